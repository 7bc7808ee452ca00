//! Files of other kinds, made ready for the machine.
//!
//! - [`job_file`] reads jobs (`.rsm`), takes what a person chooses about one, and prints it as a part program.
//! - [`drawn`] makes part programs of drawings and pictures.
//! - [`convert`] is FC: a file of the part folder becomes a part file beside it.
//! - [`card_file`] makes a part file or a job ready for the card of a controller.
//! - [`ConversionHost`] answers a program that is followed on paper, to convert it.
//!
//! Nothing of it is a run: no machine, no operator, no time.

pub mod card_file;
mod conversion;
pub mod drawn;
mod host;
pub mod job_file;

pub use conversion::convert;
pub use host::{Answers, ConversionHost};
