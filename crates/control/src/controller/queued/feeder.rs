//! Plans that are made, cut into pieces of steps, each with the tail that brings the machine to rest.
//!
//! Times are seconds of machine time; clocks are ticks of the board.

use super::beam::Follow;
use super::height::Height;
use kerf_driver_klipper::mailbox::Set;
use kerf_driver_klipper::queue::{Piece, Step};
use kerf_machine::{Going, Lift};
use kerf_motion::{Leg, Mark, Rest, Stepper};
use kerf_program::{Axes, Axis};
use std::collections::VecDeque;

/// Length of a piece, seconds.
const PIECE_S: f64 = 0.02;
/// Length of a piece in which Z follows an input or a reading, seconds: what is told meanwhile changes the next one.
const FOLLOWED_S: f64 = 0.005;
/// Times closer than this are the same, seconds: the rounding of a sum.
const SAME_S: f64 = 1e-9;

/// Clocks of machine time while a board is in motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    /// A moment of machine time, and the clock then.
    pub from: (f64, f64),
    /// Ticks a second.
    pub rate: f64,
}

impl Scale {
    /// Clock at a moment.
    pub fn at(&self, t_s: f64) -> f64 {
        self.from.1 + (t_s - self.from.0) * self.rate
    }

    /// Moment of a clock.
    pub fn moment(&self, clock: u64) -> f64 {
        self.from.0 + (clock as f64 - self.from.1) / self.rate
    }
}

/// A plan at its moment of machine time.
#[derive(Clone, Debug)]
struct Followed {
    t0_s: f64,
    leg: Leg,
}

impl Followed {
    fn span_s(&self) -> [f64; 2] {
        self.leg.span_s().map(|t_s| self.t0_s + t_s)
    }
}

/// The way from plans to pieces.
#[derive(Clone, Debug)]
pub struct Feeder {
    /// Plans of which something is not handed over, in order.
    followed: VecDeque<Followed>,
    /// Another piece of plan follows those that are there.
    follows: bool,
    /// The plan that was taken last is known by its moves and its end.
    last: (usize, f64),
    stepper: Stepper,
    per_unit: Axes,
    /// Axes of the motors.
    motors: Vec<Axis>,
    /// The moment up to which motion was handed over.
    pub handed_s: f64,
    /// Nothing is handed over before this moment: something else comes before the move that begins there.
    limit_s: f64,
    /// The machine stands there, as it was handed over.
    pub rests: bool,
    /// Motors that move; nothing for all.
    pub only: Option<Vec<usize>>,
    /// The output that follows the speed.
    pub follow: Option<Follow>,
    /// Z follows a sheet beside the plan.
    pub height: Option<Height>,
    /// The plan that follows has to be known first: the way to rest would lead beyond this one.
    pub starves: bool,
}

impl Feeder {
    /// Motors that turn these axes, with so many steps for a millimetre or a degree.
    pub fn new(motors: Vec<Axis>, per_unit: Axes) -> Self {
        Self {
            followed: VecDeque::new(),
            follows: true,
            last: (0, 0.0),
            stepper: Stepper::new(per_unit, Axes::default()),
            per_unit,
            motors,
            handed_s: f64::NEG_INFINITY,
            limit_s: f64::INFINITY,
            rests: true,
            only: None,
            follow: None,
            height: None,
            starves: false,
        }
    }

    /// Steps made by the motors of an axis, as they were handed over.
    pub fn made(&self, axis: Axis) -> i64 {
        self.stepper.made()[axis.index()]
    }

    /// The machine stands there.
    pub fn is_at(&mut self, place: Axes) {
        self.stepper = Stepper::new(self.per_unit, place);
    }

    /// Another piece of plan is followed from now on.
    pub const fn begin_plan(&mut self) {
        self.follows = true;
    }

    /// Nothing of what is not handed over is made.
    pub fn forget(&mut self) {
        self.followed.clear();
        (self.follows, self.rests, self.starves) = (true, true, false);
    }

    /// The machine makes this plan: a new one, or the one that it makes has changed from here on. Tells the axes that are
    /// elsewhere than their motors brought them, because somebody said so.
    pub fn follow(&mut self, going: &Going<'_>) -> Vec<usize> {
        let plan = going.plan;
        let known_by = (plan.moves().len(), going.t0_s + plan.duration_s());
        let begin_s = |index| going.t0_s + plan.span_s(index).0;
        self.limit_s =
            if going.until < plan.moves().len() { begin_s(going.until) } else { f64::INFINITY };
        let follows = std::mem::take(&mut self.follows);
        if !follows && self.last == known_by {
            return Vec::new();
        }
        (self.last, self.starves) = (known_by, false);
        if !follows {
            self.followed.pop_back();
        }
        if known_by.1 <= self.handed_s + SAME_S {
            return Vec::new();
        }
        let leg = Leg::new(plan.clone());
        let mut anew = Vec::new();
        if self.rests && self.followed.is_empty() {
            anew = self.stepper.stands(leg.at(leg.span_s()[0]));
        }
        self.followed.push_back(Followed { t0_s: going.t0_s, leg });
        anew
    }

