//! Overrides of the fake: shares of feeds, of rapid moves and of the spindle.

use super::Fake;

/// Shares of rapid moves, by their characters from 0x95 on, percent.
const RAPID: [u32; 3] = [100, 50, 25];

/// Turns an override by a character.
pub fn turn(fake: &mut Fake, byte: u8) {
    match byte {
        0x90..=0x94 => {
            fake.override_percent = turned(fake.override_percent, byte - 0x90);
            fake.motion.feed = f64::from(fake.override_percent) / 100.0;
        }
        0x95..=0x97 => {
            fake.rapid_percent = RAPID[usize::from(byte - 0x95)];
            fake.motion.rapid = f64::from(fake.rapid_percent) / 100.0;
        }
        0x99..=0x9d => fake.spindle_percent = turned(fake.spindle_percent, byte - 0x99),
        _ => {}
    }
}

/// A share after a step: back to 100 %, 10 and 1 percent up and down.
fn turned(percent: u32, step: u8) -> u32 {
    let percent = match step {
        1 => percent + 10,
        2 => percent.saturating_sub(10),
        3 => percent + 1,
        4 => percent.saturating_sub(1),
        _ => 100,
    };
    percent.clamp(10, 200)
}
