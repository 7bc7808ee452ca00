//! Finding home on the machine itself: the procedure of [`kerf_machine::homing`], each search a planned
//! motion that a home switch ends.

use crate::by_hand::Driven;
use crate::runner::{Over, Runner};
use kerf_diag::{Code, Diagnostic, Place};
use kerf_machine::homing::{self, Axle, Homed, NotFound, Rig, Sought, Which};
use kerf_machine::lines::Input;
use kerf_machine::planning::hand_settings;
use kerf_motion::Mover;
use kerf_program::{At, Axes, Axis, AxisSet, Feed, Interpreter, Line, MoveKind, Settings, Status};
use kerf_sim::{Machine, Watched};
use kerf_trace::Event;

impl<I: Interpreter> Runner<'_, I> {
    /// Homes axes that have a switch, and tells how far the last home was off.
    pub(crate) fn home(&mut self, axes: AxisSet) -> Found {
        if self.drive.homes() {
            return self.home_by_itself();
        }
        let machine = self.world.machine_is.clone();
        let settings = hand_settings(&machine);
        let now_s = self.world.now();
        self.world.tracked().advance(now_s);
        let mut rig =
            OnMachine { runner: self, settings, axis: None, over: None, found: Found::default() };
        let mut homed = Vec::new();
        let ended = homing::home(&machine, &mut rig, axes, &mut homed);
        let (over, at, mut found) = (rig.over.take(), rig.axis, rig.found);
        self.world.tracked().move_alone(None);
        self.mover.set_position(self.world.machine.position());
        match &ended {
            Ok(()) => found.done = found.zeroed,
            // A switch that does not come is not where it was believed to be.
            Err(_) if over.is_none() => at.iter().for_each(|axis| found.lost.insert(*axis)),
            // Its motors may stand differently.
            Err(_) => found.lost = found.zeroed.without(found.done),
        }
        found.over = over.or_else(|| ended.err().map(|missing| self.misses_switch(&missing, at)));
        homed.retain(|it| found.done.contains(it.axis));
        self.tell_homed(&homed);
        found
    }

    /// Has a controller go home that finds it by itself, with all its axes.
    fn home_by_itself(&mut self) -> Found {
        let axes = self.world.homes;
        let mut found = Found { lost: axes, ..Found::default() };
        self.world.workspace.tape.moves(true, self.world.placed());
        let forbidden = self.forbidden();
        let home = if forbidden.is_none() { self.drive.home() } else { None };
        match (forbidden, home) {
            (_, Some(place)) => {
                self.world.machine.put(place);
                self.mover.set_position(place);
                found = Found { done: axes, zeroed: axes, ..Found::default() };
                let text = "the controller has homed its axes".into();
                self.world.tell(&Event::Message { text, t: self.world.now() });
            }
            (Some(driven), _) => found.over = Some(self.interrupted(&driven)),
            (None, None) => {
                let failed = self.drive.fault().cloned().map(|fault| self.fails(&fault));
                let stopped = Over { status: Status::Stopped, diagnostic: None };
                found.over = Some(failed.unwrap_or(stopped));
            }
        }
        self.stand();
        found
    }

    fn misses_switch(&self, missing: &NotFound, axis: Option<Axis>) -> Over {
        let place = Place::line(self.world.file(At::default()), 0);
        let input = axis.and_then(Machine::home_line).map_or("none", Input::name);
        let hint = format!(
            "nothing moves on; look at the switch on input {input} (homing), and at the length of the axis (axis.length)"
        );
        let why = Diagnostic::new(Code::NoHome, place, missing.to_string()).hint(hint);
        Over { status: Status::Failed, diagnostic: Some(Box::new(why)) }
    }

    fn tell_homed(&mut self, homed: &[Homed]) {
        let t = self.world.now();
        for it in homed {
            let axis = self.world.machine_is.motors.axis_name(it.axis);
            self.world.tell(&Event::Homed { axis, steps: it.difference_steps, t });
        }
    }
}

/// Result of homing.
#[derive(Debug, Default)]
pub(crate) struct Found {
    /// Axes that are homed.
    pub done: AxisSet,
    /// Axes whose home nobody knows any more.
    pub lost: AxisSet,
    /// Axes whose zero has moved.
    pub zeroed: AxisSet,
    /// By how much.
    pub shift: Axes,
    /// Reason for which it did not come to its end.
    pub over: Option<Over>,
}

/// The machine as the homing procedure moves it.
struct OnMachine<'a, 'b, I> {
    runner: &'a mut Runner<'b, I>,
    settings: Settings,
    /// The axis that is being homed.
    axis: Option<Axis>,
    /// Reason for which nothing moves any more.
    over: Option<Over>,
    found: Found,
}

impl<I: Interpreter> Rig for OnMachine<'_, '_, I> {
    fn axle(&mut self, axis: Axis) -> &mut dyn Axle {
        // Those before it are done.
        self.found.done = self.found.zeroed;
        self.axis = Some(axis);
        self
    }
}

impl<I: Interpreter> OnMachine<'_, '_, I> {
    fn axis(&self) -> Axis {
        self.axis.unwrap_or(Axis::X)
    }

    fn place(&self) -> f64 {
        self.runner.world.machine.position()[self.axis()]
    }

    /// Moves the axis, until a switch reads a state; tells where that was.
    fn drive(&mut self, which: Which, to: f64, speed: f64, until: Option<bool>) -> Option<f64> {
        if self.over.is_some() {
            return None;
        }
        if let Some(driven) = self.runner.forbidden() {
            self.over = Some(self.runner.interrupted(&driven));
            return None;
        }
        let (axis, from) = (self.axis(), self.runner.world.machine.position());
        self.runner.world.tracked().move_alone(match which {
            Which::All => None,
            Which::One(motor) => Some((axis, motor)),
        });
        let mut there = from;
        there[axis] = to;
        let line = Line { kind: MoveKind::Jog, to: there, feed: Feed::Path(speed.abs()) };
        let made = Mover::new(from, &self.settings).line(At::default(), &line)?;
        let switch = until.zip(Machine::home_line(axis)).map(|(on, line)| line.number_when(on));
        match self.runner.drive(made, &self.settings, switch.as_slice()) {
            Driven::Edge(place) => Some(place[axis]),
            Driven::There => None,
            driven => {
                self.over = Some(self.runner.interrupted(&driven));
                None
            }
        }
    }
}

/// Switch that a move waits for.
trait Switch {
    fn number_when(self, on: bool) -> Watched;
}

impl Switch for Input {
    fn number_when(self, on: bool) -> Watched {
        Watched { input: self.number(), on, ramped: true, level_from_s: None }
    }
}

impl<I: Interpreter> Axle for OnMachine<'_, '_, I> {
    fn switch(&self, which: Which) -> bool {
        self.runner.world.driven.borrow().home_switch(self.axis(), which)
    }

    fn seek(&mut self, which: Which, speed: f64, until: bool, most: f64) -> Sought {
        let from = self.place();
        if self.switch(which) == until {
            return Sought { edge: Some(from), stopped: from };
        }
        let edge = self.drive(which, from + speed.signum() * most, speed, Some(until));
        Sought { edge, stopped: self.place() }
    }

    fn go(&mut self, which: Which, to: f64, speed: f64) {
        self.drive(which, to, speed, None);
    }

    fn zero(&mut self, _: Which) {
        if self.over.is_none() {
            let axis = self.axis();
            self.found.shift[axis] += self.place();
            self.found.zeroed.insert(axis);
            self.runner.world.tracked().zero(axis);
        }
    }
}
