//! The driver against a fake bridge: the list that every driver has to hold, pieces, stops, probing, what its
//! panel does.

use crate::wire::{Wire, run};
use kerf_driver_linuxcnc::fake::Fake;
use kerf_machine::driver::conformance::CASES;
use kerf_machine::driver::{AXES, Axes, Link, LinkState, Order, Trouble, Wired, ZeroChange};

fn to(x: f64, y: f64) -> Order {
    Order::Move { to: Axes::xyz(x, y, 0.0), speed_mm_s: 40.0 }
}

#[test]
fn linuxcnc_holds_what_every_driver_has_to_hold() {
    let failed: Vec<String> = CASES
        .iter()
        .filter_map(|case| {
            let seen = (case.check)(&mut Wire::new(Fake::default())).err()?;
            Some(format!("{}: {seen}", case.name))
        })
        .collect();
    assert!(failed.is_empty(), "{failed:#?}");
}

#[test]
fn moves_that_come_together_are_one_piece_without_a_stand() {
    let mut link = Link::new(Wire::new(Fake::default()));
    for n in 1..=2000 {
        let angle = f64::from(n) / 2000.0 * std::f64::consts::TAU;
        link.order(to(20.0 * angle.cos() - 20.0, 20.0 * angle.sin()));
    }
    run(&mut link, 0.0, |_, _| {});
    let fake = &link.driver().fake;
    assert_eq!((fake.pieces, fake.stands(), fake.made.len()), (1, 1, 2000));
    assert!(link.is_idle() && link.state() == LinkState::Up);
}

#[test]
fn a_stop_on_the_way_keeps_the_place_and_switches_off() {
    let mut link = Link::new(Wire::new(Fake::default()));
    link.order(Order::Spindle { rpm: 9000.0 });
    link.order(Order::Output { line: 1, on: true });
    link.order(to(100.0, 0.0));
    let mut now_s = 0.0;
    while now_s < 1.0 {
        now_s += 0.005;
        link.poll(now_s);
    }
    assert_eq!(link.driver().fake.spindle(), Some(9000.0));
    link.stop(now_s);
    for _ in 0..200 {
        now_s += 0.005;
        link.poll(now_s);
    }
    let Wire { driver, fake, .. } = link.driver();
    let (told, stands) = (driver.stands().unwrap().position, fake.position());
    assert_eq!((fake.spindle(), driver.trouble()), (None, None));
    assert!((told.0[0] - stands.0[0]).abs() < 1e-4 && told.0[0] > 5.0 && told.0[0] < 95.0);
    assert!(link.driver().driver.begin_anew());
    link.restart(now_s);
    link.order(to(0.0, 0.0));
    run(&mut link, now_s, |_, _| {});
    assert!(link.driver().fake.position().0[0].abs() < 1e-4);
}

#[test]
fn a_probe_stands_at_the_place_of_its_contact() {
    let mut fake = Fake::default();
    fake.plate_mm = Some(-7.25);
    let mut link = Link::new(Wire::new(fake));
    link.order(Order::Probe { to: Axes::xyz(0.0, 0.0, -20.0), speed_mm_s: 5.0, active: true });
    run(&mut link, 0.0, |_, _| {});
    let Wire { driver, fake, .. } = link.driver();
    let contact = driver.contact().unwrap();
    assert!(
        (contact.0[2] + 7.25).abs() < 0.02 && (fake.position().0[2] - contact.0[2]).abs() < 1e-4
    );
    link.order(to(0.0, 0.0));
    run(&mut link, 10.0, |_, _| {});
    assert_eq!((link.state(), link.driver().fake.position()), (LinkState::Up, Axes::default()));
}

#[test]
fn what_somebody_does_at_its_panel_is_told_and_the_move_goes_on() {
    let mut link = Link::new(Wire::new(Fake::default()));
    link.order(to(100.0, 0.0));
    let mut seen = Vec::new();
    run(&mut link, 0.0, |link, now_s| {
        link.driver().fake.panel_pauses((0.8..2.0).contains(&now_s));
        seen.extend(link.driver().driver.waits());
    });
    assert!(seen.contains(&"it is held at its own panel"), "{seen:?}");
    assert_eq!((link.state(), link.driver().fake.position().0[0]), (LinkState::Up, 100.0));
}

