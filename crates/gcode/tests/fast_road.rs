//! Runs of plain moves are executed on a road of their own, which must do what line by line does.

use crate::support::Quiet;
use kerf_gcode::{Dialect, Interpreter, Options, Session, read};
use kerf_program::settings::{AxisUnit, LinearUnit};
use kerf_program::{GoTo, Sourced, Step};
use proptest::prelude::*;
use serde::Serialize;
use serde_json::Value;

/// Numbers that differ by less, of what they are and of 1, differ by rounding.
const ROUNDING: f64 = 1e-10;

/// Lines that a setting, a mode or an offset comes from, and lines that no plain move is.
const OTHERS: &[&str] = &[
    "G90",
    "G91",
    "G20",
    "G21",
    "G93",
    "G94",
    "G95",
    "G17",
    "G18",
    "G19",
    "G90.1",
    "G91.1",
    "G54",
    "G55",
    "G10 L2 P1 R30",
    "G10 L2 P1 R0",
    "G10 L2 P2 X3 Y4",
    "G92 X1 Y2",
    "G92.1",
    "G43.1 Z5",
    "G49",
    "G52 X2",
    "G41.1 D1",
    "G41.1 D1\nG1 X9\nG40",
    "G40",
    "G1",
    "G80",
    "G81 X1 Y1 Z-1 R1",
    "G81 X1 Y1 Z-1 R1\nG1 X2",
    "G82 Z-2 R2 P1",
    "G5 X9 Y9 I1 J1 P1 Q1",
    "G5 X4 Y5 P1 Q2",
    "G5.2 X1 Y1 P1",
    "G5.3",
    "G53 G0 X1 Y1",
    "F0",
    "F50",
    "S700",
    "M3",
    "M5",
    "M70",
    "M72",
    "M2",
    "G38.2 Z-9",
    "(a comment)",
    "",
    "G1 X[1+1]",
    "#1=2",
    "G1 X#1 F9",
    "/G0 X1",
    "N7 G1 X2",
    "G9999",
    "G61",
    "%",
    "M99",
];

/// A number as a line has it, in thousandths.
fn number() -> impl Strategy<Value = f64> {
    prop_oneof![1 => Just(0), 9 => -9000..9000i32].prop_map(|n| f64::from(n) / 1000.0)
}

/// A line of letters that plain moves have, valid or not.
fn plain() -> impl Strategy<Value = String> {
    let letters = prop::sample::subsequence(b"XYZABIJKRFS".to_vec(), 1..5);
    let motion = prop::sample::select(vec!["", "", "", "G0 ", "G1 ", "G2 ", "G3 "]);
    (motion, letters, prop::collection::vec(number(), 5)).prop_map(|(motion, letters, values)| {
        let signed = |letter: u8, v: f64| if b"FS".contains(&letter) { v.abs() * 100.0 } else { v };
        let word = |(letter, v): (u8, f64)| format!("{}{}", letter as char, signed(letter, v));
        let words: Vec<String> = letters.into_iter().zip(values).map(word).collect();
        format!("{motion}{}", words.join(" "))
    })
}

/// A line of a straight move.
fn straight() -> impl Strategy<Value = String> {
    let axes = prop::sample::subsequence(b"XYZA".to_vec(), 1..3);
    let motion = prop::sample::select(vec!["", "G0 ", "G1 "]);
    let rate = prop::sample::select(vec!["", "", "", " F70", " S9000"]);
    (motion, axes, prop::array::uniform2(number()), rate).prop_map(|(motion, axes, to, rate)| {
        let word = |(letter, v): (u8, f64)| format!("{}{v}", letter as char);
        let words: Vec<String> = axes.into_iter().zip(to).map(word).collect();
        format!("{motion}{}{rate}", words.join(" "))
    })
}

/// Half a circle while distances are relative.
fn half_circle() -> impl Strategy<Value = String> {
    (2..4u8, number(), number(), any::<bool>()).prop_map(|(g, i, j, rises)| {
        let z = if rises { " Z0.5" } else { "" };
        format!("G{g} X{} Y{}{z} I{i} J{j}", 2.0 * i, 2.0 * j)
    })
}

fn line() -> impl Strategy<Value = String> {
    let other = prop::sample::select(OTHERS).prop_map(str::to_owned);
    prop_oneof![1 => plain(), 5 => straight(), 4 => half_circle(), 2 => other]
}

