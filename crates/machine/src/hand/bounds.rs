//! Ways of a move by hand, and the bounds they must keep.

use super::Hand;
use super::errand::{Errand, FAR, Stretch};
use crate::homing::{bounds_by_hand, soft_bounds, table_bounds, words_of_end};
use kerf_diag::{Code, Diagnostic, SourcePlace};
use kerf_geom::{Arc2, Point2};
use kerf_program::settings::Mode;
use kerf_program::{AXES, Axes, Axis, rounded};
use std::collections::VecDeque;
use std::sync::Arc;

/// Places closer than this are the same, mm or degrees.
pub(super) const SAME: f64 = 1e-9;

/// Bounds of an axis that has none.
const FREE: (f64, f64) = (f64::NEG_INFINITY, f64::INFINITY);

/// A way to a place, machine frame.
#[derive(Clone, Copy, Debug)]
pub(super) struct Leg {
    pub to: Axes,
    /// The arc in X and Y; else it is straight.
    pub arc: Option<Arc2>,
}

impl From<Axes> for Leg {
    fn from(to: Axes) -> Self {
        Self { to, arc: None }
    }
}

impl Hand {
    /// Returns its ways, one after the other.
    pub(super) fn ways(&mut self) -> VecDeque<Leg> {
        if let Errand::Along(stretches) = &self.errand {
            return self.along(stretches);
        }
        self.straight_ways().into_iter().map(Leg::from).collect()
    }

    fn straight_ways(&mut self) -> VecDeque<Axes> {
        let here = self.position;
        let job = &self.machine.job;
        match self.errand {
            Errand::FindHome(_) | Errand::Along(_) | Errand::WarmUp(_) => VecDeque::new(),
            Errand::Home(axes) => {
                let mut up = here;
                if axes.contains(Axis::Z) {
                    up[Axis::Z] = 0.0;
                }
                let mut home = up;
                axes.iter().for_each(|axis| home[axis] = 0.0);
                [up, home].into()
            }
            Errand::Origin => self.over_the_table([0.0; 2]),
            Errand::Finish => self.over_the_table(job.finish_mm),
            Errand::CutMoveTo(place) => self.over_the_table(place),
            Errand::To { place, relative, flat } => {
                let mut to = here;
                for (axis, value) in Axis::ALL.into_iter().zip(place) {
                    let Some(value) = value else { continue };
                    let zero = match axis {
                        _ if relative => here[axis],
                        Axis::X => job.origin_mm[0],
                        Axis::Y => job.origin_mm[1],
                        _ => 0.0,
                    };
                    to[axis] = zero + value;
                }
                let mut level = to;
                if flat {
                    (2..AXES).for_each(|i| level.0[i] = here.0[i]);
                }
                [level, to].into()
            }
            Errand::Held(held) => {
                let way = held.way.map(f64::from);
                [self.as_far_as_allowed(way, FAR)].into()
            }
            Errand::Keypad(keypad) => {
                [self.as_far_as_allowed(keypad.way, keypad.times.unwrap_or(FAR))].into()
            }
        }
    }

    /// Lines and arcs from the job origin.
    fn along(&self, stretches: &[Stretch]) -> VecDeque<Leg> {
        let [x0, y0] = self.machine.job.origin_mm;
        let on_table = |at: Point2| Point2::new(x0 + at.x, y0 + at.y);
        let mut to = self.position;
        let leg = |stretch: &Stretch| {
            let end = on_table(stretch.path.end());
            (to[Axis::X], to[Axis::Y]) = (end.x, end.y);
            to[Axis::Z] = stretch.z_mm.unwrap_or(to[Axis::Z]);
            let on_table = |arc: Arc2| Arc2 {
                start: on_table(arc.start),
                centre: on_table(arc.centre),
                ..arc
            };
            Leg { to, arc: stretch.path.arc().map(on_table) }
        };
        stretches.iter().map(leg).collect()
    }

    /// Up to Z top where the tool is lower, then to a place from the job origin.
    fn over_the_table(&self, [x, y]: [f64; 2]) -> VecDeque<Axes> {
        let [x0, y0] = self.machine.job.origin_mm;
        let mut up = self.position;
        up[Axis::Z] = up[Axis::Z].max(self.machine.zpos.top_mm);
        let mut there = up;
        (there[Axis::X], there[Axis::Y]) = (x0 + x, y0 + y);
        [up, there].into()
    }

