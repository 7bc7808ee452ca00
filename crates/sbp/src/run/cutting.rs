//! Motion commands out of moves and cuts, through the tab filter where tabs hold.

use super::Context;
use super::state::Origin;
use kerf_cut::{Cut, Step, Tabber};
use kerf_geom::Vec2;
use kerf_program::{Arc, Axes, Axis, Command, Feed, Line, MoveKind};

/// Returns the context that the geometry of a cut needs; places are working millimetres.
pub(crate) fn cut_context(c: &Context<'_>) -> kerf_cut::Context {
    let level = c.core.flow.level();
    kerf_cut::Context {
        zero_z: level.map_or(0.0, |l| l.offset[2]),
        scale: level.map_or([1.0; 3], |l| l.proportion),
        ..kerf_cut::Context::new(c.core.place.working().first3(), c.settings())
    }
}

/// Carries a cut out. Its last pass gets tabs when asked to, or when tabs hold for the file.
pub(crate) fn carry_out(c: &mut Context<'_>, cut: Cut, feature_tab: bool) {
    let Some(pass) = cut.last_pass.clone().filter(|_| feature_tab || c.core.cutting.tabs.is_some())
    else {
        without_tabs(c, &cut.steps);
        c.core.cutting.heading = Some(cut.heading_deg);
        return;
    };
    without_tabs(c, &cut.steps[..pass.start]);
    let own = c.core.cutting.tabs.is_none();
    if own {
        let settings = c.settings();
        c.core.cutting.tabs = Some(Tabber::for_cut(&settings.tabs, settings.cutter.safe_z_mm));
    }
    give_steps(c, &cut.steps[pass.clone()]);
    if own {
        end_tabs(c);
    }
    without_tabs(c, &cut.steps[pass.end..]);
    c.core.cutting.heading = Some(cut.heading_deg);
}

/// Steps that never get tabs; a tabbed path around them is over.
fn without_tabs(c: &mut Context<'_>, steps: &[Step]) {
    if steps.is_empty() {
        return;
    }
    path_over(c);
    let held = c.core.cutting.tabs.take();
    give_steps(c, steps);
    c.core.cutting.tabs = held;
}

fn give_steps(c: &mut Context<'_>, steps: &[Step]) {
    for step in steps {
        give_step(c, *step);
    }
}

fn give_step(c: &mut Context<'_>, step: Step) {
    if c.core.cutting.tabs.is_some() {
        through_tabs(c, step);
        c.core.place.position = machine_of(c, step.to());
    } else {
        plain_step(c, origin(c), step);
    }
}

/// A straight move to a machine position.
pub(crate) fn line(c: &mut Context<'_>, kind: MoveKind, to: Axes) {
    line_at(c, kind, to, Feed::Axis);
}

/// A straight move at a speed.
pub(super) fn line_at(c: &mut Context<'_>, kind: MoveKind, to: Axes, feed: Feed) {
    let from = c.core.place.position;
    if to.same_place(&from) {
        return;
    }
    let delta = Vec2::new(to[Axis::X] - from[Axis::X], to[Axis::Y] - from[Axis::Y]);
    if delta != Vec2::default() {
        c.core.cutting.heading = Some(kerf_geom::vec_to_clock(delta));
    }
    if c.core.cutting.tabs.is_some() {
        if to.0[3..] == from.0[3..] {
            through_tabs(c, Step::Line { kind, to: c.core.place.frame.working(to).first3() });
            c.core.place.position = to;
            return;
        }
        interrupt_tabs(c);
    }
    c.core.place.position = to;
    motion(c, origin(c), Command::Line(Line { kind, to, feed }));
}

fn origin(c: &Context<'_>) -> Origin {
    Origin { at: c.at, step: c.core.given.steps }
}

/// Machine position of working X, Y, Z, the other axes where they are.
fn machine_of(c: &Context<'_>, working: [f64; 3]) -> Axes {
    let mut to = c.core.place.position;
    for (axis, value) in Axis::ALL.into_iter().zip(working) {
        to[axis] = value + c.core.place.frame.working_zero[axis];
    }
    to
}

/// Gives one step as a motion command of the line it comes from.
fn plain_step(c: &mut Context<'_>, origin: Origin, step: Step) {
    let to = machine_of(c, step.to());
    let command = match step {
        Step::Line { kind, .. } => Command::Line(Line { kind, to, feed: Feed::Axis }),
        Step::Arc { centre, sweep_rad, chords, small, .. } => {
            let zero = c.core.place.frame.working_zero;
            let centre = [centre[0] + zero[Axis::X], centre[1] + zero[Axis::Y]];
            Command::Arc(Arc {
                kind: MoveKind::Cut,
                centre,
                sweep_rad,
                to,
                feed: Feed::Axis,
                chords,
                small,
            })
        }
    };
    c.core.place.position = to;
    motion(c, origin, command);
}

fn motion(c: &mut Context<'_>, origin: Origin, command: Command) {
    c.core.given.motions += 1;
    if !c.core.handlers.watches.is_empty() {
        c.core.given.given_by.push(origin.step);
    }
    let here = std::mem::replace(&mut c.at, origin.at);
    c.emit(command);
    c.at = here;
}

fn through_tabs(c: &mut Context<'_>, step: Step) {
    let from = c.core.place.working().first3();
    let origin = origin(c);
    // Whatever the filter holds back has still to be carried out.
    c.core.given.settled = false;
    let_go(c, |tabs, out| tabs.push(from, step, origin, out));
}

/// The path is interrupted but not over: what is buffered goes out.
pub(crate) fn interrupt_tabs(c: &mut Context<'_>) {
    let_go(c, |tabs, out| tabs.flush(out));
}

/// The tabbed path is over, tabs hold on.
fn path_over(c: &mut Context<'_>) {
    let_go(c, |tabs, out| tabs.path_end(out));
}

/// Tabs end.
pub(crate) fn end_tabs(c: &mut Context<'_>) {
    path_over(c);
    c.core.cutting.tabs = None;
}

/// Gives the moves that the tab filter lets go; the planned position stays what it is.
fn let_go(c: &mut Context<'_>, act: impl FnOnce(&mut Tabber<Origin>, &mut Vec<(Origin, Step)>)) {
    let Some(mut tabs) = c.core.cutting.tabs.take() else { return };
    let mut cut = Vec::new();
    act(&mut tabs, &mut cut);
    let planned = c.core.place.position;
    for (origin, step) in cut {
        plain_step(c, origin, step);
    }
    c.core.place.position = planned;
    c.core.cutting.tabs = Some(tabs);
}
