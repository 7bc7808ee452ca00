//! LinuxCNC's "naive CAM detector" (G64 Q): straight feeds that stay within a tolerance of one line
//! are made as that line.

use crate::moves::{Move, Path};
use kerf_program::MoveKind;

/// So many points are looked at before a line ends in any case.
const MOST: usize = 100;

/// Returns the number of moves, from the first on, that become one line.
pub(super) fn merged(moves: &[Move], tolerance_mm: f64) -> usize {
    let feeds = |m: &Move| m.kind == MoveKind::Cut && m.path == Path::Line && flat(m);
    if !moves.first().is_some_and(feeds) {
        return 1;
    }
    let mut count = 1;
    while let Some(next) = moves.get(count).filter(|m| feeds(m)) {
        let same_feed = (next.speed_mm_s - moves[0].speed_mm_s).abs() < 1e-9 * next.speed_mm_s;
        if !same_feed || count >= MOST || !fits(&moves[..=count], tolerance_mm) {
            break;
        }
        count += 1;
    }
    count
}

/// Returns `true` if only X, Y and Z move.
fn flat(m: &Move) -> bool {
    m.from.0[3..] == m.to.0[3..]
}

/// Returns `true` if the points between lie near the line from the first to the last, and between its ends.
fn fits(moves: &[Move], tolerance_mm: f64) -> bool {
    let (from, to) = (moves[0].from.first3(), moves[moves.len() - 1].to.first3());
    let minus = |a: [f64; 3], b: [f64; 3]| [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let along = minus(to, from);
    let mm = dot(along, along).sqrt();
    mm > 0.0
        && moves[1..].iter().all(|m| {
            let place = minus(m.from.first3(), from);
            let way = dot(place, along) / mm;
            let off_sqr = dot(place, place) - way * way;
            (0.0..=mm).contains(&way) && off_sqr <= tolerance_mm * tolerance_mm
        })
}
