//! Parameters and expressions.

use super::Core;
use super::context::{Context, Stop};
use super::core::LOCALS;
use super::io::ANSWER;
use super::state::FeedMode;
use crate::syntax::expr::{Expr, Operator};
use crate::syntax::gathered::Fault;
use crate::syntax::tree::{Program, Setting, Span, Target};
use kerf_diag::Code;
use kerf_program::settings::LinearUnit;
use kerf_program::{Axes, Turn};
use std::sync::Arc;

/// The highest parameter there is.
const LAST: u32 = 5602;
/// Numbers of the axes in groups of parameters: X Y Z A B C, then U V W, which are always 0.
const PER_GROUP: u32 = 9;

/// A value on its way into a parameter.
pub(super) enum Assigned {
    Number(u32, f64),
    Name(u32, f64),
}

/// The parameters of a program, by name.
pub(super) fn all(core: &Core) -> Vec<(String, f64)> {
    let mut found = Vec::new();
    if let Some(call) = core.calls.iter().rev().find(|c| !c.locals.is_empty()) {
        let set = call.locals.iter().enumerate().filter(|(_, v)| **v != 0.0);
        found.extend(set.map(|(i, v)| (format!("#{}", i + 1), *v)));
        found.extend(call.named.iter().map(|(n, v)| (format!("#<{n}>"), *v)));
    }
    found.extend(core.state.parameters.iter().map(|(n, v)| (format!("#{n}"), *v)));
    found.extend(core.state.globals.iter().map(|(n, v)| (format!("#<{n}>"), *v)));
    found
}

impl Core {
    /// The value of an expression.
    pub(super) fn evaluate(
        &self,
        program: &Program,
        expr: &Expr,
        span: Span,
    ) -> Result<f64, Fault> {
        let value = match expr {
            Expr::Number(n) => *n,
            Expr::Numbered(number) => {
                let n = self.evaluate(program, number, span)?;
                self.parameter(whole_number(n, span)?, span)?
            }
            Expr::Named(id) => {
                let name = program.names.get(*id as usize).cloned().unwrap_or_default();
                self.named(&name).ok_or_else(|| no_value(&name, span))?
            }
            Expr::Exists(id) => {
                let name = program.names.get(*id as usize).cloned().unwrap_or_default();
                f64::from(u8::from(self.named(&name).is_some()))
            }
            Expr::Call(function, x) => function.of(self.evaluate(program, x, span)?),
            Expr::Atan(y, x) => {
                let (y, x) = (self.evaluate(program, y, span)?, self.evaluate(program, x, span)?);
                y.atan2(x).to_degrees()
            }
            Expr::Binary(operator, a, b) => {
                let (a, b) = (self.evaluate(program, a, span)?, self.evaluate(program, b, span)?);
                if b == 0.0 && matches!(operator, Operator::Over | Operator::Mod) {
                    return Err(Fault::new(Code::DivisionByZero, span, "division by zero").hint(
                        "which parameter in it is zero? a parameter that was never set is 0",
                    ));
                }
                operator.of(a, b)
            }
        };
        if value.is_finite() {
            return Ok(value);
        }
        Err(Fault::new(Code::BadArithmetic, span, "the calculation has no result")
            .hint("the root of a negative number, a logarithm of zero, or a value far too large"))
    }

    /// A numbered parameter.
    pub(super) fn parameter(&self, number: u32, span: Span) -> Result<f64, Fault> {
        let state = &self.state;
        Ok(match number {
            1..=30 => self.locals().get(number as usize - 1).copied().unwrap_or_default(),
            5061..=5069 => of_axis(self.to_user(self.place_of(state.probed)), number - 5061),
            5070 => f64::from(u8::from(state.probe_hit)),
            5161..=5169 => of_axis(self.in_machine_units(state.home[0]), number - 5161),
            5181..=5189 => of_axis(self.in_machine_units(state.home[1]), number - 5181),
            5210 => f64::from(u8::from(state.shift != Axes::default())),
            5211..=5219 => of_axis(self.in_machine_units(state.shift), number - 5211),
            5220 => state.modal.system as f64 + 1.0,
            5221..=5390 => self.system_parameter(number),
            5400 => f64::from(state.tool),
            5401..=5409 => of_axis(self.in_machine_units(state.tool_offset), number - 5401),
            5410 => {
                state.tools.get(&state.tool).map_or(0.0, |t| t.diameter_mm / self.machine_unit())
            }
            5420..=5428 => of_axis(self.user_position(), number - 5420),
            0 | LAST.. if number != LAST => {
                let message = format!("there is no parameter #{number}");
                return Err(Fault::new(Code::BadParameter, span, message)
                    .hint(format!("parameters are numbered from 1 to {LAST}")));
            }
            _ => state.parameters.get(&number).copied().unwrap_or_default(),
        })
    }

