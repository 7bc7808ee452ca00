//! Files that programs name: part files, custom cuts, files they read and write.
//!
//! ```text
//!  name as written ── Folders::find ──► path inside the allowed folders ── Disk ──► bytes
//!   C:\SbParts\A.SBP                      parts/a.sbp                        real, in memory,
//!                                                                           or real with a scratch
//! ```
//!
//! Nothing in here follows a name out of the folders that were allowed, whatever dots, drives or
//! symbolic links it has.

mod disk;
mod folders;
mod leftovers;
mod memory;
mod open;
pub mod private;
mod real;
mod scratch;
mod shipped;
pub mod versions;

pub use disk::Disk;
pub use folders::{Folders, Purpose, custom_name};
pub use leftovers::sweep;
pub use memory::MemoryDisk;
pub use open::{OpenFiles, make_way, to_open};
pub use real::{RealDisk, replace_whole, write_private};
pub use scratch::Scratch;
pub use shipped::{MACHINES, SAMPLES, SHIPPED, Shipped};
