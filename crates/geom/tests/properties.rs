//! Properties of every shape, held against many places of it: chords, samples, and other ways to the same.

use crate::families;
use crate::families::Dice;
use kerf_geom::edit::{Ends, broken, fillet, join, trimmed};
use kerf_geom::{Bounds2, Combine, Point2, Polyarc, Transform2, Vec2, combine, parallel_path};

/// Chords of each segment.
const CHORDS: usize = 400;

/// Shapes with lines and arcs, and a generator for more numbers.
fn every_shape(count: u64, check: impl Fn(&Polyarc, &mut Dice)) {
    for seed in 0..count {
        for shape in
            [families::polyarc(seed).0, families::filleted(seed).0, families::skyline(seed).0]
        {
            check(&shape, &mut Dice::new(seed + 1000));
        }
    }
    check(&families::gear(), &mut Dice::new(1));
    check(&Polyarc::circle(Point2::new(3.0, -2.0), 7.0), &mut Dice::new(2));
}

/// The ends of chords along a shape.
fn sampled(shape: &Polyarc) -> Vec<Point2> {
    let places = |s: kerf_geom::Segment| (0..CHORDS).map(move |k| s.at(k as f64 / CHORDS as f64));
    shape.segments().flat_map(places).collect()
}

fn anywhere(dice: &mut Dice, bounds: &Bounds2) -> Point2 {
    let area = bounds.grown(2.0);
    Point2::new(dice.between(area.min.x, area.max.x), dice.between(area.min.y, area.max.y))
}

/// Number of times that chords wind round a place.
fn winding(chords: &[Point2], place: Point2) -> i32 {
    let next = chords.iter().cycle().skip(1);
    let turn = |(a, b): (&Point2, &Point2)| {
        let (u, v) = (*a - place, *b - place);
        u.cross(v).atan2(u.dot(v))
    };
    (chords.iter().zip(next).map(turn).sum::<f64>() / std::f64::consts::TAU).round() as i32
}

#[test]
fn length_area_and_bounds_are_those_of_many_chords() {
    every_shape(12, |shape, _| {
        let chords = Polyarc::lines(sampled(shape), true);
        let (long, area) = (shape.length(), shape.signed_area());
        // A chord over the n-th part of an arc is shorter than it by 1/n² of its length at the most.
        assert!(long >= chords.length() - 1e-9 && long - chords.length() < 1e-5 * long);
        assert!((area - chords.signed_area()).abs() < 1e-5 * long * long, "{area}");
        let (bounds, inner) = (shape.bounds(), chords.bounds());
        assert!(bounds.grown(1e-9).holds_box(&inner) && inner.grown(1e-3).holds_box(&bounds));
    });
}

#[test]
fn inside_and_nearest_are_those_of_many_places() {
    every_shape(6, |shape, dice| {
        let places = sampled(shape);
        for _ in 0..40 {
            let at = anywhere(dice, &shape.bounds());
            let least = places.iter().map(|p| p.distance(at)).fold(f64::INFINITY, f64::min);
            let (place, far) = shape.nearest(at).expect("a place");
            assert!(far <= least + 1e-9 && far > least - 0.5, "{far} {least}");
            assert!((place.at.distance(at) - far).abs() < 1e-9);
            if least > 0.01 {
                assert_eq!(shape.winding(at), winding(&places, at), "{at:?}");
            }
        }
    });
}

/// Shapes cross in the places in which their chords do, and every crossing lies on both.
#[test]
fn crossings_are_where_chords_cross() {
    every_shape(3, |shape, dice| {
        let by = Vec2::new(dice.between(-9.0, 9.0), dice.between(-9.0, 9.0));
        let other = families::polyarc(77).0.similar(&Transform2::moved(by));
        let found = shape.crossings(&other);
        for crossing in &found {
            let at = crossing.first.at;
            let (_, a) = shape.nearest(at).expect("near");
            let (_, b) = other.nearest(at).expect("near");
            assert!(a < 1e-7 && b < 1e-7 && at.distance(crossing.second.at) < 1e-7);
        }
        let (mine, theirs) =
            (Polyarc::lines(sampled(shape), true), Polyarc::lines(sampled(&other), true));
        let chords = mine.crossings(&theirs);
        for crossing in &chords {
            let near = |c: &kerf_geom::Crossing| c.first.at.distance(crossing.first.at) < 0.05;
            assert!(found.iter().any(near), "{crossing:?}");
        }
        assert!(found.len() <= chords.len() + 1, "{} {}", found.len(), chords.len());
    });
}

