//! Area `plasma`: feeling the sheet, the arc, and losing it.

use kerf_ledger::jobs::{JobRun, JobTrace, t1};
use kerf_machine::lines::Input;
use kerf_machine::settings::height::HeightMode;
use kerf_sim::Sheet;

/// JOB-T6 without its arc: a plasma torch over a sheet at −20.
fn torch() -> JobRun {
    let run = JobRun::new(t1()).with(|machine| {
        machine.plasma.use_sequence = true;
        machine.plasma.initial_height_mm = 4.0;
        machine.plasma.initial_wait_s = 0.5;
        machine.plasma.debounce_s = 0.3;
        (machine.delays.router_start_s, machine.delays.air_tool_s) = (0.0, 0.0);
    });
    run.sheet(Sheet::flat(-20.0))
}

/// JOB-T6: the arc comes half a second after the cut output.
fn t6() -> JobRun {
    torch().input(Input::EndBottomDelay, 1.62, true)
}

fn has(trace: &JobTrace, events: &[&str]) {
    let all: Vec<String> =
        trace.edges().into_iter().chain(trace.moves()).chain(trace.states()).collect();
    for event in events {
        assert!(all.iter().any(|one| one == event), "{event} is missing in {all:#?}");
    }
}

#[test]
fn pro_timing_plasma() {
    let trace = t6().run();
    assert_eq!(
        trace.edges(),
        [
            "0.000 job_running+",
            "0.300 router+",
            "0.300 tool1+",
            "1.120 cut1+",
            "3.220 cut1-",
            "3.690 tool1-",
            "3.690 router-",
            "4.390 job_running-"
        ]
    );
    assert_eq!(
        trace.moves(),
        [
            "0.000-0.300 z-10",
            "0.300-0.860 z-20.4",
            "0.860-1.120 z-16",
            "2.120-3.220 x100",
            "3.470-3.690 z-10",
            "3.690-4.390 x0"
        ]
    );
}

#[test]
fn pro_plasma_use() {
    pro_timing_plasma();
    let normal = t6().with(|machine| machine.plasma.use_sequence = false).run();
    assert!(normal.moves().contains(&"0.300-1.340 z-30".into()), "{:?}", normal.moves());
}

#[test]
fn pro_plasma_init_height() {
    has(&t6().run(), &["0.300-0.860 z-20.4", "0.860-1.120 z-16"]);
}

#[test]
fn pro_plasma_init_wait() {
    let flickers = t6().input(Input::EndBottomDelay, 1.8, false);
    let flickers = flickers.input(Input::EndBottomDelay, 1.9, true);
    has(&flickers.run(), &["2.120-3.220 x100"]);
    let late = t6().input(Input::EndBottomDelay, 2.0, false);
    let late = late.input(Input::EndBottomDelay, 2.3, true);
    has(&late.run(), &["2.300-3.400 x100"]);
}

#[test]
fn pro_plasma_init_timeout() {
    has(&torch().run(), &["1.120 cut1+", "11.120 cut1-", "11.340 paused: no arc"]);
}

#[test]
fn pro_plasma_debounce() {
    let bounces = t6().input(Input::EndBottomDelay, 2.2, false);
    has(&bounces.input(Input::EndBottomDelay, 2.3, true).run(), &["2.120-3.220 x100"]);
}

#[test]
fn pro_plasma_arc_loss() {
    let lost = t6().input(Input::EndBottomDelay, 2.7, false).run();
    has(&lost, &["2.120-2.800 x58", "2.800 cut1-", "2.800 router-", "3.020 paused: arc lost"]);
    let dead = t6().input(Input::EndBottomDelay, 2.3, false).run();
    has(&dead, &["2.520 cut1-"]);
}

#[test]
fn pro_plasma_tooclose_cut() {
    let close = t6().input(Input::WHome, 2.5, true).run();
    has(&close, &["2.600 cut1-", "2.820 paused: head too close"]);
}

#[test]
fn pro_plasma_not_found() {
    let nothing = torch().sheet(Sheet::flat(-50.0)).run();
    has(&nothing, &["0.300-1.340 z-30"]);
    assert!(!nothing.edges().iter().any(|edge| edge.contains("cut1+")));
    assert!(nothing.states().iter().any(|state| state.ends_with("paused: surface not found")));
}

