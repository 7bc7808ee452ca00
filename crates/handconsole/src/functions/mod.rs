//! The functions behind the key Func: one table, and how a function is chosen and asks for its numbers.

mod heights;
mod jobs;
mod moves;
mod selecting;
mod settings;
mod spec;
mod stepping;
mod table;

pub(crate) use selecting::Selecting;
pub use spec::{Done, Function, Refusal, Step, shown};
pub(crate) use stepping::Stepping;
pub use table::{FUNCTIONS, function};