#[test]
fn combined_regions_hold_what_they_should() {
    every_shape(3, |shape, dice| {
        let by = Vec2::new(dice.between(-9.0, 9.0), dice.between(-9.0, 9.0));
        let other = families::polyarc(5).0.similar(&Transform2::moved(by));
        let (a, b) = (std::slice::from_ref(shape), std::slice::from_ref(&other));
        let area = |how| -> f64 {
            combine(a, b, how).expect("a region").iter().map(Polyarc::signed_area).sum()
        };
        let (both, union, xor) =
            (area(Combine::Intersection), area(Combine::Union), area(Combine::Xor));
        let sum = shape.signed_area() + other.signed_area();
        assert!((both + union - sum).abs() < 1e-6 && (union - both - xor).abs() < 1e-6);
        let less = area(Combine::Difference);
        assert!((less + both - shape.signed_area()).abs() < 1e-6);
        for how in [Combine::Union, Combine::Intersection, Combine::Difference, Combine::Xor] {
            let region = combine(a, b, how).expect("a region");
            for _ in 0..40 {
                let at = anywhere(dice, &shape.bounds());
                let (p, q) = (shape.winding(at) != 0, other.winding(at) != 0);
                let wanted = match how {
                    Combine::Union => p || q,
                    Combine::Intersection => p && q,
                    Combine::Difference => p && !q,
                    Combine::Xor => p != q,
                };
                let found = region.iter().map(|contour| contour.winding(at)).sum::<i32>() != 0;
                assert_eq!(found, wanted, "{how:?} {at:?}");
            }
        }
    });
}

#[test]
fn what_is_broken_and_joined_is_whole() {
    every_shape(8, |shape, dice| {
        let (long, area) = (shape.length(), shape.signed_area());
        let place = |share: f64| shape.place_after(long * share).expect("a place");
        let open = broken(shape, &place(dice.share()));
        assert!(open.len() == 1 && !open[0].closed && (open[0].length() - long).abs() < 1e-7);
        let at = open[0].place_after(long * dice.between(0.1, 0.9)).expect("a place");
        let halves = broken(&open[0], &at);
        assert_eq!(halves.len(), 2);
        assert!((halves.iter().map(Polyarc::length).sum::<f64>() - long).abs() < 1e-7);
        // All segments, in another order and some of them turned round.
        let mut pieces = shape.exploded();
        for k in (1..pieces.len()).rev() {
            pieces.swap(k, dice.whole(0, k as i64) as usize);
            if dice.share() < 0.5 {
                pieces[k] = pieces[k].reversed();
            }
        }
        let joined = join(&pieces, 1e-4, Ends::Merge);
        assert_eq!(joined.len(), 1);
        let whole = &joined[0].path;
        assert!(whole.closed && (whole.length() - long).abs() < 1e-6);
        assert!((whole.signed_area().abs() - area.abs()).abs() < 1e-6 * long);
    });
}

