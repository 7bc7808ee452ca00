//! Tree to tree: variables, conditions, loops and subroutines stay what they are.
//!
//! OpenSBP has labels and jumps, G-code has O-words, and numbers are single precision on one side and
//! double on the other. So not every program can be kept. What cannot is refused with its line, and
//! the whole program is written as the moves it makes instead. What could be kept is followed and
//! compared with the source, as every conversion is, within [`KEPT_MM`].

mod gcode_expressions;
mod gcode_feed;
mod gcode_flow;
mod gcode_lines;
mod gcode_modes;
mod gcode_motion;
mod gcode_survey;
mod jumps;
mod sbp_expressions;
mod sbp_lines;
mod sbp_moves;
mod unkept;

pub use unkept::{KEPT_MM, Unkept};

use crate::{Conversion, Language, Source};
use kerf_gcode::Dialect;

/// Converts tree to tree.
///
/// # Errors
/// The first construct that cannot be kept.
pub fn convert(source: &Source<'_>, how: &Conversion) -> Result<String, Unkept> {
    match (source.language, how.to) {
        (Language::OpenSbp, Language::Gcode(Dialect::LinuxCnc)) => {
            sbp_lines::to_gcode(&kerf_sbp::read(source.name.clone(), source.bytes), how)
        }
        (Language::Gcode(_), Language::OpenSbp) => {
            gcode_lines::to_sbp(&kerf_gcode::read(source.name.clone(), source.bytes), how)
        }
        (_, Language::Gcode(dialect)) => {
            Err(Unkept::new(1, format!("{} has no variables", dialect.name())))
        }
        (Language::OpenSbp, Language::OpenSbp) => Err(Unkept::new(1, "it is OpenSBP already")),
    }
}
