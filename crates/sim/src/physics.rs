//! The simulated machine's own side: what its switches and sensors feel, and when.
//!
//! Nobody but the machine knows it beforehand. It learns the plan that is followed next and works out what will change on
//! the way; each change is told when its moment has come, and not sooner.

use crate::carriages::Carriages;
use crate::head::{Head, Lent};
use crate::pushes::Pushes;
use crate::scene::{self, Touch};
use crate::sheet::Sheet;
use kerf_machine::homing::Which;
use kerf_machine::lines::Input;
use kerf_machine::{Ahead, Configuration, LiftOfMove};
use kerf_model::flips;
use kerf_model::{Change, Inputs};
use kerf_motion::{Plan, Span};
use kerf_program::{Axes, Axis, HeightLaw, Settings};
use std::sync::Arc;

/// Carriages, switches, things on the table, and the head.
#[derive(Clone, Debug, Default)]
pub struct Physics {
    settings: Arc<Settings>,
    /// The inputs up to where the plan was made last, and what is to come from there.
    inputs: Inputs,
    /// The same up to the change that was told last.
    ahead: Inputs,
    /// True places of the axes.
    carriages: Carriages,
    head: Head,
    /// Pushes by hand.
    pub(crate) pushes: Pushes,
    /// Bodies on the table, and the inputs that change where the tool is inside of them.
    touches: Arc<[Touch]>,
    /// End of the plan that was followed last, seconds of machine time.
    plan_ends_s: Option<f64>,
}

impl Physics {
    /// Begins anew with inputs, and with the changes that their script brings.
    fn begin(&mut self, inputs: Inputs) {
        self.ahead = inputs.clone();
        (self.inputs, self.plan_ends_s) = (inputs, None);
    }

    /// The same for the next run, which counts time from 0.
    pub(crate) fn again(&mut self, settings: Arc<Settings>, inputs: Inputs) {
        self.settings = settings;
        let inputs = inputs.after(&self.inputs);
        self.begin(inputs);
        self.put_home_switches();
    }

    /// A run goes on from a moment: what the script of inputs did until then is told.
    pub(crate) fn begin_at(&mut self, t_s: f64) {
        self.begin(self.inputs.at(t_s, &self.settings.io));
    }

    /// Has the switches and motors of a configuration. What is known of where its axes truly are stays, where it has as
    /// many motors as before.
    pub(crate) fn equip(&mut self, machine: &Configuration, believed: Axes) {
        let known = self.carriages.astray();
        self.carriages = Carriages::new(machine);
        if known.iter().zip(self.carriages.astray()).all(|(a, b)| a.len() == b.len()) {
            self.carriages.set_astray(&known);
        }
        self.carriages.settle(believed);
        self.both(|inputs| inputs.wire(machine.io));
        self.put_home_switches();
        // Nobody presses the emergency stop, whatever its level.
        let stop = Input::EmergencyStop.number();
        self.both(|inputs| inputs.rests(stop, !machine.estop.active));
    }

    /// Its carriages are off by so much.
    pub(crate) fn set_truth(&mut self, truth: &[Vec<f64>], believed: Axes) {
        self.carriages.set_astray(truth);
        self.carriages.settle(believed);
        self.put_home_switches();
    }

    /// A sheet lies on its table, or none.
    pub(crate) const fn put_sheet(&mut self, sheet: Option<Sheet>) {
        self.head.put_sheet(sheet);
    }

    /// These things are on its table while the tool is at a place.
    pub(crate) fn put_touches(&mut self, touches: &[Touch], at: &Axes) {
        self.touches = touches.into();
        for input in scene::inputs(touches) {
            if let Some(on) = scene::contact(touches, input, at) {
                self.both(|inputs| inputs.put(input, on));
            }
        }
    }

    fn both(&mut self, change: impl Fn(&mut Inputs)) {
        change(&mut self.inputs);
        change(&mut self.ahead);
    }

    /// The contacts of the home switches are as the carriages have them.
    fn put_home_switches(&mut self) {
        for (line, on) in self.carriages.lines() {
            if on || self.inputs.reads(line, &self.settings.io) {
                self.both(|inputs| inputs.put(line, on));
            }
        }
    }

    /// The inputs as whoever is told of them knows them.
    pub(crate) fn known(&self) -> Inputs {
        self.ahead.known()
    }

    /// Switches that somebody moved by hand, and where they were left.
    pub(crate) fn moved_by_hand(&self) -> Vec<(u8, bool)> {
        self.inputs.moved_by_hand()
    }

    /// Returns how far each motor's carriage is from where the controller believes it.
    pub(crate) fn truth(&self) -> Vec<Vec<f64>> {
        self.carriages.astray()
    }

    /// Motion will follow this plan: what the sensors will tell is worked out. What was told from the beginning on is
    /// told once more, but for what somebody has done by hand until then.
    pub(crate) fn foresee(&mut self, ahead: &Ahead<'_>) {
        let from_s = ahead.from_s;
        self.plan_ends_s = Some(ahead.t0_s + ahead.plan.duration_s());
        self.inputs.come_to(from_s);
        let lent = Lent { inputs: &self.inputs, modes: &self.settings.io };
        let ticks = self.head.foreseen_ticks(lent, ahead);
        let mut all: Vec<Change> = self.foreseen_switches(ahead);
        all.extend(self.head.foreseen_sensors(lent, ahead, &ticks));
        all.extend(self.foreseen_touches(ahead));
        all.extend(self.head.foreseen_faults(from_s, &ticks));
        all.sort_by(|a, b| a.at_s.total_cmp(&b.at_s));
        self.inputs.foresee(all);
        self.ahead = self.inputs.clone();
    }

