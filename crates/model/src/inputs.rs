//! The input switches, the lines of the ports, and the script that moves them.

use kerf_machine::lines::Input;
use kerf_machine::settings::io::IoMap;
use kerf_program::settings::{IoModes, LINES};
use serde::{Deserialize, Serialize};
use std::collections::{BTreeSet, VecDeque};
use std::str::FromStr;

/// An input changes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Change {
    /// Its number.
    pub input: u8,
    /// Time of the change, seconds of machine time.
    pub at_s: f64,
    /// Its state from then on.
    pub on: bool,
}

/// `NUMBER@SECONDS=STATE`, as `3@2.5=1`, or a name instead of the number; the error says what to give.
impl FromStr for Change {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let parts = text.split_once('@').and_then(|(n, rest)| Some((n, rest.split_once('=')?)));
        let Some((input, (at, state))) = parts else {
            return Err("give NUMBER@SECONDS=STATE, as 3@2.5=1".into());
        };
        let input = input_number(input)?;
        let at_s = at.trim().parse().ok().filter(|t: &f64| t.is_finite() && *t >= 0.0);
        let at_s = at_s.ok_or("the time is a number of seconds, 0 or more")?;
        let on = match state.trim() {
            "0" => false,
            "1" => true,
            _ => return Err("the state is 0 or 1".into()),
        };
        Ok(Self { input, at_s, on })
    }
}

/// An input, by its number or its name.
///
/// # Errors
/// What inputs are called, when this is none.
pub fn input_number(text: &str) -> Result<u8, String> {
    let number = text.trim().parse().ok().filter(|n| (1..=12).contains(n));
    let named = || match text.trim() {
        "cable" => Some(CABLE),
        "stall" => Some(STALL),
        name => Input::named(name).map(Input::number),
    };
    let unknown = || "inputs are numbered 1 to 12, or named, as arc, estop, cable or stall".into();
    number.or_else(named).ok_or_else(unknown)
}

/// Effect of an input on motion (command reference, VN).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Duty {
    /// Nothing.
    Free,
    /// Stops motion when it is triggered and limits are active.
    Limit,
    /// Stops motion and forbids it until it is released.
    Stop,
    /// The cable to the controller: without it nothing moves.
    Cable,
    /// A motor has stalled.
    Stall,
}

/// The number under which a script pulls the cable to the controller (0) and plugs it in (1).
pub const CABLE: u8 = u8::MAX;

/// The number under which a script has a motor stall (1).
pub const STALL: u8 = u8::MAX - 1;

/// The emergency stop (command reference, VN field 2).
pub const STOP_INPUT: u8 = 4;

/// Lines behind the ports: what the controller notices of height control.
const NOTICED: usize = 4;

/// Every line that has a state; the last is the cable.
const ALL: usize = LINES + NOTICED + 1;

/// States of the inputs, and the changes still to come.
#[derive(Clone, Debug, PartialEq)]
pub struct Inputs {
    script: Vec<Change>,
    /// Number of changes of the script that have happened.
    done: usize,
    /// Changes that the sensors of the head will tell while the machine follows its plan, in order of time.
    foreseen: VecDeque<Change>,
    /// Wiring of the pins of the ports.
    pins: IoMap,
    /// Contact closed or open, of a port the level of its pin; `None` for an input no script speaks of: it
    /// stays at rest.
    contact: [Option<bool>; ALL + 1],
    /// Switches that somebody moved by hand, and where they were left.
    by_hand: [Option<bool>; ALL + 1],
}

impl Default for Inputs {
    fn default() -> Self {
        Self {
            script: Vec::new(),
            done: 0,
            foreseen: VecDeque::new(),
            pins: IoMap::default(),
            contact: [None; ALL + 1],
            by_hand: [None; ALL + 1],
        }
    }
}

