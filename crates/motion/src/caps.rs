//! The highest speed of each move and of each joint between moves; see [`ShopBot`](crate::ShopBot)
//! for the rules.

use crate::corner::{FULL_CORNER_RAD, SLIGHTEST_RAD, corner_speed, is_full};
use crate::course::Course;
use crate::moves::{Move, Path};
use crate::profile::Profile;
use crate::turns::{Bend, Place, sum_turns};
use kerf_program::Axis;
use kerf_program::settings::{MM_PER_INCH, Ramps};
use std::f64::consts::TAU;

/// A curve that turns by a full corner on a smaller radius needs a full ramp at any speed.
const FULL_CURVE_RADIUS_MM: f64 = 0.25 * MM_PER_INCH;

/// The path on which such a curve makes its turn.
const FULL_CURVE_MM: f64 = FULL_CURVE_RADIUS_MM * FULL_CORNER_RAD;

/// The most that a closed circle counts as turning within the minimum distance: three of the 64
/// chords into which a small circle is cut, as the default minimum distance is three default chords.
/// Sharper circles are the business of the small circle size.
const CIRCLE_TURN_RAD: f64 = 3.0 * TAU / 64.0;

/// Slighter changes of direction are no bends of their own; they still add to the heading.
const BEND_RAD: f64 = 1e-5;

/// Shares of the axes that differ by less are the same; rounding, not a change of speed.
const SAME_SHARE: f64 = 1e-9;

/// A run between full corners that cannot reach this multiple of ramp speed keeps ramp speed, so
/// that a series of very short moves does not surge. The manual gives no number; this is a guess.
const SURGE: f64 = 2.0;

/// Caps under construction. The fields of a [`Profile`] hold them: at the start, inside, at the end.
pub(crate) struct Caps<'a> {
    ramps: &'a Ramps,
    moves: &'a [Move],
    profiles: Vec<Profile>,
    bends: Vec<Bend>,
    window_mm: f64,
    at_mm: f64,
    heading_rad: f64,
}

impl<'a> Caps<'a> {
    /// The caps of a stack.
    pub fn of(ramps: &'a Ramps, moves: &'a [Move]) -> Vec<Profile> {
        let mut caps = Self {
            ramps,
            moves,
            profiles: Vec::with_capacity(moves.len()),
            bends: Vec::with_capacity(moves.len()),
            window_mm: ramps.min_distance_mm.max(0.0),
            at_mm: 0.0,
            heading_rad: 0.0,
        };
        caps.walk();
        caps.limit_turns();
        caps.hold_short_runs();
        caps.profiles
    }

    /// Goes along the path once: collects bends, limits changes of speed and long arcs.
    fn walk(&mut self) {
        let mut before: Option<Course> = None;
        for (i, m) in self.moves.iter().enumerate() {
            let course = Course::of(m);
            self.profiles.push(alone(m));
            match before {
                Some(before) if m.continues(&self.moves[i - 1]) => self.joint(i, &before, &course),
                // Far away: no window reaches across.
                _ => self.at_mm += 2.0 * (self.window_mm + FULL_CURVE_MM),
            }
            let way_mm = m.length_mm * course.xy;
            if let Path::Arc { sweep_rad, .. } = m.path {
                self.arc(i, sweep_rad, way_mm, course.xy);
                self.heading_rad += sweep_rad;
            }
            self.at_mm += way_mm;
            before = Some(course);
        }
    }

    fn joint(&mut self, i: usize, before: &Course, after: &Course) {
        let (m, last) = (&self.moves[i], &self.moves[i - 1]);
        let ramp = m.ramp_mm_s.min(last.ramp_mm_s);
        let cap = self.step_limit(before, after).max(ramp);
        self.profiles[i - 1].v_exit = cap;
        self.profiles[i].v_entry = cap;
        let turn = before.turn_rad(after);
        if turn.abs() > BEND_RAD {
            let place = Place::Joint(i as u32);
            self.bend(self.at_mm, turn, before.xy.max(after.xy), place);
        }
        self.heading_rad += turn;
    }

    /// The speed at which no axis changes its own by more than its ramp speed times the threshold.
    fn step_limit(&self, before: &Course, after: &Course) -> f64 {
        let percent = self.ramps.threshold_3d_percent;
        let limit = |axis, change: f64| match change.abs() {
            change if change < SAME_SHARE => f64::INFINITY,
            change => self.ramps.cut.of(axis) * percent / 100.0 / change,
        };
        let mut v = limit(Axis::X, after.xy - before.xy);
        for (k, axis) in [Axis::Z, Axis::A, Axis::B, Axis::C].into_iter().enumerate() {
            v = v.min(limit(axis, after.others[k] - before.others[k]));
        }
        v
    }

    fn bend(&mut self, at_mm: f64, turn: f64, xy: f64, place: Place) {
        self.bends.push(Bend {
            at_mm,
            before_rad: self.heading_rad,
            turn_rad: turn as f32,
            xy: xy as f32,
            place,
        });
    }

