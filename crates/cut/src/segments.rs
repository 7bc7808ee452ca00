//! Into how many chords a circle is divided (VU circle segment resolution).
//!
//! Kerf keeps circles as arcs; machines that know only lines, and ellipses, use this number. A
//! circle too small for the resolution gets a finer one for itself alone (command reference, CC
//! technical note).

/// The finest resolution there is: .005 in.
pub const MIN_SEGMENT_MM: f64 = 0.127;

/// A whole circle that would have fewer chords than this is divided finer.
pub const MIN_CHORDS: f64 = 63.0;

/// Chords of a whole circle that is divided finer, as far as [`MIN_SEGMENT_MM`] allows.
pub const FINE_CHORDS: f64 = 64.0;

/// Rounding must not add a chord to a count that comes out even.
const COUNT_SLACK: f64 = 1e-9;

/// Chords of a circular path: `circumference_mm` of the whole circle, of which `share` (0 … 1) is cut.
pub fn chord_count(circumference_mm: f64, share: f64, resolution_mm: f64) -> u32 {
    let enough = count(circumference_mm / resolution_mm) >= MIN_CHORDS;
    let wanted = if enough { resolution_mm } else { circumference_mm / FINE_CHORDS };
    let chords = count(circumference_mm * share / wanted.max(MIN_SEGMENT_MM));
    // A float to integer cast saturates, so that no number is too large here.
    (chords as u32).max(1)
}

fn count(chords: f64) -> f64 {
    (chords - COUNT_SLACK).ceil()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    fn chords_of_circle(diameter_in: f64, resolution_in: f64) -> u32 {
        chord_count(PI * diameter_in * 25.4, 1.0, resolution_in * 25.4)
    }

    #[test]
    fn sbp_cut_segments() {
        assert_eq!(chords_of_circle(4.0, 0.05), 252);
        assert_eq!(chords_of_circle(4.0, 0.2), 63);
        assert_eq!(chords_of_circle(4.0, 0.005), 2514);
    }

    #[test]
    fn sbp_cut_seg_downshift() {
        assert_eq!(chords_of_circle(0.1, 0.05), 63);
        assert_eq!(chords_of_circle(1.0, 0.2), 64);
        assert_eq!(chords_of_circle(0.01, 0.05), 7);
    }

    #[test]
    fn odd_numbers_give_a_chord() {
        for odd in [0.0, -1.0, f64::NAN] {
            assert!(chord_count(odd, 1.0, 1.0) >= 1);
            assert!(chord_count(10.0, 1.0, odd) >= 1);
        }
        assert_eq!(chord_count(f64::INFINITY, 1.0, 1.0), u32::MAX);
        assert_eq!(chord_count(100.0, 0.25, 200.0), 16);
    }
}