    fn system_parameter(&self, number: u32) -> f64 {
        let (system, index) = ((number - 5221) / 20, (number - 5221) % 20);
        let system = self.state.systems[(system as usize).min(8)];
        if index == PER_GROUP {
            return self.turn_of(system.rotation_deg);
        }
        of_axis(self.in_machine_units(system.offset), index)
    }

    /// The unit that offsets are told in: the machine's, not the file's.
    fn machine_unit(&self) -> f64 {
        self.settings.linear_unit.mm()
    }

    fn in_machine_units(&self, place: Axes) -> Axes {
        let unit = self.machine_unit();
        Axes(std::array::from_fn(|i| {
            if i < 3 { kerf_program::settings::to_user(place.0[i], unit) } else { place.0[i] }
        }))
    }

    /// `#1` … `#30` of the subroutine that runs.
    fn locals(&self) -> &[f64] {
        self.calls.iter().rev().find(|c| !c.locals.is_empty()).map_or(&[], |c| &c.locals)
    }

    /// A named parameter; a name that begins with an underscore is global.
    pub(super) fn named(&self, name: &str) -> Option<f64> {
        if !name.starts_with('_') {
            let call = self.calls.iter().rev().find(|c| !c.locals.is_empty())?;
            return call.named.get(name).copied();
        }
        self.state.globals.get(name).copied().or_else(|| self.predefined(name))
    }

    /// Names that tell the state.
    fn predefined(&self, name: &str) -> Option<f64> {
        let modal = &self.state.modal;
        let yes = |holds: bool| f64::from(u8::from(holds));
        let place = || self.user_position();
        let machine = || self.to_user(self.position);
        Some(match name {
            "_x" | "_y" | "_z" | "_a" | "_b" | "_c" => {
                place().0[AXIS_NAMES.find(name.as_bytes()[1] as char)?]
            }
            "_abs_x" | "_abs_y" | "_abs_z" | "_abs_a" | "_abs_b" | "_abs_c" => {
                machine().0[AXIS_NAMES.find(name.as_bytes()[5] as char)?]
            }
            "_u" | "_v" | "_w" => 0.0,
            "_feed" => modal.feed.map_or(0.0, |f| match modal.feed_mode {
                FeedMode::Inverse => f.rotary,
                _ => f.linear / modal.unit.mm(),
            }),
            "_rpm" => modal.rpm,
            "_metric" => yes(modal.unit == LinearUnit::Mm),
            "_imperial" => yes(modal.unit == LinearUnit::Inch),
            "_absolute" => yes(!modal.relative),
            "_incremental" => yes(modal.relative),
            "_ijk_absolute_mode" => yes(modal.arc_absolute),
            "_inverse_time" => yes(modal.feed_mode == FeedMode::Inverse),
            "_units_per_minute" => yes(modal.feed_mode == FeedMode::PerMinute),
            "_units_per_rev" => yes(modal.feed_mode == FeedMode::PerTurn),
            "_coord_system" => modal.system as f64 * 10.0 + 540.0,
            "_plane" => 170.0 + 10.0 * modal.plane as u8 as f64,
            "_motion_mode" => f64::from(modal.motion.unwrap_or(800)),
            "_spindle_on" => yes(modal.turn != Turn::Off),
            "_spindle_cw" => yes(modal.turn == Turn::Clockwise),
            "_mist" => yes(modal.mist),
            "_flood" => yes(modal.flood),
            "_feed_override" => yes(modal.overrides[0]),
            "_speed_override" => yes(modal.overrides[1]),
            "_current_tool" => f64::from(self.state.tool),
            "_selected_tool" => f64::from(self.state.selected),
            "_tool_offset" => yes(self.state.tool_offset != Axes::default()),
            "_call_level" => self.calls.len().saturating_sub(1) as f64,
            "_line" => self.calls.last().map_or(0.0, |c| f64::from(c.next)),
            "_task" => yes(!self.options.preview),
            "_vmajor" => 2.9,
            "_vminor" => 0.0,
            _ => return None,
        })
    }
}

const AXIS_NAMES: &str = "xyzabc";

/// The value of the n-th axis of a group of parameters.
fn of_axis(axes: Axes, index: u32) -> f64 {
    axes.0.get(index as usize).copied().unwrap_or_default()
}

