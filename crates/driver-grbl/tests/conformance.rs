//! The driver against a fake controller: the list that every driver has to hold, streaming, stops, probing.

use crate::wire::{Wire, run, to};
use kerf_driver_grbl::Grbl;
use kerf_driver_grbl::fake::{Board, Fake};
use kerf_machine::driver::conformance::CASES;
use kerf_machine::driver::{Axes, Driver, Link, LinkNews, LinkState, Order, Signal, Wired, way_mm};

#[test]
fn grbl_holds_what_every_driver_has_to_hold() {
    let failed: Vec<String> = CASES
        .iter()
        .filter_map(|case| {
            let board = Board::grbl_with("VM");
            let seen = (case.check)(&mut Wire::new(Fake::of(board, &[]))).err()?;
            Some(format!("{}: {seen}", case.name))
        })
        .collect();
    assert!(failed.is_empty(), "{failed:#?}");
}

#[test]
fn a_row_of_short_moves_is_made_without_a_stand() {
    let mut link = Link::new(Wire::new(Fake::default()));
    let moves = 400;
    for n in 1..=moves {
        let angle = f64::from(n) * 0.05;
        link.order(to(20.0 * angle.sin(), 20.0 - 20.0 * angle.cos()));
    }
    let took_s = run(&mut link, 0.0, |_, _| {});
    let fake = &link.driver().fake;
    assert_eq!((fake.stands(), fake.overflowed), (1, 0), "it stands at the end alone");
    let planned_s = fake.way_mm() / 40.0;
    assert!(took_s < planned_s + 1.0, "{took_s} s for {planned_s} s of way");
    assert!((fake.way_mm() - 400.0).abs() < 0.5, "{}", fake.way_mm());
}

#[test]
fn the_receive_buffer_never_overflows() {
    let mut link = Link::new(Wire::new(Fake::default()));
    for n in 0..300 {
        let x = f64::from(n % 2) * 0.123_456;
        link.order(to(100.0 + x, -0.001 * f64::from(n)));
    }
    run(&mut link, 0.0, |_, _| {});
    assert_eq!(link.driver().fake.overflowed, 0);
    assert!(link.is_idle() && link.state() == LinkState::Up);
}

#[test]
fn a_stop_on_the_way_keeps_the_place_and_switches_off() {
    let mut link = Link::new(Wire::new(Fake::default()));
    link.order(Order::Output { line: 1, on: true });
    link.order(to(100.0, 0.0));
    let mut now_s = 0.0;
    while now_s < 1.0 {
        now_s += 0.005;
        link.poll(now_s);
    }
    assert!(link.driver().fake.spindle().is_some());
    link.stop(now_s);
    for _ in 0..400 {
        now_s += 0.005;
        link.driver().signal(Signal::Ask, now_s);
        link.poll(now_s);
    }
    let Wire { grbl, fake, .. } = link.driver();
    assert_eq!(grbl.trouble(), None, "a reset that comes too early is an alarm");
    assert_eq!(fake.spindle(), None);
    let (told, true_place) = (grbl.stands().unwrap().position, fake.position());
    assert!((told.0[0] - true_place.0[0]).abs() < 0.001 && told.0[0] > 5.0 && told.0[0] < 95.0);
    assert!(link.driver().grbl.begin_anew());
    link.restart(now_s);
    link.order(to(0.0, 0.0));
    run(&mut link, now_s, |_, _| {});
    assert!(link.driver().fake.position().0[0].abs() < 0.001);
}

/// Somebody does something at the controller while it moves; what it waits for is told, and the move goes on.
#[track_caller]
fn goes_on(board: Board, told: &str, does: impl Fn(&mut Fake, f64)) {
    let mut link = Link::new(Wire::new(Fake::of(board, &[])));
    link.order(to(100.0, 0.0));
    let mut seen = Vec::new();
    run(&mut link, 0.0, |link, now_s| {
        does(&mut link.driver().fake, now_s);
        seen.extend(link.driver().grbl.waits());
    });
    assert_eq!((link.state(), link.driver().fake.position().0[0]), (LinkState::Up, 100.0));
    assert_eq!(link.driver().grbl.trouble(), None);
    assert!(seen.iter().any(|why| why.contains(told)), "{seen:?}");
    assert_eq!(link.driver().grbl.waits(), None);
}

