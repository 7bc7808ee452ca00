//! The eight groups of shapes, named by their colours.

use serde::{Deserialize, Serialize};

/// A group: shapes that are cut alike. Eight of them, in the order of the Profiler reference
/// ("Groups"); a new shape is [`Group::Black`].
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize,
)]
#[serde(rename_all = "lowercase")]
pub enum Group {
    /// The group of new and imported shapes.
    #[default]
    Black,
    /// Group 1.
    Blue,
    /// Group 2.
    Green,
    /// Group 3.
    Cyan,
    /// Group 4.
    Red,
    /// Group 5.
    Magenta,
    /// Group 6.
    Brown,
    /// Group 7.
    White,
}

impl Group {
    /// All groups, in order.
    pub const ALL: [Self; 8] = [
        Self::Black,
        Self::Blue,
        Self::Green,
        Self::Cyan,
        Self::Red,
        Self::Magenta,
        Self::Brown,
        Self::White,
    ];

    /// Its place in [`Group::ALL`], 0 … 7.
    pub fn index(self) -> usize {
        self as usize
    }

    /// Its name, in small letters.
    pub fn name(self) -> &'static str {
        match self {
            Self::Black => "black",
            Self::Blue => "blue",
            Self::Green => "green",
            Self::Cyan => "cyan",
            Self::Red => "red",
            Self::Magenta => "magenta",
            Self::Brown => "brown",
            Self::White => "white",
        }
    }

    /// The group of that name, in any case, or of that number.
    pub fn named(word: &str) -> Option<Self> {
        let found = Self::ALL.into_iter().find(|group| group.name().eq_ignore_ascii_case(word));
        found.or_else(|| Self::ALL.get(word.parse::<usize>().ok()?).copied())
    }

    /// Its number among the 256 colours of DXF drawings: 7 is black on white and white on black.
    pub fn dxf_colour(self) -> u8 {
        match self {
            Self::Black => 7,
            Self::Blue => 5,
            Self::Green => 3,
            Self::Cyan => 4,
            Self::Red => 1,
            Self::Magenta => 6,
            Self::Brown => 34,
            Self::White => 9,
        }
    }
}

impl std::fmt::Display for Group {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pro_group_eight() {
        let names: Vec<_> = Group::ALL.iter().map(|group| group.name()).collect();
        let expected = ["black", "blue", "green", "cyan", "red", "magenta", "brown", "white"];
        assert_eq!(names, expected);
        assert!(Group::ALL.iter().enumerate().all(|(n, group)| group.index() == n));
    }

    #[test]
    fn groups_are_found_by_name_and_by_number() {
        assert_eq!(Group::named("Red"), Some(Group::Red));
        assert_eq!(Group::named("7"), Some(Group::White));
        assert_eq!(Group::named("8"), None);
        assert_eq!(Group::named("purple"), None);
    }
}
