//! Areas `delays`, `speeds` and `zpos`: what the waits, speeds and heights of the machine do to a job.

use kerf_ledger::jobs::{JobRun, JobTrace, drawn, job, line, t1, t2};
use kerf_machine::lines::Input;
use kerf_machine::settings::delays::{BottomDelayType, TimeoutAction};
use kerf_program::job::{CutDepth, Job};

/// Every event of a run that a person would look for.
fn told(trace: &JobTrace) -> Vec<String> {
    trace.edges().into_iter().chain(trace.moves()).chain(trace.states()).collect()
}

/// Checks that a run shows these lines somewhere.
fn shows(run: JobRun, expected: &[&str]) {
    let told = told(&run.run());
    for event in expected {
        assert!(told.iter().any(|one| one == event), "{event} is missing in {told:#?}");
    }
}

fn input_type(bottom_s: f64) -> JobRun {
    JobRun::new(t1()).with(|machine| {
        machine.delays.bottom_type = BottomDelayType::Input;
        machine.delays.bottom_s = bottom_s;
    })
}

fn depths(job: &mut Job, height: CutDepth) {
    job.shapes = job
        .shapes
        .iter()
        .cloned()
        .map(|mut shape| {
            shape.height = height;
            shape
        })
        .collect();
}

#[test]
fn pro_delays_router() {
    shows(JobRun::new(t1()), &["0.300 router+", "2.300 tool1+"]);
    let routers = JobRun::new(t2()).run().edges();
    assert_eq!(routers.iter().filter(|edge| edge.contains("router+")).count(), 1);
}

#[test]
fn pro_delays_router_resume() {
    let edges = JobRun::new(t1()).stop(5.34).say("resume").run().edges();
    let again = edges.iter().position(|edge| edge == "5.940 router+").expect("router again");
    assert_eq!(edges[again + 1], "7.940 tool1+");
}

#[test]
fn pro_delays_air() {
    shows(
        JobRun::new(t1()),
        &["2.300 tool1+", "2.800-3.840 z-30", "6.690 tool1-", "7.190-7.890 x0"],
    );
}

#[test]
fn pro_delays_bottom_type_time() {
    let pulsed = JobRun::new(t1()).input(Input::EndBottomDelay, 4.0, true);
    shows(pulsed, &["3.840 cut1+", "4.840-5.940 x100"]);
}

#[test]
fn pro_delays_bottom_type_input() {
    let pulse = input_type(0.0).input(Input::EndBottomDelay, 4.64, true);
    shows(pulse.input(Input::EndBottomDelay, 4.65, false), &["3.840 cut1+", "4.640-5.740 x100"]);
    // A level that is there when the cut output goes on counts, a pulse that is over does not.
    let level = input_type(0.0).input(Input::EndBottomDelay, 3.0, true);
    shows(level, &["3.840-4.940 x100"]);
    let early = input_type(0.0).input(Input::EndBottomDelay, 3.0, true);
    let early = early.input(Input::EndBottomDelay, 3.5, false);
    shows(early, &["13.840 cut1-"]);
}

#[test]
fn pro_delays_bottom_timeout() {
    shows(input_type(0.2), &["13.840 cut1-", "14.340 paused: no end-of-bottom-delay input"]);
    let on = input_type(0.2).with(|m| m.delays.bottom_timeout = TimeoutAction::Continue);
    shows(on, &["14.040-15.140 x100"]);
}

#[test]
fn pro_delays_bottom_follow() {
    let at = |bottom_s| input_type(bottom_s).input(Input::EndBottomDelay, 4.64, true);
    shows(at(0.2), &["4.840-5.940 x100"]);
    shows(at(0.0), &["4.640-5.740 x100"]);
}

#[test]
fn pro_delays_bottom_use() {
    let point = JobRun::new(job([line(1, (0.0, 0.0), (0.0, 0.0))]));
    shows(point, &["3.840 cut1+", "4.840 cut1-"]);
}

#[test]
fn pro_delays_end() {
    shows(JobRun::new(t1()), &["5.940 cut1-", "6.190-6.690 z-10"]);
}

