//! Options of a run.

use crate::{CarriedOver, Started};
use kerf_model::Change;
use kerf_program::HeightMap;
use kerf_sim::Push;
use kerf_sim::{Sheet, Touch};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Options with which a program is run.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct RunOptions {
    /// Options for reading the language.
    pub program: kerf_sbp::Options,
    /// Options for reading G-code, as far as `program` does not say.
    pub gcode: kerf_gcode::Options,
    /// Changes of the simulated machine's inputs.
    pub inputs: Vec<Change>,
    /// The sheet on the table of the simulated machine.
    pub sheet: Option<Sheet>,
    /// Heights of the surface that the program follows.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub heights: Option<Arc<HeightMap>>,
    /// Switches of the simulated machine that feel where the tool is.
    #[serde(default)]
    pub touches: Vec<Touch>,
    /// Pushes of the simulated machine by hand.
    pub pushes: Vec<Push>,
    /// Tell the user's variables at the end.
    pub tell_variables: bool,
    /// The controller that carries it out, as it was named; else it is the simulated machine.
    #[serde(default)]
    pub controller: Option<String>,
    /// Start of the run, for the log of the part file; without it none is written.
    pub started: Option<Started>,
    /// Treatment of a move that would leave the table limits.
    pub limits: LimitPolicy,
    /// The password was given, where one protects the machine's settings: whoever runs it may change them.
    #[serde(default)]
    pub opened: bool,
    /// Preparations of the run, which goes on from there.
    #[serde(default)]
    pub before: CarriedOver,
    /// Carry out so many commands at the most, moves and all others; 0 for no bound. What only looks at a
    /// program has one: a program may go round for ever on purpose.
    #[serde(default)]
    pub most_commands: u64,
    /// Look at the commands of a run after so many lines; 0 for the usual. Results do not depend
    /// on it.
    pub lines_at_once: u64,
    /// Save the state of the program at each look and go on from what was saved. Results do not
    /// depend on it.
    pub restore: bool,
}

/// Treatment of a move that would leave the table limits.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum LimitPolicy {
    /// The operator is asked whether to go on; the default ends the run.
    #[default]
    Ask,
    /// Each such move is told, and made.
    List,
}
