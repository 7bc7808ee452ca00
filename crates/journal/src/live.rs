//! State of a machine that runs, as other programs see it: the status byte and the bytes of its switches
//! (programming handbook, Registry Interface; readings, A-46).

use kerf_model::Model;
use kerf_trace::flag;
use serde::{Deserialize, Serialize};

/// Inputs or outputs that a byte of the registry tells; those beyond are in another.
const IN_A_BYTE: u32 = 8;

/// State of the machine as other programs see it. All zero where no Kerf is at the machine.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Live {
    /// The sum of [`flag`]s.
    pub status: u8,
    /// Inputs that are on: bit 0 is input 1.
    pub inputs: u16,
    /// Outputs that are on: bit 0 is output 1.
    pub outputs: u16,
}

impl Live {
    /// Of a machine that stands.
    pub fn at_rest(machine: &Model) -> Self {
        let sum = |is_on: &dyn Fn(u8) -> bool| {
            (1..=u16::BITS as u8)
                .filter(|number| is_on(*number))
                .fold(0, |sum, n| sum | 1 << (n - 1))
        };
        let inputs = sum(&|number| machine.input(number));
        let outputs = sum(&|number| machine.outputs().is_on(number));
        let status = if machine.draws() { flag::PREVIEW } else { 0 };
        Self { status, inputs, outputs }
    }

    /// Tells whether the machine gives a key its value, so that nobody sets it.
    pub fn tells(key: &str) -> bool {
        Self::default().values().iter().any(|(name, _)| *name == key)
    }

    /// Keys and values as the registry has them.
    pub fn values(&self) -> [(&'static str, u16); 5] {
        let [low, high] = [|bits: u16| bits & 0xff, |bits: u16| bits >> IN_A_BYTE];
        [
            ("Status", u16::from(self.status)),
            ("InputSwitches", low(self.inputs)),
            ("InputSwitchesUpper", high(self.inputs)),
            ("OutPutSwitches", low(self.outputs)),
            ("OutPutSwitchesUpper", high(self.outputs)),
        ]
    }
}