    fn arc(&mut self, i: usize, sweep_rad: f64, way_mm: f64, xy: f64) {
        let sweep = sweep_rad.abs();
        let closed = sweep > TAU - BEND_RAD;
        if way_mm <= self.window_mm && !closed {
            let middle_mm = self.at_mm + 0.5 * way_mm;
            return self.bend(middle_mm, sweep_rad, xy, Place::Arc(i as u32));
        }
        let turn = sweep * (self.window_mm / way_mm).min(1.0);
        let tight = is_full(sweep) && way_mm < FULL_CURVE_RADIUS_MM * sweep;
        let turn = match (closed, tight) {
            (true, _) => turn.min(CIRCLE_TURN_RAD),
            (false, true) => turn.max(FULL_CORNER_RAD),
            (false, false) => turn,
        };
        self.profiles[i].v_peak = self.turning(self.profiles[i].v_peak, turn as f32, xy as f32);
    }

    /// Applies the corner rule to what the direction changes around each bend.
    fn limit_turns(&mut self) {
        let turns = self.summed();
        let bends = std::mem::take(&mut self.bends);
        for (bend, turn) in bends.iter().zip(&turns) {
            if let Place::Arc(i) = bend.place {
                let v = self.profiles[i as usize].v_peak;
                self.profiles[i as usize].v_peak = self.turning(v, *turn, bend.xy);
            }
        }
        for cap in &mut self.profiles {
            cap.v_entry = cap.v_entry.min(cap.v_peak);
            cap.v_exit = cap.v_exit.min(cap.v_peak);
        }
        for (bend, turn) in bends.iter().zip(&turns) {
            if let Place::Joint(i) = bend.place {
                self.limit_joint(i as usize, *turn, bend.xy);
            }
        }
    }

    fn limit_joint(&mut self, i: usize, turn_rad: f32, xy: f32) {
        let v = self.profiles[i].v_peak.min(self.profiles[i - 1].v_peak);
        let cap = self.turning(v, turn_rad, xy);
        self.profiles[i].v_entry = self.profiles[i].v_entry.min(cap);
        self.profiles[i - 1].v_exit = self.profiles[i - 1].v_exit.min(cap);
    }

    /// What the direction changes around each bend, radians.
    fn summed(&self) -> Vec<f32> {
        let mut turns: Vec<f32> = self.bends.iter().map(|b| b.turn_rad.abs()).collect();
        let greatest = sum_turns(&self.bends, self.window_mm, SLIGHTEST_RAD, &mut turns);
        // A longer stretch is covered by so many of the window, and cannot turn more than they.
        let windows = (FULL_CURVE_MM / self.window_mm).ceil();
        if windows > 1.0 && is_full(windows * f64::from(greatest)) {
            self.add_tight_curves(&mut turns);
        }
        turns
    }

    /// Makes a full corner of every bend in a curve that turns by as much on a small radius.
    fn add_tight_curves(&self, turns: &mut [f32]) {
        let mut tight = turns.to_vec();
        sum_turns(&self.bends, FULL_CURVE_MM, SLIGHTEST_RAD, &mut tight);
        for (turn, tight) in turns.iter_mut().zip(tight) {
            if is_full(f64::from(tight)) {
                *turn = tight;
            }
        }
    }

    fn turning(&self, v: f64, turn_rad: f32, xy: f32) -> f64 {
        let turn_rad = f64::from(turn_rad);
        if turn_rad < SLIGHTEST_RAD {
            return v;
        }
        let in_xy = v * f64::from(xy);
        let ramp = self.ramps.cut.xy;
        let slow = corner_speed(in_xy, turn_rad, ramp, self.ramps.slow_corner_percent);
        if slow < in_xy { v * (slow / in_xy) } else { v }
    }

    /// Keeps ramp speed in runs between full corners that are too short to be worth a surge.
    fn hold_short_runs(&mut self) {
        // What the squared speed gains up to the middle of the run and loses again.
        let (mut first, mut gain, mut corner_before) = (0, 0.0, false);
        for (i, m) in self.moves.iter().enumerate() {
            gain += m.accel_mm_s2 * m.length_mm;
            let next = self.moves.get(i + 1).filter(|next| next.continues(m));
            let ramp = next.map(|next| m.ramp_mm_s.max(next.ramp_mm_s) * (1.0 + 1e-9));
            let corner = ramp.is_some_and(|ramp| self.profiles[i].v_exit <= ramp);
            if next.is_some() && !corner {
                continue;
            }
            if corner || corner_before {
                self.hold(first, i, gain);
            }
            (first, gain, corner_before) = (i + 1, 0.0, corner);
        }
    }

    fn hold(&mut self, first: usize, last: usize, gain: f64) {
        let ramp = self.moves[first].ramp_mm_s.max(self.moves[last].ramp_mm_s);
        if gain >= (SURGE * SURGE - 1.0) * ramp * ramp {
            return;
        }
        for i in first..=last {
            let cap = &mut self.profiles[i];
            let v = self.moves[i].ramp_mm_s;
            cap.v_entry = cap.v_entry.min(v);
            cap.v_peak = cap.v_peak.min(v);
            cap.v_exit = cap.v_exit.min(v);
        }
    }
}

/// The caps of a move by itself: it starts and ends at ramp speed.
fn alone(m: &Move) -> Profile {
    let small = matches!(m.path, Path::Arc { small: true, .. });
    let ramp = m.speed_mm_s.min(m.ramp_mm_s);
    let v_peak = if small { ramp } else { m.speed_mm_s };
    Profile { start_s: 0.0, v_entry: ramp, v_peak, v_exit: ramp }
}
