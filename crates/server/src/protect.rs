//! The password of the settings: who may change them.

use crate::clock::Clock;
use crate::configure::{MachineSettings, PASSWORD};
use crate::locks::lock;
use crate::refusal::problem;
use kerf_machine::password;
use kerf_machine::{Value, table};
use kerf_wire::{Problem, Tone, Who, Why};
use std::collections::BTreeMap;
use std::sync::{Mutex, TryLockError};
use std::time::Duration;

/// Time for which a page may change settings after it gave the password.
const OPEN: Duration = Duration::from_secs(15 * 60);

/// Pages and scripts that gave the password, and until when it counts.
#[derive(Debug)]
pub struct Unlocked {
    clock: Clock,
    until: Mutex<BTreeMap<u32, Duration>>,
}

impl Unlocked {
    /// By a clock.
    pub fn by(clock: Clock) -> Self {
        Self { clock, until: Mutex::default() }
    }

    /// Returns `true` if somebody has given it, and it still counts.
    pub fn has(&self, client: u32) -> bool {
        lock(&self.until).get(&client).is_some_and(|until| *until > self.clock.now())
    }

    /// Notes that a client has given the password.
    pub fn add(&self, client: u32) {
        let now = self.clock.now();
        let mut open = lock(&self.until);
        open.retain(|_, until| *until > now);
        open.insert(client, now + OPEN);
    }

    /// Takes the permission of a client that has gone.
    pub fn remove(&self, client: u32) {
        lock(&self.until).remove(&client);
    }

    fn clear(&self) {
        lock(&self.until).clear();
    }
}

impl MachineSettings {
    /// Protects settings with a password, or no longer.
    ///
    /// # Errors
    /// The old password is missing, the new one is too short or not the same twice.
    pub fn protect(
        &self,
        who: &Who,
        password: Option<&str>,
        new: Option<[String; 2]>,
    ) -> Result<(), Problem> {
        self.opened(who, password)?;
        let kept = new.map(|[new, again]| kept(&new, &again)).transpose()?;
        let Some(setting) = table::setting(PASSWORD) else { return Ok(()) };
        let mut wanted = lock(&self.left).session.configuration();
        let value = kept.map_or_else(Value::none, Value::Text);
        setting
            .set(&mut wanted, &value)
            .map_err(|error| problem(Why::Mistake, error.to_string()))?;
        self.unlocked.clear();
        self.keep_on_disk(setting, wanted, None)
    }

    /// Takes the password: whoever gave it may change settings for a while.
    ///
    /// # Errors
    /// It is wrong.
    pub fn unlock(&self, who: &Who, password: &str) -> Result<(), Problem> {
        self.opened(who, Some(password))?;
        self.unlocked.add(who.client);
        Ok(())
    }

    /// Checks that somebody may change settings.
    ///
    /// # Errors
    /// The settings are protected, and the password is missing or wrong.
    pub fn opened(&self, who: &Who, password: Option<&str>) -> Result<(), Problem> {
        let kept = lock(&self.left).session.machine_is.options.password.clone();
        let Some(kept) = kept else { return Ok(()) };
        match password {
            Some(given) => self.try_password(who, &kept, given),
            None if self.unlocked.has(who.client) => Ok(()),
            None => {
                Err(problem(Why::Password, "the settings are protected: give the password first"))
            }
        }
    }
}

impl MachineSettings {
    /// Tries a password, while nobody else does: a guess costs the computer a moment of work.
    fn try_password(&self, who: &Who, kept: &str, given: &str) -> Result<(), Problem> {
        let mut wrong = match self.passwords.try_lock() {
            Ok(wrong) => wrong,
            Err(TryLockError::Poisoned(left)) => left.into_inner(),
            Err(TryLockError::WouldBlock) => {
                let text =
                    "another password is being tried, one at a time: wait 1 s, then try again";
                return Err(problem(Why::Password, text));
            }
        };
        let (device, now) = (&who.device, self.clock.now());
        if let Some(seconds) = wrong.wait_s(device, now) {
            let text =
                format!("wrong passwords were tried from here: wait {seconds} s, then try again");
            return Err(problem(Why::Password, text));
        }
        if password::fits(kept, given) {
            wrong.right(device);
            return Ok(());
        }
        let count = wrong.wrong(device, self.clock.now());
        drop(wrong);
        let from = if device.is_empty() { "at the machine" } else { device };
        let text =
            format!("a wrong password of the settings was tried: {from}, {count} wrong so far");
        self.hub.say(Tone::Warning, text);
        Err(problem(Why::Password, "this is not the password of the settings"))
    }
}

/// Returns what is kept of a new password.
fn kept(new: &str, again: &str) -> Result<String, Problem> {
    if new != again {
        return Err(problem(Why::Mistake, "the two passwords are not the same"));
    }
    if new.chars().count() < password::SHORTEST {
        let text = format!("a password has {} characters at least", password::SHORTEST);
        return Err(problem(Why::Mistake, text));
    }
    let mut salt = [0; 16];
    getrandom::fill(&mut salt)
        .map_err(|_| problem(Why::Server, "this computer gives no random numbers"))?;
    Ok(password::hashed(new, salt))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn settings_are_open_for_a_while_and_not_for_a_night_of_sleep() {
        let clock = Clock::default();
        let unlocked = Unlocked::by(clock.clone());
        unlocked.add(7);
        clock.forward(OPEN * 9 / 10);
        assert!(unlocked.has(7) && !unlocked.has(8));
        clock.forward(OPEN / 5);
        assert!(!unlocked.has(7));
    }
}
