//! The words that a block needs, and those that it holds in vain.

use crate::syntax::codes::{
    self, COMPENSATION, IO, MOTION, ONCE, OVERRIDE, PATH, STATE, STOP, TOOL, TOOL_LENGTH,
};
use crate::syntax::gathered::{AXIS_WORDS, Fault, Gathered, PLACE_WORDS, letter_of, letters};
use crate::syntax::tree::Span;
use kerf_diag::Code;

/// Largest distance of a calculated number from the whole one that is meant.
const WHOLE: f64 = 1e-4;

impl Gathered {
    /// The number of a tool.
    pub(crate) fn tool(&self, letter: u8) -> Option<u32> {
        self.get(letter).map(|number| number.round() as u32)
    }

    /// Returns `true` if the axis words belong to a code that is no motion.
    pub(crate) fn axes_taken(&self) -> bool {
        matches!(self.g[ONCE], Some(100 | 280 | 300 | 520 | 920))
            || self.g[TOOL_LENGTH] == Some(431)
    }

    /// Returns `true` if a block names places for G28 or G30.
    pub(crate) fn goes_home(&self) -> bool {
        matches!(self.g[ONCE], Some(280 | 300)) && self.has_any(PLACE_WORDS)
    }

    /// Reports what is missing or out of range whatever the state is. Values may be unknown (not a number).
    pub(crate) fn needs(&self, span: Span, fault: &mut dyn FnMut(Fault)) {
        self.check_dwell(span, fault);
        self.check_words(span, fault);
        self.check_numbers(span, fault);
        self.check_axis_words(span, fault);
    }

    fn check_dwell(&self, span: Span, fault: &mut dyn FnMut(Fault)) {
        if self.g[ONCE] == Some(40) && [b'P', b'X', b'S'].iter().any(|l| self.or_zero(*l) < 0.0) {
            let fault_at = Fault::new(Code::OutOfRange, span, "G4 with a time below zero");
            fault(fault_at.hint("G4 P1.5 waits for one and a half seconds"));
        }
    }

    fn check_words(&self, span: Span, fault: &mut dyn FnMut(Fault)) {
        if self.m[IO] == Some(66) && self.has(b'P') && self.has(b'E') {
            let both = Fault::new(Code::ModalConflict, span, "M66 with P and E");
            fault(both.hint("P is a switch and E an analog input: one M66 reads one of them"));
        }
        let mut need = |holds: bool, what: &str, hint: &str| {
            if holds {
                fault(Fault::new(Code::MissingWord, span, what).hint(hint));
            }
        };
        need(
            self.g[ONCE] == Some(40) && !self.has(b'P') && !self.has_any(letters(b"XS")),
            "G4 without P",
            "G4 P1.5 waits for one and a half seconds",
        );
        need(
            self.g[ONCE] == Some(100) && !self.has(b'L'),
            "G10 without L",
            "G10 L2 P1 X0 sets the offset of G54, G10 L20 P1 X0 the present place",
        );
        need(
            matches!(self.m[IO], Some(62..=65)) && !self.has(b'P'),
            "an output needs its number P",
            "M64 P0 switches the first output on",
        );
        need(
            self.m[IO] == Some(66) && !self.has_any(letters(b"PE")),
            "M66 needs the number of an input, P or E",
            "M66 P0 L3 Q5 waits up to 5 seconds until the first input is on",
        );
        need(
            matches!(self.m[IO], Some(67 | 68)) && !(self.has(b'E') && self.has(b'Q')),
            "an analog output needs E and Q",
            "M68 E0 Q50 sets the first one to 50",
        );
        need(
            self.m[STOP] == Some(98) && !self.has(b'P'),
            "M98 without P",
            "M98 P100 runs the subroutine O100",
        );
        need(
            self.m[TOOL] == Some(61) && !self.has(b'Q'),
            "M61 without Q",
            "M61 Q3 says that tool 3 is in",
        );
        need(
            matches!(self.g[MOTION], Some(382..=385)) && !self.has_any(AXIS_WORDS),
            "a probe move without a place",
            "name the axis to move, as in G38.2 Z-10 F50",
        );
    }

