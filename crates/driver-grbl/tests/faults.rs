//! Faults of the line and of the controller: nobody is left with a wrong place.

use crate::wire::{Chance, Wire, run, to};
use kerf_driver_grbl::fake::{Board, Fake};
use kerf_machine::driver::{
    Axes, Driver, Link, LinkNews, LinkState, Order, Signal, Trouble, Wired,
};

#[test]
fn alarms_and_errors_are_told_in_words() {
    let mut link = Link::new(Wire::new(Fake::default()));
    link.order(to(100.0, 0.0));
    let mut hit = false;
    run(&mut link, 0.0, |link, now_s| {
        if now_s > 0.5 && !std::mem::replace(&mut hit, true) {
            link.driver().fake.hits_limit();
        }
    });
    assert!(matches!(link.state(), LinkState::Refused(1, _)), "{:?}", link.state());
    let trouble = link.driver().grbl.trouble().unwrap().clone();
    assert!(matches!(trouble, Trouble::Alarm { number: 1, lost: true, .. }), "{trouble:?}");
    assert!(trouble.to_string().contains("limit switch"), "{trouble}");

    let limited = Fake::new(&[(20, 1.0)]);
    let mut link = Link::new(Wire::new(limited));
    link.order(to(10.0, 0.0));
    run(&mut link, 0.0, |_, _| {});
    let trouble = link.driver().grbl.trouble().unwrap().to_string();
    assert!(trouble.contains("outside its travel"), "{trouble}");
}

#[test]
fn garbled_reports_are_counted_and_a_cut_line_is_lost() {
    let mut link = Link::new(Wire::new(Fake::default()));
    link.driver().spoils_every = Some(97);
    link.order(to(30.0, 0.0));
    let mut now_s = 0.0;
    while now_s < 0.6 {
        now_s += 0.005;
        link.poll(now_s);
    }
    assert!(link.troubles().garbled > 0, "{:?}", link.troubles());
    link.driver().cut = true;
    let mut told = Vec::new();
    while now_s < 14.0 {
        now_s += 0.005;
        told.extend(link.poll(now_s));
    }
    assert_eq!(told, [LinkNews::State(LinkState::Lost)]);
}

#[test]
fn a_controller_that_is_not_heard_any_more_is_switched_off_all_the_same() {
    let mut link = Link::new(Wire::new(Fake::default()));
    link.order(Order::Spindle { rpm: 1000.0 });
    link.order(Order::Output { line: 1, on: true });
    link.order(to(600.0, 0.0));
    let lost_s = run(&mut link, 0.0, |link, now_s| link.driver().deaf = now_s > 1.0);
    assert_eq!(link.state(), LinkState::Lost);
    for tick in 0..100 {
        link.driver().carry(lost_s + 0.1 * f64::from(tick));
    }
    let fake = &link.driver().fake;
    assert_eq!(fake.spindle(), None, "it was held, and its spindle turns");
    assert!(fake.position().0[0] < 590.0, "it moved on: {:?}", fake.position());
}

#[test]
fn an_answer_that_is_lost_ends_the_work() {
    let mut link = Link::new(Wire::new(Fake::default()));
    link.order(to(1.0, 0.0));
    link.driver().spoils_every = Some(1);
    let mut now_s = 0.0;
    link.poll(now_s);
    link.driver().spoils_every = None;
    while now_s < 6.0 && link.state() == LinkState::Up {
        now_s += 0.005;
        link.poll(now_s);
    }
    let trouble = link.driver().grbl.trouble().unwrap().to_string();
    assert!(trouble.contains("did not come through"), "{trouble}");
}

#[test]
fn an_alarm_whose_line_is_lost_is_seen_in_the_next_report() {
    let mut link = Link::new(Wire::new(Fake::default()));
    link.order(to(100.0, 0.0));
    run(&mut link, 0.0, |link, now_s| {
        if now_s > 0.5 {
            link.driver().fake.says = Some("Alarm:1".into());
        }
    });
    let trouble = link.driver().grbl.trouble().cloned();
    assert!(matches!(trouble, Some(Trouble::Alarm { number: 1, lost: true, .. })), "{trouble:?}");
}

/// A digit of a line is another one when it arrives: nobody sees that but in where the machine stands.
#[test]
fn a_machine_that_stands_elsewhere_than_it_was_told_to_is_in_trouble() {
    let mut link = Link::new(Wire::new(Fake::default()));
    link.driver().garbles = Some((b'7', b'3'));
    link.order(to(17.0, 0.0));
    run(&mut link, 0.0, |_, _| {});
    for tick in 0..100 {
        link.poll(20.0 + 0.01 * f64::from(tick));
        link.driver().signal(Signal::Ask, 20.0 + 0.01 * f64::from(tick));
    }
    let trouble = link.driver().grbl.trouble().map(ToString::to_string).unwrap_or_default();
    assert!(trouble.contains("stands elsewhere"), "{trouble}");
}

