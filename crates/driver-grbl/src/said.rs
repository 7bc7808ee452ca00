//! Words for the bytes and lines between Kerf and the controller: bytes that are obeyed at once, and kinds of answers.

use crate::facts::KnownFacts;
use kerf_machine::driver::{LineKind, Said};

/// The question for a report.
const ASK: u8 = b'?';

/// The same for a report with everything in it, of grblHAL.
const ASK_ALL: u8 = 0x87;

/// Bytes that are obeyed at once, by their meaning (grbl interface, "Real-Time Control Commands"; grblHAL has more).
const NAMES: [(u8, &str); 32] = [
    (ASK, "status report asked"),
    (b'!', "feed hold"),
    (b'~', "resume"),
    (0x18, "reset"),
    (0x19, "stop"),
    (0x80, "status report asked"),
    (0x81, "resume"),
    (0x82, "feed hold"),
    (0x83, "parser state asked"),
    (0x84, "door opened"),
    (0x85, "jog cancelled"),
    (ASK_ALL, "full status report asked"),
    (0x88, "optional stop switched"),
    (0x89, "single block switched"),
    (0x90, "feed at 100 %"),
    (0x91, "feed 10 % faster"),
    (0x92, "feed 10 % slower"),
    (0x93, "feed 1 % faster"),
    (0x94, "feed 1 % slower"),
    (0x95, "rapid moves at 100 %"),
    (0x96, "rapid moves at 50 %"),
    (0x97, "rapid moves at 25 %"),
    (0x99, "spindle at 100 %"),
    (0x9a, "spindle 10 % faster"),
    (0x9b, "spindle 10 % slower"),
    (0x9c, "spindle 1 % faster"),
    (0x9d, "spindle 1 % slower"),
    (0x9e, "spindle stopped in a hold, or on again"),
    (0xa0, "flood coolant switched"),
    (0xa1, "mist coolant switched"),
    (0xa3, "tool change acknowledged"),
    (0xa4, "probe connected, or not any more"),
];

/// Returns the meaning of a byte that is obeyed at once; nothing for one of a line.
pub fn at_once(byte: u8) -> Option<Said> {
    if matches!(byte, b'\n' | b' '..=b'~') && !matches!(byte, ASK | b'!' | b'~') {
        return None;
    }
    let named = NAMES.into_iter().find(|(known, _)| *known == byte);
    let asks = matches!(byte, ASK | ASK_ALL | 0x80);
    let kind = if asks { LineKind::Ask } else { LineKind::AtOnce };
    match named {
        Some((_, name)) => Some(Said::with(kind, name)),
        None if byte >= 0x80 => Some(Said::with(kind, "a byte that is obeyed at once")),
        None => None,
    }
}

/// Tells what a line is that came: errors and alarms have words of the board itself, where it has told such.
pub fn came(line: &str, told: &KnownFacts) -> Said {
    let number = |before: &str| line.strip_prefix(before)?.parse().ok();
    if line == "ok" {
        return Said::plain(LineKind::Ok);
    }
    if let Some(number) = number("error:") {
        return Said::with(LineKind::Error, told.error(number));
    }
    if let Some(number) = number("ALARM:") {
        return Said::with(LineKind::Alarm, told.alarm(number));
    }
    Said::plain(match line.get(..1) {
        Some("<") => LineKind::Report,
        _ if line.starts_with("Grbl") => LineKind::Welcome,
        _ => LineKind::Message,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn answers_have_kinds_and_numbers_have_words() {
        let check = |line: &str, kind: LineKind, words: &str| {
            let said = came(line, &KnownFacts::default());
            assert_eq!((said.kind, &*said.words), (kind, words), "{line}");
        };
        check("ok", LineKind::Ok, "");
        check("<Idle|MPos:0.000,0.000,0.000>", LineKind::Report, "");
        check("error:9", LineKind::Error, "it is locked by an alarm");
        check("ALARM:10", LineKind::Alarm, "the emergency stop is pressed");
        check("Grbl 1.1h ['$' for help]", LineKind::Welcome, "");
        check("GrblHAL 1.1f", LineKind::Welcome, "");
        check("[MSG:Caution: Unlocked]", LineKind::Message, "");
        check("$120=500.000", LineKind::Message, "");
        check("error:", LineKind::Message, "");
    }

    #[test]
    fn bytes_that_are_obeyed_at_once_have_names() {
        let named = |byte| at_once(byte).map(|said| (said.kind, said.words.into_owned()));
        let check = |byte: u8, kind, name: &str| {
            assert_eq!(named(byte), Some((kind, name.to_owned())), "{byte:#x}");
        };
        check(b'?', LineKind::Ask, "status report asked");
        check(0x18, LineKind::AtOnce, "reset");
        check(0x96, LineKind::AtOnce, "rapid moves at 50 %");
        check(0xff, LineKind::AtOnce, "a byte that is obeyed at once");
        assert_eq!([b'G', b'\n', b'$'].map(named), [None, None, None]);
    }
}
