//! Two lists of moves side by side.

use super::canon::Move;

/// Most distance between two places, mm: rounding to four decimals of an inch, of place and offsets.
const CLOSE_MM: f64 = 0.006;

fn close(a: &[f64; 6], b: &[f64; 6]) -> bool {
    a.iter().zip(b).all(|(a, b)| (a - b).abs() < CLOSE_MM)
}

/// The first difference between two lists of moves.
pub fn difference(ours: &[Move], theirs: &[Move]) -> Option<String> {
    let (mut i, mut j) = (0, 0);
    let mut at = [0.0; 6];
    loop {
        let still = |m: Option<&Move>, at: &[f64; 6]| {
            m.is_some_and(|m| matches!(m, Move::Straight { to, .. } if close(to, at)))
        };
        // Moves that go nowhere are given by one and not by the other.
        while still(theirs.get(j), &at) && !same(ours.get(i), theirs.get(j)) {
            j += 1;
        }
        while still(ours.get(i), &at) && !same(ours.get(i), theirs.get(j)) {
            i += 1;
        }
        match (ours.get(i), theirs.get(j)) {
            (None, None) => return None,
            (Some(_), Some(Move::Other { to })) => {
                // Chords stand for it; the last of them ends where it ends.
                let chords = ours[i..].iter().position(|m| close(m.to(), to));
                let Some(chords) = chords else {
                    return Some(format!("no end of {:?}", theirs[j]));
                };
                i += chords;
            }
            (a, b) if same(a, b) => {}
            (a, b) => return Some(format!("move {j}: ours {a:?}, theirs {b:?}, from {at:?}")),
        }
        at = *theirs[j].to();
        i += 1;
        j += 1;
    }
}

fn same(a: Option<&Move>, b: Option<&Move>) -> bool {
    match (a, b) {
        (Some(Move::Straight { jog: a, to: p }), Some(Move::Straight { jog: b, to: q })) => {
            a == b && close(p, q)
        }
        (
            Some(Move::Arc { to: p, centre: c, turns: a }),
            Some(Move::Arc { to: q, centre: d, turns: b }),
        ) => {
            // They count whole turns: 1 is anything up to a turn.
            let near = (c[0] - d[0]).hypot(c[1] - d[1]) < CLOSE_MM;
            close(p, q) && near && (a.abs() - 1e-6).ceil() == b.abs() && a.signum() == b.signum()
        }
        _ => false,
    }
}
