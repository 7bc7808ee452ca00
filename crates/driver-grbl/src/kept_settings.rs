//! Settings (`$$`) that are changed while the controller is attached: by Kerf, or by somebody at its own controls.
//!
//! The controller tells nobody that a setting has changed. It is asked for all of them behind each that Kerf writes, and now
//! and then while it stands; what follows from them, its planner too, is known anew then.

use crate::explained::explained;
use crate::facts::KnownFacts;
use crate::settings::setting;
use kerf_machine::driver::ToldSetting;
use std::collections::BTreeMap;

/// Asks for groups and settings in its own words.
const LISTS: [&str; 2] = ["$EG", "$ES"];

/// Asks for the description of one.
const DESCRIBE: &str = "$SED=";

/// So many are asked for at once: the line is free again in a tenth of a second.
const DESCRIBED_AT_ONCE: usize = 8;

/// Questions that leave the machine as it is, in capitals (grbl commands, "View …"; grblHAL has more). A number behind the `$`
/// asks for one setting.
const QUESTIONS: [&str; 14] =
    ["$", "$$", "$+", "$#", "$G", "$I", "$I+", "$N", "$EA", "$EE", "$EG", "$ES", "$PINS", "$HELP"];

/// Asks for all of them.
pub const ASK: &str = "$$";

/// The error of a controller that moves, and tells nothing of itself meanwhile.
pub const BUSY: u16 = 8;

/// While it stands it is asked so often, seconds: the answer keeps a serial line for some hundredths of a second.
const OFTEN_S: f64 = 10.0;

/// The setting that says what reports tell. Kerf cannot follow a controller that does not tell its place.
const REPORTS: u16 = 10;

/// Characters that a controller obeys at once, wherever they stand.
const REAL_TIME: [char; 3] = ['?', '!', '~'];

/// Returns the line that changes one.
pub fn line(number: u16, value: &str) -> String {
    format!("${number}={value}")
}

/// Returns a setting as a controller told it last, in its own words where it has told such.
pub fn told(number: u16, value: String, facts: &KnownFacts) -> ToldSetting {
    let (name, unit, bounds) = match (facts.own.of(number), setting(number)) {
        (Some(own), _) => (own.name.clone(), own.unit.clone(), own.bounds),
        (None, Some(known)) => {
            let (least, most) = known.bounds;
            let bounds = (Some(least), Some(most).filter(|most| most.is_finite()));
            (known.name.to_owned(), known.unit.to_owned(), bounds)
        }
        (None, None) => Default::default(),
    };
    let does = explained(number, facts.is_hal());
    let own = facts.own.description(number).to_owned();
    ToldSetting { number, value, name, unit, bounds, does, own }
}

/// Returns `true` for a line that asks and changes nothing.
fn is_question(line: &str) -> bool {
    let number = line.strip_prefix('$').filter(|rest| !rest.is_empty());
    let of_setting = number.is_some_and(|rest| rest.bytes().all(|byte| byte.is_ascii_digit()));
    of_setting || QUESTIONS.contains(&&*line.to_ascii_uppercase())
}

/// State of settings that were asked for or written.
#[derive(Clone, Debug, Default)]
pub struct KeptSettings {
    /// Time when it was asked for them last; nothing before it has stood since it was attached.
    asked_s: Option<f64>,
    /// It was asked to list them in its own words, and to describe those below this number.
    described_below: Option<u16>,
    /// The refusal of one that was written, in words.
    refused: Option<String>,
}

impl KeptSettings {
    /// Returns `true` if it is to be asked for them now, where it stands.
    pub fn is_due(&mut self, now_s: f64) -> bool {
        let is_due = now_s - *self.asked_s.get_or_insert(now_s) > OFTEN_S;
        if is_due {
            self.asked_s = Some(now_s);
        }
        is_due
    }

    /// Returns `true` once it was asked to list its settings in its own words.
    pub const fn has_asked_words(&self) -> bool {
        self.described_below.is_some()
    }

    /// Returns the next lines that ask for its own words: lists first, then descriptions, some at a time; none where it has no
    /// more of them.
    pub fn asks_words(&mut self, facts: &KnownFacts) -> Vec<String> {
        if !facts.own.has {
            return Vec::new();
        }
        let Some(below) = self.described_below else {
            self.described_below = Some(0);
            return LISTS.map(str::to_owned).into();
        };
        if !facts.own.describes {
            return Vec::new();
        }
        let left = facts.texts().range(below..).take(DESCRIBED_AT_ONCE).map(|(number, _)| *number);
        let next: Vec<u16> = left.collect();
        self.described_below = next.last().map(|last| last.saturating_add(1)).or(Some(below));
        next.into_iter().map(|number| format!("{DESCRIBE}{number}")).collect()
    }

    /// One of the settings that the controller has is about to be written.
    ///
    /// # Errors
    /// It has no such setting, or the value is none of it.
    pub fn takes(
        &mut self,
        has: &BTreeMap<u16, String>,
        number: u16,
        value: &str,
    ) -> Result<(), String> {
        self.refused = None;
        if !has.contains_key(&number) {
            return Err(format!("it has no setting ${number}"));
        }
        if number == REPORTS {
            return Err("$10 is kept as Kerf needs it to follow the controller".into());
        }
        if value.contains(|c: char| c.is_control() || REAL_TIME.contains(&c)) {
            return Err("a value holds no control character, and no ?, ! or ~: the controller obeys them wherever they come".into());
        }
        setting(number).and_then(|known| known.refuses(value)).map_or(Ok(()), Err)
    }

    /// A question is about to be asked that somebody has typed.
    ///
    /// # Errors
    /// The machine would move by it, or be set otherwise.
    pub fn takes_question(&mut self, question: &str) -> Result<(), String> {
        self.refused = None;
        if is_question(question) {
            return Ok(());
        }
        let known = QUESTIONS.join("  ");
        Err(format!(
            "{question} is no question that leaves the machine as it is: {known}  or a setting, $120 or $120=500"
        ))
    }

    /// Returns `true` if a refused line is no order: a setting that the controller does not take, a question for its own words,
    /// or one that came while somebody moved it. None of them ends anything.
    pub fn is_refused(&mut self, asked: Option<&str>, number: u16, why: &str) -> bool {
        let Some(text) = asked else { return false };
        if LISTS.contains(&text) || text.starts_with(DESCRIBE) {
            return true;
        }
        if text == ASK && number == BUSY {
            return true;
        }
        let is_own = is_question(text) || text.starts_with('$') && text.contains('=');
        if is_own {
            self.refused = Some(format!("{text}: error {number}: {why}"));
        }
        is_own
    }

    /// Returns the refusal of one that was written, once.
    pub const fn takes_refusal(&mut self) -> Option<String> {
        self.refused.take()
    }
}
