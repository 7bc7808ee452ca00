//! Jobs that lead where the machine cannot go: none of them begins.

use kerf_geom::{Point2, Polyarc};
use kerf_ledger::jobs::{JobRun, drawn, job, line, square, t1, t2};
use kerf_machine::settings::homing::HomeEnd;
use kerf_machine::settings::job::Heads;
use kerf_machine::{file, profile};
use kerf_program::Axis;
use kerf_program::job::{CutDepth, JobShape, Plunge};

/// A job that is refused before anything happens, with this.
fn refused(run: JobRun, why: &str) {
    let trace = run.run();
    assert_eq!(trace.refused(), why);
    assert!(trace.moves().is_empty() && trace.edges().is_empty(), "{:?}", trace.moves());
}

/// A job that is cut.
fn cut(run: JobRun) -> Vec<String> {
    let trace = run.run();
    assert_eq!(trace.refused(), "");
    trace.moves()
}

/// The ready-made knife.
fn knife(clauses: &str) -> JobRun {
    let text = profile::profile("knife").expect("the profile").text;
    let machine = file::read(&"knife".into(), text).expect("a profile without mistakes");
    JobRun::new(drawn(clauses)).with(|it| *it = machine)
}

#[test]
fn pro_axes_limit_on__at_the_finish_position() {
    let ends_at = |x: f64, y: f64| JobRun::new(t2()).job(|it| it.finish = Some(Point2::new(x, y)));
    refused(ends_at(9999.0, 0.0), "Out of bounds: the finish position reaches X 9999.000");
    refused(ends_at(0.0, -0.001), "Out of bounds: the finish position reaches Y -0.001");
    let set = JobRun::new(t2()).with(|machine| machine.job.finish_mm = [-5.0, 0.0]);
    refused(set, "Out of bounds: the finish position reaches X -5.000");
    // It counts from the origin of the job.
    let from = |x: f64| ends_at(-5.0, 0.0).job(|it| it.origin = Some(Point2::new(x, 0.0)));
    refused(from(4.0), "Out of bounds: the finish position reaches X -1.000");
    let moves = cut(from(5.0));
    assert!(moves.last().expect("moves").ends_with(" x-5 y0"), "{moves:?}");
    let anywhere = ends_at(9999.0, 0.0).with(|machine| machine.axes.limit_movement = false);
    assert!(cut(anywhere).last().expect("moves").ends_with(" x9999 y0"));
}

#[test]
fn pro_axes_limit_on__where_start_takes_the_place_it_stands_at() {
    let run = JobRun::new(t1()).at(2450.0, 0.0, 0.0);
    let here = run.with(|machine| machine.job.change_origin_at_start = true);
    refused(here, "Out of bounds: shape 1 reaches X 2550.000");
}

#[test]
fn pro_axes_limit_on__up_and_down() {
    let high = |z_mm: f64| {
        let path = Polyarc::lines([(0.0, 0.0), (50.0, 0.0)].map(|(x, y)| Point2::new(x, y)), false);
        let z_mm = [0.0, z_mm].into();
        let shape = JobShape { height: CutDepth::ThreeD, z_mm, ..JobShape::through(1, path) };
        JobRun::new(job([shape]))
    };
    refused(high(21.0), "Out of bounds: shape 1 reaches Z 1.000");
    cut(high(19.0));
    let level = |depth_mm: f64| {
        let height = CutDepth::Mm(depth_mm);
        let shape = JobShape { height, ..line(1, (0.0, 0.0), (50.0, 0.0)) };
        JobRun::new(job([shape]))
    };
    refused(level(30.0), "Out of bounds: shape 1 reaches Z 10.000");
    let top = JobRun::new(t1()).with(|machine| machine.zpos.top_mm = 5.0);
    refused(top, "Out of bounds: ZTop reaches Z 5.000");
}

#[test]
fn pro_axes_limit_on__beside_the_path() {
    let helix = |y: f64| {
        let plunge = Plunge::Helix { radius_mm: 5.0, angle_deg: 5.0 };
        JobRun::new(job([JobShape { plunge, ..line(1, (20.0, y), (50.0, y)) }]))
    };
    refused(helix(9.5), "Out of bounds: shape 1 reaches Y -0.500");
    cut(helix(10.5));
}

#[test]
fn pro_axes_limit_on__of_the_table() {
    let limited = |high_x: f64| {
        JobRun::new(t1()).with(|machine| {
            machine.program.limits.check = true;
            machine.program.limits.high[Axis::X] = high_x;
        })
    };
    refused(limited(99.0), "Out of bounds: shape 1 reaches X 100.000");
    cut(limited(100.0));
    let second = |length: f64| {
        let two = JobRun::new(t1());
        two.with(|machine| {
            machine.job.heads = Heads::Both;
            machine.axes.length[Axis::A] = length;
            machine.homing.switches[Axis::A.index()].end = HomeEnd::High;
        })
    };
    refused(second(25.0), "Out of bounds: shape 1 reaches A -30.000");
}

#[test]
fn pro_axes_tangent_wrap__on_the_ready_made_knife() {
    // Four circles in two laps: eight turns, never back.
    let circles = "circle 300,100 20; circle 400,100 20; circle 500,100 20; circle 600,100 20";
    let moves = cut(knife(circles).with(|machine| machine.job.repeats = 2));
    let turned = moves.iter().filter_map(|it| it.rsplit_once(" c")).map(|(_, c)| c.parse::<f64>());
    let most = turned.map(|c| c.expect("degrees")).fold(0.0, f64::max);
    assert_eq!(most, 90.0 + 8.0 * 360.0);
}

#[test]
fn a_knife_whose_axis_ends_does_not_begin_what_it_cannot_turn() {
    let ends = |clauses: &str, repeats: u32| {
        knife(clauses).with(|machine| {
            (machine.misc.tangential_endless, machine.job.repeats) = (false, repeats);
        })
    };
    refused(ends("circle 300,100 20", 1), "Out of bounds: shape 1 reaches C 450.000");
    // To and fro it never gets further; a square is a turn a lap, and the second is one too many.
    cut(ends("line 10,10 60,10; line 60,20 10,20", 9));
    let lap = |repeats: u32| {
        let run = ends("line 10,10 60,10", repeats);
        run.job(|it| *it = job([square(1, (10.0, 10.0), 50.0)]))
    };
    cut(lap(1));
    refused(lap(2), "Out of bounds: shape 1 reaches C 450.000");
    // By its length as by the limits of the table.
    let short = knife("circle 300,100 20").with(|machine| {
        machine.axes.length[Axis::C] = 400.0;
        machine.homing.switches[Axis::C.index()].end = HomeEnd::Low;
    });
    refused(short, "Out of bounds: shape 1 reaches C 450.000");
}
