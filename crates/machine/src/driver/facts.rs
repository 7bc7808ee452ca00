//! Facts that a controller told of itself: what it has, and what it can do.

use kerf_motion::controllers as planners;
use kerf_program::{AXES, Gauge, HeightLaw};

/// Facts that a controller told of itself.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Facts {
    /// Name it gives itself, with its version.
    pub name: String,
    /// Number of its axes, X first.
    pub axes: usize,
    /// The fastest each axis goes, mm/s; `None` where it did not say.
    pub speed_mm_s: [Option<f64>; AXES],
    /// Range of each axis, its own machine frame, mm; `None` where it does not check.
    pub travel_mm: [Option<(f64, f64)>; AXES],
    /// It knows where it is only after it was homed.
    pub homes: bool,
    /// Greatest distance of an arc's chord from the arc, mm.
    pub arc_tolerance_mm: f64,
    /// It makes arcs by itself ([`super::Order::Arc`]).
    pub arcs: bool,
    /// Outputs it has, a bit each, line 1 lowest.
    pub outputs: u32,
    /// PWM channels it has, a bit each, channel 1 lowest.
    pub pwm: u32,
    /// The reason for which it has no spindle, in words; empty where it has one, or tells none.
    pub no_spindle: &'static str,
    /// Inputs of which it tells, a bit each, input 1 lowest.
    pub inputs: u32,
    /// Nothing is on when its line is opened: it starts then, or switched off when the line ended.
    pub is_fresh: bool,
    /// The input at whose change it stops by itself, and latches the place ([`super::Order::Probe`]); nothing where it has none.
    pub probe: Option<u8>,
    /// The fastest its spindle turns, revolutions a minute.
    pub spindle_rpm: f64,
    /// It changes the speed of moves that it has (feed override).
    pub overrides: bool,
    /// A change of feed waits until the machine stands, while it watches inputs.
    pub feed_waits: bool,
    /// The output of its spindle can be a laser's, whose power follows the speed.
    pub follows_speed: bool,
    /// Z follows a sheet by the voltage of a torch (height control).
    pub follows_voltage: bool,
    /// Z follows a sheet by two switches of its head (height control).
    pub follows_switches: bool,
    /// Z goes down and up by the input of a torch (VH), and the machine tells how far.
    pub follows_torch: bool,
    /// It changes the speed of its rapid moves, and that of its spindle, by itself ([`super::Override`]).
    pub overrides_more: bool,
    /// It stops on its path and goes on from there, with its outputs as they are (feed hold).
    pub holds: bool,
    /// Its stop switches every output off.
    pub stop_switches_off: bool,
    /// It passes corners at a speed of its own: the plan of all moves up to the next stand is one piece, and it does not wait for
    /// the plan at corners where that stands.
    pub plans_corners: bool,
    /// It is given all moves up to the next stand at once: it stands wherever it has to wait for more.
    pub takes_whole: bool,
    /// A repeated run gives the same inputs, so that they need no place on record.
    pub repeats: bool,
    /// Its place comes from the record of the last run; every other machine tells its own.
    pub placed_by_record: bool,
    /// Its planner, where it plans for itself and has told how it is set: by it the time of a run is told.
    pub planner: Option<planners::OwnPlanner>,
    /// A run may tell of a move so long before it is made, seconds.
    pub leads_s: f64,
    /// Its switches are moved here: of every other machine they are moved where they are.
    pub inputs_by_hand: bool,
    /// The bits of its card are switched one at a time, and its motors stepped once.
    pub card: bool,
    /// Nothing real hangs on it: nobody is hurt by what it does.
    pub harmless: bool,
}

impl Facts {
    /// Tells whether Z follows a sheet by a law.
    pub const fn follows(&self, law: &HeightLaw) -> bool {
        match law.gauge {
            Gauge::Simple { .. } => self.follows_switches,
            Gauge::Proportional { .. } => self.follows_voltage,
        }
    }
}
