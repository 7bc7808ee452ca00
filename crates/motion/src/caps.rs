//! The highest speed of each move and of each joint between moves; see [`ShopBot`](crate::ShopBot)
//! for the rules.

use crate::ahead::Ahead;
use crate::corner::{FULL_CORNER_RAD, SLIGHTEST_RAD, corner_speed, is_full};
use crate::course::Course;
use crate::moves::{Move, Path};
use crate::profile::Profile;
use crate::turns::{Bend, BendAt, full_stretches, sum_turns};
use kerf_program::Axis;
use kerf_program::settings::{MM_PER_INCH, Ramps};
use std::f64::consts::TAU;
use std::ops::Range;

/// A curve that turns by a full corner on a smaller radius needs a full ramp at any speed.
const FULL_CURVE_RADIUS_MM: f64 = 0.25 * MM_PER_INCH;

/// The path on which such a curve makes its turn.
const FULL_CURVE_MM: f64 = FULL_CURVE_RADIUS_MM * FULL_CORNER_RAD;

/// An arc of a smaller radius rounds a corner. Guess.
const FILLET_RADIUS_MM: f64 = 0.05 * MM_PER_INCH;

/// The most that a closed circle counts as turning within the minimum distance: three of the 64
/// chords into which a small circle is cut, as the default minimum distance is three default chords.
/// Sharper circles are the business of the small circle size.
const CIRCLE_TURN_RAD: f64 = 3.0 * TAU / 64.0;

/// Slighter changes of direction are no bends of their own; they still add to the heading.
const BEND_RAD: f64 = 1e-5;

/// Shares of the axes that differ by less are the same; rounding, not a change of speed.
const SAME_SHARE: f64 = 1e-9;

/// So many bends are gathered before their turns are summed: enough that the few at the edges,
/// which are summed twice, do not matter, and few enough to stay near the processor.
pub(crate) const BLOCK: usize = 1 << 12;

/// Caps under construction. The fields of a [`Profile`] hold them: at the start, inside, at the end.
#[derive(Clone, Debug)]
pub(crate) struct Caps {
    ramps: Ramps,
    /// Bends that may still matter, in order.
    bends: Vec<Bend>,
    /// So many of them make a block.
    block: usize,
    /// Moves since bends were summed: where bends are rare, moves do not wait for a block of them.
    waits: usize,
    /// So many of them have limited arcs, and joints.
    done: [usize; 2],
    window_mm: f64,
    at_mm: f64,
    heading_rad: f64,
    /// The course of the last move.
    before: Option<Course>,
}

impl Caps {
    /// For a stack that is planned with these ramps, with so many bends a block.
    pub fn new(ramps: &Ramps, block: usize) -> Self {
        Self {
            ramps: *ramps,
            bends: Vec::new(),
            block,
            waits: 0,
            done: [0; 2],
            window_mm: ramps.min_distance_mm.max(0.0),
            at_mm: 0.0,
            heading_rad: 0.0,
            before: None,
        }
    }

