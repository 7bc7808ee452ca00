//! Edits on digitized points (Profiler reference, table 27), as they are seen in the list.

use kerf_digitize::{Digitizer, Dimension, Kind, Refusal, Stand};
use kerf_drawing::{Group, Shape};
use kerf_geom::Segment;

fn at(x: f64, y: f64) -> Stand {
    Stand::new(x, y, 0.0)
}

/// Points as `L0,0 A5,-5`.
fn points(text: &str) -> Digitizer {
    let mut made = Digitizer::default();
    for word in text.split_whitespace() {
        let (kind, place) = word.split_at(1);
        let (x, y) = place.split_once(',').unwrap();
        be(&mut made, if kind == "A" { Kind::Arc } else { Kind::Line });
        made.append(at(x.parse().unwrap(), y.parse().unwrap())).unwrap();
    }
    be(&mut made, Kind::Line);
    made
}

/// The next point is of a kind.
fn be(made: &mut Digitizer, kind: Kind) {
    if made.next() != kind {
        made.toggle().unwrap();
    }
}

/// The points as they are read, and which one is current.
fn shown(made: &Digitizer) -> String {
    let letter = |kind| if kind == Kind::Arc { 'A' } else { 'L' };
    let one = |point: &kerf_digitize::Point| {
        format!("{}{},{}", letter(point.kind), point.stand.at.x, point.stand.at.y)
    };
    let all: Vec<_> = made.points().iter().map(one).collect();
    format!("{} ({} of {})", all.join(" "), made.current(), made.points().len())
}

/// With another current point.
fn with_current(mut made: Digitizer, number: usize) -> Digitizer {
    let way = made.way_to(&at(0.0, 0.0), number);
    arrive(&mut made, &way);
    made
}

/// The tool goes to the end of a way.
fn arrive(made: &mut Digitizer, way: &[kerf_digitize::Leg]) {
    if let Some(last) = way.last() {
        made.moved(way, &Stand { at: last.path.end(), z_mm: 0.0 });
    }
}

fn open(text: &str) -> Shape {
    points(text).shape(false, 0.0).unwrap()
}

#[test]
fn pro_digitize_linepoint() {
    let shape = open("L0,0 L10,0");
    assert_eq!((shape.path.segment_count(), shape.path.length()), (1, 10.0));
    assert_eq!((shape.group, shape.z_mm), (Group::Black, None));
}

#[test]
fn pro_digitize_arcpoint() {
    let shape = open("L0,0 A5,-5 L10,0");
    let Segment::Arc { centre, radius, .. } = shape.path.segment(0) else { panic!("{shape:?}") };
    assert!((shape.path.vertices[0].bulge - 1.0).abs() < 1e-12);
    assert!(
        (centre.x - 5.0).abs() < 1e-12 && centre.y.abs() < 1e-12 && (radius - 5.0).abs() < 1e-12
    );
}

#[test]
fn pro_digitize_arc_collinear() {
    let shape = open("L0,0 A5,0 L10,0");
    assert_eq!((shape.path.vertices.len(), shape.path.vertices[0].bulge), (2, 0.0));
}

#[test]
fn pro_digitize_arc_adjacent__in_the_list() {
    let mut made = points("L0,0 A5,0");
    let before = made.clone();
    be(&mut made, Kind::Arc);
    let told = made.append(at(7.0, 1.0)).unwrap_err();
    assert_eq!(told.to_string(), "arc point needs an end point");
    assert_eq!(made.points(), before.points());
    assert_eq!(made.shape(false, 0.0), Err(Refusal::ArcAtEnd(2)));
    assert_eq!(points("A5,0 L10,0").shape(false, 0.0), Err(Refusal::ArcAtEnd(1)));
    // Neither can a line point between two arcs go, nor become one.
    let mut between = with_current(points("L0,0 A1,1 L2,0 A3,1 L4,0"), 3);
    assert_eq!(between.delete(), Err(Refusal::ArcBesideArc));
    be(&mut between, Kind::Arc);
    assert_eq!(between.modify(at(2.0, 0.0)), Err(Refusal::ArcBesideArc));
    assert_eq!(shown(&between), "L0,0 A1,1 L2,0 A3,1 L4,0 (3 of 5)");
}

#[test]
fn pro_digitize_closedopen__of_one_list() {
    let made = points("L0,0 L100,0 L0,100");
    let (open, closed) = (made.shape(false, 0.0).unwrap(), made.shape(true, 0.0).unwrap());
    assert!(!open.is_closed() && closed.is_closed());
    assert_eq!((open.path.segment_count(), closed.path.segment_count()), (2, 3));
}

