//! The signals of a trace, and where each of them stands in it.

use super::waveforms::{Id, Kind, Vcd};
use kerf_machine::settings::motors::MOTORS;
use kerf_machine::wiring::{Bit, INPUT_BITS, OUTPUT_BITS};
use kerf_program::settings::SWITCHES;
use kerf_program::{AXES, Axis};

/// Bits of a port.
const PORT_BITS: usize = 8;

/// The first line behind the switches.
const FIRST_LINE: usize = SWITCHES + 1;

/// Lines that people switch or read: the switches and the ports behind them.
pub(super) struct Lines {
    switches: Vec<Id>,
    bits: Vec<Id>,
}

impl Lines {
    fn new(vcd: &mut Vcd, letters: &str, ports: [(&'static str, &[Bit]); 2]) -> Self {
        let bits = ports.into_iter().flat_map(|(name, of_port)| port(vcd, name, name, of_port));
        let bits = bits.collect();
        let scope = if letters == "in" { "switches_in" } else { "switches_out" };
        let name = |n: usize| format!("{letters}{n}");
        let switches = (1..=SWITCHES).map(|n| vcd.signal(scope, name(n), Kind::Wire)).collect();
        Self { switches, bits }
    }

    /// A line changes: its bit, and with it the byte of its port.
    pub fn change(&self, vcd: &mut Vcd, t_s: f64, number: u8, on: bool) {
        let number = usize::from(number);
        if let Some(switch) = self.switches.get(number.wrapping_sub(1)) {
            vcd.at(t_s, *switch, f64::from(on));
        }
        let i = number.wrapping_sub(FIRST_LINE);
        if let Some(bit) = self.bits.get(i) {
            vcd.at(t_s, *bit, f64::from(on));
        }
    }
}

/// Everything that is traced.
pub(super) struct Signals {
    pub directions: [Id; MOTORS],
    pub steps: [Id; MOTORS],
    pub outputs: Lines,
    pub inputs: Lines,
    /// Steps of each axis.
    pub positions: [Id; AXES],
    pub pwm: [Id; 2],
    /// Of each parallel port.
    pub intensity: [Id; 2],
    pub laser_hz: [Id; 2],
    /// Power that the board of the laser gives, percent.
    pub power: Id,
}

impl Signals {
    pub fn new(vcd: &mut Vcd) -> Self {
        let a = port(vcd, "out_a", "port_a", &OUTPUT_BITS[..PORT_BITS]);
        let ports = [
            ("port_b", &OUTPUT_BITS[PORT_BITS..2 * PORT_BITS]),
            ("port_c", &OUTPUT_BITS[2 * PORT_BITS..]),
        ];
        let outputs = Lines::new(vcd, "out", ports);
        let ports = [("in_a", &INPUT_BITS[..PORT_BITS]), ("in_b", &INPUT_BITS[PORT_BITS..])];
        let inputs = Lines::new(vcd, "in", ports);
        let letters = Axis::ALL.map(|axis| axis.letter().to_ascii_lowercase());
        // Bits 4 to 7 of port C are motors Q and R.
        let c = &outputs.bits[PORT_BITS..];
        let ports = ["lpt1", "lpt2"];
        let [(byte1, hz1), (byte2, hz2)] = ports.map(|scope| {
            let byte = vcd.signal(scope, "intensity_byte", Kind::Integer);
            (byte, vcd.signal(scope, "laser_hz", Kind::Real))
        });
        let of = |i: usize| [a[i], a[2 + i], a[4 + i], a[6 + i], c[4 + i], c[6 + i]];
        Self {
            directions: of(0),
            steps: of(1),
            outputs,
            inputs,
            positions: letters
                .map(|axis| vcd.signal("steps", format!("{axis}_pos"), Kind::Integer)),
            pwm: [1, 2].map(|n| vcd.signal("analog", format!("pwm{n}"), Kind::Real)),
            intensity: [byte1, byte2],
            laser_hz: [hz1, hz2],
            power: vcd.signal("analog", "laser_power", Kind::Real),
        }
    }
}

/// The wires of a port, and its byte.
fn port(vcd: &mut Vcd, scope: &'static str, byte: &'static str, bits: &[Bit]) -> Vec<Id> {
    let wires: Vec<Id> = bits.iter().map(|bit| vcd.signal(scope, bit.name, Kind::Wire)).collect();
    vcd.byte_of(scope, byte, &wires);
    wires
}
