//! Events at the hand console, and the way to its thread.

use crate::asker::Asker;
use crate::people::Grip;
use crate::refusal::problem;
use kerf_handconsole::Key;
use kerf_wire::{Problem, Why};
use std::sync::OnceLock;
use std::sync::mpsc::Sender;

/// Event at the console.
#[derive(Debug)]
pub enum Happening {
    /// A key is pressed.
    Key {
        /// By whom.
        asker: Asker,
        /// The jog that it holds, should it move the tool.
        grip: Grip,
        /// Which.
        key: Key,
    },
    /// Outcome of a request that lasts: what was found out, or why it is not done.
    Outcome(Result<String, String>),
}

/// The keys of the hand console, as pages press them.
#[derive(Default)]
pub struct Keys {
    happens: OnceLock<Sender<Happening>>,
}

impl Keys {
    /// Sets the thread that hears them; a server has one.
    pub fn set(&self, happens: Sender<Happening>) -> Result<(), Sender<Happening>> {
        self.happens.set(happens)
    }

    /// Presses a key of the hand console.
    ///
    /// # Errors
    /// There is no such key.
    pub fn press(&self, asker: &Asker, grip: Grip, key: char) -> Result<(), Problem> {
        let Some(key) = Key::of(key) else {
            let text =
                "the keys are 0 to 9, - (sign), carriage return (Enter), F, S, P (Stop), U (Func)";
            return Err(problem(Why::Malformed, text));
        };
        let happening = Happening::Key { asker: asker.clone(), grip, key };
        let sent = self.happens.get().map(|happens| happens.send(happening));
        match sent {
            Some(Ok(())) => Ok(()),
            _ => Err(problem(Why::Server, "there is no hand console; start Kerf anew")),
        }
    }
}
