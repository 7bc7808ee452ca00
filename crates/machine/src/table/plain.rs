//! Converts the types of fields to values and back.

use crate::settings::Words;
use crate::value::Value;
use kerf_program::settings::{AxisUnit, Distance, LinearUnit, PlungeSign};
use kerf_program::{Axes, Axis, AxisSet, RampModel};

/// A type that a setting can have. `put` answers what was wanted where the value does not fit.
pub(super) trait Plain {
    /// The present value.
    fn value(&self) -> Value;
    /// Takes a value.
    fn put(&mut self, value: &Value) -> Result<(), String>;
    /// The words it accepts, when it is a choice of words; `none` where it may be absent.
    fn words(&self) -> Vec<&'static str> {
        Vec::new()
    }
}

/// A type whose value is one number, word or text.
pub(super) trait Single: Sized {
    /// It as a value.
    fn show(&self) -> Value;
    /// Reads a value, or tells what was wanted.
    fn read(value: &Value) -> Result<Self, String>;
    /// The words of a choice.
    fn words() -> Vec<&'static str> {
        Vec::new()
    }
}

impl Single for bool {
    fn show(&self) -> Value {
        Value::Flag(*self)
    }

    fn read(value: &Value) -> Result<Self, String> {
        match value {
            Value::Flag(flag) => Ok(*flag),
            Value::Number(n) if *n == 0.0 || *n == 1.0 => Ok(*n == 1.0),
            _ => Err("true or false".into()),
        }
    }
}

impl Single for f64 {
    fn show(&self) -> Value {
        Value::Number(*self)
    }

    fn read(value: &Value) -> Result<Self, String> {
        match value {
            Value::Number(number) => Ok(*number),
            _ => Err("a number".into()),
        }
    }
}

macro_rules! whole {
    ($($type:ty)*) => {$(
        impl Single for $type {
            fn show(&self) -> Value {
                Value::Number(f64::from(*self))
            }

            fn read(value: &Value) -> Result<Self, String> {
                let range = f64::from(Self::MIN)..=f64::from(Self::MAX);
                match value {
                    Value::Number(n) if n.fract() == 0.0 && range.contains(n) => Ok(*n as Self),
                    _ => Err("a whole number".into()),
                }
            }
        }
    )*};
}

whole!(u8 i8 i32 u32);

impl Single for String {
    fn show(&self) -> Value {
        Value::Text(self.clone())
    }

    fn read(value: &Value) -> Result<Self, String> {
        match value {
            Value::Text(text) => Ok(text.clone()),
            // Pins with commas between, typed without quotes.
            Value::List(texts) => {
                let texts: Result<Vec<String>, String> = texts.iter().map(Self::read).collect();
                texts.map(|texts| texts.join(", "))
            }
            _ => Err("a text".into()),
        }
    }
}

impl<T: Words> Single for T {
    fn show(&self) -> Value {
        Value::Text(self.word().into())
    }

    fn read(value: &Value) -> Result<Self, String> {
        match value {
            Value::Text(text) => Self::of_word(text).ok_or_else(choices::<T>),
            // A word such as `off` or `none` may be read as something else.
            _ => Err(choices::<T>()),
        }
    }

    fn words() -> Vec<&'static str> {
        T::ALL.iter().map(|(word, _)| *word).collect()
    }
}

/// `a, b or c`.
fn choices<T: Words>() -> String {
    let words: Vec<_> = T::ALL.iter().map(|(word, _)| *word).collect();
    match words.split_last() {
        Some((last, [])) => (*last).to_owned(),
        Some((last, rest)) => format!("{} or {last}", rest.join(", ")),
        None => String::new(),
    }
}

impl<T: Single> Plain for T {
    fn value(&self) -> Value {
        self.show()
    }

    fn put(&mut self, value: &Value) -> Result<(), String> {
        *self = T::read(value)?;
        Ok(())
    }

    fn words(&self) -> Vec<&'static str> {
        T::words()
    }
}

