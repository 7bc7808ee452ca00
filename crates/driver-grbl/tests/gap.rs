//! A line that is gone for a while: nothing is lost, or the work ends where the machine stands.

use crate::wire::{Chance, Wire, run, to};
use kerf_driver_grbl::fake::{Board, Fake};
use kerf_machine::driver::{
    Axes, Driver, Hold, Link, LinkState, Order, Signal, Trouble, Wired, way_mm,
};

/// Sixty moves, no two of which end at the same place, with the length of their way and its end.
fn zigzag(link: &mut Link<Wire>) -> (f64, Axes) {
    let (mut all_mm, mut from) = (0.0, Axes::default());
    for n in 1..=60 {
        let [x, y, z] = [(7, 6.321), (5, 4.567), (3, -1.5)].map(|(of, mm)| f64::from(n % of) * mm);
        let place = Axes::xyz(x, y, z);
        all_mm += way_mm(from, place);
        from = place;
        if n % 9 == 4 {
            link.order(Order::Spindle { rpm: 1000.0 });
            link.order(Order::Output { line: 1, on: n % 2 == 0 });
        }
        link.order(Order::Move { to: place, speed_mm_s: 60.0 });
    }
    (all_mm, from)
}

/// Takes the line away from a moment on for a time, in the middle of whatever is said.
fn gap(link: &mut Link<Wire>, at_s: f64, lasts_s: f64, passes: usize) {
    let (mut due, mut back) = (true, false);
    run(link, 0.0, |link, now_s| {
        if due && now_s > at_s {
            (due, back) = (false, true);
            link.driver().loses(passes);
        }
        if back && now_s > at_s + lasts_s {
            back = false;
            link.driver().is_back(now_s);
        }
    });
}

#[test]
fn a_line_that_was_gone_loses_nothing_or_tells_where_the_machine_stands() {
    let (mut well, mut told) = (0, 0);
    for seed in 1..=120_u64 {
        let mut chance = Chance(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15));
        let board = [Board::grbl(), Board::hal(0), Board::fluid()][(seed % 3) as usize].clone();
        let mut link = Link::new(Wire::new(Fake::of(board, &[])));
        let (all_mm, end) = zigzag(&mut link);
        let at_s = 0.05 + chance.below(8000) as f64 / 1000.0;
        let lasts_s = 0.1 + chance.below(6000) as f64 / 1000.0;
        gap(&mut link, at_s, lasts_s, chance.below(60) as usize);
        let Wire { grbl, fake, .. } = link.driver();
        let (place, way) = (fake.position(), fake.way_mm());
        if let Some(trouble) = grbl.trouble() {
            assert!(matches!(trouble, Trouble::Gap { .. }), "seed {seed}: {trouble}");
            let stands = grbl.stands().unwrap().position;
            assert!(way_mm(stands, place) < 0.002, "seed {seed}: {stands:?} and not {place:?}");
            told += 1;
            continue;
        }
        assert!(way_mm(place, end) < 0.01, "seed {seed}: {place:?} and not {end:?}");
        assert!((way - all_mm).abs() < 0.01, "seed {seed}: {way} mm and not {all_mm}");
        assert_eq!(link.state(), LinkState::Up, "seed {seed}");
        well += 1;
    }
    assert!(well > 100, "{well} went on, {told} were told");
}

/// Back and forth between two places: nobody knows how often it went before the line was gone.
#[test]
fn a_place_that_several_moves_end_at_is_no_answer() {
    let mut link = Link::new(Wire::new(Fake::default()));
    for n in 0..80 {
        link.order(to(if n % 2 == 0 { 4.0 } else { 0.0 }, 0.0));
    }
    gap(&mut link, 1.0, 2.0, 17);
    let trouble = link.driver().grbl.trouble().unwrap().to_string();
    assert!(trouble.contains("where several of the moves"), "{trouble}");
}

/// A controller that was reset while nobody looked counts from zero, and has forgotten its feed.
#[test]
fn a_controller_that_was_reset_behind_a_gap_is_found_out() {
    for greets in [false, true] {
        let mut link = Link::new(Wire::new(Fake::default()));
        link.order(to(10.0, 0.0));
        link.order(to(0.0, 0.0));
        for _ in 0..40 {
            link.order(to(30.0, 0.0));
            link.order(to(0.0, 0.0));
        }
        let mut step = 0;
        run(&mut link, 0.0, |link, now_s| match step {
            0 if now_s > 0.8 => {
                link.driver().loses(0);
                step = 1;
            }
            1 if now_s > 2.0 && !greets => {
                link.driver().fake.begins_anew();
                step = 2;
            }
            1 | 2 if now_s > 3.0 => {
                link.driver().is_back(now_s);
                if greets {
                    link.driver().fake.begins_anew();
                }
                step = 3;
            }
            _ => {}
        });
        let trouble = link.driver().grbl.trouble().unwrap().to_string();
        assert!(trouble.contains("reset"), "{trouble}");
    }
}

/// A hold that was ordered is none at the controls of the machine; that of a pendant is, and a pendant ends either.
#[test]
fn a_hold_that_was_ordered_is_told_from_one_of_a_pendant() {
    let mut link = Link::new(Wire::new(Fake::default()));
    link.order(Order::Spindle { rpm: 1000.0 });
    link.order(Order::Output { line: 1, on: true });
    link.order(to(100.0, 0.0));
    let mut seen: Vec<(Hold, Option<&str>)> = Vec::new();
    let mut step = 0;
    run(&mut link, 0.0, |link, now_s| {
        let moments = [0.8, 1.8, 2.2, 3.2, 3.4, 4.4];
        if step < moments.len() && now_s > moments[step] {
            let wire = link.driver();
            match step {
                0 | 4 => wire.signal(Signal::Hold, now_s),
                2 => wire.fake.hear(b"!", now_s + 5.0),
                3 | 5 => wire.fake.hear(b"~", now_s + 5.0),
                _ => wire.signal(Signal::Resume, now_s),
            }
            step += 1;
        }
        if matches!(link.driver().grbl.hold(), Hold::Stands) {
            assert!(link.driver().fake.spindle().is_some(), "a hold switches nothing off");
        }
        let now = (link.driver().grbl.hold(), link.driver().grbl.waits());
        if seen.last() != Some(&now) {
            seen.push(now);
        }
    });
    let held = Some("it is held: its own button has it go on");
    let expected = [
        (Hold::None, None),
        (Hold::Ordered, None),
        (Hold::Stands, None),
        (Hold::None, held),
        (Hold::None, None),
        (Hold::None, held),
        (Hold::None, None),
        (Hold::Ordered, None),
        (Hold::Stands, None),
        (Hold::WentOn, None),
    ];
    assert_eq!(seen, expected);
    assert_eq!(link.driver().fake.position().0[0], 100.0);
    assert_eq!(link.driver().fake.stands(), 4);
}