/// Something ends a move at 0.8 s; returns why.
fn ended_by(does: impl Fn(&mut Wire)) -> (Trouble, Axes) {
    let mut link = Link::new(Wire::new(Fake::default()));
    link.order(to(100.0, 0.0));
    let mut done = false;
    run(&mut link, 0.0, |link, now_s| {
        if now_s > 0.8 && !std::mem::replace(&mut done, true) {
            does(link.driver());
        }
    });
    assert!(matches!(link.state(), LinkState::Refused(1, _)), "{:?}", link.state());
    let place = link.driver().fake.position();
    (link.driver().driver.trouble().unwrap().clone(), place)
}

#[test]
fn what_ends_a_program_is_told() {
    let check = |does: &dyn Fn(&mut Wire), words: &str| {
        let (trouble, place) = ended_by(does);
        assert!(trouble.to_string().contains(words), "{trouble}");
        assert!(place.0[0] < 95.0, "{place:?}");
    };
    check(&|wire| wire.fake.presses_estop(), "emergency stop was pressed");
    check(&|wire| wire.fake.panel_aborts(), "elsewhere");
    check(&|wire| wire.spoils_to = Some(3), "garbled");
}

#[test]
fn a_garbled_line_back_is_left_out_and_the_next_one_tells_the_same() {
    let mut link = Link::new(Wire::new(Fake::default()));
    link.order(to(50.0, 0.0));
    let mut next_s = 0.5;
    run(&mut link, 0.0, |link, now_s| {
        if now_s > next_s {
            (link.driver().spoils_from, next_s) = (Some(7), next_s + 0.1);
        }
    });
    assert!(link.troubles().garbled > 3);
    assert_eq!((link.state(), link.driver().fake.position().0[0]), (LinkState::Up, 50.0));
}

#[test]
fn what_is_locked_takes_orders_when_it_is_switched_on_and_at_home() {
    let mut fake = Fake::default();
    (fake.estop, fake.on, fake.homed) = (true, false, false);
    let mut link = Link::new(Wire::new(fake));
    let locked = |link: &mut Link<Wire>| link.driver().driver.trouble().map(Trouble::to_string);
    assert!(locked(&mut link).unwrap().contains("emergency stop"));
    link.order(Order::Unlock);
    let now_s = run(&mut link, 0.0, |_, _| {});
    assert!(locked(&mut link).unwrap().contains("home it first"));
    link.order(Order::Home);
    let now_s = run(&mut link, now_s, |_, _| {});
    assert_eq!(locked(&mut link), None);
    link.order(to(5.0, 0.0));
    run(&mut link, now_s, |_, _| {});
    assert_eq!(link.driver().fake.position().0[0], 5.0);
}

#[test]
fn zero_points_are_changed_at_rest_and_one_that_was_set_at_its_panel_is_seen() {
    let mut link = Link::new(Wire::new(Fake::default()));
    let g55 = |link: &mut Link<Wire>| {
        let zeros = link.driver().driver.zeros();
        zeros.iter().find(|zero| zero.name == "G55").map(|zero| (zero.at.0[0], zero.holds))
    };
    link.order(to(10.0, 0.0));
    link.poll(0.0);
    let keeps = |link: &mut Link<Wire>, change| link.driver().driver.keeps_zero("G55", change);
    let mut reads = [None; AXES];
    reads[0] = Some(2.5);
    assert!(!keeps(&mut link, ZeroChange::Reads(reads)), "a move is under way");
    let mut now_s = run(&mut link, 0.0, |_, _| {});
    let mut passes = |link: &mut Link<Wire>| {
        (0..40).for_each(|_| {
            now_s += 0.005;
            link.poll(now_s);
        });
    };
    for (change, expected) in
        [(ZeroChange::Reads(reads), (7.5, false)), (ZeroChange::Holds, (7.5, true))]
    {
        assert!(keeps(&mut link, change) && !link.driver().driver.knows_zeros());
        passes(&mut link);
        assert!(link.driver().driver.knows_zeros());
        assert_eq!(g55(&mut link), Some(expected));
    }
    link.driver().fake.panel("G10L2P2X-4");
    passes(&mut link);
    assert_eq!(g55(&mut link), Some((-4.0, true)));
}
