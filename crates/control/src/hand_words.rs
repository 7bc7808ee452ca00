//! Words by which the operator moves the tool while a question is open.

use kerf_program::{AXES, Axes, QuestionKind};
use std::fmt;

/// Word of a key that moves the tool.
pub(crate) const KEY: &str = "pendant";

/// A movement for as long as somebody holds a key.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jog {
    /// Distance it goes when nobody lets go, mm or degrees.
    pub by: Axes,
    /// Share of the jog speed, 0 … 1.
    pub speed: f64,
}

impl Jog {
    /// Reads `jog 0,-100,0,0,0,0 0.5`.
    pub fn read(words: &str) -> Option<Self> {
        let mut words = words.split(' ');
        let (command, by, speed) = (words.next()?, words.next()?, words.next()?);
        let number = |word: &str| word.parse().ok().filter(|n: &f64| n.is_finite());
        let by: Option<Vec<f64>> = by.split(',').map(number).collect();
        let by: [f64; AXES] = by?.try_into().ok()?;
        let speed = number(speed).filter(|speed| (0.0..=1.0).contains(speed))?;
        let whole = command == "jog" && words.next().is_none();
        whole.then_some(Self { by: Axes(by), speed })
    }
}

impl fmt::Display for Jog {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [x, y, z, a, b, c] = self.by.0;
        write!(f, "jog {x},{y},{z},{a},{b},{c} {}", self.speed)
    }
}

/// The word that takes the tool out of the cut while a program asks.
pub const LIFT: &str = "lift";

/// Move of the tool by the operator while a program waits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Aside {
    /// Out of the cut, what turns stops.
    Lift,
    /// By hand.
    Jog(Jog),
}

impl Aside {
    /// Reads `lift`, or a jog.
    pub fn read(words: &str) -> Option<Self> {
        if words.trim().eq_ignore_ascii_case(LIFT) {
            return Some(Self::Lift);
        }
        Jog::read(words).map(Self::Jog)
    }

    /// Returns `true` if a question of a kind leaves the tool to the operator: a program waits for him, and goes on
    /// where it was.
    pub const fn is_for(kind: QuestionKind) -> bool {
        matches!(kind, QuestionKind::Pause | QuestionKind::Msgbox)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_is_read() {
        let jog = Jog { by: Axes([0.0, -100.25, 0.0, 0.0, 3.0, 0.0]), speed: 0.5 };
        assert_eq!(Jog::read(&jog.to_string()), Some(jog));
        let wrong = ["", "jog", "jog 1,2,3 1", "jog 1,2,3,4,5,6", "jog 1,2,3,4,5,inf 1"];
        for words in wrong.into_iter().chain(["jog 0,0,0,0,0,0 2", "nudge 0,0,0,0,0,0 1"]) {
            assert_eq!(Jog::read(words), None, "{words}");
        }
    }
}
