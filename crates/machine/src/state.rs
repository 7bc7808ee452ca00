//! States of a machine, and the effects of the events that stop it: one table for both manuals.
//!
//! OpenSBP's stop (ramp down, pull out, resume with no location lost) and Profiler's pause are the
//! same states with other [`StopSettings`]. The table below is the whole truth: whoever runs a machine
//! asks it for the next state and carries out the effects in order; the diagram in the book is drawn
//! from it. What is not in the table may not happen: a motion command while the machine is stopped is
//! refused because there is no such row.

use kerf_program::Button;

/// Time to wait for the release of a stop input before the operator is asked again, seconds.
pub const RELEASE_S: f64 = 0.5;

/// State of a machine.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum State {
    /// Nothing; programs and moves by hand may start.
    #[default]
    Idle,
    /// A start was given, and waits for a door, a jig or the second Start.
    Waiting,
    /// A program or job runs.
    Running,
    /// It slows down along the path.
    Stopping,
    /// It stands, and goes on or is given up.
    Paused,
    /// A stop input is, or was, active: nothing moves before it is released and a person says so.
    Blocked,
    /// The machine stands on a limit switch: a person decides if it goes on regardless.
    Limited,
    /// It slows down because of the emergency stop.
    EmergencyStopping,
    /// The emergency stop is, or was, pressed; nobody has acknowledged it yet.
    Emergency,
    /// Something ended the program for good, and a person has to look before anything moves again.
    Alarm,
}

/// An event that may change the state of a machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Event {
    /// Start of a program or job.
    Start,
    /// The door, the jig or the second Start that was waited for is there.
    Ready,
    /// Stop: a key, the console.
    Stop,
    /// A stop input is active, or the enclosure is open.
    StopInput,
    /// The stop input is released, and a person says so.
    Released,
    /// Something is wrong with the process: the arc is lost, no reading, the head too close.
    Fault,
    /// The emergency stop is pressed.
    EmergencyStop,
    /// The emergency stop of a machine that cuts the power with it.
    PowerCut,
    /// The emergency stop is released, and a person says so.
    Acknowledge,
    /// A limit switch, or a move that would leave the limits.
    Limit,
    /// A person says that limits do not count until the program ends.
    Override,
    /// The link to the controller, or to whoever watches over the run, is lost.
    LinkLost,
    /// A motor has lost its steps.
    Stall,
    /// The machine has come to rest.
    Stands,
    /// Start again: the job goes on.
    Continue,
    /// The job is given up.
    Abort,
    /// The program has come to its end.
    End,
}

/// An effect of an event; several are carried out in this order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Effect {
    /// Cut outputs and intensity go off at once, still in motion.
    CutOffAtOnce,
    /// Motion slows down along the path; no step is lost.
    SlowDown,
    /// Motion stops at once; a limit switch leaves no way for a ramp.
    Halt,
    /// Cut outputs, intensity and height control go off.
    CutOff,
    /// The router goes off.
    RouterOff,
    /// Every spindle goes off, and whatever moves by itself.
    SpindleOff,
    /// Every output goes off.
    AllOff,
    /// Outputs become what they are at the end of a program: of a job all go off.
    LeaveOutputs,
    /// The motors lose their power five seconds later.
    MotorsOff,
    /// The place of the axes is in doubt from now on.
    Doubt,
    /// The tool rises to the height of travel, where it is lower.
    Raise,
    /// Tool outputs go off.
    ToolOff,
    /// The place on the path is kept, to come back to.
    KeepPlace,
    /// Back to the place: travel, router, tool, plunge, cut, each with its delay.
    ComeBack,
    /// ZTop and ZSurface return to what they were when the job began.
    RestoreHeights,
}

/// Settings of a stop that differ between the manuals and between machines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StopSettings {
    /// The tool rises once the machine stands: Profiler's "Raise On Pause", always in OpenSBP.
    pub raise: bool,
    /// Pausing switches cut outputs, router and tool; OpenSBP leaves outputs to their modes (VN).
    pub outputs: bool,
}

impl StopSettings {
    /// The stop of OpenSBP: pull out to safe Z, outputs by their modes.
    pub const OPENSBP: Self = Self { raise: true, outputs: false };

    /// The pause of Profiler.
    pub const fn profiler(raise: bool) -> Self {
        Self { raise, outputs: true }
    }
}

/// Outcome of an event.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Next {
    /// The state from then on.
    pub state: State,
    /// Effects, in order.
    pub effects: Vec<Effect>,
}

