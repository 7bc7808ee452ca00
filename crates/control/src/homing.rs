//! Finding home on the machine itself: the procedure of [`kerf_machine::homing`], each search a planned
//! motion that a home switch ends.

use crate::by_hand::Driven;
use crate::run_end::RunEnd;
use crate::stopping::RunStops;
use kerf_diag::{Code, Diagnostic, SourcePlace};
use kerf_machine::homing::{self, Axle, Homed, NotFound, Rig, Sought, Which};
use kerf_machine::lines::Input;
use kerf_machine::planning::hand_settings;
use kerf_model::Watched;
use kerf_motion::Mover;
use kerf_program::{
    Answer, At, Axes, Axis, AxisSet, Button, Command, Feed, Interpreter, Line, MoveKind, Question,
    Settings, Status,
};
use kerf_trace::Event;

/// Homes axes that have a switch, and tells how far the last home was off.
pub(crate) fn home<I: Interpreter>(stops: &mut RunStops<'_, I>, axes: AxisSet) -> Found {
    if stops.station.drive.homes() {
        return home_by_itself(stops);
    }
    let machine = stops.station.world.machine_is.clone();
    let settings = hand_settings(&machine);
    let now_s = stops.station.world.now();
    stops.station.world.tracked().advance(now_s);
    let mut rig = OnMachine { stops, settings, axis: None, over: None, found: Found::default() };
    let mut homed = Vec::new();
    let ended = homing::home(&machine, &mut rig, axes, &mut homed);
    let (over, at, mut found) = (rig.over.take(), rig.axis, rig.found);
    stops.station.world.tracked().move_alone(None);
    stops.station.mover.set_position(stops.station.world.model.position());
    match &ended {
        Ok(()) => found.done = found.zeroed,
        // A switch that does not come is not where it was believed to be.
        Err(_) if over.is_none() => at.iter().for_each(|axis| found.lost.insert(*axis)),
        // Its motors may stand differently.
        Err(_) => found.lost = found.zeroed.without(found.done),
    }
    found.over = over.or_else(|| ended.err().map(|missing| misses_switch(stops, &missing, at)));
    homed.retain(|it| found.done.contains(it.axis));
    tell_homed(stops, &homed);
    found
}

/// Has a controller go home that finds it by itself, with all its axes.
fn home_by_itself<I: Interpreter>(stops: &mut RunStops<'_, I>) -> Found {
    let axes = stops.station.world.homes;
    let mut found = Found { lost: axes, ..Found::default() };
    stops.station.world.workspace.tape.moves(true, stops.station.world.placed());
    let forbidden = stops.station.forbidden();
    let home = if forbidden.is_none() { stops.station.drive.home() } else { None };
    match (forbidden, home) {
        (_, Some(place)) => {
            stops.station.world.model.put(place);
            stops.station.mover.set_position(place);
            found = Found { done: axes, zeroed: axes, ..Found::default() };
            let text = "the controller has homed its axes".into();
            stops.station.world.tell(&Event::Message { text, t: stops.station.world.now() });
        }
        (Some(driven), _) => found.over = Some(stops.station.interrupted(&driven)),
        (None, None) => {
            let failed = stops.station.drive.fault().cloned().map(|fault| stops.fails(&fault));
            let place = stops.station.world.driven.borrow_mut().place();
            if let (None, Some(place)) = (&failed, place) {
                // It was stopped on its way.
                stops.station.world.model.put(place);
                stops.station.mover.set_position(place);
            }
            let stopped = RunEnd::of(Status::Stopped);
            found.over = Some(failed.unwrap_or(stopped));
        }
    }
    stops.station.stand();
    found
}

fn misses_switch<I: Interpreter>(
    stops: &RunStops<'_, I>,
    missing: &NotFound,
    axis: Option<Axis>,
) -> RunEnd {
    let place = SourcePlace::line(stops.station.world.file(At::default()), 0);
    let input = axis.and_then(Input::home_of).map_or("none", Input::name);
    let hint = format!(
        "nothing moves on; look at the switch on input {input} (homing), and at the length of the axis (axis.length)"
    );
    let why = Diagnostic::new(Code::NoHome, place, missing.to_string()).hint(hint);
    RunEnd { status: Status::Failed, diagnostic: Some(Box::new(why)) }
}

