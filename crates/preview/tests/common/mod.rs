//! Scenes and goldens of the tests.

#![allow(dead_code, clippy::unwrap_used, missing_docs)]

use kerf_geom::{Arc2, Bounds3, Point2};
use kerf_preview::{Scene, Segment, Shape};
use kerf_program::MoveKind;
use std::f64::consts::{FRAC_PI_2, TAU};
use std::path::Path;

pub fn cut(from: [f64; 3], to: [f64; 3]) -> Segment {
    Segment { kind: MoveKind::Cut, from, to, shape: Shape::Line, line: 1 }
}

pub fn jog(from: [f64; 3], to: [f64; 3]) -> Segment {
    Segment { kind: MoveKind::Jog, ..cut(from, to) }
}

pub fn arc(from: [f64; 3], centre: [f64; 2], sweep_rad: f64, z: f64) -> Segment {
    let start = Point2::new(from[0], from[1]);
    let end = Arc2 { start, centre: Point2::new(centre[0], centre[1]), sweep_rad }.end();
    let shape = Shape::Arc { centre, sweep_rad };
    Segment { shape, ..cut(from, [end.x, end.y, z]) }
}

pub fn scene(segments: Vec<Segment>) -> Scene {
    let mut bounds = Bounds3::default();
    for segment in segments.iter().filter(|s| s.kind == MoveKind::Cut && s.is_drawable()) {
        bounds.add(segment.from);
        bounds.add(segment.to);
    }
    Scene { title: "Test".into(), segments, bounds, ..Scene::default() }
}

/// A jog, a plunge, two sides with a rounded corner, a full circle and the way home.
pub fn plate() -> Scene {
    let mut scene = scene(vec![
        jog([0.0, 0.0, 5.0], [10.0, 10.0, 5.0]),
        cut([10.0, 10.0, 5.0], [10.0, 10.0, -2.0]),
        cut([10.0, 10.0, -2.0], [50.0, 10.0, -2.0]),
        arc([50.0, 10.0, -2.0], [50.0, 20.0], FRAC_PI_2, -2.0),
        cut([60.0, 20.0, -2.0], [60.0, 40.0, -2.0]),
        cut([60.0, 40.0, -2.0], [60.0, 40.0, 5.0]),
        jog([60.0, 40.0, 5.0], [35.0, 30.0, 5.0]),
        cut([35.0, 30.0, 5.0], [35.0, 30.0, -4.0]),
        arc([35.0, 30.0, -4.0], [30.0, 30.0], -TAU, -4.0),
        cut([35.0, 30.0, -4.0], [35.0, 30.0, 5.0]),
        jog([35.0, 30.0, 5.0], [0.0, 0.0, 5.0]),
    ]);
    scene.cutter_mm = 6.0;
    scene
}

/// Moves of [`odd`] that cannot be drawn.
pub const ODD: usize = 6;

/// Numbers that no program should give.
pub fn odd() -> Scene {
    let mut scene = plate();
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300, f64::MAX] {
        scene.segments.push(cut([0.0; 3], [bad, 0.0, bad]));
    }
    scene.segments.push(arc([1.0, 0.0, 0.0], [f64::NAN, 0.0], 1.0, 0.0));
    scene.segments.push(arc([1.0, 0.0, 0.0], [1.0, 0.0], 1e6, 0.0));
    scene.segments.push(cut([0.0; 3], [0.0; 3]));
    scene.bounds = Bounds3 { min: [f64::NAN; 3], max: [f64::INFINITY; 3] };
    scene.cutter_mm = f64::NAN;
    scene.surface_z_mm = f64::NAN;
    scene.duration_s = f64::NAN;
    scene.cut_mm = f64::INFINITY;
    scene.times_s = vec![f32::NAN; scene.segments.len()];
    scene.table = Some(kerf_preview::TableView {
        origin: [f64::NAN, 0.0],
        size_mm: [f64::INFINITY; 3],
        grid_mm: f64::NAN,
    });
    scene
}

/// Compares with a file beside the tests; `KERF_BLESS=1` writes it anew.
pub fn golden(name: &str, found: &str) {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/goldens").join(name);
    if std::env::var_os("KERF_BLESS").is_some() {
        std::fs::write(&file, found).unwrap();
    }
    let expected = std::fs::read_to_string(&file).unwrap_or_default();
    assert_eq!(found, expected, "{} differs; KERF_BLESS=1 writes it anew", file.display());
}