    /// The last of some moves that were made: those whose bends count for what comes.
    pub fn reach_back<'m>(ramps: &Ramps, made: &'m [Move]) -> &'m [Move] {
        let mut left_mm = ramps.min_distance_mm.max(0.0) + FULL_CURVE_MM;
        let near = made.iter().rev().take(BLOCK).take_while(|m| {
            let near = left_mm > 0.0;
            left_mm -= m.length_mm;
            near
        });
        &made[made.len() - near.count()..]
    }

    /// Goes along the moves that are new, so many at most: collects bends, limits changes of speed and long arcs, and
    /// what directions change where enough is known.
    pub fn walk(&mut self, ahead: &mut Ahead, most: usize) {
        let known = ahead.caps.len();
        ahead.caps.reserve(ahead.moves.len() - known);
        for i in known..ahead.moves.len().min(known.saturating_add(most)) {
            let m = &ahead.moves[i];
            let course = Course::of(m);
            ahead.caps.push(alone(m));
            match self.before {
                Some(before) if i > 0 && m.continues(&ahead.moves[i - 1]) => {
                    self.joint(ahead, i, &before, &course);
                }
                // Far away: no window reaches across.
                _ => self.at_mm += 2.0 * (self.window_mm + FULL_CURVE_MM),
            }
            let m = &ahead.moves[i];
            let way_mm = m.length_mm * course.xy;
            if let Path::Arc { sweep_rad, .. } = m.path {
                self.arc(ahead, i, sweep_rad, way_mm, course.xy);
                self.heading_rad += sweep_rad;
            }
            self.at_mm += way_mm;
            self.before = Some(course);
            self.waits += 1;
            let waits = self.waits >= BLOCK && self.done[1] < self.bends.len();
            if waits || self.bends.len() >= self.block {
                self.settle(ahead);
                self.waits = 0;
            }
        }
    }

    /// The stack is complete: limits what is left.
    pub fn finish(&mut self, ahead: &mut Ahead) {
        self.limit_turns(ahead, [self.bends.len(); 2]);
    }

    /// Returns the number of moves of the window whose caps no later move can change.
    pub fn settled(&self, ahead: &Ahead) -> usize {
        let known = ahead.caps.len();
        let open = self.bends.get(self.done[1]);
        let open = open.map_or(known, |bend| ahead.index(bend.place.number()));
        // A bend limits the move before it as well, and so does the next move the last one.
        open.min(known).saturating_sub(1)
    }

    fn joint(&mut self, ahead: &mut Ahead, i: usize, before: &Course, after: &Course) {
        let (m, last) = (&ahead.moves[i], &ahead.moves[i - 1]);
        let ramp = m.ramp_mm_s.min(last.ramp_mm_s);
        let cap = self.step_limit(before, after).max(ramp);
        ahead.caps[i - 1].v_exit = cap;
        ahead.caps[i].v_entry = cap;
        let turn = before.turn_rad(after);
        if turn.abs() > BEND_RAD {
            let place = BendAt::Joint(ahead.number(i));
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

    fn bend(&mut self, at_mm: f64, turn: f64, xy: f64, place: BendAt) {
        self.bends.push(Bend {
            at_mm,
            before_rad: self.heading_rad,
            turn_rad: turn as f32,
            xy: xy as f32,
            place,
        });
    }

    fn arc(&mut self, ahead: &mut Ahead, i: usize, sweep_rad: f64, way_mm: f64, xy: f64) {
        let sweep = sweep_rad.abs();
        let closed = sweep > TAU - BEND_RAD;
        if way_mm <= self.window_mm && !closed {
            let middle_mm = self.at_mm + 0.5 * way_mm;
            let place =
                if way_mm < FILLET_RADIUS_MM * sweep { BendAt::Fillet } else { BendAt::Arc };
            return self.bend(middle_mm, sweep_rad, xy, place(ahead.number(i)));
        }
        let turn = sweep * (self.window_mm / way_mm).min(1.0);
        let tight = is_full(sweep) && way_mm < FULL_CURVE_RADIUS_MM * sweep;
        let turn = match (closed, tight) {
            (true, _) => turn.min(CIRCLE_TURN_RAD),
            (false, true) => turn.max(FULL_CORNER_RAD),
            (false, false) => turn,
        };
        ahead.caps[i].v_peak = self.turning(ahead.caps[i].v_peak, turn as f32, xy as f32);
    }

    /// Limits what no later bend can change any more, and forgets what matters to no later one.
    fn settle(&mut self, ahead: &mut Ahead) {
        // Bends farther apart know nothing of each other.
        let reach_mm = self.window_mm + FULL_CURVE_MM;
        let before = |bends: &[Bend], mm: f64| bends.partition_point(|b| b.at_mm < mm);
        let settled_mm = self.at_mm - reach_mm;
        // The cap of a joint needs that of the arcs beside it, whose middle is within a window.
        let joints = before(&self.bends, settled_mm - self.window_mm);
        self.limit_turns(ahead, [before(&self.bends, settled_mm), joints]);
        let next_mm = self.bends.get(joints).map_or(self.at_mm, |b| b.at_mm);
        // One more: how much of the path a bend stands for depends on its neighbour.
        let past = before(&self.bends, next_mm - reach_mm).saturating_sub(1);
        self.bends.drain(..past);
        self.done = self.done.map(|done| done - past);
        self.block = self.block.max(2 * self.bends.len());
    }

    /// Applies the corner rule to what the direction changes around each bend, for so many bends
    /// that are arcs and joints.
    fn limit_turns(&mut self, ahead: &mut Ahead, [arcs, joints]: [usize; 2]) {
        let (turns, stretches) = self.summed();
        // The speed at a joint depends on that of the move behind it, and so does nothing of the bend behind that.
        for k in joined(&stretches, self.done[1] + 1..self.bends.len().min(joints + 1)) {
            self.limit_between(ahead, k);
        }
        for (k, &turn_rad) in turns.iter().enumerate().take(arcs).skip(self.done[0]) {
            let Bend { place, xy, .. } = self.bends[k];
            if let Some(i) = place.arc() {
                let index = ahead.index(i);
                let cap = &mut ahead.caps[index];
                cap.v_peak = self.turning(cap.v_peak, turn_rad, xy);
            }
        }
        for (k, &turn_rad) in turns.iter().enumerate().take(joints).skip(self.done[1]) {
            if let Bend { place: BendAt::Joint(i), xy, .. } = self.bends[k] {
                self.limit_joint(ahead, ahead.index(i), turn_rad, xy);
            }
        }
        self.done = [arcs, joints];
    }

    fn limit_joint(&self, ahead: &mut Ahead, i: usize, turn_rad: f32, xy: f32) {
        let caps = &mut ahead.caps;
        let v = caps[i].v_peak.min(caps[i - 1].v_peak);
        let cap = self.turning(v, turn_rad, xy);
        caps[i].v_entry = caps[i].v_entry.min(cap);
        caps[i - 1].v_exit = caps[i - 1].v_exit.min(cap);
    }

    /// Keeps the moves between a bend and the one before it at the speed of a full corner: both are in one tight curve.
    fn limit_between(&self, ahead: &mut Ahead, k: usize) {
        let (from, to) = (&self.bends[k - 1], &self.bends[k]);
        let behind = usize::from(from.place.arc().is_some());
        let between = ahead.index(from.place.number()) + behind..ahead.index(to.place.number());
        for cap in ahead.caps.get_mut(between).into_iter().flatten() {
            cap.v_peak = self.turning(cap.v_peak, FULL_CORNER_RAD as f32, from.xy.max(to.xy));
        }
    }

    /// Computes the change of direction around each bend, radians; and the stretches that are tight curves.
    fn summed(&self) -> (Vec<f32>, Vec<(usize, usize)>) {
        let mut turns: Vec<f32> = self.bends.iter().map(|b| b.turn_rad.abs()).collect();
        let greatest = sum_turns(&self.bends, self.window_mm, SLIGHTEST_RAD, &mut turns);
        // A longer stretch is covered by so many of the window, and cannot turn more than they.
        let windows = (FULL_CURVE_MM / self.window_mm).ceil();
        if !is_full(windows * f64::from(greatest)) {
            return (turns, Vec::new());
        }
        let stretches = full_stretches(&self.bends, FULL_CURVE_MM, FULL_CORNER_RAD, is_full);
        for (first, last) in &stretches {
            let within = turns[*first..=*last].iter_mut();
            within.for_each(|turn| *turn = turn.max(FULL_CORNER_RAD as f32));
        }
        (turns, stretches)
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
}

/// The bends, of some, that lie in a stretch together with the bend before. The stretches are in the order of their ends.
fn joined(stretches: &[(usize, usize)], among: Range<usize>) -> Vec<usize> {
    let mut joined = Vec::new();
    let mut end = among.end;
    for &(first, last) in stretches.iter().rev() {
        let new = among.start.max(first + 1)..end.min(last + 1);
        end = end.min(new.start.max(among.start));
        joined.extend(new);
    }
    joined
}

/// The caps of a move by itself: it starts and ends at ramp speed.
fn alone(m: &Move) -> Profile {
    let small = matches!(m.path, Path::Arc { small: true, .. });
    let ramp = m.top_mm_s().min(m.ramp_mm_s);
    let v_peak = if small { ramp } else { m.top_mm_s() };
    Profile { start_s: 0.0, v_entry: ramp, v_peak, v_exit: ramp }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Mover;
    use kerf_program::{Arc, At, Axes, Feed, Line, MoveKind, Settings};

    /// Lines and arcs of all sizes, smooth and rough, with a plunge or a jog now and then.
    fn moves(count: usize, mut seed: u64) -> Vec<Move> {
        let mut random = move || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (seed >> 40) as f64 / (1u64 << 24) as f64
        };
        let mut mover = Mover::new(Axes::default(), &Settings::default());
        let mut heading = 0.0;
        let mut made = Vec::new();
        while made.len() < count {
            let place = mover.position();
            let rough = if made.len() / 50 % 2 == 0 { 0.05 } else { 1.5 };
            heading += (random() - 0.5) * rough;
            let (sin, cos) = f64::sin_cos(heading);
            let step = 3.0 * random() * random();
            let choice = random();
            let kind = if choice < 0.01 { MoveKind::Jog } else { MoveKind::Cut };
            let [x, y, z] = place.first3();
            let next = if choice < 0.9 {
                let plunge = choice < 0.02;
                let [dx, dy] = if plunge { [0.0; 2] } else { [step * cos, step * sin] };
                let to = Axes::xyz(x + dx, y + dy, z + if plunge { 0.5 } else { 0.0 });
                mover.line(At::default(), &Line { kind, to, feed: Feed::Axis })
            } else {
                let (radius, sweep_rad) = (step + 0.1, (random() - 0.5) * 4.0);
                let centre = [x - radius * sin, y + radius * cos];
                let (s, c) = f64::sin_cos(heading + sweep_rad);
                heading += sweep_rad;
                let to = Axes::xyz(centre[0] + radius * s, centre[1] - radius * c, z);
                let (feed, chords) = (Feed::Axis, 8);
                let arc = Arc { kind, centre, sweep_rad, to, feed, chords, small: false };
                mover.arc(At::default(), &arc)
            };
            made.extend(next);
        }
        made
    }

    fn in_blocks(ramps: &Ramps, moves: &[Move], block: usize) -> Vec<Profile> {
        let mut caps = Caps::new(ramps, block);
        let mut ahead = Ahead { moves: moves.to_vec(), ..Ahead::default() };
        caps.walk(&mut ahead, usize::MAX);
        caps.finish(&mut ahead);
        ahead.caps
    }

    #[test]
    fn blocks_give_the_caps_of_the_whole_stack() {
        for (seed, min_distance_mm) in [(1, 3.81), (2, 0.3), (3, 40.0), (4, 0.0), (5, 3.81)] {
            let ramps = Ramps { min_distance_mm, ..Settings::default().ramps };
            let moves = moves(4000, seed);
            let whole = in_blocks(&ramps, &moves, usize::MAX);
            for block in [1, 7, 64, 1000] {
                let found = in_blocks(&ramps, &moves, block);
                assert!(found == whole, "seed {seed}, blocks of {block}");
            }
        }
    }
}
