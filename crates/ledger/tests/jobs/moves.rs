//! Area `move`: moves by hand; and what belongs to them of zpos, axes and pause.

use kerf_ledger::jobs::{JobRun, JobTrace, job, line, t1};
use kerf_machine::hand::cut_move;
use kerf_machine::{Errand, Held, Keypad};
use kerf_program::{AXES, Axes, Axis, AxisSet, Settings, Status};
use kerf_trace::{Event, ExecutedMove, Sink};

fn axes(letters: &str) -> AxisSet {
    letters.chars().filter_map(Axis::from_letter).fold(AxisSet::EMPTY, AxisSet::with)
}

/// With the job origin at (300, 200).
fn placed(errand: Errand) -> JobRun {
    JobRun::hand(errand).with(|machine| machine.job.origin_mm = [300.0, 200.0])
}

fn to(place: [f64; 3], relative: bool, flat: bool) -> Errand {
    let mut all = [None; AXES];
    all.iter_mut().zip(place).for_each(|(it, value)| *it = Some(value));
    Errand::To { place: all, relative, flat }
}

/// A key that is held: which way, and shares of speed and acceleration.
fn key(x: i8, y: i8, z: i8, speed: f64, accel: f64) -> JobRun {
    let way = [x, y, z, 0, 0, 0];
    JobRun::hand(Errand::Held(Held { way, speed, accel, sets_bottom: false }))
}

#[test]
fn pro_move_home() {
    let run = |letters| JobRun::hand(Errand::Home(axes(letters))).at(500.0, 300.0, -25.0).run();
    assert_eq!(run("xy").rests(), [0.0, 0.0, -25.0]);
    let all = run("xyz");
    assert_eq!(all.rests(), [0.0, 0.0, 0.0]);
    let moves: Vec<_> =
        all.moves().iter().map(|m| m.split_once(' ').unwrap().1.to_owned()).collect();
    assert_eq!(moves, ["z0", "x0 y0"]);
}

#[test]
fn pro_zpos_home() {
    let trace = JobRun::hand(Errand::Home(axes("z"))).at(10.0, 0.0, -25.0).run();
    assert_eq!(trace.rests(), [10.0, 0.0, 0.0]);
}

#[test]
fn pro_axes_powerup_home() {
    let start = |machine: &mut kerf_machine::Configuration| {
        machine.simulated.start_at[..2].copy_from_slice(&[500.0, 300.0]);
    };
    let away = JobRun::hand(to([40.0, 30.0, 0.0], true, false)).with(start).unhomed().run();
    assert_eq!(away.rests(), [40.0, 30.0, 0.0]);
    let back = JobRun::hand(Errand::Home(axes("xy"))).with(start).after(&away).run();
    assert_eq!(back.rests(), [0.0, 0.0, 0.0]);
}

#[test]
fn pro_move_origin() {
    let low = placed(Errand::Origin).at(0.0, 0.0, -25.0).run();
    assert_eq!(low.rests(), [300.0, 200.0, -10.0]);
    assert!(low.moves()[0].ends_with(" z-10"), "up first: {:?}", low.moves());
    assert_eq!(placed(Errand::Origin).at(0.0, 0.0, -5.0).run().rests(), [300.0, 200.0, -5.0]);
}

#[test]
fn pro_move_finish() {
    let finish = |m: &mut kerf_machine::Configuration| m.job.finish_mm = [25.0, 20.0];
    let trace = placed(Errand::Finish).with(finish).at(0.0, 0.0, -25.0).run();
    assert_eq!(trace.rests(), [325.0, 220.0, -10.0]);
    assert!(trace.moves()[0].ends_with(" z-10"));
}

