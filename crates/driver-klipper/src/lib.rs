//! Boards with step queues, as values: bytes and moments of time go in, bytes and news come out.

pub mod compress;
pub mod dictionary;
pub mod identify;
pub mod link;
pub mod wire;