impl Inputs {
    /// Inputs that follow a script. Before its first change an input is in the other state; inputs
    /// without changes rest: normally closed ones closed, the others open. Changes of inputs that do
    /// not exist, or at no finite time, are left out.
    pub fn new(mut script: Vec<Change>) -> Self {
        script.retain(|c| index(c.input).is_some() && c.at_s.is_finite());
        script.sort_by(|a, b| a.at_s.total_cmp(&b.at_s));
        let mut contact = [None; ALL + 1];
        for change in script.iter().rev() {
            if let Some(i) = index(change.input) {
                contact[i] = Some(!change.on);
            }
        }
        Self { script, contact, ..Self::default() }
    }

    /// The same, with switches where earlier inputs were left by hand; a script has its way.
    #[must_use]
    pub fn after(mut self, earlier: &Self) -> Self {
        (self.by_hand, self.pins) = (earlier.by_hand, earlier.pins);
        for (contact, by_hand) in self.contact.iter_mut().zip(self.by_hand) {
            *contact = contact.or(by_hand);
        }
        self
    }

    /// The pins of the ports are wired like this from here on: their levels stay as they are.
    pub const fn wire(&mut self, pins: IoMap) {
        self.pins = pins;
    }

    /// Switches that somebody moved by hand, and where they were left.
    pub fn moved_by_hand(&self) -> Vec<(u8, bool)> {
        let moved = |(i, on): (usize, &Option<bool>)| Some((number_of(i), (*on)?));
        self.by_hand.iter().enumerate().filter_map(moved).collect()
    }

    /// Somebody moves a switch at a moment that is not over yet; it stays there.
    pub fn press(&mut self, change: Change) {
        let Some(i) = index(change.input).filter(|_| change.at_s.is_finite()) else { return };
        self.by_hand[i] = Some(change.on);
        self.learn(change);
    }

    /// Returns `true` if a script moves an input, or somebody has by hand: then nothing that is simulated moves it.
    pub fn is_told(&self, number: u8) -> bool {
        let by_hand = index(number).and_then(|i| self.by_hand.get(i)).is_some_and(Option::is_some);
        by_hand || self.script.iter().any(|change| change.input == number)
    }

    /// Returns what a program reads: ON or OFF. The emergency stop reads ON when it is pressed, however it
    /// is wired.
    pub fn reads(&self, number: u8, modes: &IoModes) -> bool {
        index(number).is_some_and(|i| signal(number, self.closed(i, modes), modes))
    }

    /// As they will be at a moment.
    pub fn at(&self, t_s: f64, modes: &IoModes) -> Self {
        let mut inputs = self.clone();
        while inputs.step(t_s, modes).is_some() {}
        inputs
    }

    /// The first moment, not before one that is given, at which an input reads a state.
    pub(crate) fn when(&self, number: u8, on: bool, from_s: f64, modes: &IoModes) -> Option<f64> {
        let mut inputs = self.at(from_s, modes);
        let mut t_s = from_s;
        while inputs.reads(number, modes) != on {
            t_s = inputs.step(f64::INFINITY, modes)?.at_s;
        }
        Some(t_s)
    }

    /// Returns the number of the first input that forbids motion now; nothing when none does.
    pub(crate) fn stopping(&self, modes: &IoModes) -> Option<u8> {
        let active = |n: &u8| {
            let i = usize::from(*n) - 1;
            duty(*n, modes) == Duty::Stop && triggers(*n, self.closed(i, modes), modes)
        };
        switches(modes).find(active)
    }

    /// A limit switch that is on, or whose wire is broken, but for those that are passed over.
    pub(crate) fn limiting(&self, modes: &IoModes, past: &BTreeSet<u8>) -> Option<u8> {
        let active = |n: &u8| {
            let i = usize::from(*n) - 1;
            duty(*n, modes) == Duty::Limit && triggers(*n, self.closed(i, modes), modes)
        };
        switches(modes).filter(|n| !past.contains(n)).find(active)
    }

    /// The next change that has an effect, not later than a time; of a pin, what its input reads from then on.
    #[inline]
    pub fn step(&mut self, until_s: f64, modes: &IoModes) -> Option<Change> {
        if self.is_due(until_s) { self.step_due(until_s, modes) } else { None }
    }