#[test]
fn pro_move_arrows_xy() {
    let trace = key(1, 0, 0, 0.25, 1.0).let_go(1.0).run();
    // 50 mm/s at 1000 mm/s/s: 48.75 at release, 0.05 s and 1.25 mm to rest.
    assert_eq!(trace.moves(), ["0.000-1.050 x50"]);
    for (x, y) in [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1)] {
        let trace = key(x, y, 0, 0.25, 1.0).at(500.0, 500.0, 0.0).let_go(1.0).run();
        let [rx, ry, _] = trace.rests();
        let expected = (500.0 + 50.0 * f64::from(x), 500.0 + 50.0 * f64::from(y));
        assert!((rx - expected.0).abs() + (ry - expected.1).abs() < 0.9, "{x},{y}: {rx} {ry}");
        assert!(x == 0 || y == 0 || ((rx - 500.0).abs() - (ry - 500.0).abs()).abs() < 1e-9);
    }
}

#[test]
fn pro_move_arrows_z() {
    let up = key(0, 0, 1, 0.25, 1.0).at(5.0, 5.0, -25.0).let_go(0.5).run();
    assert!(up.rests()[2] > -25.0 && up.rests()[..2] == [5.0, 5.0]);
    let down = key(0, 0, -1, 0.25, 1.0).at(5.0, 5.0, -25.0).run();
    assert_eq!(down.rests(), [5.0, 5.0, -30.0]);
    assert_eq!(down.messages(), ["Out of bounds: z ends at -30.000"]);
}

#[test]
fn pro_zpos_bottom_limit() {
    let down = key(0, 0, -1, 0.1, 1.0).at(0.0, 0.0, -28.0).run();
    assert_eq!((down.rests()[2], down.messages().len()), (-30.0, 1));
    let held = Held { way: [0, 0, -1, 0, 0, 0], speed: 0.1, accel: 1.0, sets_bottom: true };
    let set = JobRun::hand(Errand::Held(held)).at(0.0, 0.0, -30.0).let_go(0.4).run();
    assert!((set.rests()[2] + 32.0).abs() < 1e-6, "{:?}", set.rests());
}

/// A key of the keypad of part files on SIM, whose Z was homed or not.
fn keypad_of_sim(x: f64, z: f64, homed: bool) -> JobRun {
    let homed = if homed { AxisSet::first(3) } else { AxisSet::EMPTY };
    let way = [x, 0.0, z, 0.0, 0.0, 0.0];
    JobRun::hand(Errand::Keypad(Keypad { way, times: None, speed: 1.0, homed })).unhomed()
}

#[test]
fn pro_zpos_bottom_limit__keypad() {
    for homed in [true, false] {
        let down = keypad_of_sim(0.0, -1.0, homed).at(0.0, 0.0, -28.0).run();
        assert_eq!(down.rests()[2], -30.0, "homed {homed}");
        let [said] = &down.messages()[..] else { panic!("{:?}", down.messages()) };
        assert!(said.ends_with(", Z bottom (zpos.bottom_mm)"), "{said}");
        let up = keypad_of_sim(0.0, 1.0, homed).at(0.0, 0.0, -40.0).run();
        assert_eq!(up.rests()[2], 0.0, "the way back is free");
    }
    let no_length = |machine: &mut kerf_machine::Configuration| machine.axes.length[Axis::Z] = 0.0;
    let unknown = keypad_of_sim(0.0, -1.0, false).with(no_length).let_go(1.0).run();
    assert!(unknown.rests()[2] < -40.0, "nobody knows where Z is: {:?}", unknown.rests());
}

#[test]
fn pro_axes_limit_unhomed__keypad() {
    let right = keypad_of_sim(1.0, 0.0, false).run();
    assert_eq!(right.rests()[0], 2500.0, "from where it was switched on");
    let left = keypad_of_sim(-1.0, 0.0, false).run();
    assert_eq!(left.rests()[0], 0.0);
}

#[test]
fn pro_move_arrows_pct() {
    let trace = key(1, 0, 0, 0.25, 0.5).let_go(1.0).run();
    assert_eq!(trace.moves(), ["0.000-1.100 x50"]);
    let slow = key(1, 0, 0, 0.125, 1.0).let_go(1.0).run();
    assert_eq!(slow.moves(), ["0.000-1.025 x25"]);
}

