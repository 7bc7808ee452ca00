//! Axes that move beside the others (command reference, MI).

use kerf_program::Independent;

/// Motion of an axis beside the planned one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Spin {
    since_s: f64,
    motion: Independent,
    /// Displacement when it began.
    begun_at: f64,
}

impl Default for Spin {
    fn default() -> Self {
        Self { since_s: 0.0, motion: Independent::Off, begun_at: 0.0 }
    }
}

impl Spin {
    /// Goes on from where it is with another motion.
    pub(crate) fn change(&mut self, t_s: f64, motion: Independent) {
        *self = Self { begun_at: self.displacement(t_s), since_s: t_s, motion };
    }

    /// Displacement from the planned position, mm or degrees.
    pub(crate) fn displacement(&self, t_s: f64) -> f64 {
        let for_s = (t_s - self.since_s).max(0.0);
        let moved = match self.motion {
            Independent::Off => 0.0,
            Independent::Rotate(speed) => speed * for_s,
            // The displacement of MI is peak to peak about the start.
            Independent::Oscillate { frequency_hz, distance } => {
                0.5 * distance * (std::f64::consts::TAU * frequency_hz * for_s).sin()
            }
        };
        self.begun_at + moved
    }

    /// Stops; the displacement so far belongs to the planned position from here on.
    pub(crate) fn end(&mut self, t_s: f64) -> f64 {
        std::mem::take(self).displacement(t_s)
    }

    /// The same motion, told from a clock that was set back by so much.
    pub(crate) fn set_back(&mut self, by_s: f64) {
        self.since_s -= by_s;
    }

    /// Returns its motion now.
    pub(crate) const fn motion(&self) -> Independent {
        self.motion
    }

    /// Tells whether it moves.
    pub(crate) fn moves(&self) -> bool {
        self.motion != Independent::Off
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turns_and_stays_where_it_was_stopped() {
        let mut spin = Spin::default();
        spin.change(1.0, Independent::Rotate(-30.0));
        assert_eq!(spin.displacement(11.0), -300.0);
        spin.change(11.0, Independent::Off);
        assert_eq!(spin.displacement(99.0), -300.0);
        assert!(!spin.moves());
        assert_eq!((spin.end(99.0), spin.displacement(99.0)), (-300.0, 0.0));
    }

    #[test]
    fn swings_about_its_start() {
        let mut spin = Spin::default();
        spin.change(0.0, Independent::Oscillate { frequency_hz: 2.0, distance: 0.5 });
        assert!((spin.displacement(0.125) - 0.25).abs() < 1e-12);
        assert!(spin.displacement(0.25).abs() < 1e-12);
        assert!((spin.displacement(0.375) + 0.25).abs() < 1e-12);
    }
}
