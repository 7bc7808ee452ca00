//! Orders as lines of G-code.

use crate::driver::MODES;
use kerf_machine::driver::{Axes, Facts, Order, way_mm};

/// The lines that stand for an order, from a place; why it cannot be made by this controller.
pub fn lines(
    order: &Order,
    from: Axes,
    facts: &Facts,
    on: u32,
) -> Result<Vec<String>, &'static str> {
    match order {
        Order::Move { to, speed_mm_s } => Ok(vec![straight(from, *to, *speed_mm_s, facts)?]),
        Order::Output { line, on: true } if !has(facts, *line) => Err(missing(*line)),
        Order::Output { line, on: state } => Ok(output(*line, *state, on)),
        Order::Spindle { rpm } => Ok(vec![format!("S{}", number(*rpm))]),
        Order::Unlock => Ok(vec!["$X".into(), MODES.into()]),
        Order::Home => Ok(vec!["$H".into(), MODES.into()]),
    }
}

fn has(facts: &Facts, line: u8) -> bool {
    facts.outputs & (1 << (line - 1)) != 0
}

const fn missing(line: u8) -> &'static str {
    match line {
        4 => "it has no output 4: grbl has 1 (spindle), 2 (flood) and 3 (mist)",
        _ => "it does not have this output: grbl has 1 (spindle), 2 (flood) and 3 (mist)",
    }
}

/// A straight move in the machine frame. Only axes that move are named.
fn straight(from: Axes, to: Axes, speed_mm_s: f64, facts: &Facts) -> Result<String, &'static str> {
    let mut line = String::from("G53G1");
    for (axis, letter) in "XYZABC".chars().enumerate() {
        if to.0[axis] == from.0[axis] {
            continue;
        }
        if axis >= facts.axes {
            return Err("it does not have an axis that moves");
        }
        line.push(letter);
        line += &number(to.0[axis]);
    }
    if way_mm(from, to) == 0.0 {
        // A place that it has already: the feed alone is no motion.
        return Ok(format!("F{}", number(speed_mm_s * 60.0)));
    }
    Ok(line + "F" + &number(speed_mm_s * 60.0))
}

/// An output; `on` are those that are on.
fn output(line: u8, state: bool, on: u32) -> Vec<String> {
    let one = |line: &str| vec![line.to_owned()];
    match (line, state) {
        (1, true) => one("M3"),
        (1, false) => one("M5"),
        (2, true) => one("M8"),
        (3, true) => one("M7"),
        // M9 switches both off.
        (2, false) if on & 0b100 != 0 => vec!["M9".into(), "M7".into()],
        (3, false) if on & 0b010 != 0 => vec!["M9".into(), "M8".into()],
        (2 | 3, false) => one("M9"),
        (line, true) => vec![format!("M64P{}", line - 4)],
        (line, false) => vec![format!("M65P{}", line - 4)],
    }
}

/// A number as short as three decimals allow: a thousandth of a millimetre is less than a step.
fn number(value: f64) -> String {
    let text = format!("{value:.3}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".into() } else { text.into() }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(order: Order, on: u32, expected: &[&str]) {
        let facts = Facts { axes: 3, outputs: 0b111, ..Facts::default() };
        let from = Axes::xyz(1.0, 2.0, 3.0);
        assert_eq!(lines(&order, from, &facts, on).expect("lines"), expected);
    }

    #[test]
    fn orders_are_short_lines() {
        let to = |x, y, z| Order::Move { to: Axes::xyz(x, y, z), speed_mm_s: 20.0 };
        check(to(10.0, 2.0, -0.1234), 0, &["G53G1X10Z-0.123F1200"]);
        check(to(1.0, 2.0, 3.0), 0, &["F1200"]);
        check(Order::Output { line: 1, on: true }, 0, &["M3"]);
        check(Order::Output { line: 2, on: false }, 0b110, &["M9", "M7"]);
        check(Order::Output { line: 2, on: false }, 0b010, &["M9"]);
        check(Order::Spindle { rpm: 12_000.0 }, 0, &["S12000"]);
    }

    #[test]
    fn what_it_lacks_is_refused() {
        let facts = Facts { axes: 3, outputs: 0b111, ..Facts::default() };
        let mut to = Axes::default();
        to.0[3] = 90.0;
        let turn = Order::Move { to, speed_mm_s: 1.0 };
        assert!(lines(&turn, Axes::default(), &facts, 0).is_err());
        assert!(lines(&Order::Output { line: 5, on: true }, Axes::default(), &facts, 0).is_err());
        assert!(lines(&Order::Output { line: 3, on: true }, Axes::default(), &facts, 0).is_ok());
    }
}
