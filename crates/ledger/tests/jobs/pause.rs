//! Area `pause`: stopping in the middle of a job, what may be done then, and coming back.

use kerf_ledger::jobs::{JobRun, JobTrace, drawn, t1, t2};
use kerf_machine::lines::Input;
use kerf_program::Status;

/// JOB-T1, stopped at 5.340 s, where x is 45.
fn stopped(say: &str) -> JobTrace {
    JobRun::new(t1()).stop(5.34).say(say).run()
}

fn not_raised(say: &str) -> JobTrace {
    JobRun::new(t1()).with(|machine| machine.pause.raise = false).stop(5.34).say(say).run()
}

/// Lines that are told after a moment, seconds.
fn after(told: Vec<String>, from_s: f64) -> Vec<String> {
    let time = |text: &String| text.split([' ', '-']).next().and_then(|t| t.parse::<f64>().ok());
    told.into_iter().filter(|text| time(text).is_some_and(|t| t >= from_s)).collect()
}

#[test]
fn pro_pause_stopkey() {
    assert!(stopped("").moves().contains(&"4.840-5.440 x50".into()));
    // In a rapid, in a delay, in a plunge.
    let rapid = JobRun::new(t1()).stop(0.15).say("").run();
    assert_eq!(rapid.moves()[0], "0.000-0.250 z-7.5");
    let delay = JobRun::new(t1()).stop(1.0).say("").run();
    assert_eq!(after(delay.edges(), 0.9), ["1.000 router-", "1.000 job_running-"]);
    let plunge = JobRun::new(t1()).stop(3.0).say("").run();
    assert_eq!(plunge.moves()[1], "2.800-3.040 z-14");
}

#[test]
fn pro_pause_stopinput() {
    let trace = JobRun::new(t1()).input(Input::EmergencyStop, 5.34, true).run();
    assert!(trace.moves().contains(&"4.840-5.440 x50".into()));
    assert_eq!(
        after(trace.edges(), 5.0),
        ["5.340 cut1-", "5.440 tool1-", "5.440 router-", "5.440 job_running-"]
    );
    assert_eq!(after(trace.states(), 1.0)[0], "5.940 estop: emergency stop");
}

#[test]
fn pro_pause_decel() {
    assert!(stopped("").moves().contains(&"4.840-5.440 x50".into()));
}

#[test]
fn pro_pause_decel__on_an_arc_without_losing_a_step() {
    let circle = || JobRun::new(drawn("circle 150,150 100"));
    for at_s in [5.2, 5.9, 7.1] {
        let trace = circle().stop(at_s).say("abort").run();
        let [x, y, _] = trace.rests();
        let radius = (x - 150.0).hypot(y - 150.0);
        assert!((radius - 100.0).abs() < 1e-3, "{at_s}: {x},{y} is {radius} from the centre");
        // Where the steps brought it, 250 a millimetre.
        let signals = circle().stop(at_s).say("abort").signals();
        for (name, told) in [("x_pos", x), ("y_pos", y)] {
            let (_, bits) = signals.changes(name).pop().expect("steps");
            let steps = i64::from_str_radix(&bits[1..], 2).expect("a number") as f64;
            assert!((steps / 250.0 - told).abs() <= 0.004, "{at_s}: {steps} steps and {told}");
        }
        let whole = circle().stop(at_s).say("resume").run();
        assert_eq!(whole.rests(), circle().run().rests());
    }
}

#[test]
fn pro_pause_raise_yes() {
    assert_eq!(after(stopped("").moves(), 5.0), ["5.440-5.940 z-10"]);
}

#[test]
fn pro_pause_raise_no() {
    assert_eq!(after(not_raised("").moves(), 5.0), [""; 0]);
    assert_eq!(not_raised("").rests(), [50.0, 0.0, -30.0]);
}

