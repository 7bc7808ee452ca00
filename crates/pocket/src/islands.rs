//! Rings and strokes of places that hang together.

use crate::levels::Levels;
use kerf_geom::{Point2, Polyarc};

/// Paths that clear one island of places where the tool's centre may go: those inside one outer ring.
#[derive(Clone)]
pub(crate) struct Island {
    /// Closed paths; the first is the outer one.
    pub rings: Vec<Polyarc>,
    /// Open paths and spots.
    pub strokes: Vec<Polyarc>,
}

/// Every ring and stroke with the smallest outer ring around it.
pub(crate) fn islands(levels: &Levels, strokes: Vec<Polyarc>) -> Vec<Island> {
    let Some((first, deeper)) = levels.rings.split_first() else { return Vec::new() };
    let mut islands = islands_of(first);
    let outer = Outer::of(&islands);
    let (edges, strokes): (Vec<_>, Vec<_>) = strokes.into_iter().partition(|s| s.closed);
    for ring in deeper.iter().flatten().chain(&edges) {
        outer.around(ring).into_iter().for_each(|n| islands[n].rings.push(ring.clone()));
    }
    for stroke in strokes {
        outer.around(&stroke).into_iter().for_each(|n| islands[n].strokes.push(stroke.clone()));
    }
    islands
}

/// Outer rings, each with the holes in it.
pub(crate) fn islands_of(rings: &[Polyarc]) -> Vec<Island> {
    let (outer, holes): (Vec<_>, Vec<_>) =
        rings.iter().cloned().partition(|ring| ring.signed_area() > 0.0);
    let mut islands: Vec<Island> = outer.into_iter().map(Island::of).collect();
    let outer = Outer::of(&islands);
    for ring in holes {
        outer.around(&ring).into_iter().for_each(|n| islands[n].rings.push(ring.clone()));
    }
    islands
}

impl Island {
    fn of(ring: Polyarc) -> Self {
        Self { rings: vec![ring], strokes: Vec::new() }
    }

    /// Those of some rings that lie inside this island's outer one.
    pub fn part_of(&self, rings: &[Polyarc]) -> Vec<Polyarc> {
        let inside = |ring: &&Polyarc| {
            ring.start().is_some_and(|at| self.rings.first().is_some_and(|o| o.winding(at) != 0))
        };
        rings.iter().filter(inside).cloned().collect()
    }
}

/// The outer rings of islands, smallest first.
struct Outer {
    rings: Vec<(usize, Polyarc)>,
}

impl Outer {
    fn of(islands: &[Island]) -> Self {
        let outer = islands.iter().filter_map(|island| island.rings.first().cloned());
        let mut rings: Vec<(usize, Polyarc)> = outer.enumerate().collect();
        rings.sort_by(|a, b| a.1.signed_area().total_cmp(&b.1.signed_area()));
        Self { rings }
    }

    /// The island around a path.
    fn around(&self, path: &Polyarc) -> Option<usize> {
        let place: Point2 = path.start()?;
        let holds = |ring: &Polyarc| ring.bounds().holds(place) && ring.winding(place) != 0;
        self.rings.iter().find(|(_, ring)| holds(ring)).map(|(n, _)| *n)
    }
}
