//! Programs from dice.

use std::f64::consts::{PI, TAU};

/// Factor by which programs are larger than parts; see the head of the test.
pub const SCALE: f64 = 10_000.0;

/// Number of programs that are compared, a third of them with cutter compensation; ten times as many agree too.
pub const PROGRAMS: u64 = 90;

/// A small generator of numbers: the same on every machine.
pub struct Dice(u64);

impl Dice {
    fn roll(&mut self, sides: u64) -> u64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % sides
    }
    fn number(&mut self) -> f64 {
        (self.roll(20_001) as f64 - 10_000.0) / 1000.0 * SCALE
    }
}

/// A program of random blocks that are all allowed.
pub fn generated(seed: u64) -> String {
    let mut dice = Dice(seed);
    let mut text = String::from("G21 G90 G94 G17 F100 S100 M3\nG0 X1 Y2 Z3\n");
    for _ in 0..40 {
        let (a, b, c) = (dice.number(), dice.number(), dice.number());
        let block = match dice.roll(26) {
            0..=3 => format!("G1 X{a} Y{b}"),
            4 => format!("G0 X{a} Z{c}"),
            5 => format!("G1 A{a} B{b} C{c}"),
            // With a tool offset in force it keeps the number when the unit changes.
            6 => format!("G49\nG20 G0 X{a}"),
            7 => format!("G49\nG21 G1 Y{b}"),
            8 => format!("G91 G1 X{a} Y{b}\nZ{c}\nG90"),
            9 => format!("G91 G2 X{a} Y{b} R{}", a.hypot(b) * 0.7 + 0.1 * SCALE),
            10 => format!("G91 G3 X{a} Y{b} R-{}", a.hypot(b) * 0.9 + 0.1 * SCALE),
            11 => format!("G91\nG3 X{a} Y{a} I{a} J0 Z{c} P{}\nG90", 1 + dice.roll(3)),
            12 => format!("G2 I{a} J{b}"),
            13 => format!("G18 G91 G2 X{a} Z{a} I{a} K0\nG17 G90"),
            14 => format!("G19 G91 G3 Y{a} Z{a} J{a} K0\nG17 G90"),
            15 => format!("G10 L2 P{} X{a} Y{b} Z{c}", 1 + dice.roll(9)),
            16 => format!("G10 L20 P{} X{a} Y{b}", 1 + dice.roll(9)),
            17 => format!("G5{}\nG0 X{a}", 4 + dice.roll(6)),
            18 => format!("G92 X{a} Z{c}\nG0 X{b}"),
            19 => ["G92.1", "G92.2", "G92.3"][dice.roll(3) as usize].into(),
            20 => format!("G10 L2 P0 R{}\nG0 X{a} Y{b}", dice.roll(360)),
            21 => format!("G52 X{a}\nG1 Y{b}"),
            22 => format!("G43 H{}\nG0 Z{c}", 1 + dice.roll(9)),
            23 => format!("G49\nG0 Z{c}"),
            24 => cycle(&mut dice),
            _ => format!("G53 G0 X{a} Z{c}"),
        };
        text.push_str(&block.replace("--", ""));
        text.push('\n');
        if block.starts_with("G91") {
            text.push_str("G90\n");
        }
    }
    text + "M2\n"
}

fn cycle(dice: &mut Dice) -> String {
    let code = [73, 81, 82, 83, 84, 85, 86, 89][dice.roll(8) as usize];
    let (x, y, z) = (dice.number(), dice.number(), dice.number());
    let mut text = format!("G9{}\n", 8 + dice.roll(2));
    let word = match code {
        73 | 83 => format!("Q{}", (0.4 + dice.roll(30) as f64 / 10.0) * SCALE),
        82 | 84 | 86 | 89 => "P0.1".into(),
        _ => String::new(),
    };
    text += &format!("G{code} X{x} Y{y} Z{z} R{} {word}", z + 2.0 * SCALE);
    text += &format!(
        "\nX{y}\nG91 Z{} R{} X{x} L{} {word}\nG90 G80",
        -1.5 * SCALE,
        0.5 * SCALE,
        1 + dice.roll(3)
    );
    text
}

/// Turns closer to half a turn than this are left out: rounding an outside corner of that kind is one of
/// the differences that are meant.
const NEARLY_BACK_RAD: f64 = 0.06;

/// A path of lines and arcs with compensation, most of which fits.
pub fn compensated(seed: u64) -> String {
    let mut dice = Dice(seed);
    let mut text = format!("G21 G90 G17 F100\nT{} M6\nG0 X0 Y0\n", 1 + dice.roll(20));
    let (side, x, y) = (1 + dice.roll(2), 20.0 * SCALE, dice.number());
    text += &format!("G4{side} G1 X{x} Y{y}\nG91\n");
    let mut heading = y.atan2(x);
    for _ in 0..12 {
        let (a, b) = (dice.number() * 2.0, dice.number() * 2.0);
        let (block, begins, ends) = piece(&mut dice, a, b, heading);
        let turn = (begins - heading).rem_euclid(TAU);
        if (turn - PI).abs() > NEARLY_BACK_RAD {
            text += &block;
            heading = ends;
        }
    }
    text + "G90 G40\nG0 X0 Y0 Z9\nM2\n"
}

/// A block, and the directions of the path at its beginning and its end.
fn piece(dice: &mut Dice, a: f64, b: f64, heading: f64) -> (String, f64, f64) {
    let (chord, along) = (a.hypot(b), b.atan2(a));
    let half = |radius: f64| (chord / 2.0 / radius).asin();
    match dice.roll(6) {
        0..=2 => (format!("G1 X{a} Y{b}\n"), along, along),
        3 => {
            let radius = chord * 0.8 + 2.0 * SCALE;
            let text = format!("G2 X{a} Y{b} R{radius}\n");
            (text, along + half(radius), along - half(radius))
        }
        4 => {
            let radius = chord * 0.6 + 2.0 * SCALE;
            let text = format!("G3 X{a} Y{b} R{radius}\n");
            (text, along - half(radius), along + half(radius))
        }
        _ => (format!("G1 Z{a}\n"), heading, heading),
    }
}