    /// Foresees the changes of the home switches while a plan is carried out.
    fn foreseen_switches(&self, ahead: &Ahead<'_>) -> Vec<Change> {
        let change = |(t_s, input, on)| Change { input, at_s: ahead.t0_s + t_s, on };
        let changes = self.carriages.foresee(ahead.plan).into_iter().map(change);
        changes.filter(|change| change.at_s >= ahead.from_s).collect()
    }

    /// Foresees what switches will feel on the way.
    fn foreseen_touches(&self, ahead: &Ahead<'_>) -> Vec<Change> {
        let Ahead { plan, t0_s, from_s } = *ahead;
        let change = |input: u8| {
            let felt = |t_s: f64| {
                let at = plan.at(t_s).position;
                scene::contact(&self.touches, input, &at).unwrap_or_default()
            };
            let flips = flips((from_s - t0_s).max(0.0), plan.duration_s(), &felt).into_iter();
            flips.map(move |(t_s, on)| Change { input, at_s: t0_s + t_s, on })
        };
        scene::inputs(&self.touches).into_iter().flat_map(change).collect()
    }

    /// Returns the moment of the next change that was not told.
    pub(crate) fn next_s(&self) -> Option<f64> {
        self.ahead.next().map(|change| change.at_s)
    }

    /// Tells the next change up to a moment: the contact, of a pin its level. What changed behind the end of the plan is
    /// not told again by the next one.
    #[inline]
    pub(crate) fn tell(&mut self, until_s: f64) -> Option<Change> {
        if self.ahead.is_due(until_s) { self.tell_due(until_s) } else { None }
    }

    fn tell_due(&mut self, until_s: f64) -> Option<Change> {
        loop {
            let next = self.ahead.next().filter(|change| change.at_s <= until_s)?;
            let (felt, known) = (self.ahead.is_foreseen_first(), self.ahead.is_known(&next));
            let change = self.ahead.happen(until_s)?;
            if self.plan_ends_s.is_none_or(|end_s| change.at_s > end_s) {
                self.inputs = self.ahead.clone();
            }
            if !(felt && known) {
                return Some(change);
            }
        }
    }

    /// Returns the moment from another on at which an input will read a state anew.
    pub(crate) fn changes_s(&self, number: u8, on: bool, from_s: f64) -> Option<f64> {
        self.ahead.changes_s(number, on, from_s, &self.settings.io)
    }

    /// Somebody moves the switch of an input at a moment that is not over yet; it stays there, also for the next run.
    pub(crate) fn press(&mut self, change: Change) {
        self.both(|inputs| inputs.press(change));
    }

    /// These settings hold from here on.
    pub(crate) fn use_settings(&mut self, settings: Arc<Settings>) {
        if !settings.torch_on() {
            self.head.land();
        }
        self.settings = settings;
    }

    /// Z follows the sheet from here on, or does not. Returns what the switches of the head read at its place.
    pub(crate) fn height_control(&mut self, law: Option<HeightLaw>, at: &Axes) -> Vec<(u8, bool)> {
        self.head.land();
        let lent = Lent { inputs: &self.ahead, modes: &self.settings.io };
        let read = self.head.use_law(law, at, lent);
        read.iter().for_each(|(input, on)| self.both(|inputs| inputs.put(*input, *on)));
        read
    }

    /// The settings in force.
    pub(crate) fn settings(&self) -> &Settings {
        &self.settings
    }

    /// Z stays where height control has carried it.
    pub(crate) fn land(&mut self) {
        self.head.land();
    }

    /// A move was made.
    pub(crate) fn made(&mut self, t0_s: f64, plan: &Plan, span: &Span<'_>) -> LiftOfMove {
        let lent = Lent { inputs: &self.inputs, modes: &self.settings.io };
        let carried = self.head.follow_sheet(lent, t0_s, plan, span);
        self.carriages.moved(span.made.from, span.made.to);
        while self.inputs.step(t0_s + span.t1_s, &self.settings.io).is_some() {}
        carried
    }

    /// Only this motor of an axis moves; nothing for all.
    pub(crate) const fn move_alone(&mut self, motor: Option<(Axis, usize)>) {
        self.carriages.move_alone(motor);
    }

    /// Tells whether a home switch of an axis is on.
    pub(crate) fn home_switch(&self, axis: Axis, which: Which) -> bool {
        self.carriages.is_on(axis, which)
    }

    /// The place of an axis is its zero.
    pub(crate) fn zero(&mut self, axis: Axis, place: f64) {
        self.carriages.zeroed(axis, place);
    }

    /// An axis without power was pushed by hand.
    pub(crate) fn pushed(&mut self, axis: Axis, by: f64, believed: Axes) {
        self.pushes.astray[axis] += by;
        self.carriages.pushed(axis, by, believed);
    }
}

/// Returns what inputs read on a simulated machine that nobody has touched, by their numbers.
pub fn untouched(machine: &Configuration) -> impl Fn(u8) -> bool {
    let mut physics = Physics::default();
    physics.equip(machine, Axes::default());
    move |number| physics.inputs.reads(number, &physics.settings.io)
}
