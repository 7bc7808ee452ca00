//! Boards with step queues as machines: the plan is made to the step, by whoever planned it.
//!
//! ```text
//!  Runner ── advance(move …) ─► Queued ── Feeder: pieces with their tails ─► Berth ─► Desk: Board ── bytes ──► board
//!  World  ── set(output) ─────►   │                                            │ (a thread of its own)
//!     ▲                           │                                            │
//!     └── reached, inputs, fault ─┴──◄── Progress, Answers ────────────────────┘
//! ```
//!
//! What was handed to a board is made: so the run goes ahead of the machine by the board's lead, some 0.15 s, and what it
//! changes (a stop, another feed) it changes from there on.

mod berth;
mod feeder;
mod machine;
mod outputs;
mod wiring;

pub use berth::Berth;
pub use machine::Queued;
pub use wiring::Wiring;
