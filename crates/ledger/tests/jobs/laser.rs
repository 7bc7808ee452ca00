//! Areas `laser` and `intensity`: piercing, gas, intensity by the real speed.

use kerf_control::OperatorRequest;
use kerf_ledger::jobs::{JobRun, job, line, t1};
use kerf_machine::settings::height::HeightMode;
use kerf_machine::settings::laser::LaserType;
use kerf_machine::{Configuration, Value, table};
use kerf_sim::Sheet;

/// JOB-T5: a laser with a pierce sequence.
fn t5() -> JobRun {
    JobRun::new(t1()).with(|machine| {
        machine.zpos.bottom_mm = -20.0;
        machine.delays.air_tool_s = 0.0;
        machine.intensity.output = true;
        machine.intensity.scale_percent = 60.0;
        let laser = &mut machine.laser;
        (laser.use_laser, laser.kind) = (true, Some(LaserType::Pulsed));
        (laser.cut_hz, laser.max_pulse_us) = (5000.0, 1e6);
        let pierce = &mut laser.pierce;
        (pierce.use_sequence, pierce.height_mm, pierce.hz) = (true, 5.0, 500.0);
        (pierce.gas_tool, pierce.gas_wait_ms) = (Some(2), 300.0);
        (pierce.intensity, pierce.time_ms, pierce.purge_ms) = (100, 500.0, 200.0);
        (laser.gas.tool, laser.gas.wait_ms, laser.gas.overrides) = (Some(1), 150.0, true);
    })
}

/// JOB-T1 with the intensity output.
fn shining(scale_percent: f64) -> JobRun {
    JobRun::new(t1()).with(|machine| {
        machine.intensity.output = true;
        machine.intensity.scale_percent = scale_percent;
    })
}

fn refuses(key: &str, values: &[f64]) {
    let setting = table::setting(key).expect("the setting");
    for value in values {
        let mut machine = Configuration::default();
        assert!(setting.set(&mut machine, &Value::Number(*value)).is_err(), "{key} = {value}");
    }
}

/// 0 says that there is none.
fn takes_none(key: &str, one: f64) {
    let setting = table::setting(key).expect("the setting");
    let mut machine = Configuration::default();
    for (value, shown) in [(one, Value::Number(one)), (0.0, Value::none())] {
        setting.set(&mut machine, &Value::Number(value)).expect("a tool or none");
        assert_eq!(setting.get(&machine), shown, "{key} = {value}");
    }
    let refused = setting.set(&mut machine, &Value::Number(4.0)).expect_err("no tool 4");
    assert!(refused.to_string().contains("1 to 3, or 0 for none, not 4"), "{refused}");
}

const T5: [&str; 14] = [
    "0.000 job_running+",
    "0.300 router+",
    "2.590 tool2+",
    "2.890 hz 500",
    "2.890 cut1+",
    "3.390 cut1-",
    "3.680 tool2-",
    "3.680 tool1+",
    "4.030 hz 5000",
    "4.030 cut1+",
    "5.130 cut1-",
    "5.680 tool1-",
    "5.680 router-",
    "6.380 job_running-",
];

/// The same without the pierce sequence.
const PLAIN: [&str; 9] = [
    "0.000 job_running+",
    "0.300 router+",
    "2.300 tool1+",
    "2.840 cut1+",
    "2.840 hz 5000",
    "4.940 cut1-",
    "5.490 tool1-",
    "5.490 router-",
    "6.190 job_running-",
];

#[test]
fn pro_timing_pierce() {
    let trace = t5().run();
    assert_eq!(trace.edges(), T5);
    let moves = ["0.000-0.300 z-10", "2.300-2.590 z-15", "3.390-3.680 z-20", "4.030-5.130 x100"];
    assert_eq!(trace.moves()[..4], moves);
    assert_eq!(trace.moves()[4..], ["5.380-5.680 z-10", "5.680-6.380 x0"]);
}

#[test]
fn pro_laser_pierce_use() {
    assert_eq!(t5().run().edges(), T5);
    let plain = t5().with(|machine| machine.laser.pierce.use_sequence = false).run();
    // The order of every job, with its bottom delay of 1 s.
    assert_eq!(plain.edges(), PLAIN);
    let moves = ["0.000-0.300 z-10", "2.300-2.840 z-20", "3.840-4.940 x100"];
    assert_eq!(plain.moves()[..3], moves);
}

