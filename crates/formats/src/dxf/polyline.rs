//! POLYLINE with its VERTEX entities, and LWPOLYLINE.

use super::file::Entity;
use super::importing::{Destination, Import};
use super::map::Vec3;
use super::skipped;
use kerf_geom::{Polyarc, Vertex};
use std::iter::Peekable;

/// Bits of group code 70 of a POLYLINE.
mod flag {
    /// The last vertex is joined to the first.
    pub const CLOSED: i64 = 1;
    /// Vertices in space.
    pub const IN_SPACE: i64 = 8;
    /// A mesh of polygons or a mesh of faces.
    pub const MESH: i64 = 16 | 64;
}

/// Bit of group code 70 of a VERTEX: a point of the frame that a spline was made from, not on it.
const FRAME_POINT: i64 = 16;

pub(super) fn light<'f, 'a>(
    import: &mut Import<'f, 'a, '_>,
    entity: &Entity<'f, 'a>,
    place: &Destination<'a>,
) {
    let mut vertices: Vec<Vertex> = Vec::new();
    let mut broken = false;
    for tag in entity.tags {
        let Some(value) = tag.real() else {
            if matches!(tag.code, 10 | 20 | 42) {
                broken = true;
                let text = format!("LWPOLYLINE: `{}` is no number", tag.text());
                import.findings.warn("number", tag.line, text);
            }
            continue;
        };
        match (tag.code, vertices.last_mut()) {
            (10, _) => vertices.push(Vertex::new(value, 0.0, 0.0)),
            (20, Some(last)) => last.at.y = value,
            (42, Some(last)) => last.bulge = value,
            _ => {}
        }
    }
    if broken {
        return told_broken(import, entity);
    }
    let height = entity.real_or(38, 0.0, &mut import.findings);
    let closed = entity.whole(70, &mut import.findings) & flag::CLOSED != 0;
    add(import, entity, place, vertices, closed, height);
}

pub(super) fn old<'f, 'a>(
    import: &mut Import<'f, 'a, '_>,
    entity: &Entity<'f, 'a>,
    rest: &mut Peekable<impl Iterator<Item = Entity<'f, 'a>>>,
    place: &Destination<'a>,
) {
    let flags = entity.whole(70, &mut import.findings);
    let mut places: Vec<(Vec3, f64)> = Vec::new();
    let (mut broken, mut ended) = (false, false);
    while let Some(vertex) = rest.next_if(|next| is_part(next.name)) {
        match vertex.name {
            b"VERTEX" => {}
            b"SEQEND" => {
                ended = true;
                break;
            }
            _ => {
                import.unknown(&vertex);
                broken = true;
                continue;
            }
        }
        if flags & flag::MESH != 0 || vertex.whole(70, &mut import.findings) & FRAME_POINT != 0 {
            continue;
        }
        let at = import.corner(&vertex, 0);
        broken |= at.is_none();
        let bulge = vertex.real_or(42, 0.0, &mut import.findings);
        places.extend(at.map(|at| (at, bulge)));
    }
    if !ended {
        import.findings.warn("seqend", entity.line, "POLYLINE without SEQEND: it may be longer");
    }
    if flags & flag::MESH != 0 {
        return import.findings.skip("POLYLINE (mesh)");
    }
    if broken {
        return told_broken(import, entity);
    }
    let closed = flags & flag::CLOSED != 0;
    if flags & flag::IN_SPACE != 0 {
        let world = places.into_iter().map(|(at, _)| place.map.apply(at)).collect();
        return import.in_space(entity, place, world, closed);
    }
    let height = entity.real_or(30, 0.0, &mut import.findings);
    let vertices = places.into_iter().map(|(at, bulge)| Vertex { at: at.flat(), bulge }).collect();
    add(import, entity, place, vertices, closed, height);
}

/// Tells whether an entity belongs to a POLYLINE: its vertices, its end, and what stands between them under a name
/// that nobody knows.
fn is_part(name: &[u8]) -> bool {
    matches!(name, b"VERTEX" | b"SEQEND") || skipped::is_foreign(name)
}

fn told_broken(import: &mut Import, entity: &Entity) {
    let text =
        format!("{} with a broken vertex: left out, since its form is not known", entity.shown());
    import.findings.warn("broken", entity.line, text);
}

fn add<'f, 'a>(
    import: &mut Import<'f, 'a, '_>,
    entity: &Entity<'f, 'a>,
    place: &Destination<'a>,
    vertices: Vec<Vertex>,
    closed: bool,
    height: f64,
) {
    let drawn = Polyarc { vertices, closed };
    let path = drawn.tidied();
    if path.segment_count() == 0 {
        return too_short(import, entity);
    }
    tell_repeated(import, entity, &drawn);
    import.flat(entity, place, &path, height);
}

/// Tells vertices that are written again at once. That the last one is the first says only that it is closed.
fn tell_repeated(import: &mut Import, entity: &Entity, drawn: &Polyarc) {
    let pairs = drawn.vertices.windows(2).filter(|pair| pair[0].at == pair[1].at);
    let (mut count, mut first) = (0, None);
    pairs.for_each(|pair| {
        count += 1;
        first = first.or(Some(pair[0].at));
    });
    if let Some(at) = first {
        let name = entity.shown();
        let text = format!(
            "{name}: segments without length left out: {count}, the first at {}, {}",
            at.x, at.y
        );
        import.findings.note("repeated", entity.line, text);
    }
}

fn too_short(import: &mut Import, entity: &Entity) {
    let text = format!("{} with fewer than two different points: left out", entity.shown());
    import.findings.warn("length", entity.line, text);
}
