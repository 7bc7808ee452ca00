//! INSERT: the entities of a block, placed again.

use super::file::{Entity, entities};
use super::importing::{Destination, Import, OpenBlock};
use super::map::{Map3, Vec3};

/// Blocks within blocks, at the most.
const DEEPEST: usize = 32;

pub(super) fn insert<'f, 'a>(
    import: &mut Import<'f, 'a, '_>,
    entity: &Entity<'f, 'a>,
    place: &Destination<'a>,
) {
    let name = entity.tag(2).map_or(b"".as_slice(), |tag| tag.name());
    let block = import.block(name).filter(|_| import.options.explode);
    let Some((key, block)) = block else {
        import.findings.skip("INSERT");
        if import.options.explode {
            let shown = super::tag::decoded(name);
            let text = format!("INSERT of block `{shown}`, which the file does not have: left out");
            import.findings.warn("block", entity.line, text);
        }
        return;
    };
    if import.open_blocks.iter().any(|open| open.key == key) || import.open_blocks.len() >= DEEPEST
    {
        let shown = super::tag::decoded(key);
        let text = format!("block {shown} is placed within itself, or too deep: left out");
        import.findings.warn("nest", entity.line, text);
        return;
    }
    let Some(copies) = copies(import, entity, place) else { return };
    let base = import.corner(&block.head, 0).unwrap_or_default();
    let own = entity.tag(8).map(|tag| tag.name());
    let layer = own.filter(|own| *own != b"0").or(place.layer);
    import.open_blocks.push(OpenBlock { key, name, line: entity.line });
    // Copies of nothing take time too.
    let is_empty = entities(block.tags).next().is_none();
    for copy in copies {
        if is_empty && !import.goes_on() || import.is_over() {
            break;
        }
        let map = Map3::moved(Vec3::new(-base.x, -base.y, -base.z)).then(&copy);
        import.entities(block.tags, &Destination { map, layer });
    }
    import.open_blocks.pop();
}

/// The maps from the frame of the block, its base at the origin, to the world: one for each row and
/// column.
fn copies<'f, 'a>(
    import: &mut Import<'f, 'a, '_>,
    entity: &Entity<'f, 'a>,
    place: &Destination<'a>,
) -> Option<impl Iterator<Item = Map3> + use<>> {
    let at = import.corner(entity, 0)?;
    let mut real = |code, default| entity.real_or(code, default, &mut import.findings);
    let (x, y, z) = (real(41, 1.0), real(42, 1.0), real(43, 1.0));
    let (turn, dx, dy) = (real(50, 0.0), real(44, 0.0), real(45, 0.0));
    let (columns, rows) = (
        entity.whole(70, &mut import.findings).max(1),
        entity.whole(71, &mut import.findings).max(1),
    );
    if x == 0.0 || y == 0.0 {
        import.findings.warn("insert", entity.line, "INSERT scaled to nothing: left out");
        return None;
    }
    let world = Map3::turned(turn).then(&Map3::moved(at)).then(&import.frame(entity, place));
    let cells = (0..rows).flat_map(move |row| (0..columns).map(move |column| (row, column)));
    let copy = move |(row, column): (i64, i64)| {
        let step = Vec3::new(column as f64 * dx, row as f64 * dy, 0.0);
        Map3::scaled(x, y, z).then(&Map3::moved(step)).then(&world)
    };
    Some(cells.map(copy))
}
