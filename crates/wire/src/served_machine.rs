//! Machines that one process serves.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use ts_rs::TS;

/// A machine with an owner, a journal and a page of its own, beside others of the same server.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct ServedMachine {
    /// Its name, as the command line has it.
    pub name: String,
    /// The port of its page, at the same host.
    pub port: u16,
    /// It is the machine that tells this.
    pub here: bool,
}
