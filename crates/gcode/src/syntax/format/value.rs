//! Values: expressions in capitals, one blank on each side of an operator that is a word.

use super::blank;
use crate::syntax::expr::Operator;
use crate::syntax::tree::Keyword;

/// Returns the number of digits that a text begins with.
pub(super) fn digits(text: &str) -> usize {
    text.bytes().take_while(u8::is_ascii_digit).count()
}

/// A word, a parameter or an expression.
pub(super) fn push(text: &str, out: &mut String) {
    let mut rest = text.trim_start_matches(blank);
    while let Some(first) = rest.chars().next() {
        let length = match first {
            '<' => name_length(rest),
            _ => worded_operator(rest, out).map_or(first.len_utf8(), |word| word.len()),
        };
        let (piece, behind) = rest.split_at(length);
        if length > 1 && first != '<' {
            out.push_str(&format!(" {} ", piece.to_ascii_uppercase()));
        } else if first == '<' {
            out.push_str(piece);
        } else {
            out.push(first.to_ascii_uppercase());
        }
        rest = behind.trim_start_matches(blank);
    }
}

/// A name in `< >`, which stays as it is.
fn name_length(text: &str) -> usize {
    text.find('>').map_or(1, |end| end + 1)
}

/// The operator a text begins with, if it is a word: behind a value nothing else can stand.
fn worded_operator(text: &str, before: &str) -> Option<&'static str> {
    let behind_value =
        before.ends_with(|c: char| c.is_ascii_digit() || matches!(c, '.' | ']' | '>'));
    let words = Operator::WRITTEN.into_iter().map(|(word, _)| word);
    let mut letters = words.filter(|word| word.as_bytes()[0].is_ascii_alphabetic());
    let begins = |word: &&str| text.get(..word.len()).is_some_and(|t| t.eq_ignore_ascii_case(word));
    letters.find(begins).filter(|_| behind_value)
}

/// `O100 call [1] [2]`
pub(super) fn push_flow(text: &str, keyword: Keyword, out: &mut String) -> Option<()> {
    let mut all = String::with_capacity(text.len() + 8);
    push(text, &mut all);
    let label = label_length(&all)?;
    let word = keyword.written();
    let (label, rest) = all.split_at_checked(label)?;
    let rest = rest.trim_start();
    out.push_str(label);
    if word.is_empty() {
        return rest.is_empty().then_some(());
    }
    let values =
        rest.get(word.len()..).filter(|_| rest[..word.len()].eq_ignore_ascii_case(word))?;
    out.push_str(&format!(" {word}"));
    push_values(values, out)
}

/// The length of `O100`, `O<name>`, `O#5` or `O[…]`.
fn label_length(text: &str) -> Option<usize> {
    let rest = text.strip_prefix('O')?;
    match rest.bytes().next()? {
        b'<' => Some(1 + name_length(rest)),
        b'0'..=b'9' => Some(1 + digits(rest)),
        b'[' => Some(1 + bracket_length(rest)?),
        // The name of a parameter: its signs, then a number, a name or a bracket.
        _ => {
            let value = rest.trim_start_matches(['#', '-', '+']);
            let signs = 1 + rest.len() - value.len();
            let length = match value.bytes().next()? {
                b'<' => name_length(value),
                b'[' => bracket_length(value)?,
                _ => value.bytes().take_while(|b| b.is_ascii_digit() || *b == b'.').count(),
            };
            Some(signs + length)
        }
    }
}

/// The length of the bracket a text begins with.
fn bracket_length(text: &str) -> Option<usize> {
    let (mut depth, mut in_name) = (0, false);
    for (at, byte) in text.bytes().enumerate() {
        in_name = byte == b'<' || in_name && byte != b'>';
        match byte {
            b'[' if !in_name => depth += 1,
            b']' if !in_name => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return Some(at + 1);
        }
    }
    None
}

/// Values in brackets, one blank before each.
fn push_values(mut rest: &str, out: &mut String) -> Option<()> {
    while !rest.is_empty() {
        let (value, behind) = rest.split_at_checked(bracket_length(rest)?)?;
        out.push(' ');
        out.push_str(value);
        rest = behind;
    }
    Some(())
}
