//! Words of a clause of `kerf draw --do`: `rotate 30 about 0,0`.

use kerf_geom::{Point2, Vec2};
use thiserror::Error;

/// Mistake in the words of a clause.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum WordError {
    /// The clause ends too early.
    #[error("{0} is missing")]
    Missing(&'static str),
    /// A word does not say what is wanted at its place.
    #[error("`{word}` is not {wanted}")]
    NotA {
        /// The word.
        word: String,
        /// Description of what was wanted: "a number", "a point as x,y".
        wanted: &'static str,
    },
    /// Words that nobody asked for.
    #[error("`{0}` is one word too many")]
    TooMany(String),
}

/// The words of a clause that were not used yet.
#[derive(Clone, Debug)]
pub struct Words<'a> {
    rest: std::iter::Peekable<std::str::SplitWhitespace<'a>>,
}

impl<'a> Words<'a> {
    /// All words of a clause.
    pub fn of(clause: &'a str) -> Self {
        Self { rest: clause.split_whitespace().peekable() }
    }

    /// The next word, or nothing at the end.
    pub fn next_word(&mut self) -> Option<&'a str> {
        self.rest.next()
    }

    /// The next word, left where it is.
    pub fn peek(&mut self) -> Option<&'a str> {
        self.rest.peek().copied()
    }

    /// Takes the next word if it is this one, in any case.
    pub fn takes(&mut self, keyword: &str) -> bool {
        let found = self.peek().is_some_and(|word| word.eq_ignore_ascii_case(keyword));
        if found {
            self.rest.next();
        }
        found
    }

    /// The next word, read by `read`.
    ///
    /// # Errors
    /// The clause ends, or `read` does not understand the word.
    pub fn read<T>(
        &mut self,
        what: &'static str,
        wanted: &'static str,
        read: impl FnOnce(&str) -> Option<T>,
    ) -> Result<T, WordError> {
        let word = self.rest.next().ok_or(WordError::Missing(what))?;
        read(word).ok_or_else(|| WordError::NotA { word: word.to_owned(), wanted })
    }

    /// A number.
    ///
    /// # Errors
    /// As [`Words::read`].
    pub fn number(&mut self, what: &'static str) -> Result<f64, WordError> {
        self.read(what, "a number", number)
    }

    /// A place, `x,y`.
    ///
    /// # Errors
    /// As [`Words::read`].
    pub fn point(&mut self, what: &'static str) -> Result<Point2, WordError> {
        self.read(what, "a point as x,y", pair).map(|(x, y)| Point2::new(x, y))
    }

    /// A displacement, `x,y`.
    ///
    /// # Errors
    /// As [`Words::read`].
    pub fn vector(&mut self, what: &'static str) -> Result<Vec2, WordError> {
        self.read(what, "a distance as x,y", pair).map(|(x, y)| Vec2::new(x, y))
    }

    /// The number of a shape, counted from 1.
    ///
    /// # Errors
    /// As [`Words::read`].
    pub fn shape(&mut self) -> Result<usize, WordError> {
        self.read("the number of a shape", "the number of a shape, from 1", shape)
    }

    /// One word that says nothing new, then `operation`.
    ///
    /// # Errors
    /// Another word stands there, or none.
    pub fn keyword<T>(&mut self, word: &'static str, operation: T) -> Result<T, WordError> {
        self.read(word, word, |found| found.eq_ignore_ascii_case(word).then_some(operation))
    }

    /// All that is left, as one text.
    pub fn rest(&mut self) -> String {
        self.rest.by_ref().collect::<Vec<_>>().join(" ")
    }

    /// The clause must be used up.
    ///
    /// # Errors
    /// A word is left.
    pub fn end(&mut self) -> Result<(), WordError> {
        self.rest.next().map_or(Ok(()), |word| Err(WordError::TooMany(word.to_owned())))
    }
}

/// A finite number.
pub(super) fn number(word: &str) -> Option<f64> {
    word.parse().ok().filter(|value: &f64| value.is_finite())
}

/// `3,5-9`.
pub(super) fn numbers(w: &mut Words) -> Result<Vec<usize>, WordError> {
    w.read("the list of shapes", "a list of shapes such as 1,3-5", |word| {
        let ranges = word.split(',').map(range).collect::<Option<Vec<_>>>()?;
        Some(ranges.into_iter().flatten().collect())
    })
}

/// The most shapes that a list of numbers may name.
const MOST_SHAPES: usize = 10_000_000;

fn range(word: &str) -> Option<std::ops::RangeInclusive<usize>> {
    let (from, to) = word.split_once('-').unwrap_or((word, word));
    let (from, to) = (from.parse().ok()?, to.parse().ok()?);
    (from > 0 && from <= to && to <= MOST_SHAPES).then_some(from..=to)
}

/// Two finite numbers with a comma between.
pub(super) fn pair(word: &str) -> Option<(f64, f64)> {
    let (x, y) = word.split_once(',')?;
    Some((number(x)?, number(y)?))
}

fn shape(word: &str) -> Option<usize> {
    word.parse().ok().filter(|n| *n > 0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_read_in_order() {
        let mut words = Words::of(" 30 about  1.5,-2 Keep 7");
        assert_eq!(words.number("angle"), Ok(30.0));
        assert!(words.takes("ABOUT"));
        assert_eq!(words.point("centre"), Ok(Point2::new(1.5, -2.0)));
        assert!(!words.takes("drop") && words.takes("keep"));
        assert_eq!(words.shape(), Ok(7));
        assert_eq!(words.end(), Ok(()));
    }

    fn fails<T>(clause: &str, read: impl Fn(&mut Words) -> Result<T, WordError>, message: &str) {
        let told = read(&mut Words::of(clause)).err().map(|error| error.to_string());
        assert_eq!(told.as_deref(), Some(message));
    }

    #[test]
    fn errors_name_the_word() {
        fails("", |w| w.number("the angle"), "the angle is missing");
        fails("3x", |w| w.number("the angle"), "`3x` is not a number");
        fails("inf", |w| w.number("the angle"), "`inf` is not a number");
        fails("3", |w| w.point("the centre"), "`3` is not a point as x,y");
        fails("0", |w| w.shape(), "`0` is not the number of a shape, from 1");
        fails("a b", |w| w.end(), "`a` is one word too many");
    }
}