/// The comma of `Bf:15,128` is lost: a planner of 15128 moves would hold some for ever.
#[test]
fn one_garbled_report_does_not_make_the_planner_larger() {
    let mut link = Link::new(Wire::new(Fake::default()));
    link.driver().garbles_told = Some(("Bf:15,", "Bf:15"));
    for x in [3.0, 8.0, 2.0] {
        link.order(to(x, 0.0));
        let took_s = run(&mut link, 0.0, |_, _| {});
        assert!(took_s < 10.0, "nothing is told to be made");
    }
}

/// Silence of the line, and of whoever looks at it, is no end while the controller has lost nothing.
#[test]
fn ten_seconds_of_silence_end_no_job() {
    for sleeps in [false, true] {
        let mut link = Link::new(Wire::new(Fake::default()));
        for n in 1..=40 {
            link.order(to(10.0 * f64::from(n), 0.0));
        }
        let (mut now_s, mut slept) = (0.0, false);
        while !link.is_idle() && now_s < 60.0 {
            now_s += 0.005;
            let silent = now_s > 3.0 && now_s < 12.5;
            if sleeps && silent && !std::mem::replace(&mut slept, true) {
                now_s = 12.5;
            }
            // The line keeps what comes meanwhile, as that of a computer that sleeps.
            link.driver().stalled = !sleeps && silent;
            link.poll(now_s);
        }
        assert_eq!((link.state(), link.driver().grbl.trouble()), (LinkState::Up, None), "{sleeps}");
        assert_eq!(link.driver().fake.position().0[0], 400.0);
    }
}

/// One fault at one moment of a job: the job ends where it should on the path on which it should, or somebody is told.
#[test]
fn no_fault_of_the_line_or_the_controller_ends_in_a_wrong_place() {
    let (mut well, mut told) = (0, 0);
    for seed in 1..=200_u64 {
        let mut chance = Chance(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15));
        let board = [Board::grbl(), Board::hal(0), Board::fluid()][(seed % 3) as usize].clone();
        let mut link = Link::new(Wire::new(Fake::of(board, &[])));
        let mut way_mm = 0.0;
        let mut from = Axes::default();
        for n in 1..=60 {
            let place = Axes::xyz(
                f64::from(n % 7) * 6.321,
                f64::from(n % 5) * 4.567,
                f64::from(n % 3) * -1.5,
            );
            way_mm += kerf_machine::driver::way_mm(from, place);
            from = place;
            link.order(Order::Move { to: place, speed_mm_s: 60.0 });
        }
        let fault_s = 0.05 + chance.below(8000) as f64 / 1000.0;
        let kind = chance.below(11);
        let mut due = true;
        let over_s = run(&mut link, 0.0, |link, now_s| {
            if !due || now_s < fault_s {
                return;
            }
            let wire = link.driver();
            due = match kind {
                0..=3 => wire.to_spoil.replace((true, kind)).is_some(),
                4..=7 => wire.to_spoil.replace((false, kind - 4)).is_some(),
                8 => {
                    wire.fake.begins_anew();
                    false
                }
                9 => {
                    wire.fake.sleeps();
                    false
                }
                _ => {
                    wire.fake.hear(&[0x18], now_s + 5.0);
                    false
                }
            };
            wire.chance = chance.0;
        });
        for tick in 0..300 {
            let now_s = over_s + 0.01 * f64::from(tick);
            link.driver().signal(Signal::Ask, now_s);
            link.poll(now_s);
        }
        let trouble = link.driver().grbl.trouble().cloned();
        // Noise that is `!` holds the machine, as a pendant does.
        let waits = link.driver().grbl.waits().is_some();
        let silent = link.state() == LinkState::Up && trouble.is_none() && !waits;
        let fake = &link.driver().fake;
        if silent {
            let (place, way) = (fake.position(), fake.way_mm());
            assert!(
                kerf_machine::driver::way_mm(place, from) < 0.01,
                "seed {seed}, fault {kind}: {place:?} and not {from:?}"
            );
            assert!(
                (way - way_mm).abs() < 0.5,
                "seed {seed}, fault {kind}: {way} mm and not {way_mm}"
            );
            well += 1;
        } else {
            told += 1;
        }
    }
    assert!(well > 60 && told > 60, "{well} went on, {told} were told");
}
