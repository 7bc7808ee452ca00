//! Orders as lines of G-code.

use crate::driver::MODES;
use kerf_machine::driver::{Axes, Facts, Order, Shares, decimal, rounded, way_mm};
use std::f64::consts::TAU;

/// Words that hold from line to line.
#[derive(Clone, Debug, Default)]
pub struct Modal {
    /// `G1` or `G0` holds.
    motion: &'static str,
    /// The feed that holds.
    feed: String,
}

/// The lines that stand for an order, from a place; why it cannot be made by this controller.
pub fn lines(
    order: &Order,
    from: Axes,
    facts: &Facts,
    on: u32,
    modal: &mut Modal,
) -> Result<Vec<String>, &'static str> {
    if matches!(order, Order::Probe { .. } | Order::Home | Order::Unlock) {
        *modal = Modal::default();
    }
    match order {
        Order::Move { to, speed_mm_s } => Ok(vec![straight(from, *to, *speed_mm_s, facts, modal)?]),
        Order::Jog { to, .. } => Ok(vec![rapid(from, *to, facts, modal)?]),
        Order::Arc { to, centre, sweep_rad, speed_mm_s } => {
            let turn = if *sweep_rad > 0.0 { "G3" } else { "G2" };
            // A whole turn ends in the very place where it begins.
            let z = Axes::xyz(from.0[0], from.0[1], to.0[2]);
            let to = if sweep_rad.abs() > TAU - WHOLE_RAD { z } else { *to };
            Ok(arc(from, to, *centre, turn, &number(speed_mm_s * 60.0), modal))
        }
        Order::Probe { to, speed_mm_s, active } => probe(from, *to, *speed_mm_s, *active, facts),
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

/// A move that ends at a contact, or where it is lost, and alarms nobody when there is none. It is told by its way, as
/// probing knows the frame of the workpiece alone.
fn probe(
    from: Axes,
    to: Axes,
    speed_mm_s: f64,
    active: bool,
    facts: &Facts,
) -> Result<Vec<String>, &'static str> {
    let way = to.minus(from);
    let code = if active { "G91G38.3" } else { "G91G38.5" };
    let words = words(Axes::default(), way, facts)?;
    let feed = number(speed_mm_s * 60.0);
    Ok(vec![format!("{code}{words}F{feed}"), "G90".into()])
}

/// A straight move in the machine frame. Only axes that move are named.
pub fn straight(
    from: Axes,
    to: Axes,
    speed_mm_s: f64,
    facts: &Facts,
    modal: &mut Modal,
) -> Result<String, &'static str> {
    let words = words(from, to, facts)?;
    let feed = number(speed_mm_s * 60.0);
    if way_mm(from, to) == 0.0 {
        // A place that it has already: the feed alone is no motion.
        let line = format!("F{feed}");
        modal.feed = feed;
        return Ok(line);
    }
    let word = modal.begins("G1");
    let rate = if modal.feed == feed { String::new() } else { format!("F{feed}") };
    modal.feed = feed;
    Ok(format!("G53{word}{words}{rate}"))
}

/// An arc. It is told by its ways, as arcs know the frame of the workpiece alone; those of places that were rounded, so that
/// nothing adds up.
fn arc(
    from: Axes,
    to: Axes,
    centre: [f64; 2],
    turn: &'static str,
    feed: &str,
    modal: &mut Modal,
) -> Vec<String> {
    let way = |axis: usize, to: f64| number(rounded(to, 3) - rounded(from.0[axis], 3));
    let place = |axis: usize| way(axis, to.0[axis]);
    let z = place(2);
    let z = if z == "0" { String::new() } else { format!("Z{z}") };
    let [i, j] = [way(0, centre[0]), way(1, centre[1])];
    let rate = if modal.feed == feed { String::new() } else { format!("F{feed}") };
    feed.clone_into(&mut modal.feed);
    modal.begins(turn);
    vec![format!("G91{turn}X{}Y{}{z}I{i}J{j}{rate}", place(0), place(1)), "G90".into()]
}

