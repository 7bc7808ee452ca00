//! The machine: one thread owns it and runs one thing after the other.
//!
//! ```text
//!  acts ── Order ──► Owner ── Session::run ──┬─ Clock         time of the simulated machine
//!    └──── requests, answers ──► Link ───────┼─ PageRequests  STOP, hold, feed, keys
//!                                            ├─ Pages         questions
//!                                            └─ Teller        events ─► Board ─► Hub ─► pages
//! ```

mod arrived;
mod board;
mod card_run;
mod chores;
mod driven;
mod last_state;
pub mod link;
mod order;
mod owner;
mod planned;
mod ports;
mod reach;
mod run_context;
mod tool_length;
mod typing;
mod zeros;

pub use arrived::StopCount;
pub use last_state::LastState;
pub use link::Link;
pub use order::{CardOrder, Order};
pub use owner::Owner;
pub use planned::{Planned, Planning};
pub use ports::{bits, input_state, ports};
pub use reach::reach;
pub use typing::{CalledFile, Screen};
