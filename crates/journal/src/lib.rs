//! The journal: the state of a machine that has to outlive the process, in one SQLite file.
//!
//! ```text
//!  fact      place, homed axes, what G-code remembers, the run under way and how far it is; what the machine says of
//!            itself, as which axes are not verified: nobody else writes there ([`stated`])
//!  value     what programs and other software keep under a key
//!  step      what the world told the run under way, in order
//!  content   program files of that run, by the hash of their bytes
//!  history   runs that are over, oldest first
//! ```
//!
//! - Every table has the same shape: key, text, and a check number of both ([`rows`]), so that a bit
//!   that changed on the disk is noticed, and a damaged file is saved row by row ([`rescue`]).
//! - A change is in the file before what follows from it happens (write-ahead). Between two moves
//!   of a run that are closer than [`progress::EVERY`] nothing is written, unless machine time is
//!   the time of the world. Then a thread writes ([`scribe`]): while the machine moves nobody waits for the
//!   disk, and the record may be behind by as long as the disk takes; before the machine sets off it is not.
//! - Every change counts the generation up, and a second file follows it ([`seal`]): a journal that lost its newest changes
//!   is damaged, and so is one that is older than its copy ([`copy`]). At rest everything is in the one file.
//! - One process owns the machine ([`Journal::own`]); others may look, and set values.
//! - [`Journal`] is made of parts with state of their own over one [`store`]: [`Registry`] (values), [`MachineSettings`],
//!   [`Memory`] (where the machine is), [`Runs`]. A run under way is a [`Tape`], which hands a batch to a writer.
//! - Order is the order of writing; no decision depends on a clock.
//! - Settings are none of its business: they are in `machine.toml` beside it ([`settings`]).

mod batch;
mod carried_over;
mod contents;
mod copy;
mod database;
mod error;
pub mod facts;
mod history;
mod journal;
mod kept_work;
mod known_machine;
mod live;
pub mod machine_file;
mod memory;
mod mirror;
mod opening;
mod options;
mod owner;
mod placed;
mod press;
mod progress;
mod reached;
mod registry;
mod rescue;
mod resting_machine;
mod rows;
mod runs;
mod scribe;
mod seal;
mod settings;
mod started;
mod stated;
mod store;
mod surroundings;
pub mod switches;
mod tape;
mod under_way;
mod value;
mod work;
mod writer;

pub use carried_over::{CarriedOver, Door};
pub use copy::BACKUP_FILE;
pub use error::JournalError;
pub use history::Past;
pub use journal::Journal;
pub use kept_work::KeptWork;
pub use live::Live;
pub use memory::{Memory, ReadSettings, Remembered, Whereabouts};
pub use mirror::{INCOMING_FILE, MIRROR_FILE};
pub use options::{LimitPolicy, RunOptions};
pub use owner::Owner;
pub use placed::Placed;
pub use press::Press;
pub use registry::Registry;
pub use resting_machine::RestingMachine;
pub use runs::Runs;
pub use scribe::Hurry;
pub use seal::SEAL_FILE;
pub use settings::MachineSettings;
pub use started::Started;
pub use store::JOURNAL_FILE;
pub use surroundings::{Shell, Surroundings};
pub use tape::{AnswerSource, Kind, Tape};
pub use under_way::{CutShort, RunUnderWay};
pub use value::check_value;
pub use work::Work;

#[cfg(test)]
mod tests;
