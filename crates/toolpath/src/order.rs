//! The order in which the shapes of a drawing are cut: what lies inside first, so that no part comes free before
//! its holes are cut. An order that a person set stays, and what comes free too early is told.
//!
//! ```text
//!   ┌─1──────────┐            drawn 1, 2, 3, 4: cut 2, 3, 1, 4
//!   │  ○2   ○3   │   □4
//!   └────────────┘            what no shape holds keeps its place
//! ```

use crate::warning::Warning;
use kerf_drawing::{CutDepth, Drawing, GroupSettings, Kind, Shape, inside_first};
use kerf_geom::{Bounds2, BoxTree, Position};

/// The places of the shapes in the order in which they are cut; any order where nobody waits for it any more.
pub(crate) fn cutting_order(
    drawing: &Drawing,
    given_up: &dyn Fn() -> bool,
    warnings: &mut Vec<Warning>,
) -> Vec<usize> {
    let holders = Outlines::of(drawing).holders(drawing, given_up);
    if drawing.ordered_by_hand {
        warnings.extend(too_early(&holders));
        return (0..drawing.shapes.len()).collect();
    }
    // Every shape stays at its place but for those that it holds, which come before it.
    inside_first(&holders, |_| ())
}

/// The closed shapes that cut free what lies in them.
struct Outlines {
    /// Their places in the drawing, neighbours in the plane beside each other.
    places: Vec<usize>,
    boxes: Vec<Bounds2>,
    areas: Vec<f64>,
    tree: BoxTree,
}

impl Outlines {
    fn of(drawing: &Drawing) -> Self {
        let places = (0..drawing.shapes.len()).filter(|n| {
            let shape = &drawing.shapes[*n];
            let outline = shape.is_closed() && shape.kind() == Kind::Polyarc;
            outline && frees(drawing.settings(shape.group))
        });
        let places: Vec<usize> = places.collect();
        let bounds = |place: &usize| drawing.shapes[*place].path.bounds();
        let order = BoxTree::order(&places.iter().map(bounds).collect::<Vec<_>>());
        let places: Vec<usize> = order.into_iter().map(|n| places[n]).collect();
        let boxes: Vec<Bounds2> = places.iter().map(bounds).collect();
        let areas = places.iter().map(|place| area(&drawing.shapes[*place])).collect();
        let tree = BoxTree::new(boxes.iter().copied());
        Self { places, boxes, areas, tree }
    }

    /// For each shape that is cut the smallest outline around it. A shape drawn twice does not hold itself;
    /// shapes that cross are told elsewhere.
    fn holders(&self, drawing: &Drawing, given_up: &dyn Fn() -> bool) -> Vec<Option<usize>> {
        let holder = |shape: &Shape| {
            let is_sought = is_cut(drawing.settings(shape.group)) && !given_up();
            let start = shape.path.start().filter(|_| is_sought)?;
            let (bounds, area) = (shape.path.bounds(), area(shape));
            let mut around = Vec::new();
            self.tree.meeting(&bounds, |n| {
                if self.areas[n] > area && within(&bounds, &self.boxes[n]) {
                    around.push(n);
                }
            });
            self.smallest(around, |outer| {
                drawing.shapes[outer].path.position(start) == Position::Inside
            })
        };
        drawing.shapes.iter().map(|shape| holder(shape)).collect()
    }

    /// The place of the smallest of some outlines that holds something. Mostly the smallest of all does: they are
    /// not sorted.
    fn smallest(&self, mut around: Vec<usize>, holds: impl Fn(usize) -> bool) -> Option<usize> {
        loop {
            let by_area = |a: &usize, b: &usize| self.areas[*a].total_cmp(&self.areas[*b]);
            let (at, _) = around.iter().enumerate().min_by(|(_, a), (_, b)| by_area(a, b))?;
            let place = self.places[around.remove(at)];
            if holds(place) {
                return Some(place);
            }
        }
    }
}

fn area(shape: &Shape) -> f64 {
    if shape.is_closed() { shape.path.signed_area().abs() } else { 0.0 }
}

fn within(inner: &Bounds2, outer: &Bounds2) -> bool {
    let low = outer.min.x <= inner.min.x && outer.min.y <= inner.min.y;
    low && inner.max.x <= outer.max.x && inner.max.y <= outer.max.y
}

fn is_cut(settings: &GroupSettings) -> bool {
    settings.on && !settings.traversal
}

/// Returns `true` if a closed shape of a group may cut free what lies in it. The paths that clear an area, cut as
/// they are with a tool of known width, lie in each other, and their own order is meant.
fn frees(settings: &GroupSettings) -> bool {
    let clears = settings.offset_mm == 0.0 && settings.cutter_mm.is_some();
    let deep = match settings.height {
        CutDepth::Thru => true,
        CutDepth::ThreeD => false,
        CutDepth::Mm(depth_mm) => depth_mm < 0.0 && !clears,
    };
    deep && is_cut(settings)
}

/// Tells parts that come free before something in them is cut, each once.
fn too_early(holders: &[Option<usize>]) -> Vec<Warning> {
    let told = |(outer, inner, count): (usize, usize, usize)| {
        let more = if count > 1 { format!(" and {} more", count - 1) } else { String::new() };
        let text = format!(
            "it comes free before shape {}{more} in it is cut: cut what lies inside first, with `sequence auto 0,0`",
            inner + 1
        );
        Warning::new(outer + 1, text)
    };
    late(holders).into_iter().map(told).collect()
}

/// Shapes that come before one that they hold, each with the first of those and their number.
fn late(holders: &[Option<usize>]) -> Vec<(usize, usize, usize)> {
    let mut found = vec![None; holders.len()];
    for (inner, holder) in holders.iter().enumerate() {
        if let Some(outer) = holder.filter(|outer| *outer < inner) {
            let (_, count) = found[outer].get_or_insert((inner, 0));
            *count += 1;
        }
    }
    let told = found.into_iter().enumerate();
    told.filter_map(|(outer, first)| first.map(|(inner, count)| (outer, inner, count))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_held_comes_before_its_holder_and_all_else_keeps_its_place() {
        let inside_first = |holders: &[_]| inside_first(holders, |_| ());
        assert_eq!(inside_first(&[None, Some(0), Some(0), None]), [1, 2, 0, 3]);
        assert_eq!(inside_first(&[Some(1), None, Some(1), Some(2)]), [0, 3, 2, 1]);
        assert_eq!(inside_first(&[None, None, None]), [0, 1, 2]);
        assert_eq!(late(&[None, Some(0), Some(0), None, Some(3)]), [(0, 1, 2), (3, 4, 1)]);
    }
}