fn options() -> impl Strategy<Value = Options> {
    let dialects = vec![
        Dialect::LinuxCnc,
        Dialect::LinuxCnc,
        Dialect::Generic,
        Dialect::Grbl,
        Dialect::GrblHal,
        Dialect::Mach3,
    ];
    let proportions = vec![[1.0; 3], [2.0, 2.0, 0.5], [2.0, 1.0, 1.0], [-1.0, 1.0, 1.0]];
    (
        prop::sample::select(dialects),
        prop::sample::select(proportions),
        prop::sample::select(vec![0, 9, 10_000]),
        prop::array::uniform4(any::<bool>()),
        prop::sample::select(vec![None, None, None, Some(GoTo { line: 4, settings: true })]),
    )
        .prop_map(|(dialect, proportion, max_lines, [going, known, speeds, stepped], from)| {
            Options {
                dialect,
                proportion,
                max_lines,
                keep_going: going,
                unit_known: known,
                speeds_known: speeds,
                stepped: stepped && known && speeds,
                from,
                ..Options::default()
            }
        })
}

/// A session with this many axes, A along a line or about one.
fn session(axes: u8, linear: bool) -> Session {
    let mut session = Session::default();
    session.settings.linear_unit = LinearUnit::Mm;
    session.settings.axis_count = axes;
    session.position.0 = [1.0, 2.0, 3.0, 4.0, 0.0, 0.0];
    let unit = if linear { AxisUnit::Linear(LinearUnit::Mm) } else { AxisUnit::Degrees };
    session.settings.rotary_units[0] = unit;
    session
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(600))]

    #[test]
    fn runs_of_moves_do_what_line_by_line_does(
        lines in prop::collection::vec(line(), 1..40),
        head in prop::sample::select(vec!["G21 F100\nG91 G1\n", "G21 F100 G91\nG1 X1\n", "G20 G1 F9 X2\n", "", "G91\n"]),
        options in options(),
        (axes, linear) in (3..7u8, any::<bool>()),
        chunk in 1..9u64,
        mut entered in prop::option::weighted(0.2, 1..20u32),
    ) {
        let text = format!("{head}{}", lines.join("\n"));
        let fresh = || Interpreter::new(
            read("p".into(), text.as_bytes()), session(axes, linear), options.clone());
        let (mut fast, mut slow) = (Run::of(fresh()), Run::of(fresh()));
        for _ in 0..60 {
            let done = fast.interpreter.run(&mut Quiet::default(), &mut fast.commands, chunk);
            let (lines, ended) = (fast.interpreter.lines(), done != Step::Ran);
            // The ends of a file and of a probe move, and lines passed over, are steps that count as no line:
            // with them only the end of the run is surely the same place.
            let uncounted = text.contains("G38") || options.from.is_some();
            if !ended && (fast.interpreter.is_over() || uncounted) {
                continue;
            }
            let same = slow.until(lines, ended);
            prop_assert_eq!(&same, &done, "{}", &text);
            prop_assert!(near(&saved(&slow.commands), &saved(&fast.commands)),
                "{:?}\nline by line, but\n{:?}\n{text}", slow.commands, fast.commands);
            prop_assert!(near(&saved(&slow.interpreter), &saved(&fast.interpreter)),
                "another state behind line {lines} of\n{text}");
            if ended {
                break;
            }
            if let Some(line) = entered.take() {
                fast.interpreter.enter_line(line);
                slow.interpreter.enter_line(line);
            }
        }
    }
}

/// A program under way, and what it gave.
struct Run {
    interpreter: Interpreter,
    commands: Vec<Sourced>,
}

impl Run {
    /// Begins: the first step is no line.
    fn of(interpreter: Interpreter) -> Self {
        let mut run = Self { interpreter, commands: Vec::new() };
        run.step();
        run
    }

    fn step(&mut self) -> Step {
        self.interpreter.step(&mut Quiet::default(), &mut self.commands)
    }

    /// Steps until so many lines are executed, or to the end.
    fn until(&mut self, lines: u64, to_end: bool) -> Step {
        while to_end || self.interpreter.lines() < lines {
            let step = self.step();
            if step != Step::Ran {
                return step;
            }
        }
        Step::Ran
    }
}

fn saved(what: &impl Serialize) -> Value {
    serde_json::to_value(what).unwrap()
}

/// Returns `true` for what is the same but for the rounding of numbers: the road counts arcs from the machine's
/// zero, line by line they count from the file's.
fn near(a: &Value, b: &Value) -> bool {
    match (a, b) {
        (Value::Number(a), Value::Number(b)) => match (a.as_f64(), b.as_f64()) {
            (Some(a), Some(b)) => (a - b).abs() <= ROUNDING * a.abs().max(1.0),
            _ => a == b,
        },
        (Value::Array(a), Value::Array(b)) => {
            a.len() == b.len() && a.iter().zip(b).all(|(a, b)| near(a, b))
        }
        (Value::Object(a), Value::Object(b)) => {
            a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a.0 == b.0 && near(a.1, b.1))
        }
        _ => a == b,
    }
}
