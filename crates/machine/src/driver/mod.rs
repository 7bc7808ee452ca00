//! The protocol between Kerf and a controller: orders, signals and replies.
//!
//! A [`Driver`] is the protocol of one kind of controller as a value: it takes [`Order`]s with
//! tickets, gives [`Reply`]s, and learns from its owner how late it is. It blocks nowhere and opens no
//! port; bytes are moved by whoever owns it. The [`Link`] is what stands on the near side: it keeps
//! orders until they are done, asks again when an answer is late, and gives up in a safe way.
//!
//! ```text
//!  orders ──► Link ── Sent ──► Driver ~~~ controller
//!  told   ◄── Link ◄─ Reply ── Driver ~~~
//! ```
//!
//! What every driver has to hold is in [`conformance`]: each driver is run against it with its fake, and again with
//! its hardware.

mod card;
pub mod conformance;
mod link;
mod offsets;
mod said;
mod told_setting;
mod touch_off;
mod zero;

pub use card::{CardAnswer, CardFile, CardJob, CardNews, CardTask};
pub use link::{Link, LinkNews, LinkState, Troubles};
pub use offsets::Offsets;
pub use said::{LineKind, Said};
pub use told_setting::ToldSetting;
pub use touch_off::TouchOff;
pub use zero::{Zero, ZeroChange};

/// Planners of controllers that plan for themselves.
pub use kerf_motion::controllers as planners;
pub use kerf_program::{AXES, Axes, Axis, decimal, rounded};
use kerf_program::{Gauge, HeightLaw};
use std::borrow::Cow;

/// The number of an order; they count up from 1.
pub type Ticket = u32;

/// An order that a controller can be given.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Order {
    /// A straight move, mm and mm/s (degrees and degrees/s of rotary axes).
    Move {
        /// Target, machine frame.
        to: Axes,
        /// Highest speed.
        speed_mm_s: f64,
    },
    /// A straight move beside the work, which the feed override does not change. Where its speed is the greatest that the
    /// controller goes, it is a rapid move of the controller.
    Jog {
        /// Target, machine frame.
        to: Axes,
        /// Highest speed.
        speed_mm_s: f64,
    },
    /// An arc in X and Y, on which Z moves in proportion to the angle; of a controller that [makes arcs](Facts::arcs).
    Arc {
        /// Target, machine frame.
        to: Axes,
        /// Centre in X and Y, machine frame.
        centre: [f64; 2],
        /// Swept angle, positive counter-clockwise, a turn at most.
        sweep_rad: f64,
        /// Highest speed along the arc.
        speed_mm_s: f64,
    },
    /// A straight move that ends where the probe gets contact, or loses it: the machine stands at the very place, or at the
    /// end where nothing changed. No order is under way beside it.
    Probe {
        /// Target, machine frame.
        to: Axes,
        /// Highest speed.
        speed_mm_s: f64,
        /// The state of the probe that ends it.
        active: bool,
    },
    /// Switches an output.
    Output {
        /// Its line.
        line: u8,
        /// Its state from then on.
        on: bool,
    },
    /// Sets the speed of the spindle; it need not turn.
    Spindle {
        /// Revolutions a minute.
        rpm: f64,
    },
    /// Goes home with all axes that can.
    Home,
    /// Takes orders again after an alarm, without being homed.
    Unlock,
}

impl Order {
    /// Returns where it leads, machine frame; nothing where it is no move to a place.
    pub const fn to(&self) -> Option<Axes> {
        match self {
            Self::Move { to, .. }
            | Self::Jog { to, .. }
            | Self::Arc { to, .. }
            | Self::Probe { to, .. } => Some(*to),
            Self::Output { .. } | Self::Spindle { .. } | Self::Home | Self::Unlock => None,
        }
    }
}

/// A share that the operator turns at a controller, percent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Override {
    /// Of the speed of rapid moves, up to 100. A controller of few steps takes the next one below.
    Rapid(u8),
    /// Of the speed of the spindle.
    Spindle(u8),
}

/// Shares at which a controller makes what it is told, percent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shares {
    /// Of the speed of cuts.
    pub feed: u8,
    /// Of the speed of rapid moves.
    pub rapid: u8,
    /// Of the speed of the spindle.
    pub spindle: u8,
}

