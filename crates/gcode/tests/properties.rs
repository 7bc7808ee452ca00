//! Properties of any text and any program.

use crate::support::Quiet;
use kerf_gcode::{Dialect, Interpreter, Options, Program, Session, Writing, read, write};
use kerf_program::settings::LinearUnit;
use kerf_program::{Arc, At, Axes, Command, Feed, Line, MoveKind, Sourced, Step};
use proptest::prelude::*;

fn session() -> Session {
    let mut session = Session::default();
    session.settings.linear_unit = LinearUnit::Mm;
    session.settings.axis_count = 6;
    session
}

fn run(program: Program, options: Options, lines: u64) -> (Vec<Sourced>, Step) {
    let options = Options { max_lines: 20_000, ..options };
    let mut interpreter = Interpreter::new(program, session(), options);
    let mut out = Vec::new();
    loop {
        let step = interpreter.run(&mut Quiet::default(), &mut out, lines);
        if step != Step::Ran {
            return (out, step);
        }
    }
}

/// Pieces of blocks: glued together they give everything from good programs to nonsense.
fn piece() -> impl Strategy<Value = String> {
    let words = [
        "G0",
        "G1",
        "G2",
        "G3",
        "G4",
        "G5",
        "G5.1",
        "G5.2",
        "G5.3",
        "G10",
        "G17",
        "G18",
        "G19",
        "G20",
        "G21",
        "G28",
        "G38.2",
        "G38.3",
        "G40",
        "G41",
        "G42",
        "G41.1",
        "G43",
        "G49",
        "G52",
        "G53",
        "G54",
        "G59.3",
        "G61",
        "G64",
        "G73",
        "G80",
        "G81",
        "G82",
        "G83",
        "G84",
        "G87",
        "G88",
        "G90",
        "G91",
        "G90.1",
        "G91.1",
        "G92",
        "G92.1",
        "G93",
        "G94",
        "G95",
        "G98",
        "G99",
        "M0",
        "M1",
        "M3",
        "M4",
        "M5",
        "M6",
        "M7",
        "M8",
        "M9",
        "M48",
        "M66",
        "M70",
        "M72",
        "M73",
        "M98",
        "M99",
        "T1",
        "L2",
        "L20",
        "P1",
        "P2",
        "O1 sub",
        "O1 endsub",
        "O1 call",
        "O2 if [1]",
        "O2 else",
        "O2 endif",
        "O3 while [#1 LT 3]",
        "O3 endwhile",
        "O4 repeat [2]",
        "O4 endrepeat",
        "O3 break",
        "O3 continue",
        "O5 do",
        "O5 while [0]",
        "#1=[#1+1]",
        "#<a>=2",
        "#<_b>=#<a>",
        "(MSG,x)",
        "(PRINT,#1 #<a>)",
        "%",
        "/",
        "$H",
        ";",
        "(",
        ")",
        "[",
        "]",
        "#",
        "<",
        "é",
        "F100",
        "S1000",
        "D1",
        "H1",
        "@5",
        "^90",
        "X[1/0]",
        "-",
        ".",
        "*",
    ];
    let number = (0..8u8, -20.0..20.0f64).prop_map(|(l, v)| {
        format!("{}{v:.3}", ["X", "Y", "Z", "A", "I", "J", "R", "K"][usize::from(l)])
    });
    prop_oneof![
        4 => prop::sample::select(words.to_vec()).prop_map(str::to_owned),
        5 => number,
        2 => Just("\n".to_owned()),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn any_bytes_are_read(bytes in prop::collection::vec(any::<u8>(), 0..400)) {
        let program = read("any".into(), &bytes);
        run(program, Options { keep_going: true, ..Options::default() }, 100);
    }

    #[test]
    fn any_blocks_run_to_an_end_and_chunks_do_not_matter(
        pieces in prop::collection::vec(piece(), 1..60),
        lines in 1u64..40,
    ) {
        let text = format!("G21 F100\n{}", pieces.join(" "));
        for dialect in [Dialect::LinuxCnc, Dialect::Generic, Dialect::Mach3] {
            for keep_going in [false, true] {
                let options = Options { dialect, keep_going, ..Options::default() };
                let whole = run(read("p".into(), text.as_bytes()), options.clone(), u64::MAX);
                let parts = run(read("p".into(), text.as_bytes()), options, lines);
                prop_assert_eq!(&whole, &parts);
                for sourced in &whole.0 {
                    if let Command::Line(Line { to, .. }) | Command::Arc(Arc { to, .. }) = &sourced.command {
                        prop_assert!(to.0.iter().all(|v| v.is_finite()), "{:?}", to);
                    }
                }
            }
        }
    }

    #[test]
    fn a_saved_run_goes_on_as_if_never_saved(
        pieces in prop::collection::vec(piece(), 1..40),
        after in 0u64..20,
    ) {
        let text = format!("G21 F100\n{}", pieces.join(" "));
        let options = Options { keep_going: true, max_lines: 2000, ..Options::default() };
        let mut one = Interpreter::new(read("p".into(), text.as_bytes()), session(), options);
        let mut out = Vec::new();
        if one.run(&mut Quiet::default(), &mut out, after) == Step::Ran {
            let saved = serde_json::to_string(&one).unwrap();
            let mut two: Interpreter = serde_json::from_str(&saved).unwrap();
            let (mut a, mut b) = (Vec::new(), Vec::new());
            let ends = (
                one.run(&mut Quiet::default(), &mut a, u64::MAX),
                two.run(&mut Quiet::default(), &mut b, u64::MAX),
            );
            prop_assert_eq!(ends.0, ends.1);
            prop_assert_eq!(format!("{a:?}"), format!("{b:?}"));
        }
    }

    #[test]
    fn what_is_written_runs_the_same_path(
        moves in prop::collection::vec(
            (0..4u8, -50.0..50.0f64, -50.0..50.0f64, -9.0..9.0f64, -15.0..15.0f64, 0.5..40.0f64), 1..30),
        inches in any::<bool>(),
        dialect in 0..3u8,
    ) {
        let mut position = Axes::default();
        let mut commands = Vec::new();
        for (what, x, y, z, sweep_rad, speed) in moves {
            let feed = if what == 3 { Feed::Time(speed) } else { Feed::Path(speed) };
            let command = if what < 2 {
                let kind = if what == 0 { MoveKind::Jog } else { MoveKind::Cut };
                position = Axes([x, y, z, if dialect == 0 { sweep_rad } else { 0.0 }, 0.0, 0.0]);
                Command::Line(Line { kind, to: position, feed: if what == 0 { Feed::Axis } else { feed } })
            } else {
                let centre = [x, y];
                let (dx, dy) = (position.0[0] - x, position.0[1] - y);
                let (sin, cos) = sweep_rad.sin_cos();
                position.0[0] = x + dx * cos - dy * sin;
                position.0[1] = y + dx * sin + dy * cos;
                position.0[2] = z;
                let kind = MoveKind::Cut;
                Command::Arc(Arc { kind, centre, sweep_rad, to: position, feed, chords: 1, small: false })
            };
            commands.push(Sourced { at: At::default(), command });
        }
        let dialect = [Dialect::LinuxCnc, Dialect::Grbl, Dialect::Generic][usize::from(dialect)];
        let unit = if inches { LinearUnit::Inch } else { LinearUnit::Mm };
        let text = write(&commands, &Writing { dialect, unit, ..Writing::default() }).text;
        let program = read("w".into(), text.as_bytes());
        prop_assert!(program.diagnostics.is_empty(), "{:?}\n{}", program.diagnostics, text);
        let (again, end) = run(program, Options { dialect, ..Options::default() }, u64::MAX);
        prop_assert!(matches!(end, Step::Done(kerf_program::Status::Ok, _)), "{:?}\n{}", end, text);
        compare(&commands, &again).map_err(|e| TestCaseError::fail(format!("{e}\n{text}")))?;
    }
}

/// The same path: places at the same shares of each move; arcs may come in several parts.
fn compare(wanted: &[Sourced], found: &[Sourced]) -> Result<(), String> {
    let mut found = found.iter().filter(|s| s.command.is_motion());
    let mut at = Axes::default();
    for sourced in wanted {
        match &sourced.command {
            Command::Line(line) => {
                if line.to == at {
                    continue;
                }
                let Some(Command::Line(other)) = found.next().map(|s| &s.command) else {
                    return Err(format!("no line for {line:?}"));
                };
                near(line.to, other.to)?;
                same_feed(line.feed, other.feed)?;
                at = line.to;
            }
            Command::Arc(arc) => {
                let mut left = arc.sweep_rad;
                while left.abs() > 1e-6 {
                    let Some(Command::Arc(other)) = found.next().map(|s| &s.command) else {
                        return Err(format!("no arc for {arc:?}"));
                    };
                    if (arc.centre[0] - other.centre[0]).hypot(arc.centre[1] - other.centre[1])
                        > 1e-6
                    {
                        return Err(format!("{arc:?} became {other:?}"));
                    }
                    left -= other.sweep_rad;
                    at = other.to;
                }
                near(arc.to, at)?;
            }
            _ => {}
        }
    }
    found.next().map_or(Ok(()), |more| Err(format!("one more: {more:?}")))
}

fn near(a: Axes, b: Axes) -> Result<(), String> {
    let off = a.0.iter().zip(b.0).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    if off < 1e-6 { Ok(()) } else { Err(format!("{a:?} became {b:?}")) }
}

fn same_feed(a: Feed, b: Feed) -> Result<(), String> {
    let same = match (a, b) {
        (Feed::Axis, Feed::Axis) => true,
        (Feed::Path(a), Feed::Path(b)) | (Feed::Time(a), Feed::Time(b)) => {
            (a / b - 1.0).abs() < 1e-6
        }
        _ => false,
    };
    if same { Ok(()) } else { Err(format!("feed {a:?} became {b:?}")) }
}
