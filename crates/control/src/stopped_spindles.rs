//! Spindles and axes that turn or move by themselves, and stop with a stop input.

use crate::world::World;
use kerf_machine::lines::Input;
use kerf_program::{Axis, Independent};
use kerf_sbp::SPINDLE_STATUS;

/// Spindles that turned and axes that moved by themselves, until they may again.
#[derive(Clone, Debug, Default)]
pub(crate) struct Turning {
    /// Outputs of spindles.
    pub spindles: Vec<u8>,
    /// Axes with their motion.
    pub alone: Vec<(Axis, Independent)>,
}

impl Turning {
    /// Returns `true` if nothing turned or moved by itself.
    pub const fn is_empty(&self) -> bool {
        self.spindles.is_empty() && self.alone.is_empty()
    }

    /// These too, each once.
    pub fn add(&mut self, spindles: Vec<u8>, alone: Vec<(Axis, Independent)>) {
        for number in spindles {
            if !self.spindles.contains(&number) {
                self.spindles.push(number);
            }
        }
        for (axis, motion) in alone {
            if self.alone.iter().all(|(other, _)| *other != axis) {
                self.alone.push((axis, motion));
            }
        }
    }
}

impl World<'_> {
    /// Stops what turns and moves by itself, and keeps it.
    pub fn stop_turning(&mut self) {
        let alone = self.machine.moving_alone();
        let spindles = self.machine.stop_spindles();
        self.stopped.add(spindles, alone);
        self.workspace.set_value(SPINDLE_STATUS, Some("0"));
    }

    /// Returns `true` if the emergency stop of jobs is pressed.
    pub fn is_pressed(&self) -> bool {
        let active = self.machine_is.estop.active;
        !self.machine.draws() && self.machine.input(Input::EmergencyStop.number()) == active
    }

    /// A switch was moved while somebody is asked: what turns stops when it is a stop.
    pub fn heed_switch(&mut self) {
        let stops = self.machine.stop_input().is_some() || self.is_pressed();
        if stops && self.machine.turns() {
            self.stop_turning();
            self.tell_log();
        }
    }
}
