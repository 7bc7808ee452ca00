//! The gate: the one place that decides who may have the machine move, go on, or switch something dangerous.
//!
//! ```text
//!  act (socket, HTTP) ──┐
//!  answer to a question ┤
//!  request of a key ───────┤   needs: role, turn at driving,      met by whoever asks?
//!  value of the registry┼─►        arming, password ─────────► yes: done, unless a stop came since it was asked
//!  order that begins ───┤                                      no:  the reason, and how it is mended
//!  command passed in ───┘
//! ```
//!
//! [`needs`] is the only list. The page `docs/book/who-may-what.md` is made from what a server answers to each
//! line of it; that nothing has begun that was stopped meanwhile is looked after in [`asker`](crate::asker).

use crate::machine::Order;
use crate::refusal::problem;
use crate::setup::Options;
use kerf_control::answers::{self, Effect};
use kerf_handconsole::{ConsoleRequest, Key};
use kerf_wire::{Act, Asked, CardAct, Lease, Mode, Problem, Role, Snapshot, State, Who, Why};
use kerf_workspace::stored;

/// Something that somebody asks for, by the way on which it came.
#[derive(Clone, Copy, Debug)]
pub enum Demand<'a> {
    /// A page or a script asks for it.
    Act(&'a Act),
    /// A key of the hand console asks for it.
    Console(&'a ConsoleRequest),
    /// The machine's thread begins it.
    Order(&'a Order),
    /// The run goes on.
    GoOn,
    /// A value of the registry is written over the network, under this key; a command comes as an act.
    Value(&'a str),
    /// A program on this computer passed a command in.
    PassedIn,
    /// The start-up line with which Kerf was started here asks for it.
    StartUp,
}

/// Conditions for something that is to be done.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Need {
    role: Role,
    turn: TurnNeeded,
    /// The machine has to be armed.
    armed: bool,
    /// The settings must not be locked by their password.
    unlocked: bool,
}

/// The turn at driving that something takes.
#[derive(Clone, Copy, Debug, PartialEq)]
enum TurnNeeded {
    /// None.
    Anybody,
    /// The one whose number it carries.
    Number(u32),
    /// The present one of whoever asks.
    Own,
}

const fn need(role: Role) -> Need {
    Need { role, turn: TurnNeeded::Anybody, armed: false, unlocked: false }
}

/// Returns the conditions for an act of the driver, also while the machine is disarmed.
const fn with_lease(lease: u32) -> Need {
    Need { turn: TurnNeeded::Number(lease), ..need(Role::Operator) }
}

/// Returns the conditions for what is only drawn: whoever drives has it done, also while the machine is disarmed.
const fn drawing(turn: TurnNeeded) -> Need {
    Need { turn, ..need(Role::Operator) }
}

/// Returns the conditions for letting go on what runs.
fn going_on(now: &Snapshot, turn: TurnNeeded) -> Need {
    let draws = now.job.as_ref().is_some_and(|job| job.draws_only && job.ended.is_none());
    if draws { drawing(turn) } else { driving(turn) }
}

/// Returns `true` if a part file or a typed line that begins now is only drawn: in preview, on a machine that nobody
/// armed. It does not leave preview then.
pub fn draws_only(now: &Snapshot) -> bool {
    now.machine.mode == Mode::Preview && !now.machine.armed
}

/// Returns the conditions for an act of the driver, with the machine armed.
const fn driving(turn: TurnNeeded) -> Need {
    Need { turn, armed: true, ..need(Role::Operator) }
}

/// The same for what changes settings of the machine.
const fn setting(need: Need) -> Need {
    Need { role: Role::Setter, unlocked: true, ..need }
}

/// Stop of the hand console.
pub const STOP_KEY: char = Key::Stop.character();

/// Decides what something takes. This is the one list.
///
/// # Errors
/// Nobody may have that done, in this way.
fn needs(now: &Snapshot, demand: Demand<'_>) -> Result<Need, Problem> {
    Ok(match demand {
        Demand::Act(act) => return needs_of_act(now, act),
        Demand::Console(request) => return needs_of_request(now, request),
        Demand::Order(order) if order.draws_only() => drawing(TurnNeeded::Own),
        Demand::Order(order) if order.moves() => driving(TurnNeeded::Own),
        Demand::Order(_) | Demand::StartUp => need(Role::Observer),
        Demand::GoOn => going_on(now, TurnNeeded::Own),
        Demand::Value(key) if stored::is_own(key) => {
            let text = format!(
                "Kerf alone writes {key}; values of your own have other names, as uValue or one with a $"
            );
            return Err(problem(Why::Malformed, text));
        }
        Demand::Value(_) => need(Role::Operator),
        Demand::PassedIn => Need { armed: true, ..need(Role::Observer) },
    })
}

fn needs_of_act(now: &Snapshot, act: &Act) -> Result<Need, Problem> {
    Ok(match act {
        Act::Key { key: STOP_KEY, .. } => need(Role::Observer),
        Act::Stop | Act::Hold | Act::Disarm | Act::JogStop { .. } | Act::Ping | Act::GiveUp => {
            need(Role::Observer)
        }
        Act::Answer { question, answer } => return needs_of_answer(now, Some(*question), answer),
        Act::Resume { lease } => going_on(now, TurnNeeded::Number(*lease)),
        Act::Run { lease, .. } if draws_only(now) => drawing(TurnNeeded::Number(*lease)),
        Act::Run { lease, .. }
        | Act::TakeUp { lease }
        | Act::JogStart { lease, .. }
        | Act::JogRenew { lease, .. }
        | Act::Lift { lease, .. }
        | Act::Nudge { lease, .. }
        | Act::Go { lease, .. }
        | Act::Bit { lease, .. }
        | Act::Step { lease, .. }
        | Act::Zero { lease, .. }
        | Act::TouchOff { lease }
        | Act::ToolIn { lease }
        | Act::ControllerCard { lease, task: CardAct::Run { .. } } => {
            driving(TurnNeeded::Number(*lease))
        }
        Act::Command { lease, line } => needs_of_typed(now, *lease, line),
        // A question may wait for that very switch.
        Act::Input { lease, .. } if now.machine.state == State::Asking => {
            driving(TurnNeeded::Number(*lease))
        }
        Act::GiveLease { lease }
        | Act::Arm { lease }
        | Act::Override { lease, .. }
        | Act::HeightMap { lease, .. }
        | Act::ControllerCard { lease, .. }
        | Act::Tool { lease, .. }
        | Act::ForgetPace { lease }
        | Act::Key { lease, .. }
        | Act::Input { lease, .. } => with_lease(*lease),
        Act::Set { lease, .. } => setting(with_lease(*lease)),
        Act::Wire { lease, .. }
        | Act::WireLook { lease, .. }
        | Act::WireAnswer { lease, .. }
        | Act::ControllerSteps { lease, .. } => setting(driving(TurnNeeded::Number(*lease))),
        Act::Protect { .. } | Act::Unlock { .. } => need(Role::Setter),
        Act::Folder { .. } => need(Role::Owner),
        Act::TakeLease { .. }
        | Act::Open { .. }
        | Act::Parameters { .. }
        | Act::Choose { .. }
        | Act::KeepOrigin
        | Act::SaveJob
        | Act::TakeShapeBack
        | Act::Machine { .. }
        | Act::Record { .. }
        | Act::Watch { .. }
        | Act::Close
        | Act::ClearPrinted
        | Act::SheetDone
        | Act::Acknowledge
        | Act::Draw { .. } => need(Role::Operator),
    })
}

fn needs_of_request(now: &Snapshot, request: &ConsoleRequest) -> Result<Need, Problem> {
    Ok(match request {
        ConsoleRequest::Stop => need(Role::Observer),
        ConsoleRequest::Answer(words) => return needs_of_answer(now, None, words),
        ConsoleRequest::Resume
        | ConsoleRequest::Start
        | ConsoleRequest::Jog(_)
        | ConsoleRequest::Go(_)
        | ConsoleRequest::Job(_) => driving(TurnNeeded::Own),
        ConsoleRequest::Set(_) | ConsoleRequest::KeepSettings => setting(driving(TurnNeeded::Own)),
        ConsoleRequest::Acknowledge
        | ConsoleRequest::TakeControl
        | ConsoleRequest::Open(_)
        | ConsoleRequest::AddShape(_)
        | ConsoleRequest::Look(_) => need(Role::Operator),
    })
}

/// An answer that fills in a value, or ends what asks, is free for operators; one after which the machine goes on
/// is an act of whoever drives. Motion is none: it has acts of its own, which somebody holds on to.
fn needs_of_answer(now: &Snapshot, question: Option<u32>, words: &str) -> Result<Need, Problem> {
    let open = |asked: &&Asked| question.is_none_or(|number| number == asked.number);
    // One that comes too late is refused where it is given.
    let Some(asked) = now.asked.as_ref().filter(open) else { return Ok(need(Role::Operator)) };
    match answers::kind_of(&asked.kind).map(|kind| answers::effect(kind, words)) {
        Some(Effect::Value | Effect::Ends) => Ok(need(Role::Operator)),
        Some(Effect::Moves) => Err(problem(Why::Malformed, NO_MOTION)),
        Some(Effect::GoesOn) | None => Ok(going_on(now, TurnNeeded::Own)),
    }
}

/// Said to an answer that is a motion.
const NO_MOTION: &str = "no answer moves the tool: hold a key of the keypad (jogStart), or nudge (nudge); both \
                         work while the question is open";

/// Typed lines need an armed machine where they can move or switch something.
fn needs_of_typed(now: &Snapshot, lease: u32, lines: &str) -> Need {
    let program = kerf_sbp::read_typed("command".into(), &format!("{lines}\n"));
    let need = if draws_only(now) || program.moves_nothing() {
        with_lease(lease)
    } else {
        driving(TurnNeeded::Number(lease))
    };
    if program.sets_machine() { setting(need) } else { need }
}

impl Need {
    /// Returns `true` if the machine may move by it, so that no stop may have come since it was asked for.
    pub const fn moves(self) -> bool {
        self.armed
    }

    /// Returns `true` if only who may change settings may have it done.
    pub const fn is_protected(self) -> bool {
        self.unlocked
    }

    /// Looks whether somebody meets it, but for the password.
    fn met(self, now: &Snapshot, who: &Who) -> Result<(), Problem> {
        if who.role < self.role {
            let text =
                format!("this needs the role {:?}, this device is {:?}", self.role, who.role);
            return Err(problem(Why::Role, text.to_lowercase()));
        }
        match (self.turn, &now.lease) {
            (TurnNeeded::Anybody, _) => {}
            (TurnNeeded::Number(number), Some(lease)) if lease.client == who.client => {
                if lease.number != number {
                    return Err(problem(Why::Lease, "this belongs to an older turn at driving"));
                }
            }
            (TurnNeeded::Own, Some(lease)) if lease.client == who.client => {}
            (_, Some(lease)) => return Err(driven_by(lease)),
            (_, None) => return Err(problem(Why::Lease, "nobody drives: take control first")),
        }
        if self.armed && !now.machine.armed {
            return Err(problem(Why::Disarmed, "the machine is disarmed: arm it first"));
        }
        Ok(())
    }
}

/// Decides whether somebody may have something done, as things are now.
///
/// # Errors
/// Why not.
pub fn pass(now: &Snapshot, who: &Who, demand: Demand<'_>) -> Result<Need, Problem> {
    let need = needs(now, demand)?;
    need.met(now, who).map(|()| need)
}

/// Refuses because somebody else drives: says who has the machine, and how it is had from there.
pub fn driven_by(Lease { device, .. }: &Lease) -> Problem {
    let who = if device.is_empty() { "another page" } else { device };
    let text = format!(
        "somebody else drives: {who}. Press Give up control there, or close that page; another page \
         takes it with Take control"
    );
    problem(Why::Lease, text)
}

/// Said where the machine is left alone.
const DRAWING_ONLY: &str =
    "this is not available in the editing version: only drawings are worked on here";

/// Said where only files are run.
const FILES_ONLY: &str = "Kerf was started for files only: no commands, no keypad";

/// Looks whether Kerf was started for acts of this sort.
pub fn open_here(options: &Options, act: &Act) -> Result<(), Problem> {
    if options.drawing_only && !is_of_drawings(act) {
        return Err(problem(Why::State, DRAWING_ONLY));
    }
    let files_only = options.start.as_ref().is_some_and(|start| start.display == 9);
    if files_only && is_by_hand(act) {
        return Err(problem(Why::State, FILES_ONLY));
    }
    Ok(())
}

/// Returns `true` if an act leaves the machine alone: it is about drawings and files, or it only stops.
const fn is_of_drawings(act: &Act) -> bool {
    matches!(
        act,
        Act::Ping
            | Act::GiveUp
            | Act::Stop
            | Act::Hold
            | Act::Disarm
            | Act::JogStop { .. }
            | Act::Draw { .. }
            | Act::Open { .. }
            | Act::Parameters { .. }
            | Act::Close
            | Act::ClearPrinted
            | Act::SheetDone
            | Act::Unlock { .. }
            | Act::Protect { .. }
    )
}

/// Returns `true` if an act is refused where only files are run.
fn is_by_hand(act: &Act) -> bool {
    match act {
        Act::Command { line, .. } => {
            let letters: String = line.trim().chars().take(2).collect();
            line.lines().count() != 1 || !letters.eq_ignore_ascii_case("FP")
        }
        Act::JogStart { .. }
        | Act::JogRenew { .. }
        | Act::Lift { .. }
        | Act::Nudge { .. }
        | Act::Wire { .. }
        | Act::WireLook { .. }
        | Act::WireAnswer { .. }
        | Act::Key { .. } => true,
        _ => false,
    }
}
