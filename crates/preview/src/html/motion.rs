//! Motion as the page reads it: a chain of points with facts for each piece between two of them.
//!
//! Little-endian, without gaps: the points (`f32` × 3, from the middle of the motion, one more than
//! pieces), the same points on the cylinder when there is a rotary axis, the source line of each
//! piece (`u32`), the time at its end (`f32`, when times are
//! given), its kind (`u8`). Arcs are cut into chords here, and only here.

use super::roll::Cylinder;
use crate::picture::{arc, place};
use crate::scene::{Scene, Segment};
use kerf_geom::Bounds3;
use kerf_program::MoveKind;

/// The most chords of one arc; a bound for arcs of very many turns.
const MOST_CHORDS: f64 = 4096.0;

/// Kind of a piece.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    /// Nothing: the next segment starts elsewhere.
    Gap = 0,
    Cut = 1,
    Jog = 2,
}

/// The chain and what belongs to each piece.
#[derive(Clone, Debug, Default)]
pub struct Motion {
    points: Vec<[f32; 3]>,
    /// The points on the cylinder; empty without one.
    rolled: Vec<[f32; 3]>,
    cylinder: Option<Cylinder>,
    lines: Vec<u32>,
    times_s: Vec<f32>,
    kinds: Vec<u8>,
    /// First piece of each segment of the scene.
    pub first_piece: Vec<u32>,
    /// The place that points are measured from, mm.
    pub middle: [f64; 3],
    /// Reach of the motion, mm.
    pub bounds: Bounds3,
    has_times: bool,
}

impl Motion {
    /// Cuts the scene's drawable segments into pieces, arcs within `chord_mm`.
    pub fn of(scene: &Scene, chord_mm: f64) -> Self {
        let bounds = reach(scene);
        let size = bounds.size();
        let middle = match bounds.is_empty() {
            true => [0.0; 3],
            false => std::array::from_fn(|i| bounds.min[i] + 0.5 * size[i]),
        };
        let has_times = !scene.segments.is_empty() && scene.times_s.len() == scene.segments.len();
        let cylinder = Cylinder::of(scene, &bounds);
        let mut motion = Self { bounds, middle, has_times, cylinder, ..Self::default() };
        let mut last = None;
        let mut clock = 0.0_f32;
        for (i, segment) in scene.segments.iter().enumerate() {
            motion.first_piece.push(motion.kinds.len() as u32);
            let end = scene
                .times_s
                .get(i)
                .copied()
                .filter(|t| t.is_finite())
                .map_or(clock, |t| clock.max(t));
            if segment.is_drawable() {
                let turn = scene.turns_deg.get(i).map_or([0.0; 2], |t| t.map(f64::from));
                motion.start(segment, last, clock, turn[0]);
                motion.segment(segment, chord_mm, [clock, end], turn);
                last = Some(segment.to);
            }
            clock = end;
        }
        motion
    }

    /// Returns the number of pieces.
    pub fn len(&self) -> usize {
        self.kinds.len()
    }

    /// Returns `true` if the motion has planned times.
    pub fn has_times(&self) -> bool {
        self.has_times
    }

    /// Lowest and highest place on the cylinder, mm.
    pub fn rolled_box(&self) -> Option<[[f64; 3]; 2]> {
        let reach = |pick: fn(f64, f64) -> f64| {
            std::array::from_fn(|i| {
                let places = self.rolled.iter().map(|p| f64::from(p[i]) + self.middle[i]);
                places.reduce(pick).unwrap_or_default()
            })
        };
        (!self.rolled.is_empty()).then(|| [reach(f64::min), reach(f64::max)])
    }

    /// Height of the axis of the cylinder, mm.
    pub fn axis_z(&self) -> Option<f64> {
        self.cylinder.map(|cylinder| cylinder.axis_z())
    }

    fn start(&mut self, segment: &Segment, last: Option<[f64; 3]>, time: f32, turn_deg: f64) {
        match last {
            None => self.point(segment.from, turn_deg),
            Some(at) if at != segment.from => {
                self.point(segment.from, turn_deg);
                self.piece(segment.line, time, Kind::Gap);
            }
            Some(_) => {}
        }
    }

    fn segment(
        &mut self,
        segment: &Segment,
        chord_mm: f64,
        [start, end]: [f32; 2],
        [turn, turned]: [f64; 2],
    ) {
        let kind = match segment.kind {
            MoveKind::Cut => Kind::Cut,
            MoveKind::Jog => Kind::Jog,
        };
        let rolls = self.cylinder.map_or(1, |_| Cylinder::chords(turned - turn));
        let count = chords(segment, chord_mm).max(rolls);
        for k in 1..=count {
            let share = f64::from(k) / f64::from(count);
            let time = start + (end - start) * share as f32;
            self.point(place(segment, share), turn + (turned - turn) * share);
            self.piece(segment.line, time, kind);
        }
    }

    fn point(&mut self, place: [f64; 3], turn_deg: f64) {
        self.points.push(self.relative(place));
        if let Some(cylinder) = self.cylinder {
            self.rolled.push(self.relative(cylinder.roll(place, turn_deg)));
        }
    }