impl Default for Shares {
    fn default() -> Self {
        Self { feed: 100, rapid: 100, spindle: 100 }
    }
}

/// A request outside the row of orders, carried out at once.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Signal {
    /// Tell where you are.
    Ask,
    /// Slow down on the path and wait.
    Hold,
    /// Go on.
    Resume,
    /// Nothing runs: whoever moves you now does it by hand, also while you [wait for a tool](Wired::waits_for_tool).
    ByHand,
    /// The tool is in for which you [wait](Wired::waits_for_tool).
    ToolIn,
    /// Touch it off by yourself, as far as you [do such](Wired::touch_off).
    TouchOff,
    /// Nobody puts it in: give the change of tools up.
    ToolOff,
    /// Slow down, forget every order that is not done, switch outputs off.
    Stop,
    /// Make moves at so many percent of the speed that was ordered, from now on.
    Feed(u8),
    /// The operator turns something else.
    Override(Override),
}

/// An order with its ticket.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sent {
    /// Its ticket.
    pub ticket: Ticket,
    /// The order.
    pub order: Order,
}

/// State of a controller: its place, motion, outputs and progress.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ControllerState {
    /// Place of the axes, machine frame.
    pub position: Axes,
    /// Something moves.
    pub moving: bool,
    /// Outputs that are on, a bit each, line 1 lowest.
    pub outputs: u32,
    /// The last order that is done; 0 for none.
    pub done: Ticket,
}

/// An answer of a controller.
#[derive(Clone, Debug, PartialEq)]
pub enum Reply {
    /// An order was taken and will be carried out. Orders are taken in the order of their tickets.
    Taken(Ticket),
    /// It is done.
    Done(Ticket),
    /// It cannot be carried out.
    Refused(Ticket, &'static str),
    /// The answer to [`Signal::Ask`].
    State(ControllerState),
    /// An input changed.
    Input {
        /// Its line.
        line: u8,
        /// Its state.
        on: bool,
    },
}

/// Bytes came that are no reply.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("an answer could not be read")]
pub struct Garbled;

/// The protocol of one kind of controller. Times are seconds by one clock that never goes back.
pub trait Driver {
    /// Hands an order to the controller. The same ticket may come again: it is carried out once and
    /// answered again. A ticket that does not follow the last one taken is left alone.
    fn send(&mut self, sent: &Sent, now_s: f64);

    /// Hands a signal to the controller.
    fn signal(&mut self, signal: Signal, now_s: f64);

    /// Returns the replies that came back up to a time.
    fn replies(&mut self, now_s: f64) -> Vec<Result<Reply, Garbled>>;

    /// Returns `true` while silence is no fault: grbl does not answer while it goes home.
    fn quiet(&self) -> bool {
        false
    }