fn whole_number(value: f64, span: Span) -> Result<u32, Fault> {
    let rounded = value.round();
    if (value - rounded).abs() < 1e-4 && (0.0..1e6).contains(&rounded) {
        return Ok(rounded as u32);
    }
    let message = format!("the number of a parameter is whole, not {value}");
    Err(Fault::new(Code::BadParameter, span, message))
}

fn no_value(name: &str, span: Span) -> Fault {
    let hint = if name.starts_with("_ini[") || name.starts_with("_hal[") || name.starts_with('/') {
        "values of a controller's own configuration are not there"
    } else {
        "set it before it is used, as in #<depth>=5"
    };
    Fault::new(Code::NoValue, span, format!("#<{name}> has no value")).hint(hint)
}

impl Context<'_> {
    /// The value of an expression of this block.
    pub(super) fn evaluate(&self, program: &Program, expr: &Expr, span: Span) -> Result<f64, Stop> {
        self.core.evaluate(program, expr, span).map_err(|f| self.faulty(f))
    }

    /// The values of settings: all are worked out before any is set.
    pub(super) fn evaluate_settings(
        &mut self,
        program: &Arc<Program>,
        settings: &[Setting],
    ) -> Result<Vec<(Assigned, Span)>, Stop> {
        let mut values = Vec::with_capacity(settings.len());
        for Setting { target, value, span } in settings {
            let value = self.evaluate(program, value, *span)?;
            let assigned = match target {
                Target::Named(id) => Assigned::Name(*id, value),
                Target::Numbered(number) => {
                    let number = self.evaluate(program, number, *span)?;
                    let number = whole_number(number, *span).map_err(|f| self.faulty(f))?;
                    Assigned::Number(number, value)
                }
            };
            values.push((assigned, *span));
        }
        Ok(values)
    }

    /// Sets parameters.
    pub(super) fn assign(
        &mut self,
        program: &Arc<Program>,
        values: Vec<(Assigned, Span)>,
    ) -> Result<(), Stop> {
        for (assigned, span) in values {
            match assigned {
                Assigned::Number(number, value) => self.set_parameter(number, value, span)?,
                Assigned::Name(id, value) => {
                    let name = program.names.get(id as usize).cloned().unwrap_or_default();
                    self.set_named(name, value);
                }
            }
        }
        Ok(())
    }

    /// Sets a named parameter.
    pub(super) fn set_named(&mut self, name: Arc<str>, value: f64) {
        if name.starts_with('_') {
            self.core.state.globals.insert(name, value);
        } else if let Some(call) = self.core.calls.iter_mut().rev().find(|c| !c.locals.is_empty()) {
            call.named.insert(name, value);
        }
    }

    fn set_parameter(&mut self, number: u32, value: f64, span: Span) -> Result<(), Stop> {
        let unit = self.core.machine_unit();
        let length = |index: u32| value * if index < 3 { unit } else { 1.0 };
        let calls = &mut self.core.calls;
        let state = &mut self.core.state;
        match number {
            1..=30 => {
                if let Some(call) = calls.iter_mut().rev().find(|c| c.locals.len() == LOCALS) {
                    call.locals[number as usize - 1] = value;
                }
            }
            5161..=5166 => state.home[0].0[number as usize - 5161] = length(number - 5161),
            5181..=5186 => state.home[1].0[number as usize - 5181] = length(number - 5181),
            5211..=5216 => state.shift.0[number as usize - 5211] = length(number - 5211),
            5221..=5390 => self.set_system_parameter(number, value),
            31..=5000 | ANSWER => {
                state.parameters.insert(number, value);
            }
            5167..=5169 | 5187..=5189 | 5217..=5219 => {}
            _ => {
                let message = format!("#{number} cannot be set");
                let hint = "parameters for programs are #1 to #5000";
                return Err(self.faulty(Fault::new(Code::BadParameter, span, message).hint(hint)));
            }
        }
        if (5211..=5390).contains(&number) {
            self.relocate();
        }
        Ok(())
    }

    fn set_system_parameter(&mut self, number: u32, value: f64) {
        let (system, index) = ((number - 5221) / 20, (number - 5221) % 20);
        let (unit, turn) = (self.core.machine_unit(), self.core.turn_of(value));
        let system = &mut self.core.state.systems[(system as usize).min(8)];
        match index {
            0..=2 => system.offset.0[index as usize] = value * unit,
            3..=5 => system.offset.0[index as usize] = value,
            PER_GROUP => system.rotation_deg = turn,
            _ => {}
        }
    }
}
