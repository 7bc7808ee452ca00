//! Who is connected, and which devices may.

mod devices;
mod hand;
mod pages;

pub use devices::{Devices, PairError};
pub use hand::{Grip, GripError};
pub use pages::Pages;