#[test]
fn pro_delays_end_intensity() {
    let burning = JobRun::new(t1()).with(|machine| {
        machine.intensity.output = true;
        machine.intensity.scale_percent = 60.0;
        machine.delays.end_intensity = 50;
    });
    let shone = burning.run().intensities();
    let end: Vec<_> = shone.iter().filter(|(t, ..)| *t > 5.9399).collect();
    assert_eq!(
        end.iter().map(|(t, value, _)| ((t * 1e3).round(), *value)).collect::<Vec<_>>(),
        [(5940.0, 30), (6190.0, 0)]
    );
    let table = kerf_machine::table::setting("delays.end_intensity").expect("the setting");
    let mut machine = kerf_machine::Configuration::default();
    assert!(table.set(&mut machine, &kerf_machine::Value::Number(128.0)).is_err());
}

#[test]
fn pro_delays_ranges() {
    let mut machine = kerf_machine::Configuration::default();
    for key in ["router_start_s", "air_tool_s", "bottom_s", "end_s", "bottom_timeout_s"] {
        let key = format!("delays.{key}");
        let setting = kerf_machine::table::setting(&key).expect("the setting");
        let mut set = |value| setting.set(&mut machine, &kerf_machine::Value::Number(value));
        assert!(set(-0.1).is_err() && set(0.0).is_ok(), "{key}");
    }
    let none = JobRun::new(t1()).with(|machine| {
        let delays = &mut machine.delays;
        (delays.router_start_s, delays.air_tool_s) = (0.0, 0.0);
        (delays.bottom_s, delays.end_s) = (0.0, 0.001);
    });
    shows(none, &["0.300 tool1+", "0.300-1.340 z-30", "1.340-2.440 x100", "2.441-2.941 z-10"]);
}

#[test]
fn pro_zpos_top() {
    shows(JobRun::new(t2()), &["7.190-7.640 y50", "11.530-12.030 z-10", "12.530-12.980 y0"]);
    assert_eq!(JobRun::new(t2()).run().rests(), [0.0, 0.0, -10.0]);
}

#[test]
fn pro_zpos_surface() {
    let lowered = |surface: f64, height: CutDepth| {
        let run = JobRun::new(t1()).with(|machine| machine.zpos.surface_mm = surface);
        run.job(|job| depths(job, height)).run().moves()[1].clone()
    };
    let mm = CutDepth::Mm(-2.0);
    assert!(lowered(-20.0, mm).ends_with("z-22") && lowered(-21.0, mm).ends_with("z-23"));
    assert!(lowered(-21.0, CutDepth::ThreeD).ends_with("z-21"));
    assert!(lowered(-21.0, CutDepth::Thru).ends_with("z-30"));
}

#[test]
fn pro_zpos_bottom() {
    let at = |bottom: f64, height: CutDepth| {
        let run = JobRun::new(t1()).with(|machine| machine.zpos.bottom_mm = bottom);
        run.job(|job| depths(job, height)).run().moves()[1].clone()
    };
    assert!(
        at(-30.0, CutDepth::Thru).ends_with("z-30") && at(-31.0, CutDepth::Thru).ends_with("z-31")
    );
    let mm = CutDepth::Mm(-5.0);
    assert!(at(-31.0, mm).ends_with("z-25"));
}

#[test]
fn pro_speeds_change() {
    let run = JobRun::new(t1()).stop(5.34).say("cut 3000\nresume").run();
    assert!(run.moves().contains(&"10.480-11.530 x100".into()), "{:?}", run.moves());
}

#[test]
fn pro_speeds_plunge() {
    shows(JobRun::new(t1()), &["2.800-3.840 z-30"]);
}