#[test]
fn pro_laser_pierce_freq() {
    let hz: Vec<_> = t5().run().edges().into_iter().filter(|edge| edge.contains("hz")).collect();
    assert_eq!(hz, ["2.890 hz 500", "4.030 hz 5000"]);
    refuses("laser.pierce.hz", &[0.0, -1.0]);
}

#[test]
fn pro_laser_pierce_height() {
    assert!(t5().run().moves().contains(&"2.300-2.590 z-15".into()));
}

#[test]
fn pro_laser_pierce_gasbit() {
    takes_none("laser.pierce.gas_tool", 2.0);
    let none = t5().with(|machine| machine.laser.pierce.gas_tool = None).run();
    assert!(none.edges().contains(&"2.590 cut1+".into()), "{:?}", none.edges());
    assert!(!none.edges().iter().any(|edge| edge.contains("tool2")));
    refuses("laser.pierce.gas_tool", &[4.0]);
}

#[test]
fn pro_laser_pierce_gaswait() {
    assert_eq!(t5().run().edges()[2..5], T5[2..5]);
}

#[test]
fn pro_laser_pierce_int() {
    let shone = t5().run().intensities();
    let pierced: Vec<_> =
        shone.iter().take(2).map(|(t, v, b)| ((t * 1e3).round(), *v, *b)).collect();
    assert_eq!(pierced, [(2890.0, 60, 120), (3390.0, 0, 0)]);
    refuses("laser.pierce.intensity", &[128.0]);
}

#[test]
fn pro_laser_pierce_time() {
    assert_eq!(t5().run().edges()[4..6], T5[4..6]);
    let none = t5().with(|machine| machine.laser.pierce.time_ms = 0.0).run();
    assert_eq!(none.edges().iter().filter(|edge| edge.contains("cut1+")).count(), 1);
}

#[test]
fn pro_laser_pierce_purge() {
    assert!(t5().run().edges().contains(&"4.030 cut1+".into()));
    let none = t5().with(|machine| machine.laser.pierce.gas_tool = None).run();
    // Without pierce gas neither its wait nor the purge: 0.5 s earlier.
    assert!(none.edges().contains(&"3.530 cut1+".into()), "{:?}", none.edges());
}

#[test]
fn pro_laser_cut_freq() {
    assert_eq!(t5().run().edges()[8..10], T5[8..10]);
}

#[test]
fn pro_laser_cut_gasbit() {
    takes_none("laser.gas.tool", 2.0);
    assert_eq!(t5().run().edges()[7], T5[7]);
    let none = t5().with(|machine| machine.laser.gas.tool = None).run();
    assert!(none.edges().contains(&"3.880 cut1+".into()), "{:?}", none.edges());
    refuses("laser.gas.tool", &[4.0]);
}

#[test]
fn pro_laser_cut_gaswait() {
    assert_eq!(t5().run().edges()[9], T5[9]);
}

#[test]
fn pro_laser_override() {
    let of_group = |overrides: bool| {
        let run = t5().with(|machine| machine.laser.gas.overrides = overrides);
        let run = run.job(|job| {
            let mut shapes = job.shapes.to_vec();
            (shapes[0].tool, shapes[0].cut) = (3, 2);
            job.shapes = shapes.into();
        });
        run.run().edges().join(" ")
    };
    let (own, gas) = (of_group(false), of_group(true));
    assert!(gas.contains("tool1+") && gas.contains("cut2+") && !gas.contains("tool3"), "{gas}");
    assert!(own.contains("tool3+") && own.contains("cut2+") && !own.contains("tool1"), "{own}");
}

#[test]
fn pro_laser_engrave_bit() {
    takes_none("laser.engrave_cut", 2.0);
    let engraved = t5().with(|machine| machine.laser.engrave_cut = Some(2)).job(|job| {
        let mut shapes = job.shapes.to_vec();
        shapes[0].cut = 2;
        job.shapes = shapes.into();
    });
    let trace = engraved.run();
    assert!(!trace.edges().iter().any(|edge| edge.contains("tool2")), "{:?}", trace.edges());
    let on = trace.edges().into_iter().find(|edge| edge.ends_with("cut2+"));
    let begins = trace.moves().into_iter().find(|made| made.ends_with(" x100"));
    let at_s = |told: Option<String>| -> f64 {
        told.and_then(|told| told.split([' ', '-']).next()?.parse().ok()).expect("a time")
    };
    let (on_s, begins_s) = (at_s(on), at_s(begins));
    assert!((begins_s - on_s - 1.0).abs() < 2e-3, "the bottom delay: {on_s} to {begins_s}");
    let dark = |(t, value, byte): &(f64, u8, u8)| *t > begins_s || (*value, *byte) == (0, 0);
    assert!(trace.intensities().iter().all(dark), "{:?}", trace.intensities());
    assert!(trace.intensities().iter().any(|(_, value, _)| *value == 76), "cruise at 60 %");
    let pierced = t5().with(|machine| machine.laser.engrave_cut = Some(2)).run();
    assert_eq!(pierced.edges(), T5);
}

