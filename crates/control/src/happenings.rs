//! Passes on what the machine logged: to those who follow the run, and to the machine that makes it.

use crate::told_heights;
use crate::world::World;
use kerf_machine::Actuator;
use kerf_machine::lines::{Input, Output};
use kerf_machine::settings::laser::Laser;
use kerf_model::{Happening, What};
use kerf_program::job::Heights;
use kerf_program::settings::SWITCHES;
use kerf_program::{Axis, Independent, SPINDLE_OUTPUT};
use kerf_sbp::SPINDLE_STATUS;
use kerf_trace::event::Event;

impl World<'_> {
    /// Tells what the machine logged.
    pub fn tell_log(&mut self) {
        if self.model.log().is_empty() {
            return;
        }
        let bits = |is_on: &dyn Fn(u8) -> bool| {
            (1..=SWITCHES as u8).filter(|n| is_on(*n)).fold(0, |bits, n| bits | 1 << (n - 1))
        };
        let inputs = bits(&|n| self.model.input(n));
        let outputs = bits(&|n| self.model.outputs().is_on(n));
        self.workspace.tape.switches(inputs, outputs);
        let happenings: Vec<Happening> = self.model.log().take().collect();
        for happening in happenings {
            match happening.what {
                What::LaserFrequency(hz) => self.laser_hz = Some(hz),
                What::Output { number: SPINDLE_OUTPUT, .. } => self.spindle_switched = true,
                What::Pushed { axis, by } => self.hands.push(axis, by, self.model.position()),
                _ => {}
            }
            if let Some(actuator) = actuator(&happening.what) {
                self.set(&actuator);
            }
            let event = self.happened(&happening);
            self.tell(&event);
        }
    }

    fn happened(&mut self, happening: &Happening) -> Event {
        let t = happening.t_s;
        match happening.what {
            What::Input { number, on } => {
                Event::Input { n: number, on, t, name: Input::of_number(number).map(Input::name) }
            }
            What::Link(up) => {
                let state = if up { "connected" } else { "not connected" };
                Event::State { state: state.into(), why: "".into(), t }
            }
            What::Stall(stalled) => {
                let state = if stalled { "stalled" } else { "free" };
                Event::State { state: state.into(), why: "".into(), t }
            }
            What::Intensity { value, burn } => Event::Intensity {
                value,
                byte: intensity_byte(value, burn),
                port: self.machine_is.intensity.port,
                pulse_us: self.laser_hz.map(|hz| Laser::pulse_us(hz, value)),
                t,
            },
            What::Height { z_mm, error_mm, reading } => {
                let Heights { top_mm: top, surface_mm: surface, .. } = self.heights.at(z_mm);
                let off = error_mm.abs() > self.machine_is.height.display_accuracy_mm;
                Event::Height { z: z_mm, error: error_mm, reading, off, surface, top, t }
            }
            What::Carried { z_mm } => told_heights::event(self.heights.at(z_mm), t),
            What::LaserFrequency(hz) => Event::LaserHz { hz, t },
            What::Output { number, on, why } => Event::Output {
                n: number,
                on,
                t,
                why,
                name: Output::of_number(number).map(Output::name),
            },
            What::Pwm { channel, percent, frequency_khz } => {
                Event::Pwm { channel, percent, t, khz: frequency_khz }
            }
            What::Spindle { number, rpm, on } => Event::Spindle { rpm, on, t, n: number },
            What::Light(on) => Event::Light { on, t },
            What::Motors(on) => Event::Motors { on, t },
            What::Pushed { axis, by } => {
                Event::HandMove { axis: axis.letter(), by: by / self.scale(axis), t }
            }
            What::Resolution(multipliers) => Event::Resolution { multipliers, t },
            What::Independent { axis, motion } => self.independent(axis, motion, t),
        }
    }

    fn independent(&self, axis: Axis, motion: Independent, t: f64) -> Event {
        let scale = self.scale(axis);
        let (speed, frequency, distance) = match motion {
            Independent::Off => (0.0, 0.0, 0.0),
            Independent::Rotate(speed) => (speed / scale, 0.0, 0.0),
            Independent::Oscillate { frequency_hz, distance } => {
                (0.0, frequency_hz, distance / scale)
            }
        };
        Event::Independent { axis: axis.letter(), speed, frequency, distance, t }
    }

    /// Stops what turns and moves by itself, and keeps it.
    pub fn stop_turning(&mut self) {
        let alone = self.model.moving_alone();
        let spindles = self.model.stop_spindles();
        self.stopped.add(spindles, alone);
        self.workspace.set_value(SPINDLE_STATUS, Some("0"));
    }

    /// Returns `true` if the emergency stop of jobs is pressed.
    pub fn is_pressed(&self) -> bool {
        let active = self.machine_is.estop.active;
        !self.model.draws() && self.model.input(Input::EmergencyStop.number()) == active
    }
}

/// Returns the actuator that is set where this happens; nothing where it is only noticed.
pub(crate) const fn actuator(what: &What) -> Option<Actuator> {
    Some(match *what {
        What::Output { number, on, why } => Actuator::Output { number, on, why },
        What::Spindle { rpm, .. } => Actuator::Spindle { rpm },
        What::Pwm { channel, percent, .. } => Actuator::Pwm { channel, percent },
        What::Intensity { value, burn } => {
            Actuator::Intensity { byte: intensity_byte(value, burn) }
        }
        _ => return None,
    })
}

/// The byte of the intensity output: the value, and the burn bit below it.
const fn intensity_byte(value: u8, burn: bool) -> u8 {
    2 * value + burn as u8
}
