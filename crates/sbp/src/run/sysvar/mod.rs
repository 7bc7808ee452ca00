//! System variables, `%(n)`: the state of the machine as programs read it.
//!
//! They are a table, like the commands: number, name, unit, and the function that reads it. The
//! numbers are those of the handbook of 2013, which supersedes the lists before it (readings, A-02,
//! Distances are in the user's units. What only the machine knows, inputs and outputs, is
//! asked once motion has come to rest.

mod list;
#[cfg(test)]
mod tests;

use super::{Context, Stop};
use crate::Value;
use crate::tree::Span;
use kerf_diag::Code;
use kerf_program::Axis;
use kerf_program::settings::to_user;
use list::FAMILIES;

/// Name and version of the software, `%(48)`; what `kerf --version` prints.
pub const VERSION: &str = concat!("kerf ", env!("CARGO_PKG_VERSION"));

/// The last number of the table.
const LAST: u8 = 161;

/// One system variable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SystemVariable {
    /// Its number, 1 … 161.
    pub number: u8,
    /// Name of the value that it shows.
    pub name: &'static str,
    /// Its unit, or the values it takes.
    pub unit: &'static str,
}

/// All that have a meaning, in order of numbers.
pub fn system_variables() -> impl Iterator<Item = SystemVariable> {
    FAMILIES.iter().flat_map(|family| {
        let named = (family.first..).zip(family.names);
        named.map(|(number, name)| SystemVariable { number, name, unit: family.unit })
    })
}

/// Variables with numbers in a row that are read alike.
struct Family {
    first: u8,
    unit: &'static str,
    names: &'static [&'static str],
    /// Reads the one with this place in the family.
    read: fn(&mut Context<'_>, usize) -> Result<Value, Stop>,
}

/// The value of a system variable in the user's units.
pub(crate) fn system_variable(c: &mut Context<'_>, number: f64, span: Span) -> Result<Value, Stop> {
    if number.fract() != 0.0 || !(1.0..=f64::from(LAST)).contains(&number) {
        let message = format!("no system variable {}", Value::Number(number).display());
        let hint = "they are numbered 1 to 161";
        return Err(c.fail_at(span, Code::NoSystemVariable, message, hint));
    }
    let n = match c.core.options.dialect {
        crate::Dialect::Fabmo => fabmo_number(c, number as u8, span)?,
        _ => number as u8,
    };
    let found = FAMILIES.iter().find_map(|family| {
        let place = usize::from(n.checked_sub(family.first)?);
        (place < family.names.len()).then_some((family, place))
    });
    match found {
        Some((family, place)) => (family.read)(c, place),
        None => {
            let message = format!("system variable {n} is not assigned");
            c.warn(Code::UnassignedSystemVariable, message, "it reads as empty");
            Ok(Value::Empty)
        }
    }
}

/// The number here of a system variable of FabMo's dialect: C comes behind B there, so that
/// locations are 1 to 6 and base coordinates 7 to 12.
fn fabmo_number(c: &Context<'_>, n: u8, span: Span) -> Result<u8, Stop> {
    match n {
        6 => Ok(144),
        7..=11 => Ok(n - 1),
        12 => Ok(145),
        77..=112 => {
            let message = format!("%({n}) of FabMo's dialect is not known here");
            Err(c.fail_at(span, Code::NotSupported, message, "limits and jerk are not read"))
        }
        _ => Ok(n),
    }
}

/// Returns the distance of an axis that moves by itself from where the program sent it; 0 for any other.
fn drift(c: &mut Context<'_>, axis: Axis) -> Result<f64, Stop> {
    if !c.core.wanders(axis) {
        return Ok(0.0);
    }
    c.settle()?;
    Ok(c.host.machine_position()[axis.index()] - c.core.place.position[axis])
}

/// Working location of an axis.
fn working_location(c: &mut Context<'_>, axis: Axis) -> Result<Value, Stop> {
    let place = c.core.place.position[axis] + drift(c, axis)?;
    Ok(axis_value(c, axis, place - c.core.place.frame.working_zero[axis]))
}

/// Table base coordinate of an axis, in the reading of the dialect.
fn base_location(c: &mut Context<'_>, axis: Axis) -> Result<Value, Stop> {
    let drift = drift(c, axis)?;
    Ok(axis_value(c, axis, c.core.base_coordinate(axis, drift)))
}

fn axis_value(c: &Context<'_>, axis: Axis, internal: f64) -> Value {
    Value::Number(to_user(internal, c.settings().axis_scale(axis)))
}

fn length_value(c: &Context<'_>, mm: f64) -> Value {
    Value::Number(to_user(mm, c.settings().linear_unit.mm()))
}

/// State of an input, 1 … 12.
fn input_state(c: &mut Context<'_>, number: usize) -> Result<bool, Stop> {
    c.settle()?;
    Ok(c.host.input(number as u8))
}

/// State of an output, 1 … 12.
fn output_state(c: &mut Context<'_>, number: usize) -> Result<bool, Stop> {
    c.settle()?;
    Ok(c.host.output(number as u8))
}
