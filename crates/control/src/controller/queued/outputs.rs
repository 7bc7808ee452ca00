//! Outputs of a board: actuators of a run, each with its share.

use super::beam::{Follow, Law, level};
use super::wiring::Wiring;
use crate::controller::lacks::{lacked, no_channel, no_output, wired};
use kerf_machine::Actuator;
use kerf_machine::driver::Facts;
use kerf_program::{Beam, OutputReason, SpindleTurn};

/// Number of the spindle's output.
const SPINDLE: u8 = 1;
/// Number of the output of flood coolant.
const FLOOD: u8 = 2;
/// Number of the output of mist coolant.
const MIST: u8 = 3;

/// Outputs of a board as they are wanted.
#[derive(Clone, Debug, Default)]
pub struct Outputs {
    /// The spindle turns.
    turns: bool,
    /// Its speed, revolutions a minute; the highest where nobody said.
    rpm: Option<f64>,
    /// It is a laser whose power follows the speed.
    is_dynamic: bool,
    /// The beam of a job.
    beam: Beam,
}

impl Outputs {
    /// Returns the outputs that change, each with its share from 0 (off) to 1.
    ///
    /// # Errors
    /// The board lacks what is asked for, in words.
    pub fn set(
        &mut self,
        actuator: &Actuator,
        wiring: &Wiring,
        facts: &Facts,
    ) -> Result<Vec<(usize, f64)>, String> {
        match *actuator {
            Actuator::Output { number, on, why } if why != OutputReason::Trigger => {
                let Some(line) = wired(facts, number) else { return Ok(Vec::new()) };
                if facts.outputs & (1 << (line - 1)) == 0 {
                    let needs = on && why != OutputReason::Motion;
                    return if needs { Err(no_output(facts, number)) } else { Ok(Vec::new()) };
                }
                Ok(self.switch(line, on, wiring))
            }
            Actuator::Spindle { rpm } => {
                self.rpm = Some(rpm);
                Ok(self.spins(wiring).into_iter().collect())
            }
            Actuator::Coolant { mist, flood } => {
                let all = [self.switch(FLOOD, flood, wiring), self.switch(MIST, mist, wiring)];
                Ok(all.concat())
            }
            Actuator::Turn(turn @ (SpindleTurn::Clockwise | SpindleTurn::Dynamic))
                if turn == SpindleTurn::Clockwise || wiring.spindle.is_some() =>
            {
                self.is_dynamic = turn == SpindleTurn::Dynamic;
                Ok(self.spins(wiring).into_iter().collect())
            }
            Actuator::Pwm { channel, percent } if !wiring.pwm.is_empty() => {
                let found = wiring.pwm.iter().find(|(own, _)| *own == channel);
                match found {
                    Some((_, place)) => Ok(vec![(*place, 0.01 * percent)]),
                    None if percent > 0.0 => Err(no_channel(facts, channel)),
                    None => Ok(Vec::new()),
                }
            }
            // The beam itself is told.
            Actuator::Intensity { .. } if wiring.spindle.is_some() => Ok(Vec::new()),
            other => match lacked(&other) {
                Some(what) => Err(format!("has no {what}")),
                None => Ok(Vec::new()),
            },
        }
    }

    /// All outputs that go off at a stop.
    pub fn off(&mut self, wiring: &Wiring) -> Vec<(usize, f64)> {
        (self.turns, self.beam) = (false, Beam::Off);
        let switched = wiring.outputs.iter().chain(&wiring.pwm).map(|(_, place)| (*place, 0.0));
        switched.chain(wiring.spindle.map(|(place, _)| (place, 0.0))).collect()
    }

    /// Returns the outputs that change with another beam; nothing where it is the one that is.
    pub fn shine(&mut self, beam: &Beam, wiring: &Wiring) -> Option<Vec<(usize, f64)>> {
        if *beam == self.beam {
            return None;
        }
        self.beam = beam.clone();
        Some(self.spins(wiring).into_iter().collect())
    }

    /// The output that follows the speed.
    pub fn follow(&self, wiring: &Wiring) -> Option<Follow> {
        let (place, most) = wiring.spindle?;
        let law = match &self.beam {
            Beam::Follow(law) => Law::Table(law.clone()),
            _ if self.turns && self.is_dynamic => Law::Proportional(self.at_speed(most)),
            _ => return None,
        };
        Some(Follow::new(place, law))
    }

    /// Outputs that follow the speed have no share where the machine stands.
    pub fn rests(&self, wiring: &Wiring) -> Option<(usize, f64)> {
        self.follow(wiring).and(wiring.spindle).map(|(place, _)| (place, 0.0))
    }

    fn switch(&mut self, line: u8, on: bool, wiring: &Wiring) -> Vec<(usize, f64)> {
        let place = wiring.outputs.iter().find(|(number, _)| *number == line);
        let mut changes: Vec<_> =
            place.map(|(_, place)| (*place, f64::from(u8::from(on)))).into_iter().collect();
        if line == SPINDLE {
            self.turns = on;
            changes.extend(self.spins(wiring));
        }
        changes
    }

    /// The share of the spindle's speed, or of a laser's power where the machine stands.
    fn spins(&self, wiring: &Wiring) -> Option<(usize, f64)> {
        let (place, most) = wiring.spindle?;
        let share = match &self.beam {
            Beam::Level { value, .. } => level(*value),
            Beam::Follow(_) => 0.0,
            Beam::Off if self.turns && !self.is_dynamic => self.at_speed(most),
            Beam::Off => 0.0,
        };
        Some((place, share))
    }

    /// The share of the speed that is asked for.
    fn at_speed(&self, most: f64) -> f64 {
        self.rpm.map_or(1.0, |rpm| (rpm / most).clamp(0.0, 1.0))
    }
}
