//! Inputs, outputs and steps of jobs, as their signals show them.

use kerf_ledger::jobs::{JobRun, Signals, job, t1, t2};
use kerf_machine::lines::Input;
use kerf_machine::settings::height::HeightMode;
use kerf_machine::settings::io::{Card, IoMap};
use kerf_machine::settings::motors::FreeMotor;
use kerf_sim::Sheet;
use kerf_trace::Event;
use std::sync::LazyLock;

/// The signals of JOB-T1, made once for all tests.
static T1: LazyLock<Signals> = LazyLock::new(|| JobRun::new(t1()).signals());

/// Checks when an output of JOB-T1 was on, milliseconds.
fn check(name: &str, expected: &[(u64, u64)]) {
    assert_eq!(T1.on(name), expected, "{name}");
}

/// JOB-T2 whose second shape has another tool and another cut output.
fn second_tool(tool: u8, cut: u8) -> Signals {
    let mut shapes = t2().shapes.to_vec();
    (shapes[1].tool, shapes[1].cut) = (tool, cut);
    JobRun::new(job(shapes)).signals()
}

#[test]
fn pro_io_outb0() {
    check("tool1", &[(2300, 6690)]);
}

#[test]
fn pro_io_outb1() {
    check("cut1", &[(3840, 5940)]);
}

#[test]
fn pro_io_outb2() {
    assert_eq!(second_tool(2, 1).on("tool2"), [(7640, 12030)]);
}

#[test]
fn pro_io_outb3() {
    assert_eq!(second_tool(1, 2).on("cut2"), [(9180, 11280)]);
}

#[test]
fn pro_io_outb4() {
    assert_eq!(second_tool(3, 1).on("tool3"), [(7640, 12030)]);
}

#[test]
fn pro_io_outb5() {
    assert_eq!(second_tool(1, 3).on("cut3"), [(9180, 11280)]);
}

#[test]
fn pro_io_outb6() {
    check("router", &[(300, 7190)]);
}

#[test]
fn pro_io_outb7() {
    check("job_running", &[(0, 7890)]);
}

#[test]
fn pro_io_pci_o_run() {
    check("job_running", &[(0, 7890)]);
}

#[test]
fn pro_io_pci_o_tools() {
    // On through plunge, cut and raise.
    check("tool1", &[(2300, 6690)]);
}

/// JOB-T1 with a pause in the middle of the cut.
static PAUSED: LazyLock<Signals> =
    LazyLock::new(|| JobRun::new(t1()).stop(5.34).say("continue").signals());

#[test]
fn pro_io_pci_o_router() {
    assert_eq!(PAUSED.on("router")[0], (300, 5440));
    check("router", &[(300, 7190)]);
}

#[test]
fn pro_io_io_router() {
    assert_eq!(PAUSED.on("router").len(), 2);
}

#[test]
fn pro_io_io_run() {
    assert_eq!(PAUSED.on("job_running").len(), 1);
}

#[test]
fn pro_io_outc23() {
    let signals = &*T1;
    assert!(signals.on("c2").is_empty() && signals.on("c3").is_empty());
}

#[test]
fn pro_io_inb2() {
    quiet(&[11]);
}

#[test]
fn pro_io_inb37() {
    quiet(&[12, 13, 14, 15, 16]);
}

/// Inputs that change nothing: those behind the first of the ports.
fn quiet(behind: &[u8]) {
    let mut run = JobRun::new(t1());
    for by in behind {
        let line = Input::ZHome.number() + by - 1;
        run = run.raw_input(line, 5.0, true).raw_input(line, 5.5, false);
    }
    let signals = run.signals();
    for name in ["tool1", "cut1", "router", "job_running", "x_pos", "z_pos", "port_c"] {
        assert_eq!(signals.changes(name), T1.changes(name), "{name}");
    }
}

#[test]
fn pro_io_vcd() {
    let signals = &*T1;
    let rises = |name: &str| signals.changes(name).iter().filter(|(_, it)| it == "1").count();
    // 100 mm there and back, 10 mm down before the first shape and 20 mm down to cut, and up again.
    assert_eq!((rises("xstep"), rises("ystep")), (50_000, 0));
    let bytes: Vec<(u64, String)> = signals.changes("port_b");
    let shown: Vec<String> = bytes.iter().map(|(t_ms, byte)| format!("{t_ms} {byte}")).collect();
    assert_eq!(
        shown,
        [
            "0 b10000000",
            "300 b11000000",
            "2300 b11000001",
            "3840 b11000011",
            "5940 b11000001",
            "6690 b11000000",
            "7190 b10000000",
            "7890 b00000000"
        ]
    );
    // Down 10 mm to Z top and 20 mm to the bottom, up 20 mm again; 250 steps a millimetre.
    assert_eq!(rises("zstep"), 250 * (10 + 20 + 20));
}

