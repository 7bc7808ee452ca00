//! The settings of a run, and those that come back.

use kerf_program::Settings;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Settings in force and set aside.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct Values {
    /// Those in force.
    pub(crate) settings: Arc<Settings>,
    /// Permanent values, restored when the run ends (SV replaces them).
    pub(crate) kept: Arc<Settings>,
    /// In preview mode, while a file runs: those that it began with.
    pub(crate) looked_at: Option<Arc<Settings>>,
}

impl Values {
    pub(crate) fn new(settings: Settings) -> Self {
        let settings = Arc::new(settings);
        Self { kept: settings.clone(), settings, looked_at: None }
    }
}