impl<T: Single> Plain for Option<T> {
    fn value(&self) -> Value {
        self.as_ref().map_or_else(Value::none, Single::show)
    }

    fn put(&mut self, value: &Value) -> Result<(), String> {
        *self = match value.is_none() {
            true => None,
            false => Some(T::read(value).map_err(|wanted| format!("{wanted}, or none"))?),
        };
        Ok(())
    }

    fn words(&self) -> Vec<&'static str> {
        [T::words(), vec![crate::value::NONE]].concat()
    }
}

/// The first values of a list are given, the others stay.
impl<T: Plain, const N: usize> Plain for [T; N] {
    fn value(&self) -> Value {
        Value::List(self.iter().map(Plain::value).collect())
    }

    fn put(&mut self, value: &Value) -> Result<(), String> {
        let values = match value {
            Value::List(values) => values.as_slice(),
            one => std::slice::from_ref(one),
        };
        if values.len() > N {
            return Err(format!("a shorter list, of at most {N} values"));
        }
        for (place, value) in self.iter_mut().zip(values) {
            place.put(value).map_err(|wanted| format!("a list, each {wanted}"))?;
        }
        Ok(())
    }
}

impl Plain for Axes {
    fn value(&self) -> Value {
        self.0.value()
    }

    fn put(&mut self, value: &Value) -> Result<(), String> {
        self.0.put(value)
    }
}

/// Letters in any case and order; axis C is also called w.
impl Plain for AxisSet {
    fn value(&self) -> Value {
        Value::List(self.iter().map(|axis| Value::Text(axis.word().into())).collect())
    }

    fn put(&mut self, value: &Value) -> Result<(), String> {
        let words = match value {
            Value::List(values) => values.iter().map(letters).collect::<Option<String>>(),
            one => letters(one),
        };
        let wanted = || "a list of axes: x, y, z, a, b, w".to_owned();
        let words = words.filter(|it| it != crate::value::NONE).unwrap_or_default();
        *self = words.chars().try_fold(Self::EMPTY, |set, letter| {
            let axis = Axis::of_word(letter.encode_utf8(&mut [0; 4]));
            axis.or_else(|| Axis::from_letter(letter)).map(|axis| set.with(axis)).ok_or_else(wanted)
        })?;
        Ok(())
    }
}

fn letters(value: &Value) -> Option<String> {
    match value {
        Value::Text(text) => Some(text.to_ascii_lowercase()),
        _ => None,
    }
}

impl Words for Axis {
    const ALL: &'static [(&'static str, Self)] = &[
        ("x", Self::X),
        ("y", Self::Y),
        ("z", Self::Z),
        ("a", Self::A),
        ("b", Self::B),
        ("w", Self::C),
    ];
}

impl Words for LinearUnit {
    const ALL: &'static [(&'static str, Self)] = &[("in", Self::Inch), ("mm", Self::Mm)];
}

impl Words for AxisUnit {
    const ALL: &'static [(&'static str, Self)] = &[
        ("in", Self::Linear(LinearUnit::Inch)),
        ("mm", Self::Linear(LinearUnit::Mm)),
        ("deg", Self::Degrees),
    ];
}

impl Words for Distance {
    const ALL: &'static [(&'static str, Self)] =
        &[("absolute", Self::Absolute), ("relative", Self::Relative)];
}

impl Words for PlungeSign {
    const ALL: &'static [(&'static str, Self)] = &[("minus", Self::Minus), ("plus", Self::Plus)];
}

impl Words for RampModel {
    const ALL: &'static [(&'static str, Self)] =
        &[("shopbot", Self::Shopbot), ("profiler", Self::Profiler), ("optimal", Self::Optimal)];
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_flag_may_be_written_as_0_or_1() {
        let read = |n| bool::read(&Value::Number(n));
        assert_eq!((read(1.0), read(0.0)), (Ok(true), Ok(false)));
        assert!(read(2.0).is_err() && bool::read(&Value::Flag(true)) == Ok(true));
    }
}
