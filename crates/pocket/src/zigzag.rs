//! Parallel lines to and fro, then once along every wall.
//!
//! ```text
//!  ┌─────────────┐
//!  │ ┌─────────╮ │   lines clipped to the places where the centre may go, joined along its edge;
//!  │ ╰─────────┐ │   the edge itself last, and behind it what was left for the finish
//!  │ ──────────╯ │
//!  └─────────────┘
//! ```
//!
//! Nothing remains: a place farther than half a step inside the edge has a line within half a step, as
//! the disc about it that reaches there lies where the centre may go; all others are covered from the edge.

use crate::cutter::CutDirection;
use crate::inside::Inside;
use crate::islands::{Island, islands_of};
use crate::levels::{MOST_RINGS, Offsets};
use crate::route::Route;
use crate::spans::chains;
use crate::tour::along_walls;
use crate::{Cleared, Cutter, PocketError};
use kerf_geom::{Offsetter, Point2, Polyarc, Transform2};
use serde::{Deserialize, Serialize};

/// Course of the lines: their direction, the finish at the walls, and the way along them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Zigzag {
    /// Their direction, degrees counter-clockwise from X.
    pub angle_deg: f64,
    /// Width that they leave at the walls for a last way round, millimetres; no more than the tool's radius.
    pub finish_mm: f64,
    /// With the material on the right along the walls.
    pub climb: bool,
}

/// The paths that clear a region line by line, one or a few for each island of places where the tool
/// fits. Who clears many regions keeps one offsetter for all of them.
///
/// # Errors
/// As [`crate::rings`], and a finish out of bounds.
pub fn zigzag(
    region: &[Polyarc],
    cutter: &Cutter,
    lines: &Zigzag,
    offsetter: &Offsetter,
) -> Result<Cleared, PocketError> {
    if !(0.0..=cutter.radius_mm()).contains(&lines.finish_mm) {
        let bound = "0 or more and no more than half the diameter of the tool";
        return Err(PocketError::Bound { what: "the finish", value: lines.finish_mm, bound });
    }
    if let Some(contour) = region.iter().position(|contour| !contour.closed) {
        return Err(PocketError::Open { contour });
    }
    let turn = |rad: f64| Transform2::turned(Point2::default(), rad);
    let angle = lines.angle_deg.to_radians();
    let level: Vec<Polyarc> = region.iter().map(|contour| contour.similar(&turn(-angle))).collect();
    let mut found = cleared(&level, cutter, lines, Offsets::new(offsetter))?;
    found.paths.iter_mut().for_each(|path| *path = path.similar(&turn(angle)));
    Ok(found)
}

/// Clears a region with level lines.
fn cleared(
    region: &[Polyarc],
    cutter: &Cutter,
    lines: &Zigzag,
    mut offsets: Offsets,
) -> Result<Cleared, PocketError> {
    let inside = Inside::of(region, cutter);
    let way = CutDirection { climb: lines.climb, outward: false };
    let depth = cutter.first_depth_mm();
    let walls = islands_of(&offsets.inset(region, depth)?);
    let within = if lines.finish_mm > 0.0 {
        offsets.inset(region, depth + lines.finish_mm)?
    } else {
        Vec::new()
    };
    let mut route = Route::new(&inside);
    for wall in &walls {
        let rough = if lines.finish_mm > 0.0 { wall.part_of(&within) } else { wall.rings.clone() };
        for island in islands_of(&rough) {
            to_and_fro(&island, cutter, &mut route)?;
            along_walls(&island, &inside, way, &mut route);
        }
        if lines.finish_mm > 0.0 {
            along_walls(wall, &inside, way, &mut route);
        }
        route.lift();
    }
    Ok(Cleared { paths: route.paths(), coarse: offsets.coarse })
}

/// The lines of an island, chain after chain, always the nearest one next.
fn to_and_fro(island: &Island, cutter: &Cutter, route: &mut Route) -> Result<(), PocketError> {
    let heights = heights(island, cutter)?;
    let mut left = chains(&island.rings, &heights);
    while let Some((n, turned)) = nearest(&left, route.end()) {
        let chain = left.swap_remove(n);
        route.add(if turned { chain.reversed() } else { chain }, &island.rings);
    }
    Ok(())
}

/// The heights of the lines, no farther apart than a step and no farther from the ends.
fn heights(island: &Island, cutter: &Cutter) -> Result<Vec<f64>, PocketError> {
    let Some(bounds) = island.rings.first().map(Polyarc::bounds) else { return Ok(Vec::new()) };
    let count = (bounds.size().y / cutter.step_mm()).ceil();
    if count > MOST_RINGS {
        return Err(PocketError::TooMany { rings: count });
    }
    let gap = bounds.size().y / count.max(1.0);
    Ok((1..count as u32).map(|k| bounds.min.y + gap * f64::from(k)).collect())
}

/// The chain whose end is nearest to a place, and whether that is its last end.
fn nearest(chains: &[Polyarc], to: Option<Point2>) -> Option<(usize, bool)> {
    let Some(to) = to else { return (!chains.is_empty()).then_some((0, false)) };
    let far = |end: Option<Point2>| end.map_or(f64::INFINITY, |end| end.distance(to));
    let both = chains
        .iter()
        .enumerate()
        .flat_map(|(n, chain)| [(n, false, far(chain.start())), (n, true, far(chain.end()))]);
    both.min_by(|a, b| a.2.total_cmp(&b.2)).map(|(n, turned, _)| (n, turned))
}