    /// Returns the greatest number of orders that may be with it at a time.
    fn window(&self) -> usize {
        8
    }
}

/// Facts that a controller told of itself.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Facts {
    /// Name it gives itself, with its version.
    pub name: String,
    /// Number of its axes, X first.
    pub axes: usize,
    /// The fastest each axis goes, mm/s; `None` where it did not say.
    pub speed_mm_s: [Option<f64>; AXES],
    /// Range of each axis, its own machine frame, mm; `None` where it does not check.
    pub travel_mm: [Option<(f64, f64)>; AXES],
    /// It knows where it is only after it was homed.
    pub homes: bool,
    /// Greatest distance of an arc's chord from the arc, mm.
    pub arc_tolerance_mm: f64,
    /// It makes arcs by itself ([`Order::Arc`]).
    pub arcs: bool,
    /// Outputs it has, a bit each, line 1 lowest.
    pub outputs: u32,
    /// PWM channels it has, a bit each, channel 1 lowest.
    pub pwm: u32,
    /// The reason for which it has no spindle, in words; empty where it has one, or tells none.
    pub no_spindle: &'static str,
    /// Inputs of which it tells, a bit each, input 1 lowest.
    pub inputs: u32,
    /// Nothing is on when its line is opened: it starts then, or switched off when the line ended.
    pub is_fresh: bool,
    /// The input at whose change it stops by itself, and latches the place ([`Order::Probe`]); nothing where it has none.
    pub probe: Option<u8>,
    /// The fastest its spindle turns, revolutions a minute.
    pub spindle_rpm: f64,
    /// It changes the speed of moves that it has (feed override).
    pub overrides: bool,
    /// A change of feed waits until the machine stands, while it watches inputs.
    pub feed_waits: bool,
    /// The output of its spindle can be a laser's, whose power follows the speed.
    pub follows_speed: bool,
    /// Z follows a sheet by the voltage of a torch (height control).
    pub follows_voltage: bool,
    /// Z follows a sheet by two switches of its head (height control).
    pub follows_switches: bool,
    /// Z goes down and up by the input of a torch (VH), and the machine tells how far.
    pub follows_torch: bool,
    /// It changes the speed of its rapid moves, and that of its spindle, by itself ([`Override`]).
    pub overrides_more: bool,
    /// It stops on its path and goes on from there, with its outputs as they are (feed hold).
    pub holds: bool,
    /// Its stop switches every output off.
    pub stop_switches_off: bool,
    /// It passes corners at a speed of its own: the plan of all moves up to the next stand is one piece, and it does not wait for
    /// the plan at corners where that stands.
    pub plans_corners: bool,
    /// It is given all moves up to the next stand at once: it stands wherever it has to wait for more.
    pub takes_whole: bool,
    /// A repeated run gives the same inputs, so that they need no place on record.
    pub repeats: bool,
    /// Its place comes from the record of the last run; every other machine tells its own.
    pub placed_by_record: bool,
    /// Its planner, where it plans for itself and has told how it is set: by it the time of a run is told.
    pub planner: Option<planners::OwnPlanner>,
    /// A run may tell of a move so long before it is made, seconds.
    pub leads_s: f64,
    /// Its switches are moved here: of every other machine they are moved where they are.
    pub inputs_by_hand: bool,
    /// The bits of its card are switched one at a time, and its motors stepped once.
    pub card: bool,
    /// Nothing real hangs on it: nobody is hurt by what it does.
    pub harmless: bool,
}

impl Facts {
    /// Tells whether Z follows a sheet by a law.
    pub const fn follows(&self, law: &HeightLaw) -> bool {
        match law.gauge {
            Gauge::Simple { .. } => self.follows_switches,
            Gauge::Proportional { .. } => self.follows_voltage,
        }
    }
}

/// A hold that was ordered ([`Signal::Hold`]).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Hold {
    /// There is none, or it is over by [`Signal::Resume`].
    #[default]
    None,
    /// It slows down.
    Ordered,
    /// It stands.
    Stands,
    /// Somebody at its own controls has had it go on.
    WentOn,
}

/// A setting of a controller that was changed to drive it, and is put back afterwards.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Changed {
    /// Its number.
    pub number: u16,
    /// Its value before.
    pub was: u32,
    /// Its value from then on.
    pub is: u32,
}

/// Reason for which a controller does nothing more.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Trouble {
    /// It stopped by itself; whether it knows where it is.
    #[error("alarm {number}: {why}")]
    Alarm {
        /// Its number.
        number: u16,
        /// In words.
        why: Cow<'static, str>,
        /// Steps may be lost.
        lost: bool,
    },
    /// It was locked when it was connected.
    #[error("it is locked: {why}")]
    Locked {
        /// The reason, and the way to end it.
        why: &'static str,
    },
    /// It cannot be driven in the state that it is set to.
    #[error("{why}")]
    Unfit {
        /// The reason, and the way to mend it.
        why: &'static str,
    },
    /// The machine is at another place than ordered, and knows it.
    #[error("{why}: a line was garbled on its way, look at the cable")]
    Elsewhere {
        /// Words for it.
        why: &'static str,
    },
    /// It refused an order.
    #[error("error {number}: {why}")]
    Refused {
        /// Its number; 0 when the order was not even sent.
        number: u16,
        /// In words.
        why: Cow<'static, str>,
    },
    /// The line was gone, and nobody knows how far the controller has come with what was sent; it knows its place.
    #[error("the line was gone for a while, and {why}")]
    Gap {
        /// The reason why the work cannot go on.
        why: &'static str,
    },
    /// The controller restarted during work: its place may be wrong.
    #[error("it was reset while it was at work")]
    Restarted,
}

