//! Straight moves, and where the zero is.

use super::SbpPrinter;
use kerf_program::{AXES, Axes, Axis, AxisSet, Feed, Frame, Line, MoveKind};
use std::fmt::Write as _;

impl SbpPrinter<'_> {
    pub(super) fn straight(&mut self, line: &Line) {
        let from = self.places.position;
        self.settle_height(line, from);
        let named = self.places.changes(line.to);
        self.places.position = line.to;
        if named.iter().all(Option::is_none) {
            return;
        }
        if line.kind == MoveKind::Cut {
            let delta = line.to.minus(from);
            self.speed(line.feed, delta.0[0].hypot(delta.0[1]), delta);
        } else if let Feed::Path(_) | Feed::Time(_) = line.feed {
            self.unsaid("the speed of a jog");
        }
        let text = move_words(line.kind, &named);
        self.line(&text);
    }

    /// After a change of tools the tool may stand higher than the program knows: before it cuts it
    /// goes to where it should be. A jog may start from above.
    fn settle_height(&mut self, line: &Line, from: Axes) {
        if line.kind == MoveKind::Cut {
            self.lower();
        } else if line.to[Axis::Z] != from[Axis::Z] {
            self.places.raised = false;
        }
    }

    /// Brings the tool to the height that the program knows.
    pub(super) fn lower(&mut self) {
        if std::mem::take(&mut self.places.raised) {
            let z = self.places.values(self.places.position)[Axis::Z.index()].clone();
            self.line(&format!("JZ,{z}"));
            self.places.wrote(Axis::Z, z);
        }
    }

    /// Nothing moves: the present place is called otherwise.
    pub(super) fn locate(&mut self, frame: Frame, working: AxisSet) {
        let before = self.places.frame;
        let moved = working
            .iter()
            .filter(|a| frame.working_zero[*a] != before.working_zero[*a])
            .fold(AxisSet::EMPTY, AxisSet::with);
        if !moved.is_empty() {
            // The height that it goes down to is one of the zero before.
            self.lower();
        }
        self.places.frame = frame;
        if moved.is_empty() {
            return;
        }
        let values = self.places.values(self.places.position);
        let mut named: [Option<String>; AXES] = Default::default();
        for axis in moved.iter() {
            let value = values[axis.index()].clone();
            self.places.wrote(axis, value.clone());
            named[axis.index()] = Some(value);
        }
        if named[5].take().is_some() {
            self.unsaid_motion("a new zero of C");
        }
        let text = fields("VA", &named[..5]);
        self.line(&text);
    }

    /// The present place is called by what it is in the table base coordinates, which the program does not move:
    /// `%(1)+%(6)` is where the tool stands in them.
    pub(super) fn locate_in_machine(&mut self, frame: &Frame, axes: AxisSet) {
        self.lower();
        let mut named: [Option<String>; AXES] = Default::default();
        for axis in axes.iter().filter(|axis| axis.index() < 5) {
            let ahead = self.places.zero_at(axis, frame);
            let number = axis.index() + 1;
            named[axis.index()] = Some(format!("%({number})+%({}){ahead}", number + 5));
        }
        let text = fields("VA", &named[..5]);
        self.line(&text);
    }
}

/// A move of the axes that have values: MX for one, M2 … M6 for several.
fn move_words(kind: MoveKind, named: &[Option<String>; AXES]) -> String {
    let letter = if kind == MoveKind::Jog { 'J' } else { 'M' };
    let mut given = (0..AXES).filter(|i| named[*i].is_some());
    let (Some(first), last) = (given.next(), given.next_back()) else { return String::new() };
    match last {
        None => format!(
            "{letter}{},{}",
            Axis::ALL[first].letter(),
            named[first].as_deref().unwrap_or_default()
        ),
        Some(last) => fields(&format!("{letter}{}", last + 1), &named[..=last]),
    }
}

/// A command and its values, empty ones at the end left out.
pub(super) fn fields(command: &str, values: &[Option<String>]) -> String {
    let count = values.iter().rposition(Option::is_some).map_or(0, |last| last + 1);
    let mut text = String::from(command);
    for value in &values[..count] {
        let _ = write!(text, ",{}", value.as_deref().unwrap_or_default());
    }
    text
}
