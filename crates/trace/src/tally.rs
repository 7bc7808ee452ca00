//! Counting what a run does: lengths, bounds, times by kind and by tool path.

use kerf_geom::Bounds3;
use kerf_machine::Lift;
use kerf_motion::{Move, Path};
use kerf_program::{Axes, Axis, Frame, MoveKind, ToolPathStart};
use serde::Serialize;
use std::sync::Arc;

/// Lengths in mm, times in seconds.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tally {
    /// Straight moves made.
    pub moves: u64,
    /// Arcs made.
    pub arcs: u64,
    /// Length of the cutting moves in space.
    pub cut_mm: f64,
    /// Length of the jogs in space.
    pub jog_mm: f64,
    /// Bounds of the cutting moves, working locations, arcs counted exactly.
    pub bounds: Bounds3,
    /// Time cutting, outside tool changes.
    pub cut_s: f64,
    /// Time jogging, outside tool changes.
    pub jog_s: f64,
    /// Time waiting, outside tool changes: pauses, warnings, waiting for an input.
    pub wait_s: f64,
    /// Time in tool changes, of every kind.
    pub tool_change_s: f64,
    /// Named parts in order.
    pub toolpaths: Vec<ToolPathTime>,
    changing: bool,
}

/// A named part of the program and how long it takes.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct ToolPathTime {
    /// Its name.
    pub name: Arc<str>,
    /// The tool, empty when unknown.
    pub tool: Arc<str>,
    /// Time that it takes, s, waiting and tool changes included.
    pub seconds: f64,
    /// Of that, cutting.
    pub cut: f64,
    /// Jogging.
    pub jog: f64,
    /// Waiting.
    pub wait: f64,
    /// Tool changes.
    pub tool_change: f64,
    /// Length of its cutting moves in space, mm: every pass, plunges too.
    #[serde(skip)]
    pub cut_mm: f64,
    /// Number of moves and arcs that were made before it.
    #[serde(skip)]
    pub first_move: u64,
}

impl ToolPathTime {
    /// Returns `true` if a start names this part and no other tool: files repeat it after a tool change.
    fn goes_on(&self, start: &ToolPathStart) -> bool {
        let named = start.name.as_ref().is_some_and(|name| !name.is_empty() && *name == self.name);
        named && start.tool.as_ref().is_none_or(|tool| *tool == self.tool)
    }
}

impl Tally {
    /// A move was made.
    pub fn made(&mut self, made: &Move, seconds: f64, frame: &Frame) {
        let length_mm = match made.path {
            Path::Line | Path::Curve { .. } => {
                self.moves += 1;
                straight(made, [Axis::X, Axis::Y, Axis::Z])
            }
            Path::Arc { .. } => {
                self.arcs += 1;
                let round = made.arc().map_or(0.0, |arc| arc.length());
                round.hypot(made.to[Axis::Z] - made.from[Axis::Z])
            }
        };
        match made.kind {
            MoveKind::Cut => {
                self.cut_mm += length_mm;
                if let Some(path) = self.toolpaths.last_mut() {
                    path.cut_mm += length_mm;
                }
                self.spend(seconds, |t| &mut t.cut_s, |path| &mut path.cut);
                self.grow(made, frame);
            }
            MoveKind::Jog => {
                self.jog_mm += length_mm;
                self.spend(seconds, |t| &mut t.jog_s, |path| &mut path.jog);
            }
        }
    }

    /// Height control carried a cut up and down on the way.
    pub fn carried(&mut self, made: &Move, lift: &Lift, frame: &Frame) {
        if made.kind != MoveKind::Cut || lift.is_still() {
            return;
        }
        let [begin_mm, _] = lift.ends();
        for mm in lift.range() {
            let mut at = made.from;
            at[Axis::Z] += mm - begin_mm;
            self.bounds.add(working(at, frame));
        }
    }

    /// Time passed without motion.
    pub fn waited(&mut self, seconds: f64) {
        self.spend(seconds, |t| &mut t.wait_s, |path| &mut path.wait);
    }

    /// A tool path begins. A start that only names the tool, or only the path, belongs to the part
    /// that has nothing but the other; one that names the same again goes on with it.
    pub fn begins(&mut self, start: &ToolPathStart) {
        let (name, tool) = (start.name.clone(), start.tool.clone());
        if self.toolpaths.last().is_some_and(|last| last.goes_on(start)) {
            return;
        }
        match self.toolpaths.last_mut() {
            Some(last) if last.seconds == 0.0 && (last.name.is_empty() || name.is_none()) => {
                last.name = name.unwrap_or_else(|| last.name.clone());
                last.tool = tool.unwrap_or_else(|| last.tool.clone());
                self.join_same();
            }
            _ => self.toolpaths.push(ToolPathTime {
                name: name.unwrap_or_default(),
                tool: tool.unwrap_or_default(),
                first_move: self.moves + self.arcs,
                ..ToolPathTime::default()
            }),
        }
    }

    /// A part that turns out to be the one before goes on with it.
    fn join_same(&mut self) {
        if let [.., before, last] = &self.toolpaths[..]
            && !last.name.is_empty()
            && (&before.name, &before.tool) == (&last.name, &last.tool)
        {
            self.toolpaths.pop();
        }
    }

    /// A tool change begins or is over.
    pub fn changing(&mut self, begin: bool) {
        self.changing = begin;
    }