/// A driver whose controller hangs on a line of bytes. Whoever owns the line moves them.
pub trait Wired: Driver {
    /// Bytes came.
    fn hear(&mut self, bytes: &[u8], now_s: f64);

    /// Bytes that are to be sent now.
    fn speak(&mut self, now_s: f64) -> Vec<u8>;

    /// Returns the facts that the controller told of itself; nothing until it has told all.
    fn facts(&self) -> Option<&Facts>;

    /// Returns the place at which the probe ended the last [`Order::Probe`], machine frame; nothing where it did not.
    fn contact(&self) -> Option<Axes> {
        None
    }

    /// Returns for what it waits at its own controls, in words: it goes on when somebody there wants it to. A hold that was
    /// ordered is none.
    fn waits(&self) -> Option<&'static str> {
        None
    }

    /// Returns `true` if it has begun a change of tools and waits: it makes moves by hand, and goes on by [`Signal::ToolIn`].
    fn waits_for_tool(&self) -> bool {
        false
    }

    /// Returns the state of the touch-off that it makes by itself of the tool for which it waits, by [`Signal::TouchOff`];
    /// nothing where it makes none.
    fn touch_off(&self) -> Option<TouchOff> {
        None
    }

    /// Returns the state of a hold that was ordered.
    fn hold(&self) -> Hold {
        Hold::None
    }

    /// Returns the shares that hold in it: as it was told last, or as somebody at its own controls has turned them since.
    fn shares(&self) -> Option<Shares> {
        None
    }

    /// Returns the zero points that it keeps, as it told them last.
    fn zeros(&self) -> &[Zero] {
        &[]
    }

    /// Has it change a zero point that it keeps, while nothing moves; tells whether it does.
    fn keeps_zero(&mut self, _name: &str, _change: ZeroChange) -> bool {
        false
    }

    /// Returns `true` if its zero points are told as it was last had to keep them.
    fn knows_zeros(&self) -> bool {
        true
    }

    /// Returns the steps of a millimetre that it keeps, of each axis; none where it keeps none.
    fn steps_per_mm(&self) -> Vec<f64> {
        Vec::new()
    }

    /// Returns a setting that it keeps, by its number, as it writes it.
    fn setting(&self, _number: u16) -> Option<&str> {
        None
    }

    /// Returns all settings that it keeps by number, in their order; what was changed to drive it is as it was.
    fn told_settings(&self) -> Vec<ToldSetting> {
        Vec::new()
    }

    /// Has it keep another value of a setting, while nothing moves, and tell all of them again.
    ///
    /// # Errors
    /// It is at work, keeps no such setting, or the value is none of it.
    fn keeps_setting(&mut self, _number: u16, _value: &str) -> Result<(), String> {
        Err("it keeps no settings by number".into())
    }

    /// Has it answer a question in its own language, while nothing moves: the answer is among the lines that come.
    ///
    /// # Errors
    /// It is at work, or this is no question that leaves the machine as it is.
    fn asks(&mut self, _question: &str) -> Result<(), String> {
        Err("it is asked no questions in lines of its own".into())
    }

    /// Returns its refusal of a setting that it was told to keep, in words, once.
    fn takes_refusal(&mut self) -> Option<String> {
        None
    }

    /// Returns the name of a byte that the controller obeys at once, wherever it stands; nothing for a byte of a line.
    fn at_once(&self, _byte: u8) -> Option<Said> {
        None
    }

    /// Returns `true` while bytes of a file go to the controller, which are neither lines nor obeyed.
    fn sends_file(&self) -> bool {
        false
    }

    /// Tells what a line is that was sent to the controller, or came from it.
    fn said(&self, _line: &str, is_sent: bool) -> Said {
        Said::plain(if is_sent { LineKind::Line } else { LineKind::Message })
    }

    /// Tells whether it has a card with files that it runs by itself.
    ///
    /// # Errors
    /// It has none, for a reason.
    fn has_card(&self) -> Result<(), &'static str> {
        Err("it has no card")
    }

    /// Begins something on its card, while nothing moves.
    ///
    /// # Errors
    /// It has none, cannot do this, is at work, or the name is none that it takes.
    fn does_on_card(&mut self, _task: CardTask) -> Result<(), String> {
        self.has_card().map_err(str::to_owned)
    }

    /// Returns what became of that since this was asked last.
    fn card_news(&mut self) -> Option<CardNews> {
        None
    }

    /// Gives up what is done on its card; a file that runs goes on.
    fn leaves_card(&mut self) {}

    /// Returns the file that it runs from its card, whoever has begun it.
    fn card_job(&self) -> Option<CardJob> {
        None
    }

    /// The line was gone and is there again. Finds out what the controller has got of what was sent, before anything else is
    /// sent; what was lost for good becomes its [trouble](Wired::trouble).
    fn line_is_back(&mut self, _now_s: f64) {}

    /// Returns the setting that was changed in it, for whoever keeps it in mind until it is put back.
    fn changed(&self) -> Option<Changed> {
        None
    }

    /// Puts a changed setting back, behind all orders; tells whether it has done so.
    fn puts_back(&mut self, _: Changed) -> bool {
        true
    }

    /// Returns the state that it told last.
    fn stands(&self) -> Option<ControllerState>;

    /// Returns the reason for which it does nothing more.
    fn trouble(&self) -> Option<&Trouble>;

    /// Begins to take orders again after a stop, with ticket 1. Returns `false` if it does not.
    fn begin_anew(&mut self) -> bool;
}

