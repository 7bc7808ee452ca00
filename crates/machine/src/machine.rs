//! A machine as a run drives it.
//!
//! A [`Machine`] takes planned motion and what is switched in its place between two moves, stops on request, and tells
//! what has happened. What it has and can do it tells as data ([`Facts`]): nobody asks what kind it is.
//!
//! ```text
//!  run ── take(move …) ─────► Machine ── bytes, steps ──► axes, outputs
//!   │  ── set(output) ──────►    │
//!   │  ── stop ─────────────►    │
//!   └──◄─ News: reached, input, fault ┘
//! ```
//!
//! A run calls [`Machine::advance`] again and again: each call takes what there is room for, waits a moment at most and
//! tells how far the machine has come in its plan. Between two calls the run looks at what the operator asks for.
//!
//! Every machine passes the list in [`conformance`](crate::conformance).

use crate::driver::{Facts, Override, Shares};
use crate::homing::Which;
use crate::lift::LiftOfMove;
use kerf_motion::{Move, Plan, Span, State};
use kerf_program::{At, Axes, Axis, Beam, HeightLaw, OutputReason, Settings, SpindleTurn};
use std::cell::RefCell;
use std::rc::Rc;
use std::sync::Arc;

/// An input at whose change the machine is to stand at once.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Watch {
    /// Its number, as part files count.
    pub input: u8,
    /// The state of its pin that is waited for.
    pub active: bool,
}

/// A move of a plan that the machine is about to make.
#[derive(Clone, Copy, Debug)]
pub struct Going<'a> {
    /// Its plan.
    pub plan: &'a Plan,
    /// Which move of the plan.
    pub index: usize,
    /// Beginning of the plan, seconds of machine time.
    pub t0_s: f64,
    /// Before this move of the plan something else has to be done.
    pub until: usize,
    /// Share of the planned move that its own shares refer to: less than 1 where it ends at a stop within, 0
    /// where the machine moves beside the program.
    pub part: f64,
    /// Inputs at whose change it is to stand at once, while this plan is made. A machine that can stop by itself there
    /// stands at the very place, and tells the input as its news; one that looks at the input now and then makes the
    /// moves so slowly that it comes no farther than [`OVERRUN_MM`] behind it.
    pub watches: &'a [Watch],
}

/// Longest way behind the change of an input that is only looked at now and then, mm.
pub const OVERRUN_MM: f64 = 0.1;

impl Going<'_> {
    /// The move.
    pub fn made(&self) -> Option<&Move> {
        self.plan.moves().get(self.index)
    }

    /// Returns place and speed of every axis at a moment of machine time, seconds.
    pub fn at(&self, t_s: f64) -> State {
        self.plan.at(t_s - self.t0_s)
    }
}

/// A plan that is followed from a moment on.
#[derive(Clone, Copy, Debug)]
pub struct Ahead<'a> {
    /// The plan.
    pub plan: &'a Plan,
    /// Its beginning, seconds of machine time.
    pub t0_s: f64,
    /// The moment up to which the one before was made, seconds of machine time.
    pub from_s: f64,
}

/// A thing that is switched or set between two moves, or while the machine stands, and what it is set to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Actuator {
    /// An output goes on or off.
    Output {
        /// Its number, as part files count.
        number: u8,
        /// Its state from then on.
        on: bool,
        /// Reason for the switching.
        why: OutputReason,
    },
    /// The speed of a spindle, revolutions a minute; it need not turn.
    Spindle {
        /// Revolutions a minute.
        rpm: f64,
    },
    /// Which way the spindle turns.
    Turn(SpindleTurn),
    /// Coolant.
    Coolant {
        /// Mist.
        mist: bool,
        /// Flood.
        flood: bool,
    },
    /// The share of a PWM channel, percent.
    Pwm {
        /// Its number, from 1.
        channel: u8,
        /// Percent.
        percent: f64,
    },
    /// The byte of the intensity output.
    Intensity {
        /// 0 is off.
        byte: u8,
    },
}

