//! Words of the Profiler manual's glossary, in numbers.

use kerf_geom::{Point2, Polyarc, Segment, Vertex};

fn p(x: f64, y: f64) -> Point2 {
    Point2::new(x, y)
}

fn arc(bulge: f64) -> Segment {
    Segment::bulged(p(0.0, 0.0), p(10.0, 0.0), bulge)
}

fn near(value: f64, expected: f64) {
    assert!((value - expected).abs() < 1e-3, "{value} is not {expected}");
}

#[test]
fn pro_glossary_bulge() {
    let cases = [(1.0, 180.0), (0.414214, 90.0), (0.5, 106.260), (2.0, 253.740), (-0.25, -56.145)];
    for (bulge, degrees) in cases {
        let Segment::Arc { sweep_rad, .. } = arc(bulge) else { panic!("{bulge} is no arc") };
        near(sweep_rad.to_degrees(), degrees);
        near(arc(bulge).bulge(), bulge);
    }
}

#[test]
fn pro_glossary_bulge_sign() {
    for (bulge, y) in [(1.0, -5.0), (-1.0, 5.0), (0.0, 0.0)] {
        assert!(arc(bulge).at(0.5).distance(p(5.0, y)) < 1e-9);
    }
}

#[test]
fn pro_glossary_bulge_one() {
    let Segment::Arc { centre, radius, .. } = arc(1.0) else { panic!("no arc") };
    assert!(centre.distance(p(5.0, 0.0)) < 1e-9);
    near(radius, 5.0);
    near(arc(1.0).length(), 15.708);
}

#[test]
fn pro_glossary_simple() {
    let square = Polyarc::rectangle(p(0.0, 0.0), p(100.0, 100.0));
    let places = [(0.0, 0.0), (100.0, 100.0), (100.0, 0.0), (0.0, 100.0)];
    let bow_tie = Polyarc::lines(places.map(|(x, y)| p(x, y)), true);
    assert!(square.is_simple() && !bow_tie.is_simple());
    assert!(
        !Polyarc::open(vec![Vertex::new(0.0, 0.0, 0.0), Vertex::new(1.0, 0.0, 0.0)]).is_simple()
    );
}
