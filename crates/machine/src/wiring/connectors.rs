//! The connectors of the controller's box.

use super::terminal::{Terminal, Wiring, at};

pub(super) const BOX: Wiring = Wiring {
    name: "box",
    terminals: TERMINALS,
    notes: &[
        "Motor connectors: 15-pin female D. Switch connectors: 9-pin female D.",
        "PCI OUTPUT and PCI INPUT: 37-pin female D, the pins of the PCI card.",
    ],
};

macro_rules! motor {
    ($name:literal) => {
        [
            at($name, "1,2,9", "phase A", ""),
            at($name, "3,4,11", "phase A bar", ""),
            at($name, "5,6,13", "phase B", ""),
            at($name, "7,8,15", "phase B bar", ""),
        ]
    };
}

macro_rules! switch {
    ($name:literal, $signal:literal) => {
        [
            at($name, "1", "+15V", "supply"),
            at($name, "2", $signal, ""),
            at($name, "5", "Gnd", "ground"),
        ]
    };
}

const MOTORS: [[Terminal; 4]; 4] =
    [motor!("X MOTOR"), motor!("Y MOTOR"), motor!("Z MOTOR"), motor!("W MOTOR")];

const SWITCHES: [[Terminal; 3]; 5] = [
    switch!("X-HOME", "xhome"),
    switch!("Y-HOME", "yhome"),
    switch!("Z-HOME", "zhome"),
    switch!("W-HOME", "whome"),
    switch!("STOP", "estop"),
];

const HEIGHT: [Terminal; 7] = [
    at("BDEL-HC", "1", "+15V", "supply"),
    at("BDEL-HC", "2", "zhigh", "HC top"),
    at("BDEL-HC", "3", "zlow", "HC bottom"),
    at("BDEL-HC", "4", "end_bottom_delay", "bottom delay"),
    at("BDEL-HC", "5", "Gnd", "ground"),
    at("PCI OUTPUT", "1-37", "as `kerf io map --card pci`, output", "37 rows"),
    at("PCI INPUT", "1-37", "as `kerf io map --card pci`, input", "37 rows"),
];

/// All connectors one behind the other.
const fn joined() -> [Terminal; 38] {
    let mut all = [HEIGHT[0]; 38];
    let mut n = 0;
    while n < 38 {
        all[n] = if n < 16 {
            MOTORS[n / 4][n % 4]
        } else if n < 31 {
            SWITCHES[(n - 16) / 3][(n - 16) % 3]
        } else {
            HEIGHT[n - 31]
        };
        n += 1;
    }
    all
}

static ALL: [Terminal; 38] = joined();
const TERMINALS: &[Terminal] = &ALL;
