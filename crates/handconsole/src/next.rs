//! Consequences of a key.

use crate::functions::Function;
use crate::{ConsoleRequest, Screen};

/// The mode that a key leads to.
#[derive(Debug, Default)]
pub(crate) enum To<M> {
    /// What the machine does decides what is shown.
    #[default]
    Rest,
    /// The mode that took the key, as it is now.
    Stay(M),
    /// A job is chosen.
    File,
    /// A function is chosen.
    Selecting,
    /// A function asks for its numbers and places.
    Function(&'static Function),
    /// Points of a shape are recorded.
    Digitizing,
    /// A job is to be aborted, if Enter says so.
    Aborting,
    /// The machine does what the function of this name wants.
    Doing(&'static str),
}

/// Consequences of a key that a mode took: the mode after it, requests, a note, a beep.
#[derive(Debug)]
pub(crate) struct Next<M> {
    pub to: To<M>,
    pub requests: Vec<ConsoleRequest>,
    pub note: Option<Note>,
    pub beeps: bool,
}

/// A screen that is shown until the next key.
#[derive(Clone, Debug)]
pub(crate) struct Note {
    pub screen: Screen,
    /// Enter takes control.
    pub control: bool,
}

impl<M> Default for Next<M> {
    fn default() -> Self {
        Self::to(To::Rest)
    }
}

impl<M> Next<M> {
    /// Another mode.
    pub fn to(to: To<M>) -> Self {
        Self { to, requests: Vec::new(), note: None, beeps: false }
    }

    /// The same mode.
    pub fn stay(mode: M) -> Self {
        Self::to(To::Stay(mode))
    }

    /// The mode in which the machine decides what is shown, and requests.
    pub fn request(requests: impl IntoIterator<Item = ConsoleRequest>) -> Self {
        Self::default().and(requests)
    }

    /// The same with requests.
    pub fn and(self, requests: impl IntoIterator<Item = ConsoleRequest>) -> Self {
        Self { requests: requests.into_iter().collect(), ..self }
    }

    /// The same with a text that is shown until the next key, and a beep.
    pub fn refused(self, text: impl AsRef<str>) -> Self {
        let note = Some(Note { screen: Screen::of_text(text.as_ref()), control: false });
        Self { note, beeps: true, ..self }
    }

    /// The same with a text below the name of what was done, until the next key; nothing for no text.
    pub fn said(self, name: &str, text: &str) -> Self {
        let note = Note { screen: Screen::new(name, text), control: false };
        Self { note: (!text.is_empty()).then_some(note), ..self }
    }

    /// The same with a beep.
    pub fn beep(self) -> Self {
        Self { beeps: true, ..self }
    }

    /// The same, with the mode of an outer one that holds this.
    pub fn within<N>(self, wrap: impl FnOnce(To<M>) -> To<N>) -> Next<N> {
        let Self { to, requests, note, beeps } = self;
        Next { to: wrap(to), requests, note, beeps }
    }

    /// The same, where a mode that stays is one of several.
    pub fn map<N>(self, wrap: impl FnOnce(M) -> N) -> Next<N> {
        self.within(|to| match to {
            To::Rest => To::Rest,
            To::Stay(mode) => To::Stay(wrap(mode)),
            To::File => To::File,
            To::Selecting => To::Selecting,
            To::Function(function) => To::Function(function),
            To::Digitizing => To::Digitizing,
            To::Aborting => To::Aborting,
            To::Doing(name) => To::Doing(name),
        })
    }
}