#[test]
fn pro_laser_no_bottom() {
    let longer = t5().with(|machine| machine.delays.bottom_s = 1.0).run();
    assert_eq!(longer.edges(), T5);
}

#[test]
fn pro_laser_use() {
    let none = JobRun::new(t1()).run();
    assert!(none.intensities().is_empty());
    assert!(!none.edges().iter().any(|edge| edge.contains("hz")));
    let unchosen = t5().with(|machine| machine.laser.kind = None).run();
    assert_eq!(unchosen.refused(), "the type of laser is not chosen");
}

#[test]
fn pro_laser_pwm() {
    let clipped = |kind| {
        let run = t5().with(|machine| {
            (machine.laser.kind, machine.laser.cut_hz) = (Some(kind), 100_000.0);
            (machine.laser.min_pulse_us, machine.laser.max_pulse_us) = (1.0, 5.0);
            machine.intensity.scale_percent = 100.0;
        });
        run.run().intensities().into_iter().map(|(_, value, _)| value).max()
    };
    assert_eq!((clipped(LaserType::Pulsed), clipped(LaserType::Continuous)), (Some(63), Some(127)));
}

#[test]
fn pro_laser_lowbit() {
    let burning = shining(60.0).with(|machine| machine.intensity.low_bit_at_bottom = true).run();
    let low: Vec<_> =
        burning.intensities().iter().filter(|(.., byte)| byte & 1 == 1).copied().collect();
    assert_eq!(low, [(low[0].0, 0, 1)]);
    assert!((low[0].0 - 3.84).abs() < 1e-3);
    let after = burning.intensities().into_iter().find(|(t, ..)| *t > 3.9).expect("a change");
    assert!((after.0 - 4.84).abs() < 1e-3 && after.2 & 1 == 0);
    let never = shining(60.0).run();
    assert!(never.intensities().iter().all(|(.., byte)| byte & 1 == 0));
}

#[test]
fn pro_intensity_burn() {
    pro_laser_lowbit();
}

#[test]
fn pro_intensity_clip_none() {
    let refused = |min: f64, max: f64| {
        let run = t5().with(|machine| {
            machine.laser.cut_hz = 200_000.0;
            (machine.laser.min_pulse_us, machine.laser.max_pulse_us) = (min, max);
        });
        run.run().refused()
    };
    assert_eq!(refused(6.0, 10.0), "no valid laser pulse width");
    assert_eq!(refused(3.0, 2.0), "no valid laser pulse width");
}

#[test]
fn pro_intensity_byte() {
    let bytes = shining(100.0).run().intensities();
    assert!(bytes.iter().all(|(_, value, byte)| *byte == 2 * value));
    assert!(bytes.iter().any(|(_, value, byte)| (*value, *byte) == (127, 254)));
    assert!(shining(60.0).run().intensities().iter().any(|(.., byte)| *byte == 0x4c));
}

#[test]
fn pro_intensity_follow() {
    let shone = shining(100.0).run().intensities();
    let values: Vec<u8> = shone.iter().map(|(_, value, _)| *value).collect();
    let (rise, fall): (Vec<u8>, Vec<u8>) = ((1..=127).collect(), (0..127).rev().collect());
    assert_eq!(values, [rise, fall].concat());
    // Index k is reached at speed k/127 of 100 mm/s, with 1000 mm/s² after k/127 tenths of a second.
    for (t, value, _) in &shone[..127] {
        assert!((t - (4.84 + 0.1 * f64::from(*value) / 127.0)).abs() < 1e-5, "{value} at {t}");
    }
    assert!((shone[126].0 - 4.94).abs() < 1e-5);
}

