//! Tests of what the machine does, and when.

use super::*;
use crate::Change;
use kerf_motion::{Mover, plan_stack};
use kerf_program::{At, Feed, Line, MoveKind};

fn machine(edit: impl FnOnce(&mut Settings), script: &[Change]) -> Model {
    let mut settings = Settings::default();
    edit(&mut settings);
    let inputs = Inputs::new(script.to_vec());
    Model::new(Axes::default(), Frame::default(), Arc::new(settings), inputs)
}

/// Makes cuts one after the other as one stack.
fn cut(machine: &mut Model, places: &[Axes]) {
    let settings = machine.settings().clone();
    let mut mover = Mover::new(machine.position(), &settings);
    let line = |to| Line { kind: MoveKind::Cut, to, feed: Feed::Axis };
    let moves = places.iter().filter_map(|to| mover.line(At::default(), &line(*to))).collect();
    let plan = plan_stack(moves, &settings.ramps);
    let t0_s = machine.begin_motion();
    for span in plan.iter() {
        let still = machine.not_carried();
        machine.make(t0_s, &plan, &span, &still);
    }
    machine.rest();
}

/// Outputs that changed: number, state, time to a thousandth.
fn outputs(machine: &mut Model) -> Vec<(u8, bool, f64)> {
    let changed = machine.log().take().filter_map(|h| match h.what {
        What::Output { number, on, .. } => Some((number, on, (h.t_s * 1e3).round() / 1e3)),
        _ => None,
    });
    changed.collect()
}

#[test]
fn the_warning_comes_before_motion_and_once() {
    let mut m = machine(|s| s.warning_s = 2.0, &[]);
    cut(&mut m, &[Axes::xyz(25.4, 0.0, 0.0)]);
    cut(&mut m, &[Axes::xyz(50.8, 0.0, 0.0)]);
    // Each inch takes .59143 s.
    assert!((m.clock_s() - 2.0 - 2.0 * 0.591_428_571).abs() < 1e-6, "{}", m.clock_s());
    m.end_file();
    assert_eq!(outputs(&mut m), [(4, true, 0.0), (4, false, 3.183)]);
}

#[test]
fn output_4_is_free_in_its_last_mode() {
    let mut m = machine(|s| s.io.output4 = -4, &[]);
    cut(&mut m, &[Axes::xyz(25.4, 0.0, 0.0)]);
    m.end_file();
    assert_eq!(outputs(&mut m), []);
}

#[test]
fn the_trigger_fires_while_z_passes() {
    let trigger = |s: &mut Settings| {
        s.io.output4 = -4;
        s.cutter.trigger.active = true;
        (s.cutter.trigger.on_at_mm, s.cutter.trigger.off_at_mm) = (-10.0, -5.0);
    };
    let places = [-20.0, -6.0, 0.0].map(|z| Axes::xyz(0.0, 0.0, z));
    let mut m = machine(trigger, &[]);
    cut(&mut m, &places);
    let switched = outputs(&mut m);
    let states: Vec<(u8, bool)> = switched.iter().map(|(n, on, _)| (*n, *on)).collect();
    assert_eq!(states, [(8, true), (8, false)]);
    assert!(switched[0].2 > 0.0 && switched[1].2 < m.clock_s(), "{switched:?}");
    // A move that also goes sideways does not trigger.
    let mut m = machine(trigger, &[]);
    cut(&mut m, &[Axes::xyz(30.0, 0.0, -20.0)]);
    assert_eq!(outputs(&mut m), []);
}

#[test]
fn inputs_change_while_the_clock_runs() {
    let change = |at_s, on| Change { input: 3, at_s, on };
    let mut m = machine(|_| (), &[change(1.0, true), change(2.0, false)]);
    assert_eq!((m.when_input(3, false), m.when_input(3, true)), (Some(0.0), Some(1.0)));
    assert_eq!(m.when_input(5, true), None);
    m.advance(1.5);
    assert!(m.input(3));
    assert_eq!((m.when_input(3, true), m.when_input(3, false)), (Some(1.5), Some(2.0)));
    let told: Vec<f64> = m.log().take().map(|h| h.t_s).collect();
    assert_eq!(told, [1.0]);
}

#[test]
fn each_pwm_channel_has_a_share_of_its_own_and_all_go_off() {
    let mut m = machine(|_| (), &[]);
    m.pwm(1, 50.0);
    m.pwm(2, 50.0);
    m.pwm(2, 50.0);
    m.outputs_off();
    let told = m.log().take().filter_map(|happening| match happening.what {
        What::Pwm { channel, percent, .. } => Some((channel, percent)),
        _ => None,
    });
    assert_eq!(told.collect::<Vec<_>>(), [(1, 50.0), (2, 50.0), (1, 0.0), (2, 0.0)]);
}

#[test]
fn while_a_preview_is_drawn_nothing_has_an_effect() {
    let mut m = machine(|_| (), &[Change { input: 4, at_s: 0.1, on: false }]);
    let draw = |m: &Model, mode| Arc::new(Settings { mode, ..(**m.settings()).clone() });
    m.use_settings(draw(&m, Mode::Preview));
    m.learn(Change { input: 4, at_s: 0.1, on: false });
    assert_eq!(m.halted(9.0, &[]), None);
    cut(&mut m, &[Axes::xyz(25.4, 0.0, 0.0)]);
    m.output(3, true, OutputReason::Program);
    m.pwm(1, 50.0);
    m.motors_off();
    assert_eq!((m.position().0[0], m.outputs().is_on(3)), (25.4, false));
    m.use_settings(draw(&m, Mode::Move));
    assert_eq!(m.position(), Axes::default());
    // What is drawn takes no machine time, so the input of 0.1 s has not come yet.
    assert_eq!((m.clock_s(), m.log().take().count()), (0.0, 0));
}

#[test]
fn motors_off_stops_everything() {
    let mut m = machine(|_| (), &[]);
    m.output(3, true, OutputReason::Program);
    m.independent(Axis::B, Independent::Rotate(30.0));
    m.advance(2.0);
    m.motors_off();
    m.advance(9.0);
    assert_eq!((m.true_position()[Axis::B], m.outputs().is_on(3)), (60.0, false));
    assert_eq!(m.log().take().last().map(|h| h.what), Some(What::Motors(false)));
}

#[test]
fn an_override_of_limits_ends_with_the_file() {
    let limits = |s: &mut Settings| {
        s.limits.check = true;
        s.io.inputs[1] = 1;
    };
    let mut m = machine(limits, &[]);
    assert_eq!(m.halted(2.0, &[]), None);
    m.learn(Change { input: 2, at_s: 1.0, on: true });
    assert!(m.halted(2.0, &[]).is_some());
    m.override_table();
    assert!(m.halted(2.0, &[]).is_some(), "the table is no switch");
    m.override_switch(2);
    assert!(m.halted(2.0, &[]).is_none());
    m.end_file();
    assert!(m.halted(2.0, &[]).is_some());
}