/// One row of the table.
struct Row(State, Event, State, &'static [Effect]);

/// Table of the state machine.
const ROWS: &[Row] = {
    use Effect::{
        AllOff, ComeBack, CutOff, CutOffAtOnce, Doubt, Halt, KeepPlace, LeaveOutputs, MotorsOff,
        Raise, RestoreHeights, RouterOff, SlowDown, SpindleOff, ToolOff,
    };
    use Event as E;
    use State as S;
    &[
        Row(S::Idle, E::Start, S::Waiting, &[]),
        Row(S::Idle, E::EmergencyStop, S::EmergencyStopping, &[CutOffAtOnce, SlowDown]),
        Row(S::Waiting, E::Ready, S::Running, &[]),
        Row(S::Waiting, E::Stop, S::Idle, &[LeaveOutputs]),
        Row(S::Waiting, E::Abort, S::Idle, &[LeaveOutputs]),
        Row(S::Waiting, E::EmergencyStop, S::EmergencyStopping, &[CutOffAtOnce, SlowDown]),
        Row(S::Waiting, E::StopInput, S::Blocked, &[SlowDown, CutOff, SpindleOff]),
        Row(S::Waiting, E::Limit, S::Limited, &[Halt, CutOff, RouterOff]),
        Row(S::Running, E::Stop, S::Stopping, &[SlowDown, KeepPlace]),
        Row(S::Running, E::Fault, S::Stopping, &[SlowDown, KeepPlace]),
        Row(S::Running, E::StopInput, S::Blocked, &[SlowDown, KeepPlace, CutOff, SpindleOff]),
        Row(
            S::Running,
            E::EmergencyStop,
            S::EmergencyStopping,
            &[CutOffAtOnce, SlowDown, KeepPlace],
        ),
        Row(S::Running, E::PowerCut, S::Alarm, &[Halt, SpindleOff, AllOff, MotorsOff, Doubt]),
        Row(S::Running, E::Limit, S::Limited, &[Halt, KeepPlace, CutOff, RouterOff]),
        Row(S::Running, E::LinkLost, S::Alarm, &[SlowDown, CutOff, AllOff, Doubt]),
        Row(S::Running, E::Stall, S::Alarm, &[CutOff, LeaveOutputs, Doubt]),
        Row(S::Running, E::End, S::Idle, &[LeaveOutputs, RestoreHeights]),
        Row(S::Stopping, E::Stands, S::Paused, &[CutOff, RouterOff, Raise, ToolOff]),
        Row(S::Stopping, E::EmergencyStop, S::EmergencyStopping, &[CutOffAtOnce, SlowDown]),
        Row(S::Paused, E::Continue, S::Running, &[ComeBack]),
        Row(S::Paused, E::Abort, S::Idle, &[LeaveOutputs, RestoreHeights]),
        Row(S::Paused, E::EmergencyStop, S::EmergencyStopping, &[CutOffAtOnce, SlowDown]),
        Row(S::Paused, E::StopInput, S::Blocked, &[SlowDown, CutOff, SpindleOff]),
        Row(S::Paused, E::PowerCut, S::Alarm, &[SpindleOff, AllOff, MotorsOff, Doubt]),
        Row(S::Paused, E::LinkLost, S::Alarm, &[AllOff, Doubt]),
        Row(S::Blocked, E::Released, S::Paused, &[CutOff, RouterOff, Raise, ToolOff]),
        Row(S::Blocked, E::Abort, S::Idle, &[LeaveOutputs, RestoreHeights]),
        Row(S::Blocked, E::EmergencyStop, S::EmergencyStopping, &[CutOffAtOnce, SlowDown]),
        Row(S::Blocked, E::PowerCut, S::Alarm, &[SpindleOff, AllOff, MotorsOff, Doubt]),
        Row(S::Limited, E::Override, S::Running, &[ComeBack]),
        Row(S::Limited, E::Abort, S::Alarm, &[LeaveOutputs, RestoreHeights]),
        Row(S::Limited, E::EmergencyStop, S::EmergencyStopping, &[CutOffAtOnce, SlowDown]),
        Row(S::Limited, E::PowerCut, S::Alarm, &[SpindleOff, AllOff, MotorsOff, Doubt]),
        Row(S::EmergencyStopping, E::Stands, S::Emergency, &[CutOff, AllOff, Raise]),
        Row(S::Emergency, E::Acknowledge, S::Paused, &[]),
        Row(S::Emergency, E::Abort, S::Idle, &[LeaveOutputs, RestoreHeights]),
        Row(S::Alarm, E::Acknowledge, S::Idle, &[RestoreHeights]),
        Row(S::Alarm, E::EmergencyStop, S::EmergencyStopping, &[CutOffAtOnce, SlowDown]),
    ]
};

impl State {
    /// Its name in traces and messages.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Idle => "idle",
            Self::Waiting => "waiting",
            Self::Running => "running",
            Self::Stopping => "stopping",
            Self::Paused => "paused",
            Self::Blocked => "blocked",
            Self::Limited => "limit",
            Self::EmergencyStopping => "estopping",
            Self::Emergency => "estop",
            Self::Alarm => "alarm",
        }
    }

    /// The answers to the question of a machine that stands: it goes on, or that is the end.
    pub const fn ways_on(self) -> [Button; 2] {
        match self {
            Self::Limited => [Button::Continue, Button::End],
            _ => [Button::Resume, Button::Quit],
        }
    }

    /// Returns the outcome of an event; nothing when the event may not happen in this state.
    pub fn on(self, event: Event, settings: StopSettings) -> Option<Next> {
        let Row(_, _, state, effects) =
            ROWS.iter().find(|Row(state, on, ..)| (*state, *on) == (self, event))?;
        let effects = effects.iter().copied().filter(|effect| effect.holds(settings)).collect();
        Some(Next { state: *state, effects })
    }
}