    /// The moment at which the next piece begins, where there is one.
    pub fn begins_s(&self) -> Option<f64> {
        let [begin_s, _] = self.followed.front()?.span_s();
        Some(if self.rests { begin_s.max(self.handed_s) } else { self.handed_s })
    }

    /// Cuts the next piece off, which begins at a moment and a clock; nothing where more has to be known or done first.
    /// With it go the changes of the output that follows the speed, in it and on its way to rest.
    pub fn piece(&mut self, scale: &Scale, starts: u64) -> Option<(Piece, [Vec<Set>; 2])> {
        let from_s = self.begins_s()?;
        let front = self.followed.front()?;
        let [_, end_s] = front.span_s();
        let piece_s = if self.height.is_some() { FOLLOWED_S } else { PIECE_S };
        let to_s = (from_s + piece_s).min(end_s).min(self.limit_s);
        let is_whole = to_s >= end_s;
        if to_s <= from_s + SAME_S && !is_whole {
            return None;
        }
        let stands = is_whole && front.leg.rests();
        let rests = if stands { Vec::new() } else { self.rests_from(to_s).unwrap_or_default() };
        if !stands && rests.is_empty() {
            self.starves = true;
            return None;
        }
        let ends = (scale.at(to_s).ceil() as u64).max(starts);
        let t0_s = front.t0_s;
        let span_s = [from_s - t0_s, to_s - t0_s];
        // While axes are homed nothing carries Z.
        let carries = self.height.as_mut().filter(|_| self.only.is_none());
        let lift = carries.map(|height| height.carry(&front.leg, t0_s, span_s));
        let made = match &lift {
            None => front.leg.steps(&mut self.stepper, span_s),
            Some(lift) => {
                let place = |t_s: f64| lifted(front.leg.at(t_s), lift, t0_s + t_s);
                self.stepper.follow(span_s[0], span_s[1], place)
            }
        };
        let steps =
            self.of_motors(made.iter().copied().map(Mark::from), t0_s, scale, [starts, ends]);
        let (tail, at_rest) = self.tail(&rests, scale, ends);
        let sets = self.beam([from_s, to_s], scale, [starts, ends, at_rest], &rests);
        (self.handed_s, self.rests, self.starves) = (to_s, stands, false);
        if is_whole {
            self.followed.pop_front();
        }
        Some((Piece { steps, ends, tail, rests: at_rest, ..Piece::default() }, sets))
    }

    /// Changes of the output that follows the speed: between two moments, and on the ways to rest behind them.
    fn beam(
        &mut self,
        span_s: [f64; 2],
        scale: &Scale,
        [starts, ends, at_rest]: [u64; 3],
        ways: &[(f64, RestPart)],
    ) -> [Vec<Set>; 2] {
        let (Some(follow), Some(front)) = (&mut self.follow, self.followed.front()) else {
            return Default::default();
        };
        let pace = |t_s: f64| front.leg.pace(t_s - front.t0_s);
        let clock = |t_s: f64| (scale.at(t_s) as u64).clamp(starts, ends);
        let mut sets = follow.changes(span_s, pace, clock);
        if ways.is_empty() {
            sets.push(follow.off(ends));
            return [sets, Vec::new()];
        }
        let (mut behind, mut pace) = (follow.clone(), pace(span_s[1]));
        let mut tail = Vec::new();
        for (t0_s, way) in ways {
            let clock = |t_s: f64| (scale.at(t0_s + t_s) as u64).clamp(ends, at_rest);
            tail.extend(behind.changes(way.span_s(), |t_s| way.pace(t_s, pace), clock));
            pace = way.pace(way.span_s()[1], pace);
        }
        tail.push(behind.off(at_rest));
        [sets, tail]
    }

    /// The ways to rest from a moment on, one behind the other: as planned to the end of what cannot brake in time, then
    /// braking in what follows. Nothing where what is known ends before.
    fn rests_from(&self, from_s: f64) -> Option<Vec<(f64, RestPart)>> {
        let (mut ways, mut from_s) = (Vec::new(), from_s);
        for followed in &self.followed {
            let t0_s = followed.t0_s;
            let rest = followed.leg.rest(from_s - t0_s)?;
            if rest.stands {
                ways.push((t0_s, RestPart::Brakes(from_s - t0_s, Box::new(rest))));
                return Some(ways);
            }
            let [_, end_s] = followed.span_s();
            ways.push((
                t0_s,
                RestPart::Planned(followed.leg.clone(), [from_s - t0_s, end_s - t0_s]),
            ));
            from_s = end_s;
        }
        // Where nothing can brake before its end, the machine stands there as planned.
        self.followed.back().filter(|followed| followed.leg.rests()).map(|_| ways)
    }