#[test]
fn pro_speeds_plunge_3d() {
    let deep = JobRun::new(t1()).job(|job| {
        let mut shapes = job.shapes.to_vec();
        shapes[0].height = CutDepth::ThreeD;
        shapes[0].z_mm = [-3.0, -8.0].into();
        job.shapes = shapes.into();
    });
    // 13 mm at 20 mm/s.
    shows(deep, &["2.800-3.490 z-23"]);
    // 40 mm down in 10 mm across, at 50 mm/s of Z and not at 100 mm/s of the way.
    let steep = JobRun::new(job([line(1, (0.0, 0.0), (10.0, 0.0))])).job(|job| {
        let mut shapes = job.shapes.to_vec();
        shapes[0].height = CutDepth::ThreeD;
        shapes[0].z_mm = [-0.0, -40.0].into();
        job.shapes = shapes.into();
    });
    let moves = steep.with(|machine| machine.zpos.bottom_mm = -100.0).run().moves();
    // 0.1 s to 50 mm/s with 500 mm/s², 0.7 s at it, 0.1 s to rest.
    let falls = moves.iter().find(|made| made.ends_with("x10 z-60")).expect("the cut");
    let times: Vec<f64> = falls.split(['-', ' ']).take(2).map(|t| t.parse().unwrap()).collect();
    assert!((times[1] - times[0] - 0.9).abs() < 2e-3, "{falls}");
}

#[test]
fn pro_speeds_yfactor() {
    let along = |x: f64, y: f64| {
        let run = JobRun::new(job([line(1, (0.0, 0.0), (x, y))]));
        run.with(|machine| machine.program.smoothing.y_factor = 0.8).run()
    };
    let speed = |trace: &JobTrace| trace.cutting_speeds()[0];
    assert_eq!(speed(&along(100.0, 0.0)), 100.0);
    assert_eq!(speed(&along(0.0, 100.0)), 80.0);
}

#[test]
fn pro_speeds_yfactor_angle() {
    let speed = |degrees: f64, factor: f64| {
        let (y, x) = degrees.to_radians().sin_cos();
        let run =
            JobRun::new(job([line(1, (300.0, 300.0), (300.0 + 200.0 * x, 300.0 + 200.0 * y))]));
        let run = run.with(|machine| machine.program.smoothing.y_factor = factor).run();
        (run.cutting_speeds()[0] * 60.0).round()
    };
    let at = [0.0, 30.0, 45.0, 60.0, 90.0, 150.0].map(|degrees| speed(degrees, 0.8));
    assert_eq!(at, [6000.0, 5600.0, 5400.0, 5200.0, 4800.0, 5600.0]);
    assert_eq!(speed(60.0, 1.5), 8000.0);
}

#[test]
fn pro_speeds_cut_group() {
    let fast = JobRun::new(t1()).job(|job| {
        let mut shapes = job.shapes.to_vec();
        shapes[0].speed_mm_s = Some(150.0);
        job.shapes = shapes.into();
    });
    let trace = fast.run();
    assert_eq!(trace.cutting_speeds(), [100.0]);
    assert_eq!(trace.warnings(), ["group black: 9000 mm/min is limited to 6000 mm/min"]);
    assert_eq!(JobRun::new(t1()).run().warnings(), Vec::<String>::new());
}

#[test]
fn pro_speeds_units() {
    // Cutting speeds are said in mm/min, those of the machine and of the trace are in mm/s.
    let cut = drawn("line 0,0 100,0; set black speed=6000");
    let run = JobRun::new(cut).with(|machine| machine.program.smoothing.cut_speed_mm_s = None);
    assert_eq!(run.run().cutting_speeds(), [100.0]);
}

#[test]
fn pro_speeds_cut_group__once_for_each_group_and_speed() {
    let fast = |number: u32, y: f64, group: &str, mm_s: f64| {
        let mut shape = line(number, (0.0, y), (100.0, y));
        (shape.group, shape.speed_mm_s) = (group.into(), Some(mm_s));
        shape
    };
    let shapes = || {
        let mut last = fast(4, 30.0, "black", 150.0);
        last.pause = true;
        [
            fast(1, 0.0, "black", 150.0),
            fast(2, 10.0, "black", 150.0),
            fast(3, 20.0, "red", 100.0),
            last,
        ]
    };
    let black = "group black: 9000 mm/min is limited to 6000 mm/min".to_owned();
    let run = JobRun::new(job(shapes())).say("resume").run();
    assert_eq!(run.warnings(), std::slice::from_ref(&black));
    // A lower speed of the machine holds from the pause on.
    let run = JobRun::new(job(shapes())).say("cut 3000\nresume").run();
    assert_eq!(
        run.warnings(),
        [black, "group black: 9000 mm/min is limited to 3000 mm/min".into()]
    );
}
