//! Refusals: no board, no board for this machine, or a board that goes away is told, and nothing moves by itself.

use crate::world::{GRAIN_S, Motion, World, setup};
use kerf_driver_klipper::board::{Board, Fault, News, Options};
use kerf_driver_klipper::fake::{Dice, Faults};
use kerf_driver_klipper::setup::{DriverWire, Pin, Pulsed, Setup};

/// Fault that the host tells of something that answers each of its words so.
fn told_of(mut answers: impl FnMut(&[u8]) -> Vec<u8>) -> Fault {
    let mut host = Board::new(setup(), Options::default(), 0.0);
    for n in 1..30_000 {
        let now_s = f64::from(n) * GRAIN_S;
        let said = host.transmit(now_s).bytes;
        host.receive(&answers(&said), now_s);
        if let Some(news) = host.news() {
            let News::Fault(fault) = news else { panic!("{news:?}") };
            return fault;
        }
    }
    panic!("nothing was told");
}

#[test]
fn another_firmware_is_told() {
    let line = |words: &'static str| {
        move |said: &[u8]| if said.is_empty() { Vec::new() } else { words.as_bytes().to_vec() }
    };
    assert_eq!(told_of(line("echo:Unknown command: \"~\"\r\nok\r\n")), Fault::NoBoard);
    assert_eq!(told_of(line("Grbl 1.1f ['$' for help]\r\nerror:1\r\n")), Fault::NoBoard);
    assert_eq!(told_of(|_| Vec::new()), Fault::NoBoard);
    let mut dice = Dice(7);
    assert_eq!(told_of(|_| (0..3).map(|_| dice.roll() as u8).collect()), Fault::NoBoard);
    // A line whose two ends are joined gives back every frame, and acknowledges none.
    assert_eq!(told_of(<[u8]>::to_vec), Fault::Unanswered("identify"));
}

/// A setup with one thing of each kind.
fn whole() -> Setup {
    let pin = |n: usize| Pin::new(&format!("gpio{n}"));
    Setup {
        pulsed: vec![Pulsed { pin: pin(21), cycle_s: 0.001, watch_s: None }],
        voltages: vec![Pin::new("ADC")],
        buttons: vec![pin(30)],
        drivers: vec![DriverWire { rx: pin(40), tx: pin(40) }],
        ..setup()
    }
}

/// Tells a host of a board whose words were changed, and makes sure that it was not configured.
fn refused(change: impl FnOnce(&mut World)) -> String {
    let mut world = World::new(9, Faults::default(), whole(), Options::default());
    change(&mut world);
    world.fake.words.pack();
    let fault = world.wait_fault();
    assert!(!world.fake.ran.contains_key("allocate_oids"), "{fault}: it was configured");
    fault.to_string()
}

/// Words of boards without which Kerf does not drive one.
const NEEDED: [&str; 40] = [
    "get_uptime",
    "get_clock",
    "get_config",
    "emergency_stop",
    "clear_shutdown",
    "allocate_oids",
    "config_trsync",
    "trsync_start",
    "trsync_set_timeout",
    "trsync_trigger",
    "config_stepper",
    "queue_step",
    "set_next_step_dir",
    "reset_step_clock",
    "stepper_get_position",
    "stepper_stop_on_trigger",
    "config_endstop",
    "endstop_home",
    "endstop_query_state",
    "config_digital_out",
    "queue_digital_out",
    "config_pwm_out",
    "queue_pwm_out",
    "config_analog_in",
    "query_analog_in",
    "config_buttons",
    "buttons_add",
    "buttons_query",
    "buttons_ack",
    "config_tmcuart",
    "tmcuart_send",
    "uptime",
    "config",
    "shutdown",
    "trsync_state",
    "stepper_position",
    "endstop_state",
    "analog_in_state",
    "buttons_state",
    "tmcuart_response",
];

#[test]
fn an_old_dictionary_is_told_before_anything_is_configured() {
    for name in NEEDED {
        let why = refused(|world| {
            let words = &mut world.fake.words;
            words.commands.retain(|form| form.name != name);
            words.responses.retain(|form| form.name != name);
        });
        assert!(why.contains(&format!("`{name}`")) && why.contains("flash a newer one"), "{why}");
    }
    // Of another version: with one field more, or one less.
    let why = refused(|world| {
        let forms = &mut world.fake.words.commands;
        let form = forms.iter_mut().find(|form| form.name == "endstop_home").unwrap();
        form.text = form.text.replace(" trigger_reason=%c", "");
    });
    assert!(why.contains("`endstop_home` with") && why.contains("trigger_reason"), "{why}");
    let why = refused(|world| {
        let forms = &mut world.fake.words.commands;
        let form = forms.iter_mut().find(|form| form.name == "config_stepper").unwrap();
        form.text += " more=%u";
    });
    assert!(why.contains("`config_stepper`"), "{why}");
}

#[test]
fn a_cable_that_is_pulled_at_whatever_moment_is_told_and_all_stands() {
    for tenth in 0..30 {
        let mut world = World::new(tenth, Faults::default(), setup(), Options::default());
        let motion = Motion::waves(2000.0, 4.0);
        let pulled_s = 0.02 + f64::from(tenth as u32) * 0.1;
        let mut feed = None;
        while world.now_s < pulled_s {
            world.pass();
            let is_ready = world.news.iter().any(|news| matches!(news, News::Ready { .. }));
            if is_ready && feed.is_none() {
                world.host.set_output(0, 1.0, world.now_s).expect("a board");
                feed = Some(world.begin(&motion, &[]));
            }
            if let Some(feed) = &mut feed {
                world.feed(&motion, feed);
            }
        }
        world.there.faults.drop = 1.0;
        world.back.faults.drop = 1.0;
        world.pass_for(0.6);
        let stood: Vec<i64> = world.fake.steppers.values().map(|it| it.position).collect();
        let fault = world.wait_fault();
        assert!(fault.is_silent(), "pulled at {pulled_s} s: {fault}");
        world.pass_for(1.0);
        let stands: Vec<i64> = world.fake.steppers.values().map(|it| it.position).collect();
        assert_eq!(stood, stands, "pulled at {pulled_s} s: nothing moves by itself");
        assert!(world.fake.outputs.values().all(|output| output.value == 0), "{pulled_s} s");
        // What comes back is another session's: the old one says no more.
        world.there.faults.drop = 0.0;
        world.back.faults.drop = 0.0;
        world.pass_for(1.0);
        assert_eq!(world.news.iter().filter(|it| matches!(it, News::Fault(_))).count(), 0);
        assert!(world.fake.steppers.is_empty() || !world.fake.is_stepping(0));
    }
}
