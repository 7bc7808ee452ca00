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
mod facts;
mod link;
mod offsets;
mod order;
mod said;
mod told_setting;
mod touch_off;
mod trouble;
mod zero;

pub use card::{CardAnswer, CardFile, CardJob, CardNews, CardTask, NO_CARD_IN, TAKES_NO_FILES};
pub use facts::Facts;
pub use link::{Link, LinkNews, LinkState, Troubles};
pub use offsets::Offsets;
pub use order::{Order, Override, Sent, Shares, Signal, Ticket, is_sound, way_mm};
pub use said::{LineKind, Said};
pub use told_setting::ToldSetting;
pub use touch_off::TouchOff;
pub use trouble::Trouble;
pub use zero::{Zero, ZeroChange};

/// Planners of controllers that plan for themselves.
pub use kerf_motion::controllers as planners;
pub use kerf_program::{AXES, Axes, Axis, decimal, rounded};

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
