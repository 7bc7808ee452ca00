//! The workspace of a machine: everything on disk that a program may reach.
//!
//! - [`Workspace`] has the part files, custom cuts, files that programs read and write, and values that survive. A
//!   preview gets a copy that keeps its writes to itself.
//! - [`stored`] are values by key, which other software may set meanwhile.
//! - Folders of it have a module each: [`parts`], [`settings_files`], [`sounds`], fonts; so have the tools that write
//!   into them ([`virtual_tools`]) and the log of a session ([`system_log`]).
//!
//! What a run hears of all this is on its tape, so that the run can be taken up.

pub mod command_passing;
mod fonts;
pub mod height_map;
mod host;
pub mod part_log;
pub mod parts;
mod program_file;
mod session_log;
mod settings_files;
mod shell;
pub mod sounds;
pub mod stored;
pub mod system_log;
mod values;
pub mod virtual_tools;
mod workspace;

pub use program_file::MOST_BYTES;
pub use values::{CONFIRM, confirm, unconfirmed, unverified};
pub use workspace::{Firmware, Workspace};
