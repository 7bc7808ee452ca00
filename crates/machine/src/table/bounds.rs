//! Units and bounds of settings.

use crate::value::Value;
use kerf_program::settings::MM_PER_INCH;

/// Unit of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Unit {
    None,
    Mm,
    Degrees,
    /// Millimetres, or degrees on a rotary axis.
    AxisLength,
    MmPerS,
    MmPerS2,
    /// mm/s, or degrees/s on a rotary axis.
    AxisSpeed,
    /// mm/s² or degrees/s².
    AxisAccel,
    /// mm/s³ or degrees/s³.
    AxisJerk,
    /// Steps for a millimetre or a degree.
    StepsPerUnit,
    Seconds,
    Ms,
    Us,
    Ns,
    Percent,
    Hz,
    KHz,
    Baud,
    Pixels,
    Twips,
}

impl Unit {
    /// Returns the symbol behind a number; empty for numbers without unit.
    pub const fn symbol(self) -> &'static str {
        match self {
            Self::None => "",
            Self::Mm => "mm",
            Self::Degrees => "deg",
            Self::AxisLength => "mm or deg",
            Self::MmPerS => "mm/s",
            Self::MmPerS2 => "mm/s²",
            Self::AxisSpeed => "mm/s or deg/s",
            Self::AxisAccel => "mm/s² or deg/s²",
            Self::AxisJerk => "mm/s³ or deg/s³",
            Self::StepsPerUnit => "steps for a mm or degree",
            Self::Seconds => "s",
            Self::Ms => "ms",
            Self::Us => "µs",
            Self::Ns => "ns",
            Self::Percent => "%",
            Self::Hz => "Hz",
            Self::KHz => "kHz",
            Self::Baud => "baud",
            Self::Pixels => "px",
            Self::Twips => "twips",
        }
    }
}

/// Units in which a speed may be written: how many mm in how many seconds.
const SPEEDS: [(&str, f64, f64); 5] = [
    ("mm/s", 1.0, 1.0),
    ("mm/min", 1.0, 60.0),
    ("m/min", 1000.0, 60.0),
    ("in/s", MM_PER_INCH, 1.0),
    ("in/min", MM_PER_INCH, 60.0),
];

impl Unit {
    /// A value in this unit. A speed may carry another behind it, `6000 mm/min`; the error says which.
    pub(super) fn plain(self, value: &Value) -> Result<Value, String> {
        let (Self::MmPerS, Value::Text(text)) = (self, value) else { return Ok(value.clone()) };
        let text = text.trim();
        let end = text.find(|c: char| !(c.is_ascii_digit() || ".+-".contains(c)));
        let (number, unit) = text.split_at(end.unwrap_or(text.len()));
        let Ok(number) = number.parse::<f64>() else { return Ok(value.clone()) };
        let known = SPEEDS.iter().find(|(name, ..)| unit.trim().eq_ignore_ascii_case(name));
        known.map(|(_, mm, seconds)| Value::Number(number * mm / seconds)).ok_or_else(|| {
            let names = SPEEDS.map(|(name, ..)| name).join(", ");
            format!("a number of mm/s, or one with its unit: {names}")
        })
    }
}

/// Values that a setting accepts beside its type; of a list, each value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Bounds {
    /// Every finite number, every word of its choice.
    Any,
    /// Greater than 0.
    Positive,
    /// 0 or greater.
    NotNegative,
    /// From the first to the second.
    Range(f64, f64),
    /// The same, and 0 for none.
    RangeOrNone(f64, f64),
    /// One of these.
    OneOf(&'static [f64]),
    /// Like [`Bounds::Positive`], and without end too.
    PositiveOrInfinite,
}

impl Bounds {
    /// Checks that every number of a value fits; the error says what is accepted.
    pub(super) fn check(self, value: &Value) -> Result<(), String> {
        match value {
            Value::Number(number) if !self.holds(*number) => Err(self.to_string()),
            Value::List(values) => values.iter().try_for_each(|value| self.check(value)),
            _ => Ok(()),
        }
    }

    /// Returns the meaning of a value: 0 may say that there is none.
    pub(super) fn meant(self, value: Value) -> Value {
        let none = matches!(self, Self::RangeOrNone(..)) && value == Value::Number(0.0);
        if none { Value::none() } else { value }
    }

    fn holds(self, number: f64) -> bool {
        match self {
            Self::Any => number.is_finite(),
            Self::Positive => number.is_finite() && number > 0.0,
            Self::NotNegative => number.is_finite() && number >= 0.0,
            Self::Range(low, high) => (low..=high).contains(&number),
            Self::RangeOrNone(low, high) => number == 0.0 || (low..=high).contains(&number),
            Self::OneOf(values) => values.contains(&number),
            Self::PositiveOrInfinite => number > 0.0,
        }
    }
}

impl std::fmt::Display for Bounds {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Any => f.write_str("a finite number"),
            Self::Positive => f.write_str("greater than 0"),
            Self::NotNegative => f.write_str("0 or greater"),
            Self::Range(low, high) => write!(f, "{low} to {high}"),
            Self::RangeOrNone(low, high) => write!(f, "{low} to {high}, or 0 for none"),
            Self::OneOf(values) => {
                let words: Vec<String> = values.iter().map(f64::to_string).collect();
                write!(f, "one of {}", words.join(", "))
            }
            Self::PositiveOrInfinite => f.write_str("greater than 0, or inf"),
        }
    }
}
