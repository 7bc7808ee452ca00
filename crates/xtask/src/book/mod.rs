//! Pages of the user's book that are made from the program's own tables.

mod commands;
mod functions;
mod messages;
mod states;

pub use commands::commands;
pub use functions::functions;
pub use messages::messages;
pub use states::states;
