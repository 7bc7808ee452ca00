//! A path on the cylinder that a rotary axis about X turns under the tool (command reference, VD and VP: rotary
//! preview), as the page that `kerf preview` writes has it.

use super::path::Path;
use kerf_program::settings::AxisUnit;
use kerf_program::{Axis, Settings};

/// Between two drawn places the work turns no more than this, degrees.
const CHORD_DEG: f64 = 3.0;
/// The most chords of one move; a bound for very many turns.
const MOST_CHORDS: f64 = 4096.0;

/// Returns `true` if a machine that is set so turns work about X: its fifth axis is B, in degrees.
pub fn is_rotary(settings: &Settings) -> bool {
    settings.axis_count > 4 && settings.axis_unit(Axis::B) == AxisUnit::Degrees
}

/// Into how many pieces a move is cut whose work turns so far.
pub fn chords(turn_deg: f64) -> f64 {
    (turn_deg.abs() / CHORD_DEG).ceil().clamp(1.0, MOST_CHORDS)
}

/// The path where it lies on the work, by what that has turned at each vertex, degrees. The axis lies at Y 0 of the
/// working zero; half a blank below its Z 0 where cuts go deeper, and at Z 0 where none do.
pub fn rolled(path: &Path, turns_deg: &[f32], zero: [f64; 3], blank_mm: f64) -> Path {
    let below = path.cut_bounds().is_some_and(|[low, _]| low[2] < zero[2]);
    let axis_z = zero[2] - if below { 0.5 * blank_mm } else { 0.0 };
    path.moved(|vertex, [x, y, z]| {
        let turn_deg = turns_deg.get(vertex).copied().map_or(0.0, f64::from);
        let (sin, cos) = (turn_deg % 360.0).to_radians().sin_cos();
        let (across, height) = (y - zero[1], z - axis_z);
        [x, zero[1] + across * cos - height * sin, axis_z + across * sin + height * cos]
    })
}

#[cfg(test)]
#[allow(clippy::unwrap_used, non_snake_case)]
mod tests {
    use super::super::path::Segment;
    use super::*;
    use kerf_wire::preview::CUT;

    #[test]
    fn work_turns_where_there_is_a_fifth_axis_in_degrees() {
        let mut settings = Settings::default();
        for (axes, unit, turns) in [
            (4, AxisUnit::Degrees, false),
            (5, AxisUnit::Degrees, true),
            (6, AxisUnit::Degrees, true),
            (5, AxisUnit::Linear(settings.linear_unit), false),
        ] {
            settings.axis_count = axes;
            settings.rotary_units[1] = unit;
            assert_eq!(is_rotary(&settings), turns, "{axes} {unit:?}");
        }
    }

    #[test]
    fn sbp_val_vp_rotary__a_quarter_turn_brings_the_top_to_the_side() {
        let check = |z: f64, expected: [f64; 3]| {
            let mut path = Path::new([0.0, 5.0, 10.0], 0.0);
            path.push([7.0, 5.0, z], Segment { end_s: 1.0, line: 1, made: 0, kind: CUT });
            let [low, high] =
                rolled(&path, &[90.0, 90.0], [0.0, 5.0, 10.0], 100.0).cut_bounds().unwrap();
            for (axis, want) in expected.into_iter().enumerate() {
                let near = |at: f64| (at - want).abs() < 1e-3;
                assert!(near(low[axis]) || near(high[axis]), "{low:?} {high:?} {expected:?}");
            }
        };
        // Two millimetres deep in a blank of a hundred: forty-eight from its axis.
        check(8.0, [7.0, 5.0 - 48.0, 10.0 - 50.0]);
        // Nothing is cut below the surface: the axis lies in it.
        check(12.0, [7.0, 5.0 - 2.0, 10.0]);
        assert_eq!((chords(0.0), chords(-90.0), chords(1e300)), (1.0, 30.0, 4096.0));
    }
}
