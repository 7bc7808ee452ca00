//! Frames and rings within each other, as drawings of pockets and labyrinths have them by the thousand.

use kerf_drawing::{Drawing, Shape};
use kerf_geom::{Point2, Polyarc};

fn frame(by_mm: f64) -> Shape {
    let corners = [(-by_mm, -by_mm), (by_mm, -by_mm), (by_mm, by_mm), (-by_mm, by_mm)];
    Shape::flat(Polyarc::lines(corners.map(|(x, y)| Point2::new(x, y)), true))
}

fn ring(by_mm: f64) -> Shape {
    Shape::flat(Polyarc::circle(Point2::default(), by_mm))
}

/// The warnings of shapes within each other.
fn told(shape: fn(f64) -> Shape, count: u32) -> Vec<String> {
    let drawing = Drawing::of((1..=count).map(|n| shape(f64::from(n))));
    let (job, warnings) = kerf_toolpath::job(&drawing).unwrap();
    assert_eq!(job.paths.len(), count as usize);
    warnings.iter().map(ToString::to_string).collect()
}

/// Each was held against each: six thousand frames took longer than a minute.
#[test]
fn frames_within_each_other_are_cut_without_a_warning() {
    assert_eq!(told(frame, 3000), [""; 0]);
    assert_eq!(told(ring, 1000), [""; 0]);
}

#[test]
fn a_frame_across_many_is_told_of_each() {
    let across = Polyarc::lines(
        [(0.5, -99.0), (9.5, -99.0), (9.5, 99.0), (0.5, 99.0)].map(|(x, y)| Point2::new(x, y)),
        true,
    );
    let shapes = (1..=20).flat_map(|n| [frame(f64::from(n)), ring(f64::from(n))]);
    let drawing = Drawing::of(shapes.chain([Shape::flat(across)]));
    let (_, warnings) = kerf_toolpath::job(&drawing).unwrap();
    let across =
        warnings.iter().map(ToString::to_string).filter(|text| text.contains("crosses shape 41"));
    assert_eq!(across.count(), 40);
}
