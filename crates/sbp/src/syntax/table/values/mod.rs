//! V commands: the values of the machine.
//!
//! Nearly all of them are their parameters and nothing else; see [`super::setting`]. A blank keeps what was.

mod axes;
mod cutter;
mod display;
mod driver;
mod height;
mod limits;
mod offset;
mod ramps;
mod speeds;
mod switches;
mod tabs;
mod units;
mod variable;
mod view;

pub(crate) use display::{is_turn, set_axis_unit};
pub(super) use speeds::{JOG, MOVE};

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
