//! Heights and speeds in force: a pause, or height control, changes them.

use kerf_machine::Configuration;
use kerf_machine::state::StopSettings;
use kerf_program::Settings;
use kerf_program::job::{Heights, InForce};
use std::sync::Arc;

/// Heights and speeds.
#[derive(Clone, Debug)]
pub(crate) struct Values {
    pub heights: Heights,
    pub cut_mm_s: f64,
    pub plunge_mm_s: f64,
    /// The tool rises in pauses.
    pub raise: bool,
    /// Groups that were told to be slower than they ask for.
    pub limited: Vec<Arc<str>>,
}

impl Values {
    /// Those of a machine.
    pub fn of(machine: &Configuration, settings: &Settings) -> Self {
        Self {
            heights: machine.zpos,
            cut_mm_s: settings.smoothing.cut_speed_mm_s.unwrap_or(settings.speeds.cut.xy),
            plunge_mm_s: machine.speeds.plunge_mm_s,
            raise: machine.pause.raise,
            limited: Vec::new(),
        }
    }

    /// Returns the values that a pause may have changed, heights apart.
    pub const fn in_force(&self) -> InForce {
        InForce { cut_mm_s: self.cut_mm_s, plunge_mm_s: self.plunge_mm_s, raise: self.raise }
    }

    pub const fn stop_settings(&self) -> StopSettings {
        StopSettings::profiler(self.raise)
    }

    /// The height of travel: where height control carried it above home, that of home.
    pub fn travel_mm(&self, machine: &Configuration) -> f64 {
        self.heights.top_mm.min(machine.zpos.top_mm.max(0.0))
    }

    /// ZTop and ZSurface as they were when the job began.
    pub fn restore_heights(&mut self, machine: &Configuration) {
        let [top_mm, surface_mm] = [machine.zpos.top_mm, machine.zpos.surface_mm];
        self.heights = Heights { top_mm, surface_mm, ..self.heights };
    }

    /// From here on the machine cuts at most so fast, mm/s.
    pub fn use_cut_speed(&mut self, mm_s: f64) {
        self.cut_mm_s = mm_s;
        self.limited.clear();
    }
}
