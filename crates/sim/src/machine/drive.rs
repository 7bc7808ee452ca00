//! Power, steps and resolution of the motors (command reference, MO, VI, VU).

use super::Machine;
use crate::hand::Push;
use crate::log::What;
use kerf_program::{AXES, Axes, AxisSet, MoveKind, OutputReason};

/// Factors of steps that are not made coarser.
const FINE: [u8; AXES] = [1; AXES];

impl Machine {
    /// Steps each motor has made, driver channel 1 first.
    pub fn steps(&self) -> [i64; AXES] {
        let mut motors = self.motors.clone();
        if !self.draws() {
            motors.follow(self.true_position(), &self.settings);
        }
        motors.steps()
    }

    /// Axes that may have been moved while the motors had no power, and whose location nobody has
    /// set since.
    pub const fn unverified(&self) -> AxisSet {
        self.unverified
    }

    /// The same machine, whose locations of these axes nobody has verified since an earlier session.
    #[must_use]
    pub fn doubting(mut self, axes: AxisSet) -> Self {
        axes.iter().for_each(|axis| self.unverified.insert(axis));
        self
    }

    /// The same machine, whose locations of these axes somebody has verified.
    #[must_use]
    pub fn trusting(mut self, axes: AxisSet) -> Self {
        axes.iter().for_each(|axis| self.unverified.remove(axis));
        self
    }

    /// The same machine, pushed by hand at these times.
    #[must_use]
    pub fn pushed(mut self, script: Vec<Push>) -> Self {
        let to_come = script.into_iter().filter(|push| push.at_s >= self.clock_s).collect();
        self.hand.follow(to_come);
        self
    }

    /// Returns how far axes are from where the controller believes them, because somebody pushed them: what only the
    /// simulation knows, mm or degrees.
    pub const fn astray(&self) -> Axes {
        self.hand.astray
    }

    /// An axis is pushed by hand: its motor holds it, or it gives way and nobody notices.
    pub(super) fn push(&mut self, push: Push) {
        let by = if self.powered || self.draws() { 0.0 } else { push.by };
        self.hand.astray[push.axis] += by;
        self.carriages.pushed(push.axis, by, self.position);
        let what = What::Pushed { axis: push.axis, by };
        self.log.add(push.at_s.max(self.clock_s), what);
    }

    /// Nobody knows for sure where the axes are from now on.
    pub fn doubt(&mut self) -> AxisSet {
        self.unverified = AxisSet::first(usize::from(self.settings.axis_count));
        self.unverified
    }

    /// Cuts motor power; everything that moves or is on stops (MO).
    pub fn motors_off(&mut self) {
        if self.draws() {
            return;
        }
        self.spins_off();
        self.set_light(false);
        self.all_off(OutputReason::Stop);
        self.power_motors(false);
        self.doubt();
    }

    pub(super) fn power_motors(&mut self, on: bool) {
        if std::mem::replace(&mut self.powered, on) != on {
            self.log.add(self.clock_s, What::Motors(on));
        }
    }

    /// The motors have brought the axes to where they are.
    pub(super) fn follow_motors(&mut self) {
        if !self.draws() {
            self.motors.follow(self.true_position(), &self.settings);
        }
    }

    /// Steps are coarser during jogs, unless shifting is disabled.
    pub(super) fn shift_resolution(&mut self, moving: Option<MoveKind>) {
        let resolution = &self.settings.resolution;
        let shifted = moving == Some(MoveKind::Jog) && !resolution.no_shift;
        let factors = if shifted { resolution.multipliers } else { FINE };
        if !self.draws() && std::mem::replace(&mut self.coarse, factors) != factors {
            self.log.add(self.clock_s, What::Resolution(factors));
        }
    }
}
