//! Many copies of a shape on each other, as programs write them that draw each layer anew.

use kerf_drawing::{Drawing, Shape};
use kerf_geom::{Point2, Polyarc};
use std::time::Instant;

fn rect() -> Shape {
    let corners = [(0.0, 0.0), (9.0, 0.0), (9.0, 9.0), (0.0, 9.0)];
    Shape::flat(Polyarc::lines(corners.map(|(x, y)| Point2::new(x, y)), true))
}

/// Each with each took 40 seconds for a thousand, and four times that for twice as many.
#[test]
fn a_heap_of_copies_is_looked_at_once() {
    let drawing = Drawing::of((0..2000).map(|_| rect()).collect::<Vec<_>>());
    let begun = Instant::now();
    let (job, warnings) = kerf_toolpath::job(&drawing).unwrap();
    assert_eq!(job.paths.len(), 2000);
    assert_eq!(warnings.len(), 21, "twenty copies, and how many more");
    assert!(begun.elapsed().as_secs() < 20, "{:?}", begun.elapsed());
}
