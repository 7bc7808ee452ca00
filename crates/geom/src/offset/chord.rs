//! What is quickly known of a segment, and of several in a row.

use crate::segment::square;
use crate::{Point2, Segment};

/// Ends of a segment and how far it strays from the line between them: what is quickly known of it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Chord {
    start: Point2,
    end: Point2,
    /// By so much the square of the distance of the segment may be less than that of its nearer end, where it
    /// is less than the limit.
    slack: f64,
}

impl Chord {
    /// For limits of no more than a distance.
    ///
    /// A place whose nearer end is e away is at least √(e² − c²/4) from the chord of length c, and the path is
    /// as near to the chord as it rises above it.
    pub fn of(segment: &Segment, most: f64) -> Self {
        let (start, end) = (segment.start(), segment.end());
        let quarter = 0.25 * square(end - start);
        let rise = match *segment {
            Segment::Line { .. } => 0.0,
            // r − √(r² − c²/4), and the other side of the centre for more than half a circle.
            Segment::Arc { radius, sweep_rad, .. } => {
                let high = (radius * radius - quarter).max(0.0).sqrt();
                let long = sweep_rad.abs() > std::f64::consts::PI;
                if long { radius + high } else { quarter / (radius + high) }
            }
        };
        Self { start, end, slack: quarter + rise * (most + most + rise) }
    }

    /// Returns `false` only if the segment is no nearer to a place than a limit, of which the square is given.
    pub fn may_be_nearer(&self, place: Point2, limit_squared: f64) -> bool {
        let nearer = square(self.start - place).min(square(self.end - place));
        nearer < limit_squared + self.slack
    }
}

/// So many segments are looked at together.
pub(super) const BLOCK: usize = 8;
/// Their starts, the end of the last, and one more to make the number even.
const PLACES: usize = BLOCK + 2;

/// The ends of neighbouring segments, in the order in which processors like to have them.
#[derive(Clone, Copy)]
pub(super) struct Block {
    x: [f64; PLACES],
    y: [f64; PLACES],
    /// The greatest slack of its segments; without bound where they do not follow each other.
    slack: f64,
}

impl Block {
    pub fn of(chords: &[Chord]) -> Self {
        let last = chords.last().map_or(Point2::default(), |chord| chord.end);
        let (mut x, mut y) = ([last.x; PLACES], [last.y; PLACES]);
        for (n, chord) in chords.iter().enumerate() {
            (x[n], y[n]) = (chord.start.x, chord.start.y);
        }
        let broken = chords.windows(2).any(|pair| pair[0].end != pair[1].start);
        let most = if broken { f64::INFINITY } else { 0.0 };
        let slack = chords.iter().map(|chord| chord.slack).fold(most, f64::max);
        Self { x, y, slack }
    }

    pub fn may_be_nearer(&self, place: Point2, limit_squared: f64) -> bool {
        let most = limit_squared + self.slack;
        let mut near = false;
        for (x, y) in self.x.iter().zip(&self.y) {
            let (x, y) = (x - place.x, y - place.y);
            near |= x * x + y * y < most;
        }
        near
    }
}
