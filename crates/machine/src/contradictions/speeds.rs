//! Speeds that exceed those of the axis that makes them.

use super::Contradiction;
use crate::Configuration;
use crate::settings::height::HeightControl;
use kerf_program::Axis;
use kerf_program::settings::AxisUnit;

type Found = Vec<Contradiction>;

/// One value and the axis' own that it may not exceed.
struct Share {
    key: &'static str,
    value: f64,
    axis: Axis,
    most: f64,
    unit: &'static str,
}

const HINT: &str = "Lower it, or raise what the axis can do (dynamics).";

/// The last bits of a conversion from mm/min are no excess.
fn beyond(value: f64, most: f64) -> bool {
    value > most * (1.0 + 1e-9)
}

impl Share {
    fn check(&self, of: &'static str, found: &mut Found) {
        if beyond(self.value, self.most) {
            let Self { key, value, axis, most, unit } = self;
            let message = format!("{key} is {value} {unit}, axis {} reaches {most}", axis.letter());
            found.push(Contradiction::new(&[key, of], message, HINT));
        }
    }
}

const SPEED: &str = "dynamics.speed_mm_s";
const ACCEL: &str = "dynamics.accel_mm_s2";

/// Cutting and plunging ("Maximum Machine Cutting Speeds").
pub(super) fn cutting(c: &Configuration, found: &mut Found) {
    let most = c.program.axis_dynamics().speed_mm_s;
    let cut = c.program.smoothing.cut_speed_mm_s.unwrap_or(0.0);
    let shares = [
        ("smoothing.cut_speed_mm_s", cut, Axis::X),
        ("plunge.speed_mm_s", c.speeds.plunge_mm_s, Axis::Z),
    ];
    for (key, value, axis) in shares {
        if beyond(value, most[axis]) {
            let [value_min, most_min] = [value, most[axis]].map(|v| (v * 6e4).round() / 1e3);
            let message = format!(
                "{key} is {value} mm/s ({value_min} mm/min), axis {} reaches {} ({most_min})",
                axis.letter(),
                most[axis]
            );
            found.push(Contradiction::new(&[key, SPEED], message, HINT));
        }
    }
}

/// Height control ("Automatic Height Control"). What nobody has set binds only where it is on: a slow Z is no
/// mistake of a machine without it.
pub(super) fn height(c: &Configuration, found: &mut Found) {
    let (dynamics, axis, fresh) = (c.program.axis_dynamics(), Axis::Z, HeightControl::default());
    let (key, value) = ("height.speed_mm_s", c.height.speed_mm_s);
    let most = dynamics.speed_mm_s[axis];
    if c.height.on || value != fresh.speed_mm_s {
        Share { key, value, axis, most, unit: "mm/s" }.check(SPEED, found);
    }
    let (key, value) = ("height.accel_mm_s2", c.height.accel_mm_s2);
    let most = dynamics.accel_mm_s2[axis];
    if c.height.on || value != fresh.accel_mm_s2 {
        Share { key, value, axis, most, unit: "mm/s²" }.check(ACCEL, found);
    }
}

const HOMING: [[&str; 2]; 6] = [
    ["homing.x.fast", "homing.x.slow"],
    ["homing.y.fast", "homing.y.slow"],
    ["homing.z.fast", "homing.z.slow"],
    ["homing.a.fast", "homing.a.slow"],
    ["homing.b.fast", "homing.b.slow"],
    ["homing.w.fast", "homing.w.slow"],
];

/// The search for home, of axes that have a switch.
pub(super) fn homing(c: &Configuration, found: &mut Found) {
    let most = c.program.axis_dynamics().speed_mm_s;
    for (axis, [fast, slow]) in Axis::ALL.into_iter().zip(HOMING) {
        let switch = c.homing.of(axis);
        let unit = if c.program.axis_unit(axis) == AxisUnit::Degrees { "deg/s" } else { "mm/s" };
        for (key, value) in [(fast, switch.fast), (slow, switch.slow)] {
            if switch.fitted {
                Share { key, value, axis, most: most[axis], unit }.check(SPEED, found);
            }
        }
    }
}
