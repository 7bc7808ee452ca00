//! Functions that move the machine.

use super::spec::Step::Number;
use super::spec::{Done, Function, Refusal};
use crate::{ConsoleRequest, View};
use kerf_machine::Errand;
use kerf_machine::settings::axes::W;
use kerf_program::{AXES, Axis, AxisSet};

pub(super) const ORIGIN: Function = Function {
    number: "4",
    name: "Move to origin",
    doc: "To the job origin in X and Y, Z at least at ZTop",
    steps: &[],
    does: |_, _| Ok(go([Errand::Origin])),
};

pub(super) const FINISH: Function = Function {
    number: "5",
    name: "Move to finish",
    doc: "To the finish position of the job, in the same way",
    steps: &[],
    does: |_, _| Ok(go([Errand::Finish])),
};

pub(super) const BY: Function = Function {
    number: "6",
    name: "Move by x,y,z",
    doc: "By distances. Z first where it rises, last where it sinks",
    steps: &[
        Number { prompt: "Move by x mm:", now: |_| Some(0.0) },
        Number { prompt: "Move by y mm:", now: |_| Some(0.0) },
        Number { prompt: "Move by z mm:", now: |_| Some(0.0) },
    ],
    does: |by, _| Ok(go(ways(by, true, by[2] > 0.0))),
};

pub(super) const TO: Function = Function {
    number: "21",
    name: "Move to x,y,z",
    doc: "To a place: X and Y from the job origin, Z from home. Z first where it rises, last where it sinks",
    steps: &[
        Number {
            prompt: "Move to x mm:",
            now: |view| Some(view.position[Axis::X] - view.machine.job.origin_mm[0]),
        },
        Number {
            prompt: "Move to y mm:",
            now: |view| Some(view.position[Axis::Y] - view.machine.job.origin_mm[1]),
        },
        Number { prompt: "Move to z mm:", now: |view| Some(view.position[Axis::Z]) },
    ],
    does: |to, view| Ok(go(ways(to, false, to[2] > view.position[Axis::Z]))),
};

pub(super) const HOMES: Function = Function {
    number: "20",
    name: "Move to homes",
    doc: "Z to home, then all other axes",
    steps: &[],
    does: |_, view| Ok(go([Errand::Home(view.machine.motors.axes())])),
};

pub(super) const FIND_Z: Function = Function {
    number: "50",
    name: "Find z(w) home",
    doc: "The home switch of Z is sought; then that of w, where it keeps the tool along the path",
    steps: &[],
    does: |_, view| {
        let turns = view.machine.misc.tangential && has_switch(view, W);
        let z = find(view, &[Axis::Z], "no z home switch")?;
        Ok(go([Errand::FindHome(if turns { z.with(W) } else { z })]))
    },
};

/// Z rises first where it is below Z top: the tool leaves the work.
pub(super) const FIND_XY: Function = Function {
    number: "51",
    name: "Find xy homes",
    doc: "Those of X and Y; Z rises to ZTop first where it is lower",
    steps: &[],
    does: |_, view| {
        let axes = find(view, &[Axis::X, Axis::Y], "no xy home switches")?;
        let top = view.machine.zpos.top_mm;
        let up = (view.position[Axis::Z] < top).then(|| to_height(top));
        Ok(go(up.into_iter().chain([Errand::FindHome(axes)])))
    },
};

fn go(errands: impl IntoIterator<Item = Errand>) -> Done {
    errands.into_iter().map(ConsoleRequest::Go).collect::<Vec<_>>().into()
}

/// The way to a place in the plane and a height: Z first where it rises, last where it sinks, so that the tool
/// is never drawn through what it has cut.
fn ways(place: &[f64], relative: bool, rises: bool) -> [Errand; 2] {
    let part = |axes: std::ops::Range<usize>| {
        let mut all = [None; AXES];
        axes.for_each(|axis| all[axis] = place.get(axis).copied());
        Errand::To { place: all, relative, flat: false }
    };
    let (plane, height) = (part(0..2), part(2..3));
    if rises { [height, plane] } else { [plane, height] }
}

/// Z goes to a height, counted from home.
pub(super) fn to_height(z: f64) -> Errand {
    let mut place = [None; AXES];
    place[Axis::Z.index()] = Some(z);
    Errand::To { place, relative: false, flat: false }
}

fn has_switch(view: &View, axis: Axis) -> bool {
    view.machine.homing.of(axis).fitted
}

/// Those of the axes that have a home switch.
fn find(view: &View, axes: &[Axis], none: &str) -> Result<AxisSet, Refusal> {
    let fitted = axes.iter().filter(|axis| has_switch(view, **axis));
    let fitted = fitted.fold(AxisSet::EMPTY, |set, axis| set.with(*axis));
    if fitted.is_empty() { Err(none.into()) } else { Ok(fitted) }
}
