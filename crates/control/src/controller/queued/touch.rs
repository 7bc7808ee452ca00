//! Homing and probing of a board: what its latches stop, and where that was.

use super::guard::LOOK_S;
use super::height::Height;
use super::homing::{Act, Came, Homing};
use super::machine::{Queued, SAME_S, State};
use crate::controller::connection::NAP;
use kerf_driver_klipper::board::{Ended, Watched};
use kerf_driver_klipper::mailbox::Request;
use kerf_machine::lines::Input;
use kerf_machine::{Going, Machine, News, Watch};
use kerf_motion::{Mover, planner};
use kerf_program::{At, Axes, Axis, Feed, Line, MoveKind};
use std::time::Duration;

/// Time behind the board's clock up to which it would have told that an input stopped it, seconds: the line may need some
/// resends.
const HEARD_S: f64 = 0.2;
/// Moments are looked through in these steps for the place at which the machine stands, seconds.
const SOUGHT_S: f64 = 1e-5;
/// Longest time from the change of an input to the stand, seconds.
const TOUCH_S: f64 = 5e-3;
/// Farthest that a place is from the count of a motor, steps: half a step, and the rounding of a time.
const STEP: f64 = 0.55;

/// Inputs at whose change the machine stands by itself, and the one that did it.
#[derive(Clone, Debug, Default)]
pub struct Probe {
    /// Inputs that are watched while the plan is made.
    watches: Vec<Watch>,
    /// Switches that the board was told to watch.
    told: Vec<Watched>,
    /// Motion that began without them is over first.
    waits: bool,
    /// The machine comes to rest because it was asked to.
    slows: bool,
    /// The change that stopped the machine.
    touch: Option<Touch>,
    /// Readings of the height are awaited on the way down to the sheet.
    pub(super) listens: bool,
}

/// A change of an input that stopped the machine.
#[derive(Clone, Copy, Debug)]
struct Touch {
    /// Its moment, seconds of machine time.
    at_s: f64,
    watch: Watch,
    /// The run knows of it.
    is_told: bool,
}

impl Probe {
    /// Something is watched: no moment is told before the machine has passed it.
    pub const fn is_armed(&self) -> bool {
        self.listens || !self.watches.is_empty()
    }
}

impl Queued {
    /// Begins to home all axes that have switches.
    pub(super) fn begin_homing(&mut self) {
        if self.fault.is_none() && !self.wiring.homes.is_empty() {
            let mut homing = Homing::new(self.wiring.homes.clone());
            let act = homing.begin();
            self.homing = Some(homing);
            self.port.request(Request::LetRest);
            self.wait_until(|it| it.state == State::Rest);
            self.act(act);
        }
    }

    /// Homing goes on; tells whether it is not over.
    pub(super) fn homes_on(&mut self) -> bool {
        let wait = if self.hand_on() { Duration::ZERO } else { NAP };
        if self.feeder.rests && matches!(self.state, State::Moving(..)) {
            self.port.request(Request::LetRest);
        }
        self.tend(wait);
        if let Some(came) = self.came.take() {
            self.feeder.forget();
            let act = self.homing.as_mut().map(|homing| homing.ended(&came));
            act.into_iter().for_each(|act| self.act(act));
        }
        self.homing.is_some()
    }

    /// Homes all axes that have switches, before any run. Returns the place where it stands then.
    ///
    /// # Errors
    /// Somebody stopped it, or a switch was not found; in words.
    pub(super) fn comes_home(&mut self, is_stopped: impl Fn() -> bool) -> Result<Axes, String> {
        self.begin_homing();
        while self.settle() {
            if is_stopped() {
                self.halt();
                return Err(format!("{}: it was stopped while it homed", self.name));
            }
        }
        match &self.fault {
            Some(fault) => Err(fault.message.clone()),
            None => Ok(self.counted()),
        }
    }

    /// The place of the home switch of an axis among the switches.
    pub fn home_switch(&self, axis: Axis) -> Option<usize> {
        self.wiring.motors.iter().find(|motor| motor.axis == axis)?.home
    }

    /// The state of a switch; nothing where the board does not tell it.
    pub fn is_on(&mut self, switch: usize) -> Option<bool> {
        self.are_on(&[switch]).and_then(|told| told.first().copied())
    }

    /// The states of switches, in their order; nothing where the board does not tell them.
    pub fn are_on(&mut self, switches: &[usize]) -> Option<Vec<bool>> {
        self.asked = switches.iter().map(|switch| (*switch, None)).collect();
        switches.iter().for_each(|switch| self.port.request(Request::Switch(*switch)));
        self.wait_until(|it| it.fault.is_some() || it.asked.iter().all(|(_, told)| told.is_some()));
        std::mem::take(&mut self.asked).into_iter().map(|(_, told)| told).collect()
    }

