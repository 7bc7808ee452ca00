//! Tabs: bridges that hold a part, made by lifting the cutter a little along the path (VB).
//!
//! ```text
//!            next          lead size lead       next
//!  Z+up  ·               ·   /‾‾‾‾‾\   ·                 ·
//!  Z     ────────────────────       ────────────────────
//!        s=0              s=next                s=next+period
//! ```
//!
//! `s` is counted along the programmed path in space, through corners and slopes; the profile is
//! added to whatever Z the path has. Counting begins anew when Z comes to Safe-Z. A tab that does
//! not fit in the rest of the path is left out; so a step in which a tab begins is held back until
//! the path has come as far as the tab's end. Nothing else is held back. (Command reference, VB and
//! FP; readings, Tabs, A-88, A-89.)

use crate::CutError;
use crate::error::check_length;
use crate::step::Step;
use kerf_geom::{Arc2, Point2};
use kerf_program::MoveKind;
use kerf_program::settings::Tabs;
use serde::{Deserialize, Serialize};
use std::collections::VecDeque;

/// Path lengths closer than this are the same, so that a tab may end exactly where the path does.
const SAME_LENGTH_MM: f64 = 1e-6;

/// Tabs that follow each other closer than this are a mistake.
const MIN_PERIOD_MM: f64 = 1e-3;

/// The most tabs in one step; a step with room for more passes without any.
const MAX_TABS: f64 = 1.0e5;

/// A filter that adds tabs to a stream of steps.
///
/// Each step carries a tag, for the line of the source it comes from; pieces of a split step keep
/// it. Steps come out in the order in which they went in. Before anything else is put into the
/// stream (an output, a change of speed, a pause), call [`Tabber::flush`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Tabber<T> {
    profile: Profile,
    safe_z: Option<f64>,
    /// Tabs still to insert; `None` without end.
    left: Option<u32>,
    /// Path length at which the next tab begins.
    next_at: f64,
    /// Path length at the end of what was pushed.
    travelled: f64,
    /// Path length at the end of what was given out.
    given: f64,
    /// Place of the tool after what was given out.
    at: [f64; 3],
    held: VecDeque<Held<T>>,
}

/// Lengths along the path and the height of one tab.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
struct Profile {
    up: f64,
    lead: f64,
    size: f64,
    /// Length of a tab: flat and both inclines.
    length: f64,
    /// From the beginning of one tab to that of the next.
    period: f64,
    /// From the beginning of the path to that of the first tab.
    first: f64,
}

/// A step of which a part was not given out yet.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
struct Held<T> {
    from: [f64; 3],
    step: Step,
    tag: T,
    /// Path length at its beginning and end.
    span: [f64; 2],
}

impl<T: Copy> Tabber<T> {
    /// Tabs switched on for a file: with the number of tabs and the distance to the first of VB.
    ///
    /// `safe_z` is in the frame of the steps. Without one, any jog ends the path. Values that
    /// [`Tabber::check`] refuses make no tabs.
    pub fn new(tabs: &Tabs, safe_z: Option<f64>) -> Self {
        let profile = Some(Profile::new(tabs)).filter(|p| Self::check(tabs).is_ok() && p.is_tab());
        let left = if profile.is_some() { tabs.count } else { Some(0) };
        let profile = profile.unwrap_or_default();
        Self {
            profile,
            safe_z,
            left,
            next_at: profile.first,
            travelled: 0.0,
            given: 0.0,
            at: [0.0; 3],
            held: VecDeque::new(),
        }
    }

    /// Tabs of one Cut command with the tab feature: number and first distance do not apply.
    pub fn for_cut(tabs: &Tabs, safe_z: Option<f64>) -> Self {
        Self::new(&Tabs { count: None, start_mm: None, ..*tabs }, safe_z)
    }

