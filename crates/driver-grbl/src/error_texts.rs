//! The numbers of grbl in words, with what to do.

/// Tells what an `error:` number means.
pub const fn error(number: u16) -> &'static str {
    match number {
        1 | 2 | 24 | 25 | 26 | 28 | 29 | 31 => "it did not understand a line; the cable may be bad",
        3 => "it does not know this $ command",
        5 => "homing is not enabled in it: set $22=1, or do not home",
        6 => "its step pulse is too short: look at $0",
        7 => {
            "its settings were lost and are the usual ones again: look at them before anything moves"
        }
        8 => "it is busy with something else",
        9 => "it is locked by an alarm",
        10 => "soft limits need homing: set $22=1 or $20=0",
        11 | 14 => "the line is too long for it; the cable may be bad",
        13 => "its door is open",
        15 => "the place lies outside its travel ($130, $131, $132)",
        16 | 20 | 21 => "it does not have this command",
        17 => "its laser mode has no PWM output",
        22 => "no feed was given",
        33..=35 => "it cannot make this arc",
        39 => "it does not have this output",
        _ => "see the list of error codes of its firmware",
    }
}

/// Tells what an `ALARM:` number means.
pub const fn alarm(number: u16) -> &'static str {
    match number {
        1 => "a limit switch was hit; its place is lost: home it before anything moves",
        2 => "the place lies outside its travel ($130, $131, $132); it stands where it was",
        3 => "it was reset while it moved; its place is lost: home it before anything moves",
        4 | 5 => "probing failed",
        6 => "homing was interrupted by a reset",
        7 => "homing was interrupted by the door",
        8 => "homing did not leave the limit switch: look at $27 and the wires of the switches",
        9 => "homing did not find the limit switch: look at $130 and the wires of the switches",
        10 => "the emergency stop is pressed",
        11 => "it wants to be homed before anything moves",
        14 => "the spindle did not reach its speed",
        _ => "see the list of alarm codes of its firmware",
    }
}

/// Returns `true` if steps may be lost in an alarm.
pub const fn is_lost(number: u16) -> bool {
    !matches!(number, 2 | 4 | 5 | 14)
}
