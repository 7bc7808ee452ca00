//! Area `plasma`: feeling the sheet, the arc, and losing it.

use kerf_ledger::jobs::{JobRun, JobTrace, t1};
use kerf_machine::lines::Input;
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
