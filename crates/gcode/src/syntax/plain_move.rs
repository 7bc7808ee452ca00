//! Lines that name nothing but a place and a speed: nearly all of a large file.

/// A line of G0 … G3, or without a code, whose words are literal numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlainMove {
    /// 0 … 3 for G0 … G3, [`PlainMove::MODAL`] when the line names none.
    pub motion: u8,
    /// Bit i set: the letter i of [`PlainMove::LETTERS`] has a value.
    pub given: u16,
    /// The value of each letter; those of letters that are not given mean nothing.
    values: [f64; Self::LETTERS.len()],
}

impl Default for PlainMove {
    fn default() -> Self {
        Self { motion: Self::MODAL, given: 0, values: [0.0; Self::LETTERS.len()] }
    }
}

impl PlainMove {
    /// The line names no motion.
    pub const MODAL: u8 = 4;
    /// The letters such a line may hold.
    pub const LETTERS: [u8; 12] = *b"XYZABCIJKRFS";

    /// Forgets everything.
    pub(crate) fn clear(&mut self) {
        (self.motion, self.given) = (Self::MODAL, 0);
    }

    /// The value of the letter at a place of [`PlainMove::LETTERS`].
    pub fn value(&self, letter: usize) -> Option<f64> {
        let value = self.values.get(letter)?;
        (self.given & (1 << letter) != 0).then_some(*value)
    }

    /// Gives a letter its value; `None` when there is no such letter, or it has one.
    pub(crate) fn give(&mut self, letter: usize, value: f64) -> Option<()> {
        let place = self.values.get_mut(letter)?;
        let bit = 1 << letter;
        if self.given & bit != 0 {
            return None;
        }
        *place = value;
        self.given |= bit;
        Some(())
    }

    /// The letters with their values.
    pub fn words(&self) -> impl Iterator<Item = (u8, f64)> {
        let letters = Self::LETTERS.into_iter().enumerate();
        letters.filter_map(|(at, letter)| Some((letter, self.value(at)?)))
    }
}
