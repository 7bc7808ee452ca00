//! Short straight moves that lie on one line, as one order: a line to the controller takes time on its way.

use super::chords::{nearest, speed_mm_s};
use kerf_motion::{Move, Path};

/// The most moves that become one order.
const MOST: usize = 64;

/// Longest time of moves that are sent as one, seconds: the progress of the run is known no closer.
const LONGEST_S: f64 = 0.1;

/// Speeds that differ by less than this share are the same.
const SAME: f64 = 1e-6;

/// Returns the number of the first moves that are made as one straight move: none of their ends lies farther from it than the
/// tolerance, mm, and all have one speed.
pub fn together(moves: &[Move], tolerance_mm: f64) -> usize {
    let Some(first) = moves.first().filter(|first| is_straight(first)) else { return 1 };
    let (mut count, mut seconds) = (1, seconds(first));
    while count < MOST
        && let Some(next) = moves.get(count).filter(|next| continues(first, next))
    {
        seconds += self::seconds(next);
        if seconds > LONGEST_S || !lies_on(&moves[..=count], tolerance_mm) {
            break;
        }
        count += 1;
    }
    count
}

fn is_straight(mv: &Move) -> bool {
    matches!(mv.path, Path::Line) && mv.from != mv.to
}

fn continues(first: &Move, next: &Move) -> bool {
    let [speed, other] = [first, next].map(|mv| speed_mm_s(mv, &[(1.0, mv.to)]));
    let same = (speed - other).abs() <= SAME * speed;
    is_straight(next) && next.kind == first.kind && same
}

fn seconds(mv: &Move) -> f64 {
    mv.length_mm / mv.top_mm_s()
}

/// Tells whether the ends of moves lie on the straight way from the first to the last, one behind the other.
fn lies_on(moves: &[Move], tolerance_mm: f64) -> bool {
    let [first, .., last] = moves else { return true };
    let mut share = 0.0;
    moves.iter().all(|mv| {
        let (far_mm, at) = nearest(first.from, last.to, mv.to);
        let on = far_mm <= tolerance_mm && at >= share;
        share = at;
        on
    })
}
