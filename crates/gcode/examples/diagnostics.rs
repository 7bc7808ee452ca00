//! What reading and running G-code files finds: `cargo run -p kerf-gcode --example diagnostics -- FILE…`.
//!
//! Runs each file without a machine in the dialect of the environment variable `DIALECT` (`linuxcnc`,
//! `grbl` or `generic`), prints every diagnostic, and how many moves and arcs there were.
#![allow(clippy::print_stdout)]

use kerf_gcode::{Dialect, Interpreter, Options, Session, read};
use kerf_program::{
    Answer, Button, Command, FileMode, FileRequest, Host, HostError, Question, ShellCall,
    SourceFile, Step,
};
use std::path::PathBuf;
use std::task::Poll;

/// A host that agrees with everything and reads files beside the program.
struct Quiet(PathBuf);

impl Host for Quiet {
    fn settle(&mut self) -> Poll<()> {
        Poll::Ready(())
    }
    fn input(&mut self, _: u8) -> bool {
        false
    }
    fn output(&mut self, _: u8) -> bool {
        false
    }
    fn ask(&mut self, _: &Question) -> Poll<Answer> {
        Poll::Ready(Answer::Button(Button::OK))
    }
    fn source(&mut self, request: &FileRequest) -> Result<SourceFile, HostError> {
        let bytes = std::fs::read(self.0.join(&request.name));
        let bytes = bytes.map_err(|e| HostError::NotFound(e.to_string()))?;
        Ok(SourceFile { name: request.name.as_str().into(), bytes: bytes.into() })
    }
    fn set_part_folder(&mut self, _: Option<&str>) -> Result<String, HostError> {
        Ok(String::new())
    }
    fn open(&mut self, _: u8, path: &str, _: FileMode) -> Result<String, HostError> {
        Err(HostError::NotAllowed(path.into()))
    }
    fn write(&mut self, _: u8, _: &str) -> Result<(), HostError> {
        Ok(())
    }
    fn read_line(&mut self, _: u8) -> Result<String, HostError> {
        Err(HostError::EndOfFile)
    }
    fn close(&mut self, _: u8) -> Result<(), HostError> {
        Ok(())
    }
    fn stored(&mut self, _: &str) -> Option<String> {
        None
    }
    fn store(&mut self, _: &str, _: Option<&str>) {}
    fn shell(&mut self, _: &ShellCall) -> Poll<Result<(), HostError>> {
        Poll::Ready(Ok(()))
    }
    fn machine_position(&mut self) -> [f64; 6] {
        [0.0; 6]
    }
    fn user_path(&mut self) -> String {
        String::new()
    }
    fn app_path(&mut self) -> String {
        String::new()
    }
    fn firmware(&mut self) -> i32 {
        0
    }
}

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
