//! A change of tools that the controller itself has begun: grblHAL in the state `Tool`, behind an `M6` of a macro, of a
//! pendant or of a file on its card.
//!
//! ```text
//!  <Tool|…> ──► 0xA3: it puts aside what it was sent, and takes jogs ($J=) and zero points alone
//!           ──► 0xA3 ~: the tool is in, it goes on with what it put aside
//! ```
//!
//! By its setting `$341` it wants the tool touched off first, by `$TPW`: it probes down where it stands, lifts, and shifts Z by the
//! difference to the tool that is the reference (`[TLR:…]` of `$#`). Where none is, `$TLR` makes this tool the one.
//!
//! What was sent before is answered when the tool is in. So the first 0xA3 waits until no order is unanswered, and until
//! somebody moves the machine by hand: what a job sends meanwhile would be jogs otherwise. Questions that were on their way are
//! put aside here, too ([`Grbl::aside`](crate::driver::Grbl)).

use crate::report::Doing;
use kerf_machine::driver::TouchOff;

/// Acknowledges that the controller waits for a tool.
pub const TOOL: u8 = 0xa3;

/// Has it touch the tool off.
pub const TOUCH: &str = "$TPW";

/// Makes the tool that was touched off last the reference of the others.
pub const REFERENCE: &str = "$TLR";

/// The setting that says how a tool is changed.
pub const MODE: u16 = 341;

/// Values of it by which a tool is touched off with [`TOUCH`].
const TOUCHES: [f64; 2] = [1.0, 2.0];

/// Ends a jog.
pub const JOG_CANCEL: u8 = 0x85;

/// The tool for which the controller waits.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ToolWait {
    is_on: bool,
    /// It was told that somebody has heard it: it takes jogs.
    is_heard: bool,
    touch: TouchOff,
    /// The plate that it was told to touch was touched, as it told last; nothing where it told of none.
    touched: Option<bool>,
}

impl ToolWait {
    /// It tells what it does, with or without a jog of ours under way.
    pub fn sees(&mut self, doing: Doing, jogs: bool) {
        self.is_on = match doing {
            Doing::Tool => true,
            Doing::Run | Doing::Slowing | Doing::Held => {
                self.is_heard && (jogs || self.is_touching())
            }
            _ => false,
        };
        if !self.is_on {
            *self = Self::default();
        }
    }

    /// Somebody is about to move it by hand. Returns `true` if it is to be told now that it was heard.
    pub fn hears(&mut self) -> bool {
        let tells = self.is_on && !self.is_heard;
        self.is_heard |= tells;
        tells
    }

    /// Returns `true` while it waits for a tool.
    pub const fn is_on(&self) -> bool {
        self.is_on
    }

    /// Returns `true` while it takes jogs.
    pub const fn takes_jogs(&self) -> bool {
        self.is_heard
    }

    /// The tool is in: returns what it is told.
    pub const fn is_in(&self) -> [u8; 2] {
        [TOOL, b'~']
    }

    /// It is about to be told to touch the tool off.
    pub fn begins_touch(&mut self) {
        (self.touch, self.touched) = (TouchOff::Going, None);
    }

    /// Returns `true` while it touches the tool off.
    pub fn is_touching(&self) -> bool {
        self.touch == TouchOff::Going
    }

    /// It tells whether its probe has touched something.
    pub const fn hears_touch(&mut self, touched: bool) {
        self.touched = Some(touched);
    }

    /// It has answered that the tool is touched off, having a reference or none. Tells whether it is.
    pub fn ends_touch(&mut self, has_reference: bool) -> bool {
        self.touch = match self.touched {
            Some(true) => TouchOff::Done { is_reference: !has_reference },
            Some(false) => TouchOff::Failed("the tool has touched nothing: bring it nearer to the plate, and look at the probe's lead".into()),
            None => TouchOff::Failed("press Continue first: the controller takes the tool to where it is touched off".into()),
        };
        self.touched == Some(true)
    }

    /// It has refused to touch the tool off, for a reason.
    pub fn refuses_touch(&mut self, why: String) {
        match self.touched {
            Some(false) => drop(self.ends_touch(true)),
            _ => self.touch = TouchOff::Failed(why),
        }
    }

    /// Returns the state of the touch-off that it makes by its setting; nothing where it makes none.
    pub fn touch_off(&self, mode: Option<f64>) -> Option<TouchOff> {
        let touches = mode.is_some_and(|mode| TOUCHES.contains(&mode));
        (self.is_on && touches).then(|| self.touch.clone())
    }

    /// Returns for what it waits, in words, where a tool is touched off by it.
    pub fn waits(&self, mode: Option<f64>) -> Option<&'static str> {
        self.touch_off(mode).map(|touch| match touch {
            TouchOff::Wanted | TouchOff::Failed(_) => {
                "it waits for a tool: put it in and touch it off, then press Continue"
            }
            TouchOff::Going => "it touches the tool off",
            TouchOff::Done { .. } => {
                "the tool is touched off: take the plate away, then press Continue"
            }
        })
    }
}
