//! A shop in inches: builds stacks the way the rows of the ledger are written.
#![allow(dead_code)] // each test file uses its own part

use kerf_motion::{Move, Mover, Plan, plan_stack};
use kerf_program::settings::MM_PER_INCH as INCH;
use kerf_program::{Arc, At, Axes, Feed, Line, MoveKind, Settings};

/// A stack under construction, inches and inches a second.
pub struct Shop {
    pub settings: Settings,
    mover: Mover,
    moves: Vec<Move>,
}

/// The settings of the rows: `VS,xy,z` and the defaults of VR.
pub fn vs(xy: f64, z: f64) -> Shop {
    let mut settings = Settings::default();
    settings.speeds.cut.xy = xy * INCH;
    settings.speeds.cut.z = z * INCH;
    Shop::new(settings)
}

impl Shop {
    pub fn new(settings: Settings) -> Self {
        let mover = Mover::new(Axes::default(), &settings);
        Self { settings, mover, moves: Vec::new() }
    }

    /// Changes settings from here on.
    pub fn set(mut self, change: impl FnOnce(&mut Settings)) -> Self {
        change(&mut self.settings);
        self.mover.settings(&self.settings);
        self
    }

    fn line(mut self, kind: MoveKind, to: Axes, feed: Feed) -> Self {
        let line = Line { kind, to, feed };
        self.moves.extend(self.mover.line(At::default(), &line));
        self
    }

    /// M3
    pub fn m3(self, x: f64, y: f64, z: f64) -> Self {
        self.line(MoveKind::Cut, Axes::xyz(x * INCH, y * INCH, z * INCH), Feed::Axis)
    }

    /// M3 with a feed along the path, inches a second.
    pub fn g1(self, x: f64, y: f64, z: f64, feed: f64) -> Self {
        self.line(MoveKind::Cut, Axes::xyz(x * INCH, y * INCH, z * INCH), Feed::Path(feed * INCH))
    }

    /// J3
    pub fn j3(self, x: f64, y: f64, z: f64) -> Self {
        self.line(MoveKind::Jog, Axes::xyz(x * INCH, y * INCH, z * INCH), Feed::Axis)
    }

    /// MX
    pub fn mx(self, x: f64) -> Self {
        let [_, y, z] = self.here();
        self.m3(x, y, z)
    }

    /// MZ
    pub fn mz(self, z: f64) -> Self {
        let [x, y, _] = self.here();
        self.m3(x, y, z)
    }

    /// A straight move by a distance in a direction, degrees counter-clockwise from X.
    pub fn ray(self, degrees: f64, length: f64) -> Self {
        let [x, y, z] = self.here();
        let (sin, cos) = degrees.to_radians().sin_cos();
        self.m3(x + length * cos, y + length * sin, z)
    }

    /// A curve to the left made of equal chords, which begins along a direction.
    pub fn chords(mut self, from: f64, to: f64, radius: f64, n: u32) -> Self {
        let step = (to - from) / f64::from(n);
        let chord = 2.0 * radius * (step.to_radians() / 2.0).sin();
        for k in 0..n {
            self = self.ray(from + step * (f64::from(k) + 0.5), chord);
        }
        self
    }

    /// A true arc to the left about a centre, degrees.
    pub fn arc(mut self, cx: f64, cy: f64, sweep: f64, small: bool) -> Self {
        let [x, y, z] = self.here();
        let (sin, cos) = sweep.to_radians().sin_cos();
        let to = Axes::xyz(
            (cx + (x - cx) * cos - (y - cy) * sin) * INCH,
            (cy + (x - cx) * sin + (y - cy) * cos) * INCH,
            z * INCH,
        );
        let arc = Arc {
            kind: MoveKind::Cut,
            centre: [cx * INCH, cy * INCH],
            sweep_rad: sweep.to_radians(),
            to,
            feed: Feed::Axis,
            chords: 64,
            small,
        };
        self.moves.extend(self.mover.arc(At::default(), &arc));
        self
    }

    pub fn here(&self) -> [f64; 3] {
        self.mover.position().first3().map(|v| v / INCH)
    }

    pub fn plan(self) -> Plan {
        plan_stack(self.moves, &self.settings.ramps)
    }
}

/// Speeds at which the joints of a plan are passed, in/s, beginning with its start.
pub fn joints(plan: &Plan) -> Vec<f64> {
    let mut speeds: Vec<f64> = plan.iter().map(|s| s.v_entry / INCH).collect();
    speeds.extend(plan.iter().last().map(|s| s.v_exit / INCH));
    speeds
}

/// Highest speed of each move, in/s.
pub fn peaks(plan: &Plan) -> Vec<f64> {
    plan.iter().map(|s| s.v_peak / INCH).collect()
}

/// Asserts that numbers agree to a tolerance.
#[track_caller]
pub fn near(got: &[f64], expected: &[f64], tolerance: f64) {
    let close = |(a, b): (&f64, &f64)| (a - b).abs() <= tolerance;
    let agree = got.len() == expected.len() && got.iter().zip(expected).all(close);
    assert!(agree, "{got:?} is not {expected:?}");
}
