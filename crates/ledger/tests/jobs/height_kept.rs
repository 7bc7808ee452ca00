//! Area `height`: however many shapes are cut and however often a job stops, ZSurface and ZTop lie where the
//! sheet has them.

use kerf_ledger::jobs::{JobRun, JobTrace, job, line};
use kerf_machine::lines::Input;
use kerf_machine::settings::height::HeightMode;
use kerf_sim::Sheet;
use kerf_trace::Event;

/// Accuracy of proportional height control, mm.
const ACCURACY_MM: f64 = 0.1;

/// Lines along X, ten millimetres apart, every other one backwards.
fn lines(count: u32) -> JobRun {
    let ends = |i: u32| if i.is_multiple_of(2) { (0.0, 60.0) } else { (60.0, 0.0) };
    let shape = |i: u32| {
        let ((from, to), y) = (ends(i), f64::from(i) * 10.0);
        line(i + 1, (from, y), (to, y))
    };
    JobRun::new(job((0..count).map(shape))).with(|machine| {
        (machine.height.on, machine.height.mode) = (true, HeightMode::Proportional);
        machine.height.k = 9.5;
    })
}

/// The same with a plasma torch that starts so far above the sheet.
fn torch(count: u32, initial_mm: f64) -> JobRun {
    let run = lines(count).input(Input::EndBottomDelay, 0.0, true).with(|machine| {
        machine.plasma.use_sequence = true;
        machine.plasma.initial_height_mm = initial_mm;
        machine.height.activation_percent = 80.0;
    });
    run.sheet(Sheet::flat(-20.0))
}

/// Every ZTop and ZSurface that was told, between shapes and with the readings.
fn told(trace: &JobTrace) -> Vec<[f64; 2]> {
    let told = trace.events.iter().filter_map(|event| match event {
        Event::Heights { top, surface, .. } | Event::Height { top, surface, .. } => {
            Some([*top, *surface])
        }
        _ => None,
    });
    told.collect()
}

/// Lowest and highest ZSurface that was told behind the beginning, with ZTop ten millimetres above it, mm.
fn surfaces(trace: &JobTrace) -> [f64; 2] {
    assert_eq!(trace.refused(), "");
    let all = told(trace);
    assert!(all.len() > 40, "heights are told");
    assert!(all.iter().all(|[top, surface]| (top - surface - 10.0).abs() < 1e-9));
    // As they were set, at the beginning and the end.
    let [begin, controlled @ .., end] = &all[..] else { unreachable!("more than forty") };
    assert_eq!([begin, end], [&[-10.0, -20.0]; 2]);
    let surfaces = || controlled.iter().map(|[_, surface]| *surface);
    [surfaces().fold(f64::INFINITY, f64::min), surfaces().fold(f64::NEG_INFINITY, f64::max)]
}

/// ZSurface stays between two heights, as exactly as height control is.
fn keeps(run: JobRun, low_mm: f64, high_mm: f64) {
    let [low, high] = surfaces(&run.run());
    let within = low_mm - ACCURACY_MM < low && high < high_mm + ACCURACY_MM;
    assert!(within, "{low} to {high}, not {low_mm} to {high_mm}");
}

#[test]
fn pro_height_surf_track__flat_for_forty_shapes() {
    for at_mm in [-20.0, -22.0] {
        let cuts_mm = at_mm + 150.0 * 0.038;
        keeps(lines(40).sheet(Sheet::flat(at_mm)), cuts_mm, cuts_mm);
    }
}

#[test]
fn pro_height_surf_track__flat_under_a_torch() {
    // From the initial height, below and above the height that the readings ask for, 5.7 mm, to that.
    keeps(torch(40, 4.0), -16.0, -14.3);
    keeps(torch(40, 8.0), -14.3, -12.0);
    // Never fast enough for height control to act.
    let slow =
        torch(10, 4.0).with(|machine| machine.program.smoothing.cut_speed_mm_s = Some(100.0));
    let slow = slow.job(|job| {
        let mut shapes = job.shapes.to_vec();
        shapes.iter_mut().skip(1).step_by(2).for_each(|shape| shape.speed_mm_s = Some(1.0));
        job.shapes = shapes.into();
    });
    keeps(slow, -16.0, -14.3);
}

#[test]
fn pro_height_surf_track__with_a_set_point_for_each_axis() {
    let across = |i: u32| line(i + 1, (f64::from(i) * 10.0, 0.0), (f64::from(i) * 10.0, 60.0));
    for between in [false, true] {
        let run = lines(0).sheet(Sheet::flat(-20.0)).with(|machine| {
            machine.height.y_set_point = 170;
            machine.height.between = between;
        });
        let run = run.job(|it| {
            let both = it.shapes.iter().cloned().chain((0..20).map(across));
            it.shapes = both.collect();
        });
        // Along Y 0.76 mm higher than along X, where the plunge ends.
        keeps(run, -14.3, -14.3 + 20.0 * 0.038);
    }
}

#[test]
fn pro_height_surf_track__of_a_slope_for_forty_shapes() {
    let slope = Sheet { slope_x: 0.03, slope_y: 0.01, ..Sheet::flat(-20.0) };
    for run in [lines(40), torch(40, 4.0)] {
        let trace = run.sheet(slope).with(|machine| machine.zpos.bottom_mm = -40.0).run();
        assert_eq!(trace.refused(), "");
        let readings = trace.events.iter().filter_map(|event| match event {
            Event::Height { z, surface, .. } => Some((*z, *surface)),
            _ => None,
        });
        assert!(readings.into_iter().all(|(z, surface)| z == surface), "where the tool cuts");
        let tops = trace.events.iter().filter_map(|event| match event {
            Event::Move(made) if (made.to.y - made.from.y).abs() > 1.0 => Some(made.to),
            _ => None,
        });
        // From the end of a line to the beginning of the next: at ZTop of that end.
        let off = tops.filter(|to| to.y < 399.0 && to.y > 1.0).map(|to| {
            let end_y = to.y - 10.0;
            // 10 mm over a cut that was 5.7 mm over the sheet, as far as Z goes up.
            let sheet = 0.03 * to.x + 0.01 * end_y - 20.0;
            (to.z - (sheet + 5.7 + 10.0).min(0.0)).abs()
        });
        let off = off.fold(0.0, f64::max);
        // The torch is not controlled below 80 % of its speed: 3.2 mm of the slope.
        assert!(off < ACCURACY_MM + 3.2 * 0.03, "the way between paths: {off} mm");
    }
}

#[test]
fn pro_height_surf_track__after_many_stops_on_a_slope() {
    let top_after = |stops: &[f64]| {
        let run = stops.iter().fold(lines(1), |run, at_s| run.stop(*at_s));
        let long = run.job(|it| *it = job([line(1, (0.0, 0.0), (1000.0, 0.0))]));
        let trace = long
            .sheet(Sheet { slope_x: 0.02, ..Sheet::flat(-40.0) })
            .with(|machine| {
                [machine.zpos.top_mm, machine.zpos.surface_mm, machine.zpos.bottom_mm] =
                    [-30.0, -40.0, -50.0];
            })
            .say(&vec!["continue"; stops.len()].join("\n"))
            .run();
        let paused = trace.states().iter().filter(|state| state.contains("paused")).count();
        assert_eq!(paused, stops.len());
        trace.rests()[2]
    };
    let stops: Vec<f64> = (0..8).map(|i| 5.0 + 5.8 * f64::from(i)).collect();
    let (free, stopped) = (top_after(&[]), top_after(&stops));
    assert!((stopped - free).abs() < 0.03, "{free} without a stop, {stopped} with {}", stops.len());
}
