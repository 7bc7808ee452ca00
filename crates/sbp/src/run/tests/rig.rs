//! A program and a machine that moves later than the program is read.

use super::host_with;
use crate::run::Watch;
use crate::testing::FakeHost;
use crate::{Interpreter, Options, Session, Status, Step, Value, read};
use kerf_program::{Axes, Command, Sourced};

/// A program and the machine that carries it out.
pub(super) struct Rig {
    pub(super) interpreter: Interpreter,
    pub(super) host: FakeHost,
    /// Commands that were given and are not dropped.
    pub(super) out: Vec<Sourced>,
    pub(super) done: Option<Status>,
    pub(super) error: String,
}

impl Rig {
    pub(super) fn new(text: &str, files: &[(&str, &str)]) -> Self {
        let text = text.split('⏎').map(str::trim).collect::<Vec<_>>().join("\n");
        let program = read("test.sbp".into(), text.as_bytes());
        assert!(!program.has_errors(), "{:?}", program.diagnostics);
        let options = Options { max_lines: 400, ..Options::default() };
        Self::of(Interpreter::new(program, Session::default(), options), host_with(files))
    }

    pub(super) fn of(interpreter: Interpreter, host: FakeHost) -> Self {
        Self { interpreter, host, out: Vec::new(), done: None, error: String::new() }
    }

    /// One step. The machine moves from the first motion command on.
    pub(super) fn step(&mut self) -> Step {
        let before = self.out.len();
        let step = self.interpreter.step(&mut self.host, &mut self.out);
        self.host.moving |= self.out[before..].iter().any(|c| c.command.is_motion());
        if let Step::Done(status, error) = &step {
            self.done = Some(*status);
            self.error = error.as_ref().map_or(String::new(), |e| e.message.clone());
        }
        step
    }

    /// Reads as far as the language allows while the machine does not come on.
    pub(super) fn read_ahead(&mut self) -> &mut Self {
        while self.done.is_none() && self.step() == Step::Ran {}
        self
    }

    /// The machine carries out everything given.
    pub(super) fn come_to_rest(&mut self) -> &mut Self {
        self.host.moving = false;
        self
    }

    /// An input changes while a motion is under way; the machine stops at a place (inches).
    pub(super) fn fires(
        &mut self,
        input: u8,
        condition: u8,
        motion: u64,
        at: [f64; 3],
    ) -> &mut Self {
        let watch = watch(input, condition);
        assert!(self.interpreter.watches().any(|w| *w == watch), "{watch:?} is not armed");
        let mut count = 0;
        self.out.retain(|c| {
            count += u64::from(c.command.is_motion());
            count <= motion
        });
        self.host.moving = false;
        self.interpreter.interrupt(&watch, Some(motion), place(at));
        self
    }

    /// Runs to the end without further events.
    pub(super) fn finish(&mut self) -> &mut Self {
        for _ in 0..10_000 {
            self.read_ahead().come_to_rest();
            if self.done.is_some() {
                return self;
            }
        }
        panic!("the run does not end");
    }

    #[track_caller]
    pub(super) fn at(&self, x: f64, y: f64, z: f64) -> &Self {
        assert_eq!(self.interpreter.position(), place([x, y, z]), "{}", self.error);
        self
    }

    #[track_caller]
    pub(super) fn variable(&self, name: &str, expected: &str) -> &Self {
        let value = self.interpreter.variables().get(name).map_or("(none)".into(), Value::display);
        assert_eq!(value, expected, "&{name}");
        self
    }

    pub(super) fn printed(&self) -> String {
        let texts = self.out.iter().filter_map(|c| match &c.command {
            Command::Print { text, .. } => Some(text.to_string()),
            _ => None,
        });
        texts.collect::<Vec<_>>().join("|")
    }

    pub(super) fn motion_count(&self) -> usize {
        self.out.iter().filter(|c| c.command.is_motion()).count()
    }
}

pub(super) fn place(inches: [f64; 3]) -> Axes {
    Axes::xyz(inches[0] * 25.4, inches[1] * 25.4, inches[2] * 25.4)
}

pub(super) fn watch(input: u8, condition: u8) -> Watch {
    Watch::change(input, condition % 2 == 1, condition >= 2)
}

pub(super) fn rig(text: &str) -> Rig {
    Rig::new(text, &[])
}
