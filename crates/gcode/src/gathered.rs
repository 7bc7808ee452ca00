//! The words of a block, sorted: one code a group, one value a letter.

use crate::codes::{
    self, COMPENSATION, G_GROUPS, IO, M_GROUPS, MOTION, ONCE, OVERRIDE, PATH, STATE, STOP, TOOL,
    TOOL_LENGTH, g_group, g_name, m_group,
};
use crate::tree::{MoveNode, Span, Word};
use kerf_diag::Code;

/// Something wrong with a block.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Fault {
    pub(crate) code: Code,
    pub(crate) span: Span,
    pub(crate) message: String,
    pub(crate) hint: String,
}

impl Fault {
    pub(crate) fn new(code: Code, span: Span, message: impl Into<String>) -> Self {
        Self { code, span, message: message.into(), hint: String::new() }
    }

    pub(crate) fn hint(mut self, hint: impl Into<String>) -> Self {
        self.hint = hint.into();
        self
    }
}

/// Letters a word may begin with: A … Z, `@`, `^`, `$`.
const LETTERS: usize = 29;

/// A block's words by their meaning.
#[derive(Clone, Debug)]
pub(crate) struct Gathered {
    /// G codes in tenths, by group.
    pub(crate) g: [Option<i32>; G_GROUPS],
    /// M codes, by group.
    pub(crate) m: [Option<i32>; M_GROUPS],
    values: [f64; LETTERS],
    given: u32,
}

/// The bits of some letters.
pub(crate) const fn letters(text: &[u8]) -> u32 {
    let mut mask = 0;
    let mut i = 0;
    while i < text.len() {
        mask |= 1 << slot(text[i]);
        i += 1;
    }
    mask
}

const fn slot(letter: u8) -> usize {
    match letter {
        b'@' => 26,
        b'^' => 27,
        b'$' => 28,
        _ => (letter - b'A') as usize,
    }
}

const fn letter_of(slot: usize) -> char {
    match slot {
        26 => '@',
        27 => '^',
        28 => '$',
        _ => (b'A' + slot as u8) as char,
    }
}

/// The letters of axes.
pub(crate) const AXIS_WORDS: u32 = letters(b"XYZABC");
/// Axes and polar coordinates.
const PLACE_WORDS: u32 = AXIS_WORDS | letters(b"@^");

impl Default for Gathered {
    fn default() -> Self {
        Self { g: [None; G_GROUPS], m: [None; M_GROUPS], values: [0.0; LETTERS], given: 0 }
    }
}

impl Gathered {
    /// The words of a block, faults told one by one.
    pub(crate) fn of(
        words: &[Word],
        mut value: impl FnMut(&Word) -> Result<f64, Fault>,
        mut fault: impl FnMut(Fault),
    ) -> Self {
        let mut all = Self::default();
        for word in words {
            match value(word).and_then(|v| all.add(word.letter, v, word.span)) {
                Ok(()) => {}
                Err(found) => fault(found),
            }
        }
        all
    }

    /// The words of a move line.
    pub(crate) fn of_move(node: MoveNode, numbers: &[f64]) -> Self {
        let mut all = Self::default();
        if node.motion < MoveNode::MODAL {
            all.g[MOTION] = Some(i32::from(node.motion) * 10);
        }
        let mut index = node.first as usize;
        for (bit, letter) in MoveNode::LETTERS.into_iter().enumerate() {
            if node.given & (1 << bit) != 0 {
                all.set(letter, numbers.get(index).copied().unwrap_or_default());
                index += 1;
            }
        }
        all
    }

    fn add(&mut self, letter: u8, value: f64, span: Span) -> Result<(), Fault> {
        match letter {
            b'N' => Ok(()),
            b'G' => self.add_g(value, span),
            b'M' => self.add_m(value, span),
            _ if self.has(letter) => {
                let message = format!("{} stands twice in the block", letter as char);
                let hint = "write the second one on a line of its own";
                Err(Fault::new(Code::WordTwice, span, message).hint(hint))
            }
            _ => {
                self.set(letter, value);
                Ok(())
            }
        }
    }