    /// Refuses values that make no tabs though they should.
    ///
    /// # Errors
    /// Lengths that are negative, too large or so small that tabs would be everywhere.
    pub fn check(tabs: &Tabs) -> Result<(), CutError> {
        let profile = Profile::new(tabs);
        for (what, value) in [
            ("pull-up of tabs", profile.up),
            ("distance to the next tab", tabs.next_mm),
            ("size of tabs", profile.size),
            ("lead of tabs", profile.lead),
            ("distance to the first tab", profile.first),
        ] {
            check_length(what, value)?;
            if value < 0.0 {
                return Err(CutError::NotPositive { what });
            }
        }
        if profile.period < MIN_PERIOD_MM { Err(CutError::EmptyTabs) } else { Ok(()) }
    }

    /// Returns `true` while more tabs will come.
    pub fn active(&self) -> bool {
        self.left != Some(0)
    }

    /// Takes the next step, which begins at `from`, and gives out what is decided.
    ///
    /// A step of absurd size passes without tabs: one with places that are no numbers, or room for
    /// more than a hundred thousand tabs.
    pub fn push(&mut self, from: [f64; 3], step: Step, tag: T, out: &mut Vec<(T, Step)>) {
        let length = step.length(from);
        let bounded = length <= MAX_TABS * self.profile.period;
        if !self.active() || !bounded || !self.is_below(from, &step) {
            return self.pass_by(step, tag, out);
        }
        if self.held.is_empty() {
            self.at = from;
        }
        let span = [self.travelled, self.travelled + length];
        self.travelled = span[1];
        self.held.push_back(Held { from, step, tag, span });
        self.decide(out);
    }

    /// Takes a step that gets no tabs whatever it is: an earlier pass, a plunge, a way back.
    ///
    /// It ends the path when it leads up to Safe-Z and else only interrupts it.
    pub fn pass_by(&mut self, step: Step, tag: T, out: &mut Vec<(T, Step)>) {
        let jog = matches!(step, Step::Line { kind: MoveKind::Jog, .. });
        if self.is_safe(step.to()[2]) || (jog && self.safe_z.is_none()) {
            self.path_end(out);
        } else {
            self.flush(out);
        }
        out.push((tag, step));
    }

    /// The path is interrupted but not over: gives out everything held; the count goes on.
    ///
    /// A tab that has begun and does not fit any more is left out.
    pub fn flush(&mut self, out: &mut Vec<(T, Step)>) {
        self.give_to(self.travelled, [0.0, 0.0], out);
        let begun = (self.travelled - SAME_LENGTH_MM - self.next_at) / self.profile.period;
        self.next_at += begun.ceil().max(0.0) * self.profile.period;
    }

    /// The path is over: gives out everything held; the next path counts from its beginning.
    pub fn path_end(&mut self, out: &mut Vec<(T, Step)>) {
        self.flush(out);
        (self.travelled, self.given) = (0.0, 0.0);
        self.next_at = self.profile.first;
    }

    /// The path was broken off: what is held never moves; the count goes on from what was given out.
    pub fn drop_buffered(&mut self) {
        self.held.clear();
        self.travelled = self.given;
    }

    /// Cuts with some X or Y motion below Safe-Z.
    fn is_below(&self, from: [f64; 3], step: &Step) -> bool {
        let below = !self.is_safe(from[2]) && !self.is_safe(step.to()[2]);
        below
            && match *step {
                Step::Arc { .. } => true,
                Step::Line { kind, to } => {
                    kind == MoveKind::Cut && (from[..2] != to[..2] || from == to)
                }
            }
    }

    fn is_safe(&self, z: f64) -> bool {
        self.safe_z.is_some_and(|safe| z >= safe - SAME_LENGTH_MM)
    }

    /// Gives out all tabs that fit so far and what lies before the first that may not.
    fn decide(&mut self, out: &mut Vec<(T, Step)>) {
        while self.active() && self.next_at + self.profile.length <= self.travelled + SAME_LENGTH_MM
        {
            self.give_tab(out);
        }
        if !self.active() || self.next_at >= self.travelled - SAME_LENGTH_MM {
            return self.give_to(self.travelled, [0.0, 0.0], out);
        }
        while let Some(whole) = self.held.front().filter(|h| h.span[1] <= self.next_at) {
            self.give_to(whole.span[1], [0.0, 0.0], out);
        }
    }

