//! The ports of the card as bytes, and what diagnostics do with them (Profiler reference, "Hardware
//! Input and Output").

use kerf_machine::settings::motors::{MOTORS, Motor};
use kerf_machine::wiring::{Bit, OUTPUT_BITS, Port};

/// Bytes of the ports, and the number of steps that each motor has been given.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Ports {
    /// Outputs A, B, C.
    outputs: [u8; 3],
    /// Inputs A, B.
    inputs: [u8; 2],
    /// Steps of X, Y, Z, W, Q, R.
    steps: [i64; MOTORS],
}

/// Reason why diagnostics do nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Refusal {
    /// A job runs.
    #[error("a job runs: outputs belong to it until it is over")]
    JobRuns,
    /// A bit that steps a motor.
    #[error("this bit belongs to a motor: step it instead")]
    Motor,
}

impl Ports {
    /// Ports that say this: outputs A, B, C and inputs A, B.
    pub const fn of(outputs: [u8; 3], inputs: [u8; 2]) -> Self {
        Self { outputs, inputs, steps: [0; MOTORS] }
    }

    /// The byte of an output port.
    pub const fn output(&self, port: Port) -> u8 {
        self.outputs[port as usize]
    }

    /// The byte of an input port; C has no inputs.
    pub fn input(&self, port: Port) -> u8 {
        self.inputs.get(port as usize).copied().unwrap_or_default()
    }

    /// Steps that a motor has been given.
    pub const fn steps(&self, motor: Motor) -> i64 {
        self.steps[motor.index()]
    }

    /// Tells whether a bit is on.
    pub fn is_on(&self, is_output: bool, bit: &Bit) -> bool {
        let byte = if is_output { self.output(bit.port) } else { self.input(bit.port) };
        byte & bit.mask() != 0
    }

    /// Sets an input of the simulated machine.
    pub fn set_input(&mut self, bit: &Bit, on: bool) {
        if let Some(byte) = self.inputs.get_mut(bit.port as usize) {
            *byte = with(*byte, bit, on);
        }
    }

    /// Switches an output by hand.
    ///
    /// # Errors
    /// [`Refusal`] while a job runs, and for the bits of motors.
    pub fn set_output(&mut self, bit: &Bit, on: bool, job_runs: bool) -> Result<(), Refusal> {
        if job_runs {
            return Err(Refusal::JobRuns);
        }
        if bit.name.ends_with("step") || bit.name.ends_with("dir") {
            return Err(Refusal::Motor);
        }
        let byte = &mut self.outputs[bit.port as usize];
        *byte = with(*byte, bit, on);
        Ok(())
    }

    /// Steps a motor once: the bytes its port shows on the way, direction and step, then the step
    /// off again.
    ///
    /// # Errors
    /// [`Refusal`] while a job runs.
    pub fn step(
        &mut self,
        motor: Motor,
        forward: bool,
        job_runs: bool,
    ) -> Result<[u8; 2], Refusal> {
        if job_runs {
            return Err(Refusal::JobRuns);
        }
        let Some((direction, step)) = motor_bits(motor) else { return Err(Refusal::Motor) };
        let byte = &mut self.outputs[step.port as usize];
        let directed = with(*byte, direction, forward);
        let bytes = [with(directed, step, true), directed];
        *byte = directed;
        self.steps[motor.index()] += if forward { 1 } else { -1 };
        Ok(bytes)
    }

    /// As text, to be kept between commands.
    pub fn write(&self) -> String {
        let bytes = self.outputs.iter().chain(&self.inputs).map(|byte| format!("{byte:02X}"));
        let steps = self.steps.iter().map(i64::to_string);
        bytes.chain(steps).collect::<Vec<_>>().join(" ")
    }