impl Effect {
    /// Returns `true` if it is done with these settings.
    const fn holds(self, settings: StopSettings) -> bool {
        match self {
            Self::Raise => settings.raise,
            // The tool stays in the material: what cools or clears it stays on.
            Self::ToolOff => settings.raise && settings.outputs,
            Self::RouterOff | Self::CutOff => settings.outputs,
            _ => true,
        }
    }

    /// Returns its name in the diagram.
    pub const fn name(self) -> &'static str {
        match self {
            Self::CutOffAtOnce => "cut off at once",
            Self::SlowDown => "slow down",
            Self::Halt => "halt",
            Self::CutOff => "cut off",
            Self::RouterOff => "router off",
            Self::SpindleOff => "spindles off",
            Self::AllOff => "all outputs off",
            Self::LeaveOutputs => "outputs as at the end",
            Self::MotorsOff => "motors off 5 s later",
            Self::Doubt => "location in doubt",
            Self::Raise => "raise",
            Self::ToolOff => "tool off",
            Self::KeepPlace => "keep the place",
            Self::ComeBack => "come back",
            Self::RestoreHeights => "restore heights",
        }
    }
}

/// The table as a state diagram in the words of Mermaid, and as rows for people.
pub fn diagram() -> String {
    let mut text = String::from("stateDiagram-v2\n    [*] --> idle\n");
    for Row(from, event, to, _) in ROWS {
        let event = format!("{event:?}");
        text += &format!("    {} --> {}: {event}\n", from.name(), to.name());
    }
    text
}

/// The rows of the table: state, event, next state, effects.
pub fn rows() -> impl Iterator<Item = (State, Event, State, &'static [Effect])> {
    ROWS.iter().map(|Row(from, event, to, effects)| (*from, *event, *to, *effects))
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn check(from: State, event: Event, raise: bool, to: State, effects: &[Effect]) {
        let next = from.on(event, StopSettings::profiler(raise));
        assert_eq!(next, Some(Next { state: to, effects: effects.to_vec() }));
    }

    #[test]
    fn a_pause_switches_off_and_rises_only_when_that_is_set() {
        use Effect::{CutOff, KeepPlace, Raise, RouterOff, SlowDown, ToolOff};
        check(State::Running, Event::Stop, true, State::Stopping, &[SlowDown, KeepPlace]);
        let raised = [CutOff, RouterOff, Raise, ToolOff];
        check(State::Stopping, Event::Stands, true, State::Paused, &raised);
        check(State::Stopping, Event::Stands, false, State::Paused, &[CutOff, RouterOff]);
    }

    #[test]
    fn the_stop_of_part_files_leaves_outputs_to_their_modes() {
        let next = State::Stopping.on(Event::Stands, StopSettings::OPENSBP);
        assert_eq!(next.map(|next| next.effects), Some(vec![Effect::Raise]));
    }

    #[test]
    fn nothing_starts_in_an_emergency() {
        for event in [Event::Start, Event::Continue, Event::Ready] {
            for state in [State::Emergency, State::Alarm, State::Blocked, State::Limited] {
                assert_eq!(state.on(event, StopSettings::OPENSBP), None, "{state:?}");
            }
        }
    }

    #[test]
    fn what_a_stop_input_stopped_goes_on_only_by_way_of_a_pause() {
        let blocked = State::Running.on(Event::StopInput, StopSettings::OPENSBP).unwrap();
        let effects = [Effect::SlowDown, Effect::KeepPlace, Effect::SpindleOff];
        assert_eq!((blocked.state, &blocked.effects[..]), (State::Blocked, &effects[..]));
        let released = blocked.state.on(Event::Released, StopSettings::OPENSBP).unwrap();
        assert_eq!((released.state, released.effects), (State::Paused, vec![Effect::Raise]));
    }

    #[test]
    fn no_row_stands_twice_and_every_state_can_be_left() {
        for (n, Row(from, event, ..)) in ROWS.iter().enumerate() {
            assert!(!ROWS[..n].iter().any(|Row(f, e, ..)| (f, e) == (from, event)), "{from:?}");
        }
        for (_, _, to, _) in rows() {
            assert!(rows().any(|(from, ..)| from == to), "{to:?} is a trap");
        }
    }
}
