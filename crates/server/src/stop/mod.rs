//! STOP, and its way of its own.
//!
//! ```text
//!  page ──┬─ /ws of the console ──► front ──┐
//!         └─ /stop, a port of its own ──► a thread that does nothing else ──► Link ──► machine's thread
//! ```
//!
//! - [`StopPress`] recognises what only stops, in whatever form it comes, before anything is parsed.
//! - [`StopWay`] is a listener with a thread of its own, which waits for nobody.
//! - A page presses STOP on both ways: [`Presses`] sees to it that one press counts once.

mod halt;
mod presses;
mod way;

pub use halt::{StopPress, heard};
pub use presses::Presses;
pub use way::{Door, StopWay};