#[test]
fn pro_pause_outputs() {
    let edges = after(stopped("resume").edges(), 5.0);
    assert_eq!(edges[..4], ["5.440 cut1-", "5.440 router-", "5.940 tool1-", "5.940 router+"]);
    let edges = after(not_raised("resume").edges(), 5.0);
    assert_eq!(edges[..4], ["5.440 cut1-", "5.440 router-", "5.440 router+", "7.440 cut1+"]);
}

#[test]
fn pro_pause_change_cut() {
    let moves = stopped("cut 3000 ⏎ resume").moves();
    assert!(moves.contains(&"10.480-11.530 x100".into()), "{moves:?}");
}

#[test]
fn pro_pause_change_plunge() {
    let moves = stopped("plunge 600 ⏎ resume").moves();
    assert!(moves.contains(&"8.440-10.460 z-30".into()), "{moves:?}");
}

#[test]
fn pro_pause_adjust_zb() {
    let deeper = JobRun::new(t2()).stop(5.34).say("zbottom -0.5 ⏎ resume").run();
    let depths = |trace: &JobTrace| {
        let moves = trace.moves();
        moves
            .iter()
            .filter_map(|m| m.split_once(" z").map(|(_, z)| z.to_owned()))
            .collect::<Vec<_>>()
    };
    assert_eq!(depths(&deeper), ["-10", "-30", "-10", "-30.5", "-10", "-30.5", "-10"]);
    let higher = JobRun::new(t1()).stop(5.34).say("zbottom 0.5 ⏎ resume").run();
    assert_eq!(depths(&higher), ["-10", "-30", "-10", "-29.5", "-10"]);
}

#[test]
fn pro_pause_continue() {
    let trace = stopped("resume");
    assert_eq!(
        after(trace.edges(), 5.9),
        [
            "5.940 tool1-",
            "5.940 router+",
            "7.940 tool1+",
            "9.480 cut1+",
            "11.080 cut1-",
            "11.830 tool1-",
            "12.330 router-",
            "13.030 job_running-"
        ]
    );
    assert_eq!(after(trace.moves(), 5.9)[..2], ["8.440-9.480 z-30", "10.480-11.080 x100"]);
    assert_eq!(trace.summary.status, Status::Ok);
}

#[test]
fn pro_pause_abort() {
    let trace = stopped("abort");
    assert_eq!(after(trace.edges(), 5.9), ["5.940 tool1-", "5.940 job_running-"]);
    assert_eq!(trace.states().last().map(String::as_str), Some("5.940 idle"));
    assert_eq!((trace.rests(), trace.summary.status), ([50.0, 0.0, -10.0], Status::Stopped));
}

#[test]
fn pro_pause_arrows() {
    let trace = stopped("move y 300 ⏎ move x -60 ⏎ abort");
    let moves = after(trace.moves(), 5.9);
    assert!(moves[0].ends_with(" y300") && moves[1].ends_with(" x0"), "{moves:?}");
    assert!(after(trace.edges(), 5.941).iter().all(|edge| !edge.contains("router")));
}

#[test]
fn pro_pause_resume_pos() {
    let trace = stopped("move y 200 ⏎ resume");
    let moves = after(trace.moves(), 5.9);
    // There and back at ZTop, down, and on from the very place.
    let ends: Vec<_> = moves.iter().map(|m| m.split_once(' ').map_or("", |(_, end)| end)).collect();
    assert_eq!(ends, ["y200", "y0", "z-30", "x100", "z-10", "x0"]);
}

#[test]
fn stops_anywhere_leave_the_same_cut() {
    for n in 1..130 {
        let at = 0.1 * f64::from(n);
        let trace = JobRun::new(t2()).stop(at).say("resume").run();
        assert_eq!(trace.summary.status, Status::Ok, "{at}");
        let cut = trace.summary.tally.cut_mm - 20.0 * 2.0;
        assert!(cut >= 200.0 - 1e-9, "stopped at {at}: {cut} mm");
        assert_eq!(trace.rests(), [0.0, 0.0, -10.0]);
    }
}
