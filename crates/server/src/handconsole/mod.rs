//! The hand console of the machine: one, whose keys come from pages and from a serial link.
//!
//! ```text
//!  pages ── Act::Key ──┐                    ┌── Wish ──► App: acts, orders
//!                      ├─► Keeper: Console ─┤
//!  serial link ────────┘    ▲               └── Screen ─► Hub ─► pages, serial link
//!  machine's thread ─ Told ─┘
//! ```
//!
//! Its thread owns the [`Console`](kerf_handconsole::Console): keys are pressed one after the other, and what
//! one wishes is granted to whoever pressed it, under the same rules as everything that this somebody asks for.

mod keeper;
mod left;
mod port;
mod view;
mod wishes;

use crate::app::App;
use crate::asker::Asker;
use crate::people::Grip;
use crate::priority::Yields;
use crate::refusal::problem;
use kerf_handconsole::Key;
use kerf_wire::{Problem, Why};
use std::sync::Arc;
use std::sync::mpsc::channel;
use std::thread;

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
    /// Outcome of a wish that lasts: what was found out, or why it is not done.
    Told(Result<String, String>),
}

/// Begins the thread of the console, which ends with the server. Where only drawings are worked on there is
/// none.
pub fn begin(app: &Arc<App>) {
    if app.options.drawing_only {
        return;
    }
    let (happens, happenings) = channel();
    let keeper = keeper::Keeper::new(Arc::downgrade(app), happens.clone());
    let thread = thread::Builder::new().name("hand console".into());
    if thread
        .spawn(move || {
            Yields::Front.hold();
            keeper.work(&happenings);
        })
        .is_ok()
    {
        // There is one for a server.
        drop(app.hand_console.set(happens));
        port::begin(app);
    }
}

impl App {
    /// Presses a key of the hand console.
    ///
    /// # Errors
    /// There is no such key.
    pub fn press_key(&self, asker: &Asker, grip: Grip, key: char) -> Result<(), Problem> {
        let Some(key) = Key::of(key) else {
            let text =
                "the keys are 0 to 9, - (sign), carriage return (Enter), F, S, P (Stop), U (Func)";
            return Err(problem(Why::Malformed, text));
        };
        let happening = Happening::Key { asker: asker.clone(), grip, key };
        let sent = self.hand_console.get().map(|happens| happens.send(happening));
        match sent {
            Some(Ok(())) => Ok(()),
            _ => Err(problem(Why::Server, "there is no hand console; start Kerf anew")),
        }
    }
}