    fn check_numbers(&self, span: Span, fault: &mut dyn FnMut(Fault)) {
        for letter in [b'F', b'S', b'T', b'D', b'H', b'L'] {
            let h_unset = letter == b'H' && self.or_zero(letter) == -1.0;
            // A diameter below zero is the other side.
            let other_side = letter == b'D' && matches!(self.g[COMPENSATION], Some(411 | 421));
            if self.get(letter).is_some_and(|v| v < 0.0) && !h_unset && !other_side {
                let message = format!("{} may not be negative", letter as char);
                fault(Fault::new(Code::OutOfRange, span, message).hint("write 0 or more"));
            }
        }
        for letter in [b'T', b'H'] {
            if self.get(letter).is_some_and(|v| (v - v.round()).abs() > WHOLE) {
                let message = format!("{} is the number of a tool, a whole one", letter as char);
                let hint = format!("is a point too many, as in {0}1.5 for {0}15?", letter as char);
                fault(Fault::new(Code::OutOfRange, span, message).hint(hint));
            }
        }
    }

    fn check_axis_words(&self, span: Span, fault: &mut dyn FnMut(Fault)) {
        let home = matches!(self.g[ONCE], Some(280 | 300));
        let free = |motion: i32| motion == 800 || home && matches!(motion, 0 | 10);
        if self.axes_taken()
            && self.has_any(PLACE_WORDS)
            && self.g[MOTION].is_some_and(|motion| !free(motion))
        {
            let message = "two codes of the block need the axis words";
            let hint = "write the motion on a line of its own";
            fault(Fault::new(Code::ModalConflict, span, message).hint(hint));
        }
    }

    /// The first letter that nothing uses when this motion (in tenths, `None` for G80) holds.
    pub(crate) fn unused(&self, motion: Option<i32>) -> Option<char> {
        let mut used = letters(b"NFST");
        used |= match motion {
            Some(0 | 10) => PLACE_WORDS,
            Some(20 | 30) => PLACE_WORDS | letters(b"IJKRP"),
            Some(50 | 51) => PLACE_WORDS | letters(b"IJPQ"),
            Some(52 | 53) => PLACE_WORDS | letters(b"PL"),
            Some(382..=385) => PLACE_WORDS,
            Some(730 | 830) => PLACE_WORDS | letters(b"RLQ"),
            Some(820 | 840 | 860 | 880 | 890) => PLACE_WORDS | letters(b"RLP"),
            Some(870) => PLACE_WORDS | letters(b"RLIJK"),
            Some(810 | 850) => PLACE_WORDS | letters(b"RL"),
            _ => 0,
        };
        used |= match self.g[ONCE] {
            Some(40) => letters(b"PXS"),
            Some(100) => AXIS_WORDS | letters(b"LPRIJQ"),
            Some(280 | 300 | 520 | 920) => PLACE_WORDS,
            _ => 0,
        };
        used |= match self.g[TOOL_LENGTH] {
            Some(430) => letters(b"H"),
            Some(431) => AXIS_WORDS,
            _ => 0,
        };
        if self.g[COMPENSATION].is_some() {
            used |= letters(b"DL");
        }
        if self.g[PATH].is_some() {
            used |= letters(b"PQ");
        }
        used |= match self.m[IO] {
            Some(66) => letters(b"PELQ"),
            Some(62..=65) => letters(b"P"),
            Some(67 | 68) => letters(b"EQ"),
            _ => 0,
        };
        if matches!(self.m[STOP], Some(98)) {
            used |= letters(b"PLQ");
        }
        if matches!(self.m[STOP], Some(99)) || self.m[OVERRIDE].is_some() || self.m[STATE].is_some()
        {
            used |= letters(b"P");
        }
        if self.m[TOOL] == Some(61) {
            used |= letters(b"Q");
        }
        if self.g[codes::LATHE].is_some() || self.m[codes::SPINDLE] == Some(19) {
            used |= letters(b"DRPQ");
        }
        if self.m[codes::NOTHING].is_some() {
            used |= letters(b"PQRES");
        }
        if self.m[codes::SPINDLE].is_some() || self.has(b'S') {
            used |= letters(b"$");
        }
        let left = self.given() & !used;
        let no_axes = left & letters(b"UVW");
        let left = if no_axes != 0 { no_axes } else { left };
        (left != 0).then(|| letter_of(left.trailing_zeros() as usize))
    }
}