    /// Reads what was written; nothing when the text is something else.
    pub fn read(text: &str) -> Option<Self> {
        let words: Vec<&str> = text.split_whitespace().collect();
        let (bytes, steps) = words.split_at_checked(5)?;
        let bytes: Vec<u8> =
            bytes.iter().map(|it| u8::from_str_radix(it, 16).ok()).collect::<Option<_>>()?;
        let steps: Vec<i64> = steps.iter().map(|it| it.parse().ok()).collect::<Option<_>>()?;
        let outputs = bytes.get(..3)?.try_into().ok()?;
        let inputs = bytes.get(3..)?.try_into().ok()?;
        Some(Self { outputs, inputs, steps: steps.try_into().ok()? })
    }
}

const fn with(byte: u8, bit: &Bit, on: bool) -> u8 {
    if on { byte | bit.mask() } else { byte & !bit.mask() }
}

/// Direction and step bit of a motor.
pub fn motor_bits(motor: Motor) -> Option<(&'static Bit, &'static Bit)> {
    let named =
        |what: &str| OUTPUT_BITS.iter().find(|bit| bit.name == format!("{}{what}", motor.word()));
    Some((named("dir")?, named("step")?))
}

#[cfg(test)]
#[allow(clippy::unwrap_used, non_snake_case)] // rows and their variants
mod tests {
    use super::*;
    use kerf_machine::wiring::bit;

    fn alone(name: &str, port: Port, byte: u8) {
        let mut ports = Ports::default();
        ports.set_output(bit(name).unwrap().1, true, false).unwrap();
        assert_eq!(ports.output(port), byte, "{name}");
        assert_eq!(ports.set_output(bit(name).unwrap().1, true, true), Err(Refusal::JobRuns));
        assert_eq!(Ports::read(&ports.write()), Some(ports));
    }

    #[test]
    fn pro_io_diag_write__byte() {
        alone("tool2", Port::B, 0x04);
    }

    #[test]
    fn pro_io_outb0__alone() {
        alone("tool1", Port::B, 0x01);
    }

    #[test]
    fn pro_io_outb1__alone() {
        alone("cut1", Port::B, 0x02);
    }

    #[test]
    fn pro_io_outb2__alone() {
        alone("tool2", Port::B, 0x04);
    }

    #[test]
    fn pro_io_outb3__alone() {
        alone("cut2", Port::B, 0x08);
    }

    #[test]
    fn pro_io_outb4__alone() {
        alone("tool3", Port::B, 0x10);
    }

    #[test]
    fn pro_io_outb5__alone() {
        alone("cut3", Port::B, 0x20);
    }

    #[test]
    fn pro_io_outb6__alone() {
        alone("router", Port::B, 0x40);
        alone("shutter", Port::B, 0x40);
    }

    #[test]
    fn pro_io_outb7__alone() {
        alone("job_running", Port::B, 0x80);
    }

    #[test]
    fn pro_io_outc23__diagnostics() {
        alone("c2", Port::C, 0x04);
        alone("c3", Port::C, 0x08);
    }

    #[test]
    fn pro_io_diag_step__pulse() {
        let mut ports = Ports::default();
        assert_eq!(ports.step(Motor::X, true, false), Ok([0x03, 0x01]));
        assert_eq!(ports.steps(Motor::X), 1);
        assert_eq!(ports.step(Motor::X, false, false), Ok([0x02, 0x00]));
        assert_eq!(ports.step(Motor::X, false, true), Err(Refusal::JobRuns));
        assert_eq!(Ports::read(&ports.write()), Some(ports));
    }

    #[test]
    fn pro_io_outc45() {
        let mut ports = Ports::default();
        assert_eq!(ports.step(Motor::Q, true, false), Ok([0x30, 0x10]));
        assert_eq!(bit("r0").unwrap().1.name, "qdir");
    }

    #[test]
    fn pro_io_outc67() {
        let mut ports = Ports::default();
        assert_eq!(ports.step(Motor::R, true, false), Ok([0xC0, 0x40]));
        assert_eq!(bit("q0").unwrap().1.name, "rdir");
    }

    #[test]
    fn what_is_no_state_of_ports_is_not_read() {
        for text in ["", "00", "00 00 00 00 0G 0 0 0 0 0 0", "00 00 00 00 00 1 2"] {
            assert_eq!(Ports::read(text), None, "{text}");
        }
    }
}
