//! Which shape lies within which.

use crate::Shape;
use kerf_geom::{Bounds2, BoxTree, Polyarc, PolyarcPlace, Position, tol};
use std::sync::Arc;

/// The shapes of a drawing as a forest: a closed shape is the parent of what lies directly inside
/// it. Open shapes and points are leaves (readings, Directions and Automatic sequence).
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Nesting {
    parent: Vec<Option<usize>>,
    depth: Vec<usize>,
    across: Vec<(usize, usize)>,
    same: Vec<(usize, usize)>,
}

/// Position of a shape relative to a closed one that is larger.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Relation {
    Inside,
    Apart,
    Across,
}

impl Nesting {
    /// Finds what lies within what. Shapes that cross each other are side by side.
    pub fn of(shapes: &[Arc<Shape>]) -> Self {
        let mut found = Finder::of(shapes);
        let parent: Vec<_> = (0..shapes.len()).map(|inner| found.parent_of(inner)).collect();
        let depth = (0..shapes.len()).map(|n| ancestors(&parent, n).count()).collect();
        found.across.sort_unstable();
        found.same.sort_unstable();
        Self { parent, depth, across: found.across, same: found.same }
    }

    /// The smallest shape around a shape.
    pub fn parent(&self, shape: usize) -> Option<usize> {
        self.parent.get(shape).copied().flatten()
    }

    /// Returns the number of shapes that lie around a shape.
    pub fn depth(&self, shape: usize) -> usize {
        self.depth.get(shape).copied().unwrap_or_default()
    }

    /// Pairs of which one, closed, is crossed by the other.
    pub fn across(&self) -> &[(usize, usize)] {
        &self.across
    }

    /// Pairs of closed shapes that lie on each other, the lower number first.
    pub fn same(&self) -> &[(usize, usize)] {
        &self.same
    }

    /// The shapes directly inside a shape, or those outside all others, in order.
    pub fn children(&self, parent: Option<usize>) -> impl Iterator<Item = usize> + '_ {
        (0..self.parent.len()).filter(move |n| self.parent[*n] == parent)
    }

    /// All shapes in an order in which whatever lies inside comes first, and siblings in the order
    /// that `sort` puts them into.
    pub fn inside_first(&self, sort: impl FnMut(&mut Vec<usize>)) -> Vec<usize> {
        inside_first(&self.parent, sort)
    }
}

/// All shapes in an order in which whatever lies inside comes before its holder, and those with the same holder in the
/// order that `sort` puts them into; for each shape its holder.
pub fn inside_first(holders: &[Option<usize>], sort: impl FnMut(&mut Vec<usize>)) -> Vec<usize> {
    let outside = holders.len();
    let mut held: Vec<Vec<usize>> = vec![Vec::new(); outside + 1];
    for (shape, holder) in holders.iter().enumerate() {
        held[holder.unwrap_or(outside)].push(shape);
    }
    held.iter_mut().for_each(sort);
    post_order(&held, outside)
}

/// The nodes below `root`, children before parents, without recursion: nests may be deep.
fn post_order(children: &[Vec<usize>], root: usize) -> Vec<usize> {
    let mut order = Vec::with_capacity(children.len());
    let mut open = vec![root];
    while let Some(node) = open.pop() {
        order.push(node);
        // The last child is visited first: the order is turned round at the end.
        open.extend(&children[node]);
    }
    order.reverse();
    order.pop();
    order
}

fn ancestors(parent: &[Option<usize>], shape: usize) -> impl Iterator<Item = usize> + '_ {
    std::iter::successors(parent[shape], |n| parent[*n])
}

/// Tables that are needed again and again while parents are sought.
struct Finder<'a> {
    shapes: &'a [Arc<Shape>],
    boxes: Vec<Bounds2>,
    areas: Vec<f64>,
    /// Shapes from the smallest to the largest area.
    by_area: Vec<usize>,
    /// Their boxes, and at which place of `by_area` each is.
    tree: BoxTree,
    ranks: Vec<usize>,
    across: Vec<(usize, usize)>,
    same: Vec<(usize, usize)>,
}

impl<'a> Finder<'a> {
    fn of(shapes: &'a [Arc<Shape>]) -> Self {
        let boxes: Vec<Bounds2> = shapes.iter().map(|shape| shape.path.bounds()).collect();
        let areas: Vec<f64> = shapes.iter().map(|shape| area(shape)).collect();
        let mut by_area: Vec<usize> = (0..shapes.len()).filter(|n| areas[*n] > 0.0).collect();
        by_area.sort_by(|a, b| areas[*a].total_cmp(&areas[*b]));
        let ranked: Vec<Bounds2> = by_area.iter().map(|n| boxes[*n]).collect();
        let ranks = BoxTree::order(&ranked);
        let tree = BoxTree::new(ranks.iter().map(|rank| ranked[*rank]));
        let (across, same) = (Vec::new(), Vec::new());
        Self { shapes, boxes, areas, by_area, tree, ranks, across, same }
    }

    /// The smallest closed shape around a shape. Equal shapes do not contain each other.
    fn parent_of(&mut self, inner: usize) -> Option<usize> {
        let (least, most) = self.like(inner);
        let from = self.by_area.partition_point(|n| self.areas[*n] < least);
        for rank in self.ranks_near(inner, from) {
            let outer = self.by_area[rank];
            let equal = self.areas[outer] <= most && self.areas[inner] > 0.0;
            if equal && outer <= inner {
                continue;
            }
            let pair = (outer.min(inner), outer.max(inner));
            match self.relation(outer, inner) {
                Relation::Inside if equal => self.same.push(pair),
                Relation::Inside => return Some(outer),
                Relation::Across => self.across.push(pair),
                Relation::Apart => {}
            }
        }
        None
    }

