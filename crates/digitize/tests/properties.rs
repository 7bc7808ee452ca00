//! Properties of all points: a shape that is loaded and saved again is the same shape, and no edit leaves the list as
//! it must not be.

use kerf_digitize::{Digitizer, Dimension, Kind, Stand, nearest_shape};
use kerf_drawing::Shape;
use kerf_geom::{Point2, Polyarc, Vertex};
use proptest::prelude::*;

/// Vertices a few millimetres apart at least.
fn path() -> impl Strategy<Value = Polyarc> {
    let vertex = ((-40..40i32), prop_oneof![Just(0.0), -1.5..1.5f64]);
    (prop::collection::vec(vertex, 3..9), any::<bool>()).prop_map(|(all, closed)| {
        let places = all.into_iter().enumerate();
        let mut vertices: Vec<_> = places
            .map(|(n, (y, bulge))| Vertex::new(n as f64 * 7.0, f64::from(y), bulge))
            .collect();
        if let (false, Some(last)) = (closed, vertices.last_mut()) {
            last.bulge = 0.0;
        }
        Polyarc { vertices, closed }
    })
}

fn same(a: &Polyarc, b: &Polyarc) -> bool {
    let near = |(a, b): (&Vertex, &Vertex)| a.at == b.at && (a.bulge - b.bulge).abs() < 1e-9;
    a.closed == b.closed
        && a.vertices.len() == b.vertices.len()
        && a.vertices.iter().zip(&b.vertices).all(near)
}

proptest! {
    #[test]
    fn a_flat_shape_comes_back(path in path()) {
        let mut made = Digitizer::default();
        let shape = Shape::flat(path);
        made.load(&shape, -20.0, &Stand::default()).unwrap();
        let saved = made.shape(shape.is_closed(), -20.0).unwrap();
        prop_assert!(same(&saved.path, &shape.path), "{saved:?}");
        let mut again = Digitizer::default();
        again.load(&saved, -20.0, &Stand::default()).unwrap();
        prop_assert_eq!(again.points().len(), made.points().len());
        for (a, b) in again.points().iter().zip(made.points()) {
            prop_assert!(a.kind == b.kind && a.stand.at.distance(b.stand.at) < 1e-6);
        }
    }

    #[test]
    fn a_shape_with_heights_comes_back(path in path(), heights in prop::collection::vec(-30..5i32, 9)) {
        let lines = Polyarc::lines(path.vertices.iter().map(|v| v.at), path.closed);
        let z = heights.into_iter().take(lines.vertices.len()).map(f64::from).collect();
        let shape = Shape::with_heights(lines, z);
        let mut made = Digitizer::default();
        made.load(&shape, -20.0, &Stand::default()).unwrap();
        prop_assert_eq!(made.dimension(), Dimension::Three);
        prop_assert_eq!(made.shape(shape.is_closed(), -20.0).unwrap(), shape);
    }

    #[test]
    fn the_way_along_a_path_is_as_long_as_the_path(path in path()) {
        let mut made = Digitizer::default();
        made.load(&Shape::flat(path.clone()), 0.0, &Stand::default()).unwrap();
        let start = made.points()[0].stand;
        let way = made.way_to(&start, made.points().len());
        let long: f64 = way.iter().map(|leg| leg.path.length()).sum();
        // A line that closes is no way between points.
        let arc_closes = path.closed && path.vertices.last().unwrap().bulge != 0.0;
        let count = path.segment_count() - usize::from(path.closed && !arc_closes);
        let expected: f64 = path.segments().take(count).map(|s| s.length()).sum();
        prop_assert!((long - expected).abs() < 1e-6, "{} {}", long, expected);
        prop_assert!(way.windows(2).all(|two| two[0].path.end() == two[1].path.start()));
        let end = made.points().last().unwrap().stand;
        made.moved(&way, &end);
        let back = made.way_to(&end, 1);
        let returned: f64 = back.iter().map(|leg| leg.path.length()).sum();
        prop_assert!((returned - long).abs() < 1e-6);
    }

    #[test]
    fn edits_keep_the_list_sound(edits in prop::collection::vec((0..8u8, -50..50i32, -50..50i32), 0..60)) {
        let mut made = Digitizer::default();
        for (edit, x, y) in edits {
            let tool = Stand::new(f64::from(x), f64::from(y), f64::from(x - y));
            let before = made.clone();
            let done = match edit {
                0 => made.append(tool),
                1 => made.insert_after(tool),
                2 => made.insert_before(tool),
                3 => made.delete(),
                4 => made.modify(tool),
                5 => made.toggle(),
                6 => made.set_dimension(if x > 40 { Dimension::Three } else { Dimension::Two }),
                _ => { made.moved(&made.way_back(&tool), &tool); Ok(()) }
            };
            if done.is_err() {
                prop_assert_eq!(&made, &before);
            }
            let (count, current) = (made.points().len(), made.current());
            prop_assert!(current <= count && (current > 0) == (count > 0));
            let arcs = made.points().windows(2).filter(|two| two.iter().all(|p| p.kind == Kind::Arc));
            prop_assert_eq!(arcs.count(), 0);
            // Whatever the list is: a shape, or words.
            for closed in [false, true] {
                if let Ok(shape) = made.shape(closed, -20.0) {
                    prop_assert!(shape.path.check().is_ok());
                }
            }
            prop_assert_eq!(made.segments().len(), count.saturating_sub(1));
        }
    }

    #[test]
    fn what_is_kept_comes_back(path in path()) {
        let mut made = Digitizer::default();
        made.load(&Shape::flat(path), 0.0, &Stand::default()).unwrap();
        let kept = serde_json::to_string(&made).unwrap();
        prop_assert_eq!(serde_json::from_str::<Digitizer>(&kept).unwrap(), made);
    }
}

#[test]
fn the_nearest_shape_is_that_whose_path_passes_nearest() {
    let square = |x: f64| {
        let corners = [(x, 0.0), (x + 100.0, 0.0), (x + 100.0, 100.0), (x, 100.0)];
        Shape::flat(Polyarc::lines(corners.map(|(x, y)| Point2::new(x, y)), true))
    };
    let shapes = [square(0.0), square(300.0)];
    let (n, far) = nearest_shape(&shapes, Point2::new(297.0, 50.0)).unwrap();
    assert_eq!((n, far), (1, 3.0));
    assert!(nearest_shape(&[], Point2::default()).is_err());
}
