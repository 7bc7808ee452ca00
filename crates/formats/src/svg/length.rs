//! Lengths: what a unit and a percentage are in units of the file.
//!
//! Sources: SVG 1.1, section 7.10; SVG 2, section 8.9; CSS Values and Units 4, sections 5 and 6.

use kerf_geom::Vec2;

/// The size of letters where a file does not tell it: CSS's `medium`, in units of the file.
pub const LETTER: f64 = 16.0;

/// Height of an x, in sizes of its letter, where the font is not known (CSS Values 4, 6.1.1).
const X_HEIGHT: f64 = 0.5;

/// Length of which a percentage is a part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Along {
    /// The width of the viewport.
    Width,
    /// Its height.
    Height,
    /// Its diagonal, divided by the square root of two.
    Both,
}

impl Along {
    /// Returns what percentages of an attribute refer to.
    pub fn of(name: &str) -> Self {
        match name {
            "x" | "x1" | "x2" | "cx" | "rx" | "width" => Self::Width,
            "y" | "y1" | "y2" | "cy" | "ry" | "height" => Self::Height,
            _ => Self::Both,
        }
    }

    fn whole(self, room: Vec2) -> f64 {
        match self {
            Self::Width => room.x,
            Self::Height => room.y,
            Self::Both => (0.5 * room.dot(room)).sqrt(),
        }
    }
}

/// Sizes that relative lengths at a place in a file refer to, all in units of the file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measure {
    /// The nearest viewport; nothing where the file does not tell its size.
    pub room: Option<Vec2>,
    /// The page.
    pub page: Option<Vec2>,
    /// The size of the letters here.
    pub letter: f64,
    /// The size of the letters of the page.
    pub page_letter: f64,
}

impl Default for Measure {
    fn default() -> Self {
        Self { room: None, page: None, letter: LETTER, page_letter: LETTER }
    }
}

impl Measure {
    /// A length in units of the file, or why it is none.
    pub fn units(&self, text: &str, along: Along) -> Result<f64, String> {
        let (number, unit) = split(text)?;
        let unknown = || format!("`{}` of a page whose size is not told", text.trim());
        let room = self.room.map(|room| along.whole(room)).ok_or_else(unknown);
        let page = |of: fn(Vec2) -> f64| self.page.map(of).ok_or_else(unknown);
        let hundredth = |whole: f64| whole / 100.0;
        let units = match unit.as_str() {
            "%" => hundredth(room?),
            "em" => self.letter,
            "ex" | "ch" => X_HEIGHT * self.letter,
            "rem" => self.page_letter,
            "vw" => hundredth(page(|page| page.x)?),
            "vh" => hundredth(page(|page| page.y)?),
            "vmin" => hundredth(page(|page| page.x.min(page.y))?),
            "vmax" => hundredth(page(|page| page.x.max(page.y))?),
            _ => absolute(&unit).ok_or_else(|| no_length(text))?,
        };
        Some(number * units).filter(|value| value.is_finite()).ok_or_else(|| no_length(text))
    }

    /// The size of letters, which has words for sizes besides lengths; percentages are parts of the size around.
    pub fn letters(&self, text: &str) -> Option<f64> {
        let text = text.trim();
        let of_medium = [
            ("xx-small", 0.6),
            ("x-small", 0.75),
            ("small", 8.0 / 9.0),
            ("medium", 1.0),
            ("large", 1.2),
            ("x-large", 1.5),
            ("xx-large", 2.0),
        ];
        match text {
            "larger" => return Some(self.letter * 1.2),
            "smaller" => return Some(self.letter / 1.2),
            _ => {}
        }
        let named = of_medium.iter().find(|(name, _)| *name == text);
        if let Some((_, factor)) = named {
            return Some(factor * LETTER);
        }
        let around = Self { room: Some(Vec2::new(self.letter, self.letter)), ..*self };
        around.units(text, Along::Width).ok().filter(|size| *size >= 0.0)
    }
}

