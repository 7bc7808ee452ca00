//! The word at a place of a text.

/// A word and where it stands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Word<'a> {
    /// Its text, with `&`, `$` or `%` before it.
    pub text: &'a str,
    /// Its first column, counted from 1 in characters.
    pub from: u32,
    /// The column behind it.
    pub to: u32,
    /// Text before it in the line.
    pub before: &'a str,
}

/// A line of a text, counted from 1.
pub fn line(text: &str, number: u32) -> &str {
    text.lines().nth((number as usize).saturating_sub(1)).unwrap_or("")
}

/// The word that a column of a line touches. May be empty.
pub fn at(line: &str, column: u32) -> Word<'_> {
    let cut = offset(line, column.saturating_sub(1));
    let (before, behind) = line.split_at(cut);
    let start = before.trim_end_matches(part_of_word).len();
    let length = behind.len() - behind.trim_start_matches(part_of_word).len();
    let text = &line[start..cut + length];
    let from = line[..start].chars().count() as u32 + 1;
    Word { text, from, to: from + text.chars().count() as u32, before: &line[..start] }
}

fn part_of_word(c: char) -> bool {
    c.is_alphanumeric() || matches!(c, '_' | '&' | '$' | '%' | '.')
}

/// The byte at which a character of a line begins; its end when it is shorter.
fn offset(line: &str, characters: u32) -> usize {
    line.char_indices().nth(characters as usize).map_or(line.len(), |(at, _)| at)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_word_is_found_from_any_of_its_letters() {
        for column in 4..=8 {
            let word = at("MX,&size+1", column);
            assert_eq!((word.text, word.from, word.to, word.before), ("&size", 4, 9, "MX,"));
        }
        assert_eq!(at("MX, ", 5).text, "");
        assert_eq!(at("½ MX", 3).text, "MX");
        assert_eq!(at("", 9).text, "");
    }
}