#[test]
fn pro_move_arrows_limit() {
    let trace = key(1, 0, 0, 0.25, 1.0).at(2490.0, 0.0, 0.0).run();
    assert_eq!(trace.rests()[0], 2500.0);
    assert_eq!(trace.messages(), ["Out of bounds: x ends at 2500.000"]);
    let free = key(1, 0, 0, 0.25, 1.0).at(2490.0, 0.0, 0.0).let_go(1.0);
    let free = free.with(|machine| machine.axes.limit_movement = false).run();
    assert_eq!((free.rests()[0], free.messages().len()), (2540.0, 0));
}

#[test]
fn pro_axes_limit_unhomed() {
    let start = |machine: &mut kerf_machine::Configuration| {
        machine.simulated.start_at[..2].copy_from_slice(&[500.0, 300.0]);
    };
    let right = key(1, 0, 0, 1.0, 1.0).with(start).unhomed().run();
    assert_eq!(right.rests()[0], 2500.0, "from where it was switched on");
    let homed = JobRun::hand(Errand::FindHome(axes("x"))).with(start).unhomed().run();
    let truly = homed.session.truth()[0][0];
    assert!((truly + 117.0).abs() < 0.01, "zero is at the switch: {truly}");
    let right = key(1, 0, 0, 1.0, 1.0).with(start).after(&homed).run();
    assert_eq!(right.rests()[0], 2500.0);
}

#[test]
fn pro_axes_limit_on() {
    let trace = JobRun::new(job([line(1, (0.0, 0.0), (2600.0, 0.0))])).run();
    assert_eq!(trace.summary.status, Status::Failed);
    assert!(trace.refused().starts_with("Out of bounds: "), "{}", trace.refused());
    assert!(trace.moves().is_empty() && trace.edges().is_empty());
    let by_hand = JobRun::hand(to([2600.0, 0.0, 0.0], false, false)).run();
    assert_eq!(by_hand.refused(), "Out of bounds: x would reach 2600.000");
    assert_eq!(by_hand.rests(), [0.0, 0.0, 0.0]);
}

#[test]
fn pro_axes_limit_off() {
    let off = |machine: &mut kerf_machine::Configuration| machine.axes.limit_movement = false;
    let trace = JobRun::new(job([line(1, (0.0, 0.0), (2600.0, 0.0))])).with(off).run();
    assert_eq!(trace.summary.status, Status::Ok);
    assert!(trace.moves().iter().any(|made| made.ends_with(" x2600")), "{:?}", trace.moves());
    assert_eq!(trace.messages(), [""; 0]);
}

#[test]
fn pro_axes_axes__by_hand() {
    let trace = JobRun::hand(to([0.0, 0.0, 1.0], true, false)).at(0.0, 0.0, -5.0).run();
    assert_eq!(trace.rests(), [0.0, 0.0, -4.0]);
}

#[test]
fn pro_move_cutmoveto() {
    let trace = placed(Errand::CutMoveTo([100.0, 50.0])).at(0.0, 0.0, -25.0).run();
    assert_eq!(trace.rests(), [400.0, 250.0, -10.0]);
    assert_eq!(trace.edges(), [""; 0]);
    // Up to Z top first, then over the table, as fast as it goes without cutting, relative to the origin.
    // Z takes 15 mm at 50 mm/s and a ramp of .1 s, X, the longer way, 400 mm at 200 mm/s and .2 s.
    assert_eq!(trace.moves(), ["0.000-0.400 z-10", "0.400-2.600 x400 y250"]);
}

#[test]
fn pro_move_cutmoveto_cut() {
    let made = cut_move(&kerf_ledger::jobs::sim(), Axes::default(), [100.0, 0.0]);
    let (trace, whole) = (JobRun::new(made).run(), JobRun::new(t1()).run());
    let cut = |trace: &JobTrace| {
        let edges = trace.edges();
        let [on, off] =
            ["router+", "router-"].map(|e| edges.iter().position(|x| x.ends_with(e)).unwrap());
        edges[on..=off].to_vec()
    };
    assert_eq!(cut(&trace), cut(&whole));
    assert_eq!(trace.moves()[..], whole.moves()[..trace.moves().len()]);
    assert_eq!(trace.rests(), [100.0, 0.0, -10.0], "no finish move");
}