    fn piece(&mut self, line: u32, time: f32, kind: Kind) {
        self.lines.push(line);
        self.kinds.push(kind as u8);
        if self.has_times {
            self.times_s.push(time);
        }
    }

    fn relative(&self, place: [f64; 3]) -> [f32; 3] {
        std::array::from_fn(|i| (place[i] - self.middle[i]) as f32)
    }

    /// The bytes in the order told above.
    pub fn bytes(&self) -> Vec<u8> {
        let mut bytes = Vec::with_capacity(21 * self.kinds.len() + 12);
        bytes.extend(self.points.iter().flatten().flat_map(|v| v.to_le_bytes()));
        bytes.extend(self.rolled.iter().flatten().flat_map(|v| v.to_le_bytes()));
        bytes.extend(self.lines.iter().flat_map(|v| v.to_le_bytes()));
        bytes.extend(self.times_s.iter().flat_map(|v| v.to_le_bytes()));
        bytes.extend_from_slice(&self.kinds);
        bytes
    }
}

fn reach(scene: &Scene) -> Bounds3 {
    let mut bounds = Bounds3::default();
    for segment in scene.segments.iter().filter(|s| s.is_drawable()) {
        crate::picture::reach(segment, &mut bounds);
    }
    bounds
}

/// So many chords stay within `chord_mm` of an arc: a chord over the angle a is off by
/// r·(1 − cos(a/2)).
fn chords(segment: &Segment, chord_mm: f64) -> u32 {
    let Some(arc) = arc(segment) else { return 1 };
    let radius = arc.radius();
    let off = (chord_mm.max(1e-6) / radius.max(1e-9)).min(0.5);
    let most_rad = 2.0 * (1.0 - off).acos();
    (arc.sweep_rad.abs() / most_rad).ceil().clamp(1.0, MOST_CHORDS) as u32
}

/// Base64 with padding (RFC 4648, section 4).
pub fn base64(bytes: &[u8]) -> String {
    const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut out = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for group in bytes.chunks(3) {
        let byte = |i: usize| u32::from(group.get(i).copied().unwrap_or(0));
        let bits = byte(0) << 16 | byte(1) << 8 | byte(2);
        for k in 0..4 {
            let letter = LETTERS[(bits >> (18 - 6 * k)) as usize & 63];
            out.push(if k <= group.len() { char::from(letter) } else { '=' });
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Shape;

    fn segment(from: [f64; 3], to: [f64; 3], shape: Shape, line: u32) -> Segment {
        Segment { kind: MoveKind::Cut, from, to, shape, line }
    }

    #[test]
    fn base64_is_padded() {
        for (bytes, text) in
            [("", ""), ("f", "Zg=="), ("fo", "Zm8="), ("foo", "Zm9v"), ("foob", "Zm9vYg==")]
        {
            assert_eq!(base64(bytes.as_bytes()), text);
        }
    }

    #[test]
    fn a_jump_is_a_gap_and_what_cannot_be_drawn_is_none() {
        let line = |a, b, n| segment(a, b, Shape::Line, n);
        let scene = Scene {
            segments: vec![
                line([0.0; 3], [2.0, 0.0, 0.0], 1),
                line([2.0, 0.0, 0.0], [f64::NAN, 0.0, 0.0], 2),
                line([2.0, 2.0, 0.0], [4.0, 4.0, 4.0], 3),
            ],
            times_s: vec![1.0, f32::NAN, 3.0],
            ..Scene::default()
        };
        let motion = Motion::of(&scene, 0.1);
        assert_eq!(motion.kinds, [1, 0, 1]);
        assert_eq!(motion.lines, [1, 3, 3]);
        assert_eq!(motion.times_s, [1.0, 1.0, 3.0]);
        assert_eq!(motion.first_piece, [0, 1, 1]);
        assert_eq!(motion.middle, [2.0; 3]);
        assert_eq!(motion.points.last(), Some(&[2.0; 3]));
        assert_eq!(motion.bytes().len(), 4 * 12 + 3 * 4 + 3 * 4 + 3);
    }

    #[test]
    fn chords_keep_their_distance() {
        let arc = Shape::Arc { centre: [0.0, 0.0], sweep_rad: std::f64::consts::TAU };
        let scene = Scene {
            segments: vec![segment([50.0, 0.0, 0.0], [50.0, 0.0, -5.0], arc, 1)],
            ..Scene::default()
        };
        let motion = Motion::of(&scene, 0.02);
        for pair in motion.points.windows(2) {
            let middle = [0, 1].map(|i| f64::from(pair[0][i] + pair[1][i]) / 2.0);
            let off = 50.0 - middle[0].hypot(middle[1]);
            assert!((-1e-4..=0.0201).contains(&off), "{off}");
        }
        assert!(motion.len() < 130, "{}", motion.len());
        assert_eq!(motion.bounds.min, [-50.0, -50.0, -5.0]);
    }
}
