//! Places of the stops, so that those near a place are found without a look at all.

use super::site::Site;
use kerf_geom::{Bounds2, BoxTree};

/// Stops in the plane.
pub(super) struct Map {
    tree: BoxTree,
    /// The stop of each box of the tree.
    stops: Vec<usize>,
}

impl Map {
    pub fn of(site: &Site, stops: impl Iterator<Item = usize>) -> Self {
        let stops: Vec<usize> = stops.collect();
        let boxes: Vec<Bounds2> = stops.iter().map(|stop| site.stop(*stop).bounds).collect();
        let order = BoxTree::order(&boxes);
        let tree = BoxTree::new(order.iter().map(|place| boxes[*place]));
        Self { tree, stops: order.into_iter().map(|place| stops[place]).collect() }
    }

    /// Returns the number of its stops.
    pub fn len(&self) -> usize {
        self.stops.len()
    }

    /// About how far a stop is from the next, millimetres; never 0.
    pub fn spacing_mm(&self) -> f64 {
        let size = self.tree.bounds().size();
        let side = (size.x * size.y / self.len().max(1) as f64).sqrt();
        side.max(size.x.max(size.y) / self.len().max(1) as f64).max(1e-3)
    }

    /// Tells whether everything lies in an area.
    pub fn lies_in(&self, area: &Bounds2) -> bool {
        self.stops.is_empty() || area.holds_box(&self.tree.bounds())
    }

    /// Calls `visit` with every stop whose bounds meet an area.
    pub fn meeting(&self, area: &Bounds2, mut visit: impl FnMut(usize)) {
        self.tree.meeting(area, |place| visit(self.stops[place]));
    }
}
