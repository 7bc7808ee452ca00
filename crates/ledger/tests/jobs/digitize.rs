//! Area `digitize`: ways along digitized points, driven on the machine.

use kerf_digitize::{Digitizer, Kind, Leg, Stand};
use kerf_geom::{Point2, Segment};
use kerf_ledger::jobs::{JobRun, JobTrace};
use kerf_machine::lines::Input;
use kerf_machine::{Errand, Stretch};
use kerf_program::Status;
use kerf_trace::Event;

/// L(0,0), A(5,-5), L(10,0), L(10,10), the last one current.
fn points() -> Digitizer {
    let mut made = Digitizer::default();
    for (x, y, kind) in
        [(0., 0., Kind::Line), (5., -5., Kind::Arc), (10., 0., Kind::Line), (10., 10., Kind::Line)]
    {
        if made.next() != kind {
            made.toggle().unwrap();
        }
        made.append(Stand::new(x, y, -5.0)).unwrap();
    }
    made
}

fn along(way: &[Leg]) -> Errand {
    Errand::Along(way.iter().map(|leg| Stretch { path: leg.path, z_mm: leg.z_mm }).collect())
}

/// With the job origin at (300, 200), the tool at a place from there.
fn drive(way: &[Leg], x: f64, y: f64) -> JobRun {
    let run = JobRun::hand(along(way)).with(|machine| machine.job.origin_mm = [300.0, 200.0]);
    run.at(300.0 + x, 200.0 + y, -5.0)
}

/// Moves from the job origin: `to 10,10`, `cw 90 about 5,0 to 0,0`.
fn ways(trace: &JobTrace) -> Vec<String> {
    let r = |v: f64| (v * 1e6).round() / 1e6 + 0.0;
    let end =
        |to: &kerf_trace::event::Location| format!("to {},{}", r(to.x - 300.0), r(to.y - 200.0));
    let told = |event: &Event| match event {
        Event::Move(made) => Some(end(&made.to)),
        Event::Arc(arc) => {
            let (x, y) = (r(arc.centre.x - 300.0), r(arc.centre.y - 200.0));
            Some(format!("{} {} about {x},{y} {}", arc.dir, r(arc.sweep), end(&arc.made.to)))
        }
        _ => None,
    };
    trace.events.iter().filter_map(told).collect()
}

#[test]
fn ways_along_the_points_are_lines_and_arcs() {
    let mut made = points();
    let back = made.way_to(&Stand::new(10.0, 10.0, -5.0), 1);
    let trace = drive(&back, 10.0, 10.0).run();
    let expected = ["to 10,0", "cw 90 about 5,0 to 5,-5", "cw 90 about 5,0 to 0,0"];
    assert_eq!(ways(&trace), expected);
    assert_eq!(trace.rests(), [300.0, 200.0, -5.0]);
    made.moved(&back, &Stand::new(0.0, 0.0, -5.0));
    let on = made.way_to(&Stand::new(0.0, 0.0, -5.0), 4);
    let trace = drive(&on, 0.0, 0.0).run();
    let expected = ["ccw 90 about 5,0 to 5,-5", "ccw 90 about 5,0 to 10,0", "to 10,10"];
    assert_eq!(ways(&trace), expected);
    assert_eq!(trace.summary.status, Status::Ok);
}

#[test]
fn a_stop_ends_a_way_where_the_tool_comes_to_rest() {
    let mut made = points();
    let back = made.way_to(&Stand::new(10.0, 10.0, -5.0), 1);
    let whole = drive(&back, 10.0, 10.0).run();
    let arc_begins = whole.events.iter().find_map(|event| match event {
        Event::Arc(arc) => Some(arc.made.t0),
        _ => None,
    });
    // In the first half of the arc.
    let stopped = drive(&back, 10.0, 10.0).stop(arc_begins.unwrap() + 0.05).run();
    assert_eq!(stopped.summary.status, Status::Ended);
    assert_eq!(stopped.states().last(), None, "nobody is asked whether it goes on");
    let [x, y, z] = stopped.rests();
    let on_arc = (Point2::new(x, y).distance(Point2::new(305.0, 200.0)) - 5.0).abs();
    assert!(on_arc < 1e-6 && y < 200.0 && x > 305.0, "{x} {y}");
    assert_eq!(z, -5.0, "it is not raised");
    made.moved(&back, &Stand::new(x - 300.0, y - 200.0, z));
    assert_eq!(made.current(), 3);
}

#[test]
fn a_way_out_of_bounds_is_refused_before_it_begins() {
    // Its end lies on the table, the middle of the arc does not.
    let arc = Segment::bulged(Point2::new(-290.0, 0.0), Point2::new(-290.0, 60.0), -1.0);
    let way = [Leg { path: arc, z_mm: None, point: 1 }];
    let trace = drive(&way, -290.0, 0.0).run();
    assert_eq!(trace.summary.status, Status::Failed);
    assert!(trace.refused().starts_with("Out of bounds: x would reach -20"), "{}", trace.refused());
    assert!(ways(&trace).is_empty());
}

#[test]
fn pro_estop_trigger__while_digitizing() {
    let way = points().way_to(&Stand::new(10.0, 10.0, -5.0), 1);
    let whole = drive(&way, 10.0, 10.0).run();
    let span = |event: &Event| match event {
        Event::Arc(arc) => Some((arc.made.t0, arc.made.t1)),
        Event::Move(made) => Some((made.t0, made.t1)),
        _ => None,
    };
    let spans: Vec<_> = whole.events.iter().filter_map(span).collect();
    for (t0, t1) in spans {
        // While it gathers speed: it slows down from the very moment, in the time that it took.
        let at_s = t0 + 0.2 * (t1 - t0);
        let trace = drive(&way, 10.0, 10.0).input(Input::EmergencyStop, at_s, true).run();
        let ended = trace.events.iter().rev().find_map(span).map(|(_, end)| end);
        assert!(ended.is_some_and(|end| end <= t0 + 2.0 * (at_s - t0) + 1e-3), "{at_s} {ended:?}");
        assert_eq!(trace.summary.status, Status::Stopped);
        assert_eq!(trace.summary.error.unwrap().message, "emergency stop");
    }
}
