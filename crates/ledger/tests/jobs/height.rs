//! Area `height`: Z follows a warped sheet, closed loop on the simulated machine.

use kerf_ledger::jobs::{JobRun, JobTrace, job, line, t1};
use kerf_machine::lines::Input;
use kerf_machine::settings::height::HeightMode;
use kerf_program::job::{CutDepth, JobShape};
use kerf_sim::Sheet;
use kerf_trace::Event;

/// JOB-T1 with proportional height control over a sheet.
fn over(sheet: Sheet) -> JobRun {
    JobRun::new(t1())
        .with(|machine| {
            (machine.height.on, machine.height.mode) = (true, HeightMode::Proportional);
            machine.height.k = 9.5;
        })
        .sheet(sheet)
}

/// The set point's gap, mm: 150 units of 0.038 mm.
const GAP_MM: f64 = 5.7;

/// A sheet that rises along X, and over which the tool begins at ZSurface.
fn rising(slope_x: f64) -> Sheet {
    Sheet { slope_x, ..Sheet::flat(-20.0 - GAP_MM) }
}

/// Times, heights and errors of the readings, mm.
fn readings(trace: &JobTrace) -> Vec<(f64, f64, f64)> {
    let told = trace.events.iter().filter_map(|event| match event {
        Event::Height { z, error, t, .. } => Some((*t, *z, *error)),
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
    let setting = kerf_machine::table::setting("height.x_set_point").expect("the setting");
    let mut machine = kerf_machine::Configuration::default();
    let mut set = |value| setting.set(&mut machine, &kerf_machine::Value::Number(value));
    assert!(set(255.0).is_ok() && set(256.0).is_err());
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
    let deep = |height: CutDepth| {
        let run = over(rising(0.03)).job(|job| {
            let mut shapes = job.shapes.to_vec();
            shapes[0].height = height;
            job.shapes = shapes.into();
        });
        readings(&run.run()).len()
    };
    assert!(deep(CutDepth::Thru) > 100);
    assert_eq!(deep(CutDepth::Mm(-3.0)), 0);
    assert_eq!(deep(CutDepth::ThreeD), 0);
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
        second.height = CutDepth::Mm(3.0);
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
        let run = over(rising(0.2)).with(|machine| machine.height.activation_percent = percent);
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
    // Told to stop at -19.6 mm the plunge runs on to -20 mm. 0.1 s at 30 mm/s with 400 mm/s²: 1.875 mm down,
    // 1.125 mm to stop. ZTop is 10 mm above.
    assert!((raised - (-20.0 - 3.0 + 10.0)).abs() < 0.05, "{raised}");
}

#[test]
fn pro_height_simple_hw() {
    pro_height_simple_high();
}

/// ZSurface and ZTop as they are told with the readings.
fn surfaces(trace: &JobTrace) -> Vec<(f64, f64)> {
    let told = trace.events.iter().filter_map(|event| match event {
        Event::Height { surface, top, .. } => Some((*surface, *top)),
        _ => None,
    });
    told.collect()
}

/// Top, surface and bottom as they are told when they change.
fn heights(trace: &JobTrace) -> Vec<[f64; 3]> {
    let told = trace.events.iter().filter_map(|event| match event {
        Event::Heights { top, surface, bottom, .. } => Some([*top, *surface, *bottom]),
        _ => None,
    });
    told.collect()
}

/// JOB-T1 with simple height control, lowered to the height at which the input says so.
fn simple() -> JobRun {
    let run = JobRun::new(t1()).with(|machine| machine.height.on = true);
    run.input(Input::ZHigh, 0.1, true).input(Input::ZHigh, 3.3, false)
}

#[test]
fn pro_height_two_types() {
    let follows = |on: bool, mode: HeightMode| {
        let run = simple().sheet(rising(0.03)).with(|machine| {
            (machine.height.on, machine.height.mode) = (on, mode);
        });
        let trace = run.input(Input::ZLow, 5.0, true).input(Input::ZLow, 5.1, false).run();
        (readings(&trace).len() > 100, trace.rests()[2])
    };
    assert_eq!(follows(false, HeightMode::Simple), (false, -10.0));
    let (reads, top) = follows(true, HeightMode::Simple);
    assert!(!reads && top > -8.0 && top < -6.0, "the input carries it up: {top}");
    let (reads, top) = follows(true, HeightMode::Proportional);
    assert!(reads && (top + 7.0).abs() < 0.1, "readings carry it with the sheet: {top}");
}

#[test]
fn pro_height_surf_track() {
    // ZSurface was set 20 mm down; where it goes on is where the tool cuts, not that and how far the sheet rises.
    for (sheet_mm, first_mm) in [(-20.0 - GAP_MM, -20.0), (-22.0, -16.3), (-28.0, -22.3)] {
        let trace = over(Sheet { slope_x: 0.03, ..Sheet::flat(sheet_mm) }).run();
        let told = surfaces(&trace);
        let (first, last) = (told[0].0, told[told.len() - 1].0);
        assert!((first - first_mm).abs() < 0.1, "a sheet at {sheet_mm}: {first}");
        assert!((last - first_mm - 3.0).abs() < 0.1, "a sheet at {sheet_mm}: up to {last}");
        assert!(told.windows(2).all(|pair| pair[1].0 - pair[0].0 < 0.1));
        let cuts = readings(&trace).into_iter().zip(&told);
        assert!(cuts.into_iter().all(|((_, z, _), (surface, _))| z == *surface));
        let begins = heights(&trace)[1];
        assert!((begins[1] - first_mm).abs() < 0.1, "told before the first reading: {begins:?}");
    }
    let deep = |height: CutDepth| {
        let run = over(rising(0.03)).job(|job| {
            let mut shapes = job.shapes.to_vec();
            shapes[0].height = height;
            job.shapes = shapes.into();
        });
        heights(&run.run())
    };
    for height in [CutDepth::Mm(-3.0), CutDepth::ThreeD] {
        assert!(deep(height).iter().all(|told| *told == [-10.0, -20.0, -30.0]));
    }
}

#[test]
fn pro_height_surf_track__stays_over_a_tool_at_the_bottom() {
    // The sheet lies below what the head may go down to: the tool is not where it is to cut.
    let trace = over(Sheet::flat(-40.0)).run();
    assert!(heights(&trace).iter().all(|told| *told == [-10.0, -20.0, -30.0]));
}

#[test]
fn pro_height_top_track__at_every_sample() {
    let told = surfaces(&over(rising(0.03)).run());
    assert!(told.iter().all(|(surface, top)| (top - surface - 10.0).abs() < 1e-9));
}

/// ZTop after a job that was stopped so often and went on each time.
fn top_after(stops: &[f64]) -> f64 {
    let run = stops.iter().fold(over(rising(0.03)), |run, at_s| run.stop(*at_s));
    let trace = run.say(&vec!["continue"; stops.len()].join("\n")).run();
    assert_eq!(trace.states().iter().filter(|state| state.contains("paused")).count(), stops.len());
    trace.rests()[2]
}

#[test]
fn pro_height_surf_track__whatever_stops_the_job() {
    let undisturbed = top_after(&[]);
    assert!((undisturbed + 7.0).abs() < 0.1, "{undisturbed}");
    // On the way down to the sheet; on the path; three times on ways down; path, way down, bottom delay.
    for stops in [&[2.95][..], &[4.9], &[2.95, 5.75, 8.6], &[4.9, 7.8, 11.5]] {
        let top = top_after(stops);
        assert!((top - undisturbed).abs() < 0.1, "{top} after stops at {stops:?}");
    }
}

#[test]
fn pro_height_reset() {
    let whole = heights(&over(rising(0.03)).run());
    assert!(whole.iter().any(|[top, ..]| (top + 7.0).abs() < 0.1), "{whole:?}");
    assert_eq!(whole.last(), Some(&[-10.0, -20.0, -30.0]));
    let aborted = over(rising(0.03)).stop(5.2).run();
    let told = heights(&aborted);
    assert!(told.iter().any(|[_, surface, _]| *surface > -19.0), "{told:?}");
    assert_eq!(told.last(), Some(&[-10.0, -20.0, -30.0]));
}

/// Two lines with a corner between; the input of the head is on so long before and after it.
fn at_a_corner(activation_percent: f64) -> f64 {
    let path = || {
        let corner = [(0.0, 0.0), (100.0, 0.0), (100.0, 100.0)];
        let places = corner.map(|(x, y)| kerf_geom::Point2::new(x, y));
        job([JobShape::through(1, kerf_geom::Polyarc::lines(places, false))])
    };
    let run = |pulse: Option<f64>| {
        let mut run = simple().job(|it| *it = path()).with(|machine| {
            machine.height.activation_percent = activation_percent;
        });
        if let Some(at_s) = pulse {
            run = run.input(Input::ZLow, at_s - 0.02, true).input(Input::ZLow, at_s + 0.02, false);
        }
        run.run()
    };
    let free = run(None);
    let moves = free.moves();
    let corner = moves.iter().find(|it| it.contains(" x100")).expect("the first line");
    let at_s = corner.split([' ', '-']).nth(1).and_then(|t| t.parse().ok()).expect("a time");
    run(Some(at_s)).rests()[2] - free.rests()[2]
}

#[test]
fn pro_height_activation_0() {
    let (always, half) = (at_a_corner(0.0), at_a_corner(50.0));
    // 0.04 s at 400 mm/s²: 0.32 mm, and as much again to come to rest.
    assert!((always - 0.64).abs() < 0.05, "{always}");
    assert_eq!(half, 0.0, "off in a slow corner");
}

#[test]
fn pro_height_activation_0__while_a_knife_turns() {
    let run = |pulse: bool| {
        let mut run = simple().with(|machine| machine.misc.tangential = true).job(|job| {
            let corner = [(0.0, 0.0), (100.0, 0.0), (100.0, 100.0)];
            let places = corner.map(|(x, y)| kerf_geom::Point2::new(x, y));
            job.shapes = [JobShape::through(1, kerf_geom::Polyarc::lines(places, false))].into();
        });
        if pulse {
            run = run.input(Input::ZLow, 5.9, true).input(Input::ZLow, 6.0, false);
        }
        run.run()
    };
    let free = run(false);
    let turns = free.moves().into_iter().find(|it| it.ends_with(" c90")).expect("a turn");
    let (from, to) = turns.split_once(' ').and_then(|(t, _)| t.split_once('-')).expect("times");
    let inside = |t: &str, before: bool| (t.parse::<f64>().expect("a time") < 5.9) == before;
    assert!(inside(from, true) && inside(to, false), "the pulse comes in the turn: {turns}");
    assert!(run(true).rests()[2] - free.rests()[2] > 2.0);
}

#[test]
fn pro_height_between() {
    let run = |between: bool| {
        let two = [line(1, (0.0, 0.0), (100.0, 0.0)), line(2, (200.0, 0.0), (300.0, 0.0))];
        let run = over(rising(0.03)).job(|it| *it = job(two));
        run.with(|machine| machine.height.between = between).run()
    };
    let top_at = |trace: &JobTrace| {
        let moves = trace.moves();
        let link = moves.iter().position(|it| it.contains(" x200")).expect("the link");
        let begin_s: f64 = moves[link].split('-').next().and_then(|t| t.parse().ok()).expect("t");
        let linked: Vec<_> = readings(trace).into_iter().filter(|(t, ..)| *t > begin_s).collect();
        let end_s: f64 = moves[link + 1].split('-').next().and_then(|t| t.parse().ok()).expect("t");
        linked.into_iter().filter(|(t, ..)| *t < end_s).collect::<Vec<_>>()
    };
    assert!(top_at(&run(false)).is_empty());
    let linked = top_at(&run(true));
    let (first, last) = (linked[0].1, linked[linked.len() - 1].1);
    assert!((first + 7.0).abs() < 0.1 && (last + 4.0).abs() < 0.15, "{first} to {last}");
    // The gap to the sheet is that of the cut and the way up, whatever the sheet does.
    let worst = linked.iter().map(|(.., error)| error.abs()).fold(0.0, f64::max);
    assert!(worst < 0.15, "{worst}");
    assert!(!kerf_machine::Configuration::default().height.between);
    let setting = kerf_machine::table::setting("height.between").expect("the setting");
    assert!(setting.doc.contains("Beware of high speeds in X and Y"));
}

#[test]
fn pro_height_simple_low__in_a_job() {
    let raised = |pulse: bool| {
        let run = simple();
        let run = if pulse {
            run.input(Input::ZLow, 4.7, true).input(Input::ZLow, 4.8, false)
        } else {
            run
        };
        run.run().rests()[2]
    };
    // 0.1 s at 400 mm/s² and 30 mm/s: 1.875 mm, 1.125 mm to rest.
    assert!((raised(true) - raised(false) - 3.0).abs() < 0.05, "{}", raised(true));
}

#[test]
fn pro_height_simple_hold() {
    let held = simple().run();
    assert!(heights(&held).windows(2).all(|pair| (pair[1][1] - pair[0][1]).abs() < 0.5));
    assert_eq!(held.states().last().map(|s| s.ends_with("idle")), Some(true));
    let both = simple().input(Input::ZHigh, 4.6, true).input(Input::ZLow, 4.7, true);
    let states = both.run().states();
    assert!(states.iter().any(|s| s.ends_with("paused: height sensors conflict")), "{states:?}");
}

#[test]
fn pro_height_simple_hw__nothing_on_a_line() {
    // No readings come, and nobody misses them.
    let run = simple().input(Input::NoReadings, 0.0, true).run();
    assert!(run.states().iter().all(|state| !state.contains("paused")), "{:?}", run.states());
}

#[test]
fn pro_height_prop_input() {
    let trace = over(rising(0.05)).run();
    for event in &trace.events {
        if let Event::Height { error, reading, .. } = event {
            let gap_mm = 150.0 * 0.038 + error;
            assert_eq!(f64::from(*reading), (gap_mm / 0.038).round(), "a gap of {gap_mm}");
        }
    }
    let cut = |from_s: f64, to_s: f64| {
        let run = over(rising(0.05)).input(Input::NoReadings, from_s, true);
        run.input(Input::NoReadings, to_s, false).run().states()
    };
    let lost = cut(4.6, 9.0);
    assert!(lost.iter().any(|state| state.ends_with("paused: no height readings")), "{lost:?}");
    let short = cut(4.6, 4.69);
    assert!(short.iter().all(|state| !state.contains("paused")), "{short:?}");
}

#[test]
fn pro_height_prop_input__stops_a_tenth_of_a_second_later() {
    let run = over(Sheet::flat(-20.0)).input(Input::NoReadings, 4.6, true).run();
    let cut = run.moves().into_iter().find(|it| it.contains(" x")).expect("the cut");
    let end_s: f64 = cut.split([' ', '-']).nth(1).and_then(|t| t.parse().ok()).expect("a time");
    // 0.1 s without a reading, 0.1 s to slow down from 100 mm/s.
    assert!((end_s - 4.8).abs() < 0.003, "{cut}");
}

#[test]
fn pro_height_prop_baud() {
    assert_eq!(kerf_machine::Configuration::default().height.baud, 9600);
    let all = readings(&over(rising(0.01)).run());
    let byte_s = (all[all.len() - 1].0 - all[0].0) / (all.len() - 1) as f64;
    assert!((byte_s - 10.0 / 9600.0).abs() < 1e-5, "a byte takes {byte_s} s");
    let slow = readings(&over(rising(0.01)).with(|machine| machine.height.baud = 2400).run());
    assert!((slow[1].0 - slow[0].0 - 10.0 / 2400.0).abs() < 1e-3);
}

#[test]
fn pro_height_prop_display() {
    let sheet = Sheet { step: Some([50.0, 1.0]), ..Sheet::flat(-20.0) };
    let trace = over(sheet).run();
    let flagged: Vec<_> = trace
        .events
        .iter()
        .filter_map(|event| match event {
            Event::Height { error, off, .. } => Some((error.abs(), *off)),
            _ => None,
        })
        .collect();
    assert!(flagged.iter().all(|(error, off)| *off == (*error > 0.1)));
    assert!(flagged.iter().any(|(_, off)| *off) && flagged.iter().any(|(_, off)| !*off));
}

#[test]
fn pro_height_nonhomog() {
    let run = over(Sheet::flat(-20.0)).with(|machine| {
        machine.program.smoothing.y_factor = 0.8;
        (machine.height.x_set_point, machine.height.y_set_point) = (150, 170);
    });
    let trace = run.job(|it| *it = job([line(1, (0.0, 0.0), (80.0, 80.0))])).run();
    assert_eq!(trace.cutting_speeds(), [90.0], "5400 mm/min");
    let (_, z, _) = *readings(&trace).last().expect("readings");
    assert!((z + 20.0 - 160.0 * 0.038).abs() < 0.04, "a gap of {}", z + 20.0);
}

#[test]
fn pro_height_prop_scale__in_a_pause() {
    let gap = |words: &str| {
        let run = over(Sheet::flat(-20.0)).stop(4.8).say(&format!("{words}resume"));
        let (_, z, _) = *readings(&run.run()).last().expect("readings");
        z + 20.0
    };
    // Ten units of 0.038 mm.
    assert!((gap("height 0.38 \u{23ce} ") - gap("") - 0.38).abs() < 0.04);
}

/// JOB-T1 with height control over no sheet at all.
fn over_nothing(mode: HeightMode) -> JobRun {
    JobRun::new(t1()).with(|machine| (machine.height.on, machine.height.mode) = (true, mode))
}

#[test]
fn nothing_is_cut_in_the_air_where_no_sheet_is_sensed() {
    for (mode, why) in [
        (HeightMode::Proportional, "paused: no height readings"),
        (HeightMode::Simple, "paused: no height readings: zhigh is off at Z top"),
    ] {
        let trace = over_nothing(mode).say("resume ⏎ abort").run();
        let states = trace.states();
        let paused = states.iter().filter(|state| state.ends_with(why)).count();
        assert_eq!(paused, 2, "whoever goes on is asked again: {states:?}");
        let cuts = trace.edges().into_iter().filter(|edge| edge.contains("cut1")).count();
        assert_eq!((cuts, trace.cutting_speeds().len()), (0, 0), "{:?}", trace.edges());
        assert_eq!(trace.rests(), [0.0, 0.0, -10.0], "the tool is up");
        assert_eq!(trace.summary.status, kerf_program::Status::Stopped);
    }
}

#[test]
fn a_sheet_that_is_missing_is_told_before_anything_moves() {
    let told = |run: JobRun| {
        let trace = run.run();
        let first = |event: &Event| matches!(event, Event::Move(_));
        let moves = trace.events.iter().position(first).expect("moves");
        let before = trace.events[..moves].iter().filter_map(|event| match event {
            Event::Diag(told) => Some(told.message.clone()),
            _ => None,
        });
        before.collect::<Vec<_>>()
    };
    let missing = "height control is on (height.on), and no sheet lies on the simulated table";
    assert_eq!(told(over_nothing(HeightMode::Simple)), [missing]);
    assert_eq!(told(over_nothing(HeightMode::Proportional)), [missing]);
    assert!(told(over(rising(0.01))).is_empty() && told(JobRun::new(t1())).is_empty());
    // A script that moves the switch is a sheet of its own.
    assert!(told(simple()).is_empty());
}

#[test]
fn two_switches_lead_the_head_along_a_sheet() {
    let run = over_nothing(HeightMode::Simple).sheet(rising(0.03));
    let trace = run.run();
    assert!(trace.states().iter().all(|state| !state.contains("paused")), "{:?}", trace.states());
    // 4.3 to 3.7 mm over a sheet that rises by 3 mm to -22.7 mm; up by 10 mm behind it.
    let top = trace.rests()[2];
    assert!((-19.1..-18.3).contains(&(top - 10.0)), "{top}");
}
