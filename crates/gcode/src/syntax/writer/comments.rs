//! Comments as G-code has them.

/// Controllers read lines of a limited length (LinuxCNC 255 characters); a longer comment takes
/// several lines.
const LONGEST_COMMENT: usize = 120;

/// Words that make a comment say something to a controller.
const ASKING: [&str; 8] =
    ["msg", "print", "debug", "log", "logopen", "logclose", "probeopen", "probeclose"];

/// A comment as it stands in a block; parentheses within would end it.
pub(super) fn comment(text: &str) -> String {
    let inner: String = text
        .chars()
        .map(|c| match c {
            '(' => '[',
            ')' => ']',
            c if c.is_control() => ' ',
            c => c,
        })
        .collect();
    format!("({})", inner.trim())
}

/// The comments of a text that only people read: long ones in parts, and none that a controller
/// would take as a request.
pub(super) fn comments(text: &str) -> Vec<String> {
    let mut parts = Vec::new();
    for line in text.lines() {
        let mut part = String::from(if asks(line) { "- " } else { "" });
        for word in line.split(' ') {
            if part.chars().count() + word.chars().count() > LONGEST_COMMENT && !part.is_empty() {
                parts.push(comment(&std::mem::take(&mut part)));
            }
            if !part.is_empty() && !part.ends_with(' ') || word.is_empty() {
                part.push(' ');
            }
            part.extend(word.chars().take(LONGEST_COMMENT));
        }
        parts.push(comment(&part));
    }
    parts
}

/// Returns `true` if a controller would take a comment as a request.
fn asks(text: &str) -> bool {
    let head: String = text.chars().filter(|c| !c.is_whitespace()).take(12).collect();
    let head = head.to_ascii_lowercase();
    ASKING
        .iter()
        .any(|word| head.strip_prefix(word).is_some_and(|r| r.is_empty() || r.starts_with(',')))
}