#[test]
fn pro_plasma_resume() {
    let lost = t6().input(Input::EndBottomDelay, 2.7, false);
    let again = lost.input(Input::EndBottomDelay, 5.0, true).say("resume").run();
    let moves: Vec<String> =
        again.moves().iter().map(|m| m.split_once(' ').map_or("", |(_, end)| end).into()).collect();
    assert_eq!(moves[3..9], ["x58", "z-10", "z-20.4", "z-16", "x100", "z-10"]);
}

#[test]
fn pro_misc_plasma_on() {
    // Never looks at A1.
    let ignored = JobRun::new(t1()).input(Input::WHome, 5.0, true).run();
    has(&ignored, &["4.840-5.940 x100"]);
    pro_timing_plasma();
}

#[test]
fn pro_plasma_use__never_looks_at_the_sensor_without() {
    let normal = t6().with(|machine| machine.plasma.use_sequence = false).run();
    assert_eq!(normal.edges()[..2], ["0.000 job_running+", "0.300 router+"]);
    assert!(normal.moves().iter().all(|made| !made.contains("z-16")), "{:?}", normal.moves());
}

#[test]
fn pro_plasma_tooclose_input() {
    // The sensor is on while Z is at the sheet or below it.
    let changes: Vec<String> = t6()
        .run()
        .events
        .iter()
        .filter_map(|event| match event {
            kerf_trace::Event::Input { name: Some("whome"), on, t, .. } => {
                Some(format!("{t:.3} {on}"))
            }
            _ => None,
        })
        .collect();
    // Down through -20 at 20 mm/s, 0.4 mm further, and up through it again.
    assert_eq!(changes[0], "0.820 true");
    assert!(changes.len() == 2 && changes[1].ends_with("false"), "{changes:?}");
    let bit = t6().signals().on("whome");
    assert_eq!(bit[0].0, 820, "port A bit 1");
}

/// A torch with proportional height control.
fn controlled(sheet: Sheet) -> JobRun {
    t6().sheet(sheet).with(|machine| {
        (machine.height.on, machine.height.mode) = (true, HeightMode::Proportional);
        machine.height.k = 9.5;
        // The set point is the initial height.
        (machine.height.x_set_point, machine.height.y_set_point) = (105, 105);
    })
}

/// Times and heights of the readings.
fn readings(trace: &JobTrace) -> Vec<(f64, f64)> {
    let told = trace.events.iter().filter_map(|event| match event {
        kerf_trace::Event::Height { z, t, .. } => Some((*t, *z)),
        _ => None,
    });
    told.collect()
}

#[test]
fn pro_plasma_z_zero() {
    let trace = controlled(Sheet { slope_x: 0.25, ..Sheet::flat(-20.0) }).run();
    assert!(
        trace.states().iter().any(|state| state.ends_with("paused: z at 0")),
        "{:?}",
        trace.states()
    );
    let all = readings(&trace);
    let highest = all.iter().map(|(_, z)| *z).fold(f64::NEG_INFINITY, f64::max);
    assert!((-0.05..=0.0).contains(&highest), "{highest}");
    assert!(trace.rests()[2] <= 0.0 && trace.rests()[0] < 90.0, "{:?}", trace.rests());
    // The torch is out when it pauses, and stays out.
    let moment = |told: &str| told.split(' ').next().unwrap().parse::<f64>().unwrap();
    let torch: Vec<String> =
        trace.edges().into_iter().filter(|edge| edge.contains("cut1")).collect();
    let out = torch.last().filter(|edge| edge.ends_with("cut1-")).expect("it burned");
    let states = trace.states();
    let paused = states.iter().find(|state| state.ends_with("paused: z at 0")).unwrap();
    assert!(moment(out) <= moment(paused), "{torch:?} {states:?}");
}

#[test]
fn pro_plasma_heightctl() {
    let run = controlled(Sheet { slope_x: 0.2, ..Sheet::flat(-20.0) });
    let trace = run.with(|machine| machine.height.activation_percent = 80.0).run();
    let all = readings(&trace);
    let begin_s = all[0].0;
    // 80 mm/s are reached after 0.08 s: until then Z is where the sheet was felt, 4 mm above it.
    let early: Vec<_> = all.iter().filter(|(t, _)| *t < begin_s + 0.079).collect();
    assert!(early.iter().all(|(_, z)| (z + 16.0).abs() < 1e-6), "{early:?}");
    let later = all.iter().find(|(t, _)| *t > begin_s + 0.5).expect("a reading");
    assert!(later.1 > -12.0, "{later:?}");
}