/// The job origin is a place to cut to, wherever jobs finish.
#[test]
fn pro_move_cutmoveto_cut__to_the_origin() {
    let mut machine = kerf_ledger::jobs::sim();
    machine.job.finish_mm = [25.0, 20.0];
    let made = cut_move(&machine, Axes([50.0, 0.0, 0.0, 0.0, 0.0, 0.0]), [0.0, 0.0]);
    let run = JobRun::new(made).with(|machine| machine.job.finish_mm = [25.0, 20.0]);
    assert_eq!(run.at(50.0, 0.0, 0.0).run().rests(), [0.0, 0.0, -10.0]);
}

#[test]
fn pro_move_moveto_abs() {
    assert_eq!(placed(to([10.0, 20.0, -5.0], false, false)).run().rests(), [310.0, 220.0, -5.0]);
}

#[test]
fn pro_move_moveto_rel() {
    let trace = JobRun::hand(to([5.0, 0.0, 1.0], true, false)).at(10.0, 20.0, -5.0).run();
    assert_eq!(trace.rests(), [15.0, 20.0, -4.0]);
}

#[test]
fn pro_move_moveto_2d() {
    let trace = JobRun::hand(to([10.0, 20.0, -5.0], false, true)).at(0.0, 0.0, -10.0).run();
    let moves: Vec<_> =
        trace.moves().iter().map(|m| m.split_once(' ').unwrap().1.to_owned()).collect();
    assert_eq!(moves, ["x10 y20", "z-5"]);
}

#[test]
fn pro_move_moveto_3d() {
    let trace = JobRun::hand(to([10.0, 20.0, -5.0], false, false)).at(0.0, 0.0, -10.0).run();
    assert_eq!(trace.moves().len(), 1, "one straight way: {:?}", trace.moves());
    assert_eq!(trace.rests(), [10.0, 20.0, -5.0]);
}

/// MoveTo (100, 0, −25) from (0, 0, −25), stopped on the way.
fn stopped_move(raise: bool, z: f64) -> JobTrace {
    JobRun::hand(to([100.0, 0.0, z], false, false))
        .with(|machine| machine.pause.raise = raise)
        .at(0.0, 0.0, z)
        .stop(0.3)
        .run()
}

#[test]
fn pro_pause_raise_moveto() {
    assert_eq!(stopped_move(true, -25.0).rests()[2], -10.0);
    assert_eq!(stopped_move(false, -25.0).rests()[2], -25.0);
    assert_eq!(stopped_move(true, -5.0).rests()[2], -5.0, "it is not lowered");
    assert!(stopped_move(true, -25.0).rests()[0] < 100.0);
    let on = JobRun::hand(to([100.0, 0.0, -25.0], false, false)).at(0.0, 0.0, -25.0);
    assert_eq!(on.stop(0.3).say("resume").run().rests(), [100.0, 0.0, -25.0]);
}

#[test]
fn pro_pause_stopkey__moves_by_hand() {
    let trace = stopped_move(false, -25.0);
    assert_eq!(trace.summary.status, Status::Stopped);
    // 0.2 s to 200 mm/s, 0.1 s at it, 0.2 s to rest.
    assert_eq!(trace.moves(), ["0.000-0.500 x60"]);
    let key = key(1, 0, 0, 1.0, 1.0).stop(0.3).run();
    assert_eq!(key.moves(), ["0.000-0.500 x60"]);
}

