//! Settings and boards: understood, or refused with the way to mend them.

use crate::wire::{Wire, run, to};
use kerf_driver_grbl::fake::{Board, Fake};
use kerf_machine::driver::{
    Axes, Changed, Driver, Link, LinkState, Order, Reply, Signal, Trouble, Wired, way_mm,
};

#[test]
fn a_locked_controller_is_homed() {
    let mut link = Link::new(Wire::new(Fake::new(&[(22, 1.0)])));
    assert!(matches!(link.driver().grbl.trouble(), Some(Trouble::Locked { .. })));
    assert!(link.driver().grbl.facts().unwrap().homes);
    link.order(Order::Home);
    link.order(to(-10.0, -10.0));
    run(&mut link, 0.0, |_, _| {});
    assert_eq!((link.state(), link.driver().grbl.trouble()), (LinkState::Up, None));
    let place = link.driver().fake.position();
    assert_eq!((place.0[0], place.0[1]), (-10.0, -10.0));
}

#[test]
fn what_it_told_of_itself_is_known() {
    let mut wire = Wire::new(Fake::new(&[(20, 1.0)]));
    let facts = wire.grbl.facts().unwrap();
    assert_eq!((facts.axes, &*facts.name), (3, "grbl 1.1h.20190825"));
    assert_eq!(facts.speed_mm_s[2], Some(50.0));
    assert_eq!(facts.travel_mm[0], Some((-600.0, 0.0)));
    assert!(wire.fake.lines.contains(&"$10=3".to_owned()), "{:?}", wire.fake.lines);
    assert_eq!(wire.grbl.changed(), Some(Changed { number: 10, was: 1, is: 3 }));
    wire.fake.pins("PD");
    wire.signal(Signal::Ask, 0.1);
    let replies = wire.replies(0.2);
    let inputs = replies.iter().filter(|reply| matches!(reply, Ok(Reply::Input { on: true, .. })));
    assert_eq!(inputs.count(), 1, "a door is no input: {replies:?}");
}

/// Every board, with places told in every way that can be set.
fn ways_to_tell() -> Vec<(Board, Vec<(u16, f64)>)> {
    let masks =
        [(Board::grbl(), 0.0), (Board::grbl(), 2.0), (Board::hal(0), 508.0), (Board::fluid(), 2.0)];
    let masks = masks.into_iter().chain([(Board::hal(4), 511.0 - 17.0)]);
    masks
        .flat_map(|(board, mask)| {
            [0.0, 1.0].map(|unit| (board.clone(), vec![(10, mask), (13, unit)]))
        })
        .collect()
}

#[test]
fn a_place_of_the_workpiece_without_its_zero_is_no_place() {
    for (board, settings) in ways_to_tell() {
        let mut fake = Fake::of(board, &settings);
        fake.offsets.systems[0] = Axes::xyz(100.0, 50.0, -20.0);
        let mut link = Link::new(Wire::new(fake));
        let stands = link.driver().grbl.stands().unwrap().position;
        assert!(way_mm(stands, Axes::default()) < 0.001, "{settings:?}: {stands:?}");
        link.order(to(7.0, 3.0));
        run(&mut link, 0.0, |_, _| {});
        let (told, real) =
            (link.driver().grbl.stands().unwrap().position, link.driver().fake.position());
        assert_eq!((real.0[0], real.0[1]), (7.0, 3.0), "{settings:?}");
        assert!(way_mm(told, real) < 0.0013, "{settings:?}: {told:?}");
    }
}

/// A controller that moves when it is connected takes no setting: it tells its zero in one of its next reports.
#[test]
fn a_controller_that_hides_its_place_is_driven_once_it_has_told_it() {
    let mut fake = Fake::of(Board::hal(0), &[(10, 511.0 - 1.0)]);
    fake.offsets.systems[0] = Axes::xyz(100.0, 50.0, -20.0);
    fake.keeps_settings = true;
    let wire = Wire::new(fake);
    let stands = wire.grbl.stands().unwrap().position;
    assert!(way_mm(stands, Axes::default()) < 0.001, "{stands:?}");
    let mut fake = Fake::of(Board::hal(0), &[(10, 508.0 - 16.0)]);
    fake.keeps_settings = true;
    let wire = Wire::new(fake);
    assert_eq!(wire.grbl.facts().map(|facts| facts.axes), None, "nobody knows where it is");
}

