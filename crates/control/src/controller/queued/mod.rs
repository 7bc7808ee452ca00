//! Boards with step queues as machines: the plan is made to the step, by whoever planned it.
//!
//! ```text
//!  Runner ── advance(move …) ─► Queued ── Feeder: pieces with their tails ─► BoardPort ─► Mailbox: Board ── bytes ──► board
//!  World  ── set(output) ─────►   │                                            │ (a thread of its own)
//!     ▲                           │                                            │
//!     └── reached, inputs, fault ─┴──◄── Progress, Answers ────────────────────┘
//! ```
//!
//! Motion that was handed to a board is made: so the run goes ahead of the machine by the board's lead, some 0.14 s, and what it
//! changes (a stop, another feed) it changes from there on.

mod as_machine;
mod attached;
mod axis_move;
mod beam;
mod board_port;
mod drivers;
mod facts;
mod feeder;
mod guard;
mod height;
mod homing;
mod introduced;
mod machine;
mod others;
mod outputs;
mod pins;
mod priority;
mod run_lead;
mod steering;
mod thread;
mod touch;
mod wiring;
pub mod wizard;

pub use attached::{Attached, Socket};
pub use axis_move::AxisMove;
pub use board_port::BoardPort;
pub use introduced::{at_ports, introduced};
pub use kerf_driver_klipper::board::{Held, Introduced};
pub use machine::Queued;
pub use others::{address, read as others};
pub use priority::raise as raise_priority;
pub use thread::OpensLine;
pub use wiring::Wiring;
