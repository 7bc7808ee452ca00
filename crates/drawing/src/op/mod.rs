//! Operations: everything that can be done to a drawing, each a value.
//!
//! An [`Operation`] is what the command line, a console and tests send, what undo remembers and what
//! a script holds. Its words (`rotate 30 about 0,0`) are read and written by the entry of its name
//! in [`ENTRIES`]; what it does is in the file of its chapter.

mod act;
mod arrays;
mod clause;
mod clear;
mod clear_group;
mod clipboard;
mod copies;
mod draw;
mod edit;
mod entries;
mod error;
mod form;
mod grouping;
mod layout;
mod operation;
mod outline;
mod path;
mod picked;
mod picks;
mod region;
mod sequence;
mod vertices;
mod words;
mod write;

pub use clause::{ClauseError, script};
pub use clear::{Clearing, Pattern};
pub use entries::{ENTRIES, Entry};
pub use error::{OpError, Outcome, spot};
pub use form::{Part, Value, Variant};

pub(crate) use act::act;
pub use grouping::Change;
pub use operation::{How, Operation};
pub use picked::Picks;
pub use picks::Picking;
pub use sequence::Sequencing;
