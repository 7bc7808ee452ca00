//! Rings and strokes of places that hang together.

use crate::levels::Levels;
use kerf_geom::{Point2, Polyarc};

/// What clears one island of places where the tool's centre may go: those inside one outer ring.
#[derive(Clone)]
pub(crate) struct Island {
    /// Closed paths; the first is the outer one.
    pub rings: Vec<Polyarc>,
    /// Open paths and spots.
    pub strokes: Vec<Polyarc>,
}

/// Every ring and stroke with the smallest outer ring around it.
pub(crate) fn islands(levels: &Levels, strokes: Vec<Polyarc>) -> Vec<Island> {
    let Some(first) = levels.rings.first() else { return Vec::new() };
    let outer = Outer::of(first);
    let mut islands: Vec<Island> = outer.rings.iter().map(Island::of).collect();
    let holes = first.iter().filter(|ring| ring.signed_area() <= 0.0);
    let deeper = levels.rings.iter().skip(1).flatten();
    let (edges, strokes): (Vec<_>, Vec<_>) = strokes.into_iter().partition(|s| s.closed);
    for ring in holes.chain(deeper).chain(&edges) {
        outer.around(ring).into_iter().for_each(|n| islands[n].rings.push(ring.clone()));
    }
    for stroke in strokes {
        outer.around(&stroke).into_iter().for_each(|n| islands[n].strokes.push(stroke.clone()));
    }
    islands
}

impl Island {
    fn of(ring: &Polyarc) -> Self {
        Self { rings: vec![ring.clone()], strokes: Vec::new() }
    }
}

/// The outer rings of level 0, smallest first.
struct Outer {
    rings: Vec<Polyarc>,
}

impl Outer {
    fn of(rings: &[Polyarc]) -> Self {
        let outer = rings.iter().filter(|ring| ring.signed_area() > 0.0);
        let mut rings: Vec<Polyarc> = outer.cloned().collect();
        rings.sort_by(|a, b| a.signed_area().total_cmp(&b.signed_area()));
        Self { rings }
    }

    fn around(&self, path: &Polyarc) -> Option<usize> {
        let place: Point2 = path.start()?;
        let holds = |ring: &Polyarc| ring.bounds().holds(place) && ring.winding(place) != 0;
        self.rings.iter().position(holds)
    }
}
