//! Tests of what a connection orders and tells, with a controller that says what it is told to say.

use super::Connection;
use kerf_machine::driver::{
    ControllerState, Driver, Facts, Garbled, Order, Reply, Sent, Signal, Trouble, Wired, way_mm,
};
use kerf_machine::{Going, Machine};
use kerf_motion::{Move, Mover, Path, Plan, planner};
use kerf_program::{Arc, At, Axes, Feed, Line, MoveKind, Settings};
use kerf_transport::LineError;
use std::cell::RefCell;
use std::rc::Rc;
use std::time::Duration;

/// Greatest distance of a chord from its arc, and of merged lines from theirs, mm.
const TOLERANCE_MM: f64 = 0.01;

/// An arc of a controller lies so far from that of the plan at most, mm.
const UNROUND_MM: f64 = 0.002;

/// Orders that came, and replies that are due.
#[derive(Default)]
struct Record {
    orders: Vec<Order>,
    due: Vec<Reply>,
    /// Each order is done as soon as it comes.
    makes: bool,
}

/// A controller that records its orders.
struct Fake {
    record: Rc<RefCell<Record>>,
    facts: Facts,
}

impl Driver for Fake {
    fn send(&mut self, sent: &Sent, _: f64) {
        let mut record = self.record.borrow_mut();
        record.orders.push(sent.order);
        if record.makes {
            record.due.push(Reply::Done(sent.ticket));
        }
    }

    fn signal(&mut self, _: Signal, _: f64) {}

    fn replies(&mut self, _: f64) -> Vec<Result<Reply, Garbled>> {
        self.record.borrow_mut().due.drain(..).map(Ok).collect()
    }
}

impl Wired for Fake {
    fn hear(&mut self, _: &[u8], _: f64) {}

    fn speak(&mut self, _: f64) -> Vec<u8> {
        Vec::new()
    }

    fn facts(&self) -> Option<&Facts> {
        Some(&self.facts)
    }

    fn stands(&self) -> Option<ControllerState> {
        None
    }

    fn trouble(&self) -> Option<&Trouble> {
        None
    }

    fn begin_anew(&mut self) -> bool {
        true
    }
}

/// A line on which nothing comes.
struct Silent;

impl kerf_transport::Line for Silent {
    fn read(&mut self, _: &mut [u8], _: Duration) -> Result<usize, LineError> {
        Ok(0)
    }

    fn write(&mut self, _: &[u8]) -> Result<(), LineError> {
        Ok(())
    }
}

fn connected(facts: Facts) -> (Connection, Rc<RefCell<Record>>) {
    let record = Rc::<RefCell<Record>>::default();
    let fake = Fake { record: record.clone(), facts };
    let mut connection =
        Connection::open("fake", Box::new(fake), Box::new(Silent)).expect("it answers");
    connection.begin();
    connection.begin_plan();
    (connection, record)
}

fn planned(moves: Vec<Move>) -> Plan {
    let mut planner = planner(&Settings::default());
    moves.into_iter().for_each(|made| planner.push(made));
    planner.finish().expect("moves")
}

const fn going(plan: &Plan, index: usize, until: usize) -> Going<'_> {
    Going { plan, index, t0_s: 0.0, until, part: 1.0, watches: &[] }
}

#[test]
fn an_input_that_changed_on_the_way_of_a_move_is_told_before_its_end() {
    let (mut connection, record) = connected(Facts::default());
    let to = Line { kind: MoveKind::Cut, to: Axes::xyz(10.0, 0.0, 0.0), feed: Feed::Path(10.0) };
    let mut mover = Mover::new(Axes::default(), &Settings::default());
    let plan = planned(mover.line(At::default(), &to).into_iter().collect());
    let (going, end_s) = (going(&plan, 0, 1), plan.duration_s());
    let first = connection.advance(&going, 0.0, end_s);
    assert!(first.reached_s < end_s && first.input.is_none());
    // Both are heard in one look: the end of the move is known when it is asked for next.
    record.borrow_mut().due.extend([Reply::Input { line: 1, on: true }, Reply::Done(1)]);
    connection.look();
    let news = connection.advance(&going, 0.0, end_s);
    assert_eq!((news.reached_s >= end_s, news.input), (true, Some((1, true))));
    assert_eq!(connection.advance(&going, 0.0, end_s).input, None);
}

/// A way from place to place: of a plan, or as it was sent.
struct Stretch {
    from: Axes,
    to: Axes,
    /// Centre in X and Y, and swept angle.
    arc: Option<([f64; 2], f64)>,
}

impl Stretch {
    fn of(made: &Move) -> Self {
        let arc = match made.path {
            Path::Arc { centre, sweep_rad, .. } => Some((centre, sweep_rad)),
            _ => None,
        };
        Self { from: made.from, to: made.to, arc }
    }

    /// Places along it, a share apart each.
    fn at(&self, share: f64) -> Axes {
        let mut at = self.from.zip(self.to, |a, b| a + (b - a) * share);
        if let Some(([cx, cy], sweep_rad)) = self.arc {
            let (x, y) = (self.from.0[0] - cx, self.from.0[1] - cy);
            let (sin, cos) = (sweep_rad * share).sin_cos();
            (at.0[0], at.0[1]) = (cx + x * cos - y * sin, cy + x * sin + y * cos);
        }
        at
    }