    /// Returns the place to which a held key leads: the first bound on its way.
    fn as_far_as_allowed(&mut self, way: [f64; AXES], most: f64) -> Axes {
        let ways = Axis::ALL.into_iter().zip(way);
        let mut far = most;
        for (axis, way) in ways.clone().filter(|(_, way)| *way != 0.0) {
            let (low, high) = self.allowed(axis);
            let end = if way > 0.0 { high } else { low };
            let room = ((end - self.position[axis]) / way).max(0.0);
            if room < far {
                far = room;
                self.note = Some(self.ends_at(axis, end));
            }
        }
        let mut to = self.position;
        ways.for_each(|(axis, way)| to[axis] += way * far);
        to
    }

    /// Returns the message at the end of an axis; at the keypad in the words and units of part files.
    fn ends_at(&self, axis: Axis, end: f64) -> Arc<str> {
        if !matches!(self.errand, Errand::Keypad(_)) {
            let name = self.machine.motors.axis_name(axis);
            return format!("Out of bounds: {name} ends at {end:.3}").into();
        }
        let shown = self.settings.to_user(self.frame.working(Axes::splat(end)))[axis];
        let shown = rounded(shown, 4);
        let words = words_of_end(&self.machine, axis, end);
        format!("Out of bounds: {} ends at {shown}{words}", axis.letter()).into()
    }

    /// Returns the range of an axis, machine frame: the soft bounds, the table limits while they are checked,
    /// Z no lower than Z bottom, and no farther than the machine reaches.
    fn allowed(&self, axis: Axis) -> (f64, f64) {
        let by_hand = |homed| bounds_by_hand(&self.machine, axis, homed);
        let (mut low, mut high) = match self.errand {
            Errand::Held(held) if held.sets_bottom => {
                soft_bounds(&self.machine, axis).unwrap_or(FREE)
            }
            Errand::Keypad(keypad) => by_hand(keypad.homed.contains(axis)),
            _ => by_hand(true),
        };
        if let Some((lowest, highest)) = table_bounds(&self.machine, axis) {
            let zero = self.frame.base_zero[axis];
            (low, high) = (low.max(lowest + zero), high.min(highest + zero));
        }
        if let Some((least, most)) = self.reach[axis.index()] {
            (low, high) = (low.max(least), high.min(most));
        }
        (low, high)
    }

    /// Refuses a move that leads out of bounds, with the reason.
    pub(super) fn refusal(&self) -> Option<Box<Diagnostic>> {
        if matches!(self.errand, Errand::Keypad(_)) && self.settings.mode == Mode::Preview {
            let place = SourcePlace::line(self.errand.name().into(), 0);
            let why =
                Diagnostic::new(Code::NotSupported, place, "the keypad moves nothing in preview");
            return Some(Box::new(why.hint("SM sets Move/Cut mode")));
        }
        if self.is_held() {
            return None;
        }
        let (outside, reached) = self.places().into_iter().find_map(|to| {
            let axis = Axis::ALL.into_iter().find(|axis| {
                let (low, high) = self.allowed(*axis);
                let moves = (to[*axis] - self.position[*axis]).abs() > SAME;
                moves && !(low - SAME..=high + SAME).contains(&to[*axis])
            })?;
            Some((axis, to[axis]))
        })?;
        let (low, high) = self.allowed(outside);
        let name = self.machine.motors.axis_name(outside);
        let message = format!("Out of bounds: {name} would reach {reached:.3}");
        let hint = format!("{name} goes from {low:.3} to {high:.3}");
        let place = SourcePlace::line(self.errand.name().into(), 0);
        Some(Box::new(Diagnostic::new(Code::OutsideLimits, place, message).hint(hint)))
    }

    /// The places that must be within bounds: the end of the way, all of one that is followed.
    fn places(&self) -> Vec<Axes> {
        if !matches!(self.errand, Errand::Along(_)) {
            return self.legs.back().map(|leg| leg.to).into_iter().collect();
        }
        let mut places = Vec::new();
        for leg in &self.legs {
            places.push(leg.to);
            let mut reaches = |at: Point2| {
                let mut place = leg.to;
                (place[Axis::X], place[Axis::Y]) = (at.x, at.y);
                places.push(place);
            };
            leg.arc.iter().for_each(|arc| arc.extremes(&mut reaches));
        }
        places
    }
}
