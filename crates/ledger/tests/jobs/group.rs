//! Area `group`: what the cut settings of a group do on the machine, from the drawing on.

use kerf_drawing::{Editor, script};
use kerf_ledger::jobs::{JobRun, JobTrace, drawn, t1};
use kerf_program::Axis;

/// A line of the black group and one of the red group, which has these settings.
fn black_and_red(red: &str) -> JobRun {
    let clauses = format!(
        "line 0,0 100,0; line 100,50 0,50; select 2; group red; set black speed=6000; set red {red}"
    );
    JobRun::new(drawn(&clauses))
}

/// Words that refuse a setting of a group.
fn refused(setting: &str) -> String {
    let mut editor = Editor::default();
    let operations = script(&format!("set red {setting}")).expect("a script");
    editor.apply(&operations[0].1).expect_err("a refusal").to_string()
}

#[test]
fn pro_group_toolbit() {
    let signals = black_and_red("tool=2").signals();
    assert_eq!(signals.on("tool1"), [(2300, 6690)], "black only");
    assert_eq!(signals.on("tool2"), [(7640, 12030)], "red only");
    assert!(signals.on("tool3").is_empty());
    // Port B, bit 2: job running, router, tool 2.
    assert!(signals.changes("port_b").contains(&(7640, "b11000100".into())));
    for setting in ["tool=0", "tool=4"] {
        assert!(refused(setting).contains("a group has the outputs 1, 2 and 3"), "{setting}");
    }
}

#[test]
fn pro_group_cutbit() {
    let signals = black_and_red("cut=3").signals();
    // A second of bottom delay, 1.1 s of cutting.
    assert_eq!(signals.on("cut3"), [(9180, 11_280)]);
    assert_eq!(signals.on("cut1"), [(3840, 5940)]);
    assert!(signals.changes("port_b").iter().any(|(t, byte)| *t == 9180 && byte == "b11100001"));
    assert!(refused("cut=4").contains("cut is 4"));
}

#[test]
fn pro_group_bit_timing() {
    let run = || JobRun::new(t1()).with(|machine| machine.delays.air_tool_s = 0.0);
    let trace = run().run();
    // The router is up to speed at 2.3 s: tool 1 rises as the plunge begins, cut 1 at depth.
    assert_eq!(trace.moves()[1..3], ["2.300-3.340 z-30", "4.340-5.440 x100"]);
    let edges = trace.edges();
    for edge in ["2.300 tool1+", "3.340 cut1+", "5.440 cut1-"] {
        assert!(edges.contains(&edge.to_owned()), "{edge} in {edges:?}");
    }
    let first_step_down = run().signals().changes("zstep").into_iter().find(|(t, _)| *t > 1000);
    assert!(first_step_down.is_some_and(|(t_ms, _)| t_ms.abs_diff(2300) <= 10));
}

/// Speeds of the two lines, mm/s.
fn speeds(run: JobRun) -> Vec<f64> {
    run.run().cutting_speeds()
}

#[test]
fn pro_group_speed() {
    assert_eq!(speeds(black_and_red("speed=3000")), [100.0, 50.0]);
}

/// The highest speed of the line of a group, mm/min, from the time it takes.
fn cruise(group_mm_min: f64, machine_mm_min: f64, axis_mm_s: f64) -> f64 {
    let clauses = format!("line 0,0 1000,0; set black speed={group_mm_min}");
    let run = JobRun::new(drawn(&clauses)).with(|machine| {
        machine.program.smoothing.cut_speed_mm_s = Some(machine_mm_min / 60.0);
        let mut dynamics = machine.program.axis_dynamics();
        dynamics.speed_mm_s[Axis::X] = axis_mm_s;
        machine.program.dynamics = Some(dynamics);
    });
    let trace = run.run();
    let cut = trace.moves().into_iter().find(|it| it.ends_with(" x1000")).expect("the cut");
    let (t0, t1) = cut.split(' ').next().and_then(|t| t.split_once('-')).expect("times");
    let seconds: f64 = t1.parse::<f64>().expect("a time") - t0.parse::<f64>().expect("a time");
    // 1,000 mm from rest to rest at 1,000 mm/s²: L = v t − v² / a.
    let a = 1000.0;
    let v = 0.5 * (a * seconds - (a * a * seconds * seconds - 4.0 * a * 1000.0).sqrt());
    v * 60.0
}

#[test]
fn pro_group_speed_min() {
    for (group, machine, axis, expected) in [
        (9000.0, 6000.0, 200.0, 6000.0),
        (3000.0, 6000.0, 200.0, 3000.0),
        (9000.0, 6000.0, 40.0, 2400.0),
    ] {
        let found = cruise(group, machine, axis);
        assert!((found - expected).abs() < 5.0, "{group} {machine} {axis}: {found}");
    }
}

/// Heights of the cut, machine frame.
fn heights(trace: &JobTrace) -> Vec<String> {
    let moves = trace.moves();
    moves.iter().filter_map(|it| it.rsplit_once(" z").map(|(_, z)| z.to_owned())).collect()
}

#[test]
fn pro_group_h_3d() {
    // A 3D shape comes with a drawing; here its heights stand in the job as they are cut.
    let mut job = drawn("line 0,0 50,0 100,0; set black height=3d");
    let mut shapes = job.shapes.to_vec();
    shapes[0].z_mm = [-3.0, 2.0, -3.0].into();
    job.shapes = shapes.into();
    let trace = JobRun::new(job).run();
    // Home, ZTop, down to −3, up to +2, down again, ZTop; ZSurface is −20.
    assert_eq!(heights(&trace), ["-10", "-23", "-18", "-23", "-10"]);
}
