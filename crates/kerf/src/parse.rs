//! Values of options.

use kerf_model::Change;
use kerf_program::GoTo;
use kerf_program::settings::LinearUnit;
use kerf_program::{Axis, RampModel};
use kerf_sbp::{Dialect, Value};
use kerf_sim::Push;
use kerf_sim::Sheet;
use std::any::TypeId;

/// A command whose options take `-1` where their value is a number, or several: whether it may be below 0 the
/// reader of the value says, in its own words.
pub fn with_negative_numbers(command: clap::Command) -> clap::Command {
    let numbers = [
        TypeId::of::<f64>(),
        TypeId::of::<[f64; 2]>(),
        TypeId::of::<[f64; 3]>(),
        TypeId::of::<(f64, f32)>(),
        TypeId::of::<Sheet>(),
        TypeId::of::<u8>(),
        TypeId::of::<u32>(),
        TypeId::of::<u64>(),
        TypeId::of::<usize>(),
    ];
    let takes = |arg: clap::Arg| {
        let number = numbers.iter().any(|it| arg.get_value_parser().type_id() == *it);
        let counted = arg.get_long().is_some() && number && arg.get_action().takes_values();
        if counted { arg.allow_hyphen_values(true) } else { arg }
    };
    command.mut_args(takes).mut_subcommands(with_negative_numbers)
}

/// Letters of axes, as `xyz`.
pub fn axes(text: &str) -> Result<Vec<Axis>, String> {
    let letters = text.chars().filter(|c| !matches!(c, ',' | ' '));
    let axes: Option<Vec<Axis>> = letters.map(Axis::from_letter).collect();
    let mut axes = axes.filter(|a| !a.is_empty()).ok_or("give letters of axes, as xyz")?;
    axes.sort();
    axes.dedup();
    Ok(axes)
}

/// `in` or `mm`.
pub fn units(text: &str) -> Result<LinearUnit, String> {
    match text {
        "in" => Ok(LinearUnit::Inch),
        "mm" => Ok(LinearUnit::Mm),
        _ => Err("give in or mm".into()),
    }
}

/// Which reading of each language holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dialects {
    /// Of OpenSBP.
    pub sbp: Dialect,
    /// Of G-code.
    pub gcode: kerf_gcode::Dialect,
}

/// `sb3`, `fabmo` or `strict` for OpenSBP; `generic`, `linuxcnc`, `grbl`, `grblhal` or
/// `mach3` for G-code. What is to
/// the letter in one language is so in the other.
pub fn dialect(text: &str) -> Result<Dialects, String> {
    use kerf_gcode::Dialect as Gcode;
    let (sbp, gcode) = match text {
        "sb3" | "generic" => (Dialect::Sb3, Gcode::Generic),
        "fabmo" => (Dialect::Fabmo, Gcode::Generic),
        "strict" => (Dialect::Strict, Gcode::LinuxCnc),
        "linuxcnc" => (Dialect::Sb3, Gcode::LinuxCnc),
        "grbl" => (Dialect::Sb3, Gcode::Grbl),
        "grblhal" => (Dialect::Sb3, Gcode::GrblHal),
        "mach3" => (Dialect::Sb3, Gcode::Mach3),
        _ => {
            return Err("give sb3, fabmo, strict, generic, linuxcnc, grbl, grblhal or mach3".into());
        }
    };
    Ok(Dialects { sbp, gcode })
}

/// `3d` or `2d`, as the number of FP.
pub fn offset(text: &str) -> Result<u8, String> {
    match text {
        "3d" => Ok(1),
        "2d" => Ok(2),
        _ => Err("give 3d or 2d".into()),
    }
}

/// `120`, `120 settings`, `last` or `last settings`.
pub fn from_line(text: &str) -> Result<String, String> {
    let known = GoTo::read(text, Some(1)).is_some();
    known.then(|| text.to_owned()).ok_or_else(|| "give the number of a line, or last".into())
}

/// `Z`, `Z,SLOPE`, `Z,SLOPE,SLOPE` or `Z,SLOPE,SLOPE,WAVE,LENGTH`: a sheet, how high it lies, how it rises
/// along X and Y, and how high and long the waves along X are.
pub fn sheet(text: &str) -> Result<Sheet, String> {
    let numbers: Option<Vec<f64>> = text.split(',').map(|n| n.trim().parse().ok()).collect();
    let numbers = numbers
        .filter(|all| matches!(all.len(), 1..=3 | 5) && all.iter().all(|n: &f64| n.is_finite()));
    let numbers = numbers
        .ok_or_else(|| "give Z, or Z,SLOPE, as -20,0.05, or five numbers for waves".to_owned())?;
    let number = |i: usize| numbers.get(i).copied().unwrap_or_default();
    let [at_mm, slope_x, slope_y, wave_mm, wave_length_mm] = [0, 1, 2, 3, 4].map(number);
    Ok(Sheet { at_mm, slope_x, slope_y, wave_mm, wave_length_mm, step: None })
}

