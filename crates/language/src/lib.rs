//! Answers to the questions of an editor of part files and of a fill-in sheet.
//!
//! ```text
//!  command table ──► commands   menus, hints and sheets, with the settings that hold
//!  text ──► check               what is wrong with it, without running it
//!  text, place ──► complete     words that could stand there
//!               └► hover        what the word there means
//! ```
//!
//! Everything comes from the same core that runs part files: a word that is offered here runs, and a
//! mistake told here is one there. Pure functions; the server and other editors call them.

mod check;
mod commands;
mod complete;
mod hover;
mod word;

pub use check::{check, check_lines, check_until, finding};
pub use commands::{added, commands};
pub use complete::complete;
pub use hover::hover;
