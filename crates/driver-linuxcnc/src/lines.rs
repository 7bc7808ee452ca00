//! Orders as lines of a program file of LinuxCNC.

use kerf_machine::driver::{Axes, Facts, Order, Shares, decimal, way_mm};

/// Share by which two speeds differ that are the same.
const SAME: f64 = 1e-6;

/// The lines that stand for an order, from a place, while outputs are on; why it cannot be made.
pub fn lines(
    order: &Order,
    from: Axes,
    facts: &Facts,
    on: u32,
    shares: Shares,
) -> Result<Vec<String>, &'static str> {
    match order {
        Order::Move { to, speed_mm_s } => straight(from, *to, *speed_mm_s, facts),
        Order::Jog { to, speed_mm_s } if is_rapid(from, *to, *speed_mm_s, facts) => {
            Ok(vec![format!("G53 G0{}", words(from, *to, *to, facts)?)])
        }
        Order::Jog { to, speed_mm_s } => {
            let share = f64::from(shares.rapid) / f64::from(shares.feed.max(1));
            straight(from, *to, speed_mm_s * share, facts)
        }
        Order::Arc { .. } => Err("Kerf has LinuxCNC make chords, no arcs"),
        Order::Probe { to, speed_mm_s, active } => {
            let code = if *active { "G38.3" } else { "G38.5" };
            let words = words(from, *to, to.minus(from), facts)?;
            let feed = number(feed_mm_min(from, *to, *speed_mm_s));
            Ok(vec![format!("G91 {code}{words} F{feed}"), "G90".into()])
        }
        Order::Output { line, on: true } if facts.outputs & 1 << (line - 1) == 0 => {
            Err("it does not have this output")
        }
        Order::Output { line, on: state } => Ok(output(*line, *state, on)),
        Order::Spindle { rpm } => Ok(vec![format!("S{}", number(*rpm))]),
        Order::Home | Order::Unlock => Ok(Vec::new()),
    }
}

fn straight(
    from: Axes,
    to: Axes,
    speed_mm_s: f64,
    facts: &Facts,
) -> Result<Vec<String>, &'static str> {
    let words = words(from, to, to, facts)?;
    let feed = number(feed_mm_min(from, to, speed_mm_s));
    Ok(vec![if words.is_empty() { format!("F{feed}") } else { format!("G53 G1{words} F{feed}") }])
}

/// The feed of a move, mm or degrees a minute: LinuxCNC counts the way of X, Y and Z where one of them moves.
fn feed_mm_min(from: Axes, to: Axes, speed_mm_s: f64) -> f64 {
    let way = to.minus(from).0;
    let linear_mm = way[..3].iter().map(|way| way * way).sum::<f64>().sqrt();
    let all_mm = way_mm(from, to);
    let share = if linear_mm > 0.0 { linear_mm / all_mm } else { 1.0 };
    60.0 * speed_mm_s * share
}

/// The words of the axes that move, each with its number.
fn words(from: Axes, to: Axes, numbers: Axes, facts: &Facts) -> Result<String, &'static str> {
    let mut words = String::new();
    for (axis, letter) in "XYZABC".chars().enumerate() {
        if to.0[axis] == from.0[axis] {
            continue;
        }
        if axis >= facts.axes {
            return Err("it does not have an axis that moves");
        }
        words += &format!(" {letter}{}", number(numbers.0[axis]));
    }
    Ok(words)
}

/// Returns `true` if no axis that moves lets LinuxCNC go faster.
fn is_rapid(from: Axes, to: Axes, speed_mm_s: f64, facts: &Facts) -> bool {
    let (length_mm, ways) = (way_mm(from, to), to.minus(from).0);
    let moved = ways.iter().enumerate().filter(|(_, way)| **way != 0.0);
    let most = moved.map(|(axis, way)| Some(facts.speed_mm_s[axis]? * length_mm / way.abs()));
    let least = most
        .collect::<Option<Vec<f64>>>()
        .map(|most| most.into_iter().fold(f64::INFINITY, f64::min));
    least.is_some_and(|most_mm_s| speed_mm_s >= most_mm_s * (1.0 - SAME))
}

/// The line of the first output of `M64`.
const FIRST_OUTPUT: u8 = 4;

/// An output; `on` are those that are on.
fn output(line: u8, state: bool, on: u32) -> Vec<String> {
    let said: &[&str] = match (line, state) {
        (1, true) => &["M3"],
        (1, false) => &["M5"],
        (2, true) => &["M8"],
        (3, true) => &["M7"],
        // M9 switches both off.
        (2, false) if on & 0b100 != 0 => &["M9", "M7"],
        (3, false) if on & 0b010 != 0 => &["M9", "M8"],
        (2 | 3, false) => &["M9"],
        (line, true) => return vec![format!("M64 P{}", line - FIRST_OUTPUT)],
        (line, false) => return vec![format!("M65 P{}", line - FIRST_OUTPUT)],
    };
    said.iter().map(|line| (*line).to_owned()).collect()
}

/// A number with five decimals at most: LinuxCNC counts in doubles, and a hundred-thousandth is no step.
fn number(value: f64) -> String {
    decimal(value, 5)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(order: Order, on: u32, expected: &[&str]) {
        let speed_mm_s = [Some(100.0), Some(100.0), Some(50.0), None, None, None];
        let facts = Facts { axes: 4, outputs: 0b1111, speed_mm_s, ..Facts::default() };
        let from = Axes::xyz(1.0, 2.0, 3.0);
        let shares = Shares { feed: 50, ..Shares::default() };
        assert_eq!(lines(&order, from, &facts, on, shares).expect("lines"), expected);
    }

    #[test]
    fn orders_are_lines_in_the_machine_frame() {
        let to = Axes::xyz(10.0, 2.0, -0.12346);
        check(Order::Move { to, speed_mm_s: 20.0 }, 0, &["G53 G1 X10 Z-0.12346 F1200"]);
        check(Order::Move { to: Axes::xyz(1.0, 2.0, 3.0), speed_mm_s: 20.0 }, 0, &["F1200"]);
        let up = Axes::xyz(1.0, 2.0, 8.0);
        check(Order::Jog { to: up, speed_mm_s: 50.0 }, 0, &["G53 G0 Z8"]);
        check(Order::Jog { to: up, speed_mm_s: 20.0 }, 0, &["G53 G1 Z8 F2400"]);
        let mut turned = Axes::xyz(4.0, 2.0, 3.0);
        turned.0[3] = 4.0;
        check(Order::Move { to: turned, speed_mm_s: 5.0 }, 0, &["G53 G1 X4 A4 F180"]);
        let probe = Order::Probe { to: Axes::xyz(1.0, 2.0, -1.0), speed_mm_s: 5.0, active: true };
        check(probe, 0, &["G91 G38.3 Z-4 F300", "G90"]);
        check(Order::Output { line: 4, on: true }, 0, &["M64 P0"]);
        check(Order::Output { line: 2, on: false }, 0b110, &["M9", "M7"]);
        check(Order::Spindle { rpm: 12_000.0 }, 0, &["S12000"]);
    }

    #[test]
    fn what_it_lacks_is_refused() {
        let facts = Facts { axes: 3, outputs: 0b111, ..Facts::default() };
        let lines = |order| super::lines(&order, Axes::default(), &facts, 0, Shares::default());
        let mut to = Axes::default();
        to.0[3] = 90.0;
        assert!(lines(Order::Move { to, speed_mm_s: 1.0 }).is_err());
        assert!(lines(Order::Output { line: 5, on: true }).is_err());
        assert!(lines(Order::Output { line: 3, on: true }).is_ok());
    }
}