    /// The shapes whose boxes meet that of a shape, as places of `by_area` from one on, in order.
    fn ranks_near(&self, shape: usize, from: usize) -> Vec<usize> {
        let mut near = Vec::new();
        self.tree.meeting(&self.boxes[shape], |n| {
            if self.ranks[n] >= from {
                near.push(self.ranks[n]);
            }
        });
        near.sort_unstable();
        near
    }

    /// Between which areas a shape is as large as another: a strip along its box as wide as two places
    /// that are one may be apart.
    fn like(&self, shape: usize) -> (f64, f64) {
        let size = self.boxes[shape].size();
        let strip = 2.0 * (size.x + size.y) * tol::SAME_PLACE_MM;
        (self.areas[shape] - strip, self.areas[shape] + strip)
    }

    fn relation(&self, outer: usize, inner: usize) -> Relation {
        relation(&self.shapes[outer].path, &self.shapes[inner].path)
    }
}

/// Tells whether a path lies partly inside and partly outside a closed one.
pub fn crosses(outer: &Polyarc, inner: &Polyarc) -> bool {
    relation(outer, inner) == Relation::Across
}

fn area(shape: &Shape) -> f64 {
    if shape.is_closed() { shape.path.signed_area().abs() } else { 0.0 }
}

/// Cuts the inner path where it meets the outer one; each piece then lies on one side.
fn relation(outer: &Polyarc, inner: &Polyarc) -> Relation {
    let sides = pieces(outer, inner).into_iter().map(|middle| outer.position(middle.at));
    let (mut inside, mut outside) = (false, false);
    for side in sides {
        inside |= side == Position::Inside;
        outside |= side == Position::Outside;
    }
    match (inside, outside) {
        (true, true) => Relation::Across,
        (false, true) => Relation::Apart,
        // Nothing but edge: a part of the outer path drawn again lies on it, so within it.
        (_, false) => Relation::Inside,
    }
}

/// A place in the middle of each piece of `inner` between its meetings with `outer`.
fn pieces(outer: &Polyarc, inner: &Polyarc) -> Vec<PolyarcPlace> {
    let long = inner.length();
    let mut cuts: Vec<f64> =
        inner.crossings(outer).iter().map(|crossing| inner.length_to(&crossing.first)).collect();
    cuts.push(0.0);
    cuts.push(long);
    cuts.sort_by(f64::total_cmp);
    cuts.dedup();
    let middles = cuts.windows(2).map(|ends| 0.5 * (ends[0] + ends[1]));
    let places: Vec<PolyarcPlace> = middles.filter_map(|at| inner.place_after(at)).collect();
    if places.is_empty() { inner.place_after(0.0).into_iter().collect() } else { places }
}

#[cfg(test)]
mod tests {
    use super::*;
    use kerf_geom::Point2;

    fn square(x: f64, y: f64, side: f64) -> Polyarc {
        Polyarc::rectangle(Point2::new(x, y), Point2::new(x + side, y + side))
    }

    fn check(paths: &[Polyarc], parents: &[Option<usize>], across: &[(usize, usize)]) {
        let shapes: Vec<_> = paths.iter().map(|p| Arc::new(Shape::flat(p.clone()))).collect();
        let nesting = Nesting::of(&shapes);
        assert_eq!(nesting.parent, parents);
        assert_eq!(nesting.across(), across);
    }

    #[test]
    fn squares_nest() {
        let nest = [square(0.0, 0.0, 100.0), square(40.0, 40.0, 20.0), square(20.0, 20.0, 60.0)];
        check(&nest, &[None, Some(2), Some(0)], &[]);
    }

    #[test]
    fn touching_from_inside_is_inside_and_from_outside_is_not() {
        let pair = [square(0.0, 0.0, 100.0), square(0.0, 0.0, 50.0), square(100.0, 0.0, 50.0)];
        check(&pair, &[None, Some(0), None], &[]);
    }

    #[test]
    fn equal_shapes_do_not_contain_each_other() {
        check(&[square(0.0, 0.0, 10.0), square(0.0, 0.0, 10.0)], &[None, None], &[]);
        check(&[square(0.0, 0.0, 10.0), square(1e-9, 0.0, 10.0)], &[None, None], &[]);
    }

    #[test]
    fn crossing_shapes_are_side_by_side() {
        check(&[square(0.0, 0.0, 60.0), square(50.0, 50.0, 100.0)], &[None, None], &[(0, 1)]);
        check(&[square(0.0, 0.0, 60.0), square(50.0, 50.0, 60.0)], &[None, None], &[(0, 1)]);
    }

    #[test]
    fn open_shapes_and_points_are_leaves() {
        let line = Polyarc::lines([Point2::new(10.0, 10.0), Point2::new(90.0, 10.0)], false);
        let hole = Polyarc::lines([Point2::new(50.0, 50.0)], false);
        check(&[square(0.0, 0.0, 100.0), line, hole], &[None, Some(0), Some(0)], &[]);
    }

    #[test]
    fn a_line_through_a_shape_crosses_it() {
        let line = Polyarc::lines([Point2::new(-10.0, 5.0), Point2::new(90.0, 5.0)], false);
        check(&[line, square(0.0, 0.0, 10.0)], &[None, None], &[(0, 1)]);
    }

    #[test]
    fn what_is_inside_comes_first() {
        let nest = [square(0.0, 0.0, 100.0), square(40.0, 40.0, 20.0), square(20.0, 20.0, 60.0)];
        let shapes: Vec<_> = nest.into_iter().map(|p| Arc::new(Shape::flat(p))).collect();
        assert_eq!(Nesting::of(&shapes).inside_first(|_| ()), [1, 2, 0]);
    }
}
