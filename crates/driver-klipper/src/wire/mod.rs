//! Bytes on the line: whole numbers, the check number, frames.

pub mod crc;
pub mod frame;
pub mod vlq;