    fn step_due(&mut self, until_s: f64, modes: &IoModes) -> Option<Change> {
        while let Some(change) = self.next_until(until_s) {
            let Some(i) = index(change.input) else { continue };
            let before = self.closed(i, modes);
            self.contact[i] = Some(change.on);
            let on = self.closed(i, modes);
            if before != on {
                return Some(Change { on, ..change });
            }
        }
        None
    }

    /// Inputs that changed from a moment on, up to now, and what they read.
    pub(crate) fn changed_since(&self, from_s: f64, modes: &IoModes) -> Vec<(u8, bool)> {
        let past = self.script.get(..self.done).unwrap_or_default();
        let before = past.partition_point(|change| change.at_s < from_s);
        let (earlier, late) = past.split_at(before);
        let differs = |change: &&Change| {
            let last = earlier.iter().rev().find(|other| other.input == change.input);
            last.is_none_or(|last| last.on != change.on)
        };
        let changed = late.iter().filter(differs).map(|change| change.input);
        let mut changed: Vec<u8> = changed.collect();
        changed.dedup();
        changed.into_iter().map(|number| (number, self.reads(number, modes))).collect()
    }

    /// Takes the next change, of the script or foreseen, not later than a time.
    fn next_until(&mut self, until_s: f64) -> Option<Change> {
        let next = self.next().filter(|change| change.at_s <= until_s)?;
        if self.is_foreseen_first() {
            self.foreseen.pop_front();
        } else {
            self.done += 1;
        }
        Some(next)
    }

    /// The same as they are known to whoever is told of them: nothing of what is to come.
    pub fn known(&self) -> Self {
        let (script, foreseen) = (Vec::new(), VecDeque::new());
        Self { script, done: 0, foreseen, ..self.clone() }
    }

    /// Somebody tells of a change at a moment that is not over yet.
    pub(crate) fn learn(&mut self, change: Change) {
        if index(change.input).is_some() && change.at_s.is_finite() {
            let place = self.script.partition_point(|c| c.at_s <= change.at_s).max(self.done);
            self.script.insert(place, change);
        }
    }

    /// Returns the moment of the last change that is told and has not happened yet.
    pub(crate) fn told_s(&self) -> Option<f64> {
        self.script.get(self.done..)?.last().map(|change| change.at_s)
    }

    /// Nothing is known any more of what was told from a moment on.
    pub(crate) fn forget(&mut self, from_s: f64) {
        let place = self.script.partition_point(|change| change.at_s < from_s).max(self.done);
        self.script.truncate(place);
    }

    /// Returns `true` if a change up to a time has not happened yet.
    #[inline]
    pub fn is_due(&self, until_s: f64) -> bool {
        self.next().is_some_and(|change| change.at_s <= until_s)
    }

    /// The next change, of the script or foreseen.
    #[inline]
    pub fn next(&self) -> Option<Change> {
        match self.is_foreseen_first() {
            true => self.foreseen.front().copied(),
            false => self.script.get(self.done).copied(),
        }
    }

    /// Returns `true` if a sensor tells the next change, and no script.
    #[inline]
    pub fn is_foreseen_first(&self) -> bool {
        let Some(foreseen) = self.foreseen.front() else { return false };
        self.script.get(self.done).is_none_or(|scripted| foreseen.at_s < scripted.at_s)
    }

    /// Has the next change happen, and returns it, not later than a time: the contact from then on, of a pin its level.
    pub fn happen(&mut self, until_s: f64) -> Option<Change> {
        let change = self.next_until(until_s)?;
        if let Some(contact) = index(change.input).and_then(|i| self.contact.get_mut(i)) {
            *contact = Some(change.on);
        }
        Some(change)
    }

    /// Has everything happen that came before a moment, and what somebody has done by hand until then.
    pub fn come_to(&mut self, t_s: f64) {
        let by_hand = |inputs: &Self, change: Change| {
            let moved = index(change.input).and_then(|i| inputs.by_hand.get(i)).copied().flatten();
            change.at_s <= t_s && !inputs.is_foreseen_first() && moved.is_some()
        };
        while self.next().is_some_and(|it| it.at_s < t_s || by_hand(self, it)) {
            self.happen(t_s);
        }
    }

