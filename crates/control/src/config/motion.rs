//! The parts of a configuration that say how the machine moves.

use super::bounds::{NOT_NEGATIVE, POSITIVE, group, not_negative, positive, set};
use super::{ConfigError, Group};
use kerf_program::settings::{Ramps, Settings};
use kerf_program::{Axes, Axis, Dynamics};
use serde::Deserialize;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RampValues {
    cut: Option<Group>,
    jog: Option<Group>,
    cut_rate_mm: Option<f64>,
    jog_rate_mm: Option<f64>,
    threshold_3d_percent: Option<f64>,
    min_distance_mm: Option<f64>,
    slow_corner_percent: Option<f64>,
    small_circle_mm: Option<f64>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct SmoothingValues {
    factor: Option<f64>,
    stop_angle_deg: Option<f64>,
    centripetal_percent: Option<f64>,
    cut_speed_mm_s: Option<f64>,
    y_factor: Option<f64>,
}

impl RampValues {
    pub fn apply(&self, s: &mut Ramps) -> Result<(), ConfigError> {
        group(&mut s.cut, self.cut, "ramps.cut", NOT_NEGATIVE, not_negative)?;
        group(&mut s.jog, self.jog, "ramps.jog", NOT_NEGATIVE, not_negative)?;
        for (place, value, key) in [
            (&mut s.cut_rate_mm, self.cut_rate_mm, "ramps.cut_rate_mm"),
            (&mut s.jog_rate_mm, self.jog_rate_mm, "ramps.jog_rate_mm"),
        ] {
            set(place, value, key, POSITIVE, positive)?;
        }
        for (place, value, key) in [
            (&mut s.threshold_3d_percent, self.threshold_3d_percent, "ramps.threshold_3d_percent"),
            (&mut s.min_distance_mm, self.min_distance_mm, "ramps.min_distance_mm"),
            (&mut s.slow_corner_percent, self.slow_corner_percent, "ramps.slow_corner_percent"),
            (&mut s.small_circle_mm, self.small_circle_mm, "ramps.small_circle_mm"),
        ] {
            set(place, value, key, NOT_NEGATIVE, not_negative)?;
        }
        Ok(())
    }
}

impl SmoothingValues {
    pub fn apply(&self, s: &mut Settings) -> Result<(), ConfigError> {
        let x_mm_s = s.axis_dynamics().speed_mm_s[Axis::X];
        let smoothing = &mut s.smoothing;
        set(&mut smoothing.factor, self.factor, "smoothing.factor", NOT_NEGATIVE, not_negative)?;
        let angle = &mut smoothing.stop_angle_deg;
        let half_turn = |v: &f64| (0.0..=180.0).contains(v);
        set(angle, self.stop_angle_deg, "smoothing.stop_angle_deg", "0 to 180", half_turn)?;
        let percent = &mut smoothing.centripetal_percent;
        let share = |v: &f64| (1.0..=100.0).contains(v);
        let key = "smoothing.centripetal_percent";
        set(percent, self.centripetal_percent, key, "1 to 100", share)?;
        set(&mut smoothing.y_factor, self.y_factor, "smoothing.y_factor", POSITIVE, positive)?;
        if let Some(speed) = self.cut_speed_mm_s {
            let wanted = "greater than 0 and at most the speed of the X axis";
            let fits = |v: &f64| *v > 0.0 && *v <= x_mm_s;
            set(&mut 0.0, Some(speed), "smoothing.cut_speed_mm_s", wanted, fits)?;
            smoothing.cut_speed_mm_s = Some(speed);
        }
        Ok(())
    }
}

pub(super) fn check_dynamics(d: &Dynamics) -> Result<(), ConfigError> {
    let jerk = d.jerk_mm_s3.unwrap_or(Axes::splat(1.0));
    for (values, key) in [
        (d.speed_mm_s, "dynamics.speed_mm_s"),
        (d.accel_mm_s2, "dynamics.accel_mm_s2"),
        (jerk, "dynamics.jerk_mm_s3"),
    ] {
        for value in values.0 {
            set(&mut 0.0, Some(value), key, POSITIVE, positive)?;
        }
    }
    set(&mut 0.0, Some(d.tolerance_mm), "dynamics.tolerance_mm", NOT_NEGATIVE, not_negative)
}

#[cfg(test)]
#[allow(clippy::unwrap_used, non_snake_case)] // rows and their variants
mod tests {
    use crate::config::settings;

    /// What is refused of the smoothing values, a line each.
    fn check(lines: &str, part: &str) {
        let error = settings(&format!("[smoothing]\n{lines}")).unwrap_err().to_string();
        assert!(error.contains(part), "{lines}: {error}");
    }

    #[test]
    fn pro_smoothing_default__negative_refused() {
        assert_eq!(settings("").unwrap().smoothing.factor, 0.6);
        check("factor = -0.1", "smoothing.factor must be 0 or greater, not -0.1");
    }

    #[test]
    fn pro_smoothing_stop_default__bounds() {
        assert_eq!(settings("").unwrap().smoothing.stop_angle_deg, 1.0);
        for angle in ["-0.1", "181"] {
            check(&format!("stop_angle_deg = {angle}"), "stop_angle_deg must be 0 to 180");
        }
    }

    #[test]
    fn pro_smoothing_saved() {
        let s = settings("[smoothing]\nfactor = 0.8\nstop_angle_deg = 2.0").unwrap().smoothing;
        assert_eq!((s.factor, s.stop_angle_deg, s.centripetal_percent), (0.8, 2.0, 100.0));
    }

    #[test]
    fn pro_speeds_centripetal__bounds() {
        for percent in ["0", "101"] {
            check(&format!("centripetal_percent = {percent}"), "percent must be 1 to 100");
        }
        let s = settings("[smoothing]\ncentripetal_percent = 50").unwrap();
        assert_eq!(s.smoothing.centripetal_percent, 50.0);
    }

    #[test]
    fn pro_speeds_cut() {
        let with = |mm_s: &str| {
            settings(&format!(
                "[dynamics]\nspeed_mm_s = [200, 200, 50, 1, 1, 1]\n\
                accel_mm_s2 = [1, 1, 1, 1, 1, 1]\ntolerance_mm = 0\n\
                [smoothing]\ncut_speed_mm_s = {mm_s}"
            ))
        };
        assert_eq!(with("200").unwrap().smoothing.cut_speed_mm_s, Some(200.0));
        // 12001 mm/min
        let error = with("200.017").unwrap_err().to_string();
        assert!(error.contains("at most the speed of the X axis, not 200.017"), "{error}");
    }
}