#[test]
fn pro_intensity_reference() {
    let slow = shining(100.0).job(|job| {
        let mut shapes = job.shapes.to_vec();
        shapes[0].speed_mm_s = Some(50.0);
        job.shapes = shapes.into();
    });
    assert_eq!(slow.run().intensities().iter().map(|(_, value, _)| *value).max(), Some(127));
    // Along Y 80 mm/s are the whole of it, and along X 80 of 100.
    let along = |x: f64, y: f64| {
        let run = shining(100.0).job(|it| *it = job([line(1, (0.0, 0.0), (x, y))]));
        let run = run.with(|machine| machine.program.smoothing.y_factor = 0.8).run();
        let most = run.intensities().iter().map(|(_, value, _)| *value).max();
        (run.cutting_speeds()[0], most)
    };
    assert_eq!([along(0.0, 100.0), along(100.0, 0.0)], [(80.0, Some(127)), (100.0, Some(127))]);
}

#[test]
fn pro_intensity_reference__follows_the_override() {
    // JOB-T1 cuts from 4.84 s on, and cruises from 4.94 s.
    for share in [0.5, 0.25] {
        let shone = shining(60.0).request(5.2, OperatorRequest::Feed(share)).run().intensities();
        let cruises = |(t, _, _): &&(f64, u8, u8)| (4.9..5.9).contains(t);
        let last = shone.iter().rfind(cruises).map(|(t, value, _)| (*t < 4.9401, *value));
        assert_eq!(last, Some((true, 76)), "slower, and as much of what is asked for: {shone:?}");
    }
}

#[test]
fn pro_intensity_idle() {
    let paused = shining(100.0).stop(5.34).say("resume").run();
    let lit: Vec<_> = paused.intensities().into_iter().filter(|(_, value, _)| *value > 0).collect();
    let cutting = |t: f64| (4.84..5.4401).contains(&t) || t > 10.4799;
    assert!(lit.iter().all(|(t, ..)| cutting(*t)), "{lit:?}");
    let ends = paused.intensities();
    assert!(ends.iter().any(|(t, value, _)| *value == 0 && (t - 5.44).abs() < 1e-3));
    assert_eq!(ends.last().map(|(_, value, _)| *value), Some(0));
}

#[test]
fn pro_misc_intensity_on() {
    assert!(JobRun::new(t1()).run().intensities().is_empty());
    let shone = shining(100.0).run().intensities();
    let cruise: Vec<_> = shone.iter().filter(|(t, ..)| (4.95..5.83).contains(t)).collect();
    assert!(cruise.is_empty() && shone.iter().any(|(.., byte)| *byte == 254));
}

#[test]
fn pro_misc_laser_on() {
    pro_laser_use();
}

/// JOB-T5 through the material with proportional height control over a sheet.
fn over(sheet: Sheet) -> JobRun {
    t5().sheet(sheet).with(|machine| {
        machine.zpos.bottom_mm = -30.0;
        (machine.height.on, machine.height.mode) = (true, HeightMode::Proportional);
        machine.height.k = 9.5;
    })
}

/// Heights at which moves of Z end, in order.
fn heights(run: JobRun) -> Vec<f64> {
    let moves = run.run().moves();
    moves.iter().filter_map(|it| it.rsplit_once(" z").and_then(|(_, z)| z.parse().ok())).collect()
}

#[test]
fn pro_laser_heightctl() {
    // The sheet lies at -18.5; the set point is 150 units of 0.038 mm above it, and one unit ends the way down.
    let ends = heights(over(Sheet::flat(-18.5)));
    let sensed = -18.5 + 5.7;
    let (pierced, cut) = (ends[2], ends[3]);
    assert!(ends[1] < sensed && ends[1] > sensed - 0.5, "it runs on a little: {ends:?}");
    assert!((pierced - cut - 5.0).abs() < 1e-6, "{ends:?}");
    assert!((cut - sensed).abs() < 0.04, "{ends:?}");
    let edges = over(Sheet::flat(-18.5)).run().edges();
    let order: Vec<&str> =
        edges.iter().filter_map(|edge| edge.split_once(' ').map(|(_, e)| e)).collect();
    let pierce = ["tool2+", "hz 500", "cut1+", "cut1-", "tool2-", "tool1+", "hz 5000", "cut1+"];
    assert_eq!(order[2..10], pierce);
}

