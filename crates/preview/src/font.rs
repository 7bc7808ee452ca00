//! The letters of pictures: measured for the layout, outlined for PNG.
//!
//! The font is in the program, so that a PNG is the same on every machine. An SVG names the same
//! family and falls back to what the viewer has; the layout leaves room for wider letters.

use ttf_parser::{Face, GlyphId, OutlineBuilder};

/// Families that an SVG asks for, first choice first.
pub const FAMILY: &str = "Roboto, 'Helvetica Neue', Arial, 'Liberation Sans', sans-serif";

static REGULAR: &[u8] = include_bytes!("../assets/font/Roboto-Regular.ttf");
static BOLD: &[u8] = include_bytes!("../assets/font/Roboto-Bold.ttf");

/// The file of the built-in font, regular or bold.
pub const fn file(bold: bool) -> &'static [u8] {
    if bold { BOLD } else { REGULAR }
}

/// One weight of the font.
pub struct Font(Option<Face<'static>>);

impl Font {
    /// The regular or the bold weight.
    pub fn new(bold: bool) -> Self {
        Self(Face::parse(file(bold), 0).ok())
    }

    /// Width of a line of text in a size of 1.
    pub fn width(&self, text: &str) -> f64 {
        text.chars().map(|c| self.advance(c)).sum()
    }

    /// Step to the next letter in a size of 1.
    pub fn advance(&self, c: char) -> f64 {
        let Some(face) = &self.0 else { return 0.5 };
        let units = f64::from(face.units_per_em());
        face.glyph_hor_advance(glyph(face, c)).map_or(0.5, |a| f64::from(a) / units)
    }

    /// Draws a letter; the builder gets font units, see [`Font::scale`].
    pub fn outline(&self, c: char, into: &mut impl OutlineBuilder) {
        if let Some(face) = &self.0 {
            face.outline_glyph(glyph(face, c), into);
        }
    }

    /// Size 1 in font units.
    pub fn scale(&self) -> f64 {
        self.0.as_ref().map_or(1.0, |f| 1.0 / f64::from(f.units_per_em()))
    }

    /// The text in lines no wider than `width` in a size of 1, broken between words; at most
    /// `most` of them, the last one shortened.
    pub fn wrapped(&self, text: &str, width: f64, most: usize) -> Vec<String> {
        let mut lines = Vec::new();
        let mut line = String::new();
        for word in text.split_whitespace() {
            let longer = if line.is_empty() { word.to_owned() } else { format!("{line} {word}") };
            let full = self.width(&longer) > width && !line.is_empty() && lines.len() + 1 < most;
            line = if full {
                lines.push(line);
                word.to_owned()
            } else {
                longer
            };
        }
        lines.push(self.fitted(&line, width));
        lines
    }

    /// The text, shortened with an ellipsis where it is wider than `width` in a size of 1.
    pub fn fitted(&self, text: &str, width: f64) -> String {
        if self.width(text) <= width {
            return text.to_owned();
        }
        let room = width - self.advance('…');
        let mut used = 0.0;
        let kept = text.chars().take_while(|c| {
            used += self.advance(*c);
            used <= room
        });
        let mut short: String = kept.collect();
        short.truncate(short.trim_end().len());
        short.push('…');
        short
    }
}

/// The letter's glyph, or the box that stands for a letter the font does not have.
fn glyph(face: &Face<'_>, c: char) -> GlyphId {
    face.glyph_index(c).unwrap_or(GlyphId(0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_are_equally_wide_and_letters_known() {
        for font in [Font::new(false), Font::new(true)] {
            let zero = font.advance('0');
            assert!(('0'..='9').all(|c| font.advance(c) == zero) && zero > 0.4);
            let face = font.0.as_ref().expect("the font is in the crate");
            for c in "AZaz09äßéÅłЖяΩ×−°…›≤ \u{2009}".chars() {
                assert!(face.glyph_index(c).is_some(), "{c}");
            }
        }
    }

    #[test]
    fn text_is_wrapped_between_words() {
        let font = Font::new(false);
        let lines = font.wrapped("a plunge at jog speed into the material of the part", 10.0, 2);
        assert_eq!(lines.len(), 2);
        assert!(
            lines[1].ends_with('…') && lines.iter().all(|l| font.width(l) <= 10.0),
            "{lines:?}"
        );
        assert_eq!(font.wrapped("", 10.0, 2), [""]);
    }

    #[test]
    fn long_text_is_shortened_to_its_room() {
        let font = Font::new(false);
        let short = font.fitted("Outer contour with four passes", 8.0);
        assert!(short.ends_with('…') && font.width(&short) <= 8.0, "{short}");
        assert_eq!(font.fitted("Slot", 8.0), "Slot");
        assert_eq!(font.fitted("Slot", 0.1), "…");
    }
}