    /// Returns `true` if the contact of an input is known to be so.
    pub fn is_known(&self, change: &Change) -> bool {
        index(change.input).is_some_and(|i| self.contact.get(i) == Some(&Some(change.on)))
    }

    /// The machine itself moves a switch now: it reads this from here on.
    pub fn put(&mut self, number: u8, on: bool) {
        if let Some(i) = index(number) {
            self.contact[i] = Some(self.pins.line_level(number, on));
        }
    }

    /// An input that nobody has moved and no script speaks of reads this.
    pub fn rests(&mut self, number: u8, on: bool) {
        let level = self.pins.line_level(number, on);
        if let Some(contact) = index(number).and_then(|i| self.contact.get_mut(i)) {
            contact.get_or_insert(level);
        }
    }

    /// From here on the sensors of the head will have inputs read this, and nothing that was foreseen before.
    pub fn foresee(&mut self, changes: Vec<Change>) {
        let level = |change: Change| {
            let on = self.pins.line_level(change.input, change.on);
            Change { on, ..change }
        };
        self.foreseen = changes.into_iter().map(level).collect();
    }

    /// The moment, not before one that is given, at which a change to come has an input read a state.
    pub fn changes_s(&self, number: u8, on: bool, from_s: f64, modes: &IoModes) -> Option<f64> {
        let mut inputs = self.clone();
        loop {
            let change = inputs.happen(f64::INFINITY)?;
            let comes = change.input == number && inputs.reads(number, modes) == on;
            if comes && change.at_s >= from_s {
                return Some(change.at_s);
            }
        }
    }

    /// Tells whether a contact is closed; of a pin, what its input reads.
    fn closed(&self, i: usize, modes: &IoModes) -> bool {
        let number = number_of(i);
        match self.contact[i] {
            Some(on) => self.pins.line_reads(number, on),
            None => normally_closed(number, modes) || self.pins.open_line_reads(number),
        }
    }
}

fn number_of(i: usize) -> u8 {
    match i {
        ALL => STALL,
        i if i == ALL - 1 => CABLE,
        i => i as u8 + 1,
    }
}

fn index(number: u8) -> Option<usize> {
    match number {
        STALL => Some(ALL),
        CABLE => Some(ALL - 1),
        _ => (1..ALL as u8).contains(&number).then(|| usize::from(number) - 1),
    }
}

/// Contact to what a program reads.
pub(crate) fn signal(number: u8, closed: bool, modes: &IoModes) -> bool {
    if number == STOP_INPUT { triggers(number, closed, modes) } else { closed }
}

/// Tells whether a contact in this state triggers the input.
pub fn triggers(number: u8, closed: bool, modes: &IoModes) -> bool {
    closed != normally_closed(number, modes)
}

/// The contact of an input that a controller reports as active, however it is wired.
pub fn contact(number: u8, active: bool, modes: &IoModes) -> bool {
    active != normally_closed(number, modes)
}

/// The state of a pin, as a controller reports it, in which an input reads as given.
pub fn pin(number: u8, on: bool, modes: &IoModes) -> bool {
    signal(number, contact(number, true, modes), modes) == on
}

/// The inputs that can do anything to motion, by number.
fn switches(modes: &IoModes) -> impl Iterator<Item = u8> {
    let last = modes.inputs.len() as u8;
    let beyond = modes.interlock.filter(|n| *n > last && usize::from(*n) <= LINES);
    (1..=last).chain(beyond)
}

/// Returns the effect of an input on motion.
pub fn duty(number: u8, modes: &IoModes) -> Duty {
    match number {
        CABLE => return Duty::Cable,
        STALL => return Duty::Stall,
        _ => {}
    }
    if number == STOP_INPUT || modes.interlock == Some(number) {
        return Duty::Stop;
    }
    match mode(number, modes) {
        1 | 2 if modes.limits_active => Duty::Limit,
        3 | 4 => Duty::Stop,
        _ => Duty::Free,
    }
}

