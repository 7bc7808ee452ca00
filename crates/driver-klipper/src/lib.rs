//! Boards with step queues, as values: bytes and moments of time go in, bytes and news come out.

pub mod board;
pub mod clock;
pub mod compress;
pub mod dictionary;
pub mod identify;
pub mod link;
pub mod orders;
pub mod queue;
pub mod setup;
pub mod tmc;
pub mod wire;
