//! The way from the numbers of the file to places of the machine.
//!
//! ```text
//!  word ── scale ──► place in the coordinate system, mm ── turned, zero ──► machine frame
//! ```

use super::session::Options;
use super::state::State;
use kerf_program::{AXES, Axes, Axis, Settings, settings};
use serde::{Deserialize, Serialize};

/// The coordinate system in force with unit, offsets and the proportions of FP: worked out again when one of
/// them changes.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(super) struct Coordinates {
    /// Millimetres or degrees of one unit in the file, per axis: unit times proportion.
    pub(super) scale: [f64; AXES],
    /// Machine position of a place that reads zero in the file, while nothing is turned.
    pub(super) zero: Axes,
    /// The same without the temporary zero of FP.
    pub(super) working_zero: Axes,
    /// Sine and cosine of the coordinate system's turn.
    pub(super) turned: Option<[f64; 2]>,
}

impl Coordinates {
    pub(super) fn new(state: &State, settings: &Settings, options: &Options) -> Self {
        let system = state.system();
        let turned = (system.rotation_deg != 0.0).then(|| {
            let (sin, cos) = system.rotation_deg.to_radians().sin_cos();
            [sin, cos]
        });
        let scale = Axis::ALL.map(|axis| state.modal.unit_of(settings, axis));
        let mut all = Self { scale, turned, ..Self::default() };
        all.working_zero = system.offset.plus(state.tool_offset).plus(all.turn(state.shift));
        all.zero = all.working_zero;
        for i in 0..3 {
            all.scale[i] *= options.proportion[i];
            all.zero.0[i] += options.temporary_zero_mm[i];
        }
        all
    }

    /// A displacement in the coordinate system as one in the machine frame.
    fn turn(&self, mut place: Axes) -> Axes {
        if let Some([sin, cos]) = self.turned {
            let [x, y, ..] = place.0;
            place.0[0] = x * cos - y * sin;
            place.0[1] = x * sin + y * cos;
        }
        place
    }

    /// A displacement in the machine frame as one in the coordinate system.
    fn unturn(&self, mut place: Axes) -> Axes {
        if let Some([sin, cos]) = self.turned {
            let [x, y, ..] = place.0;
            place.0[0] = x * cos + y * sin;
            place.0[1] = y * cos - x * sin;
        }
        place
    }

    /// Machine position of a place in the coordinate system, mm.
    pub(super) fn machine_of(&self, place: Axes) -> Axes {
        self.turn(place).plus(self.zero)
    }

    /// Place in the coordinate system of a machine position, mm.
    pub(super) fn place_of(&self, machine: Axes) -> Axes {
        self.unturn(machine.minus(self.zero))
    }

    /// A place in the coordinate system in the units of the file.
    pub(super) fn to_user(&self, place: Axes) -> Axes {
        Axes(std::array::from_fn(|i| settings::to_user(place.0[i], self.scale[i])))
    }

    /// A machine position with some axes put to places of the coordinate system, mm.
    pub(super) fn moved(&self, from: Axes, places: impl Iterator<Item = (usize, f64)>) -> Axes {
        if self.turned.is_none() {
            let mut to = from;
            for (axis, place) in places {
                to.0[axis] = place + self.zero.0[axis];
            }
            return to;
        }
        let mut place = self.place_of(from);
        let mut in_plane = false;
        let mut to = from;
        for (axis, value) in places {
            place.0[axis] = value;
            in_plane |= axis < 2;
            if axis >= 2 {
                to.0[axis] = value + self.zero.0[axis];
            }
        }
        if in_plane {
            let machine = self.machine_of(place);
            to.0[0] = machine.0[0];
            to.0[1] = machine.0[1];
        }
        to
    }
}