fn normally_closed(number: u8, modes: &IoModes) -> bool {
    if number == STOP_INPUT {
        return !modes.input4_normally_open;
    }
    number == CABLE || matches!(mode(number, modes), 2 | 4)
}

/// The mode of a switch; lines of the ports have none.
fn mode(number: u8, modes: &IoModes) -> u8 {
    modes.inputs.get(usize::from(number).wrapping_sub(1)).copied().unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;
    use kerf_program::Settings;

    fn modes(edit: impl FnOnce(&mut IoModes)) -> IoModes {
        let mut modes = Settings::default().io;
        edit(&mut modes);
        modes
    }

    #[test]
    fn an_input_was_in_the_other_state_before_its_first_change() {
        let io = modes(|_| ());
        let mut inputs = Inputs::new(vec![Change { input: 3, at_s: 2.0, on: false }]);
        assert!(inputs.reads(3, &io) && !inputs.reads(2, &io));
        assert_eq!(inputs.step(1.9, &io), None);
        assert_eq!(inputs.step(2.0, &io).map(|c| c.input), Some(3));
        assert!(!inputs.reads(3, &io));
    }

    #[test]
    fn changes_come_in_order_of_time_and_repeated_states_are_none() {
        let io = modes(|_| ());
        let change = |input, at_s, on| Change { input, at_s, on };
        let script = vec![change(2, 3.0, true), change(1, 1.0, true), change(1, 2.0, true)];
        let mut inputs = Inputs::new(script);
        let seen: Vec<u8> = std::iter::from_fn(|| inputs.step(9.0, &io)).map(|c| c.input).collect();
        assert_eq!(seen, [1, 2]);
    }

    #[test]
    fn the_emergency_stop_reads_pressed_however_it_is_wired() {
        let closed = modes(|_| ());
        let open = modes(|m| m.input4_normally_open = true);
        for (on, wiring, pressed) in
            [(false, &closed, true), (true, &closed, false), (true, &open, true)]
        {
            let mut inputs = Inputs::new(vec![Change { input: 4, at_s: 0.0, on }]);
            while inputs.step(0.0, wiring).is_some() {}
            assert_eq!(inputs.reads(4, wiring), pressed, "{on}");
            assert_eq!(inputs.stopping(wiring).is_some(), pressed, "{on}");
        }
        assert!(!Inputs::default().reads(4, &closed));
    }

    #[test]
    fn a_normally_closed_input_without_a_script_rests() {
        let io = modes(|m| m.inputs[4] = 4);
        assert!(Inputs::default().reads(5, &io));
        assert_eq!(Inputs::default().stopping(&io), None);
    }

    #[test]
    fn a_switch_that_was_moved_by_hand_stays_there() {
        let io = modes(|_| ());
        let mut inputs = Inputs::new(vec![Change { input: 1, at_s: 5.0, on: true }]);
        inputs.press(Change { input: 3, at_s: 2.0, on: true });
        inputs.press(Change { input: 2, at_s: 2.0, on: true });
        let seen: Vec<u8> = std::iter::from_fn(|| inputs.step(9.0, &io)).map(|c| c.input).collect();
        assert_eq!(seen, [3, 2, 1]);
        let script = vec![Change { input: 2, at_s: 1.0, on: true }];
        let next = Inputs::new(script).after(&inputs);
        assert!(next.reads(3, &io) && !next.reads(2, &io), "a script knows what was before");
        assert!(!next.reads(1, &io), "what a script did is over with it");
    }

    #[test]
    fn inputs_that_do_not_exist_are_left_out() {
        let nowhere = Change { input: 33, at_s: 0.0, on: true };
        let never = Change { input: 1, at_s: f64::NAN, on: true };
        let inputs = Inputs::new(vec![nowhere, never]);
        assert_eq!(inputs, Inputs::default());
        assert!(!inputs.reads(33, &modes(|_| ())));
    }
}