/// JOB-T1 under height control: by two inputs, or by readings over a sheet that rises.
fn controlled(mode: HeightMode) -> JobRun {
    let run = JobRun::new(t1()).with(|machine| {
        (machine.height.on, machine.height.mode, machine.height.k) = (true, mode, 9.5);
    });
    if mode == HeightMode::Proportional {
        return run.sheet(Sheet { slope_x: 0.03, ..Sheet::flat(-22.0) });
    }
    // Down to the sheet; down on the way, and less far up again.
    let pulses =
        [(3.3, Input::ZHigh, false), (4.6, Input::ZHigh, true), (4.7, Input::ZHigh, false)];
    let run = run.input(Input::ZHigh, 0.1, true).input(Input::ZLow, 5.0, true);
    let run = run.input(Input::ZLow, 5.05, false);
    pulses.into_iter().fold(run, |run, (at_s, input, on)| run.input(input, at_s, on))
}

#[test]
fn pro_io_vcd__has_the_steps_of_height_control() {
    for mode in [HeightMode::Simple, HeightMode::Proportional] {
        let (signals, trace) = (controlled(mode).signals(), controlled(mode).run());
        let ends = (trace.rests()[2] * 250.0).round() as i64;
        let off = signals.driven('z') - ends;
        assert!(
            off.abs() <= 1,
            "{mode:?}: the pulses lead {off} steps beside where Z ends, {ends}"
        );
        let counted = signals.positions('z');
        let apart = counted.windows(2).map(|pair| (pair[1].1 - pair[0].1).abs());
        assert_eq!(apart.max(), Some(1), "{mode:?}: a step is a step");
        let (_, last) = counted[counted.len() - 1];
        assert!((last - ends).abs() <= 1, "{mode:?}: {last} counted, {ends}");
        // In the cut itself, which the plan holds at one height.
        let cut = &signals.on("cut1")[0];
        let steps = counted.iter().filter(|(t_ms, _)| (cut.0..cut.1).contains(t_ms)).count();
        assert!(steps > 100, "{mode:?}: {steps} steps in the cut");
    }
}

#[test]
fn pro_io_vcd__as_the_trace_and_the_bounds_have_it() {
    let trace = controlled(HeightMode::Simple).run();
    let cut = trace.moves().into_iter().find(|it| it.contains(" x100")).expect("the cut");
    // 3 mm down, and the 1.5 mm of a pulse half as long up again: 10 mm below ZTop at the end.
    let ends = trace.rests()[2] - 10.0;
    assert!(cut.ends_with(&format!(" z{}", (ends * 1e3).round() / 1e3)), "{cut} to {ends}");
    let low = trace.summary.tally.bounds.min[2];
    assert!((low + 23.0).abs() < 0.05 && ends > low + 0.5, "{low}, {ends}: as low as on the way");
    let told = trace.events.iter().filter_map(|event| match event {
        Event::Heights { surface, t, .. } if *t > 4.5 && *t < 5.0 => Some(*surface),
        _ => None,
    });
    let lowest = told.fold(f64::INFINITY, f64::min);
    assert!((lowest - low).abs() < 1e-6, "told where it comes to rest: {lowest}");
}

#[test]
fn pro_timing_inputs() {
    let signals = JobRun::new(t1()).input(Input::EndBottomDelay, 4.0, true).signals();
    assert_eq!(signals.changes("end_bottom_delay"), [(4000, "1".to_owned())]);
    let places = |name: &str| {
        signals.changes(name).into_iter().map(|(t_ms, bits)| {
            let steps = u32::from_str_radix(&bits[1..], 2).expect("a whole number of steps") as i32;
            (t_ms, steps)
        })
    };
    // 250 steps a millimetre: at -30 when the cut output goes on, at 100 at the end of the cut. The last step is
    // made a little before the axis comes to rest.
    let near = |place: Option<(u64, i32)>, t_ms: u64| {
        let (t, steps) = place.expect("a place");
        assert!((t_ms - 4..=t_ms).contains(&t), "{t} for {t_ms}");
        steps
    };
    assert_eq!(near(places("z_pos").min_by_key(|(_, steps)| *steps), 3840), -30 * 250);
    assert_eq!(near(places("x_pos").max_by_key(|(_, steps)| *steps), 5940), 100 * 250);
    assert_eq!(near(places("x_pos").next_back(), 7890), 0);
    assert_eq!(signals.changes("y_pos"), []);
}

