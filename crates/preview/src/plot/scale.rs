//! From values to places on the page, and the round numbers at an edge.

/// Share of a scale that is left free beyond the values.
const ROOM: f64 = 0.07;

/// A straight scale: values from `low` to `high` on the page from `start` to `end`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    pub low: f64,
    pub high: f64,
    pub start: f64,
    pub end: f64,
    /// Values of one user unit.
    pub unit: f64,
}

/// A number at an edge.
#[derive(Clone, Debug, PartialEq)]
pub struct Tick {
    pub at: f64,
    pub text: String,
}

impl Scale {
    /// Returns the place of a value on the page.
    pub fn at(&self, value: f64) -> f64 {
        self.start + (value - self.low) / (self.high - self.low) * (self.end - self.start)
    }

    /// Room for the lines of the highest and the lowest value; nothing below zero without values.
    pub fn with_room(mut self) -> Self {
        let room = ROOM * (self.high - self.low);
        self.high += room;
        self.low -= if self.low < 0.0 { room } else { 0.0 };
        self
    }

    /// Round numbers, at least so far apart on the page.
    pub fn ticks(&self, apart: f64) -> Vec<Tick> {
        let step = self.step(apart);
        let decimals = (-(step / self.unit).log10().floor()).clamp(0.0, 9.0) as usize;
        let first = (self.low / step - 1e-9).ceil() as i64;
        let last = (self.high / step + 1e-9).floor() as i64;
        let tick = |k: i64| {
            let value = k as f64 * step;
            Tick { at: self.at(value), text: text(value / self.unit, decimals) }
        };
        (first..=last.min(first + 200)).map(tick).collect()
    }

    /// 1, 2 or 5 times a power of ten of the user's unit.
    fn step(&self, apart: f64) -> f64 {
        let least = (self.high - self.low) / self.unit * apart / (self.end - self.start).abs();
        let power = 10f64.powf(least.max(1e-12).log10().floor());
        let factor = [1.0, 2.0, 5.0, 10.0].into_iter().find(|f| f * power >= least * (1.0 - 1e-9));
        factor.unwrap_or(10.0) * power * self.unit
    }
}

/// A number with thin spaces between thousands and a true minus.
pub fn text(value: f64, decimals: usize) -> String {
    let plain = format!("{:.decimals$}", value.abs());
    let (whole, rest) = plain.split_once('.').map_or((&*plain, ""), |(a, b)| (a, b));
    let mut out = String::new();
    if value < 0.0 && plain.bytes().any(|b| (b'1'..=b'9').contains(&b)) {
        out.push('−');
    }
    for (i, digit) in whole.chars().enumerate() {
        let thousand = whole.len() > 4 && i > 0 && (whole.len() - i).is_multiple_of(3);
        out.extend(thousand.then_some('\u{2009}'));
        out.push(digit);
    }
    if !rest.is_empty() {
        out.push('.');
        out.push_str(rest);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(low: f64, high: f64, unit: f64, expected: &[&str]) {
        let scale = Scale { low, high, start: 0.0, end: 100.0, unit };
        let ticks: Vec<String> = scale.ticks(20.0).into_iter().map(|t| t.text).collect();
        assert_eq!(ticks, expected);
    }

    #[test]
    fn edges_have_round_numbers() {
        check(0.0, 97.0, 1.0, &["0", "20", "40", "60", "80"]);
        check(-0.9, 1.0, 1.0, &["−0.5", "0.0", "0.5", "1.0"]);
        check(0.0, 25.4, 25.4, &["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
        check(-12_000.0, 500.0, 1.0, &["−10\u{2009}000", "−5000", "0"]);
    }

    #[test]
    fn only_what_has_values_below_zero_gets_room_there() {
        let ends = |low, high| {
            let scale = Scale { low, high, start: 0.0, end: 1.0, unit: 1.0 }.with_room();
            [scale.low.round(), scale.high.round()]
        };
        assert_eq!((ends(0.0, 100.0), ends(-100.0, 0.0)), ([0.0, 107.0], [-107.0, 7.0]));
    }
}
