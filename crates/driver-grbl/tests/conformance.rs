//! The driver against a controller that is none.
#![allow(clippy::unwrap_used)]

use kerf_driver_grbl::Grbl;
use kerf_driver_grbl::fake::{Board, Fake};
use kerf_machine::driver::conformance::CASES;
use kerf_machine::driver::{
    Axes, Changed, Driver, Garbled, Link, LinkState, Order, Reply, Sent, Signal, Told, Trouble,
    Wired, way_mm,
};

/// A driver on a line with a fake controller at its other end.
struct Wire {
    grbl: Grbl,
    fake: Fake,
    /// Begins before the clock of whoever looks.
    ahead_s: f64,
    /// The line is cut.
    cut: bool,
    /// Nothing comes through either way for a while, and nothing is lost.
    stalled: bool,
    /// The wire back is broken: the controller hears and is not heard.
    deaf: bool,
    /// Every so many bytes of the controller one is spoiled.
    spoils_every: Option<usize>,
    /// Every one of these bytes arrives as another one.
    garbles: Option<(u8, u8)>,
    told: usize,
}

impl Wire {
    fn new(fake: Fake) -> Self {
        let (grbl, ahead_s) = (Grbl::new(), 5.0);
        let mut wire = Self {
            grbl,
            fake,
            ahead_s,
            cut: false,
            stalled: false,
            deaf: false,
            spoils_every: None,
            garbles: None,
            told: 0,
        };
        for tick in 0..500 {
            wire.carry(-5.0 + 0.01 * f64::from(tick));
        }
        wire
    }

    fn carry(&mut self, now_s: f64) {
        let now_s = now_s + self.ahead_s;
        if self.stalled {
            return;
        }
        let mut bytes = self.grbl.speak(now_s);
        if let Some((from, to)) = self.garbles {
            bytes.iter_mut().filter(|byte| **byte == from).for_each(|byte| *byte = to);
        }
        if self.cut {
            return;
        }
        self.fake.hear(&bytes, now_s);
        let mut bytes = self.fake.speak(now_s);
        for byte in &mut bytes {
            self.told += 1;
            if self.spoils_every.is_some_and(|every| self.told.is_multiple_of(every)) {
                *byte ^= 0x11;
            }
        }
        if !self.deaf {
            self.grbl.hear(&bytes, now_s);
        }
    }
}

impl Driver for Wire {
    fn send(&mut self, sent: &Sent, now_s: f64) {
        self.grbl.send(sent, now_s);
        self.carry(now_s);
    }

    fn signal(&mut self, signal: Signal, now_s: f64) {
        self.grbl.signal(signal, now_s + self.ahead_s);
        self.carry(now_s);
    }

    fn replies(&mut self, now_s: f64) -> Vec<Result<Reply, Garbled>> {
        self.carry(now_s);
        self.grbl.replies(now_s)
    }

    fn window(&self) -> usize {
        self.grbl.window()
    }

    fn quiet(&self) -> bool {
        self.grbl.quiet()
    }
}

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

fn to(x: f64, y: f64) -> Order {
    Order::Move { to: Axes::xyz(x, y, 0.0), speed_mm_s: 40.0 }
}

/// Runs until a link has nothing left to do, or is not up any more.
fn run(link: &mut Link<Wire>, from_s: f64, mut look: impl FnMut(&mut Link<Wire>, f64)) -> f64 {
    let mut now_s = from_s;
    while !link.is_idle() && link.state() == LinkState::Up && now_s < from_s + 600.0 {
        now_s += 0.005;
        link.poll(now_s);
        look(link, now_s);
    }
    now_s
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
    assert_eq!(told, [Told::State(LinkState::Lost)]);
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
        fake.offset = Axes::xyz(100.0, 50.0, -20.0);
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
    fake.offset = Axes::xyz(100.0, 50.0, -20.0);
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
    assert_eq!(outputs(Board::fluid(), &[]), 0b111);
    assert_eq!(outputs(Board::fluid(), &[(30, 0.0)]), 0b110, "a spindle that never turns");
    assert_eq!(outputs(Board::hal(0), &[(32, 1.0)]), 0b110, "a beam");
    let mut link = Link::new(Wire::new(Fake::of(Board::hal(2), &[])));
    link.order(Order::Output { line: 5, on: true });
    run(&mut link, 0.0, |_, _| {});
    assert_eq!((link.driver().fake.aux, link.state()), (0b10, LinkState::Up));
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
        stalled: false,
        deaf: false,
        spoils_every: None,
        garbles: None,
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
            if let Told::Input { line: 1, on } = told_now {
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
            (fake.plate_mm, fake.offset) = (Some(-9.824), Axes::xyz(3.0, 4.0, 5.0));
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