fn no_length(text: &str) -> String {
    let shown: String = text.trim().chars().take(30).collect();
    format!("`{shown}` is no length that Kerf reads")
}

/// A number and its unit in small letters.
pub fn split(text: &str) -> Result<(f64, String), String> {
    let small = text.trim().to_ascii_lowercase();
    let (number, unit) = small.split_at(number_end(small.as_bytes()));
    let number = number.parse().map_err(|_| no_length(text))?;
    Ok((number, unit.to_owned()))
}

/// Returns the end of the number with which a text begins. The first letter of `em` and `ex` is no exponent.
fn number_end(text: &[u8]) -> usize {
    let sign = |at: usize| usize::from(matches!(text.get(at), Some(b'+' | b'-')));
    let digits = |at: usize| text[at..].iter().take_while(|byte| byte.is_ascii_digit()).count();
    let mut end = sign(0);
    end += digits(end);
    if text.get(end) == Some(&b'.') {
        end += 1 + digits(end + 1);
    }
    let exponent = end + 1 + sign(end + 1);
    if text.get(end) == Some(&b'e') && text.get(exponent).is_some_and(u8::is_ascii_digit) {
        end = exponent + digits(exponent);
    }
    end
}

/// Units of the file in a unit that refers to nothing else.
fn absolute(unit: &str) -> Option<f64> {
    Some(match unit {
        "" | "px" => 1.0,
        "in" => 96.0,
        "cm" => 96.0 / 2.54,
        "mm" => 96.0 / 25.4,
        "q" => 96.0 / 101.6,
        "pt" => 96.0 / 72.0,
        "pc" => 16.0,
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(text: &str, along: Along, expected: f64) {
        let (room, page) = (Some(Vec2::new(300.0, 400.0)), Some(Vec2::new(1000.0, 500.0)));
        let measure = Measure { room, page, letter: 10.0, page_letter: 20.0 };
        let found = measure.units(text, along);
        assert!(found.as_ref().is_ok_and(|it| (it - expected).abs() < 1e-9), "{text}: {found:?}");
    }

    #[test]
    fn every_unit_is_a_length() {
        check(" 2 ", Along::Both, 2.0);
        check("2in", Along::Both, 192.0);
        check("25.4MM", Along::Both, 96.0);
        check("101.6Q", Along::Both, 96.0);
        check("1e1pt", Along::Both, 960.0 / 72.0);
        check("10%", Along::Width, 30.0);
        check("10%", Along::Height, 40.0);
        check("10%", Along::Both, 50.0 / 2.0_f64.sqrt());
        check("-1.5em", Along::Both, -15.0);
        check("2ex", Along::Both, 10.0);
        check("2rem", Along::Both, 40.0);
        check("1vw", Along::Height, 10.0);
        check("1vh", Along::Width, 5.0);
        check("1vmin", Along::Width, 5.0);
        check("1vmax", Along::Width, 10.0);
    }

    #[test]
    fn what_is_no_length_says_so() {
        let told = |text| Measure::default().units(text, Along::Width).err().unwrap_or_default();
        for text in ["", "wide", "3 furlongs", "calc(1px + 2px)", "1e999", "nan"] {
            assert!(told(text).ends_with("is no length that Kerf reads"), "{text}");
        }
        assert_eq!(told("50%"), "`50%` of a page whose size is not told");
        assert_eq!(told("5vh"), "`5vh` of a page whose size is not told");
    }

    #[test]
    fn letters_have_words_for_their_sizes() {
        let measure = Measure { letter: 10.0, ..Measure::default() };
        let sizes = ["12px", "150%", "2em", "large", "larger", "-3px", "wide"];
        let found = sizes.map(|text| measure.letters(text));
        let expected =
            [Some(12.0), Some(15.0), Some(20.0), Some(1.2 * LETTER), Some(12.0), None, None];
        assert_eq!(found, expected);
    }
}