    /// A switch told its state.
    pub(super) fn switch_told(&mut self, switch: usize, is_on: bool) {
        let Some(asked) = self.asked.iter_mut().find(|(other, _)| *other == switch) else { return };
        asked.1 = Some(is_on);
        let told: Option<Vec<bool>> = self.asked.iter().map(|(_, is_on)| *is_on).collect();
        if let (Some(told), Some(homing)) = (told, &mut self.homing) {
            let act = homing.looked(told.contains(&true));
            self.asked.clear();
            self.act(act);
        }
    }

    fn act(&mut self, act: Act) {
        match act {
            Act::Look(switches) => {
                self.asked = switches.iter().map(|switch| (*switch, None)).collect();
                switches.into_iter().for_each(|it| self.port.request(Request::Switch(it)));
            }
            Act::Move { axis, by, speed, motors, homes } => {
                let mut from = self.counted();
                if let Some(first) = motors.first() {
                    let steps = self.counts[*first] - self.zeros[*first];
                    from[axis] = steps as f64 / self.per_unit[axis];
                }
                let mut to = from;
                to[axis] += by;
                let line = Line { kind: MoveKind::Jog, to, feed: Feed::Path(speed) };
                let made = Mover::new(from, &self.wiring.by_hand).line(At::default(), &line);
                let Some(made) = made else {
                    let (counts, edges) = (self.counts.clone(), Vec::new());
                    self.came = Some(Came { why: Ended::Rested, counts, edges });
                    return;
                };
                let mut planner = planner(&self.wiring.by_hand);
                planner.push(made);
                let Some(plan) = planner.finish() else { return };
                self.watch_for(self.guards(&[]));
                (self.homes, self.feeder.only) = (homes, Some(motors));
                self.feeder.is_at(from);
                self.feeder.begin_plan();
                let t0_s = self.progress.at_s;
                (self.feeder.handed_s, self.feeder.rests) = (t0_s, true);
                let until = plan.moves().len();
                let going = Going { plan: &plan, index: 0, t0_s, until, part: 0.0, watches: &[] };
                self.feeder.follow(&going);
            }
            Act::Zero(axis) => {
                let mut place = self.counted();
                place[axis] = 0.0;
                self.feeder.is_at(place);
                self.count_anew();
                let act = self.homing.as_mut().map(Homing::zeroed);
                act.into_iter().for_each(|act| self.act(act));
            }
            Act::Done => self.homed(),
            Act::Fails(why) => {
                self.fail(why, "look at the switch, and at the length of the axis", false);
            }
        }
    }

    /// All axes are homed.
    fn homed(&mut self) {
        (self.homing, self.feeder.only) = (None, None);
        self.feeder.forget();
        self.feeder.handed_s = f64::NEG_INFINITY;
        let place = self.counted();
        self.is_at(place);
        self.elsewhere = Some(place);
    }

    /// Inputs at which the machine is to stand at once: those of a plan, and on the way down to a sheet the switch that says
    /// that the head is too high.
    pub(super) fn own_watches(&self, going: &Going<'_>) -> Vec<Watch> {
        let height = self.feeder.height.as_ref().zip(going.made());
        let stops = height.is_some_and(|(height, made)| height.stops_in(made));
        let lets_go = stops.then(|| Watch { input: Input::ZHigh.number(), active: false });
        going.watches.iter().copied().chain(lets_go).collect()
    }

    /// Has the board watch the inputs of a plan, and those at which motion ends. Returns `false` while motion that began without them is waited for.
    pub(super) fn watches(&mut self, going: &Going<'_>) -> bool {
        if self.probe.watches != going.watches {
            self.probe.watches = going.watches.to_vec();
            (self.probe.waits, self.probe.touch) = (true, None);
        }
        let told = self.switches(going.watches);
        if self.probe.waits && self.feeder.rests && self.state != State::Rest {
            self.port.request(Request::LetRest);
            return false;
        }
        self.probe.waits = false;
        self.watch_for(told);
        true
    }

    fn watch_for(&mut self, told: Vec<Watched>) {
        if told != self.probe.told {
            self.port.request(Request::Watch(told.clone()));
            self.probe.told = told;
        }
    }

    /// The switches at which motion ends, and those of inputs that were not as they are watched for when that began.
    fn switches(&self, watches: &[Watch]) -> Vec<Watched> {
        let switch = |watch: &Watch| {
            let mut inputs = self.wiring.inputs.iter().enumerate();
            let (bit, input) = inputs.find(|(_, it)| it.number == watch.input)?;
            let is_there = (self.pressed & (1 << bit) != 0) == watch.active;
            let opens = watch.active == input.turned;
            let watched = Watched { switch: input.switch, opens, look_s: LOOK_S, guards: false };
            let is_watched = !self.probe.waits && self.probe.told.contains(&watched);
            (is_watched || !is_there).then_some(watched)
        };
        let mut all = self.guards(&self.probe.told);
        let probes = watches.iter().filter_map(switch);
        let probes = probes.filter(|it| all.iter().all(|guard| guard.switch != it.switch));
        let probes: Vec<Watched> = probes.collect();
        all.extend(probes);
        all
    }