/// A line across a shape takes out the stretch between its crossings and nothing else.
#[test]
fn what_is_trimmed_ends_on_the_cutter() {
    every_shape(8, |shape, dice| {
        let bounds = shape.bounds();
        let y = dice.between(0.3, 0.7) * bounds.size().y + bounds.min.y;
        let far = bounds.size().x + 1.0;
        let level = [bounds.centre() - Vec2::new(far, 0.0), bounds.centre() + Vec2::new(far, 0.0)];
        let cutter = Polyarc::lines(level.map(|p| Point2::new(p.x, y)), false);
        let crossings = shape.crossings(&cutter);
        if crossings.len() < 2 || crossings.iter().any(|c| c.along) {
            return;
        }
        let picked = shape.place_after(shape.length() * dice.share()).expect("a place").at;
        let rest = trimmed(shape, picked, std::slice::from_ref(&cutter)).expect("a rest");
        assert_eq!(rest.len(), 1);
        let ends = [rest[0].start(), rest[0].end()].map(|end| end.expect("an end"));
        ends.iter().for_each(|end| assert!((end.y - y).abs() < 1e-6));
        let (_, off) = rest[0].nearest(picked).expect("near");
        assert!(off > 1e-9 || (picked.y - y).abs() < 1e-6);
        let places = sampled(&rest[0]);
        assert!(places.iter().all(|p| shape.nearest(*p).expect("near").1 < 1e-7));
        assert!(rest[0].length() < shape.length());
    });
}

/// A fillet touches both segments, goes straight over into them, and has its radius.
#[test]
fn fillets_are_tangent_and_have_their_radius() {
    let mut made = 0;
    for seed in 0..40 {
        let mut dice = Dice::new(seed);
        let (a, b) = (dice.between(0.4, 2.6), dice.between(3.5, 5.8));
        let at = |turn: f64| Point2::default() + Vec2::from_angle(turn) * (12.0 + turn);
        let mut path = Polyarc::lines([at(a), Point2::default(), at(b)], false);
        path.vertices[0].bulge = if seed % 3 == 0 { dice.between(-0.3, 0.3) } else { 0.0 };
        let radius = dice.between(0.1, 2.0);
        let Ok(round) = fillet(&path, 1, radius) else { continue };
        made += 1;
        let segments: Vec<_> = round.segments().collect();
        let arc = segments[1].arc().expect("an arc");
        assert!((arc.radius() - radius).abs() < 1e-6, "{seed}");
        for pair in segments.windows(2) {
            assert!(pair[0].direction(1.0).cross(pair[1].direction(0.0)).abs() < 1e-6, "{seed}");
        }
        assert!(round.length() < path.length());
    }
    assert!(made > 20, "{made}");
}

/// The offset of a path that crosses itself: one path, every place of it at the distance of the segment it
/// belongs to, and the same however the path lies.
#[test]
fn a_path_with_loops_keeps_its_distance_however_it_lies() {
    let mut made = 0;
    for seed in 0..20 {
        let mut dice = Dice::new(seed);
        let (loops, size) = (dice.whole(1, 4) as f64, dice.between(8.0, 15.0));
        let place = |k: usize| {
            let t = k as f64 / 60.0 * std::f64::consts::TAU;
            Point2::new(30.0 * t + size * 2.0 * (loops * t).cos(), size * (loops * t).sin() * 2.0)
        };
        let path = Polyarc::lines((0..60).map(place), false);
        let by = dice.between(-1.5, 1.5);
        let Ok(beside) = parallel_path(&path, by) else { continue };
        let far = |p: Point2| path.nearest(p).expect("near").1;
        let places = beside.segments().flat_map(|s| [0.0, 0.3, 0.7].map(|share| s.at(share)));
        places.for_each(|p| assert!(far(p) <= by.abs() + 1e-6, "{seed}"));
        made += 1;
        let same = |other: &Polyarc, by: f64, scale: f64| {
            let found = parallel_path(other, by).expect("a path");
            assert_eq!(found.vertices.len(), beside.vertices.len(), "{seed}");
            assert!((found.length() / scale - beside.length()).abs() < 1e-6, "{seed}");
        };
        same(&path.reversed(), -by, 1.0);
        let mirror = Transform2::mirrored(Point2::new(1., 2.), Vec2::new(3., 1.));
        same(&path.similar(&mirror), -by, 1.0);
        same(&path.similar(&Transform2::moved(Vec2::new(1e4, -987.25))), by, 1.0);
        same(&path.similar(&Transform2::turned(Point2::new(5., 5.), 0.7)), by, 1.0);
        same(&path.similar(&Transform2::scaled(Point2::default(), 25.4, 25.4)), by * 25.4, 25.4);
    }
    assert!(made > 10, "{made}");
}
