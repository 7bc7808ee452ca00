//! A simulated machine between two runs: what is believed of it, and what there is around it.

use crate::physics::Physics;
use crate::pushes::Push;
use crate::scene::Touch;
use crate::sheet::Sheet;
use kerf_machine::Configuration;
use kerf_model::{Change, Inputs, Model};
use kerf_program::{Axes, AxisSet, Frame, Settings};
use std::sync::Arc;

/// Beliefs about a machine, and the carriages, switches and things that are simulated around it.
#[derive(Clone, Debug, Default)]
pub struct Simulation {
    /// Beliefs about it.
    pub model: Model,
    /// Switches and sensors, and what they feel. A run hands it to the machine that it drives.
    pub physics: Physics,
}

impl Simulation {
    /// Has what its switches feel change, and learns what they read then.
    fn around(&mut self, change: impl FnOnce(&mut Physics)) {
        change(&mut self.physics);
        self.model.knows(self.physics.known());
    }

    /// The machine after a run, ready for the next, which counts time from 0: what turns keeps turning, what is on stays
    /// on, motors keep their count.
    #[must_use]
    pub fn again(
        mut self,
        position: Axes,
        frame: Frame,
        settings: Arc<Settings>,
        inputs: Inputs,
    ) -> Self {
        self.model = self.model.again(position, frame, settings.clone());
        self.around(|physics| physics.again(settings, inputs));
        self
    }

    /// The same machine, whose run goes on from a moment: what its script of inputs did until then is told.
    #[must_use]
    pub fn begun_at(mut self, t_s: f64) -> Self {
        if t_s > 0.0 {
            self.model = self.model.begun_at(t_s);
            self.around(|physics| physics.begin_at(t_s));
        }
        self
    }

    /// The same machine, standing elsewhere while a preview is drawn.
    #[must_use]
    pub fn drawing_from(mut self, position: Axes) -> Self {
        self.model = self.model.drawing_from(position);
        self
    }

    /// The same machine with the switches, motors and lengths of a configuration; the lengths bound these axes. What is
    /// known of where its axes truly are stays, where it has as many motors as before.
    #[must_use]
    pub fn equipped(mut self, machine: &Configuration, bounded: AxisSet) -> Self {
        let believed = self.model.position();
        self.model = self.model.bounded(machine, bounded);
        self.around(|physics| physics.equip(machine, believed));
        self
    }

    /// The same machine, whose carriages are off by so much.
    #[must_use]
    pub fn with_truth(mut self, truth: &[Vec<f64>]) -> Self {
        let believed = self.model.position();
        self.around(|physics| physics.set_truth(truth, believed));
        self
    }

    /// The same machine with a sheet on its table, or without.
    #[must_use]
    pub fn with_sheet(mut self, sheet: Option<Sheet>) -> Self {
        self.physics.put_sheet(sheet);
        self
    }

    /// The same machine with things on its table that switches feel.
    #[must_use]
    pub fn with_touches(mut self, touches: &[Touch]) -> Self {
        let at = self.model.true_position();
        self.around(|physics| physics.put_touches(touches, &at));
        self
    }

    /// The same machine, whose switches somebody has left like this.
    #[must_use]
    pub fn with_switches(mut self, switches: &[(u8, bool)]) -> Self {
        switches.iter().for_each(|(input, on)| self.press(*input, *on));
        self
    }

    /// The same machine, whose locations of these axes nobody has verified since an earlier session.
    #[must_use]
    pub fn doubting(mut self, axes: AxisSet) -> Self {
        self.model = self.model.doubting(axes);
        self
    }

    /// The same machine, whose locations of these axes somebody has verified.
    #[must_use]
    pub fn trusting(mut self, axes: AxisSet) -> Self {
        self.model = self.model.trusting(axes);
        self
    }

    /// The same machine, pushed by hand at these times.
    #[must_use]
    pub fn pushed(mut self, script: Vec<Push>) -> Self {
        let begun_s = self.model.clock_s();
        let to_come = script.into_iter().filter(|push| push.at_s >= begun_s).collect();
        self.physics.pushes.follow(to_come);
        self
    }

    /// Somebody moves the switch of an input of the machine, which stands; it stays there, also for the next run.
    pub fn press(&mut self, input: u8, on: bool) {
        let at_s = self.model.clock_s();
        self.physics.press(Change { input, on, at_s });
        while let Some(change) = self.physics.tell(at_s) {
            self.model.learn(change);
        }
        self.model.advance(at_s);
        self.model.log().take().for_each(drop);
    }

    /// Switches that somebody moved by hand, and where they were left.
    pub fn switches(&self) -> Vec<(u8, bool)> {
        self.physics.moved_by_hand()
    }

    /// Returns how far axes are from where they are believed to be, because somebody pushed them, mm or degrees.
    pub const fn astray(&self) -> Axes {
        self.physics.pushes.astray
    }

    /// Returns how far each motor's carriage is from where the controller believes it.
    pub fn truth(&self) -> Vec<Vec<f64>> {
        self.physics.truth()
    }
}
