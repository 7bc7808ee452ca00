//! The words of a block, sorted: one code a group, one value a letter.

use crate::syntax::codes::{self, G_GROUPS, M_GROUPS, MOTION, g_group, g_name, m_group};
use crate::syntax::tree::{PlainMove, Span, Word};
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
    /// A code that switches off what is never on.
    pub(crate) cancels: Option<i32>,
    /// G80 stands beside another motion.
    pub(crate) beside_g80: bool,
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

pub(crate) const fn letter_of(slot: usize) -> char {
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
pub(crate) const PLACE_WORDS: u32 = AXIS_WORDS | letters(b"@^");

impl Default for Gathered {
    fn default() -> Self {
        Self {
            g: [None; G_GROUPS],
            cancels: None,
            beside_g80: false,
            m: [None; M_GROUPS],
            values: [0.0; LETTERS],
            given: 0,
        }
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
    pub(crate) fn of_move(plain: &PlainMove) -> Self {
        let mut all = Self::default();
        if plain.motion < PlainMove::MODAL {
            all.g[MOTION] = Some(i32::from(plain.motion) * 10);
        }
        plain.words().for_each(|(letter, value)| all.set(letter, value));
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
        if known && codes::g_cancels(code) {
            self.cancels = Some(code);
            return Ok(());
        }
        let Some(group) = known.then(|| g_group(code)).flatten() else {
            return Err(unknown_g(value, code, known, span));
        };
        match self.g[group].replace(code) {
            // G80 ends a cycle; another motion beside it does so too.
            Some(800) => {
                self.beside_g80 |= code != 800;
                Ok(())
            }
            Some(other) if code == 800 => {
                self.g[group] = Some(other);
                self.beside_g80 = true;
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
                UNKNOWN
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

    /// Returns `true` if a letter has a value.
    pub(crate) const fn has(&self, letter: u8) -> bool {
        self.given & (1 << slot(letter)) != 0
    }

    /// Returns `true` if one of some letters has a value.
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

    /// Only the codes of some groups, with the words they use, and some letters.
    pub(crate) fn only(&self, groups: &[usize], letters: &[u8]) -> Self {
        let mut kept = Self::default();
        for group in groups {
            kept.g[*group] = self.g[*group];
        }
        let used = match (kept.g[codes::PATH], kept.g[codes::TOOL_LENGTH]) {
            (Some(_), _) => b"PQ".as_slice(),
            (_, Some(430)) => b"H",
            (_, Some(431)) => b"XYZABC",
            _ => b"",
        };
        for letter in letters.iter().chain(used) {
            if let Some(value) = self.get(*letter) {
                kept.set(*letter, value);
            }
        }
        kept
    }

    /// The letters that have a value.
    pub(crate) const fn given(&self) -> u32 {
        self.given
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
    Fault::new(Code::UnknownGWord, span, format!("unknown code G{value}")).hint(UNKNOWN)
}

/// Hint for mending a code that nobody knows.
const UNKNOWN: &str =
    "is a blank or a point missing? the book lists the codes; put others into a comment";
