//! The motors: how many steps each has made (command reference, VI and VU).
//!
//! A driver channel turns its motor for the axis it is given; an axis on two channels turns both.

use kerf_program::{AXES, Axes, Settings};

/// The motors of the six driver channels.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Motors {
    /// Steps made, with the part of a step still to come.
    turned: [f64; AXES],
    /// Places of the axes when that was worked out, machine frame.
    seen: Axes,
}

impl Motors {
    /// The axes have moved to a place under these settings. Without steps (VI, Enable) the location
    /// changes and the motors stand.
    pub(crate) fn follow(&mut self, place: Axes, settings: &Settings) {
        let way = place.minus(self.seen);
        self.seen = place;
        if !settings.driver.enabled {
            return;
        }
        for (turned, axis) in self.turned.iter_mut().zip(settings.driver.channels) {
            *turned += way[axis] * settings.resolution.steps_per_unit[axis];
        }
    }

    /// The axes are said to be elsewhere; no motor turned.
    pub(crate) const fn say(&mut self, place: Axes) {
        self.seen = place;
    }

    /// Whole steps of each motor, channel 1 first.
    pub(crate) fn steps(&self) -> [i64; AXES] {
        self.turned.map(|steps| steps.round() as i64)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use kerf_program::Axis;

    fn check(edit: impl FnOnce(&mut Settings), expected: [i64; AXES]) {
        let mut settings = Settings::default();
        edit(&mut settings);
        let mut motors = Motors::default();
        motors.follow(Axes([25.4, 50.8, 0.0, 0.0, 360.0, 0.0]), &settings);
        assert_eq!(motors.steps(), expected);
    }

    #[test]
    fn a_motor_turns_for_the_axis_of_its_channel() {
        check(|_| {}, [400, 800, 0, 0, 5000, 0]);
        check(|s| s.driver.channels[0] = Axis::Y, [800, 800, 0, 0, 5000, 0]);
        check(|s| s.resolution.steps_per_unit[Axis::X] *= -2.0, [-800, 800, 0, 0, 5000, 0]);
        check(|s| s.driver.enabled = false, [0; AXES]);
    }

    #[test]
    fn steps_do_not_gather_rounding() {
        let settings = Settings::default();
        let mut motors = Motors::default();
        for i in 1..=100_000 {
            motors.follow(Axes::xyz(f64::from(i) * 0.0127, 0.0, 0.0), &settings);
        }
        assert_eq!(motors.steps()[0], 20_000);
    }
}
