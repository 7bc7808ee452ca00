//! Choices with a word for each.

/// A choice that a file spells with a word.
pub(crate) trait Words: Copy + PartialEq + 'static {
    /// Every choice with its word.
    const ALL: &'static [(&'static str, Self)];

    /// The word of a choice.
    fn word(self) -> &'static str {
        Self::ALL.iter().find(|(_, it)| *it == self).map_or("", |(word, _)| word)
    }

    /// The choice of a word.
    fn of_word(word: &str) -> Option<Self> {
        Self::ALL.iter().find(|(it, _)| it.eq_ignore_ascii_case(word)).map(|(_, it)| *it)
    }
}

/// An enumeration together with the words of its variants; the first is the default.
macro_rules! words {
    ($(#[$meta:meta])* $name:ident { $(#[$first_meta:meta])* $first:ident = $first_word:literal,
        $($(#[$variant_meta:meta])* $variant:ident = $word:literal),* $(,)? }) => {
        $(#[$meta])*
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum $name {
            $(#[$first_meta])* #[default] $first,
            $($(#[$variant_meta])* $variant,)*
        }

        impl $crate::settings::Words for $name {
            const ALL: &'static [(&'static str, Self)] =
                &[($first_word, Self::$first), $(($word, Self::$variant),)*];
        }

        impl $name {
            /// The word it has in files.
            pub fn word(self) -> &'static str {
                $crate::settings::Words::word(self)
            }
        }
    };
}

pub(super) use words;
