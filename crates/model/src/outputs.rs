//! The output switches with their modes, and the lines of the ports.

use kerf_program::settings::{IoModes, LINES, SWITCHES};

/// States of the outputs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Outputs {
    on: [bool; LINES],
    /// Those that were left on and nobody has switched since: the board may have been switched off meanwhile.
    left: [bool; LINES],
}

impl Outputs {
    /// State of an output; one that does not exist is off.
    pub fn is_on(&self, number: u8) -> bool {
        let i = usize::from(number).wrapping_sub(1);
        self.on.get(i).copied().unwrap_or_default()
    }

    /// Tells whether any is on.
    pub fn is_any_on(&self) -> bool {
        self.on.contains(&true)
    }

    /// Switches one; true when that changed it, or may have.
    pub(crate) fn set(&mut self, number: u8, on: bool) -> bool {
        let i = usize::from(number).wrapping_sub(1);
        let Some(state) = self.on.get_mut(i) else { return false };
        let changes = std::mem::replace(state, on) != on;
        std::mem::take(&mut self.left[i]) || changes
    }

    /// One was left on: whatever it is switched to is a change.
    pub(crate) fn was_left_on(&mut self, number: u8) {
        let i = usize::from(number).wrapping_sub(1);
        if i < LINES {
            (self.on[i], self.left[i]) = (true, true);
        }
    }
}

/// The output that follows motion (command reference, SO).
pub(crate) const MOTION_OUTPUT: u8 = 4;

/// Occasion on which an output is switched without a command (command reference, VN fields 15-26).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Occasion {
    /// A part file starts.
    Start,
    /// Motion was stopped.
    Stop,
    /// It goes on after a stop.
    Resume,
    /// The part file is over.
    End,
}

/// Outputs that change their state on an occasion because of their mode.
pub(crate) fn switched(
    modes: &IoModes,
    occasion: Occasion,
) -> impl Iterator<Item = (u8, bool)> + '_ {
    let automatic = modes.output4 != -4;
    (1..=SWITCHES as u8).filter_map(move |number| {
        if number == MOTION_OUTPUT && automatic {
            return None;
        }
        let mode = modes.outputs[usize::from(number) - 1];
        let on = match (occasion, mode) {
            (Occasion::Start, 3..=5) => true,
            (Occasion::Resume, 5) => true,
            (Occasion::Stop, 2 | 5) | (Occasion::End, 0 | 2 | 3 | 5) => false,
            _ => return None,
        };
        Some((number, on))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use kerf_program::Settings;

    fn check(mode: u8, occasion: Occasion, expected: Option<bool>) {
        let mut modes = Settings::default().io;
        modes.outputs = [1; SWITCHES];
        modes.outputs[2] = mode;
        let got = switched(&modes, occasion).next();
        assert_eq!(got, expected.map(|on| (3, on)), "mode {mode} {occasion:?}");
    }

    #[test]
    fn each_mode_switches_when_the_reference_says() {
        use Occasion::{End, Resume, Start, Stop};
        let (on, off) = (Some(true), Some(false));
        for (mode, start, stop, resume, end) in [
            (0, None, None, None, off),
            (1, None, None, None, None),
            (2, None, off, None, off),
            (3, on, None, None, off),
            (4, on, None, None, None),
            (5, on, off, on, off),
        ] {
            check(mode, Start, start);
            check(mode, Stop, stop);
            check(mode, Resume, resume);
            check(mode, End, end);
        }
    }

    #[test]
    fn outputs_that_do_not_exist_stay_off() {
        let mut outputs = Outputs::default();
        assert!(!outputs.set(0, true) && !outputs.set(29, true));
        assert!(outputs.set(28, true) && !outputs.set(28, true));
        assert!(outputs.is_on(28) && !outputs.is_on(0) && !outputs.is_on(29));
    }

    #[test]
    fn an_output_that_was_left_on_is_switched_whatever_to() {
        for on in [true, false] {
            let mut outputs = Outputs::default();
            outputs.was_left_on(2);
            assert!(outputs.is_on(2) && outputs.is_any_on());
            assert!(outputs.set(2, on), "once more {on}");
            assert!(!outputs.set(2, on) && outputs.is_on(2) == on);
        }
    }
}
