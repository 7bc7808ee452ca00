//! Facts of safety: what the machine says of itself, beside the values that programs and other software keep. They read
//! as values of the registry do; they are kept apart from those, and the machine alone writes them.

use crate::Live;
use kerf_sbp::{POSITION_LOST, SPINDLE_STATUS};

/// Fact that the machine tells of itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fact {
    /// The spindle starts without a question: somebody has answered it.
    SpindleStatus,
    /// Letters of axes that may be elsewhere.
    PositionLost,
    /// Letters of axes whose location somebody confirms before anything is cut.
    ConfirmLocation,
    /// Switches of the simulated machine as somebody left them.
    SimulatedSwitches,
    /// Place at which a controller without homing was left.
    ControllerLeft,
    /// The port of the controller that is driven.
    ControllerDriven,
    /// The setting of a controller that was changed and is not put back.
    ControllerChanged,
    /// The outputs with which a controller was left on.
    ControllerOutputs,
    /// Factors by which runs on controllers take longer than their planners say.
    ControllerPaces,
    /// Planners of controllers as they told them last.
    ControllerPlanners,
}

impl Fact {
    /// All of them.
    pub const ALL: [Self; 10] = [
        Self::SpindleStatus,
        Self::PositionLost,
        Self::ConfirmLocation,
        Self::SimulatedSwitches,
        Self::ControllerLeft,
        Self::ControllerDriven,
        Self::ControllerChanged,
        Self::ControllerOutputs,
        Self::ControllerPaces,
        Self::ControllerPlanners,
    ];

    /// The key under which the registry shows it.
    pub const fn key(self) -> &'static str {
        match self {
            Self::SpindleStatus => SPINDLE_STATUS,
            Self::PositionLost => POSITION_LOST,
            Self::ConfirmLocation => "ConfirmLocation",
            Self::SimulatedSwitches => "SimulatedSwitches",
            Self::ControllerLeft => "ControllerLeft",
            Self::ControllerDriven => "ControllerDriven",
            Self::ControllerChanged => "ControllerChanged",
            Self::ControllerOutputs => "ControllerOutputs",
            Self::ControllerPaces => "ControllerPaces",
            Self::ControllerPlanners => "ControllerPlanners",
        }
    }

    /// The fact that the registry shows under a key.
    pub fn of(key: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|fact| fact.key() == key)
    }
}

/// Tells whether the machine alone writes a key: its value is a fact of safety, or tells what the machine does now.
pub fn is_fact(key: &str) -> bool {
    Fact::of(key).is_some() || Live::tells(key)
}
