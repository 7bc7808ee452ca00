//! Which codes there are, and which exclude each other.
//!
//! G codes are kept as ten times their number, so that G38.2 is 382. Groups as in NIST RS274/NGC
//! version 3 (table 4), with the codes LinuxCNC added.

/// Number of groups of G codes.
pub const G_GROUPS: usize = 13;
/// Number of groups of M codes.
pub const M_GROUPS: usize = 9;

/// The group of codes that do something once.
pub const ONCE: usize = 0;
/// The group of motions.
pub const MOTION: usize = 1;
/// The group of planes.
pub const PLANE: usize = 2;
/// G90, G91.
pub const DISTANCE: usize = 3;
/// G90.1, G91.1.
pub const ARC_DISTANCE: usize = 4;
/// G93 … G95.
pub const FEED_MODE: usize = 5;
/// G20, G21.
pub const UNITS: usize = 6;
/// G40 … G42.
pub const COMPENSATION: usize = 7;
/// G43, G49.
pub const TOOL_LENGTH: usize = 8;
/// G98, G99.
pub const RETURN: usize = 9;
/// G54 … G59.3.
pub const SYSTEM: usize = 10;
/// G61, G64.
pub const PATH: usize = 11;
/// G96, G97, G7, G8: of lathes.
pub const LATHE: usize = 12;

/// The group of a G code, in tenths; `None` when there is no such code.
pub const fn g_group(code: i32) -> Option<usize> {
    Some(match code {
        40 | 100 | 280 | 281 | 300 | 301 | 520 | 530 | 920 | 921 | 922 | 923 => ONCE,
        0
        | 10
        | 20
        | 30
        | 50..=53
        | 382..=385
        | 730
        | 800
        | 810
        | 820
        | 830
        | 840
        | 850
        | 860
        | 870
        | 880
        | 890 => MOTION,
        170 | 180 | 190 => PLANE,
        900 | 910 => DISTANCE,
        901 | 911 => ARC_DISTANCE,
        930 | 940 | 950 => FEED_MODE,
        200 | 210 | 700 | 710 => UNITS,
        400 | 410 | 411 | 420 | 421 => COMPENSATION,
        430 | 431 | 490 => TOOL_LENGTH,
        980 | 990 => RETURN,
        540 | 550 | 560 | 570 | 580 | 590 | 591 | 592 | 593 => SYSTEM,
        610 | 611 | 640 => PATH,
        80 | 970 => LATHE,
        _ => return None,
    })
}

/// Codes that switch off what is never on here, as the safe first line of many posts has them.
pub const fn g_cancels(code: i32) -> bool {
    matches!(code, 690 | 150 | 500 | 501 | 131 | 401 | 491)
}

/// G codes of other machines that a router cannot carry out, and why.
pub const fn g_elsewhere(code: i32) -> Option<&'static str> {
    Some(match code {
        70 => "diameter mode is for lathes",
        760 | 330 | 331 => "threading needs a spindle that the axes can follow",
        432 => "additional tool offsets are not supported",
        171 | 181 | 191 => "planes of U, V and W are not supported",
        960 => "constant surface speed is for lathes",
        680 => "G10 L2 P0 R30 turns the coordinate system in force by 30 degrees, R0 turns it back",
        510 | 511 => "the proportions of FP scale and mirror a file",
        650 | 660 | 661 | 670 => {
            "a subroutine is called by O<name> call [1] [2], its values are #1, #2"
        }
        160 => "@ and ^ are polar places: @10 ^45 is 10 from zero at 45 degrees",
        _ => return None,
    })
}

/// M0, M1, M2, M30, M60, M98, M99.
pub const STOP: usize = 0;
/// M62 … M68.
pub const IO: usize = 1;
/// M6, M61.
pub const TOOL: usize = 2;
/// M3, M4, M5.
pub const SPINDLE: usize = 3;
/// M8, M9.
pub const COOLANT: usize = 4;
/// M7, which may stand beside M8.
pub const MIST: usize = 5;
/// M48 … M53.
pub const OVERRIDE: usize = 6;
/// M70 … M73.
pub const STATE: usize = 7;
/// Codes that are read and do nothing here.
pub const NOTHING: usize = 8;

/// The group of an M code; `None` when there is no such code.
pub const fn m_group(code: i32) -> Option<usize> {
    Some(match code {
        0 | 1 | 2 | 30 | 60 | 98 | 99 => STOP,
        62..=68 => IO,
        6 | 61 => TOOL,
        3..=5 | 19 => SPINDLE,
        8 | 9 => COOLANT,
        7 => MIST,
        48..=53 => OVERRIDE,
        70..=73 => STATE,
        // Clamps and such (M10, M11), which other machines have; the fan of a printer's board (M106, M107).
        10..=13 | 56 | 106 | 107 => NOTHING,
        _ => return None,
    })
}

/// A G code as people write it.
pub fn g_name(code: i32) -> String {
    if code % 10 == 0 { format!("G{}", code / 10) } else { format!("G{}.{}", code / 10, code % 10) }
}