#[test]
fn pro_axes_two_motors() {
    let signals = JobRun::new(t1()).with(|m| m.motors.x2 = Some(FreeMotor::Q)).signals();
    assert_eq!(signals.changes("xstep"), signals.changes("qstep"));
}

#[test]
fn pro_misc_intensity_on() {
    assert!(T1.changes("intensity_byte").is_empty());
    let on = JobRun::new(t1()).with(|m| m.intensity.output = true).signals();
    let cruise = on.changes("intensity_byte").into_iter().find(|(_, it)| it == "b11111110");
    assert_eq!(cruise.map(|(t_ms, _)| t_ms.abs_diff(4940) <= 1), Some(true));
}

/// The byte of port A while height control is simple, and how far an input moved Z, mm.
fn pulsed(input: Input) -> (Vec<(u64, String)>, f64) {
    let run = |pulse: bool| {
        let run = JobRun::new(t1()).with(|machine| machine.height.on = true);
        let run = run.input(Input::ZHigh, 0.1, true).input(Input::ZHigh, 3.3, false);
        if pulse { run.input(input, 4.7, true).input(input, 4.8, false) } else { run }
    };
    let by = run(true).run().rests()[2] - run(false).run().rests()[2];
    let bytes = run(true).signals().changes("in_a").into_iter().filter(|(t, _)| *t > 4000);
    (bytes.collect(), by)
}

fn carried(input: Input, byte: &str, by_mm: f64) {
    let (bytes, by) = pulsed(input);
    let expected = [(4700, byte.to_owned()), (4800, "b00000000".to_owned())];
    assert_eq!(bytes, expected);
    assert!((by - by_mm).abs() < 0.05, "{by}");
}

#[test]
fn pro_io_ina4() {
    carried(Input::ZHigh, "b00010000", -3.0);
}

#[test]
fn pro_io_ina7() {
    carried(Input::ZLow, "b10000000", 3.0);
}

#[test]
fn pro_io_io_in_hct__in_a_job() {
    pro_io_ina4();
}

#[test]
fn pro_io_io_in_hcb__in_a_job() {
    pro_io_ina7();
}

#[test]
fn pro_io_io_in_bdel__in_a_job() {
    let waits = || {
        JobRun::new(t1()).with(|machine| {
            machine.delays.bottom_type = kerf_machine::settings::delays::BottomDelayType::Input;
            machine.delays.bottom_s = 0.0;
        })
    };
    let pulse = |run: JobRun, at_s: f64| {
        let bdel = Input::EndBottomDelay;
        run.input(bdel, at_s, true).input(bdel, at_s + 0.001, false)
    };
    let cut = |run: JobRun| {
        let moves = run.run().moves();
        moves.into_iter().find(|made| made.ends_with(" x100")).unwrap_or_default()
    };
    // A millisecond is enough; before the cut bit at 3.84 it is nothing.
    assert!(cut(pulse(waits(), 4.64)).starts_with("4.640-"), "{}", cut(pulse(waits(), 4.64)));
    assert!(cut(pulse(pulse(waits(), 3.0), 5.0)).starts_with("5.000-"));
}

/// The emergency stop of JOB-T1 at 5 s, whose pin goes to a level.
fn stopped_at_level(level: bool, wiring: impl Fn(&mut IoMap)) -> Vec<(u64, String)> {
    let run = JobRun::new(t1()).with(|machine| wiring(&mut machine.io));
    run.input(Input::EmergencyStop, 5.0, level).signals().changes("in_a")
}

#[test]
fn pro_io_pci_i_elec__in_a_job() {
    let stops = |level| stopped_at_level(level, |io| io.card = Card::Pci);
    assert_eq!(stops(false)[0], (5000, "b01000000".into()), "grounded");
    assert_eq!(stopped_at_level(true, |io| io.card = Card::Io)[0], (5000, "b01000000".into()));
}

#[test]
fn pro_io_levels__in_a_job() {
    let turned = |io: &mut IoMap| io.invert_a[6] = true;
    assert_eq!(stopped_at_level(false, turned)[0], (5000, "b01000000".into()));
    let both = |io: &mut IoMap| (io.card, io.invert_a[6]) = (Card::Pci, true);
    assert_eq!(stopped_at_level(true, both)[0], (5000, "b01000000".into()));
    // A door whose switch opens: nobody has closed it.
    let door = JobRun::new(t1()).with(|machine| {
        machine.job.external_start = true;
        machine.io.invert_a[1] = true;
    });
    assert_eq!(door.signals().on("job_running"), [(0, 7890)]);
}
