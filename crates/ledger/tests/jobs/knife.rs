//! Area `axes`: a knife that is turned along the path.

use kerf_ledger::jobs::{JobRun, JobTrace, drawn, job, square};
use kerf_program::Axis;

fn knife(run: JobRun) -> JobTrace {
    run.with(|machine| machine.misc.tangential = true).run()
}

fn ends(trace: &JobTrace) -> Vec<String> {
    let moves = trace.moves();
    moves.iter().map(|m| m.split_once(' ').map_or("", |(_, end)| end).to_owned()).collect()
}

/// Duration of the move that ends there, seconds.
fn seconds(trace: &JobTrace, end: &str) -> f64 {
    let moves = trace.moves();
    let found = moves.iter().find(|it| it.ends_with(end)).unwrap_or_else(|| panic!("{moves:?}"));
    let (t0, t1) = found.split(' ').next().and_then(|t| t.split_once('-')).expect("times");
    t1.parse::<f64>().expect("a time") - t0.parse::<f64>().expect("a time")
}

#[test]
fn pro_axes_tangent_line() {
    let trace = knife(JobRun::new(job([square(1, (0.0, 0.0), 100.0)])));
    // Along a side W stands; at a corner X and Y do.
    let sides = ["z-10", "z-30", "x100", "c90", "y100", "c180", "x0", "c270", "y0"];
    // The corner at which it began comes last, above the work.
    assert_eq!(ends(&trace), [&sides[..], &["z-10", "c360"]].concat());
}

#[test]
fn pro_axes_tangent_arc() {
    // A circle of radius 10 at 50 mm/s would take 286 degrees a second; W has 180.
    let circle = "circle 50,50 10; set black speed=3000";
    let with = |w_deg_s: f64| {
        let run = JobRun::new(drawn(circle)).with(|machine| {
            let mut dynamics = machine.program.axis_dynamics();
            dynamics.speed_mm_s[Axis::C] = w_deg_s;
            dynamics.accel_mm_s2[Axis::C] = 1e5;
            machine.program.dynamics = Some(dynamics);
        });
        let trace = knife(run);
        // Both halves of the circle, less what speeding up and slowing down takes.
        let whole = seconds(&trace, "x40 c270") + seconds(&trace, "x60 c450");
        20.0 * std::f64::consts::PI / whole
    };
    let (free, held) = (with(100_000.0), with(180.0));
    assert!((46.0..50.0).contains(&free), "{free} mm/s");
    assert!((29.5..31.417).contains(&held), "{held} mm/s");
}

#[test]
fn pro_axes_tangent_wrap() {
    // Two passes of a closed circle are two turns.
    let clauses =
        "circle 50,50 10; circle 150,50 10; set black height=-8 pass=4; select 2; reverse";
    let trace = knife(JobRun::new(drawn(clauses)));
    let turns: Vec<String> = ends(&trace)
        .into_iter()
        .filter_map(|end| end.rsplit_once('c').map(|(_, c)| c.to_owned()))
        .collect();
    // Turned to 90 before the plunge, twice round without winding back; then at ZTop to -90, which is
    // 630 or 990: the nearer is 810 − 180 = 630; and round clockwise.
    assert_eq!(turns[..5], ["90", "270", "450", "630", "810"]);
    assert_eq!(turns[5..], ["630", "450", "270", "90", "-90"]);
    let lines = ends(&trace);
    let turned = lines.iter().position(|end| end == "c630").expect("the turn at ZTop");
    assert_eq!(lines[turned - 1], "x160", "{lines:?}");
    assert_eq!(lines[turned + 1], "z-24", "{lines:?}");
}
