//! Numbers and comments as G-code has them.

/// A number without needless digits, never with an exponent.
pub(super) fn number(value: f64, places: usize) -> String {
    let text = format!("{value:.places$}");
    let text =
        if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    if text == "-0" { "0".into() } else { text.into() }
}

/// A comment; parentheses within would end it.
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
