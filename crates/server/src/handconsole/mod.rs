//! The hand console of the machine: one, whose keys come from pages and from a serial link.
//!
//! ```text
//!  pages ── Act::Key ──┐                    ┌── ConsoleRequest ──► App: acts, orders
//!                      ├─► Keeper: Console ─┤
//!  serial link ────────┘    ▲               └── Screen ─► Hub ─► pages, serial link
//!  machine's thread ─ Told ─┘
//! ```
//!
//! One thread owns the [`Console`](kerf_handconsole::Console) and takes keys one after the other. What a key asks for is
//! decided by the rights of the person who pressed it, as every other request of that person is.

mod happening;
mod keeper;
mod kept_points;
mod port;
mod requests;
mod view;

pub use happening::{Happening, Keys};
pub use requests::grant;

use crate::app::App;
use crate::priority::Yields;
use std::sync::Arc;
use std::sync::mpsc::channel;
use std::thread;

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
        drop(app.keys.set(happens));
        port::begin(app);
    }
}
