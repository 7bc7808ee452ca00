//! MD: so far in a direction.

use crate::run::cutting;
use crate::run::{Arguments, Context, Stop};
use crate::syntax::Value;
use crate::syntax::value::parse_number;
use kerf_diag::Code;
use kerf_geom::Vec2;
use kerf_program::{Axes, Axis, MoveKind};

/// Moves by a length and a direction.
pub(super) fn go(c: &mut Context<'_>, a: &Arguments) -> Result<(), Stop> {
    let length = a.number_or(0, 0.0);
    let along = kerf_geom::clock_to_vec(angle(c, a)?) * length;
    for axis in [Axis::X, Axis::Y] {
        c.need_axis(axis)?;
    }
    let z = z_change(c, a)?;
    let mut to = c.core.place.position;
    for (axis, distance) in [(Axis::X, along.x), (Axis::Y, along.y)] {
        to[axis] = c.core.shifted(axis, distance * c.core.flow.proportion(axis));
    }
    if let Some(change) = z {
        move_z(c, &mut to, change);
    }
    cutting::line(c, MoveKind::Cut, to);
    Ok(())
}

/// Change of Z by the third value, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Change {
    To(f64),
    By(f64),
}

fn move_z(c: &mut Context<'_>, to: &mut Axes, change: Change) {
    let proportion = c.core.flow.proportion(Axis::Z);
    to[Axis::Z] = match change {
        Change::To(z) => {
            c.core.with_tool_offset(Axis::Z, c.core.file_zero(Axis::Z) + z * proportion)
        }
        Change::By(z) => c.core.shifted(Axis::Z, z * proportion),
    };
}

/// Clock angle of the move in the file's own frame, degrees.
fn angle(c: &Context<'_>, a: &Arguments) -> Result<f64, Stop> {
    let text = match a.value(1) {
        Some(Value::Number(n)) => return Ok(*n),
        other => other.map(Value::display).unwrap_or_default(),
    };
    let text = text.trim().to_ascii_uppercase();
    relative(c, &text)
        .or_else(|| clock(&text))
        .or_else(|| compass(&text))
        .or_else(|| parse_number(&text))
        .ok_or_else(|| {
            let message = format!("'{text}' is not a direction");
            let hint =
                "write degrees (45), a turn (90R, 30L), a time (1:30) or a compass point (NNE)";
            c.fail_at(a.span(1), Code::OutOfRange, message, hint)
        })
}

/// `90R`, `30L`: from the direction of the last move; without one from +Y, turned clockwise.
fn relative(c: &Context<'_>, text: &str) -> Option<f64> {
    let (number, right) = match text.strip_suffix('R') {
        Some(number) => (number, true),
        None => (text.strip_suffix('L')?, false),
    };
    let turn = parse_number(number)?;
    Some(match heading(c) {
        None => turn,
        Some(last) if right => last + turn,
        Some(last) => last - turn,
    })
}

/// Direction of the last move as the file sees it: proportions of the file taken out.
fn heading(c: &Context<'_>) -> Option<f64> {
    let seen = kerf_geom::clock_to_vec(c.core.cutting.heading?);
    let scale = [Axis::X, Axis::Y].map(|axis| c.core.flow.proportion(axis));
    if scale[0] == scale[1] && scale[0] > 0.0 {
        return c.core.cutting.heading;
    }
    Some(kerf_geom::vec_to_clock(Vec2::new(seen.x / scale[0], seen.y / scale[1])))
}

/// `7:30`: where the hour hand points.
fn clock(text: &str) -> Option<f64> {
    let (hours, minutes) = text.split_once(':')?;
    let (hours, minutes) = (parse_number(hours)?, parse_number(minutes)?);
    let sane = (0.0..=12.0).contains(&hours) && (0.0..60.0).contains(&minutes);
    sane.then(|| (30.0 * hours + 0.5 * minutes).rem_euclid(360.0))
}

const POINTS: [&str; 16] = [
    "N", "NNE", "NE", "ENE", "E", "ESE", "SE", "SSE", "S", "SSW", "SW", "WSW", "W", "WNW", "NW",
    "NNW",
];

fn compass(text: &str) -> Option<f64> {
    Some(POINTS.iter().position(|point| *point == text)? as f64 * 22.5)
}

fn z_change(c: &Context<'_>, a: &Arguments) -> Result<Option<Change>, Stop> {
    let Some(value) = a.value(2) else { return Ok(None) };
    c.need_axis(Axis::Z)?;
    let scale = c.settings().axis_scale(Axis::Z);
    let text = value.display().trim().to_ascii_uppercase();
    let by = |suffix: char, sign: f64| {
        Some(Change::By(parse_number(text.strip_suffix(suffix)?)? * sign * scale))
    };
    let to = || Some(Change::To(value.number()? * scale));
    by('U', 1.0).or_else(|| by('D', -1.0)).or_else(to).map(Some).ok_or_else(|| {
        let message = format!("'{}' is no change of Z", value.display());
        let hint = "write a location (-0.5), or up or down by so much (.25U, .25D)";
        c.fail_at(a.span(2), Code::OutOfRange, message, hint)
    })
}