    fn length_mm(&self) -> f64 {
        let Some(([cx, cy], sweep_rad)) = self.arc else { return way_mm(self.from, self.to) };
        let radius_mm = (self.from.0[0] - cx).hypot(self.from.0[1] - cy);
        (radius_mm * sweep_rad).hypot(self.to.0[2] - self.from.0[2])
    }

    /// The share of it at which a place lies beside it.
    fn share(&self, place: Axes) -> f64 {
        let Some(([cx, cy], sweep_rad)) = self.arc else {
            let (way, off) = (self.to.minus(self.from).0, place.minus(self.from).0);
            let [along, square]: [f64; 2] =
                [off, way].map(|v| v.iter().zip(way).map(|(a, b)| a * b).sum());
            return if square > 0.0 { f64::clamp(along / square, 0.0, 1.0) } else { 0.0 };
        };
        let angle = |at: Axes| (at.0[1] - cy).atan2(at.0[0] - cx);
        let turned = (angle(place) - angle(self.from)) * sweep_rad.signum();
        turned.rem_euclid(std::f64::consts::TAU) / sweep_rad.abs()
    }

    /// Distance of a place from it, mm: from the place beside it, or one of its ends.
    fn far_mm(&self, place: Axes) -> f64 {
        let beside = self.share(place);
        let shares = [0.0, 1.0, if beside <= 1.0 { beside } else { 0.0 }];
        shares.map(|share| way_mm(self.at(share), place)).into_iter().fold(f64::INFINITY, f64::min)
    }
}

/// The ways that were ordered, from a place on.
fn ordered(orders: &[Order], mut from: Axes) -> Vec<Stretch> {
    let mut ways = Vec::new();
    for order in orders {
        let Some(to) = order.to() else { continue };
        let arc = match order {
            Order::Arc { centre, sweep_rad, .. } => Some((*centre, *sweep_rad)),
            _ => None,
        };
        ways.push(Stretch { from, to, arc });
        from = to;
    }
    ways
}

/// Numbers between 0 and 1 that are the same each time.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }
}

/// Many moves: long and short lines that bend little or much, arcs and helices of many sizes.
fn moves(numbers: &mut Numbers, count: usize) -> Vec<Move> {
    let mut mover = Mover::new(Axes::default(), &Settings::default());
    let (mut from, mut heading, mut made) = (Axes::default(), 0.0_f64, Vec::new());
    while made.len() < count {
        let (kind, feed) =
            (MoveKind::Cut, Feed::Path(if numbers.next() < 0.05 { 12.0 } else { 30.0 }));
        let next = if numbers.next() < 0.7 {
            heading += numbers.between(-0.05, 0.05) * if numbers.next() < 0.1 { 40.0 } else { 1.0 };
            let length = if numbers.next() < 0.8 { 0.3 } else { 9.0 } * numbers.next() + 0.01;
            let z = if numbers.next() < 0.1 { numbers.between(-0.2, 0.2) } else { 0.0 };
            let way = Axes::xyz(length * heading.cos(), length * heading.sin(), z);
            let to = from.plus(way);
            mover.line(At::default(), &Line { kind, to, feed })
        } else {
            let (radius, turn) = (numbers.between(0.05, 60.0), numbers.between(-6.2, 6.2));
            let centre = [from.0[0] - radius * heading.cos(), from.0[1] - radius * heading.sin()];
            let (sin, cos) = (heading + turn).sin_cos();
            let z = from.0[2] + if numbers.next() < 0.5 { numbers.between(-1.0, 1.0) } else { 0.0 };
            let to = Axes::xyz(centre[0] + radius * cos, centre[1] + radius * sin, z);
            heading += turn;
            let (chords, small) = (32, false);
            mover
                .arc(At::default(), &Arc { kind, centre, sweep_rad: turn, to, feed, chords, small })
        };
        from = next.as_ref().map_or(from, |made| made.to);
        made.extend(next);
    }
    made
}

/// Nothing that is sent lies farther from the path than the tolerance, and nothing of the path from what is sent.
#[test]
fn what_is_sent_stays_within_the_tolerance_of_the_path() {
    for (seed, arcs) in [(1, true), (2, false), (3, true)] {
        let facts = Facts { arcs, arc_tolerance_mm: TOLERANCE_MM, ..Facts::default() };
        let (mut connection, record) = connected(facts);
        record.borrow_mut().makes = true;
        let plan = planned(moves(&mut Numbers(seed), 150));
        let count = plan.moves().len();
        for index in 0..count {
            let end_s = plan.span_s(index).1;
            while connection.advance(&going(&plan, index, count), 0.0, end_s).reached_s < end_s {}
        }
        let sent = ordered(&record.borrow().orders, plan.moves()[0].from);
        let path: Vec<Stretch> = plan.moves().iter().map(Stretch::of).collect();
        assert!(!arcs || sent.iter().any(|way| way.arc.is_some()), "arcs are sent as such");
        within(&sent, &path, "what is sent from the path");
        within(&path, &sent, "the path from what is sent");
    }
}

/// Every eighth of each way lies within the tolerance of the others.
#[track_caller]
fn within(ways: &[Stretch], others: &[Stretch], words: &str) {
    for way in ways {
        for eighth in 0..=8 {
            let at = way.at(f64::from(eighth) / 8.0);
            let mut near = f64::INFINITY;
            for other in others {
                if way_mm(other.from, at) - other.length_mm() < near {
                    near = near.min(other.far_mm(at));
                }
            }
            assert!(near <= TOLERANCE_MM + UNROUND_MM, "{words}: {near} mm at {at:?}");
        }
    }
}