    fn give_tab(&mut self, out: &mut Vec<(T, Step)>) {
        let Profile { up, lead, size, period, .. } = self.profile;
        let flat = self.next_at + lead;
        self.give_to(self.next_at, [0.0, 0.0], out);
        if lead > 0.0 {
            self.give_to(flat, [0.0, up], out);
        } else {
            self.rise(up, self.held.front().map(|h| h.tag), out);
        }
        self.give_to(flat + size, [up, up], out);
        if lead > 0.0 {
            self.give_to(flat + size + lead, [up, 0.0], out);
        } else {
            self.rise(-up, out.last().map(|(tag, _)| *tag), out);
        }
        self.next_at += period;
        self.left = self.left.map(|n| n.saturating_sub(1));
    }

    /// A side of a tab without incline.
    fn rise(&mut self, by: f64, tag: Option<T>, out: &mut Vec<(T, Step)>) {
        self.at[2] += by;
        let step = Step::Line { kind: MoveKind::Cut, to: self.at };
        out.extend(tag.map(|tag| (tag, step)));
    }

    /// Gives out the held path up to `end`; the height above the programmed path changes evenly
    /// from the first to the second value.
    fn give_to(&mut self, end: f64, height: [f64; 2], out: &mut Vec<(T, Step)>) {
        let begin = self.given;
        while let Some(held) = self.held.front().copied() {
            let whole = held.span[1] <= end + SAME_LENGTH_MM;
            let to = if whole { held.span[1] } else { end };
            if !whole && to <= self.given + SAME_LENGTH_MM {
                return;
            }
            let share = if end > begin { ((to - begin) / (end - begin)).min(1.0) } else { 1.0 };
            let piece = held.piece([self.given, to], height[0] + (height[1] - height[0]) * share);
            self.at = piece.to();
            out.push((held.tag, piece));
            self.given = to;
            if !whole {
                return;
            }
            self.held.pop_front();
        }
    }
}

impl Profile {
    /// Returns `true` if it lifts the tool anywhere.
    fn is_tab(&self) -> bool {
        self.up > 0.0 && self.length > 0.0
    }

    fn new(tabs: &Tabs) -> Self {
        let length = tabs.size_mm + 2.0 * tabs.lead_mm;
        Self {
            up: tabs.up_mm,
            lead: tabs.lead_mm,
            size: tabs.size_mm,
            length,
            period: length + tabs.next_mm,
            first: tabs.start_mm.unwrap_or(tabs.next_mm),
        }
    }
}

impl<T> Held<T> {
    /// The part of the step between two path lengths, its end raised.
    fn piece(&self, part: [f64; 2], raised: f64) -> Step {
        let length = self.span[1] - self.span[0];
        let share = |s: f64| if length > 0.0 { (s - self.span[0]) / length } else { 1.0 };
        let [first, last] =
            [share(part[0]), if part[1] == self.span[1] { 1.0 } else { share(part[1]) }];
        let mut to = self.place(last);
        to[2] += raised;
        match self.step {
            Step::Line { kind, .. } => Step::Line { kind, to },
            Step::Arc { centre, sweep_rad, chords, small, .. } => {
                let cut = last - first;
                let chords = ((f64::from(chords) * cut).ceil() as u32).max(1);
                Step::Arc { centre, sweep_rad: sweep_rad * cut, to, chords, small }
            }
        }
    }

    /// Returns the place of the tool after a share of the step.
    fn place(&self, share: f64) -> [f64; 3] {
        let end = self.step.to();
        if share == 1.0 {
            return end;
        }
        let even = |axis: usize| self.from[axis] + (end[axis] - self.from[axis]) * share;
        match self.step {
            Step::Line { .. } => [even(0), even(1), even(2)],
            Step::Arc { centre, sweep_rad, .. } => {
                let start = Point2::new(self.from[0], self.from[1]);
                let centre = Point2::new(centre[0], centre[1]);
                let at = Arc2 { start, centre, sweep_rad }.at(share);
                [at.x, at.y, even(2)]
            }
        }
    }
}
