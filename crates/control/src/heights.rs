//! The heights in force, as they are told: ZSurface and ZTop go with Z while it follows the sheet
//! (Profiler reference, "Automatic Height Control").

use crate::Event;
use kerf_program::job::Heights;

/// Heights that held when the tool was at a height.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Carried {
    /// The heights.
    pub heights: Heights,
    /// Where the tool was, Z of the machine frame, mm.
    pub z_mm: f64,
}

impl Carried {
    /// The heights now that height control has brought the tool elsewhere.
    pub fn at(&self, z_mm: f64) -> Heights {
        let Heights { top_mm, surface_mm, bottom_mm } = self.heights;
        let by = z_mm - self.z_mm;
        Heights { top_mm: top_mm + by, surface_mm: surface_mm + by, bottom_mm }
    }
}

/// The event that tells them.
pub(crate) const fn event(heights: Heights, t: f64) -> Event {
    let Heights { top_mm: top, surface_mm: surface, bottom_mm: bottom } = heights;
    Event::Heights { top, surface, bottom, t }
}
