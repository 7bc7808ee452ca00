//! MI: an axis that turns or swings beside the others. MO: motors off.

use crate::run::registry;
use crate::run::{Arguments, Context, Stop};
use crate::syntax::format_number;
use kerf_diag::Code;
use kerf_program::settings::to_user;
use kerf_program::{Axis, AxisSet, Command, Independent, Settings};

/// Above this motors rarely follow (command reference, MI).
const FAST_HZ: f64 = 30.0;

/// Starts, changes or stops an axis that moves beside the others.
pub(super) fn start(c: &mut Context<'_>, a: &Arguments) -> Result<(), Stop> {
    let axis = a.axis(0).unwrap_or(Axis::B);
    c.need_active(axis)?;
    let motion = motion(c, a, axis)?;
    refuse_too_fast(c, a, axis, motion)?;
    if motion == Independent::Off {
        if c.core.place.independent.contains(axis) {
            c.core.place.adrift.insert(axis);
        }
        c.core.place.independent.remove(axis);
    } else {
        c.core.place.independent.insert(axis);
    }
    c.emit(Command::Independent { axis, motion });
    Ok(())
}

fn motion(c: &mut Context<'_>, a: &Arguments, axis: Axis) -> Result<Independent, Stop> {
    let scale = c.settings().axis_scale(axis);
    match (a.number(2), a.number(3), a.number(4)) {
        (Some(speed), Some(frequency), _) if speed > 0.0 && frequency > 0.0 => {
            let hint = "a speed turns the axis, a frequency swings it";
            let message = "a rotary speed and a frequency exclude each other";
            Err(c.fail_at(a.span(3), Code::OutOfRange, message, hint))
        }
        (Some(speed), _, _) if speed > 0.0 => {
            Ok(Independent::Rotate(a.number_or(1, 1.0) * speed * scale))
        }
        (_, Some(frequency), distance) if frequency > 0.0 => {
            let Some(distance) = distance else {
                let hint = "how far the axis swings from one end to the other";
                return Err(c.fail_at(
                    a.span(4),
                    Code::MissingParameter,
                    "distance expected",
                    hint,
                ));
            };
            if frequency > FAST_HZ {
                let hint = "most motors follow up to 30 cycles a second";
                c.warn(Code::Unusual, "a very fast oscillation", hint);
            }
            Ok(Independent::Oscillate { frequency_hz: frequency, distance: distance * scale })
        }
        (Some(_), _, _) | (_, Some(_), _) => Ok(Independent::Off),
        (None, None, _) => {
            let hint = "give a rotary speed, or a frequency and a distance; 0 stops the axis";
            let message = "rotary speed or frequency expected";
            Err(c.fail_at(a.span(2), Code::MissingParameter, message, hint))
        }
    }
}

/// Multiple of the jog speed that counts as impossible where nobody says how fast an axis is. A guess.
const IMPOSSIBLE: f64 = 10.0;

/// Returns the highest speed of an axis, as far as the configuration tells that.
fn fastest_known(settings: &Settings, axis: Axis) -> f64 {
    match settings.dynamics {
        Some(dynamics) => dynamics.speed_mm_s[axis],
        None => IMPOSSIBLE * settings.speeds.jog.of(axis),
    }
}

/// Nothing is asked for that the axis cannot do, as far as the configuration tells that.
fn refuse_too_fast(
    c: &Context<'_>,
    a: &Arguments,
    axis: Axis,
    motion: Independent,
) -> Result<(), Stop> {
    if !c.settings().controller.independent {
        let hint = "driver.independent says whether axes can move beside the others";
        let message = "not supported by this controller";
        return Err(c.fail_at(a.span(0), Code::NotSupported, message, hint));
    }
    let (fastest, value) = match motion {
        Independent::Off => return Ok(()),
        Independent::Rotate(speed) => (speed.abs(), 2),
        // The middle of a sine is its fastest place.
        Independent::Oscillate { frequency_hz, distance } => {
            (std::f64::consts::PI * frequency_hz * distance, 3)
        }
    };
    let most = fastest_known(c.settings(), axis);
    if fastest <= most * (1.0 + 1e-9) {
        return Ok(());
    }
    let most = format_number(to_user(most, c.settings().axis_scale(axis)));
    let letter = axis.letter();
    let message = format!("{letter} axis moves {most} units a second at most");
    let hint = "dynamics.speed_mm_s of the machine's configuration says how fast each axis is";
    Err(c.fail_at(a.span(value), Code::OutOfRange, message, hint))
}

/// Cuts motor power; no axis is trusted to be where it was.
pub(super) fn motors_off(c: &mut Context<'_>) -> Result<(), Stop> {
    for axis in c.core.place.independent.iter() {
        c.core.place.adrift.insert(axis);
    }
    c.core.place.independent = AxisSet::EMPTY;
    c.emit(Command::MotorsOff);
    registry::remember_lost(c, AxisSet::first(c.settings().axis_count.into()));
    Ok(())
}