#[test]
fn what_somebody_does_at_a_controller_does_not_end_the_job() {
    let at = |now_s: f64, s: f64| (now_s - s).abs() < 0.0026;
    for board in [Board::grbl(), Board::hal(0), Board::fluid()] {
        goes_on(board.clone(), "door is open", |fake, now_s| {
            if now_s > 0.8 {
                fake.pins(if now_s < 4.0 { "D" } else { "" });
            }
            if at(now_s, 5.0) {
                fake.cycle_start();
            }
        });
        goes_on(board.clone(), "held", |fake, now_s| {
            if at(now_s, 0.8) {
                fake.hear(b"!", now_s + 5.0);
            }
            if at(now_s, 6.0) {
                fake.cycle_start();
            }
        });
        goes_on(board.clone(), "tool", |fake, now_s| {
            fake.says = (now_s > 1.0 && now_s < 2.0).then(|| "Tool".into());
        });
        goes_on(board, "held", |fake, now_s| {
            fake.says = (now_s > 1.0 && now_s < 2.0).then(|| "Hold:3".into());
        });
    }
}

/// Kerf was killed, and the controller makes what it had: it is stopped before it is asked about itself.
#[test]
fn a_controller_that_still_moves_is_stopped_and_then_asked() {
    let moving = || {
        let mut fake = Fake::default();
        fake.hear(b"$X\nM3S1000\nG53G1X400F1200\n", 0.0);
        fake.speak(1.0);
        fake
    };
    let mut wire = Wire {
        grbl: Grbl::new(),
        fake: moving(),
        ahead_s: 5.0,
        cut: false,
        gone: None,
        stalled: false,
        to_spoil: None,
        chance: 1,
        deaf: false,
        spoils_every: None,
        garbles: None,
        garbles_told: None,
        told: 0,
    };
    let run = |wire: &mut Wire, from_s: f64| {
        for tick in 0..400 {
            wire.carry(from_s + 0.01 * f64::from(tick));
        }
    };
    run(&mut wire, -3.0);
    assert!(
        wire.grbl.facts().is_none() && wire.fake.spindle().is_some(),
        "it tells nothing while it moves"
    );
    wire.grbl.signal(Signal::Stop, 6.0);
    run(&mut wire, 1.0);
    let place = wire.fake.position();
    assert_eq!((wire.fake.spindle(), wire.grbl.trouble()), (None, None));
    assert!(wire.grbl.facts().is_some() && place.0[0] > 1.0 && place.0[0] < 300.0, "{place:?}");
    assert!(way_mm(wire.grbl.stands().unwrap().position, place) < 0.001);
}

/// Goes down 20 mm at a speed until the probe changes; returns where it stands, what it told of the contact, and whether
/// it told the input.
fn probes(fake: Fake, speed_mm_s: f64, active: bool) -> (Link<Wire>, Option<Axes>, Vec<bool>) {
    let mut link = Link::new(Wire::new(fake));
    let from = link.driver().fake.position();
    let to = Axes::xyz(from.0[0], from.0[1], from.0[2] + if active { -20.0 } else { 20.0 });
    link.order(Order::Probe { to, speed_mm_s, active });
    let (mut now_s, mut told) = (0.0, Vec::new());
    while now_s < 20.0 {
        now_s += 0.005;
        for told_now in link.poll(now_s) {
            if let LinkNews::Input { line: 1, on } = told_now {
                assert!(on != active || link.is_idle(), "it is told when it stands there");
                told.push(on);
            }
        }
    }
    let contact = link.driver().grbl.contact();
    (link, contact, told)
}

