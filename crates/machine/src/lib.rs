//! The model of a machine: its settings, its moves by hand and its drivers.
//!
//! [`Configuration`] is the one model of a machine's settings: those of the V commands
//! ([`kerf_program::Settings`]) and, beside them, what the Profiler tables list, an area a file in
//! [`settings`]. The [`table`] names every one of them with unit, bounds and meaning; the
//! configuration file ([`file`]), `kerf machine`, and every form are made from it, so that a new
//! setting is a field and a row. What each row allows is checked when it is set; what several say
//! together is checked by [`contradictions`] before anything moves.
//!
//! Lengths are millimetres, angles degrees, times seconds unless the name of a field ends in
//! another unit.

pub mod boards;
pub mod conformance;
pub mod contradictions;
pub mod driver;
pub mod file;
pub mod hand;
pub mod height_follower;
pub mod homing;
mod levels;
mod lift;
pub mod lines;
pub mod machine;
pub mod password;
mod pause_order;
pub mod planning;
pub mod printer_cfg;
pub mod profile;
pub mod settings;
pub mod state;
pub mod table;
pub mod value;
pub mod wiring;

pub use hand::{Errand, Hand, Held, Keypad, Stretch};
pub use lift::{Lift, LiftOfMove, Reading};
pub use machine::{Actuator, Ahead, Driven, Fault, Going, Machine, News, OVERRUN_MM, Watch};
pub use pause_order::PauseOrder;
pub use settings::Configuration;
pub use state::State;
pub use table::Setting;
pub use value::Value;
