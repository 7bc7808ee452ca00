//! The lines of a program as the fake reads them.

use kerf_machine::driver::Axes;
use std::collections::VecDeque;

/// The speed of rapid moves, mm/s.
const RAPID_MM_S: f64 = 100.0;

/// A thing that a program asks for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Step {
    Go { to: Axes, speed_mm_s: f64, ticket: u32 },
    Probe { to: Axes, speed_mm_s: f64, ticket: u32, active: bool },
    Set { line: u8, on: bool },
    Turn { rpm: f64 },
}

/// Reads lines with their tickets, from a place; why they cannot be made.
pub fn read(lines: &[(u32, String)], from: Axes) -> Result<VecDeque<Step>, String> {
    let (mut place, mut feed_mm_min, mut relative) = (from, 0.0, false);
    let mut steps = VecDeque::new();
    for (ticket, line) in lines {
        let wrong = || format!("this line is none: {line}");
        let (mut way, mut probes, mut to) = (None, None, place);
        for word in line.split(' ') {
            let (letter, number) = word.split_at_checked(1).ok_or_else(wrong)?;
            let number: f64 = number.parse().map_err(|_| wrong())?;
            match (letter, number) {
                ("G", 53.0) => {}
                ("G", 0.0) => way = Some(RAPID_MM_S),
                ("G", 1.0) => way = Some(0.0),
                ("G", 38.3) => probes = Some(true),
                ("G", 38.5) => probes = Some(false),
                ("G", 90.0) => relative = false,
                ("G", 91.0) => relative = true,
                ("F", feed) => feed_mm_min = feed,
                ("S", rpm) => steps.push_back(Step::Turn { rpm }),
                ("M", 3.0 | 5.0) => steps.push_back(Step::Set { line: 1, on: number == 3.0 }),
                ("M", 8.0) => steps.push_back(Step::Set { line: 2, on: true }),
                ("M", 7.0) => steps.push_back(Step::Set { line: 3, on: true }),
                ("M", 9.0) => steps.extend([2, 3].map(|line| Step::Set { line, on: false })),
                ("M", 64.0 | 65.0) => steps.push_back(Step::Set { line: 0, on: number == 64.0 }),
                ("P", output) => {
                    if let Some(Step::Set { line, .. }) = steps.back_mut() {
                        *line = output as u8 + 4;
                    }
                }
                (axis, number) => {
                    let axis = "XYZ".find(axis).ok_or_else(wrong)?;
                    to.0[axis] = if relative { place.0[axis] + number } else { number };
                }
            }
        }
        let (ticket, feed_mm_s) = (*ticket, feed_mm_min / 60.0);
        match (way, probes) {
            (_, Some(active)) => {
                steps.push_back(Step::Probe { to, speed_mm_s: feed_mm_s, ticket, active })
            }
            (Some(rapid_mm_s), None) => {
                let speed_mm_s = if rapid_mm_s > 0.0 { rapid_mm_s } else { feed_mm_s };
                if speed_mm_s <= 0.0 {
                    return Err("a move without a feed".into());
                }
                steps.push_back(Step::Go { to, speed_mm_s, ticket });
            }
            (None, None) => {}
        }
        place = to;
    }
    Ok(steps)
}