#[test]
fn pro_laser_pierce_height__above_the_sensed_surface() {
    let pierced = |height: f64| {
        let ends = heights(
            over(Sheet::flat(-17.0)).with(|machine| machine.laser.pierce.height_mm = height),
        );
        ends[2] - ends[3]
    };
    assert!((pierced(5.0) - 5.0).abs() < 1e-6 && (pierced(2.0) - 2.0).abs() < 1e-6);
}

#[test]
fn pro_laser_legacy__in_a_trace() {
    let power = |cut: u8| {
        let run = t5().with(|machine| {
            machine.laser.legacy_board = true;
            machine.laser.pierce.use_sequence = false;
            machine.intensity.low_bit_at_bottom = true;
        });
        let run = run.job(|job| {
            let mut shapes = job.shapes.to_vec();
            shapes[0].cut = cut;
            job.shapes = shapes.into();
        });
        let changes = run.signals().changes("laser_power");
        let value = |t_ms: u64| {
            let before = changes.iter().rev().find(|(t, _)| *t <= t_ms);
            before.map_or(0.0, |(_, value)| value[1..].trim().parse::<f64>().expect("a number"))
        };
        // In the bottom delay, and at speed: 60 % of 127 are 76.
        (value(3200), value(4600))
    };
    let cruise = 100.0 * 76.0 / 127.0;
    let (one, two) = (power(1), power(2));
    assert_eq!((one.0, two.0), (100.0, 0.0));
    assert!((one.1 - cruise).abs() < 1e-6 && (two.1 - cruise).abs() < 1e-6, "{one:?} {two:?}");
}

#[test]
fn pro_intensity_pulse__in_a_trace() {
    let trace = t5().with(|machine| machine.laser.cut_hz = 100_000.0).run();
    let widths = trace.events.iter().filter_map(|event| match event {
        kerf_trace::Event::Intensity { value: 38, pulse_us, .. } => *pulse_us,
        _ => None,
    });
    let widths: Vec<f64> = widths.collect();
    assert!(!widths.is_empty() && widths.iter().all(|us| (us - 2.992).abs() < 5e-4), "{widths:?}");
}

/// The trace of JOB-T5 with a line of 5 mm, its intensity on a port.
fn short(port: u8) -> String {
    let run = t5().with(|machine| machine.intensity.port = port);
    run.job(|it| *it = job([line(1, (0.0, 0.0), (5.0, 0.0))])).signals().0
}

/// Changes of a signal in a scope of a trace.
fn changes_in(text: &str, scope: &str, name: &str) -> usize {
    let module = text.split(&format!("$scope module {scope} $end")).nth(1).expect("the scope");
    let declared = module.lines().find(|line| line.ends_with(&format!(" {name} $end")));
    let code = declared.and_then(|line| line.split(' ').nth(3)).expect("the signal");
    let (_, body) = text.split_once("$dumpvars").expect("a body");
    let told = body.lines().filter(|line| line.split(' ').nth(1) == Some(code));
    told.count() - 1
}

#[test]
fn pro_options_lpt() {
    for (port, other) in [(1, "lpt2"), (2, "lpt1")] {
        let own = format!("lpt{port}");
        let text = short(port);
        assert!(changes_in(&text, &own, "intensity_byte") > 20);
        assert_eq!(changes_in(&text, other, "intensity_byte"), 0);
    }
    refuses("intensity.port", &[0.0, 3.0]);
}

#[test]
fn pro_io_lpt() {
    let text = short(2);
    assert_eq!(changes_in(&text, "lpt2", "laser_hz"), 2);
    assert_eq!(changes_in(&text, "lpt1", "laser_hz"), 0);
    assert!(changes_in(&text, "lpt2", "intensity_byte") > 20);
    refuses("intensity.port", &[0.0, 3.0]);
}

#[test]
fn pro_misc_laser_on__a_laser_job() {
    let hz = |run: JobRun| run.run().edges().iter().filter(|edge| edge.contains("hz")).count();
    assert_eq!(hz(JobRun::new(t1())), 0);
    assert_eq!(hz(t5().with(|machine| machine.laser.use_laser = false)), 0);
    assert_eq!(hz(t5()), 2);
    assert!(!kerf_machine::Configuration::default().laser.use_laser);
    let unchosen = t5().with(|machine| machine.laser.kind = None).run();
    assert!(unchosen.moves().is_empty() && unchosen.edges().is_empty());
}
