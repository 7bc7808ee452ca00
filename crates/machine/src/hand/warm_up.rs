//! Warming the spindle up: steps of speed and time while the machine stands.

use kerf_program::{Command, decimal};
use std::collections::VecDeque;

/// Output of the spindle.
const SPINDLE: u8 = 1;

/// A step lasts so long at most, minutes.
const LONGEST_MIN: f64 = 120.0;

/// Steps at most.
const MOST_STEPS: usize = 20;

/// A step of a warm-up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WarmStep {
    /// Speed, percent of the greatest that the spindle turns.
    pub percent: f64,
    /// Its time, minutes.
    pub minutes: f64,
}

/// Reads steps as they are kept: `25:2, 50:2`, percent and minutes.
///
/// # Errors
/// Fault of a step, with the mend.
pub fn warm_steps(text: &str) -> Result<Vec<WarmStep>, String> {
    let steps: Result<Vec<_>, _> = text.split(',').map(|step| read(step.trim())).collect();
    let steps = steps?;
    if steps.len() > MOST_STEPS {
        return Err(format!("a warm-up has {MOST_STEPS} steps at most"));
    }
    Ok(steps)
}

fn read(step: &str) -> Result<WarmStep, String> {
    let wrong = || {
        format!(
            "'{step}' is no step of a warm-up: give percent of the spindle's greatest speed, 1 to 100, and minutes, up to 120: 25:2, 50:2"
        )
    };
    let (percent, minutes) = step.split_once(':').ok_or_else(wrong)?;
    let number = |text: &str| text.trim().parse::<f64>().ok();
    let (percent, minutes) = number(percent).zip(number(minutes)).ok_or_else(wrong)?;
    let is_sound = (1.0..=100.0).contains(&percent) && minutes > 0.0 && minutes <= LONGEST_MIN;
    if is_sound { Ok(WarmStep { percent, minutes }) } else { Err(wrong()) }
}

/// Commands for the steps, in order. Where the speed is set by hand, the spindle is on for the time alone.
pub(super) fn commands(steps: &[WarmStep], greatest_rpm: f64) -> VecDeque<Command> {
    let all_min: f64 = steps.iter().map(|step| step.minutes).sum();
    let (mut left_min, mut out) = (all_min, VecDeque::new());
    let sets_speed = greatest_rpm > 0.0;
    if !sets_speed {
        let text = format!(
            "this spindle's speed is set by hand: it is on for {} min",
            decimal(all_min, 2)
        );
        out.push_back(Command::Message { text: text.into() });
    }
    for (n, step) in steps.iter().enumerate() {
        if sets_speed {
            let rpm = 0.01 * step.percent * greatest_rpm;
            let text = format!(
                "warm-up, step {} of {}: {} rpm for {} min, {} min left",
                n + 1,
                steps.len(),
                decimal(rpm, 0),
                decimal(step.minutes, 2),
                decimal(left_min, 2)
            );
            out.push_back(Command::Message { text: text.into() });
            out.push_back(Command::Spindle { number: SPINDLE, rpm });
        }
        if n == 0 {
            out.push_back(Command::Output { number: SPINDLE, on: true });
        }
        out.push_back(Command::Wait { seconds: 60.0 * step.minutes });
        left_min -= step.minutes;
    }
    out
}

/// Switches the spindle off.
pub(super) const OFF: Command = Command::Output { number: SPINDLE, on: false };

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_are_read_or_refused_with_the_mend() {
        let step = |percent, minutes| WarmStep { percent, minutes };
        assert_eq!(warm_steps("25:2, 50 : 1.5"), Ok(vec![step(25.0, 2.0), step(50.0, 1.5)]));
        for wrong in ["", "25", "0:2", "101:2", "25:0", "25:121", "25:2,", "a:b", "NaN:1", "25:inf"]
        {
            let why = warm_steps(wrong).expect_err(wrong);
            assert!(why.contains("is no step of a warm-up"), "{wrong}: {why}");
        }
        let many = vec!["25:1"; MOST_STEPS + 1].join(",");
        assert!(warm_steps(&many).is_err_and(|why| why.contains("20 steps at most")));
    }
}
