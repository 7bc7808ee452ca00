//! Boards with step queues, as values: bytes and moments of time go in, bytes and news come out.
//!
//! The program in such a board (the micro-controller part of Klipper; on nearly every board of a printer) knows no
//! G-code and no speeds. It makes steps at clocks that it is told, and stops them when a latch triggers. Everything
//! else is the host's: so motion is made as it was planned, to the step. This crate is the host's half of that
//! protocol, written from its public description and from recorded sessions; it opens no port, starts no thread and
//! reads no clock.
//!
//! ```text
//!  steps of a plan ─► queue::Queue ─► compress::Compressor ─► interval, count, add ─┐
//!                     (pieces with     (few commands, each                           ▼
//!                      their tails)     step in its window)        board::Board ─► link::Link ─► frames ─► line
//!  counts, inputs ◄── news ◄────────────────────────────────────── (session)   ◄── (loses nothing) ◄────── line
//! ```
//!
//! - [`wire`]: numbers, check number, frames.
//! - [`link`]: commands that are run once and in order on a line that spoils bytes.
//! - [`dictionary`]: the board's own words, asked for by [`identify`]; [`orders`]: the commands that Kerf sends.
//! - [`setup`]: what hangs on a board, as its configuration. [`clock`]: the time in the board.
//! - [`compress`]: steps as few commands. [`queue`]: motion that ends at rest whatever happens to its planner.
//! - [`board`]: all of that for one board: found, configured, moved, stopped, counted.
//! - [`mailbox`]: boards as the owner of a plan deals with them, from another thread.
//! - [`crew`]: one board or several as one machine, each on its [`timeline`].
//! - [`fake`]: a fake board.
//! - [`tmc`]: registers of motor drivers on a single wire.
//!
//! Three promises hold for whoever drives: no step goes out before the board's latch is armed over it; nothing that
//! was sent ends in speed while the host lives; a host that dies is taken for dead by the board within the deadline.
//!
//! docs/how-boards-with-step-queues-are-driven.md tells it with pictures, and what is not there yet.

pub mod board;
pub mod clock;
pub mod compress;
pub mod crew;
pub mod dictionary;
pub mod fake;
pub mod identify;
pub mod link;
pub mod mailbox;
pub mod orders;
pub mod queue;
pub mod setup;
pub mod timeline;
pub mod tmc;
pub mod wire;