impl<D: Wired + ?Sized> Driver for Box<D> {
    fn send(&mut self, sent: &Sent, now_s: f64) {
        (**self).send(sent, now_s);
    }

    fn signal(&mut self, signal: Signal, now_s: f64) {
        (**self).signal(signal, now_s);
    }

    fn replies(&mut self, now_s: f64) -> Vec<Result<Reply, Garbled>> {
        (**self).replies(now_s)
    }

    fn quiet(&self) -> bool {
        (**self).quiet()
    }

    fn window(&self) -> usize {
        (**self).window()
    }
}

/// Returns `true` if an order can be carried out by some machine.
pub fn is_sound(order: &Order) -> bool {
    match order {
        Order::Move { to, speed_mm_s }
        | Order::Jog { to, speed_mm_s }
        | Order::Probe { to, speed_mm_s, .. } => {
            to.0.iter().all(|v| v.is_finite()) && speed_mm_s.is_finite() && *speed_mm_s > 0.0
        }
        Order::Arc { to, centre, sweep_rad, speed_mm_s } => {
            let numbers = to.0.iter().chain(centre).chain([sweep_rad, speed_mm_s]);
            numbers.into_iter().all(|v| v.is_finite()) && *speed_mm_s > 0.0 && *sweep_rad != 0.0
        }
        Order::Output { line, .. } => (1..=u32::BITS as u8).contains(line),
        Order::Spindle { rpm } => rpm.is_finite() && *rpm >= 0.0,
        Order::Home | Order::Unlock => true,
    }
}

/// The way of a move, its longest axis counted.
pub fn way_mm(from: Axes, to: Axes) -> f64 {
    let ways: [f64; AXES] = to.minus(from).0;
    ways.iter().map(|way| way * way).sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_order_that_no_machine_can_carry_out_is_not_sound() {
        let to = Axes::default();
        let nowhere = Axes::xyz(0.0, f64::NAN, 0.0);
        for (order, sound) in [
            (Order::Move { to, speed_mm_s: 5.0 }, true),
            (Order::Move { to, speed_mm_s: 0.0 }, false),
            (Order::Move { to, speed_mm_s: f64::INFINITY }, false),
            (Order::Move { to: nowhere, speed_mm_s: 5.0 }, false),
            (Order::Arc { to, centre: [1.0; 2], sweep_rad: 1.0, speed_mm_s: 5.0 }, true),
            (Order::Arc { to, centre: [1.0; 2], sweep_rad: 0.0, speed_mm_s: 5.0 }, false),
            (Order::Output { line: 1, on: true }, true),
            (Order::Output { line: 0, on: true }, false),
            (Order::Output { line: 33, on: true }, false),
            (Order::Spindle { rpm: 0.0 }, true),
            (Order::Spindle { rpm: -1.0 }, false),
            (Order::Home, true),
        ] {
            assert_eq!(is_sound(&order), sound, "{order:?}");
        }
    }
}
