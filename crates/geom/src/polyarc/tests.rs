use super::*;
use crate::{Transform2, Vec2};
use std::f64::consts::PI;

fn p(x: f64, y: f64) -> Point2 {
    Point2::new(x, y)
}

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-9
}

/// A square of 10 with a half-round nose of radius 5 on its right side.
fn nose() -> Polyarc {
    Polyarc::closed(vec![
        Vertex::new(0.0, 0.0, 0.0),
        Vertex::new(10.0, 0.0, 1.0),
        Vertex::new(10.0, 10.0, 0.0),
        Vertex::new(0.0, 10.0, 0.0),
    ])
}

#[test]
fn measures_are_exact_for_arcs() {
    let n = nose();
    assert!(close(n.length(), 30.0 + 5.0 * PI));
    assert!(close(n.signed_area(), 100.0 + 12.5 * PI));
    assert!(close(n.bounds().max.x, 15.0));
    assert!(close(Polyarc::circle(p(1e5, 1e5), 2.0).signed_area(), 4.0 * PI));
    assert!(close(Polyarc::rounded_rectangle(p(0., 0.), p(10., 6.), 1.0).signed_area(), 56.0 + PI));
}

#[test]
fn reversing_turns_area_and_keeps_the_start() {
    let n = nose();
    let r = n.reversed();
    assert_eq!(r.start(), n.start());
    assert!(close(r.signed_area(), -n.signed_area()) && close(r.length(), n.length()));
    assert_eq!(r.reversed(), n);
    let open = Polyarc::open(vec![
        Vertex::new(0., 0., 1.),
        Vertex::new(2., 0., 0.),
        Vertex::new(4., 0., 0.),
    ]);
    let back = open.reversed();
    assert_eq!(back.start(), open.end());
    assert!(back.segment(1).at(0.5).distance(p(1.0, -1.0)) < 1e-12);
    assert_eq!(back.reversed(), open);
}

#[test]
fn a_place_is_inside_outside_or_on_the_edge() {
    let n = nose();
    let check = |x: f64, y: f64, expected| assert_eq!(n.position(p(x, y)), expected, "{x} {y}");
    check(5.0, 5.0, Position::Inside);
    check(14.9, 5.0, Position::Inside);
    check(10.0, 5.0, Position::Inside);
    check(14.9, 9.0, Position::Outside);
    check(15.0, 5.0, Position::OnEdge);
    check(-1.0, 0.0, Position::Outside);
    check(-1.0, 10.0, Position::Outside);
    check(3.0, 0.0, Position::OnEdge);
    let bite =
        Polyarc::closed(n.vertices.iter().map(|v| Vertex { bulge: -v.bulge, ..*v }).collect());
    assert_eq!(bite.position(p(7.0, 5.0)), Position::Outside);
    assert_eq!(bite.position(p(10.0, 5.0)), Position::Outside);
    assert_eq!(bite.position(p(4.0, 5.0)), Position::Inside);
}

#[test]
fn winding_does_not_depend_on_how_the_contour_is_turned() {
    let n = nose();
    for k in 0..64 {
        let turn = Transform2::turned(p(3.0, 4.0), f64::from(k) * PI / 32.0);
        let turned = n.similar(&turn);
        for (x, y, inside) in
            [(10.0, 5.0, 1), (12.0, 5.0, 1), (10.0, 11.0, 0), (-1.0, 0.0, 0), (5.0, 5.0, 1)]
        {
            assert_eq!(turned.winding(turn.apply(p(x, y))), inside, "{k} {x} {y}");
        }
    }
}

#[test]
fn contours_in_contours() {
    let n = nose();
    assert!(n.contains(&Polyarc::circle(p(10.0, 5.0), 4.0)));
    assert!(n.contains(&Polyarc::circle(p(10.0, 5.0), 5.0)));
    assert!(!n.contains(&Polyarc::circle(p(30.0, 5.0), 4.0)));
    assert!(!Polyarc::circle(p(10.0, 5.0), 4.0).contains(&n));
}

#[test]
fn places_along_the_path() {
    let n = nose();
    let place = n.place_after(10.0 + 2.5 * PI).expect("a place");
    assert!(place.at.distance(p(15.0, 5.0)) < 1e-12);
    assert!(close(n.length_to(&place), 10.0 + 2.5 * PI));
    assert!((n.direction(&place) - Vec2::new(0.0, 1.0)).length() < 1e-12);
    let moved = n.started_at(&place);
    assert_eq!(moved.start(), Some(place.at));
    assert!(close(moved.signed_area(), n.signed_area()));
    let (a, b) = (n.place_after(5.0).expect("one"), n.place_after(20.0).expect("one"));
    assert!(close(n.between(&a, &b).length(), 15.0));
    assert!(close(n.between(&b, &a).length(), n.length() - 15.0));
    assert!(close(n.between(&a, &a).length(), n.length()));
}

#[test]
fn crossings_are_in_the_order_of_travel_and_once_each() {
    let n = nose();
    let across = Polyarc::lines([p(-5.0, 5.0), p(20.0, 5.0)], false);
    let found: Vec<_> = across.crossings(&n).iter().map(|c| c.first.at).collect();
    assert!(
        found.len() == 2
            && found[0].distance(p(0., 5.)) < 1e-9
            && found[1].distance(p(15., 5.)) < 1e-9
    );
    let corner = Polyarc::lines([p(-5.0, -5.0), p(5.0, 5.0)], false);
    assert_eq!(corner.crossings(&n).len(), 1);
    assert!(n.self_crossings().is_empty());
    let eight = Polyarc::lines([p(0., 0.), p(2., 2.), p(2., 0.), p(0., 2.)], true);
    assert_eq!(eight.self_crossings().len(), 1);
    let back = Polyarc::lines([p(0., 0.), p(2., 0.), p(1., 0.)], false);
    assert!(back.self_crossings().iter().all(|c| c.along) && back.self_crossings().len() == 2);
}

#[test]
fn tidying_removes_what_has_no_length() {
    let rough = Polyarc::closed(vec![
        Vertex::new(0., 0., 0.),
        Vertex::new(0., 0., 1.0),
        Vertex::new(10., 0., 0.),
        Vertex::new(10., 10., 0.),
        Vertex::new(10., 10., 0.),
        Vertex::new(0., 0., 0.),
    ]);
    let tidy = rough.tidied();
    assert_eq!(tidy.vertices.len(), 3);
    assert!(close(tidy.signed_area(), rough.signed_area()));
    let big = Polyarc::closed(vec![Vertex::new(0., 0., 3.0), Vertex::new(2., 0., 0.)]);
    assert!(close(big.with_short_arcs().signed_area(), big.signed_area()));
}

#[test]
fn numbers_that_are_none_are_named() {
    let mut n = nose();
    n.vertices[2].at.y = f64::NAN;
    assert_eq!(n.check(), Err(crate::GeomError::NotFinite { vertex: 2 }));
    n.vertices[2].at.y = 1e12;
    assert_eq!(n.check(), Err(crate::GeomError::TooFar { vertex: 2 }));
}