#[test]
fn insertions_and_deletions_act_on_the_current_point() {
    let five = "L1,0 L2,0 L3,0 L4,0 L5,0";
    let mut made = with_current(points(five), 3);
    made.insert_after(at(3.0, 9.0)).unwrap();
    assert_eq!(shown(&made), "L1,0 L2,0 L3,0 L3,9 L4,0 L5,0 (4 of 6)");
    made.delete().unwrap();
    assert_eq!(shown(&made), "L1,0 L2,0 L3,0 L4,0 L5,0 (4 of 5)");
    let mut made = with_current(points(five), 3);
    made.delete().unwrap();
    assert_eq!(shown(&made), "L1,0 L2,0 L4,0 L5,0 (3 of 4)");
    let mut made = points("L0,0 L10,0");
    made.insert_before(at(5.0, 5.0)).unwrap();
    assert_eq!(shown(&made), "L0,0 L5,5 L10,0 (2 of 3)");
    for left in ["L0,0 L5,5 (2 of 2)", "L0,0 (1 of 1)", " (0 of 0)"] {
        let way = made.way_to(&at(0.0, 0.0), made.points().len());
        arrive(&mut made, &way);
        made.delete().unwrap();
        assert_eq!(shown(&made), left);
    }
    assert_eq!(made.delete(), Err(Refusal::NoPoints));
    assert_eq!(made.modify(at(0.0, 0.0)), Err(Refusal::NoPoints));
    made.insert_before(at(7.0, 7.0)).unwrap();
    assert_eq!(shown(&made), "L7,7 (1 of 1)");
}

#[test]
fn points_are_added_behind_the_last_one_only() {
    let mut made = with_current(points("L1,0 L2,0 L3,0"), 2);
    assert_eq!(made.append(at(4.0, 0.0)).unwrap_err().to_string(), "not at end");
    assert_eq!(shown(&made), "L1,0 L2,0 L3,0 (2 of 3)");
}

#[test]
fn a_point_becomes_another_one() {
    let mut made = with_current(points("L0,0 L10,0 L20,0"), 2);
    be(&mut made, Kind::Arc);
    made.modify(at(10.0, 2.0)).unwrap();
    assert_eq!(shown(&made), "L0,0 A10,2 L20,0 (2 of 3)");
}

#[test]
fn there_are_no_arcs_in_3d() {
    let mut made = points("L0,0 A5,0 L10,0");
    assert_eq!(made.set_dimension(Dimension::Three), Err(Refusal::ArcInSpace));
    made.clear();
    be(&mut made, Kind::Arc);
    made.set_dimension(Dimension::Three).unwrap();
    assert_eq!((made.next(), made.toggle()), (Kind::Line, Err(Refusal::ArcInSpace)));
    made.clear();
    assert_eq!(made.dimension(), Dimension::Three);
}

#[test]
fn too_few_points_make_no_closed_shape() {
    let told = |text: &str, closed| points(text).shape(closed, 0.0).unwrap_err();
    assert_eq!(told("L0,0 L10,0", true), Refusal::TooFewToClose);
    assert_eq!(told("L0,0 L10,0 L0,0", true), Refusal::TooFewToClose);
    assert_eq!(told("L0,0", true), Refusal::TooFewToClose);
    assert_eq!(told("", false), Refusal::NoPoints);
    assert_eq!(told("L1,1 L1,1", false), Refusal::OnePlace);
    assert_eq!(told("L0,0 A20,0 L10,0", false), Refusal::NoArc(2));
    assert_eq!(told("L0,0 A20,0 L0,0", false), Refusal::NoArc(2));
    assert_eq!(told("L0,0 L2e9,0", false), Refusal::TooFar);
    let with_arc = points("L0,0 A5,-5 L10,0").shape(true, 0.0).unwrap();
    assert_eq!((with_arc.is_closed(), with_arc.path.segment_count()), (true, 2));
    // A place to drill.
    assert_eq!(open("L3,4").kind(), kerf_drawing::Kind::Point);
}

#[test]
fn a_circle_is_closed_by_its_last_point() {
    let circle = points("L0,0 A5,-5 L10,0 A5,5 L0,0").shape(true, 0.0).unwrap();
    assert_eq!(circle.path.vertices.len(), 2);
    assert!((circle.path.length() - std::f64::consts::TAU * 5.0).abs() < 1e-9);
}

#[test]
fn heights_count_from_zsurface_in_3d_only() {
    let mut made = Digitizer::default();
    made.append(Stand::new(0.0, 0.0, -20.0)).unwrap();
    made.append(Stand::new(10.0, 0.0, -23.0)).unwrap();
    assert_eq!(made.shape(false, -20.0).unwrap().z_mm, None);
    made.set_dimension(Dimension::Three).unwrap();
    assert_eq!(made.shape(false, -20.0).unwrap().z_mm, Some(vec![0.0, -3.0]));
    // Straight down is a way of its own; the same place twice is not.
    made.append(Stand::new(10.0, 0.0, -25.0)).unwrap();
    made.append(Stand::new(10.0, 0.0, -25.0)).unwrap();
    assert_eq!(made.shape(false, -20.0).unwrap().z_mm, Some(vec![0.0, -3.0, -5.0]));
}

