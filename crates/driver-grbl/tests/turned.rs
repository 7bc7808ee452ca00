//! Overrides, rapid moves, and what a board tells of itself beside numbers.

use crate::wire::{Wire, run, to};
use kerf_driver_grbl::fake::{Board, Fake};
use kerf_machine::driver::{
    Axes, Driver, Link, LinkState, Order, Override, Shares, Signal, Wired, ZeroChange, way_mm,
};

#[track_caller]
fn turns(signal: Signal, expected: [u32; 3]) {
    let mut wire = Wire::new(Fake::default());
    wire.signal(signal, 0.1);
    drop(wire.replies(0.2));
    let Fake { override_percent, rapid_percent, spindle_percent, .. } = wire.fake;
    assert_eq!([override_percent, rapid_percent, spindle_percent], expected, "{signal:?}");
}

#[test]
fn overrides_are_those_of_the_controller() {
    turns(Signal::Feed(133), [133, 100, 100]);
    turns(Signal::Feed(7), [10, 100, 100]);
    turns(Signal::Override(Override::Rapid(50)), [100, 50, 100]);
    turns(Signal::Override(Override::Rapid(99)), [100, 50, 100]);
    turns(Signal::Override(Override::Rapid(3)), [100, 25, 100]);
    turns(Signal::Override(Override::Spindle(87)), [100, 100, 87]);
    turns(Signal::Override(Override::Spindle(200)), [100, 100, 200]);
}

/// Looks at a controller for a while.
fn looks(wire: &mut Wire, from_s: f64) {
    for tick in 0..40 {
        let now_s = from_s + 0.02 * f64::from(tick);
        wire.signal(Signal::Ask, now_s);
        drop(wire.replies(now_s));
    }
}

#[test]
fn shares_that_somebody_turns_at_a_controller_are_heard() {
    let mut wire = Wire::new(Fake::default());
    assert_eq!(wire.grbl.shares(), Some(Shares::default()));
    wire.signal(Signal::Feed(80), 0.1);
    assert_eq!(wire.grbl.shares(), Some(Shares { feed: 80, ..Shares::default() }), "at once");
    // A pendant: feed 10 % less, rapids 50 %, spindle 10 % more.
    wire.fake.hear(&[0x92, 0x96, 0x9A], 6.0);
    looks(&mut wire, 1.0);
    assert_eq!(wire.grbl.shares(), Some(Shares { feed: 70, rapid: 50, spindle: 110 }));
}

#[test]
fn a_report_that_is_older_than_what_was_turned_tells_nothing_of_it() {
    let mut wire = Wire::new(Fake::default());
    wire.signal(Signal::Feed(80), 1.0);
    wire.grbl.hear(b"<Idle|MPos:0,0,0|Bf:15,128|FS:0,0|Ov:100,100,100>\r\n", 6.1);
    assert_eq!(wire.grbl.shares().unwrap().feed, 80);
    wire.grbl.hear(b"<Idle|MPos:0,0,0|Bf:15,128|FS:0,0|Ov:100,100,100>\r\n", 6.4);
    assert_eq!(wire.grbl.shares().unwrap().feed, 100);
}

#[test]
fn zero_points_of_a_controller_are_read_written_and_seen_to_change() {
    for unit in [0.0, 1.0] {
        let mut fake = Fake::of(Board::hal(0), &[(10, 511.0), (13, unit)]);
        fake.offsets.systems[0] = Axes::xyz(100.0, 50.0, -20.0);
        let mut wire = Wire::new(fake);
        let zero = |wire: &Wire, name: &str| {
            wire.grbl.zeros().iter().find(|zero| zero.name == name).map(|zero| zero.at)
        };
        let near = |at: Option<Axes>, to: Axes| way_mm(at.unwrap(), to) < 0.01;
        assert!(near(zero(&wire, "G54"), Axes::xyz(100.0, 50.0, -20.0)));
        assert!(near(zero(&wire, "G59.3"), Axes::default()) && wire.grbl.zeros()[0].holds);
        // Somebody at a pendant.
        wire.fake.hear(b"G10L2P1X7Y8Z9\n", 6.0);
        looks(&mut wire, 1.0);
        assert!(near(zero(&wire, "G54"), Axes::xyz(7.0, 8.0, 9.0)), "{:?}", wire.grbl.zeros());
        wire.fake.hear(b"G92X2\n", 7.0);
        looks(&mut wire, 2.0);
        assert!(near(zero(&wire, "G92"), Axes::xyz(-9.0, 0.0, 0.0)), "{:?}", wire.grbl.zeros());
        let lies = ZeroChange::Lies([1.0, -2.0, 3.5, 0.0, 0.0, 0.0].map(Some));
        assert!(wire.grbl.keeps_zero("G59.1", lies));
        assert!(wire.grbl.keeps_zero("G92", ZeroChange::Gone));
        assert!(!wire.grbl.keeps_zero("G28", lies));
        assert!(!wire.grbl.keeps_zero("G92", lies) && !wire.grbl.keeps_zero("TLO", lies));
        assert!(!wire.grbl.keeps_zero("G54", ZeroChange::Lies([None; 6])));
        looks(&mut wire, 3.0);
        assert!(near(zero(&wire, "G59.1"), Axes::xyz(1.0, -2.0, 3.5)));
        assert_eq!(
            (wire.fake.offsets.shift, zero(&wire, "G92")),
            (Axes::default(), Some(Axes::default()))
        );
        assert_eq!(wire.grbl.trouble(), None);
    }
}

