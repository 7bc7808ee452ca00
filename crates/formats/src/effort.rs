//! The bounds of a reading. A file may place one thing again and again, and what is placed may place others:
//! a few hundred bytes then stand for more shapes than a memory holds. Every such reader counts what it draws
//! by placing, and ends where that is more than anybody cuts.

use crate::finding::{Findings, Weight};
use kerf_diag::with_commas;

/// Entities, and elements of SVG, that are drawn by placing things again, at the most, beyond those that the
/// file itself writes. Nothing bounds what a file writes out.
pub const MOST_PLACED: u64 = 200_000;

/// The vertices of all that is placed, at the most, beyond one for every pair or byte that the file writes.
pub const MOST_PLACED_VERTICES: u64 = 5_000_000;

/// The reason for which nothing of a drawing was read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ended {
    /// Nobody waits for it any more.
    GivenUp,
    /// Things that are placed again draw more than [`MOST_PLACED`] or [`MOST_PLACED_VERTICES`] beyond the file.
    TooMuch,
}

/// The rest that a reading may still draw by placing things again.
pub(crate) struct Effort<'a> {
    given_up: &'a dyn Fn() -> bool,
    most_placed: u64,
    placed_left: u64,
    vertices_left: u64,
    ended: Option<Ended>,
    told: bool,
}

impl<'a> Effort<'a> {
    /// The effort for a file that writes so many entities that can be placed, in so many pairs or bytes.
    pub fn of(entities: usize, pairs: usize, given_up: &'a dyn Fn() -> bool) -> Self {
        Self {
            given_up,
            most_placed: MOST_PLACED,
            placed_left: MOST_PLACED + entities as u64,
            vertices_left: MOST_PLACED_VERTICES + pairs as u64,
            ended: None,
            told: false,
        }
    }

    /// The same with another bound in place of [`MOST_PLACED`].
    pub fn at_most(self, most_placed: u64) -> Self {
        let written = self.placed_left - self.most_placed;
        Self { most_placed, placed_left: written + most_placed, ..self }
    }

    /// Counts an entity; nothing more is drawn when this is false.
    pub fn goes_on(&mut self, is_placed: bool) -> bool {
        if self.ended.is_some() {
            return false;
        }
        if (self.given_up)() {
            self.ended = Some(Ended::GivenUp);
        } else if is_placed {
            self.take_placed();
        }
        self.ended.is_none()
    }

    fn take_placed(&mut self) {
        match self.placed_left.checked_sub(1) {
            Some(left) => self.placed_left = left,
            None => self.ended = Some(Ended::TooMuch),
        }
    }

    /// Counts the vertices of what was placed.
    pub fn drew(&mut self, vertices: usize) {
        match self.vertices_left.checked_sub(vertices as u64) {
            Some(left) => self.vertices_left = left,
            None => self.ended = self.ended.or(Some(Ended::TooMuch)),
        }
    }

    /// The reason for which the reading ended early.
    pub const fn ended(&self) -> Option<Ended> {
        self.ended
    }

    /// Tells once that a reading ended since things were placed too often, where that is so: `what` placed them,
    /// at a line and a column.
    pub fn tell(&mut self, what: &str, at: (u32, u32), mend: &str, findings: &mut Findings) {
        let bound = match self.ended {
            Some(Ended::TooMuch) if self.placed_left > 0 => {
                format!("{} vertices", with_commas(MOST_PLACED_VERTICES))
            }
            Some(Ended::TooMuch) => format!("{} shapes", with_commas(self.most_placed)),
            Some(Ended::GivenUp) | None => return,
        };
        if std::mem::replace(&mut self.told, true) {
            return;
        }
        let text = format!(
            "{what} comes to more than {bound} beyond those that the file writes: nothing of the drawing is read; {mend}"
        );
        findings.add_at("placed", at, Weight::Warning, text);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_file_writes_itself_is_free() {
        let mut effort = Effort::of(3, 0, &|| false).at_most(2);
        assert!((0..1000).all(|_| effort.goes_on(false)));
        assert!((0..5).all(|_| effort.goes_on(true)));
        assert!(!effort.goes_on(true) && !effort.goes_on(false));
        assert_eq!(effort.ended(), Some(Ended::TooMuch));
    }

    #[test]
    fn a_reading_that_is_given_up_ends() {
        let mut effort = Effort::of(0, 0, &|| true);
        assert!(!effort.goes_on(false));
        assert_eq!(effort.ended(), Some(Ended::GivenUp));
    }
}