/// A rapid move in the machine frame.
fn rapid(from: Axes, to: Axes, facts: &Facts, modal: &mut Modal) -> Result<String, &'static str> {
    let words = words(from, to, facts)?;
    if words.is_empty() {
        return Ok("G90".into());
    }
    Ok(format!("G53{}{words}", modal.begins("G0")))
}

impl Modal {
    /// Returns the word that has a kind of motion hold; empty where it does.
    fn begins(&mut self, word: &'static str) -> &'static str {
        if std::mem::replace(&mut self.motion, word) == word { "" } else { word }
    }
}

/// An arc that is by less than this not a turn is one.
const WHOLE_RAD: f64 = 1e-5;

/// Share by which two speeds differ that are the same.
const SAME: f64 = 1e-6;

/// Returns an order as it is told: a jog that is slower than a rapid move of the controller is one with a feed, which its feed
/// override is taken out of.
pub fn told_as(order: Order, from: Axes, facts: &Facts, shares: Shares) -> Order {
    match order {
        Order::Jog { to, speed_mm_s } if !is_rapid(from, to, speed_mm_s, facts) => {
            let share = f64::from(shares.rapid) / f64::from(shares.feed);
            Order::Move { to, speed_mm_s: speed_mm_s * share }
        }
        other => other,
    }
}

/// Returns `true` if no axis that moves lets the controller go faster.
fn is_rapid(from: Axes, to: Axes, speed_mm_s: f64, facts: &Facts) -> bool {
    let length_mm = way_mm(from, to);
    let ways = to.minus(from).0;
    let moved = ways.iter().enumerate().filter(|(_, way)| **way != 0.0);
    let mut most_mm_s = f64::INFINITY;
    for (axis, way) in moved {
        let Some(axis_mm_s) = facts.speed_mm_s[axis] else { return false };
        most_mm_s = most_mm_s.min(axis_mm_s * length_mm / way.abs());
    }
    most_mm_s.is_finite() && speed_mm_s >= most_mm_s * (1.0 - SAME)
}

/// The lines of an order while the controller waits for a tool and makes jogs alone.
pub fn jogs_alone(order: &Order, from: Axes, facts: &Facts) -> Result<Vec<String>, &'static str> {
    match order {
        Order::Move { to, speed_mm_s } | Order::Jog { to, speed_mm_s } => {
            Ok(vec![jog(from, *to, *speed_mm_s, facts)?])
        }
        _ => Err("it waits for a tool: it makes jogs alone until the tool is in"),
    }
}

/// A jog in the machine frame (`$J=`), which leaves the words that hold as they are.
fn jog(from: Axes, to: Axes, speed_mm_s: f64, facts: &Facts) -> Result<String, &'static str> {
    let words = words(from, to, facts)?;
    if words.is_empty() {
        return Ok("G90".into());
    }
    Ok(format!("$J=G21G90G53{words}F{}", number(speed_mm_s * 60.0)))
}

/// The words of the axes that move.
fn words(from: Axes, to: Axes, facts: &Facts) -> Result<String, &'static str> {
    let mut words = String::new();
    for (axis, letter) in "XYZABC".chars().enumerate() {
        if to.0[axis] == from.0[axis] {
            continue;
        }
        if axis >= facts.axes {
            return Err("it does not have an axis that moves");
        }
        words.push(letter);
        words += &number(to.0[axis]);
    }
    Ok(words)
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
    decimal(value, 3)
}

