//! The I/O card: terminals for motors, relays and switches, wired to the PCI card.

use super::terminal::{Terminal, Wiring, at};

pub(super) const IO: Wiring = Wiring {
    name: "io",
    terminals: TERMINALS,
    notes: &[
        "Inputs: 8, positive switching (pnp), +15 V supply, filtered, opto-isolated.",
        "Relay contacts are N/O: closed while the bit is 1.",
        "Router: spindle on Router/Shutter, coolant on Tool 1.",
        "Laser: shutter on Router/Shutter, laser on/off on Cut 1.",
        "Q and R have no terminals on this revision of the card.",
    ],
};

const NOT_USED: &str = "not used";
const REVISION: &str = "not used on this card revision";

const TERMINALS: &[Terminal] = &[
    at("output", "X-STEP", "xstep", "pci 23"),
    at("output", "X-DIR", "xdir", "pci 5"),
    at("output", "X-POS", "+12V", "pci 1, supply of X"),
    at("output", "Y-STEP", "ystep", "pci 24"),
    at("output", "Y-DIR", "ydir", "pci 6"),
    at("output", "Y-POS", "+12V", "pci 2, supply of Y"),
    at("output", "Z-STEP", "zstep", "pci 25"),
    at("output", "Z-DIR", "zdir", "pci 7"),
    at("output", "Z-POS", "+12V", "pci 3, supply of Z"),
    at("output", "W-STEP", "wstep", "pci 26"),
    at("output", "W-DIR", "wdir", "pci 8"),
    at("output", "W-POS", "+12V", "pci 21, supply of W"),
    at("output", "T1A/T1B", "tool1", "pci 27, relay TOOL1, N/O"),
    at("output", "T2A/T2B", "tool2", "pci 28, relay TOOL2, N/O"),
    at("output", "T3A/T3B", "tool3", "pci 29, relay TOOL3, N/O"),
    at("output", "C1A/C1B", "cut1", "pci 9, relay CUT1, N/O"),
    at("output", "C2A/C2B", "cut2", "pci 10, relay CUT2, N/O"),
    at("output", "C3A/C3B", "cut3", "pci 11, relay CUT3, N/O"),
    at("output", "ROUTER", "router", "pci 30, relay RTR/RTR, N/O; RUN on old boards"),
    at("output", "RUN", "job_running", "pci 12, relay, N/O; EX on old boards"),
    at("output", "+12", "+12V", "supply of the control lines"),
    at("output", "R-STE", NOT_USED, REVISION),
    at("output", "R-DIR", NOT_USED, REVISION),
    at("output", "R-POS", NOT_USED, REVISION),
    at("output", "Q-STE", NOT_USED, REVISION),
    at("output", "Q-DIR", NOT_USED, REVISION),
    at("output", "Q-POS", NOT_USED, REVISION),
    at("input", "X-Home", "xhome", "pci 24"),
    at("input", "Y-Home", "yhome", "pci 6"),
    at("input", "Z-Home", "zhome", "pci 23"),
    at("input", "W-Home", "whome", "pci 5"),
    at("input", "BDEL", "end_bottom_delay", "pci 7, a pulse is enough"),
    at("input", "STOP", "estop", "pci 26"),
    at("input", "HC-T", "zhigh", "pci 25, drives Z down"),
    at("input", "HC-B", "zlow", "pci 8, drives Z up"),
];
