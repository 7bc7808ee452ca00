//! The driver against a controller that is none.
#![allow(clippy::unwrap_used)]

use kerf_driver_grbl::Grbl;
use kerf_driver_grbl::fake::Fake;
use kerf_machine::driver::conformance::CASES;
use kerf_machine::driver::{
    Axes, Driver, Garbled, Link, LinkState, Order, Reply, Sent, Signal, Told, Trouble, Wired,
};

/// A driver on a line with a fake controller at its other end.
struct Wire {
    grbl: Grbl,
    fake: Fake,
    /// Begins before the clock of whoever looks.
    ahead_s: f64,
    /// The line is cut.
    cut: bool,
    /// The wire back is broken: the controller hears and is not heard.
    deaf: bool,
    /// Every so many bytes of the controller one is spoiled.
    spoils_every: Option<usize>,
    told: usize,
}

impl Wire {
    fn new(fake: Fake) -> Self {
        let (grbl, ahead_s) = (Grbl::new(), 5.0);
        let mut wire =
            Self { grbl, fake, ahead_s, cut: false, deaf: false, spoils_every: None, told: 0 };
        for tick in 0..500 {
            wire.carry(-5.0 + 0.01 * f64::from(tick));
        }
        wire
    }

    fn carry(&mut self, now_s: f64) {
        let now_s = now_s + self.ahead_s;
        let bytes = self.grbl.speak(now_s);
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
            let seen = (case.check)(&mut Wire::new(Fake::default())).err()?;
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
    while now_s < 6.0 {
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
    link.order(to(400.0, 0.0));
    let lost_s = run(&mut link, 0.0, |link, now_s| link.driver().deaf = now_s > 1.0);
    assert_eq!(link.state(), LinkState::Lost);
    for tick in 0..100 {
        link.driver().carry(lost_s + 0.1 * f64::from(tick));
    }
    let fake = &link.driver().fake;
    assert_eq!(fake.spindle(), None, "it was held, and its spindle turns");
    assert!(fake.position().0[0] < 200.0, "it moved on: {:?}", fake.position());
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
    wire.fake.pins("PD");
    wire.signal(Signal::Ask, 0.1);
    let replies = wire.replies(0.2);
    let inputs = replies.iter().filter(|reply| matches!(reply, Ok(Reply::Input { on: true, .. })));
    assert_eq!(inputs.count(), 2, "{replies:?}");
}
