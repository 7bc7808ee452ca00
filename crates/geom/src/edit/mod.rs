//! Changing shapes by hand: rounding and cutting corners, breaking, trimming, joining.

mod corner;
mod join;
mod trim;

pub use corner::{chamfer, fillet};
pub use join::{Ends, Joined, join};
pub use trim::{broken, trimmed};
