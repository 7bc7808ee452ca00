//! The hand console: a screen of two lines of twenty characters and sixteen keys, with which a machine
//! is driven where the material lies (Profiler reference, "Hand Console").
//!
//! ```text
//!  key ──► Console::press(key, &View) ──► ConsoleRequest, ConsoleRequest …   the owner grants them
//!                │                            │
//!  screen ◄── Console::screen(&View)      Console::told(outcome)
//! ```
//!
//! - A [`Console`] is a value without clock, thread or device. What it shows of the machine it is given as
//!   a [`View`]; what it wants done it says as a [`ConsoleRequest`]. Server, tests and a serial link differ only in
//!   who grants requests.
//! - A module is a mode: [`idle`], [`file`], [`start`], [`running`], and [`functions`], which asks for a
//!   function number and then for what the function wants to know.
//! - A key is one byte and a screen 41, on a serial link as well as in messages ([`Key`], [`Screen`]).

mod console;
pub mod digitizing;
mod entry;
mod file;
pub mod functions;
mod idle;
mod key;
mod next;
mod request;
mod running;
mod screen;
mod start;
mod view;

pub use console::Console;
pub use key::Key;
pub use request::{ConsoleRequest, JobRequest};
pub use screen::{COLUMNS, Screen};
pub use view::{OpenJob, View, Waits};
