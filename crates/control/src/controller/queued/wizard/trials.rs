//! Speed and acceleration by trial: faster each time, as far as somebody who watches says that it was good.

use super::question::{Question, Step, WAY_MM, unit};
use super::{AXES, Told, Wizard};
use crate::controller::queued::AxisMove;
use kerf_program::Axis;

/// The first speed, and the highest one, mm/s.
const SPEEDS_MM_S: [f64; 2] = [10.0, 640.0];
/// The first acceleration, and the highest one, mm/s².
const ACCELERATIONS_MM_S2: [f64; 2] = [100.0, 12_800.0];
/// Share of the last one that was good which is kept.
const KEPT: f64 = 0.5;

/// A quantity that is tried.
#[derive(Clone, Copy)]
enum Tried {
    Speed,
    Acceleration,
}

impl Tried {
    const fn words(self) -> &'static str {
        match self {
            Self::Speed => "speed",
            Self::Acceleration => "acceleration",
        }
    }

    const fn per(self) -> &'static str {
        match self {
            Self::Speed => "/s",
            Self::Acceleration => "/s²",
        }
    }

    /// The questions before the trials and behind each.
    const fn steps(self) -> [Step; 2] {
        match self {
            Self::Speed => [Step::TrySpeed, Step::SpeedGood],
            Self::Acceleration => [Step::TryAcceleration, Step::AccelerationGood],
        }
    }

    const fn range(self) -> [f64; 2] {
        match self {
            Self::Speed => SPEEDS_MM_S,
            Self::Acceleration => ACCELERATIONS_MM_S2,
        }
    }
}

impl Wizard<'_, '_> {
    /// Tries speeds and accelerations of each axis.
    pub(super) fn trials(&mut self) -> Told {
        let axes = self.board()?.axes();
        for (axis, ..) in AXES.into_iter().filter(|(axis, ..)| axes.contains(*axis)) {
            self.tries(axis, Tried::Speed)?;
            self.tries(axis, Tried::Acceleration)?;
        }
        Ok(())
    }

    /// Tries higher and higher values, and keeps half of the last one that was good.
    fn tries(&mut self, axis: Axis, tried: Tried) -> Told {
        let (letter, unit) = (axis.letter(), unit(axis));
        let [what, per] = [tried.words(), tried.per()];
        let [wanted, good_at] = tried.steps();
        if self.ask(Question::of(wanted, letter, ""))? != "y" {
            return Ok(());
        }
        let [mut value, most] = tried.range();
        let (before, mut good) = (self.machine.program.dynamics, None);
        while value <= most {
            self.put(axis, tried, value);
            let mm_s = self.machine.program.axis_dynamics().speed_mm_s[axis];
            for to_mm in [WAY_MM, 0.0] {
                self.way(AxisMove { axis, to_mm, mm_s })?;
            }
            if self.ask(Question::of(good_at, letter, value))? == "n" {
                break;
            }
            good = Some(value);
            value *= 2.0;
        }
        let Some(good) = good else {
            self.machine.program.dynamics = before;
            self.tell(&format!(
                "{letter}: no {what} was good, its own is kept: look at its current and its load"
            ));
            return Ok(());
        };
        let kept = KEPT * good;
        self.put(axis, tried, kept);
        self.tell(&format!("{letter}: at most {kept} {unit}{per}"));
        Ok(())
    }

    /// Sets a limit of an axis. Homing is never faster than the axis.
    fn put(&mut self, axis: Axis, tried: Tried, value: f64) {
        let mut dynamics = self.machine.program.axis_dynamics();
        match tried {
            Tried::Speed => dynamics.speed_mm_s[axis] = value,
            Tried::Acceleration => dynamics.accel_mm_s2[axis] = value,
        }
        self.machine.program.dynamics = Some(dynamics);
        let most = dynamics.speed_mm_s[axis];
        let home = &mut self.machine.homing.switches[axis.index()];
        if matches!(tried, Tried::Speed) {
            (home.fast, home.slow) = (home.fast.min(most), home.slow.min(most));
        }
    }
}