    /// A switch stopped all motors: learns which input that was, and when. Returns `false` where the run is past that.
    pub(super) fn is_touched(&mut self, edges: &[(usize, u64, Vec<i64>)]) -> bool {
        if std::mem::take(&mut self.probe.slows) {
            return true;
        }
        let (State::Moving(scale, _), Some((switch, clock, _))) = (self.state, edges.first())
        else {
            return false;
        };
        let looked = self.wiring.inputs.iter().find(|it| it.switch == *switch);
        let watches = &self.probe.watches;
        let watch = looked.and_then(|it| watches.iter().find(|watch| watch.input == it.number));
        let Some(watch) = watch.copied() else { return false };
        let at_s = scale.moment(*clock);
        self.probe.touch = Some(Touch { at_s, watch, is_told: false });
        self.feeder.forget();
        at_s + SAME_S >= self.told_s
    }

    /// The news of the input that stopped the machine in a move: the input once, then the moment alone.
    pub(super) fn touched(&mut self, from_s: f64, end_s: f64) -> Option<News> {
        let touch = self.probe.touch.as_mut().filter(|touch| touch.at_s <= end_s)?;
        let is_told = std::mem::replace(&mut touch.is_told, true);
        let input = (!is_told).then_some((touch.watch.input, touch.watch.active));
        Some(News { reached_s: touch.at_s.max(from_s) + if is_told { SAME_S } else { 0.0 }, input })
    }

    /// The moment up to which no input can have stopped the machine any more: infinite where motion is over.
    pub(super) fn passed_s(&self, end_s: f64) -> f64 {
        match (self.state, self.progress.clock) {
            (State::Rest, _) if self.feeder.handed_s >= end_s - SAME_S => f64::INFINITY,
            // It has stopped: when is about to be told.
            (State::Moving(..), _) if !self.progress.moves => self.told_s,
            (State::Moving(scale, _), Some((now, off))) => {
                let passed_s = scale.moment(now.saturating_sub(off)) - HEARD_S;
                if passed_s > end_s { f64::INFINITY } else { passed_s }
            }
            _ => f64::NEG_INFINITY,
        }
    }

    /// Returns the moment of the plan at which the machine stands after an input stopped it, or has it come to rest while
    /// inputs are watched; nothing where it stops by the ramp that is planned for it.
    pub(super) fn stands_s(&mut self, going: &Going<'_>) -> Option<f64> {
        let [from_s, until_s] = match (self.probe.touch.take(), self.probe.is_armed()) {
            (Some(Touch { at_s, .. }), _) => [at_s, at_s + TOUCH_S],
            (None, true) => self.comes_to_rest()?,
            (None, false) => return None,
        };
        let counted = self.counted();
        let axes = self.wiring.axes();
        let off = |t_s: f64| {
            let mut place = going.at(t_s).position;
            place[Axis::Z] += self.feeder.height.as_ref().map_or(0.0, |it| it.offset_at(t_s));
            let steps = |axis| ((place[axis] - counted[axis]) * self.per_unit[axis]).abs();
            axes.iter().map(steps).fold(0.0, f64::max)
        };
        let many = ((until_s - from_s) / SOUGHT_S) as u32;
        let moments = (0..many).map(|n| from_s + f64::from(n) * SOUGHT_S);
        let places = moments.map(|t_s| (t_s, off(t_s)));
        // The nearest one: what goes on from the edge of a step would begin with that step.
        let passes = places.skip_while(|(_, off)| *off > STEP).take_while(|(_, off)| *off <= STEP);
        let nearest = passes.min_by(|(_, a), (_, b)| a.total_cmp(b));
        if nearest.is_none() && self.wiring.pins.boards.len() > 1 {
            let why = "its boards stopped some steps apart, so it stands beside its path";
            self.fail(why.into(), "its place is known: begin again at this line", false);
        }
        let stands_s = nearest.map_or(from_s, |(t_s, _)| t_s);
        self.feeder.forget();
        self.feeder.height.iter_mut().for_each(|height| height.stands(stands_s));
        self.feeder.is_at(counted);
        self.feeder.handed_s = stands_s;
        Some(stands_s)
    }

    /// Nothing is handed over any more: the board makes the way to rest behind what it has, on the path, or an input stops
    /// it before. Returns the moments between which the plan has the place where it stands.
    fn comes_to_rest(&mut self) -> Option<[f64; 2]> {
        while self.state == State::Starting && self.fault.is_none() {
            self.tend(NAP);
        }
        let State::Moving(scale, _) = self.state else { return None };
        self.probe.slows = true;
        self.port.request(Request::LetRest);
        while self.state != State::Rest && self.fault.is_none() {
            self.tend(NAP);
        }
        let is_touched = !std::mem::take(&mut self.probe.slows);
        if !is_touched {
            self.feeder.height.iter_mut().for_each(Height::coasted);
        }
        self.late = false;
        let (now, _) = self.progress.clock?;
        let from_s = if is_touched { self.told_s } else { self.feeder.handed_s - SAME_S };
        Some([from_s.max(self.told_s), scale.moment(now)])
    }
}
