//! Straight moves, and where the zero is.

use super::file::SbpPrinter;
use super::places::fields;
use super::speeds;
use kerf_program::{AXES, Axes, Axis, AxisSet, Frame, Line, MoveKind};

pub(super) fn straight(p: &mut SbpPrinter<'_>, line: &Line) {
    let from = p.places.position;
    settle_height(p, line, from);
    let named = p.places.changes(line.to);
    p.places.position = line.to;
    if named.iter().all(Option::is_none) {
        return;
    }
    let delta = line.to.minus(from);
    speeds::speed(p, line.kind, line.feed, delta.0[0].hypot(delta.0[1]), delta);
    let text = move_words(line.kind, &named);
    p.line(&text);
}

/// After a change of tools the tool may stand higher than the program knows: before it cuts it
/// goes to where it should be. A jog may start from above.
fn settle_height(p: &mut SbpPrinter<'_>, line: &Line, from: Axes) {
    if line.kind == MoveKind::Cut {
        lower(p);
    } else if line.to[Axis::Z] != from[Axis::Z] {
        p.places.raised = false;
    }
}

/// Brings the tool to the height that the program knows.
pub(super) fn lower(p: &mut SbpPrinter<'_>) {
    if std::mem::take(&mut p.places.raised) {
        let z = p.places.values(p.places.position)[Axis::Z.index()].clone();
        p.line(&format!("JZ,{z}"));
        p.places.wrote(Axis::Z, z);
    }
}

/// Nothing moves: the present place is called otherwise.
pub(super) fn locate(p: &mut SbpPrinter<'_>, frame: Frame, working: AxisSet) {
    let before = p.places.frame;
    let moved = working
        .iter()
        .filter(|a| frame.working_zero[*a] != before.working_zero[*a])
        .fold(AxisSet::EMPTY, AxisSet::with);
    if !moved.is_empty() {
        // The height that it goes down to is one of the zero before.
        lower(p);
    }
    p.places.frame = frame;
    if moved.is_empty() {
        return;
    }
    let values = p.places.values(p.places.position);
    let mut named: [Option<String>; AXES] = Default::default();
    for axis in moved.iter() {
        let value = values[axis.index()].clone();
        p.places.wrote(axis, value.clone());
        named[axis.index()] = Some(value);
    }
    if named[5].take().is_some() {
        p.unsaid_motion("a new zero of C");
    }
    let text = fields("VA", &named[..5]);
    p.line(&text);
}

/// The present place is called by what it is in the table base coordinates, which the program does not move:
/// `%(1)+%(6)` is where the tool stands in them.
pub(super) fn locate_in_machine(p: &mut SbpPrinter<'_>, frame: &Frame, axes: AxisSet) {
    lower(p);
    let mut named: [Option<String>; AXES] = Default::default();
    for axis in axes.iter().filter(|axis| axis.index() < 5) {
        let ahead = p.places.zero_at(axis, frame);
        let number = axis.index() + 1;
        named[axis.index()] = Some(format!("%({number})+%({}){ahead}", number + 5));
    }
    let text = fields("VA", &named[..5]);
    p.line(&text);
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
