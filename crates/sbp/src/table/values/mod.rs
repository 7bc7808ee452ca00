//! V commands: the values of the machine.
//!
//! Nearly all of them are their parameters and nothing else; see [`super::setting`]. A blank keeps
//! what was, and a line that is refused changes nothing: everything is checked before anything is
//! changed.

mod axes;
mod cutter;
mod display;
mod driver;
mod height;
mod limits;
mod offset;
#[cfg(test)]
mod properties;
mod ramps;
mod speeds;
mod switches;
mod tabs;
#[cfg(test)]
mod tests;
mod units;
mod variable;
mod view;

pub(super) use speeds::{JOG, MOVE, set_speeds};

use super::CommandSpec;

pub(super) static SPECS: [&CommandSpec; 14] = [
    &axes::VA,
    &tabs::VB,
    &cutter::VC,
    &display::VD,
    &height::VH,
    &driver::VI,
    &limits::VL,
    &switches::VN,
    &offset::VO,
    &view::VP,
    &ramps::VR,
    &speeds::VS,
    &units::VU,
    &variable::VV,
];
