//! The shapes of the bumps with which corners are smoothed.

/// The shape of the smoothing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Kernel {
    /// Curvature jumps: for motion limited in acceleration.
    #[default]
    Box,
    /// Curvature is continuous: for motion limited in jerk.
    Triangle,
}

/// A turn sharper than this, as change of the unit tangent, is a corner and not part of a curve.
const SHARP: f64 = 0.2;

/// Triangles of which the kernel of a corner is made: share of the area and of the width.
///
/// Together they are a broken line through the kernel of the fastest corner between axes limited in
/// jerk alone, K ∝ (1 − u²)/(1 + u²)³ at s ∝ u + u³/3, where one axis stops with its full jerk while
/// the other starts with its own.
pub(crate) const CORNER: [(f64, f64); PARTS] = [
    (0.25355, 1.0),
    (0.06040, 0.94),
    (0.08027, 0.88),
    (0.11670, 0.8),
    (0.14087, 0.7),
    (0.14475, 0.6),
    (0.12888, 0.5),
    (0.08639, 0.4),
    (0.02653, 0.3),
    (-0.01581, 0.2),
    (-0.02253, 0.1),
];

/// Share of the first and last segment on which the path is straight, for the way from rest.
const LAUNCH_SHARE: f64 = 0.25;

/// Triangles that a kernel has at most.
pub(crate) const PARTS: usize = 11;

impl Kernel {
    /// The triangles of which the kernel for a turn is made.
    pub fn parts(self, turn: f64) -> [(f64, f64); PARTS] {
        let mut parts = [(0.0, 1.0); PARTS];
        let made = self.triangles(turn);
        parts[..made.len()].copy_from_slice(made);
        parts
    }

    /// The same, without those that have no area.
    fn triangles(self, turn: f64) -> &'static [(f64, f64)] {
        if self.is_corner(turn) { &CORNER } else { &[(1.0, 1.0)] }
    }

    /// Returns `true` if the kernel for a turn is that of a corner.
    pub fn is_corner(self, turn: f64) -> bool {
        self == Self::Triangle && turn * turn > SHARP * SHARP
    }

    /// The bump of half-width `c` at a distance, and its derivative by the half-width.
    pub fn bump(self, turn: f64, c: f64, distance: f64) -> (f64, f64) {
        if self == Self::Box {
            let left = c - distance;
            return (left * left / (4.0 * c), left * (c + distance) / (4.0 * c * c));
        }
        let mut sum = (0.0, 0.0);
        for (share, width) in self.triangles(turn) {
            let (c, left) = (c * width, c * width - distance);
            if left > 0.0 {
                let square = share * left * left / (6.0 * c * c);
                sum.0 += square * left;
                sum.1 += width * square * (c + 2.0 * distance) / c;
            }
        }
        sum
    }

    /// The share of the way to a stop over which a bump may reach: with limited jerk the first bit
    /// of path from rest must be straight.
    pub const fn straight_ends(self) -> f64 {
        match self {
            Self::Box => 1.0,
            Self::Triangle => 1.0 - LAUNCH_SHARE,
        }
    }

    /// The half-width of a bump of height 1.
    pub fn width(self, turn: f64) -> f64 {
        match self {
            Self::Box => 4.0,
            Self::Triangle => {
                6.0 / self.triangles(turn).iter().map(|(share, width)| share * width).sum::<f64>()
            }
        }
    }

    /// Value, slope and curvature of the bump at an offset from its vertex, where the tangent turns by
    /// so much squared; at the vertex itself the sign of the offset tells the side.
    pub fn shape(self, turn_square: f64, c: f64, offset: f64) -> [f64; 3] {
        let side = -offset.signum();
        let triangle = |share: f64, c: f64| {
            let left = (c - offset.abs()).max(0.0);
            let scale = share / (c * c);
            let area = scale * left * left;
            [area * left / 6.0, side * 0.5 * area, scale * left]
        };
        match self {
            Self::Box => {
                let left = c - offset.abs();
                [left * left / (4.0 * c), side * left / (2.0 * c), 0.5 / c]
            }
            Self::Triangle if turn_square <= SHARP * SHARP => triangle(1.0, c),
            Self::Triangle => CORNER.iter().fold([0.0; 3], |sum, (share, width)| {
                let part = triangle(*share, c * width);
                std::array::from_fn(|k| sum[k] + part[k])
            }),
        }
    }
}
