//! A change of tools that the controller itself has begun: grblHAL in the state `Tool`, behind an `M6` of a macro, of a
//! pendant or of a file on its card.
//!
//! ```text
//!  <Tool|…> ──► 0xA3: it puts aside what it was sent, and takes jogs ($J=) and zero points alone
//!           ──► 0xA3 ~: the tool is in, it goes on with what it put aside
//! ```
//!
//! What was sent before is answered behind that; so the first 0xA3 waits until nothing is unanswered, and until somebody
//! moves the machine by hand: what a job sends meanwhile would be jogs otherwise.

use crate::report::Doing;

/// Acknowledges that the controller waits for a tool.
pub const TOOL: u8 = 0xa3;

/// Ends a jog.
pub const JOG_CANCEL: u8 = 0x85;

/// The tool for which the controller waits.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ToolWait {
    is_on: bool,
    /// It was told that somebody has heard it: it takes jogs.
    is_heard: bool,
}

impl ToolWait {
    /// It tells what it does, with or without a jog of ours under way.
    pub fn sees(&mut self, doing: Doing, jogs: bool) {
        self.is_on = match doing {
            Doing::Tool => true,
            Doing::Run | Doing::Slowing | Doing::Held => self.is_heard && jogs,
            _ => false,
        };
        self.is_heard &= self.is_on;
    }

    /// Somebody is about to move it by hand. Returns `true` if it is to be told now that it was heard.
    pub fn hears(&mut self) -> bool {
        let tells = self.is_on && !self.is_heard;
        self.is_heard |= tells;
        tells
    }

    /// Returns `true` while it waits for a tool.
    pub const fn is_on(self) -> bool {
        self.is_on
    }

    /// Returns `true` while it takes jogs.
    pub const fn takes_jogs(self) -> bool {
        self.is_heard
    }

    /// The tool is in: returns what it is told.
    pub const fn is_in(self) -> [u8; 2] {
        [TOOL, b'~']
    }
}
