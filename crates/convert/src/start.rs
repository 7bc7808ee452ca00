//! The place where a program that is converted begins.
//!
//! Where the tool will stand when the converted file starts is not known. A program that first says
//! where to go must stay so: `J2,0,0` in the first line is a move, although a machine at zero would
//! not stir. So a program is followed from a place a hair beside zero, where no program goes by
//! itself. If everything it does is the same from zero, it says all its places itself, and what it
//! did from the odd place is what is written. A program that goes on from where the tool stands is
//! followed from zero, and that is told.

use crate::item::{Item, Passage};
use kerf_program::{AXES, At, Axes, Axis, AxisSet, Command, Sourced};

/// A place a hair beside zero, mm and degrees.
pub const ODD: Axes =
    Axes([0.013_717_31, 0.017_391_13, 0.021_933_71, 0.011_171_37, 0.019_131_73, 0.015_317_19]);
/// Places that differ by less are one, mm or degrees.
const SAME: f64 = 1e-9;

/// Returns `true` if a program does from the odd place what it does from zero.
pub fn says_its_places(odd: &Passage, zero: &Passage) -> bool {
    let mut plain = zero.commands().filter(|s| s.command.is_motion()).peekable();
    let mut here = Axes::default();
    for sourced in odd.commands().filter(|s| s.command.is_motion()) {
        let to = without_odd(end(&sourced.command));
        let next = plain.peek().map(|s| &s.command);
        if next.is_some_and(|next| same_command(&sourced.command, next, to)) {
            plain.next();
        } else if !same(here, to) || matches!(sourced.command, Command::Arc(_)) {
            return false;
        }
        here = to;
    }
    plain.next().is_none() && others(odd) == others(zero)
}

/// Of each change of zero, in order, its line and the axes whose zero comes to lie at the same place of the
/// machine wherever the program begins (G10 L2), while it has not said where the tool is: no place of the tool
/// tells it.
pub fn zeros_in_machine(odd: &Passage, zero: &Passage) -> Vec<(At, AxisSet)> {
    let mut others = zero.commands().filter_map(moved_zero).peekable();
    let (mut here, mut other, mut found) = (ODD, Axes::default(), Vec::new());
    for sourced in odd.commands() {
        if sourced.command.is_motion() {
            here = end(&sourced.command);
        }
        let Some((at, there, axes)) = moved_zero(sourced) else { continue };
        // From zero, what makes the present place zero changes nothing.
        if let Some((_, zero, _)) = others.next_if(|(line, ..)| *line == at) {
            other = zero;
        }
        let fixed = |axis: &Axis| here[*axis] == ODD[*axis] && there[*axis] == other[*axis];
        found.push((at, axes.iter().filter(fixed).fold(AxisSet::EMPTY, AxisSet::with)));
    }
    found
}

const fn moved_zero(sourced: &Sourced) -> Option<(At, Axes, AxisSet)> {
    match &sourced.command {
        Command::Location { frame, working, .. } => {
            Some((sourced.at, frame.working_zero, *working))
        }
        _ => None,
    }
}

/// Returns `true` if its height is said before it matters: a change of tools leaves the tool higher than it was, and
/// an arc is written with how far it goes down.
pub fn says_its_height(odd: &Passage) -> bool {
    let (mut height, mut raised) = (ODD[Axis::Z], false);
    for Sourced { command, .. } in odd.commands() {
        if matches!(command, Command::ToolChange { begin: false }) {
            raised = height == ODD[Axis::Z];
        }
        if !command.is_motion() {
            continue;
        }
        let to = end(command)[Axis::Z];
        let unsaid = height == ODD[Axis::Z];
        let sinks = matches!(command, Command::Arc(_)) && to != height;
        if unsaid && (raised && to == height || sinks) {
            return false;
        }
        height = to;
    }
    true
}

/// Counts the things it does besides moving.
fn others(passage: &Passage) -> usize {
    let motion = |item: &&Item| matches!(item, Item::Command(s) if s.command.is_motion());
    passage.items.iter().filter(|item| !motion(item)).count()
}

/// A place as it is from zero: axes that the program has not named yet still are where they began.
fn without_odd(mut place: Axes) -> Axes {
    for i in 0..AXES {
        if place.0[i] == ODD.0[i] {
            place.0[i] = 0.0;
        }
    }
    place
}

const fn end(command: &Command) -> Axes {
    match command {
        Command::Line(line) => line.to,
        Command::Arc(arc) => arc.to,
        _ => ODD,
    }
}

fn same(a: Axes, b: Axes) -> bool {
    a.0.iter().zip(b.0).all(|(a, b)| (a - b).abs() <= SAME)
}

fn same_command(odd: &Command, zero: &Command, to: Axes) -> bool {
    match (odd, zero) {
        (Command::Line(_), Command::Line(line)) => same(to, line.to),
        (Command::Arc(a), Command::Arc(b)) => {
            same(to, b.to)
                && (a.centre[0] - b.centre[0]).abs() <= SAME
                && (a.centre[1] - b.centre[1]).abs() <= SAME
                && (a.sweep_rad - b.sweep_rad).abs() <= SAME
        }
        _ => false,
    }
}
