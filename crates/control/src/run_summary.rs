//! The summary of a run, and the event that ends it.

use crate::run_end::RunEnd;
use crate::world::World;
use kerf_geom::Bounds3;
use kerf_model::Model;
use kerf_part::Interpreter;
use kerf_program::{Axes, Axis};
use kerf_sbp::Value;
use kerf_trace::Summary;
use kerf_trace::event::{BoundsEvent, Corner, EndEvent, Partial, VarValue};
use std::collections::BTreeMap;

pub(crate) fn summary(
    interpreter: &impl kerf_program::Interpreter,
    world: &mut World<'_>,
    taken_s: Option<f64>,
    over: RunEnd,
) -> Summary {
    Summary {
        status: over.status,
        seconds: world.now(),
        taken_s,
        lines: interpreter.lines(),
        tally: std::mem::take(&mut world.tally),
        unit: interpreter.settings().linear_unit,
        error: over.diagnostic,
        closes: false,
    }
}

pub(crate) fn end_event(
    summary: &Summary,
    machine: &Model,
    astray: Axes,
    vars: Option<BTreeMap<String, VarValue>>,
) -> EndEvent {
    let mm = summary.unit.mm();
    EndEvent {
        status: summary.status,
        t: summary.seconds,
        took: summary.taken_s,
        lines: summary.lines,
        moves: summary.tally.moves,
        arcs: summary.tally.arcs,
        cut: summary.tally.cut_mm / mm,
        jog: summary.tally.jog_mm / mm,
        bounds: bounds_event(&summary.tally.bounds, mm),
        steps: machine.steps(),
        heater: (machine.settings().io.analog >= 3).then(|| machine.heater_degrees()),
        astray: partial(machine, astray),
        verify: machine.unverified().iter().map(|axis| axis.letter()).collect(),
        vars,
    }
}

fn partial(machine: &Model, places: Axes) -> Partial {
    let user = machine.settings().to_user(places);
    let axes = Axis::ALL.into_iter().filter(|axis| user[*axis] != 0.0);
    axes.map(|axis| (axis.letter().to_ascii_lowercase(), user[axis])).collect()
}

fn bounds_event(bounds: &Bounds3, mm: f64) -> Option<BoundsEvent> {
    let corner = |[x, y, z]: [f64; 3]| Corner { x: x / mm, y: y / mm, z: z / mm };
    (!bounds.is_empty()).then(|| BoundsEvent { min: corner(bounds.min), max: corner(bounds.max) })
}

pub(crate) fn variables_told(interpreter: &Interpreter) -> BTreeMap<String, VarValue> {
    let told = |value: Value| match value.number() {
        // As the language shows it: seven digits, not the noise of single precision.
        Some(number) => {
            let shown = kerf_sbp::format_number(number).parse();
            VarValue::Number(shown.unwrap_or(number))
        }
        None => VarValue::Text(value.display()),
    };
    let named = interpreter.sbp_variables().list().into_iter();
    let parameters = interpreter.gcode_parameters().into_iter();
    let parameters = parameters.map(|(name, value)| (name, VarValue::Number(value)));
    named.map(|(name, value)| (name, told(value))).chain(parameters).collect()
}
