//! Characters that act at once and are no part of a line.

/// First command of the feed override: back to 100 %; 10 % and 1 % up and down follow.
const FEED: u8 = 0x90;

/// The same of the spindle.
const SPINDLE: u8 = 0x99;

/// Rapid moves at 100, 50 and 25 %.
const RAPID: [(u8, u8); 3] = [(100, 0x95), (50, 0x96), (25, 0x97)];

/// Commands that set the feed override to so many percent, 10 to 200.
pub fn feed(percent: u8) -> Vec<u8> {
    share(FEED, percent)
}

/// Commands that set the spindle override to so many percent, 10 to 200.
pub fn spindle(percent: u8) -> Vec<u8> {
    share(SPINDLE, percent)
}

fn share(back: u8, percent: u8) -> Vec<u8> {
    let off = i32::from(percent.clamp(10, 200)) - 100;
    let steps =
        |by: i32, up: u8| vec![if by > 0 { up } else { up + 1 }; by.unsigned_abs() as usize];
    [vec![back], steps(off / 10, back + 1), steps(off % 10, back + 3)].concat()
}

/// Returns the share of rapid moves that there is, not above a wanted one, with its command.
pub fn rapid(percent: u8) -> (u8, u8) {
    RAPID.into_iter().find(|(share, _)| *share <= percent).unwrap_or((25, 0x97))
}

pub const ASK: u8 = b'?';
pub const HOLD: u8 = b'!';
pub const RESUME: u8 = b'~';
pub const RESET: u8 = 0x18;
