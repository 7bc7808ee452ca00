//! Recognises what only stops, in whatever form it comes.

use crate::app::App;
use crate::machine::StopCount;
use kerf_wire::Act;
use std::str::FromStr;
use std::sync::Arc;
use std::time::Duration;

/// Longer messages are none of these, bytes.
const LONGEST: usize = 4096;

/// Time that somebody who pressed STOP waits to be told that the machine has heard it.
const PATIENCE: Duration = Duration::from_secs(1);

/// A request that only stops.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StopPress {
    /// Ramps down, lifts, asks.
    Stop,
    /// Ramps down and stands.
    Hold,
    /// Forbids motion.
    Disarm,
    /// Lets go of a key.
    JogStop {
        /// The jog; whichever is made where none is named.
        seq: Option<u64>,
        /// The page that holds the key, where another way than its own is taken.
        client: Option<u32>,
    },
}

/// A request that only stops, and its number where it has one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pressed {
    /// The request itself.
    pub halt: StopPress,
    /// Number of the request; 0 where it has none that a page could have counted.
    pub id: u32,
}

impl StopPress {
    /// Returns the halt that a word names.
    pub fn named(word: &str) -> Option<Self> {
        let is = |name: &str| word.eq_ignore_ascii_case(name);
        Some(match () {
            () if is("stop") => Self::Stop,
            () if is("hold") => Self::Hold,
            () if is("disarm") => Self::Disarm,
            () if is("jogStop") => Self::JogStop { seq: None, client: None },
            () => return None,
        })
    }

    /// Returns the halt that an act is; nothing for any other act.
    pub const fn of(act: &Act) -> Option<Self> {
        Some(match act {
            Act::Stop => Self::Stop,
            Act::Hold => Self::Hold,
            Act::Disarm => Self::Disarm,
            Act::JogStop { seq } => Self::JogStop { seq: Some(*seq), client: None },
            _ => return None,
        })
    }

    /// Reads a message: a word, or an object that says what is to be done, whatever else is in it or missing.
    pub fn read(message: &[u8]) -> Option<Pressed> {
        let text = std::str::from_utf8(message.get(..message.len().min(LONGEST))?).ok()?;
        let word = text.trim_matches(|c: char| c.is_whitespace() || c == '"' || c == '\0');
        if let Some(halt) = Self::named(word) {
            return Some(Pressed { halt, id: 0 });
        }
        if message.len() > LONGEST {
            return None;
        }
        let word = value(text, "do")?.strip_prefix('"')?;
        let halt = Self::named(&word[..word.find('"')?])?.with(text);
        Some(Pressed { halt, id: number(text, "id").unwrap_or(0) })
    }

    /// The jog that a message names, where it is about one.
    pub fn with(self, text: &str) -> Self {
        match self {
            Self::JogStop { .. } => {
                Self::JogStop { seq: number(text, "seq"), client: number(text, "client") }
            }
            other => other,
        }
    }

    /// Does what waits for nobody: from here on nothing begins, and what runs is told to end.
    pub fn press(self, app: &App, client: u32) -> StopCount {
        match self {
            Self::Stop => return app.link.stop(),
            Self::Disarm => return app.link.disarm(),
            Self::Hold => app.link.hold(),
            Self::JogStop { seq, client: other } => app.hands.release(other.unwrap_or(client), seq),
        }
        app.link.stops()
    }

    /// Does the rest of it, which may wait for others.
    pub fn settle(self, app: &App) {
        if self == Self::Disarm {
            app.driving.tell_disarmed("disarmed at a page");
        }
    }
}

/// Waits until the machine's thread has heard a stop, for a second at most.
pub async fn heard(app: &Arc<App>, stop: StopCount) {
    // Who waits longer is told that it has come, which is true as well.
    drop(tokio::time::timeout(PATIENCE, app.link.arrived().heard(stop)).await);
}

/// The text behind the key of an object, whichever of its objects: what stands in a string has its quotes escaped and
/// is no key.
fn value<'a>(text: &'a str, key: &str) -> Option<&'a str> {
    let quoted = format!("\"{key}\"");
    let behind = |at: usize| {
        let rest = text[at + quoted.len()..].trim_start();
        rest.strip_prefix(':').map(str::trim_start)
    };
    text.match_indices(&quoted).find_map(|(at, _)| behind(at))
}

/// The whole number behind a key.
fn number<T: FromStr>(text: &str, key: &str) -> Option<T> {
    let value = value(text, key)?;
    value[..value.find(|c: char| !c.is_ascii_digit()).unwrap_or(value.len())].parse().ok()
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(message: &str, expected: Option<(StopPress, u32)>) {
        let read = StopPress::read(message.as_bytes()).map(|Pressed { halt, id }| (halt, id));
        assert_eq!(read, expected, "{message}");
    }

    #[test]
    fn stop_is_recognised_in_whatever_form_it_comes() {
        let stop = |id| Some((StopPress::Stop, id));
        check(r#"{"id":7,"act":{"do":"stop"}}"#, stop(7));
        check(r#"{"act":{"do":"stop"}}"#, stop(0));
        check(r#"{"id":-1,"act":{"do":"stop"}}"#, stop(0));
        check(r#"{"id":4294967296,"act":{"do":"stop"}}"#, stop(0));
        check(r#"{"id":"x","act":{"do":"stop","x":1}}"#, stop(0));
        check(r#"{ "do" : "stop" , "x" : [1"#, stop(0));
        check(r#"{"id":3,"act":{"do":"STOP"#, None);
        check(r#"{"id":3,"act":{"do":"STOP""#, stop(3));
        check("STOP", stop(0));
        check(" \"stop\"\r\n", stop(0));
        check(r#"{"id":1,"act":{"do":"hold"}}"#, Some((StopPress::Hold, 1)));
        check(r#"{"id":1,"act":{"do":"disarm"}}"#, Some((StopPress::Disarm, 1)));
        let jog = |seq, client| Some((StopPress::JogStop { seq, client }, 2));
        check(r#"{"id":2,"act":{"do":"jogStop","seq":9}}"#, jog(Some(9), None));
        check(r#"{"id":2,"act":{"do":"jogStop"},"client":4}"#, jog(None, Some(4)));
    }

    #[test]
    fn words_of_other_messages_stop_nothing() {
        check(r#"{"id":1,"act":{"do":"ping"}}"#, None);
        check(r#"{"id":1,"act":{"do":"command","line":"{\"do\":\"stop\"}"}}"#, None);
        check(r#"{"id":1,"act":{"do":"command","line":"stop"}}"#, None);
        check(r#"{"id":1,"act":{"do":"answer","answer":"stop","question":1}}"#, None);
        check("", None);
        check("null", None);
        assert_eq!(StopPress::read(&[0xff, 0xfe]), None);
    }

    #[test]
    fn a_long_message_is_not_looked_through() {
        let long = format!(r#"{{"x":"{}","do":"stop"}}"#, "y".repeat(LONGEST));
        check(&long, None);
    }

    #[test]
    fn every_act_that_only_stops_is_known_by_its_word() {
        let acts = [Act::Stop, Act::Hold, Act::Disarm, Act::JogStop { seq: 3 }];
        for act in acts {
            let text = serde_json::to_string(&act).unwrap();
            assert_eq!(
                StopPress::read(text.as_bytes()).map(|it| it.halt),
                StopPress::of(&act),
                "{text}"
            );
        }
        assert_eq!(StopPress::of(&Act::Ping), None);
    }
}
