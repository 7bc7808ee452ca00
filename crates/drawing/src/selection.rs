//! Which shapes an operation acts on.

use crate::{Drawing, Group, Shape};
use kerf_geom::{Bounds2, Point2, Polyarc};
use serde::{Deserialize, Serialize};

/// A way to choose shapes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Choice {
    /// Every shape.
    All,
    /// No shape.
    None,
    /// Shapes by number, counted from 1.
    Shapes(Vec<usize>),
    /// The shapes of a group.
    Group(Group),
    /// The shapes wholly inside a window.
    Window(Point2, Point2),
    /// The shapes inside a window or crossing its edge.
    Crossing(Point2, Point2),
}

impl Choice {
    /// The shapes chosen, as places in [`Drawing::shapes`], in order and each once.
    ///
    /// # Errors
    /// The first number without a shape.
    pub fn of(&self, drawing: &Drawing) -> Result<Vec<usize>, usize> {
        let those = |fits: &dyn Fn(&Shape) -> bool| {
            let shapes = drawing.shapes.iter().enumerate();
            shapes.filter(|(_, shape)| fits(shape)).map(|(n, _)| n).collect::<Vec<_>>()
        };
        Ok(match self {
            Self::All => those(&|_| true),
            Self::None => Vec::new(),
            Self::Shapes(numbers) => return by_number(numbers, drawing.shapes.len()),
            Self::Group(group) => those(&|shape| shape.group == *group),
            Self::Window(a, b) => {
                let window = Bounds2::of(*a, *b);
                those(&|shape| window.holds_box(&shape.path.bounds()))
            }
            Self::Crossing(a, b) => {
                let window = Bounds2::of(*a, *b);
                let edge = Polyarc::rectangle(*a, *b);
                those(&|shape| reaches_into(shape, &window, &edge))
            }
        })
    }
}

fn by_number(numbers: &[usize], count: usize) -> Result<Vec<usize>, usize> {
    if let Some(wrong) = numbers.iter().find(|n| !(1..=count).contains(n)) {
        return Err(*wrong);
    }
    let mut places: Vec<usize> = numbers.iter().map(|n| n - 1).collect();
    places.sort_unstable();
    places.dedup();
    Ok(places)
}

/// Tells whether a vertex lies in the window or a segment crosses its edge.
fn reaches_into(shape: &Shape, window: &Bounds2, edge: &Polyarc) -> bool {
    if !window.meets(&shape.path.bounds()) {
        return false;
    }
    shape.path.vertices.iter().any(|vertex| window.holds(vertex.at))
        || shape.path.segments().any(|s| edge.segments().any(|side| !s.meet(&side).is_empty()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn three() -> Drawing {
        let square = |x: f64| {
            Shape::flat(Polyarc::rectangle(Point2::new(x, 0.0), Point2::new(x + 10.0, 10.0)))
        };
        let circle = Polyarc::circle(Point2::new(100.0, 0.0), 20.0);
        Drawing::of([square(0.0), square(50.0).in_group(Group::Red), Shape::flat(circle)])
    }

    fn check(choice: Choice, expected: &[usize]) {
        assert_eq!(choice.of(&three()), Ok(expected.to_vec()), "{choice:?}");
    }

    #[test]
    fn shapes_are_chosen() {
        let p = Point2::new;
        check(Choice::All, &[0, 1, 2]);
        check(Choice::None, &[]);
        check(Choice::Shapes(vec![3, 1, 3]), &[0, 2]);
        check(Choice::Group(Group::Red), &[1]);
        check(Choice::Window(p(70.0, 20.0), p(-1.0, -1.0)), &[0, 1]);
        check(Choice::Window(p(5.0, -1.0), p(70.0, 20.0)), &[1]);
        check(Choice::Crossing(p(5.0, -1.0), p(70.0, 20.0)), &[0, 1]);
        assert_eq!(Choice::Shapes(vec![1, 4]).of(&three()), Err(4));
    }

    #[test]
    fn a_crossing_window_inside_a_shape_does_not_touch_it() {
        let p = Point2::new;
        check(Choice::Crossing(p(95.0, -5.0), p(105.0, 5.0)), &[]);
        check(Choice::Crossing(p(95.0, -5.0), p(125.0, 5.0)), &[2]);
        check(Choice::Crossing(p(84.0, 15.0), p(88.0, 12.0)), &[2]);
    }
}
