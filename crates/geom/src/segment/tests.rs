use super::*;
use std::f64::consts::PI;

fn p(x: f64, y: f64) -> Point2 {
    Point2::new(x, y)
}

fn line(a: (f64, f64), b: (f64, f64)) -> Segment {
    Segment::line(p(a.0, a.1), p(b.0, b.1))
}

fn arc(a: (f64, f64), b: (f64, f64), bulge: f64) -> Segment {
    Segment::bulged(p(a.0, a.1), p(b.0, b.1), bulge)
}

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-9
}

#[test]
fn bulge_one_is_half_a_circle_to_the_right_of_its_chord() {
    let a = arc((0.0, 0.0), (2.0, 0.0), 1.0);
    assert!(a.at(0.5).distance(p(1.0, -1.0)) < 1e-12);
    assert!(close(a.length(), PI) && close(a.bulge(), 1.0));
    assert!((a.direction(0.0) - Vec2::new(0.0, -1.0)).length() < 1e-12);
}

#[test]
fn long_arcs_keep_their_side() {
    let a = arc((0.0, 0.0), (2.0, 0.0), 3.0);
    let b = a.bounds();
    assert!(close(b.min.y, -3.0) && close(b.max.y, 0.0), "{b:?}");
    assert!(close(a.share_of(a.at(0.3)), 0.3) && close(a.share_of(a.at(0.9)), 0.9));
}

#[test]
fn the_nearest_place_is_the_foot_or_an_end() {
    let a = arc((1.0, 0.0), (0.0, 1.0), (PI / 8.0).tan());
    assert!(close(a.nearest(p(2.0, 2.0)).distance, 8f64.sqrt() - 1.0));
    assert_eq!(a.nearest(p(1.0, -5.0)).share, 0.0);
    assert!(close(a.distance(p(1.0, -5.0)), 5.0));
    assert!(close(line((0.0, 0.0), (4.0, 0.0)).nearest(p(3.0, 2.0)).share, 0.75));
}

#[test]
fn splitting_keeps_length_and_area() {
    let a = arc((1.0, 0.5), (0.0, 7.0), -0.7);
    let (x, y) = a.split(0.3);
    assert!(close(x.length() + y.length(), a.length()));
    assert_eq!(x.end(), y.start());
}

fn check_meet(a: Segment, b: Segment, expected: &[(f64, f64)], along: bool) {
    for (a, b) in [(a, b), (b, a), (a.reversed(), b), (a, b.reversed())] {
        let found = a.meet(&b);
        assert_eq!(found.along, along, "{a:?} {b:?} {found:?}");
        assert_eq!(found.len(), expected.len(), "{a:?} {b:?} {found:?}");
        for &(x, y) in expected {
            let hit = found.iter().find(|c| c.at.distance(p(x, y)) < 1e-7).expect("a contact");
            assert!(a.at(hit.on_first).distance(hit.at) < 1e-7);
            assert!(b.at(hit.on_second).distance(hit.at) < 1e-7);
        }
    }
}

#[test]
fn segments_meet_where_they_should() {
    check_meet(line((0., 0.), (2., 2.)), line((0., 2.), (2., 0.)), &[(1., 1.)], false);
    check_meet(line((0., 0.), (2., 0.)), line((2., 0.), (2., 5.)), &[(2., 0.)], false);
    check_meet(line((0., 0.), (2., 0.)), line((1., 0.), (5., 0.)), &[(1., 0.), (2., 0.)], true);
    check_meet(line((0., 0.), (2., 0.)), line((0., 1.), (2., 1.)), &[], false);
    let half = arc((0., 0.), (2., 0.), -1.0);
    check_meet(half, line((1., -1.), (1., 3.)), &[(1., 1.)], false);
    check_meet(half, line((-1., 1.), (3., 1.)), &[(1., 1.)], false);
    check_meet(
        half,
        line((-1., 0.5), (3., 0.5)),
        &[(0.1339745962, 0.5), (1.8660254038, 0.5)],
        false,
    );
    check_meet(half, arc((0., 2.), (2., 2.), 1.0), &[(1., 1.)], false);
    check_meet(half, arc((2., 0.), (0., 0.), -1.0), &[(0., 0.), (2., 0.)], false);
    check_meet(half, arc((1., 1.), (1., -1.), -1.0), &[(1., 1.), (2., 0.)], true);
}

#[test]
fn a_flat_arc_is_its_chord() {
    assert!(matches!(arc((0., 0.), (10., 0.), 1e-12), Segment::Line { .. }));
    assert!(matches!(arc((0., 0.), (10., 0.), 1e-8), Segment::Arc { .. }));
}

#[test]
fn an_arc_encloses_what_its_halves_do_and_the_triangle_between() {
    for k in -60..=20 {
        let bulge = 1.3f64.powi(k);
        let whole = twice_cap_area(4.0, bulge);
        // Half the angle, on a chord from an end to the top, which rises by the bulge above a half chord of 1.
        let half = twice_cap_area(1.0 + bulge * bulge, (0.5 * bulge.atan()).tan());
        let found = 2.0 * half + 2.0 * bulge;
        assert!((whole - found).abs() < 1e-10 * whole, "{bulge} {whole} {found}");
        assert_eq!(twice_cap_area(4.0, -bulge), -whole);
    }
}
