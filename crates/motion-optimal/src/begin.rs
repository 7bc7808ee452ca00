//! Beginnings of a window of path: at rest, or in the motion that the window before found.

use crate::launch::Launch;
use crate::pieces::Piece;
use crate::speed_piece::SpeedPiece;

/// Pieces that differ by no more than this share are the same.
const SAME: f64 = 1e-6;

/// Beginning of a window's path.
#[derive(Clone, Debug)]
pub(crate) enum Begin {
    Rest,
    /// In motion, by ways that are within the limits; to rest, if they lead there.
    Motion(Vec<SpeedPiece>, Option<Launch>),
}

impl Begin {
    /// The first ways of the motion with which it begins.
    pub fn kept(&self, way_mm: f64) -> &[SpeedPiece] {
        let Self::Motion(ways, _) = self else { return &[] };
        let mut at = 0.0;
        let count = ways.iter().take_while(|way| {
            at += way.h;
            at <= way_mm
        });
        &ways[..count.count()]
    }

    /// The squared speeds, in the middle of pieces, of the motion with which it begins.
    pub fn before<const N: usize>(&self, at_mm: f64, pieces: &[Piece<N>]) -> Vec<f64> {
        let Self::Motion(ways, _) = self else { return Vec::new() };
        let (mut ways, mut at) = (ways.iter().peekable(), at_mm);
        let sample = |piece: &Piece<N>| {
            let middle = piece.at_mm + 0.5 * piece.h;
            while let Some(way) = ways.next_if(|way| at + way.h <= middle) {
                at += way.h;
            }
            let way = ways.peek()?;
            if (at - piece.at_mm).abs() < SAME * way.h && (way.h - piece.h).abs() < SAME * way.h {
                return Some(way.x[1]);
            }
            let (u, [a, b, c]) = ((middle - at) / way.h, way.x);
            Some((1.0 - u) * ((1.0 - u) * a + 2.0 * u * b) + u * u * c)
        };
        pieces.iter().map_while(sample).collect()
    }
}
