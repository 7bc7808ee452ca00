//! Who is connected, and which devices may.

mod devices;
mod pages;

pub use devices::{Devices, PairError};
pub use pages::{Pages, is_script, script};
