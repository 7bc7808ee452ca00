//! What reading and running G-code files finds: `cargo run -p kerf-gcode --example diagnostics -- FILE…`.
//!
//! Runs each file without a machine in the dialect of the environment variable `DIALECT` (`linuxcnc`,
//! `grbl` or `generic`), prints every diagnostic, and how many moves and arcs there were.
#![allow(clippy::print_stdout)]

use kerf_gcode::{Dialect, Interpreter, Options, Session, read};
use kerf_program::{Command, Step};
use std::path::PathBuf;
use support::Quiet;

#[path = "../tests/support/mod.rs"]
mod support;

fn main() {
    let dialect = match std::env::var("DIALECT").as_deref() {
        Ok("grbl") => Dialect::Grbl,
        Ok("generic") => Dialect::Generic,
        _ => Dialect::LinuxCnc,
    };
    for file in std::env::args().skip(1) {
        show(&file, dialect);
    }
}

fn show(file: &str, dialect: Dialect) {
    let Ok(bytes) = std::fs::read(file) else {
        println!("{file}: cannot be read");
        return;
    };
    let path = PathBuf::from(file);
    let name = path.file_name().map_or_else(String::new, |n| n.to_string_lossy().into_owned());
    let program = read(name.as_str().into(), &bytes);
    let mut found = program.diagnostics.clone();
    let mut session = Session::default();
    session.settings.axis_count = 6;
    let options = Options {
        dialect,
        keep_going: true,
        max_lines: 1_000_000,
        preview: true,
        ..Options::default()
    };
    let mut interpreter = Interpreter::new(program, session, options);
    let mut host = Quiet(path.parent().map_or_else(PathBuf::new, PathBuf::from));
    let (mut out, mut lines, mut arcs) = (Vec::new(), 0, 0);
    let end = loop {
        let step = interpreter.run(&mut host, &mut out, 4096);
        for sourced in out.drain(..) {
            match sourced.command {
                Command::Line(_) => lines += 1,
                Command::Arc(_) => arcs += 1,
                Command::Diagnostic(d) => found.push(*d),
                _ => {}
            }
        }
        if let Step::Done(status, diagnostic) = step {
            found.extend(diagnostic.map(|d| *d));
            break status;
        }
    };
    println!("{name}: {end:?}, {lines} moves, {arcs} arcs, {} findings", found.len());
    for d in found.iter().take(12) {
        let p = &d.place;
        let text =
            std::str::from_utf8(&bytes).ok().and_then(|t| t.lines().nth(p.line as usize - 1));
        println!(
            "  {} {}:{} {} | {}",
            d.code,
            p.line,
            p.column,
            d.message,
            text.unwrap_or("").trim()
        );
    }
}
