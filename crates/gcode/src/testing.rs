//! A host made of maps, and programs as one line, for the tests of this crate.

#[path = "../../../tests/corpus/find.rs"]
pub(crate) mod find;

use crate::{Interpreter, Options, Program, Session, read};
use kerf_diag::Diagnostic;
use kerf_program::settings::{LinearUnit, SWITCHES};
use kerf_program::testing::Bystander;
use kerf_program::{
    Answer, Axis, Command, FileRequest, HostError, MoveKind, Question, SourceFile, Sourced, Status,
    Step, decimal,
};
use std::collections::BTreeMap;
use std::task::Poll;

/// A host without a machine: everything given counts as done at once.
#[derive(Debug, Default)]
pub(crate) struct FakeHost {
    pub(crate) inputs: [bool; SWITCHES + 1],
    pub(crate) asked: Vec<Question>,
    /// Answers in order; when they run out OK is pressed.
    pub(crate) answers: Vec<Answer>,
    pub(crate) files: BTreeMap<String, String>,
    /// Number of times that `settle` answers Pending before it is ready.
    pub(crate) busy: u32,
}

impl Bystander for FakeHost {
    fn settle(&mut self) -> Poll<()> {
        if self.busy > 0 {
            self.busy -= 1;
            return Poll::Pending;
        }
        Poll::Ready(())
    }
    fn input(&mut self, number: u8) -> bool {
        self.inputs[usize::from(number)]
    }
    fn ask(&mut self, question: &Question) -> Poll<Answer> {
        self.asked.push(question.clone());
        if self.answers.is_empty() {
            return Poll::Ready(Answer::Button(question.buttons[question.default]));
        }
        Poll::Ready(self.answers.remove(0))
    }
    fn source(&mut self, request: &FileRequest) -> Result<SourceFile, HostError> {
        let text = self.files.get(&request.name);
        let text = text.ok_or_else(|| HostError::NotFound(request.name.clone()))?;
        Ok(SourceFile { name: request.name.as_str().into(), bytes: text.as_bytes().into() })
    }
}

/// A run that is over.
#[derive(Debug)]
pub(crate) struct Ran {
    pub(crate) commands: Vec<Sourced>,
    pub(crate) status: Status,
    pub(crate) error: Option<Box<Diagnostic>>,
    pub(crate) host: FakeHost,
    pub(crate) session: Session,
}

/// Reads a program; `⏎` separates lines too.
pub(crate) fn program(text: &str) -> Program {
    let text: String = text.split('⏎').map(str::trim).collect::<Vec<_>>().join("\n");
    read("test.nc".into(), text.as_bytes())
}

/// A session in millimetres with six axes.
pub(crate) fn metric() -> Session {
    let mut session = Session::default();
    session.settings.linear_unit = LinearUnit::Mm;
    session.settings.axis_count = 6;
    session
}

/// Runs a program in millimetres.
pub(crate) fn run(text: &str) -> Ran {
    run_with(text, FakeHost::default(), metric(), Options::default())
}

/// Runs a program with a host, a session and options.
pub(crate) fn run_with(text: &str, mut host: FakeHost, session: Session, options: Options) -> Ran {
    let options = Options { max_lines: 100_000, ..options };
    let mut commands = Vec::new();
    let mut interpreter = Interpreter::new(program(text), session, options);
    loop {
        if let Step::Done(status, error) = interpreter.run(&mut host, &mut commands, 1000) {
            return Ran { commands, status, error, host, session: interpreter.into_session() };
        }
    }
}

fn shown(v: f64) -> String {
    decimal(v, 4)
}

impl Ran {
    /// The motion as text: `J` jog, `L` line, `A` arc, then X Y Z in mm of the machine frame; an arc
    /// with its centre and its sweep in degrees.
    pub(crate) fn path(&self) -> String {
        let places =
            |to: kerf_program::Axes| [Axis::X, Axis::Y, Axis::Z].map(|a| shown(to[a])).join(",");
        let parts: Vec<String> = self
            .commands
            .iter()
            .filter_map(|c| match &c.command {
                Command::Line(l) if l.kind == MoveKind::Jog => Some(format!("J{}", places(l.to))),
                Command::Line(l) => Some(format!("L{}", places(l.to))),
                Command::Arc(a) => Some(format!(
                    "A{}@{},{}:{}",
                    places(a.to),
                    shown(a.centre[0]),
                    shown(a.centre[1]),
                    shown(a.sweep_rad.to_degrees())
                )),
                _ => None,
            })
            .collect();
        parts.join(" ")
    }

    /// Everything but motion, diagnostics and locations, as text.
    pub(crate) fn others(&self) -> String {
        let parts: Vec<String> = self
            .commands
            .iter()
            .filter_map(|c| match &c.command {
                Command::Output { number, on } => Some(format!("out{number}={}", u8::from(*on))),
                Command::Pwm { channel, percent } => Some(format!("pwm{channel}={percent}")),
                Command::Spindle { rpm, .. } => Some(format!("rpm={rpm}")),
                Command::SpindleTurn { turn, .. } => Some(format!("{turn:?}").to_lowercase()),
                Command::Coolant { mist, flood } => Some(format!("mist={mist},flood={flood}")),
                Command::Wait { seconds } => Some(format!("wait={seconds}")),
                Command::Print { text, .. } => Some(format!("print={text}")),
                Command::Message { text } => Some(format!("message={text}")),
                Command::ToolChange { begin } => Some(format!("change={begin}")),
                Command::PathControl(p) => Some(format!("{p:?}")),
                Command::Overrides { feed, spindle } => Some(format!("overrides={feed},{spindle}")),
                _ => None,
            })
            .collect();
        parts.join(" ")
    }

    /// The codes of what was told while running, and of what ended it.
    pub(crate) fn codes(&self) -> String {
        let told = self.commands.iter().filter_map(|c| match &c.command {
            Command::Diagnostic(d) => Some(d.code.as_str()),
            _ => None,
        });
        let parts: Vec<&str> = told.chain(self.error.iter().map(|e| e.code.as_str())).collect();
        parts.join(" ")
    }

    /// The end, mm in the machine frame.
    pub(crate) fn end(&self) -> String {
        self.session.position.first3().map(shown).join(",")
    }
}
