//! Times of steps as the few commands that a board keeps: `interval, count, add`.
//!
//! Step k of a command (1 … count) is due at T + k·interval + add·k(k−1)/2, T being the last step before it. Each
//! step has a window of time around its planned moment; a command goes on for as long as one pair of whole numbers
//! passes through all windows, so few commands are needed, and no error is handed on: windows are those of the plan,
//! whatever T became.
//!
//! ```text
//!  time │              ┬ ╱ window of step 4
//!       │           ┬ ╱┴
//!       │        ┬ ╱┴         one parabola with whole coefficients
//!       │     ┬ ╱┴            through as many windows as it can
//!       │     ┴╱
//!       └─────┴──┴──┴──┴──► step
//! ```

mod run;

use run::Run;

/// Longest time between two steps within commands, ticks; behind a longer rest the clock of the motor is set anew.
const LONGEST_GAP: f64 = (3_u64 << 28) as f64;
/// Ticks between that clock and the first step behind a rest.
const LEAD_IN: u64 = 1 << 16;

/// Limits of a motor's steps, in ticks of its board.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Farthest that a step is from its planned moment. Where steps are close, half the time to the next one is the
    /// limit.
    pub error: f64,
    /// Least time between two steps: the pulse, its pause, and what the board needs.
    pub least: u32,
    /// Least time between a step and the first one the other way: the pulse, and the driver's set-up of direction.
    pub turn: u32,
}

/// Steps that one command makes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Steps {
    /// Its count rises.
    pub forward: bool,
    /// Clock from which they count. Where it is not the last step of the command before, the motor's clock is set to
    /// it.
    pub from: u64,
    /// Ticks to the first step.
    pub interval: u32,
    /// Number of steps.
    pub count: u16,
    /// Ticks by which each interval is longer than the one before.
    pub add: i16,
}

impl Steps {
    /// Clock of a step, from 1.
    pub fn at(&self, step: u16) -> u64 {
        let k = i64::from(step);
        let later = k * i64::from(self.interval) + i64::from(self.add) * (k * (k - 1) / 2);
        self.from.wrapping_add_signed(later)
    }

    /// Clock of the last step.
    pub fn to(&self) -> u64 {
        self.at(self.count)
    }
}

/// A motor was to make steps faster than its board or its driver can.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error(
    "a motor would have to step {gap:.0} ticks after its last step, and needs {least}: lower its speed or its steps"
)]
pub struct TooFast {
    /// Clock of the step.
    pub clock: f64,
    /// Ticks since the one before.
    pub gap: f64,
    /// Ticks that it needs.
    pub least: u32,
}

/// Steps at even times as they are planned.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Due {
    /// Clock of the last of them.
    clock: f64,
    forward: bool,
    count: u16,
}

/// Makes commands from the steps of one motor, in order of time.
#[derive(Clone, Debug)]
pub struct Compressor {
    limits: Limits,
    /// Steps of the command that is being made.
    run: Run,
    /// The last step that is in a command or in the run.
    last: Due,
    /// The newest step: its window depends on the next one.
    held: Option<Due>,
    /// Steps there and back that were too close together to be made.
    dropped: u64,
}

impl Compressor {
    /// A motor that stands at a clock.
    pub fn new(limits: Limits, clock: u64) -> Self {
        let last = Due { clock: clock as f64, forward: false, count: 1 };
        Self { limits, run: Run::new(clock), last, held: None, dropped: 0 }
    }

    /// Adds a step, at a clock of the board with its fraction.
    ///
    /// A step and one back that follows before the driver could turn round are both left out: in that time the axis
    /// passes the half step by a hundredth of a step at most.
    ///
    /// # Errors
    ///
    /// It comes too soon behind the one before.
    pub fn push(&mut self, clock: f64, forward: bool, out: &mut Vec<Steps>) -> Result<(), TooFast> {
        self.push_even(clock, forward, 1, out)
    }

    /// Adds steps at even times, the last of them at a clock. Of several only the last one's moment is looked at.
    ///
    /// # Errors
    ///
    /// They come too soon behind the one before, or behind each other.
    pub fn push_even(
        &mut self,
        clock: f64,
        forward: bool,
        count: u16,
        out: &mut Vec<Steps>,
    ) -> Result<(), TooFast> {
        let due = Due { clock, forward, count };
        if let Some(held) = self.held {
            let single = held.count == 1 && count == 1;
            let turns = held.forward != forward && single;
            if turns && clock - held.clock < f64::from(self.limits.turn) {
                self.held = None;
                self.dropped += 2;
                return Ok(());
            }
            self.settle(held, (clock - held.clock) / f64::from(count), out)?;
        }
        self.held = Some(due);
        Ok(())
    }

    /// Ends the command that is being made: the steps so far are all in commands.
    ///
    /// # Errors
    ///
    /// The last step comes too soon behind the one before.
    pub fn finish(&mut self, out: &mut Vec<Steps>) -> Result<(), TooFast> {
        if let Some(held) = self.held.take() {
            self.settle(held, f64::INFINITY, out)?;
        }
        out.extend(self.run.close());
        Ok(())
    }

    /// Clock of the last step that is in a command.
    pub const fn clock(&self) -> u64 {
        self.run.from()
    }

    /// Steps that were left out, there and back.
    pub const fn dropped(&self) -> u64 {
        self.dropped
    }

    /// Puts steps into the command, or ends that and begins another. The next step comes so many ticks later.
    fn settle(&mut self, due: Due, next: f64, out: &mut Vec<Steps>) -> Result<(), TooFast> {
        let turns = due.forward != self.last.forward;
        let least = if turns { self.limits.turn.max(self.limits.least) } else { self.limits.least };
        let gap = (due.clock - self.last.clock) / f64::from(due.count);
        // One command with whole ticks between its steps has to be there for so many.
        let whole = 0.5 * f64::from(due.count);
        let reach = self.limits.error.min(0.5 * gap.min(next)).max(whole);
        let window = [due.clock - reach, due.clock + reach];
        self.last = due;
        if !turns && self.run.extend(window, due.count, self.limits.least) {
            return Ok(());
        }
        out.extend(self.run.close());
        if gap > LONGEST_GAP {
            self.run = Run::new((due.clock as u64).saturating_sub(LEAD_IN));
        }
        // A step back that is a little late harms less than one that the driver takes for one ahead.
        let late = if turns { f64::from(least) + self.run.from() as f64 } else { 0.0 };
        let window = [window[0], window[1].max(late)];
        if self.run.begin(due.forward, window, due.count, least) {
            return Ok(());
        }
        Err(TooFast { clock: due.clock, gap, least })
    }
}
