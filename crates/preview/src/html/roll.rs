//! The motion on a cylinder about X, as a rotary axis turns it under the tool (command reference,
//! VD and VP: rotary preview).
//!
//! Where cuts go below the surface, the surface is that of a blank as thick as VP says the table is
//! in Z: no command tells how thick a blank is. Else the axis lies at Z 0. Seen from the axis a place is
//! as far out as the tool was high, so that its distance tells the depth of the cut.

use crate::scene::Scene;
use kerf_geom::Bounds3;

/// Between two drawn places the cylinder turns no more than this, degrees.
const CHORD_DEG: f64 = 3.0;
/// The most chords of one move; a bound for very many turns.
const MOST_CHORDS: f64 = 4096.0;
/// Thickness of the blank when there is no table to tell it, mm.
const BLANK_MM: f64 = 150.0;

/// The cylinder.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cylinder {
    /// Height of its axis, mm; it lies at Y 0.
    axis_z: f64,
}

impl Cylinder {
    /// The cylinder of a scene with a rotary axis.
    pub fn of(scene: &Scene, reach: &Bounds3) -> Option<Self> {
        let turns = &scene.turns_deg;
        if turns.is_empty() || turns.len() != scene.segments.len() {
            return None;
        }
        let below = !reach.is_empty() && reach.min[2] < scene.surface_z_mm;
        let table = scene.table.map(|table| table.size_mm[2]);
        let blank_mm = table.filter(|z| z.is_finite() && *z > 0.0).unwrap_or(BLANK_MM);
        Some(Self { axis_z: if below { scene.surface_z_mm - 0.5 * blank_mm } else { 0.0 } })
    }

    /// Height of the axis, mm.
    pub fn axis_z(&self) -> f64 {
        self.axis_z
    }

    /// Returns the place on the work of a place of the tool, when the work has turned so far.
    pub fn roll(&self, [x, y, z]: [f64; 3], turn_deg: f64) -> [f64; 3] {
        let finite = if turn_deg.is_finite() { turn_deg } else { 0.0 };
        let (sin, cos) = (finite % 360.0).to_radians().sin_cos();
        let height = z - self.axis_z;
        [x, y * cos - height * sin, self.axis_z + y * sin + height * cos]
    }

    /// Into how many pieces a move is cut whose work turns so far.
    pub fn chords(turn_deg: f64) -> u32 {
        // No number of chords is one chord.
        ((turn_deg.abs() / CHORD_DEG).ceil().clamp(1.0, MOST_CHORDS) as u32).max(1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_quarter_turn_brings_the_top_to_the_side() {
        let cylinder = Cylinder { axis_z: -50.0 };
        let near = |[x, y, z]: [f64; 3], turn: f64, expected: [f64; 3]| {
            let got = cylinder.roll([x, y, z], turn);
            assert!(got.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-9), "{got:?}");
        };
        near([7.0, 0.0, -2.0], 0.0, [7.0, 0.0, -2.0]);
        near([7.0, 0.0, -2.0], 90.0, [7.0, -48.0, -50.0]);
        near([7.0, 0.0, -2.0], 720.0, [7.0, 0.0, -2.0]);
        near([7.0, 0.0, -2.0], f64::NAN, [7.0, 0.0, -2.0]);
        // As far out as the tool was high, however it is turned: what tells the depth.
        for turn in [0.0, 33.0, 180.0, 271.0] {
            let [_, y, z] = cylinder.roll([7.0, 0.0, -2.0], turn);
            assert!((y.hypot(z - cylinder.axis_z()) + cylinder.axis_z() + 2.0).abs() < 1e-9);
        }
        assert_eq!((Cylinder::chords(0.0), Cylinder::chords(-90.0)), (1, 30));
        assert_eq!((Cylinder::chords(f64::NAN), Cylinder::chords(1e300)), (1, 4096));
    }
}
