//! From the units of a plotter file to millimetres: IP, SC and RO.

use kerf_geom::{Point2, Vec2};

/// Millimetres of a plotter unit: 1016 are an inch.
const UNIT_MM: f64 = 0.025;

/// Map of places of the file onto the paper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Scale {
    /// P1 and P2 in plotter units, when IP has set them.
    corners: Option<[Point2; 2]>,
    /// The numbers of SC.
    user: Option<User>,
    /// Quarter turns.
    turns: u8,
    origin: Vec2,
    per_unit: Vec2,
}

/// User units: the places that P1 and P2 have in them, or with `factors` the size of one.
#[derive(Clone, Copy, Debug, PartialEq)]
struct User {
    low: Point2,
    high: Point2,
    kind: Kind,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    Stretched,
    Alike,
    Factors,
}

impl Default for Scale {
    fn default() -> Self {
        let (origin, per_unit) = (Vec2::default(), Vec2::new(1.0, 1.0));
        Self { corners: None, user: None, turns: 0, origin, per_unit }
    }
}

/// Places of P1 and P2, in plotter units, of a plotter with A4 paper when the file does not say.
const PAPER: [Point2; 2] = [Point2::new(603.0, 521.0), Point2::new(10603.0, 7721.0)];

impl Scale {
    /// IP: P1 and P2; without numbers those of the paper.
    pub fn corners(&mut self, numbers: &[f64]) {
        self.corners = match *numbers {
            [x1, y1, x2, y2, ..] => Some([Point2::new(x1, y1), Point2::new(x2, y2)]),
            [x, y, ..] => {
                let [low, high] = self.corners.unwrap_or(PAPER);
                Some([Point2::new(x, y), Point2::new(x, y) + (high - low)])
            }
            _ => None,
        };
        self.settle();
    }

    /// SC: user units; without numbers plotter units again. False if they have no size.
    pub fn user(&mut self, numbers: &[f64]) -> bool {
        let before = self.user;
        self.user = match *numbers {
            [x1, x2, y1, y2, ref rest @ ..] => Some(User {
                low: Point2::new(x1, y1),
                high: Point2::new(x2, y2),
                kind: match rest.first() {
                    Some(1.0) => Kind::Alike,
                    Some(2.0) => Kind::Factors,
                    _ => Kind::Stretched,
                },
            }),
            _ => None,
        };
        let good = self.settle();
        if !good {
            self.user = before;
            self.settle();
        }
        good
    }

    /// RO: the paper turned, degrees.
    pub fn turn(&mut self, degrees: f64) {
        self.turns = ((degrees / 90.0).round().rem_euclid(4.0)) as u8;
    }

    fn settle(&mut self) -> bool {
        let Some(user) = self.user else {
            (self.origin, self.per_unit) = (Vec2::default(), Vec2::new(1.0, 1.0));
            return true;
        };
        let [low, high] = self.corners.unwrap_or(PAPER);
        let (paper, span) = (high - low, user.high - user.low);
        let mut per_unit = match user.kind {
            Kind::Factors => Vec2::new(user.high.x, user.high.y),
            _ => Vec2::new(paper.x / span.x, paper.y / span.y),
        };
        if user.kind == Kind::Alike {
            let least = per_unit.x.abs().min(per_unit.y.abs());
            per_unit = Vec2::new(least.copysign(per_unit.x), least.copysign(per_unit.y));
        }
        let spare = match user.kind {
            // What the smaller scale leaves of the paper is divided to both sides.
            Kind::Alike => {
                Vec2::new(paper.x - span.x * per_unit.x, paper.y - span.y * per_unit.y) * 0.5
            }
            _ => Vec2::default(),
        };
        let origin = low - Point2::new(user.low.x * per_unit.x, user.low.y * per_unit.y) + spare;
        let good = per_unit.x.is_normal() && per_unit.y.is_normal();
        if good {
            (self.origin, self.per_unit) = (origin, per_unit);
        }
        good
    }

    /// Tells whether circles stay circles.
    pub fn keeps_circles(&self) -> bool {
        let Vec2 { x, y } = self.per_unit;
        (x.abs() - y.abs()).abs() <= 1e-3 * x.abs()
    }

    /// Tells whether the scale turns counter-clockwise into clockwise.
    pub fn mirrors(&self) -> bool {
        self.per_unit.x * self.per_unit.y < 0.0
    }

    /// Millimetres.
    pub fn place(&self, at: Point2) -> Point2 {
        let x = (at.x * self.per_unit.x + self.origin.x) * UNIT_MM;
        let y = (at.y * self.per_unit.y + self.origin.y) * UNIT_MM;
        match self.turns {
            0 => Point2::new(x, y),
            1 => Point2::new(-y, x),
            2 => Point2::new(-x, -y),
            _ => Point2::new(y, -x),
        }
    }

    /// The units of a place in millimetres.
    pub fn units(&self, place: Point2) -> Point2 {
        let Point2 { x, y } = place;
        let (x, y) = match self.turns {
            0 => (x, y),
            1 => (y, -x),
            2 => (-x, -y),
            _ => (-y, x),
        };
        let unit = |mm: f64, origin: f64, per: f64| (mm / UNIT_MM - origin) / per;
        Point2::new(
            unit(x, self.origin.x, self.per_unit.x),
            unit(y, self.origin.y, self.per_unit.y),
        )
    }
}