fn tell_homed<I: Interpreter>(stops: &mut RunStops<'_, I>, homed: &[Homed]) {
    let t = stops.station.world.now();
    for it in homed {
        let axis = stops.station.world.machine_is.motors.axis_name(it.axis);
        stops.station.world.tell(&Event::Homed { axis, steps: it.difference_steps, t });
    }
}

/// Asks whether to home first; `Ended` goes on without.
pub(crate) fn asked<I: Interpreter>(
    stops: &mut RunStops<'_, I>,
    question: Option<Question>,
) -> Result<(), RunEnd> {
    let Some(question) = question else { return Ok(()) };
    let status = match stops.ask(&question, At::default())? {
        Answer::Button(Button::Yes) => return Ok(()),
        Answer::Button(Button::No | Button::Continue) => Status::Ended,
        _ => Status::Stopped,
    };
    Err(RunEnd::of(status))
}

/// Homes axes. An axis that was homed before keeps the numbers of its zero points, which count from
/// home; of one that was not they stay where they were on the table.
pub(crate) fn find_home<I: Interpreter>(
    stops: &mut RunStops<'_, I>,
    axes: AxisSet,
    before: AxisSet,
) -> Found {
    let found = home(stops, axes);
    let mut frame = *stops.station.world.model.frame();
    for axis in found.zeroed.without(before).iter() {
        frame.working_zero[axis] -= found.shift[axis];
        frame.base_zero[axis] -= found.shift[axis];
    }
    found.done.iter().for_each(|axis| frame.base_zero[axis] = 0.0);
    if found.over.is_none() || !found.zeroed.is_empty() {
        let (working, base) = (found.done, found.done);
        stops.station.world.perform(Command::Location { frame, working, base });
    }
    found
}

pub(crate) fn tell_end<I: Interpreter>(stops: &mut RunStops<'_, I>, over: RunEnd) -> RunEnd {
    if let Some(why) = &over.diagnostic {
        stops.station.world.tell_diagnostic((**why).clone());
    }
    over
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
    pub over: Option<RunEnd>,
}

/// The machine as the homing procedure moves it.
struct OnMachine<'a, 'b, I> {
    stops: &'a mut RunStops<'b, I>,
    settings: Settings,
    /// The axis that is being homed.
    axis: Option<Axis>,
    /// Reason for which nothing moves any more.
    over: Option<RunEnd>,
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
        self.stops.station.world.model.position()[self.axis()]
    }

    /// Moves the axis, until a switch reads a state; tells where that was.
    fn drive(&mut self, which: Which, to: f64, speed: f64, until: Option<bool>) -> Option<f64> {
        if self.over.is_some() {
            return None;
        }
        if let Some(driven) = self.stops.station.forbidden() {
            self.over = Some(self.stops.station.interrupted(&driven));
            return None;
        }
        let (axis, from) = (self.axis(), self.stops.station.world.model.position());
        self.stops.station.world.tracked().move_alone(match which {
            Which::All => None,
            Which::One(motor) => Some((axis, motor)),
        });
        let mut there = from;
        there[axis] = to;
        let line = Line { kind: MoveKind::Jog, to: there, feed: Feed::Path(speed.abs()) };
        let made = Mover::new(from, &self.settings).line(At::default(), &line)?;
        let switch = until.zip(Input::home_of(axis)).map(|(on, line)| line.number_when(on));
        match self.stops.station.drive(made, &self.settings, switch.as_slice()) {
            Driven::Edge(place) => Some(place[axis]),
            Driven::There => None,
            driven => {
                self.over = Some(self.stops.station.interrupted(&driven));
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
        self.stops.station.world.driven.borrow().home_switch(self.axis(), which)
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
            self.stops.station.world.tracked().zero(axis);
        }
    }
}
