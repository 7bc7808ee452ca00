//! Words for the lines between Kerf and the bridge.

use crate::check;
use crate::status::{Status, words};
use kerf_machine::driver::{LineKind, Said};

/// Tells what a line is that was sent: its number and its check number stand around the command.
pub fn sent(line: &str) -> Said {
    let command = line.split(' ').nth(1).unwrap_or_default();
    match command.split('*').next() {
        Some("keep") => Said::with(LineKind::Ask, "Kerf is there"),
        _ => Said::plain(LineKind::Line),
    }
}

/// Tells what a line is that came.
pub fn came(line: &str) -> Said {
    let Some(text) = check::text(line.as_bytes()) else {
        return Said::with(LineKind::Error, "a line was garbled on its way: look at the cable");
    };
    match text.split(' ').next() {
        Some("s") => match Status::read(text).map(|status| status.why) {
            Some(why) if !why.is_empty() => Said::with(LineKind::Error, why),
            _ => Said::plain(LineKind::Report),
        },
        Some("z") => Said::with(LineKind::Report, "zero points"),
        Some("facts") if words(text).contains_key("unfit") => Said::plain(LineKind::Error),
        Some("facts") => Said::plain(LineKind::Welcome),
        _ => Said::plain(LineKind::Message),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_of_the_bridge_have_kinds() {
        let check = |text: &str, kind: LineKind| {
            assert_eq!(came(check::line(text).trim_end()).kind, kind, "{text}");
        };
        check("z hi=1 next=2 holds=G54", LineKind::Report);
        check("facts version=2 unfit=absent", LineKind::Error);
        check("facts version=2 axes=3", LineKind::Welcome);
        assert_eq!(came("s hi=1*00000000").kind, LineKind::Error);
        assert_eq!(sent("7 keep*1234abcd").kind, LineKind::Ask);
        assert_eq!(sent("8 g 7 G53 G1 X1*1234abcd").kind, LineKind::Line);
    }
}
