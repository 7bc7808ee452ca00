//! Connected pages, and the devices that may connect.

mod devices;
mod hand;
mod here;
mod pages;
mod tries;

pub use devices::{Devices, PairError};
pub use hand::{Grip, GripError};
pub use here::{FILE as TOKEN_FILE, Here};
pub use pages::{Pages, is_script, script};
pub use tries::Tries;
