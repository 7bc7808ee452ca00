//! The parameters of a program: numbered, named, and those that tell the state.

use super::calls::{Calls, LOCALS};
use super::coordinates::Coordinates;
use super::state::{FeedMode, State};
use crate::syntax::gathered::Fault;
use crate::syntax::tree::Span;
use kerf_diag::Code;
use kerf_program::settings::{LinearUnit, to_user};
use kerf_program::{Axes, SpindleTurn};
use std::sync::Arc;

/// The parameter that M66 answers in.
pub(super) const ANSWER: u32 = 5399;
/// The highest parameter there is.
const LAST: u32 = 5602;
/// Numbers of the axes in groups of parameters: X Y Z A B C, then U V W, which are always 0.
const PER_GROUP: u32 = 9;

/// The state as parameters tell it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Parameters<'a> {
    pub(super) state: &'a State,
    pub(super) calls: &'a Calls,
    pub(super) coordinates: &'a Coordinates,
    /// Place on the programmed path, machine frame.
    pub(super) position: Axes,
    pub(super) scheme: Scheme,
    pub(super) preview: bool,
}

/// How numbers of parameters count.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scheme {
    /// The unit that offsets are told in, mm: the machine's, not the file's.
    pub(super) unit_mm: f64,
    /// A file that FP mirrors turns the other way.
    pub(super) mirrored: bool,
}

impl Scheme {
    /// An angle of the file as one of the machine, and back.
    pub(super) fn turn_of(self, degrees: f64) -> f64 {
        if self.mirrored { -degrees } else { degrees }
    }

    fn told(self, place: Axes) -> Axes {
        Axes(std::array::from_fn(|i| {
            if i < 3 { to_user(place.0[i], self.unit_mm) } else { place.0[i] }
        }))
    }
}