#[test]
fn ways_follow_lines_and_arcs_through_every_point() {
    let made = with_current(points("L0,0 A5,-5 L10,0 L10,10"), 1);
    let ends = |made: &Digitizer, tool, to| -> Vec<(f64, f64, usize)> {
        let way = made.way_to(&tool, to);
        way.iter().map(|leg| (leg.path.end().x, leg.path.end().y, leg.point)).collect()
    };
    assert_eq!(ends(&made, at(0.0, 0.0), 4), [(5.0, -5.0, 2), (10.0, 0.0, 3), (10.0, 10.0, 4)]);
    let way = made.way_to(&at(0.0, 0.0), 4);
    for leg in &way[..2] {
        let Segment::Arc { centre, sweep_rad, .. } = leg.path else { panic!("{leg:?}") };
        assert!((centre.x - 5.0).abs() < 1e-9 && centre.y.abs() < 1e-9);
        assert!((sweep_rad - std::f64::consts::FRAC_PI_2).abs() < 1e-9, "{sweep_rad}");
    }
    // Back over the same arc, the other way round.
    let back = with_current(made.clone(), 3).way_to(&at(10.0, 0.0), 1);
    let Segment::Arc { sweep_rad, .. } = back[0].path else { panic!("{back:?}") };
    assert!((sweep_rad + std::f64::consts::FRAC_PI_2).abs() < 1e-9);
    // A tool that is elsewhere goes to the current point first.
    assert_eq!(ends(&made, at(3.0, 4.0), 2), [(0.0, 0.0, 1), (5.0, -5.0, 2)]);
    assert!(made.way_back(&at(0.0, 0.0)).is_empty());
    assert!(with_current(made, 4).way_on(&at(10.0, 10.0)).is_empty());
    assert!(Digitizer::default().way_to(&at(0.0, 0.0), 1).is_empty());
}

#[test]
fn a_way_that_is_stopped_leaves_the_last_point_passed() {
    let mut made = with_current(points("L0,0 A5,-5 L10,0 L10,10"), 1);
    let way = made.way_to(&at(0.0, 0.0), 4);
    let stopped = |x, y| {
        let mut made = made.clone();
        made.moved(&way, &at(x, y));
        made.current()
    };
    assert_eq!(stopped(0.0, 0.0), 1);
    assert_eq!(stopped(8.535_533_9, -3.535_533_9), 2);
    assert_eq!(stopped(10.0, 0.0), 3);
    assert_eq!(stopped(10.0, 4.0), 3);
    arrive(&mut made, &way);
    assert_eq!(made.current(), 4);
}

#[test]
fn the_nearest_point_is_found_in_the_plane_or_in_space() {
    let mut made = points("L0,0 L10,0");
    assert_eq!(made.nearest(&at(9.0, 1.0)), Ok(2));
    assert_eq!(Digitizer::default().nearest(&at(0.0, 0.0)), Err(Refusal::NoPoints));
    made.clear();
    made.append(Stand::new(0.0, 0.0, 0.0)).unwrap();
    made.append(Stand::new(1.0, 0.0, -50.0)).unwrap();
    let low = Stand::new(0.0, 0.0, -40.0);
    assert_eq!(made.nearest(&low), Ok(1));
    made.set_dimension(Dimension::Three).unwrap();
    assert_eq!(made.nearest(&low), Ok(2));
}

#[test]
fn points_that_were_saved_are_known() {
    let mut made = points("L0,0 L10,0");
    assert!(made.is_unsaved());
    made.saved();
    assert!(!made.is_unsaved());
    made.append(at(20.0, 0.0)).unwrap();
    assert!(made.is_unsaved());
    made.clear();
    assert!(!made.is_unsaved());
}

#[test]
fn a_way_straight_down_is_done_at_its_bottom() {
    let mut made = Digitizer::default();
    made.set_dimension(Dimension::Three).unwrap();
    made.append(Stand::new(5.0, 5.0, 0.0)).unwrap();
    made.append(Stand::new(5.0, 5.0, -9.0)).unwrap();
    made = with_current(made, 1);
    let down = made.way_on(&Stand::new(5.0, 5.0, 0.0));
    made.moved(&down, &Stand::new(5.0, 5.0, -4.0));
    assert_eq!(made.current(), 1);
    made.moved(&down, &Stand::new(5.0, 5.0, -9.0));
    assert_eq!(made.current(), 2);
}