#[test]
fn pro_pause_arrows() {
    let run = |say: &str| JobRun::new(t1()).stop(5.34).say(say).run();
    let trace = run("jog 0,200,0,0,0,0 1 \u{23ce} resume");
    let moves = trace.moves();
    let at = moves.iter().position(|made| made.ends_with(" y200")).expect("the way out");
    assert!(moves[at + 1].ends_with(" y0"), "and back: {moves:?}");
    let out_s: f64 = moves[at].split('-').next().unwrap().parse().unwrap();
    let mut on = trace.edges().into_iter().filter(|edge| edge.contains("router+"));
    assert!(on.next_back().unwrap().split(' ').next().unwrap().parse::<f64>().unwrap() > out_s);
    assert_eq!(trace.summary.status, Status::Ok);
    // No further than the table.
    let far = run("jog 0,5000,0,0,0,0 1");
    assert_eq!(far.rests(), [50.0, 1250.0, -10.0]);
}

/// A key of the keypad of part files, on a machine in inches.
fn keypad(way: [f64; 2], times: Option<f64>, change: impl FnOnce(&mut Settings)) -> JobRun {
    let way = [way[0], way[1], 0.0, 0.0, 0.0, 0.0];
    let errand = Errand::Keypad(Keypad { way, times, speed: 1.0, homed: AxisSet::EMPTY });
    JobRun::hand(errand).unhomed().with(|machine| {
        machine.program = Settings::default();
        change(&mut machine.program);
    })
}

#[test]
fn sbp_lim_sf_keypad() {
    let limits = |settings: &mut Settings| {
        settings.limits.check = true;
        settings.limits.high[Axis::X] = 254.0;
    };
    let stopped = keypad([1.0, 0.0], None, limits).run();
    assert_eq!(stopped.rests(), [254.0, 0.0, 0.0]);
    assert!(
        stopped.messages().contains(&"Out of bounds: X ends at 10".into()),
        "{:?}",
        stopped.messages()
    );
    let free = keypad([1.0, 0.0], None, |settings| settings.limits.check = false);
    assert!(free.let_go(9.0).run().rests()[0] > 300.0);
}

#[test]
fn sbp_lim_switch_keypad() {
    let limit = |settings: &mut Settings| settings.io.inputs[1] = 1;
    let stopped = keypad([1.0, 0.0], None, limit).raw_input(2, 1.0, true).run();
    let at = stopped.rests()[0];
    assert!(at > 0.0 && at < 200.0, "{at} {:?}", stopped.events);
    assert!(
        stopped.messages().contains(&"stopped by limit input 2".into()),
        "{:?}",
        stopped.messages()
    );
    // The switch is still on: whoever presses the key again means it.
    for way in [1.0, -1.0] {
        let again = keypad([way, 0.0], Some(20.0), limit).after(&stopped).raw_input(2, 0.0, true);
        let moved = again.run().rests()[0] - at;
        assert!((moved - way * 20.0).abs() < 2e-3, "{moved}");
    }
}

#[test]
fn sbp_val_vr_keypad__moves() {
    // From .4 in/s to 2.4 in/s in .2 in, which takes 2 / 14 s; half the rate takes half the way.
    let speeds = |rate_mm: f64| {
        let run = keypad([1.0, 0.0], Some(254.0), |settings| {
            settings.ramps.keypad_rate_mm = rate_mm;
            settings.ramps.jog_rate_mm = 99.0;
        });
        let trace = run.run();
        trace.moves()[0].split([' ', '-']).nth(1).unwrap().parse::<f64>().unwrap()
    };
    // At 6 in/s: 2 · (5.6 / 14) s of ramps over 2 · 1.28 in, the rest of 10 in at full speed.
    let expected = |a: f64| 2.0 * 5.6 / a + (10.0 - (36.0 - 0.16) / a) / 6.0;
    assert!((speeds(5.08) - expected(14.0)).abs() < 2e-3, "{} {}", speeds(5.08), expected(14.0));
    assert!((speeds(2.54) - expected(28.0)).abs() < 2e-3, "{} {}", speeds(2.54), expected(28.0));
}

#[test]
fn the_keypad_leaves_outputs_as_they_are() {
    let on = |settings: &mut Settings| settings.io.outputs[2] = 3;
    let edges = keypad([1.0, 0.0], Some(25.4), on).run();
    assert!(!edges.events.iter().any(|e| matches!(e, Event::Output { n: 3, .. })));
}