impl Parameters<'_> {
    /// The parameters of a program, by name.
    pub(super) fn all(&self) -> Vec<(String, f64)> {
        let mut found = Vec::new();
        if let Some(call) = self.calls.scope() {
            let set = call.locals.iter().enumerate().filter(|(_, v)| **v != 0.0);
            found.extend(set.map(|(i, v)| (format!("#{}", i + 1), *v)));
            found.extend(call.named.iter().map(|(n, v)| (format!("#<{n}>"), *v)));
        }
        found.extend(self.state.parameters.iter().map(|(n, v)| (format!("#{n}"), *v)));
        found.extend(self.state.globals.iter().map(|(n, v)| (format!("#<{n}>"), *v)));
        found
    }

    /// A numbered parameter.
    pub(super) fn numbered(&self, number: u32, span: Span) -> Result<f64, Fault> {
        let state = &self.state;
        Ok(match number {
            1..=30 => self.local(number),
            5061..=5069 => of_axis(self.in_file_units(state.probed), number - 5061),
            5070 => f64::from(u8::from(state.probe_hit)),
            5161..=5169 => of_axis(self.scheme.told(state.home[0]), number - 5161),
            5181..=5189 => of_axis(self.scheme.told(state.home[1]), number - 5181),
            5210 => f64::from(u8::from(state.shift != Axes::default())),
            5211..=5219 => of_axis(self.scheme.told(state.shift), number - 5211),
            5220 => state.modal.system as f64 + 1.0,
            5221..=5390 => self.system_parameter(number),
            5400 => f64::from(state.tool),
            5401..=5409 => of_axis(self.scheme.told(state.tool_offset), number - 5401),
            5410 => {
                state.tools.get(&state.tool).map_or(0.0, |t| t.diameter_mm / self.scheme.unit_mm)
            }
            5420..=5428 => of_axis(self.in_file_units(self.position), number - 5420),
            0 | LAST.. if number != LAST => {
                let message = format!("there is no parameter #{number}");
                return Err(Fault::new(Code::BadParameter, span, message)
                    .hint(format!("parameters are numbered from 1 to {LAST}")));
            }
            _ => state.parameters.get(&number).copied().unwrap_or_default(),
        })
    }

    /// `#1` … `#30` of the subroutine that runs.
    fn local(&self, number: u32) -> f64 {
        let value = |call: &super::calls::Call| call.locals.get(number as usize - 1).copied();
        self.calls.scope().and_then(value).unwrap_or_default()
    }

    fn system_parameter(&self, number: u32) -> f64 {
        let (system, index) = ((number - 5221) / 20, (number - 5221) % 20);
        let system = self.state.systems[(system as usize).min(8)];
        if index == PER_GROUP {
            return self.scheme.turn_of(system.rotation_deg);
        }
        of_axis(self.scheme.told(system.offset), index)
    }

    /// A machine position as a place of the coordinate system, in the units of the file.
    fn in_file_units(&self, position: Axes) -> Axes {
        self.coordinates.to_user(self.coordinates.place_of(position))
    }

    /// A named parameter; a name that begins with an underscore is global.
    pub(super) fn named(&self, name: &str) -> Option<f64> {
        if !name.starts_with('_') {
            return self.calls.scope()?.named.get(name).copied();
        }
        self.state.globals.get(name).copied().or_else(|| self.predefined(name))
    }

    /// Names that tell the state.
    fn predefined(&self, name: &str) -> Option<f64> {
        let modal = &self.state.modal;
        let yes = |holds: bool| f64::from(u8::from(holds));
        let place = || self.in_file_units(self.position);
        let machine = || self.coordinates.to_user(self.position);
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
            "_spindle_on" => yes(modal.turn != SpindleTurn::Off),
            "_spindle_cw" => yes(modal.turn == SpindleTurn::Clockwise),
            "_mist" => yes(modal.mist),
            "_flood" => yes(modal.flood),
            "_feed_override" => yes(modal.overrides[0]),
            "_speed_override" => yes(modal.overrides[1]),
            "_current_tool" => f64::from(self.state.tool),
            "_selected_tool" => f64::from(self.state.selected),
            "_tool_offset" => yes(self.state.tool_offset != Axes::default()),
            "_call_level" => self.calls.open.len().saturating_sub(1) as f64,
            "_line" => f64::from(self.calls.next().1),
            "_task" => yes(!self.preview),
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

/// Sets a named parameter.
pub(super) fn set_named(state: &mut State, calls: &mut Calls, name: Arc<str>, value: f64) {
    if name.starts_with('_') {
        state.globals.insert(name, value);
    } else if let Some(call) = calls.scope_mut() {
        call.named.insert(name, value);
    }
}

/// Sets a numbered parameter.
pub(super) fn set_numbered(
    state: &mut State,
    calls: &mut Calls,
    scheme: Scheme,
    (number, value, span): (u32, f64, Span),
) -> Result<(), Fault> {
    let length = |index: u32| value * if index < 3 { scheme.unit_mm } else { 1.0 };
    match number {
        1..=30 => {
            let full = |c: &&mut super::calls::Call| c.locals.len() == LOCALS;
            if let Some(call) = calls.open.iter_mut().rev().find(full) {
                call.locals[number as usize - 1] = value;
            }
        }
        5161..=5166 => state.home[0].0[number as usize - 5161] = length(number - 5161),
        5181..=5186 => state.home[1].0[number as usize - 5181] = length(number - 5181),
        5211..=5216 => state.shift.0[number as usize - 5211] = length(number - 5211),
        5221..=5390 => set_of_system(state, scheme, number, value),
        31..=5000 | ANSWER => {
            state.parameters.insert(number, value);
        }
        5167..=5169 | 5187..=5189 | 5217..=5219 => {}
        _ => {
            let message = format!("#{number} cannot be set");
            let hint = "parameters for programs are #1 to #5000";
            return Err(Fault::new(Code::BadParameter, span, message).hint(hint));
        }
    }
    Ok(())
}

/// Returns `true` if a numbered parameter moves the zero.
pub(super) fn moves_zero(number: u32) -> bool {
    (5211..=5390).contains(&number)
}

fn set_of_system(state: &mut State, scheme: Scheme, number: u32, value: f64) {
    let (system, index) = ((number - 5221) / 20, (number - 5221) % 20);
    let system = &mut state.systems[(system as usize).min(8)];
    match index {
        0..=2 => system.offset.0[index as usize] = value * scheme.unit_mm,
        3..=5 => system.offset.0[index as usize] = value,
        PER_GROUP => system.rotation_deg = scheme.turn_of(value),
        _ => {}
    }
}