/// Returns how many moves the planner makes of an arc, and no more than that: each of its chords lies no farther inside it than
/// the tolerance.
pub fn parts(radius_mm: f64, sweep_rad: f64, tolerance_mm: f64) -> usize {
    let half_chord = (tolerance_mm * (2.0 * radius_mm - tolerance_mm)).sqrt();
    let parts = 0.5 * sweep_rad.abs() * radius_mm / half_chord;
    // Rounding may make one less.
    if parts.is_finite() { (parts as usize).saturating_sub(1).max(1) } else { 1 }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(order: Order, on: u32, expected: &[&str]) {
        let facts = Facts { axes: 3, outputs: 0b111, ..Facts::default() };
        let from = Axes::xyz(1.0, 2.0, 3.0);
        let modal = &mut Modal::default();
        assert_eq!(lines(&order, from, &facts, on, modal).expect("lines"), expected);
    }

    #[test]
    fn orders_are_short_lines() {
        let to = |x, y, z| Order::Move { to: Axes::xyz(x, y, z), speed_mm_s: 20.0 };
        check(to(10.0, 2.0, -0.1234), 0, &["G53G1X10Z-0.123F1200"]);
        check(to(1.0, 2.0, 3.0), 0, &["F1200"]);
        let probe = |active| Order::Probe { to: Axes::xyz(1.0, 2.5, 1.0), speed_mm_s: 5.0, active };
        check(probe(true), 0, &["G91G38.3Y0.5Z-2F300", "G90"]);
        check(probe(false), 0, &["G91G38.5Y0.5Z-2F300", "G90"]);
        let arc = |to, sweep_rad| Order::Arc { to, centre: [6.0, 2.0], sweep_rad, speed_mm_s: 5.0 };
        let half = Axes::xyz(11.0, 2.0, 3.0);
        check(arc(half, -3.0), 0, &["G91G2X10Y0I5J0F300", "G90"]);
        let from = Axes::xyz(1.0, 2.0, 2.5);
        check(arc(from, 6.3), 0, &["G91G3X0Y0Z-0.5I5J0F300", "G90"]);
        check(Order::Output { line: 1, on: true }, 0, &["M3"]);
        check(Order::Output { line: 2, on: false }, 0b110, &["M9", "M7"]);
        check(Order::Output { line: 2, on: false }, 0b010, &["M9"]);
        check(Order::Spindle { rpm: 12_000.0 }, 0, &["S12000"]);
    }

    #[test]
    fn words_that_hold_are_not_repeated() {
        let facts = Facts { axes: 3, outputs: 0b111, ..Facts::default() };
        let (mut modal, mut from, mut said) = (Modal::default(), Axes::default(), Vec::new());
        let to = |x| Axes::xyz(x, 0.0, 0.0);
        for order in [
            Order::Move { to: to(1.0), speed_mm_s: 20.0 },
            Order::Move { to: to(2.0), speed_mm_s: 20.0 },
            Order::Move { to: to(3.0), speed_mm_s: 10.0 },
            Order::Output { line: 1, on: true },
            Order::Move { to: to(4.0), speed_mm_s: 10.0 },
            Order::Probe { to: to(5.0), speed_mm_s: 10.0, active: true },
            Order::Move { to: to(6.0), speed_mm_s: 10.0 },
        ] {
            said.extend(lines(&order, from, &facts, 0, &mut modal).expect("lines"));
            if let Order::Move { to, .. } | Order::Probe { to, .. } = order {
                from = to;
            }
        }
        let expected = ["G53G1X1F1200", "G53X2", "G53X3F600", "M3", "G53X4"];
        assert_eq!(said, [&expected[..], &["G91G38.3X1F600", "G90", "G53G1X6F600"]].concat());
    }

    #[test]
    fn what_it_lacks_is_refused() {
        let facts = Facts { axes: 3, outputs: 0b111, ..Facts::default() };
        let mut to = Axes::default();
        to.0[3] = 90.0;
        let turn = Order::Move { to, speed_mm_s: 1.0 };
        let lines = |order, facts: &Facts| {
            super::lines(order, Axes::default(), facts, 0, &mut Modal::default())
        };
        assert!(lines(&turn, &facts).is_err());
        assert!(lines(&Order::Output { line: 5, on: true }, &facts).is_err());
        assert!(lines(&Order::Output { line: 3, on: true }, &facts).is_ok());
    }
}