#[test]
fn what_was_changed_in_a_controller_is_put_back() {
    let mut wire = Wire::new(Fake::of(Board::hal(0), &[(10, 508.0)]));
    let changed = wire.grbl.changed().unwrap();
    assert_eq!((changed.was, wire.fake.is_set_to(10)), (508, 511.0));
    let mut now_s = 0.0;
    while !wire.grbl.puts_back(changed) {
        now_s += 0.01;
        assert!(now_s < 1.0, "it does not come to that");
        wire.carry(now_s);
    }
    assert_eq!(wire.fake.is_set_to(10), 508.0);
}

#[track_caller]
fn unfit(fake: Fake, why: &str) {
    let trouble = Wire::new(fake).grbl.trouble().cloned();
    let said = trouble.as_ref().map(ToString::to_string).unwrap_or_default();
    assert!(matches!(trouble, Some(Trouble::Unfit { .. })) && said.contains(why), "{trouble:?}");
}

#[test]
fn a_controller_that_cannot_be_driven_as_it_is_set_is_refused() {
    unfit(Fake::of(Board::hal(0), &[(32, 2.0)]), "$32=0");
    unfit(Fake::of(Board::hal(0), &[(100, 0.0)]), "$100");
    let mut asleep = Fake::default();
    asleep.sleeps();
    unfit(asleep, "it sleeps");
    let mut checking = Fake::default();
    checking.checks();
    unfit(checking, "$C");
    let mut board = Board::hal(0);
    board.tells.push("[AXS:4:XYZU]".into());
    unfit(Fake::of(board, &[]), "axes");
}

#[track_caller]
fn travels(board: Board, settings: &[(u16, f64)], expected: (f64, f64)) {
    let settings: Vec<_> = settings
        .iter()
        .copied()
        .chain(
            [(20, 1.0), (22, 1.0)]
                .into_iter()
                .filter(|(n, _)| settings.iter().all(|(m, _)| m != n)),
        )
        .collect();
    let mut link = Link::new(Wire::new(Fake::of(board, &settings)));
    assert_eq!(link.driver().grbl.facts().unwrap().travel_mm[0], Some(expected), "{settings:?}");
    // It goes home, and to both ends of what it tells.
    link.order(Order::Home);
    link.order(to(expected.0, expected.1.min(0.0)));
    link.order(to(expected.1, expected.1.min(0.0)));
    run(&mut link, 0.0, |_, _| {});
    assert_eq!(link.state(), LinkState::Up, "{settings:?}: {:?}", link.driver().grbl.trouble());
    assert_eq!(link.driver().fake.position().0[0], expected.1);
}

#[test]
fn home_is_at_either_end_of_the_travel() {
    travels(Board::grbl(), &[], (-600.0, 0.0));
    travels(Board::grbl(), &[(23, 7.0)], (-600.0, 0.0));
    travels(Board::grbl_with("VZ"), &[(23, 1.0)], (0.0, 600.0));
    travels(Board::grbl_with("VZ"), &[], (-600.0, 0.0));
    travels(Board::hal(0), &[(22, 9.0), (23, 1.0)], (0.0, 600.0));
    travels(Board::hal(0), &[(22, 9.0)], (-600.0, 0.0));
    travels(Board::hal(0), &[(22, 1.0), (23, 1.0)], (-600.0, 0.0));
}

#[test]
fn a_board_has_the_outputs_that_it_tells() {
    let outputs =
        |board, settings: &[_]| Wire::new(Fake::of(board, settings)).grbl.facts().unwrap().outputs;
    assert_eq!(outputs(Board::grbl(), &[]), 0b11, "mist is an option of grbl");
    assert_eq!(outputs(Board::grbl_with("VM"), &[]), 0b111);
    assert_eq!(outputs(Board::hal(0), &[]), 0b111);
    assert_eq!(outputs(Board::hal(2), &[]), 0b1_1111);
    assert_eq!(
        outputs(Board::hal(20), &[]),
        0b1111_1111_1111,
        "no line that has a name is one of them"
    );
    assert_eq!(outputs(Board::fluid(), &[]), 0b111);
    assert_eq!(outputs(Board::fluid(), &[(30, 0.0)]), 0b110, "a spindle that never turns");
    assert_eq!(outputs(Board::hal(0), &[(32, 1.0)]), 0b110, "a beam");
    let mut link = Link::new(Wire::new(Fake::of(Board::hal(2), &[])));
    link.order(Order::Output { line: 5, on: true });
    run(&mut link, 0.0, |_, _| {});
    assert_eq!((link.driver().fake.aux, link.state()), (0b10, LinkState::Up));
}
