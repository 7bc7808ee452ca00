//! Settings (`$$`) that are changed while the controller is attached: by Kerf, or by somebody at its own controls.
//!
//! The controller tells nobody that a setting has changed. It is asked for all of them behind each that Kerf writes, and now
//! and then while it stands; what follows from them, its planner too, is known anew then.

use crate::driver::{Grbl, Line, Phase};
use crate::settings::setting;
use kerf_machine::driver::{Facts, Trouble};

/// Asks for all of them.
pub const ASK: &str = "$$";

/// The error of a controller that moves, and tells nothing of itself meanwhile.
pub const BUSY: u16 = 8;

/// While it stands it is asked so often, seconds: the answer keeps a serial line for some hundredths of a second.
const OFTEN_S: f64 = 10.0;

/// The setting that says what reports tell. Kerf cannot follow a controller that does not tell its place.
const REPORTS: u16 = 10;

/// Returns the line that changes one.
pub fn line(number: u16, value: &str) -> String {
    format!("${number}={value}")
}

/// What is known of settings that were asked for or written.
#[derive(Clone, Debug, Default)]
pub struct KeptSettings {
    /// Time when it was asked for them last; nothing before it has stood since it was attached.
    asked_s: Option<f64>,
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

    /// Returns `true` if a refused line is no order: a setting that it does not take, or a question that came while somebody
    /// moved it. Neither ends anything.
    pub fn is_refused(&mut self, line: Option<&Line>, number: u16, why: &str) -> bool {
        let Some(line) = line.filter(|line| line.ticket.is_none()) else { return false };
        let is_written = line.text.starts_with('$') && line.text.contains('=');
        if is_written {
            self.refused = Some(format!("{}: error {number}: {why}", line.text));
        }
        is_written || line.text == ASK && number == BUSY
    }

    /// Returns the refusal of one that was written, once.
    pub const fn takes_refusal(&mut self) -> Option<String> {
        self.refused.take()
    }
}

/// Has the controller keep another value of a setting, and tell all of them.
///
/// # Errors
/// It is at work, keeps no such setting, or the value is none of it.
pub fn keep(grbl: &mut Grbl, number: u16, value: &str) -> Result<(), String> {
    if grbl.phase != Phase::Ready || !grbl.flights.is_empty() || grbl.trouble.is_some() {
        return Err("it is at work, or takes no orders".into());
    }
    if !grbl.settings().contains_key(&number) {
        return Err(format!("it has no setting ${number}"));
    }
    if number == REPORTS {
        return Err("$10 is kept as Kerf needs it to follow the controller".into());
    }
    if let Some(why) = setting(number).and_then(|known| known.refuses(value)) {
        return Err(why);
    }
    grbl.kept.refused = None;
    grbl.say(line(number, value));
    grbl.say(ASK);
    Ok(())
}

/// A line was answered: where settings are others than before, what is known of the controller follows them.
pub fn follow(grbl: &mut Grbl, answered: &str) {
    let Some(before) = grbl.facts.as_ref().filter(|_| grbl.phase == Phase::Ready) else { return };
    if !grbl.told.takes_news() {
        return;
    }
    let facts = Facts { is_fresh: before.is_fresh, ..grbl.told.facts(before.axes) };
    if let Some(why) = grbl.told.unfit(facts.axes) {
        let _ = grbl.trouble.get_or_insert(Trouble::Unfit { why });
    }
    // Somebody else has it hide its place; what Kerf puts back itself is no answer to this question.
    if let Some(changed) = grbl.told.mend().filter(|_| answered == ASK) {
        grbl.say(line(changed.number, &changed.is.to_string()));
    }
    grbl.facts = Some(facts);
}