/// The reason for which a machine does nothing more.
#[derive(Clone, Debug, PartialEq)]
pub struct Fault {
    /// In words.
    pub message: String,
    /// Way to mend it.
    pub hint: &'static str,
    /// The line whose move it is about, where it is about one.
    pub at: Option<At>,
    /// The machine no longer answers.
    pub silent: bool,
    /// Place where it stands, machine frame, as far as it told.
    pub stands: Option<Axes>,
    /// The moment up to which it made its moves, seconds of machine time, where an input stopped it: it may have told of
    /// moves behind that. The run can be taken up from there.
    pub made_s: Option<f64>,
}

/// News of a machine since it was asked last.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct News {
    /// The moment that it has reached, seconds of machine time; infinite once the move is made.
    pub reached_s: f64,
    /// An input that changed, by its number, and whether it is active now. Others may wait.
    pub input: Option<(u8, bool)>,
}

/// A machine that makes planned motion. Positions are millimetres and degrees in the machine frame, times are seconds of
/// machine time.
pub trait Machine {
    /// Returns the name that people use for it.
    fn name(&self) -> &str;

    /// Returns what it has and can do.
    fn facts(&self) -> &Facts;

    /// Returns `true` if it takes the time of the world: what it makes is put on record while it makes it.
    fn in_real_time(&self) -> bool;

    /// Returns in words why it cannot make a move; asked before anything of its stack moves.
    fn refuses(&self, mv: &Move) -> Option<String>;

    /// Returns the lowest and the highest place that an axis reaches, machine frame, where it tells.
    fn reach(&self, _axis: Axis) -> Option<(f64, f64)> {
        None
    }

    /// A run begins, or goes on after it waited for a person.
    fn begin(&mut self);

    /// The settings from now on. A machine with switches of its own wiring needs none of them.
    fn use_settings(&mut self, _settings: &Arc<Settings>) {}

