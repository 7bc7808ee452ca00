//! The screen.

/// Characters of a line.
pub const COLUMNS: usize = 20;

/// Byte before the lines on a serial link: it empties the display.
const FORM_FEED: u8 = 0x0c;

/// Two lines of twenty characters at most.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Screen {
    /// The lines, without blanks at their ends.
    pub lines: [String; 2],
}

impl Screen {
    /// A screen; what is too long for a line is cut off.
    pub fn new(top: impl AsRef<str>, bottom: impl AsRef<str>) -> Self {
        Self { lines: [line(top.as_ref()), line(bottom.as_ref())] }
    }

    /// A text over both lines, broken between words where that leaves more of it.
    pub fn of_text(text: &str) -> Self {
        let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
        let characters: Vec<char> = text.chars().collect();
        if characters.len() <= COLUMNS {
            return Self::new(text, "");
        }
        let end = (1..=COLUMNS).rev().find(|at| characters[*at] == ' ').unwrap_or(COLUMNS);
        let (top, bottom) = characters.split_at(end);
        Self::new(top.iter().collect::<String>(), bottom.iter().collect::<String>().trim_start())
    }

    /// Returns the bytes that draw it over a serial link: form feed, then both lines padded with blanks. Characters
    /// that are no ASCII become `?`.
    pub fn bytes(&self) -> Vec<u8> {
        let mut bytes = vec![FORM_FEED];
        for line in &self.lines {
            let padded = format!("{line:COLUMNS$}");
            bytes.extend(
                padded.chars().take(COLUMNS).map(|c| if is_shown(c) { c as u8 } else { b'?' }),
            );
        }
        bytes
    }
}

fn is_shown(character: char) -> bool {
    character.is_ascii_graphic() || character == ' '
}

fn line(text: &str) -> String {
    text.chars().take(COLUMNS).collect::<String>().trim_end().to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_is_broken_between_words() {
        let check = |text: &str, top: &str, bottom: &str| {
            assert_eq!(Screen::of_text(text).lines, [top, bottom], "{text}");
        };
        check("Page drives", "Page drives", "");
        check("the machine is busy now", "the machine is busy", "now");
        check("exactly twenty chars and more", "exactly twenty chars", "and more");
        check("a-word-that-is-longer-than-a-line", "a-word-that-is-longe", "r-than-a-line");
        check("", "", "");
    }

    #[test]
    fn a_drawn_screen_has_41_bytes() {
        let bytes = Screen::new("Größe", "x").bytes();
        assert_eq!(bytes.len(), 41);
        assert_eq!(&bytes[..8], b"\x0cGr??e  ");
        assert_eq!(&bytes[20..23], b" x ");
    }
}
