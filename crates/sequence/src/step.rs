//! The steps of a job.

use kerf_geom::Point2;
use kerf_machine::lines::{Input, Output};
use kerf_program::{Axis, Beam, HeightLaw};
use std::sync::Arc;

/// One step. Each is carried out to its end before the next begins.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Step {
    /// An output goes on or off.
    Switch(Output, bool),
    /// Time passes, seconds.
    Wait(f64),
    /// An input is waited for.
    Await(Awaited),
    /// The emergency stop is waited for to be released, for a moment.
    Release,
    /// One of the jigs is waited for.
    AwaitJig,
    /// Intensity.
    Beam(Beam),
    /// Pulse frequency, Hz.
    Frequency(f64),
    /// Height control begins or ends.
    Height(Option<Arc<HeightLaw>>),
    /// People learn the heights in force.
    TellHeights,
    /// People learn the speeds in force.
    TellInForce,
    /// ZTop and ZSurface are again what they were when the job began.
    RestoreHeights,
    /// In the plane, at the present height, as fast as the axes can.
    Travel(Point2),
    /// Up or down as fast as Z can.
    Rapid(f64),
    /// Up to a height as fast as Z can, unless the tool is there or higher.
    RaiseTo(f64),
    /// Up or down at plunging speed.
    Plunge(f64),
    /// Down at plunging speed until the head is at its height over the sheet, at the lowest to a
    /// height.
    Lower(f64),
    /// Down at plunging speed until an input, at the lowest to a height.
    Feel(f64),
    /// Up at plunging speed, so far above the place that was felt.
    AboveFelt(f64),
    /// Up or down at plunging speed, so far above the height at which the sensor said that the head is
    /// where it is to be.
    AboveSensed(f64),
    /// Turns the tool about Z, degrees.
    Turn(f64),
    /// An axis moves by hand.
    Hand(Axis, f64),
    /// Down along the path or beside it, to where it begins at the height of the pass.
    Slope,
    /// Along the path, from where it was left.
    Follow,
    /// The path is made.
    Made,
    /// The tool is clear of the path.
    Clear,
    /// The machine halts at the pause mark of the shape at hand.
    Mark,
    /// The operator decides how it goes on.
    Ask,
    /// The job is given up.
    GiveUp,
    /// The machine enters a state.
    Enter(kerf_machine::State),
    /// A word to the operator.
    Say(Arc<str>),
    /// A word to the operator while an input is not on.
    SayUnless(Input, &'static str),
}

impl Step {
    /// Returns `true` if it switches something off, or tells that the machine is in a state that it stopped in.
    pub fn belongs_to_stop(&self, state: kerf_machine::State) -> bool {
        match self {
            Self::Switch(_, on) => !on,
            Self::Beam(beam) => *beam == Beam::Off,
            Self::Height(law) => law.is_none(),
            Self::Enter(entered) => *entered == state,
            _ => false,
        }
    }
}

/// An input that is waited for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Awaited {
    /// The input.
    pub input: Input,
    /// Longest wait, seconds.
    pub timeout_s: f64,
    /// Message when it does not come; without words the job goes on.
    pub missing: Option<&'static str>,
}
