//! The card of a machine that a running server has.

use super::ended::{Ended, number_of_run};
use super::{LOOK, Remote};
use anyhow::{Result, bail};
use kerf_machine::lines::line_of_pin;
use kerf_machine::wiring::Bit;
use kerf_model::ports::Ports;
use kerf_wire::Lamp;
use serde_json::json;
use std::thread::sleep;

/// The mend where a page drives the machine.
const BESIDE: &str = "nothing was switched: a page drives the machine. Press \"Give up control\" there, or use its page of the card's ports";

/// Number of looks for a bit that was switched: two seconds.
const LOOKS: u32 = 40;

/// The card of a server's machine.
pub struct Card {
    server: Remote,
    /// Arms the machine first.
    arm: bool,
}

impl Card {
    pub const fn of(server: Remote, arm: bool) -> Self {
        Self { server, arm }
    }

    /// The ports as they are; of inputs what they read.
    pub fn ports(&self) -> Result<Ports> {
        let told = &self.server.state()?["io"]["ports"];
        let (outputs, inputs) = (told["outputs"].clone(), told["inputs"].clone());
        Ok(Ports::of(serde_json::from_value(outputs)?, serde_json::from_value(inputs)?))
    }

    /// Switches an output, as whoever drives.
    pub fn switch(&self, bit: &Bit, on: bool) -> Result<Ports> {
        self.server.driving(BESIDE, self.arm, |lease, _| {
            self.server.act("bit", json!({ "lease": lease, "name": bit.name, "on": on }))?;
            self.until(true, bit, on)
        })
    }

    /// Moves a switch so that its input reads this. A disarmed machine has switches, too.
    pub fn press(&self, bit: &Bit, on: bool) -> Result<Ports> {
        self.press_switch(line_of_pin(bit), on)?;
        self.until(false, bit, on)
    }

    /// The same by the number of the input.
    pub fn press_switch(&self, number: u8, on: bool) -> Result<()> {
        self.server.driving(BESIDE, false, |lease, _| {
            self.server.act("input", json!({ "lease": lease, "number": number, "on": on }))
        })
    }

    /// The numbers of the inputs and of the outputs that are on.
    pub fn lamps(&self) -> Result<[Vec<u8>; 2]> {
        let told = self.server.state()?;
        let side = |side: &str| -> Result<Vec<u8>> {
            let lamps: Vec<Lamp> = serde_json::from_value(told["io"][side].clone())?;
            Ok(lamps.into_iter().filter(|lamp| lamp.on).map(|lamp| lamp.number).collect())
        };
        Ok([side("inputs")?, side("outputs")?])
    }

    /// Steps a motor once, as whoever drives, and waits for the end of that.
    pub fn step(&self, motor: &str, forward: bool) -> Result<Ended> {
        self.server.driving(BESIDE, self.arm, |lease, before| {
            let step = json!({ "lease": lease, "motor": motor, "forward": forward });
            self.server.act("step", step)?;
            self.server.until_over(number_of_run(before))
        })
    }

    /// Waits until a bit is as wanted: the server answers before its machine has done it.
    fn until(&self, is_output: bool, bit: &Bit, on: bool) -> Result<Ports> {
        for _ in 0..LOOKS {
            let ports = self.ports()?;
            if ports.is_on(is_output, bit) == on {
                return Ok(ports);
            }
            sleep(LOOK);
        }
        let reads = u8::from(!on);
        match is_output {
            true => bail!(
                "{} is still {reads}: the machine was stopped meanwhile; look at its page",
                bit.name
            ),
            false => bail!(
                "{} still reads {reads}: a home switch of the simulated machine is where its axis is; move the axis \
                 there (kerf machine home)",
                bit.name
            ),
        }
    }
}