/// `N@T=0` or `N@T=1`, N a number or a name.
pub fn input(text: &str) -> Result<Change, String> {
    text.parse()
}

/// An input, by its number or its name.
pub fn input_number(text: &str) -> Result<u8, String> {
    kerf_model::input_number(text)
}

/// `AXIS@T=BY`, in units of the axis.
pub fn hand_move(text: &str) -> Result<Push, String> {
    let parts = text.split_once('@').and_then(|(axis, rest)| Some((axis, rest.split_once('=')?)));
    let Some((axis, (at, by))) = parts else {
        return Err("give AXIS@SECONDS=DISTANCE, as X@2.5=1".into());
    };
    let mut letters = axis.trim().chars();
    let letter = letters.next().and_then(Axis::from_letter).filter(|_| letters.next().is_none());
    let axis = letter.ok_or("axes are X, Y, Z, A, B and C")?;
    let at_s = not_negative(at.trim()).map_err(|_| "the time is a number of seconds, 0 or more")?;
    Ok(Push { axis, at_s, by: number(by.trim())? })
}

/// `PERCENT@SECONDS`: a time and a share.
pub fn feed_override(text: &str) -> Result<(f64, f32), String> {
    let (at_s, percent) = override_of(text, "a feed", 10.0, 200.0)?;
    Ok((at_s, percent / 100.0))
}

/// The same of rapid moves: a time and percent.
pub fn rapid_override(text: &str) -> Result<(f64, u8), String> {
    override_of(text, "the speed of rapid moves", 25.0, 100.0)
        .map(|(at_s, percent)| (at_s, percent as u8))
}

/// The same of the spindle: a time and percent.
pub fn spindle_override(text: &str) -> Result<(f64, u8), String> {
    override_of(text, "a spindle", 10.0, 200.0).map(|(at_s, percent)| (at_s, percent as u8))
}

/// Reads a time and percent within bounds, of something that has a name.
fn override_of(text: &str, what: &str, least: f32, most: f32) -> Result<(f64, f32), String> {
    let (percent, at) = text.split_once('@').ok_or("give PERCENT@SECONDS, as 50@3.5")?;
    let percent = percent.trim().trim_end_matches('%').parse().ok();
    let percent = percent.filter(|p: &f32| (least..=most).contains(p));
    let at_s = at.trim().parse().ok().filter(|t: &f64| t.is_finite() && *t >= 0.0);
    match (percent, at_s) {
        (None, _) => Err(format!("{what} is overridden by {least} to {most} percent")),
        (_, None) => Err("the time is a number of seconds, 0 or more".into()),
        (Some(percent), Some(at_s)) => Ok((at_s, percent)),
    }
}

/// `NAME=VALUE`; a leading `&` is left out, a value that reads as a number is one.
pub fn variable(text: &str) -> Result<(String, Value), String> {
    let (name, value) = text.split_once('=').ok_or("give NAME=VALUE, as depth=0.25")?;
    let name = name.trim().trim_start_matches('&');
    let letters = |c: char| c.is_alphanumeric() || c == '_';
    if name.is_empty() || !name.chars().all(letters) {
        return Err("a variable's name has letters, digits and underscores".into());
    }
    let value = value.trim();
    let number = value.parse().ok().filter(|n: &f64| n.is_finite());
    let number = number.filter(|_| !value.contains(['n', 'N', 'i', 'I']));
    Ok((name.to_owned(), number.map_or_else(|| Value::text(value), Value::Number)))
}

/// One number for all three, or `X,Y,Z`.
pub fn three(text: &str) -> Result<[f64; 3], String> {
    let numbers: Result<Vec<f64>, _> = text.split(',').map(|part| part.trim().parse()).collect();
    match numbers.as_deref() {
        Ok(&[all]) if all.is_finite() => Ok([all; 3]),
        Ok(&[x, y, z]) if [x, y, z].iter().all(|n| n.is_finite()) => Ok([x, y, z]),
        _ => Err("give three numbers with commas between, X,Y,Z".into()),
    }
}

/// Three numbers as X,Y,Z, all 0 or greater.
pub fn three_not_negative(text: &str) -> Result<[f64; 3], String> {
    let all = three(text)?;
    let fit = all.iter().all(|n| *n >= 0.0);
    fit.then_some(all).ok_or_else(|| "give numbers, 0 or greater".into())
}

