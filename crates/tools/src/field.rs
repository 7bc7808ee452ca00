//! The fields of a form.

use kerf_program::rounded;

/// Millimetres in an inch.
pub const INCH_MM: f64 = 25.4;

/// A field of a form.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Field {
    /// Name in a line.
    pub key: &'static str,
    /// Name in a form.
    pub label: &'static str,
    /// Kind of the entries that are allowed.
    pub kind: Kind,
    /// Value at first.
    pub default: &'static str,
    /// Note about the field; may be empty.
    pub doc: &'static str,
}

/// Kind of the entries that a field allows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// A length in the unit of the form, at least so long; defaults are inches.
    Length(f64),
    /// A number between two.
    Number(f64, f64),
    /// A whole number between two.
    Whole(u32, u32),
    /// One of these words.
    Choice(&'static [&'static str]),
    /// A line of text.
    Text,
    /// The name of a file.
    File,
}

/// The field that says what lengths are in.
pub const UNITS: Field = Field {
    key: "units",
    label: "Units",
    kind: Kind::Choice(&["as set", "in", "mm"]),
    default: "as set",
    doc: "What the lengths here are measured in, and the part file is written in.",
};

/// A field for a length of any sign.
pub const fn place(key: &'static str, label: &'static str, default: &'static str) -> Field {
    length(key, label, default, f64::NEG_INFINITY)
}

/// A field for a length that is at least so long.
pub const fn length(
    key: &'static str,
    label: &'static str,
    default: &'static str,
    least: f64,
) -> Field {
    Field { key, label, kind: Kind::Length(least), default, doc: "" }
}

/// A field for one of some words; the first is the usual.
pub const fn choice(
    key: &'static str,
    label: &'static str,
    words: &'static [&'static str],
) -> Field {
    Field { key, label, kind: Kind::Choice(words), default: words[0], doc: "" }
}

/// A field for a line of text.
pub const fn text(key: &'static str, label: &'static str) -> Field {
    Field { key, label, kind: Kind::Text, default: "", doc: "" }
}

/// A field for a whole number.
pub const fn whole(
    key: &'static str,
    label: &'static str,
    default: &'static str,
    most: u32,
) -> Field {
    Field { key, label, kind: Kind::Whole(1, most), default, doc: "" }
}

/// A field for the name of the file that is made.
pub const fn file(default: &'static str) -> Field {
    Field { key: "file", label: "Part file", kind: Kind::File, default, doc: "" }
}

impl Field {
    /// Returns the value at first: lengths in millimetres or inches.
    pub fn shown_default(&self, metric: bool) -> String {
        let Kind::Length(_) = self.kind else { return self.default.into() };
        match self.default.parse::<f64>() {
            Ok(inches) if metric => rounded(inches * INCH_MM, 4).to_string(),
            _ => self.default.into(),
        }
    }

    /// The same with a word about it.
    pub const fn about(mut self, doc: &'static str) -> Self {
        self.doc = doc;
        self
    }
}