    /// Steps of the ways to rest, and the clock at which the machine stands.
    fn tail(
        &mut self,
        ways: &[(f64, RestPart)],
        scale: &Scale,
        ends: u64,
    ) -> (Vec<Vec<Step>>, u64) {
        let mut stepper = self.stepper.clone();
        let mut all = vec![Vec::new(); self.motors.len()];
        let mut at_rest = ends;
        let begin_s = ways.first().map(|(t0_s, way)| t0_s + way.span_s()[0]);
        let carries = self.height.as_mut().filter(|_| self.only.is_none());
        let lift = carries.zip(begin_s).map(|(height, from_s)| height.coast(from_s));
        // Where Z takes longer to come to rest than the path, it does so at the end of it.
        let alone = lift.as_ref().and_then(|lift| RestPart::alone(lift, ways.last()?));
        for (t0_s, way) in ways.iter().chain(&alone) {
            let (made, end_s) = way.steps(&mut stepper, *t0_s, lift.as_ref());
            at_rest = at_rest.max(scale.at(t0_s + end_s).ceil() as u64);
            let steps = self.of_motors(made.iter().copied(), *t0_s, scale, [ends, at_rest]);
            all.iter_mut().zip(steps).for_each(|(all, steps)| all.extend(steps));
        }
        (if ways.is_empty() { Vec::new() } else { all }, at_rest)
    }

    /// Steps of axes as steps of motors, each within clocks.
    fn of_motors(
        &self,
        made: impl Iterator<Item = Mark> + Clone,
        t0_s: f64,
        scale: &Scale,
        [starts, ends]: [u64; 2],
    ) -> Vec<Vec<Step>> {
        let moves = |motor: usize| self.only.as_ref().is_none_or(|only| only.contains(&motor));
        let of = |(motor, axis): (usize, &Axis)| {
            let own = made.clone().filter(|step| step.axis == axis.index() && moves(motor));
            own.map(|step| Step {
                clock: scale.at(t0_s + step.t_s).clamp(starts as f64, ends as f64),
                forward: step.forward,
                count: step.count,
            })
            .collect()
        };
        self.motors.iter().enumerate().map(of).collect()
    }
}

/// A part of the way to rest.
enum RestPart {
    /// As it is planned, between times of the plan.
    Planned(Leg, [f64; 2]),
    /// Braking, from a time of the plan on.
    Brakes(f64, Box<Rest>),
    /// It stands at a place but for what carries it beside the plan, between times of the plan.
    Stands(Axes, [f64; 2]),
}

impl RestPart {
    /// The times of the plan at which it begins and ends.
    const fn span_s(&self) -> [f64; 2] {
        match self {
            Self::Planned(_, span_s) | Self::Stands(_, span_s) => *span_s,
            Self::Brakes(from_s, rest) => [*from_s, rest.end_s],
        }
    }

    /// The speed at a time of the plan as a share of what is asked for, from that at the beginning on where it brakes.
    fn pace(&self, t_s: f64, begin: Option<f64>) -> Option<f64> {
        match self {
            Self::Planned(leg, _) => leg.pace(t_s),
            Self::Stands(..) => Some(0.0),
            Self::Brakes(from_s, rest) => {
                let full_mm_s = rest.speed_mm_s(*from_s);
                let share = if full_mm_s > 0.0 { rest.speed_mm_s(t_s) / full_mm_s } else { 0.0 };
                Some(begin? * share)
            }
        }
    }

    /// The way of what carries the machine on beside the plan, where it comes to rest behind another way.
    fn alone(lift: &Lift, (t0_s, way): &(f64, Self)) -> Option<(f64, Self)> {
        let [_, end_s] = way.span_s();
        let rests_s = lift.ends_s()? - t0_s;
        (rests_s > end_s).then(|| (*t0_s, Self::Stands(way.place(end_s), [end_s, rests_s])))
    }

    /// Place of every axis at a time of the plan.
    fn place(&self, t_s: f64) -> Axes {
        match self {
            Self::Planned(leg, _) => leg.at(t_s),
            Self::Brakes(_, rest) => rest.at(t_s),
            Self::Stands(place, _) => *place,
        }
    }

    /// Marks of its steps, in a plan that begins at a moment and with what carries the machine beside it, and the time of the
    /// plan at its end.
    fn steps(&self, stepper: &mut Stepper, t0_s: f64, lift: Option<&Lift>) -> (Vec<Mark>, f64) {
        let [from_s, to_s] = self.span_s();
        let steps = match lift {
            None => stepper.sketch(from_s, to_s, |t_s| self.place(t_s)),
            Some(lift) => {
                stepper.sketch(from_s, to_s, |t_s| lifted(self.place(t_s), lift, t0_s + t_s))
            }
        };
        (steps, to_s)
    }
}

/// A place with Z carried beside the plan as at a moment of machine time.
fn lifted(mut place: Axes, lift: &Lift, t_s: f64) -> Axes {
    place[Axis::Z] += lift.at(t_s);
    place
}