#[test]
fn a_zero_point_is_where_the_machine_stands_and_the_one_that_holds_outlives_a_stop() {
    let mut fake = Fake::of(Board::hal(0), &[(10, 511.0)]);
    fake.offsets.shift = Axes::xyz(2.0, 0.0, 0.0);
    fake.offsets.tool_mm = 4.0;
    let mut link = Link::new(Wire::new(fake));
    link.order(to(30.0, 40.0));
    run(&mut link, 0.0, |_, _| {});
    let wire = link.driver();
    assert_eq!(wire.grbl.zeros().last().unwrap().at, Axes::xyz(0.0, 0.0, 4.0));
    assert!(wire.grbl.keeps_zero("G55", ZeroChange::Holds));
    let reads = [Some(5.0), None, Some(-1.5), None, None, None];
    assert!(wire.grbl.keeps_zero("G55", ZeroChange::Reads(reads)));
    assert!(!wire.grbl.knows_zeros());
    looks(wire, 20.0);
    assert!(wire.grbl.knows_zeros());
    // X reads 30 - 23 - 2, Z 0 + 2.5 - 4; Y stays.
    assert_eq!(wire.fake.offsets.systems[1], Axes::xyz(23.0, 0.0, -2.5));
    let holds = |wire: &Wire| {
        let zeros = wire.grbl.zeros().iter();
        zeros.filter(|zero| zero.holds).map(|zero| zero.name.clone()).collect::<Vec<_>>()
    };
    assert_eq!(holds(wire), ["G55", "G92", "TLO"]);
    wire.signal(Signal::Stop, 22.0);
    looks(wire, 22.0);
    assert_eq!(wire.fake.offsets.chosen, 0, "a reset chooses G54");
    assert!(wire.grbl.begin_anew());
    looks(wire, 24.0);
    assert_eq!((wire.fake.offsets.chosen, holds(wire)[0].as_str()), (1, "G55"));
}

const fn jog(x: f64, speed_mm_s: f64) -> Order {
    Order::Jog { to: Axes::xyz(x, 0.0, 0.0), speed_mm_s }
}

/// Returns the lines that jogs and a cut become, and how long they take.
fn made(signals: &[Signal], orders: &[Order]) -> (Vec<String>, f64) {
    let mut link = Link::new(Wire::new(Fake::default()));
    let before = link.driver().fake.lines.len();
    signals.iter().for_each(|signal| link.driver().signal(*signal, 0.0));
    for order in orders {
        link.order(*order);
    }
    let took_s = run(&mut link, 0.0, |_, _| {});
    assert_eq!(link.state(), LinkState::Up, "{:?}", link.driver().fake.lines);
    let said = link.driver().fake.lines[before..].iter();
    let lines = said.filter(|line| !["$#", "$G"].contains(&line.as_str())).cloned().collect();
    (lines, took_s)
}

#[test]
fn a_jog_as_fast_as_the_controller_goes_is_a_rapid_move() {
    let orders = [jog(10.0, 100.0), jog(20.0, 120.0), to(30.0, 0.0), jog(40.0, 50.0)];
    let (lines, _) = made(&[Signal::Feed(200)], &orders);
    assert_eq!(lines, ["G53G0X10", "G53X20", "G53G1X30F2400", "G53X40F1500"]);
    let (lines, _) = made(&[Signal::Override(Override::Rapid(50))], &orders[2..]);
    assert_eq!(lines, ["G53G1X30F2400", "G53X40F1500"]);
}

#[test]
fn a_rapid_move_follows_its_override_and_no_other() {
    let orders = [jog(200.0, 100.0)];
    let (_, plain_s) = made(&[Signal::Feed(20)], &orders);
    let (_, slow_s) = made(&[Signal::Override(Override::Rapid(25))], &orders);
    assert!((2.0..3.0).contains(&plain_s), "{plain_s}");
    assert!((8.0..9.5).contains(&slow_s), "{slow_s}");
}

#[test]
fn a_board_that_tells_the_line_that_it_makes_is_sent_numbers() {
    let mut link = Link::new(Wire::new(Fake::of(Board::hal(0), &[(10, 511.0)])));
    for n in 1..=40 {
        link.order(to(f64::from(n), 0.0));
    }
    run(&mut link, 0.0, |_, _| {});
    let lines = &link.driver().fake.lines;
    let numbered = lines.iter().filter(|line| line.starts_with('N')).count();
    assert_eq!(numbered, 5, "{lines:?}");
    assert!(lines.contains(&"N8G53X8".to_owned()), "{lines:?}");
    assert_eq!(link.state(), LinkState::Up);
}

#[test]
fn errors_and_alarms_are_told_in_the_words_of_the_board() {
    let said = |board: Board, spoils: &dyn Fn(&mut Wire)| {
        let mut link = Link::new(Wire::new(Fake::of(board, &[])));
        spoils(link.driver());
        link.order(to(10.0, 0.0));
        run(&mut link, 0.0, |_, _| {});
        link.driver().grbl.trouble().map(ToString::to_string).unwrap_or_default()
    };
    let garbles: &dyn Fn(&mut Wire) = &|wire| wire.garbles = Some((b'G', b'M'));
    assert_eq!(said(Board::hal(0), garbles), "error 20: This board has no such word");
    assert_eq!(said(Board::grbl(), garbles), "error 20: it does not have this command");
    let hits: &dyn Fn(&mut Wire) = &|wire| wire.fake.hits_limit();
    assert_eq!(said(Board::hal(0), hits), "alarm 1: A switch at the end of an axis closed");
}