    /// Learns the plan that is followed next, or by which the rest of the one under way is made, before any of its moves
    /// is handed over. A machine that [repeats](Facts::repeats) tells once more what it told from the beginning on.
    fn follows(&mut self, _ahead: &Ahead<'_>) {}

    /// Another piece of plan is followed from now on; what it has of the one before it makes first.
    fn begin_plan(&mut self);

    /// Sets something behind every move that it has, and before every one that it gets later. What it lacks becomes its
    /// [fault](Machine::fault).
    fn set(&mut self, actuator: &Actuator);

    /// Has the intensity of a beam be so behind every move that it has. What it lacks is told by the intensities that it is
    /// [set](Machine::set) to.
    fn beam(&mut self, _: &Beam) {}

    /// Takes moves of the plan as far as there is room, waits for news for a moment at most, and tells how far it has come
    /// from one moment towards another. A moment that is reached is not waited for.
    fn advance(&mut self, going: &Going<'_>, from_s: f64, until_s: f64) -> News;

    /// Lets time pass from one moment towards another, for a moment at most, while nothing moves.
    fn stand(&mut self, from_s: f64, until_s: f64) -> News;

    /// Tells the next input that changed up to a moment that is over already, with its own moment: nothing moves and nothing
    /// is waited for. A machine that does not [repeat](Facts::repeats) what happened tells nothing of it.
    fn passed(&mut self, until_s: f64) -> News {
        News { reached_s: until_s, input: None }
    }

    /// A move of the plan is made: returns the way of its height control beside the plan.
    fn made(&mut self, _t0_s: f64, _plan: &Plan, _span: &Span<'_>) -> LiftOfMove {
        LiftOfMove::default()
    }

    /// Has Z follow the sheet from a place on, machine frame, or ends that. Returns what the switches of the head read
    /// there, as contacts.
    fn height_control(&mut self, _law: Option<HeightLaw>, _at: &Axes) -> Vec<(u8, bool)> {
        Vec::new()
    }

    /// The place to which height control has carried Z is that of the plan from now on.
    fn land(&mut self) {}

    /// From here on only this motor of an axis moves; nothing for all.
    fn move_alone(&mut self, _motor: Option<(Axis, usize)>) {}

    /// Tells whether a home switch of an axis is on.
    fn home_switch(&self, _axis: Axis, _which: Which) -> bool {
        false
    }

    /// The place of an axis is its zero from now on.
    fn zero(&mut self, _axis: Axis, _place: f64) {}

    /// Looks at it in passing, without waiting. An input that changes is told by the next call that tells news.
    fn look(&mut self);

    /// Takes an input that has changed, by its number and whether it is active, where no time passes: somebody is asked. Those of
    /// a simulated machine are moved by hands, who tell it themselves.
    fn changed_input(&mut self) -> Option<(u8, bool)> {
        None
    }

    /// Takes a sentence for the operator, where it has one.
    fn tells(&mut self) -> Option<String> {
        None
    }

    /// Makes what it has, waiting for a moment at most; returns `true` while something is not made yet.
    fn settle(&mut self) -> bool;

    /// Goes home with all axes that can, where it [homes](Facts::homes) by itself; [`Machine::settle`] tells while it does.
    fn home(&mut self);

    /// Slows down, forgets what it has not made, and switches its outputs off, while no plan is made.
    fn halt(&mut self);

    /// Returns where it stands, machine frame, as it told last; nothing where the plan says it.
    fn place(&mut self) -> Option<Axes>;

    /// Slows down on the path, forgets what it has not made, and switches its outputs off. Returns the moment of the plan
    /// at which it stands; nothing where it stops by the ramp that is planned for it, or did not tell.
    fn stop(&mut self, going: &Going<'_>) -> Option<f64>;

    /// Slows down on the path and keeps what it has, where it [holds](Facts::holds) by itself. Returns the moment of the plan
    /// at which it stands; nothing where it does not come to a stand.
    fn hold(&mut self, _: &Going<'_>) -> Option<f64> {
        None
    }

    /// Goes on from a hold, with what it has.
    fn go_on(&mut self) {}

    /// Returns `true` if somebody at its own controls has had it go on from a hold.
    fn went_on(&mut self) -> bool {
        false
    }

    /// Makes cuts at this share of their speed from now on, where it [overrides](Facts::overrides) by itself; for another
    /// the plan is made anew.
    fn feed(&mut self, share: f32);

    /// Takes what else the operator turns, where it [overrides that](Facts::overrides_more) by itself.
    fn turn(&mut self, _: Override) {}

    /// Returns the shares that somebody at its own controls has turned, once.
    fn turned_by_hand(&mut self) -> Option<Shares> {
        None
    }

    /// The operator has waited for it in vain: it does nothing more.
    fn give_up(&mut self);

    /// Returns for what it waits at its own controls, in words: an open door, a hold, a tool. It goes on when somebody
    /// there wants it to.
    fn waits(&mut self) -> Option<&'static str> {
        None
    }

    /// Returns `true` if it has begun a change of tools and waits for the tool: until then it makes moves by hand alone.
    fn waits_for_tool(&mut self) -> bool {
        false
    }

    /// Returns `true` if it touches that tool off by itself when it is asked to.
    fn touches_off(&mut self) -> bool {
        false
    }

    /// The tool is in for which it waits: it goes on.
    fn tool_is_in(&mut self) {}

    /// Nobody puts in the tool for which it waits: it gives its change of tools up.
    fn gives_tool_up(&mut self) {}

    /// Returns the reason for which it does nothing more.
    fn fault(&self) -> Option<&Fault>;
}

/// A machine that a run and whoever has opened it share.
pub type Driven = Rc<RefCell<dyn Machine>>;
