//! The canonical calls that `rs274` writes, as moves of the machine.

/// A move in the machine frame, mm.
#[derive(Clone, Debug)]
pub enum Move {
    Straight {
        jog: bool,
        to: [f64; 6],
    },
    Arc {
        to: [f64; 6],
        centre: [f64; 2],
        turns: f64,
    },
    /// An arc in another plane, or a curve: only its end is compared.
    Other {
        to: [f64; 6],
    },
}

impl Move {
    /// End of the move.
    pub fn to(&self) -> &[f64; 6] {
        match self {
            Self::Straight { to, .. } | Self::Arc { to, .. } | Self::Other { to } => to,
        }
    }
}

/// The canonical calls as moves of the machine.
pub fn parse(text: &str) -> Vec<Move> {
    let mut state = Canon { unit: 1.0, ..Canon::default() };
    let mut moves = Vec::new();
    for line in text.lines() {
        let Some((head, rest)) = line.split_once('(') else { continue };
        let name = head.rsplit(' ').next().unwrap_or_default();
        let numbers: Vec<f64> =
            rest.split([',', ')', ' ']).filter_map(|n| n.trim().parse().ok()).collect();
        let six = |from: usize| -> [f64; 6] {
            std::array::from_fn(|i| numbers.get(from + i).copied().unwrap_or_default())
        };
        match name {
            "USE_LENGTH_UNITS" => {
                let unit = if rest.contains("INCHES") { 25.4 } else { 1.0 };
                state.unit = unit;
            }
            "SET_G5X_OFFSET" => state.g5x = state.mm(six(1)),
            "SET_G92_OFFSET" => state.g92 = state.mm(six(0)),
            "SET_XY_ROTATION" => state.rotation = numbers[0],
            "USE_TOOL_LENGTH_OFFSET" => state.tool = state.mm(six(0)),
            "SELECT_PLANE" => state.plane = rest.trim_end_matches(')').to_owned(),
            "STRAIGHT_TRAVERSE" => {
                moves.push(Move::Straight { jog: true, to: state.machine(six(0)) });
            }
            "STRAIGHT_FEED" | "STRAIGHT_PROBE" => {
                moves.push(Move::Straight { jog: false, to: state.machine(six(0)) });
            }
            "ARC_FEED" => moves.push(state.arc(&numbers)),
            _ => {}
        }
    }
    moves
}

#[derive(Default)]
struct Canon {
    unit: f64,
    g5x: [f64; 6],
    g92: [f64; 6],
    rotation: f64,
    tool: [f64; 6],
    plane: String,
    last: std::cell::Cell<[f64; 6]>,
}

impl Canon {
    fn mm(&self, mut values: [f64; 6]) -> [f64; 6] {
        values[..3].iter_mut().for_each(|v| *v *= self.unit);
        values
    }

    fn machine(&self, values: [f64; 6]) -> [f64; 6] {
        let place = self.mm(values);
        let mut p: [f64; 6] = std::array::from_fn(|i| place[i] + self.g92[i]);
        let (sin, cos) = self.rotation.to_radians().sin_cos();
        (p[0], p[1]) = (p[0] * cos - p[1] * sin, p[0] * sin + p[1] * cos);
        let p = std::array::from_fn(|i| p[i] + self.g5x[i] + self.tool[i]);
        self.last.set(p);
        p
    }

    fn arc(&self, n: &[f64]) -> Move {
        let mut to = [0.0, 0.0, 0.0, n[6], n[7], n[8]];
        let axes = if self.plane.contains("XZ") {
            [2, 0, 1]
        } else if self.plane.contains("YZ") {
            [1, 2, 0]
        } else {
            [0, 1, 2]
        };
        (to[axes[0]], to[axes[1]], to[axes[2]]) = (n[0], n[1], n[5]);
        let end = self.machine(to);
        if axes[2] != 2 {
            return Move::Other { to: end };
        }
        let mut centre = to;
        (centre[0], centre[1]) = (n[2], n[3]);
        let centre = self.machine(centre);
        self.last.set(end);
        Move::Arc { to: end, centre: [centre[0], centre[1]], turns: n[4] }
    }
}
