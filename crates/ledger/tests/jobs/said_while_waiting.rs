//! Requests to a job while it waits: impossible ones are refused, and nothing is passed over in silence.

use kerf_ledger::jobs::{JobRun, JobTrace, t1, t2};
use kerf_program::Status;

/// JOB-T2, stopped at 5.340 s, where x is 45.
fn stopped(say: &str) -> JobTrace {
    JobRun::new(t2()).stop(5.34).say(say).run()
}

/// The heights at which THRU shapes are cut.
fn depths(trace: &JobTrace) -> Vec<String> {
    let ends = trace.moves();
    ends.iter().filter_map(|m| m.split_once(" z").map(|(_, z)| z.to_owned())).collect()
}

#[test]
fn pro_pause_adjust_zb__no_higher_than_the_sheet_and_no_lower_than_z_goes() {
    for (words, why) in [
        (
            "zbottom 20",
            "ZBottom would be at -10.000 mm, above ZSurface at -20.000 mm: it stays at -30.000 mm",
        ),
        (
            "zbottom -130",
            "ZBottom would be at -160.000 mm, Z ends at -150.000 mm: it stays at -30.000 mm",
        ),
    ] {
        let trace = stopped(&format!("{words} ⏎ zbottom -0.5 ⏎ resume"));
        assert!(trace.messages().iter().any(|told| told == why), "{:?}", trace.messages());
        assert_eq!(trace.summary.status, Status::Ok);
        assert_eq!(depths(&trace), ["-10", "-30", "-10", "-30.5", "-10", "-30.5", "-10"]);
    }
    // As far as it goes.
    for (words, z) in [("zbottom 10", "-20"), ("zbottom -120", "-150")] {
        let trace = stopped(&format!("{words} ⏎ resume"));
        assert_eq!(depths(&trace)[3], z, "{words}");
    }
}

/// The job did not go on, and everything is off.
fn safe(trace: &JobTrace, why: &str) {
    assert_eq!(trace.summary.status, Status::Failed);
    assert!(trace.refused().starts_with(why), "{}", trace.refused());
    let mut on = Vec::new();
    for edge in trace.edges() {
        let (_, line) = edge.split_once(' ').expect("a line");
        match line.strip_suffix('+') {
            Some(line) => on.push(line.to_owned()),
            None => on.retain(|it| Some(it.as_str()) != line.strip_suffix('-')),
        }
    }
    assert_eq!(on, [""; 0], "{:?}", trace.edges());
}

#[test]
fn an_answer_that_fits_nothing_ends_the_job_and_is_told() {
    for wrong in ["cut 0", "resume now", "0", ""] {
        let trace = stopped(&format!("cut 3000 ⏎ {wrong} ⏎ resume"));
        safe(&trace, &format!("line 2 of the answers: '{wrong}' tells a job that waits nothing"));
        assert_eq!(trace.moves().last().map(String::as_str), Some("5.440-5.940 z-10"));
    }
    let low = JobRun::new(t2()).with(|machine| machine.pause.raise = false);
    safe(&low.stop(5.34).say("up").run(), "line 1 of the answers: 'up' tells a job");
}

#[test]
fn a_job_that_would_begin_with_another_shape_than_it_is_told_does_not() {
    let twice = |say: &str| {
        let run = JobRun::new(t2()).with(|machine| machine.misc.double_start = true);
        run.say(say).run()
    };
    let wrong = twice("0 ⏎ start");
    safe(&wrong, "line 1 of the answers: '0' tells a job that waits nothing");
    assert!(wrong.moves().is_empty(), "{:?}", wrong.moves());
    let beyond = twice("7 ⏎ 2 ⏎ start");
    assert_eq!(beyond.messages(), ["the job has 2 shapes"]);
    assert!(!beyond.moves().iter().any(|it| it.ends_with(" x100 y0")), "{:?}", beyond.moves());
    // What may be said in a pause may be said before.
    assert_eq!(twice("cut 3000 ⏎ start").cutting_speeds(), [50.0, 50.0]);
    assert_eq!(
        stopped("2 ⏎ resume").messages(),
        ["the shape to begin with is chosen before the job starts"]
    );
}

#[test]
fn pro_pause_resume_pos__of_a_tool_that_is_not_raised() {
    let back = ["z-10", "x50", "z-30", "x100"];
    for raise in [("move x 30 ⏎ resume", false), ("raise no ⏎ move x 30 ⏎ resume", true)] {
        let (say, raises) = raise;
        let run = JobRun::new(t1()).with(|machine| machine.pause.raise = raises);
        let trace = run.stop(5.34).say(say).run();
        let moves = trace.moves();
        let ends: Vec<&str> = moves.iter().filter_map(|it| Some(it.split_once(' ')?.1)).collect();
        let moved = ends.iter().position(|end| *end == "x80").expect("moved by hand");
        let after = &ends[moved + 1..];
        let at_top = if raises { &back[1..] } else { &back[..] };
        assert_eq!(&after[..at_top.len()], at_top, "{say}: {moves:?}");
        let down = moves.iter().rfind(|it| it.ends_with(" z-30")).expect("a plunge");
        let begins: f64 = down.split('-').next().and_then(|t| t.parse().ok()).expect("a time");
        let edges = trace.edges();
        let on = edges.iter().rfind(|it| it.ends_with("router+")).expect("the router");
        let on: f64 = on.split(' ').next().and_then(|t| t.parse().ok()).expect("a time");
        assert!(begins >= on + 2.0 - 1e-9, "the router turns before the plunge: {edges:?}");
    }
}

#[test]
fn a_tool_that_was_lowered_by_hand_before_the_first_shape_rises_first() {
    // On the way to the first shape, moved down and away.
    let run = JobRun::new(t1()).job(|job| job.origin = Some(kerf_geom::Point2::new(300.0, 0.0)));
    let trace = run.stop(0.5).say("move z -15 ⏎ move x 30 ⏎ resume").run();
    let moves = trace.moves();
    let ends: Vec<&str> = moves.iter().filter_map(|it| Some(it.split_once(' ')?.1)).collect();
    let lowered = ends.iter().position(|end| end.starts_with("z-")).expect("moved down");
    let travels = ends.iter().skip(lowered + 1).position(|end| *end == "x0").expect("the way");
    assert_eq!(ends[lowered + travels], "z-10", "{moves:?}");
}
