//! Area `height`: Z follows a warped sheet, closed loop on the simulated machine.

use kerf_control::Event;
use kerf_ledger::jobs::{JobRun, JobTrace, job, line, t1};
use kerf_machine::lines::Input;
use kerf_machine::settings::height::HeightMode;
use kerf_program::job::Depth;
use kerf_sim::Sheet;

/// JOB-T1 with proportional height control over a sheet.
fn over(sheet: Sheet) -> JobRun {
    JobRun::new(t1())
        .with(|machine| {
            (machine.height.on, machine.height.mode) = (true, HeightMode::Proportional);
            machine.height.k = 9.5;
        })
        .sheet(sheet)
}

/// The sheet of the notes: it rises 3 mm on 60 mm.
fn rising(slope_x: f64) -> Sheet {
    Sheet { slope_x, ..Sheet::flat(-20.0) }
}

/// Times, heights and errors of the readings, mm.
fn readings(trace: &JobTrace) -> Vec<(f64, f64, f64)> {
    let told = trace.events.iter().filter_map(|event| match event {
        Event::Height { z, error, t } => Some((*t, *z, *error)),
        _ => None,
    });
    told.collect()
}

/// The greatest error from so long after the first reading on, mm.
fn worst(trace: &JobTrace, settled_s: f64) -> f64 {
    let all = readings(trace);
    let begin = all.first().expect("readings").0;
    all.iter().filter(|(t, ..)| *t > begin + settled_s).map(|(.., e)| e.abs()).fold(0.0, f64::max)
}

#[test]
fn pro_height_prop_accuracy() {
    let trace = over(rising(0.05)).with(|machine| machine.height.baud = 2400).run();
    let error = worst(&trace, 0.1);
    assert!(error <= 0.1, "{error} mm at 6 m/min, a reading every 4 ms");
    let faster = worst(&over(rising(0.05)).run(), 0.1);
    assert!(faster <= 0.1, "{faster} mm at 9600 baud");
}

#[test]
fn pro_height_prop_x() {
    let trace = over(Sheet::flat(-20.0)).run();
    let (_, z, _) = *readings(&trace).last().expect("readings");
    assert!((z + 20.0 - 150.0 * 0.038).abs() < 0.04, "a gap of {}", z + 20.0);
}

#[test]
fn pro_height_prop_y() {
    let run = over(Sheet::flat(-20.0)).with(|machine| machine.height.y_set_point = 170);
    let up = run.job(|j| *j = job([line(1, (0.0, 0.0), (0.0, 100.0))])).run();
    let (_, z, _) = *readings(&up).last().expect("readings");
    assert!((z + 20.0 - 170.0 * 0.038).abs() < 0.04, "a gap of {}", z + 20.0);
}

#[test]
fn pro_height_thru_only() {
    let deep = |depth: Depth| {
        let run = over(rising(0.03)).job(|job| {
            let mut shapes = job.shapes.to_vec();
            shapes[0].depth = depth;
            job.shapes = shapes.into();
        });
        readings(&run.run()).len()
    };
    assert!(deep(Depth::Thru) > 100);
    assert_eq!(deep(Depth::Mm { depth_mm: -3.0, pass_mm: None }), 0);
    assert_eq!(deep(Depth::ThreeD), 0);
}

#[test]
fn pro_height_top_track() {
    // 3 mm up along the line: the tool rises to −7 behind it.
    let trace = over(rising(0.03)).run();
    let top = trace.rests()[2];
    assert!((top + 7.0).abs() < 0.1, "ZTop is {top}");
}

#[test]
fn pro_zpos_surface_hc() {
    pro_height_top_track();
    pro_height_local_engrave();
}

#[test]
fn pro_height_local_engrave() {
    let run = over(rising(0.03)).job(|job| {
        let mut second = line(2, (100.0, 0.0), (100.0, 10.0));
        second.depth = Depth::Mm { depth_mm: 3.0, pass_mm: None };
        job.shapes = [job.shapes[0].clone(), second].into();
    });
    let moves = run.run().moves();
    let depth = moves[moves.len() - 4].rsplit_once('z').and_then(|(_, z)| z.parse::<f64>().ok());
    assert!((depth.expect("a plunge") + 14.0).abs() < 0.1, "{moves:?}");
}

#[test]
fn pro_height_maxspeed() {
    let sheet = Sheet { step: Some([50.0, 10.0]), ..Sheet::flat(-20.0) };
    let all = readings(&over(sheet).run());
    let speeds = all.windows(2).map(|pair| (pair[1].1 - pair[0].1) / (pair[1].0 - pair[0].0));
    let peak = speeds.fold(0.0, f64::max);
    assert!((29.0..30.001).contains(&peak), "{peak} mm/s");
}

#[test]
fn pro_height_activation() {
    let z_moved = |percent: f64| {
        let run = over(rising(0.05)).with(|machine| machine.height.activation_percent = percent);
        // A slow group: half of the machine's speed is its own.
        let all = readings(&run.run());
        let begin = all[0].0;
        let early = all.iter().filter(|(t, ..)| *t < begin + 0.045);
        early.map(|(_, z, _)| (z - all[0].1).abs()).fold(0.0, f64::max)
    };
    assert!(z_moved(0.0) > 0.05 && z_moved(50.0) < 1e-9);
}

#[test]
fn pro_misc_height_on() {
    let off = over(rising(0.05)).with(|machine| machine.height.on = false).run();
    assert!(readings(&off).is_empty() && off.moves().contains(&"2.800-3.840 z-30".into()));
}

#[test]
fn pro_height_simple_high() {
    let simple = JobRun::new(t1()).with(|machine| machine.height.on = true);
    let lowered = simple.input(Input::ZHigh, 0.1, true).input(Input::ZHigh, 3.3, false);
    let pulsed = lowered.input(Input::ZHigh, 4.7, true).input(Input::ZHigh, 4.8, false).run();
    let raised = pulsed.rests()[2];
    // 0.1 s at 30 mm/s with 400 mm/s²: 1.875 mm down, 1.125 mm to stop; the plunge ran 0.4 mm below
    // the place at which it was told to stop, and the inputs left it there.
    assert!((raised + 10.0 + 3.4).abs() < 0.05, "{raised}");
}

#[test]
fn pro_height_simple_hw() {
    pro_height_simple_high();
}
