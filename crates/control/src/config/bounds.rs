//! Values of a configuration, checked against their bounds when they are set.

use super::{ConfigError, Group};
use kerf_program::Axes;
use kerf_program::settings::{PerGroup, SWITCHES};

pub(super) const POSITIVE: &str = "greater than 0";
pub(super) const NOT_NEGATIVE: &str = "0 or greater";
pub(super) const NUMBER: &str = "a finite number";

pub(super) fn positive(v: &f64) -> bool {
    v.is_finite() && *v > 0.0
}

pub(super) fn not_negative(v: &f64) -> bool {
    v.is_finite() && *v >= 0.0
}

pub(super) fn refused(key: &str, wanted: &'static str, got: String) -> ConfigError {
    ConfigError::Value { key: key.into(), wanted, got }
}

pub(super) fn set<T: std::fmt::Display>(
    place: &mut T,
    value: Option<T>,
    key: &str,
    wanted: &'static str,
    fits: impl Fn(&T) -> bool,
) -> Result<(), ConfigError> {
    match value {
        None => Ok(()),
        Some(value) if fits(&value) => {
            *place = value;
            Ok(())
        }
        Some(value) => Err(refused(key, wanted, value.to_string())),
    }
}

pub(super) fn group(
    place: &mut PerGroup,
    group: Option<Group>,
    key: &str,
    wanted: &'static str,
    fits: fn(&f64) -> bool,
) -> Result<(), ConfigError> {
    let Some(g) = group else { return Ok(()) };
    for (place, value, letter) in [
        (&mut place.xy, g.xy, "xy"),
        (&mut place.z, g.z, "z"),
        (&mut place.a, g.a, "a"),
        (&mut place.b, g.b, "b"),
        (&mut place.c, g.c, "c"),
    ] {
        set(place, value, &format!("{key}.{letter}"), wanted, fits)?;
    }
    Ok(())
}

/// The first axes have values.
pub(super) fn axes(
    place: &mut Axes,
    values: Option<&Vec<f64>>,
    key: &str,
    wanted: &'static str,
    fits: fn(&f64) -> bool,
) -> Result<(), ConfigError> {
    list(&mut place.0, values, key, wanted, fits)
}

pub(super) fn modes(
    place: &mut [u8; SWITCHES],
    values: Option<&Vec<u8>>,
    key: &str,
    wanted: &'static str,
    most: u8,
) -> Result<(), ConfigError> {
    list(place, values, key, wanted, |mode| *mode <= most)
}

pub(super) fn list<T: Copy + std::fmt::Display>(
    place: &mut [T],
    values: Option<&Vec<T>>,
    key: &str,
    wanted: &'static str,
    fits: impl Fn(&T) -> bool,
) -> Result<(), ConfigError> {
    let values = values.map_or(&[][..], Vec::as_slice);
    if values.len() > place.len() {
        return Err(refused(key, "a shorter list", format!("{} values", values.len())));
    }
    for (place, value) in place.iter_mut().zip(values) {
        set(place, Some(*value), key, wanted, &fits)?;
    }
    Ok(())
}
