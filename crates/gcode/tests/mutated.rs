//! Programs with mistakes by dice: bytes left out, doubled, changed, put elsewhere, and files cut short.
//!
//! `MUTATIONS=10000` makes so many of each program instead of the usual few.

use crate::find;
use crate::support::Quiet;
use kerf_gcode::{Dialect, Interpreter, Options, Session, format, read};
use kerf_program::{Command, Step};
use std::path::PathBuf;

/// Of each program, unless asked otherwise.
const USUAL: u64 = 40;

/// Lines that one of them may run.
const MOST_LINES: u64 = 2_000;

/// Pieces that are put in: some that the grammar knows, and some that it does not.
const PIECES: [&str; 40] = [
    "G",
    "M",
    "X",
    "#",
    "[",
    "]",
    "<",
    ">",
    "(",
    ")",
    ";",
    "/",
    "%",
    "$",
    "@",
    "^",
    "O",
    "=",
    "-",
    ".",
    "e9",
    "1e-5",
    "99999999999",
    "\n",
    "\r",
    "\0",
    "é",
    "\u{FEFF}",
    "G2",
    "G41 D1",
    "o1 sub",
    "M98 P1",
    "#<_x>",
    "**",
    "ATAN[",
    "EXISTS[",
    "G91",
    "G18",
    "G10 L2 P1",
    "G81 R1 Z-1",
];

/// A small generator of numbers: the same on every machine.
struct Dice(u64);

impl Dice {
    fn roll(&mut self, sides: usize) -> usize {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % sides.max(1)
    }
}

fn mutated(bytes: &[u8], dice: &mut Dice) -> Vec<u8> {
    let mut text = bytes.to_vec();
    for _ in 0..=dice.roll(6) {
        let at = dice.roll(text.len() + 1);
        let end = (at + 1 + dice.roll(12)).min(text.len());
        match dice.roll(6) {
            0 => drop(text.drain(at..end)),
            1 => {
                let piece = PIECES[dice.roll(PIECES.len())].bytes();
                drop(text.splice(at..at, piece));
            }
            2 => {
                let piece = text[at..end].to_vec();
                let there = dice.roll(text.len() + 1);
                drop(text.splice(there..there, piece));
            }
            3 if at < text.len() => text[at] = dice.roll(256) as u8,
            4 if dice.roll(4) == 0 => text.truncate(at),
            _ if at < text.len() => text[at] ^= 1 << dice.roll(8),
            _ => {}
        }
    }
    text
}

/// The program is read, checked to its end, run to its first mistake, and formatted; every finding has a
/// place in the file.
fn withstands(bytes: &[u8], dice: &mut Dice) {
    let dialect = [Dialect::LinuxCnc, Dialect::Grbl, Dialect::Generic][dice.roll(3)];
    for keep_going in [true, false] {
        let program = read("m.nc".into(), bytes);
        let lines = program.line_count();
        let fits = |d: &kerf_diag::Diagnostic| {
            d.place.line <= lines.max(1) && !d.message.is_empty() && d.place.column >= 1
        };
        assert!(lines == 0 || program.diagnostics.iter().all(fits), "{:?}", program.diagnostics);
        let options = Options {
            dialect,
            keep_going,
            preview: true,
            max_lines: MOST_LINES,
            ..Options::default()
        };
        let mut interpreter = Interpreter::new(program, Session::default(), options);
        let mut out = Vec::new();
        loop {
            let step = interpreter.run(&mut Quiet::default(), &mut out, 500);
            let told = out.iter().filter_map(|s| match &s.command {
                Command::Diagnostic(d) => Some(&**d),
                _ => None,
            });
            assert!(told.into_iter().all(fits), "{out:?}");
            out.clear();
            match step {
                Step::Done(_, error) => {
                    assert!(error.iter().all(|e| fits(e)), "{error:?}");
                    break;
                }
                Step::Waiting => panic!("nobody is waited for"),
                Step::Ran => {}
            }
        }
    }
    if let Ok(text) = std::str::from_utf8(bytes) {
        let once = format(text);
        assert_eq!(format(&once), once, "{text:?}");
    }
}

fn programs() -> Vec<PathBuf> {
    let here = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    let folders = [here.join("../../fuzz/seeds/run_gcode"), here.join("../../examples/08-g-code")];
    let own = folders.iter().flat_map(|folder| find::files(folder));
    let mut files: Vec<PathBuf> = own.chain(find::all("gcode")).collect();
    files.retain(|f| std::fs::metadata(f).unwrap().len() < 8_000);
    files.sort();
    files
}

#[test]
fn mistakes_by_dice_are_told_and_nothing_panics() {
    let wanted = std::env::var("MUTATIONS").ok().and_then(|n| n.parse().ok());
    let files = programs();
    assert!(!files.is_empty());
    for file in &files {
        let bytes = std::fs::read(file).unwrap();
        for seed in 0..wanted.unwrap_or(USUAL) {
            let mut dice = Dice(seed);
            let text = mutated(&bytes, &mut dice);
            let outcome = std::panic::catch_unwind(|| withstands(&text, &mut Dice(seed)));
            assert!(
                outcome.is_ok(),
                "{} with seed {seed}:\n{}",
                file.display(),
                String::from_utf8_lossy(&text)
            );
        }
    }
    println!("{} programs, {} mutations of each", files.len(), wanted.unwrap_or(USUAL));
}