    /// A code that is not known yet counts as none.
    fn add_g(&mut self, value: f64, span: Span) -> Result<(), Fault> {
        if value.is_nan() {
            return Ok(());
        }
        let code = (value * 10.0).round();
        let known = (code / 10.0 - value).abs() < 1e-4 && (0.0..1000.0).contains(&code);
        let code = code as i32;
        let Some(group) = known.then(|| g_group(code)).flatten() else {
            return Err(unknown_g(value, code, known, span));
        };
        match self.g[group].replace(code) {
            // G80 ends a cycle; another motion beside it does so too.
            Some(800) => Ok(()),
            Some(other) if code == 800 => {
                self.g[group] = Some(other);
                Ok(())
            }
            Some(other) if other != code => Err(conflict(&g_name(other), &g_name(code), span)),
            _ => Ok(()),
        }
    }

    fn add_m(&mut self, value: f64, span: Span) -> Result<(), Fault> {
        if value.is_nan() {
            return Ok(());
        }
        let whole = value.fract() == 0.0 && (0.0..1000.0).contains(&value);
        let code = value as i32;
        let Some(group) = whole.then(|| m_group(code)).flatten() else {
            let message = format!("unknown code M{value}");
            let hint = if (100..200).contains(&code) && whole {
                "M100 to M199 run programs of the controller, which Kerf does not have"
            } else {
                ""
            };
            return Err(Fault::new(Code::UnknownMWord, span, message).hint(hint));
        };
        match self.m[group].replace(code) {
            Some(other) if other != code => {
                Err(conflict(&format!("M{other}"), &format!("M{code}"), span))
            }
            _ => Ok(()),
        }
    }

    /// Whether a letter has a value.
    pub(crate) const fn has(&self, letter: u8) -> bool {
        self.given & (1 << slot(letter)) != 0
    }

    /// Whether one of some letters has a value.
    pub(crate) const fn has_any(&self, mask: u32) -> bool {
        self.given & mask != 0
    }

    /// The value of a letter.
    pub(crate) fn get(&self, letter: u8) -> Option<f64> {
        self.has(letter).then(|| self.values[slot(letter)])
    }

    /// The value of a letter, or 0.
    pub(crate) fn or_zero(&self, letter: u8) -> f64 {
        self.get(letter).unwrap_or_default()
    }

    /// Gives a letter a value.
    pub(crate) fn set(&mut self, letter: u8, value: f64) {
        self.values[slot(letter)] = value;
        self.given |= 1 << slot(letter);
    }

    /// Takes a letter's value away.
    pub(crate) fn clear(&mut self, letter: u8) {
        self.given &= !(1 << slot(letter));
    }

    /// Whether the axis words belong to a code that is no motion.
    pub(crate) fn axes_taken(&self) -> bool {
        matches!(self.g[ONCE], Some(100 | 280 | 300 | 520 | 920))
            || self.g[TOOL_LENGTH] == Some(431)
    }

    /// What is missing or out of range whatever the state is. Values may be unknown (not a number).
    pub(crate) fn needs(&self, span: Span, fault: &mut dyn FnMut(Fault)) {
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
        for letter in [b'F', b'S', b'T', b'D', b'H', b'L'] {
            let h_unset = letter == b'H' && self.or_zero(letter) == -1.0;
            if self.get(letter).is_some_and(|v| v < 0.0) && !h_unset {
                let message = format!("{} may not be negative", letter as char);
                fault(Fault::new(Code::OutOfRange, span, message));
            }
        }
        if self.axes_taken()
            && self.has_any(PLACE_WORDS)
            && self.g[MOTION].is_some_and(|m| m != 800)
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
            used |= letters(b"PQRE");
        }
        if self.m[codes::SPINDLE].is_some() || self.has(b'S') {
            used |= letters(b"$");
        }
        let left = self.given & !used;
        let no_axes = left & letters(b"UVW");
        let left = if no_axes != 0 { no_axes } else { left };
        (left != 0).then(|| letter_of(left.trailing_zeros() as usize))
    }
}

fn conflict(first: &str, second: &str, span: Span) -> Fault {
    let message = format!("{first} and {second} exclude each other in one block");
    Fault::new(Code::ModalConflict, span, message).hint("write them on two lines")
}

fn unknown_g(value: f64, code: i32, known: bool, span: Span) -> Fault {
    if let Some(why) = known.then(|| codes::g_elsewhere(code)).flatten() {
        let message = format!("{} cannot be carried out here", g_name(code));
        return Fault::new(Code::NotSupported, span, message).hint(why);
    }
    Fault::new(Code::UnknownGWord, span, format!("unknown code G{value}"))
}