/// A size, both lengths 0 or more.
pub fn size(text: &str) -> Result<[f64; 2], String> {
    let numbers: Result<Vec<f64>, _> = text.split(',').map(|part| part.trim().parse()).collect();
    match numbers.as_deref() {
        Ok(&[x, y]) if [x, y].iter().all(|n| n.is_finite() && *n >= 0.0) => Ok([x, y]),
        _ => Err("give two lengths with a comma between, X,Y".into()),
    }
}

/// A place as X,Y.
pub fn place(text: &str) -> Result<[f64; 2], String> {
    let numbers: Result<Vec<f64>, _> = text.split(',').map(|part| part.trim().parse()).collect();
    match numbers.as_deref() {
        Ok(&[x, y]) if [x, y].iter().all(|n| n.is_finite()) => Ok([x, y]),
        _ => Err("give a place as X,Y".into()),
    }
}

/// Three numbers as X,Y,Z, all greater than 0.
pub fn three_positive(text: &str) -> Result<[f64; 3], String> {
    let all = three(text)?;
    let positive = all.iter().all(|n| *n > 0.0);
    positive.then_some(all).ok_or_else(|| "give numbers greater than 0".into())
}

/// A number, 0 or greater.
pub fn not_negative(text: &str) -> Result<f64, String> {
    number(text).ok().filter(|n| *n >= 0.0).ok_or_else(|| "give a number, 0 or greater".into())
}

/// An angle between directions, 0 to 180.
pub fn degrees(text: &str) -> Result<f64, String> {
    let angle = number(text).ok().filter(|n| (0.0..=180.0).contains(n));
    angle.ok_or_else(|| "give degrees from 0 to 180".into())
}

/// A share of an acceleration, 1 to 100.
pub fn percent(text: &str) -> Result<f64, String> {
    let percent = number(text).ok().filter(|n| (1.0..=100.0).contains(n));
    percent.ok_or_else(|| "give percent from 1 to 100".into())
}

/// `shopbot`, `profiler` or `optimal`.
pub fn ramps(text: &str) -> Result<RampModel, String> {
    let models = [RampModel::Shopbot, RampModel::Profiler, RampModel::Optimal];
    let named = models.into_iter().find(|m| m.word() == text);
    named.ok_or_else(|| "give shopbot, profiler or optimal".into())
}

/// A number greater than 0.
pub fn positive(text: &str) -> Result<f64, String> {
    number(text).ok().filter(|n| *n > 0.0).ok_or_else(|| "give a number greater than 0".into())
}

/// Any finite number.
pub fn number(text: &str) -> Result<f64, String> {
    let number = text.parse().ok().filter(|n: &f64| n.is_finite());
    number.ok_or_else(|| "give a number".into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inputs_are_number_time_and_state() {
        assert_eq!(input("3@2.5=1"), Ok(Change { input: 3, at_s: 2.5, on: true }));
        assert_eq!(input("12@0=0"), Ok(Change { input: 12, at_s: 0.0, on: false }));
        assert_eq!(input("arc@1.62=1"), Ok(Change { input: 18, at_s: 1.62, on: true }));
        assert_eq!(input("cable@3=0").map(|change| change.input), Ok(kerf_model::CABLE));
        for wrong in ["", "3", "3@1", "3=1", "0@1=1", "13@1=1", "3@-1=1", "3@nan=1", "3@1=2"] {
            assert!(input(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn hand_moves_are_axis_time_and_distance() {
        assert_eq!(hand_move("x@2.5=-1"), Ok(Push { axis: Axis::X, at_s: 2.5, by: -1.0 }));
        for wrong in ["", "x", "x@1", "x=1", "xy@1=1", "w@1=1", "x@-1=1", "x@1=far"] {
            assert!(hand_move(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn variables_hold_numbers_or_text() {
        assert_eq!(variable("&Depth=-.25"), Ok(("Depth".into(), Value::Number(-0.25))));
        assert_eq!(variable("name=a=b"), Ok(("name".into(), Value::text("a=b"))));
        assert_eq!(variable("x=inf"), Ok(("x".into(), Value::text("inf"))));
        assert!(variable("=3").is_err() && variable("a b=3").is_err() && variable("a").is_err());
    }

    #[test]
    fn three_numbers_or_one_for_all() {
        assert_eq!(three("1, 2,.5"), Ok([1.0, 2.0, 0.5]));
        assert_eq!(three("2"), Ok([2.0; 3]));
        assert!(three("1,2").is_err() && three("1,2,x").is_err() && three("nan").is_err());
    }
}