#[test]
fn pro_job_relative() {
    assert_eq!(placed(to([0.0, 0.0, 0.0], false, false)).run().rests(), [300.0, 200.0, 0.0]);
}

#[test]
fn pro_job_step_origin() {
    let trace = placed(Errand::Origin).at(0.0, 0.0, -25.0).run();
    assert_eq!(trace.rests(), [300.0, 200.0, -10.0]);
    assert_eq!(trace.edges(), [""; 0], "every output is 0");
}

/// The greatest speed and acceleration of each axis over a run, a look a millisecond.
#[derive(Default)]
struct Peaks {
    speed: Axes,
    accel: Axes,
    before: Option<(f64, Axes)>,
}

impl Sink for Peaks {
    fn event(&mut self, _: &Event) {}

    fn made(&mut self, made: &ExecutedMove<'_>) {
        let (from_s, to_s) = (made.span.t0_s, made.span.t1_s);
        let looks = ((to_s - from_s) / 0.001).floor() as u32;
        for look in 0..=looks {
            let at_s = from_s + f64::from(look) * 0.001;
            let velocity = made.plan.at(at_s).velocity;
            let t_s = made.t0_s + at_s;
            if let Some((before_s, before)) = self.before {
                let step_s = t_s - before_s;
                if step_s > 5e-4 && step_s < 2e-3 {
                    let accel = velocity.minus(before).zip(before, |dv, _| dv.abs() / step_s);
                    self.accel = self.accel.zip(accel, f64::max);
                }
            }
            self.speed = self.speed.zip(velocity, |peak, v| peak.max(v.abs()));
            self.before = Some((t_s, velocity));
        }
    }
}

fn peaks(run: JobRun) -> (Peaks, f64) {
    let mut peaks = Peaks::default();
    let seconds = run.run_for(&mut peaks).seconds;
    (peaks, seconds)
}

#[test]
fn pro_axes_maxspeed__of_a_machine() {
    let (straight, _) = peaks(JobRun::hand(to([1000.0, 0.0, 0.0], false, false)));
    assert!((straight.speed[Axis::X] - 200.0).abs() < 1e-6, "{:?}", straight.speed);
    let (diagonal, _) = peaks(JobRun::hand(to([1000.0, 800.0, 0.0], false, false)));
    assert!((diagonal.speed[Axis::X] - 200.0).abs() < 1e-6, "{:?}", diagonal.speed);
    assert!(diagonal.speed[Axis::Y] <= 200.0 + 1e-6);
    let knife = JobRun::new(job([kerf_ledger::jobs::square(1, (0.0, 0.0), 100.0)]));
    let (knife, _) = peaks(knife.with(|machine| machine.misc.tangential = true));
    assert!(knife.speed[Axis::C] > 100.0 && knife.speed[Axis::C] <= 180.0 + 1e-6);
    assert!(knife.speed[Axis::Z] <= 50.0 + 1e-6);
}

#[test]
fn pro_axes_maxacc__of_a_machine() {
    let (peak, seconds) = peaks(JobRun::hand(to([100.0, 0.0, 0.0], false, false)));
    // 0.2 s up, 0.3 s at 200 mm/s, 0.2 s down.
    assert!((seconds - 0.7).abs() < 1e-6, "{seconds}");
    assert!((999.0..=1000.001).contains(&peak.accel[Axis::X]), "{:?}", peak.accel);
    let knife = JobRun::new(job([kerf_ledger::jobs::square(1, (0.0, 0.0), 100.0)]));
    let (knife, _) = peaks(knife.with(|machine| machine.misc.tangential = true));
    let most = [1000.0, 1000.0, 500.0, f64::INFINITY, f64::INFINITY, 720.0];
    for (axis, most) in Axis::ALL.into_iter().zip(most) {
        assert!(knife.accel[axis] <= most * 1.0001, "{axis:?}: {}", knife.accel[axis]);
    }
}