#[test]
fn a_probe_stands_at_the_place_of_its_contact() {
    for (unit, board) in [(0.0, Board::grbl()), (1.0, Board::hal(0)), (0.0, Board::fluid())] {
        for speed_mm_s in [2.54, 12.7] {
            let mut fake = Fake::of(board.clone(), &[(13, unit)]);
            (fake.plate_mm, fake.offsets.systems[0]) = (Some(-9.824), Axes::xyz(3.0, 4.0, 5.0));
            let (mut link, contact, told) = probes(fake, speed_mm_s, true);
            let z = link.driver().fake.position().0[2];
            assert!((z + 9.824).abs() < 0.0025, "{z} at {speed_mm_s} mm/s");
            assert_eq!((contact.map(|it| it.0[2]), told), (Some(z), vec![true]));
            assert_eq!(link.state(), LinkState::Up);
            // What follows goes on from there.
            link.order(Order::Move { to: Axes::xyz(0.0, 0.0, 0.0), speed_mm_s: 10.0 });
            run(&mut link, 20.0, |_, _| {});
            assert_eq!(link.driver().fake.position(), Axes::default());
            assert_eq!(link.driver().grbl.trouble(), None);
        }
    }
}

#[test]
fn a_probe_without_a_contact_comes_to_its_end() {
    let (mut link, contact, told) = probes(Fake::default(), 10.0, true);
    assert_eq!((link.driver().fake.position().0[2], contact, told), (-20.0, None, Vec::new()));
    let mut fake = Fake::default();
    fake.plate_mm = Some(0.5);
    let (mut link, contact, told) = probes(fake, 10.0, false);
    let z = link.driver().fake.position().0[2];
    assert!((z - 0.5).abs() < 0.001 && contact.is_some(), "{z}");
    assert_eq!(told.last(), Some(&false), "it was there when it was connected");
}

/// At the rate of a serial line, and with the planner of a board, short chords are made as fast as they can be: 2,000
/// chords of 0.157 mm at 83 mm/s, which are 530 lines a second. The 15 moves of grbl are a braking distance of 2.4 mm, from
/// which it stands at 43 mm/s: it goes no faster, and takes 7.2 s.
#[test]
fn the_planner_of_a_controller_is_kept_filled_at_the_rate_of_its_line() {
    for (board, most_s) in [(Board::hal(0), 4.2), (Board::grbl(), 7.3)] {
        let mut fake = Fake::of(board, &[(110, 5000.0), (111, 5000.0)]);
        fake.rate_bytes_s = Some(11_520.0);
        let mut link = Link::new(Wire::new(fake));
        let chords = 2000;
        for n in 1..=chords {
            let angle = f64::from(n) / f64::from(chords) * std::f64::consts::TAU;
            let to = Axes::xyz(50.0 * angle.cos() - 50.0, 50.0 * angle.sin(), 0.0);
            link.order(Order::Move { to, speed_mm_s: 100.0 });
        }
        let (mut begun_s, mut least) = (None, usize::MAX);
        let over_s = run(&mut link, 0.0, |link, now_s| {
            let fake = &link.driver().fake;
            if fake.way_mm() > 0.0 {
                begun_s.get_or_insert(now_s);
            }
            // Once it was filled, and until the last lines are on their way.
            if fake.way_mm() > 100.0 && fake.lines.len() < 1800 {
                least = least.min(fake.planner().0);
            }
        });
        let (fake, took_s) = (&link.driver().fake, over_s - begun_s.unwrap());
        let (way_mm, holds) = (fake.way_mm(), fake.planner().1);
        assert_eq!((fake.stands(), fake.overflowed), (1, 0));
        assert!(took_s < most_s && (way_mm - 314.16).abs() < 0.1, "{took_s} s, {way_mm} mm");
        assert!(least >= holds / 2, "{least} of {holds}");
    }
}