    fn spend(
        &mut self,
        seconds: f64,
        kind: impl FnOnce(&mut Self) -> &mut f64,
        of_path: impl FnOnce(&mut ToolPathTime) -> &mut f64,
    ) {
        let changing = self.changing;
        *(if changing { &mut self.tool_change_s } else { kind(self) }) += seconds;
        if let Some(path) = self.toolpaths.last_mut() {
            path.seconds += seconds;
            *(if changing { &mut path.tool_change } else { of_path(path) }) += seconds;
        }
    }

    fn grow(&mut self, made: &Move, frame: &Frame) {
        let mut add = |at: Axes| self.bounds.add(working(at, frame));
        add(made.from);
        add(made.to);
        if let Some(arc) = made.arc() {
            arc.extremes(|p| add(Axes::xyz(p.x, p.y, made.to[Axis::Z])));
        }
    }
}

/// The working location of a place on the machine, mm.
fn working(at: Axes, frame: &Frame) -> [f64; 3] {
    at.minus(frame.working_zero).first3()
}

fn straight(made: &Move, axes: [Axis; 3]) -> f64 {
    let square: f64 = axes.into_iter().map(|a| (made.to[a] - made.from[a]).powi(2)).sum();
    square.sqrt()
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use kerf_motion::Mover;
    use kerf_program::{Arc as ArcMove, At, Feed, Line, Settings};

    fn line(from: Axes, to: Axes, kind: MoveKind) -> Move {
        let line = Line { kind, to, feed: Feed::Axis };
        Mover::new(from, &Settings::default()).line(At::default(), &line).unwrap()
    }

    #[test]
    fn lengths_are_in_space_and_jogs_have_no_bounds() {
        let mut tally = Tally::default();
        let (a, b) = (Axes::default(), Axes::xyz(3.0, 0.0, 4.0));
        tally.made(&line(a, b, MoveKind::Jog), 1.0, &Frame::default());
        assert!(tally.bounds.is_empty());
        tally.made(&line(a, b, MoveKind::Cut), 2.0, &Frame::default());
        assert_eq!((tally.cut_mm, tally.jog_mm, tally.cut_s, tally.jog_s), (5.0, 5.0, 2.0, 1.0));
        assert_eq!(tally.bounds.max, [3.0, 0.0, 4.0]);
    }

    #[test]
    fn bounds_hold_the_bulge_in_working_locations() {
        let arc = ArcMove {
            kind: MoveKind::Cut,
            centre: [10.0, 0.0],
            sweep_rad: -std::f64::consts::PI,
            to: Axes::xyz(20.0, 0.0, 0.0),
            feed: Feed::Axis,
            chords: 8,
            small: false,
        };
        let mut mover = Mover::new(Axes::default(), &Settings::default());
        let mut tally = Tally::default();
        let frame = Frame { working_zero: Axes::xyz(1.0, 1.0, 0.0), ..Frame::default() };
        tally.made(&mover.arc(At::default(), &arc).unwrap(), 1.0, &frame);
        let (min, max) = (tally.bounds.min, tally.bounds.max);
        assert!((max[1] - 9.0).abs() < 1e-9 && (min[0] + 1.0).abs() < 1e-9, "{min:?} {max:?}");
        assert!((tally.cut_mm - 10.0 * std::f64::consts::PI).abs() < 1e-9);
    }

    #[test]
    fn time_belongs_to_the_tool_path_and_the_tool_change() {
        let mut tally = Tally::default();
        let start = |name: Option<&str>, tool: Option<&str>| ToolPathStart {
            name: name.map(Arc::from),
            tool: tool.map(Arc::from),
        };
        tally.waited(1.0);
        tally.begins(&start(Some("Pocket"), None));
        tally.begins(&start(None, Some("End mill")));
        tally.changing(true);
        tally.waited(2.0);
        tally.changing(false);
        tally.waited(4.0);
        tally.begins(&start(Some("Outline"), None));
        assert_eq!((tally.wait_s, tally.tool_change_s), (5.0, 2.0));
        let first = &tally.toolpaths[0];
        assert_eq!((&*first.name, &*first.tool, first.seconds), ("Pocket", "End mill", 6.0));
        assert_eq!((first.wait, first.tool_change), (4.0, 2.0));
        assert_eq!(tally.toolpaths.len(), 2);
    }

    #[test]
    fn a_tool_path_that_is_named_again_goes_on() {
        let mut tally = Tally::default();
        let start = |name: &str, tool: Option<&str>| ToolPathStart {
            name: Some(Arc::from(name)),
            tool: tool.map(Arc::from),
        };
        for (next, count) in [
            (start("Pocket", Some("End mill")), 1),
            (start("Pocket", Some("End mill")), 1),
            (start("Pocket", None), 1),
            (start("Pocket", Some("Ball nose")), 2),
            (start("Outline", Some("Ball nose")), 3),
        ] {
            tally.begins(&next);
            tally.waited(1.0);
            assert_eq!(tally.toolpaths.len(), count, "{next:?}");
        }
        assert_eq!(tally.toolpaths[0].wait, 3.0);
        // Said piece by piece, as some files do.
        let nothing = ToolPathStart { name: None, tool: None };
        let tool = ToolPathStart { name: None, tool: Some("Ball nose".into()) };
        for next in [&nothing, &start("Outline", None), &tool] {
            tally.begins(next);
        }
        assert_eq!(tally.toolpaths.len(), 3);
    }
}
