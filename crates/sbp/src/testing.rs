//! A host made of maps, for the tests of this crate.

mod rows;

pub(crate) use rows::{check, check_as, rows};

use crate::{Interpreter, Options, Session, Status, Step, Value, read_as};
use kerf_diag::Diagnostic;
use kerf_program::{
    Answer, Axes, Axis, Command, FileMode, FileRequest, Folder, Host, HostError, Line, MoveKind,
    Question, ShellCall, SourceFile, Sourced, ToolCall, no_such_tool,
};
use std::collections::BTreeMap;
use std::sync::Arc;
use std::task::Poll;

/// A host without a machine: everything given counts as done at once.
#[derive(Debug, Default)]
pub(crate) struct FakeHost {
    pub(crate) inputs: [bool; 13],
    pub(crate) outputs: [bool; 13],
    /// Answers in order; when they run out the default button is pressed.
    pub(crate) answers: Vec<Answer>,
    pub(crate) asked: Vec<Question>,
    /// Part files and user files by name in lower case, `/` as separator.
    pub(crate) files: BTreeMap<String, String>,
    pub(crate) open: BTreeMap<u8, (String, usize)>,
    pub(crate) stored: BTreeMap<String, String>,
    pub(crate) shells: Vec<ShellCall>,
    pub(crate) folder: String,
    /// Number of times that `settle` answers Pending before it is ready.
    pub(crate) busy: u32,
    /// Place of the machine: the end of the last move, or what a test puts here.
    pub(crate) machine: [f64; 6],
    /// Place to which hand controls or an axis moving by itself take the machine.
    pub(crate) strays_to: Option<[f64; 6]>,
    /// Number of times that somebody waited for it to come to rest.
    pub(crate) settles: u32,
    /// The machine is moving: `settle` is not ready.
    pub(crate) moving: bool,
    /// Everything that may wait waits once; `hesitated` says that it did.
    pub(crate) hesitant: bool,
    pub(crate) hesitated: bool,
    /// Letters of virtual tools, and how they were called.
    pub(crate) tools: String,
    pub(crate) called: Vec<String>,
    /// Settings files by name.
    pub(crate) settings: BTreeMap<String, String>,
    pub(crate) log_forgotten: bool,
    /// Firmware that UI loads.
    pub(crate) firmware: Option<&'static str>,
}

impl FakeHost {
    /// True the first time when it is a host that hesitates.
    fn hesitates(&mut self) -> bool {
        self.hesitant && !std::mem::replace(&mut self.hesitated, true)
    }

    /// Does what a real machine does with a command.
    fn carry_out(&mut self, command: &Command) {
        match command {
            Command::Line(line) => self.machine = line.to.0,
            Command::Arc(arc) => self.machine = arc.to.0,
            Command::Output { number, on } => self.outputs[usize::from(*number)] = *on,
            Command::MotorsOff => self.outputs = [false; 13],
            _ => {}
        }
    }
}

fn key(name: &str) -> String {
    name.replace('\\', "/").to_lowercase()
}

impl Host for FakeHost {
    fn settle(&mut self) -> Poll<()> {
        self.settles += 1;
        if self.moving || self.hesitates() {
            return Poll::Pending;
        }
        if self.busy > 0 {
            self.busy -= 1;
            return Poll::Pending;
        }
        Poll::Ready(())
    }
    fn input(&mut self, number: u8) -> bool {
        self.inputs[usize::from(number)]
    }
    fn output(&mut self, number: u8) -> bool {
        self.outputs[usize::from(number)]
    }
    fn ask(&mut self, question: &Question) -> Poll<Answer> {
        if self.hesitates() {
            return Poll::Pending;
        }
        self.asked.push(question.clone());
        if self.answers.is_empty() {
            let button = question.buttons.get(question.default).copied();
            return Poll::Ready(
                button.map_or(Answer::Text(question.prefill.clone()), Answer::Button),
            );
        }
        Poll::Ready(self.answers.remove(0))
    }
    fn source(&mut self, request: &FileRequest) -> Result<SourceFile, HostError> {
        let files = match request.folder {
            Folder::Settings => &self.settings,
            _ => &self.files,
        };
        let text = files
            .get(&key(&request.name))
            .ok_or_else(|| HostError::NotFound(request.name.clone()))?;
        Ok(SourceFile { name: request.name.as_str().into(), bytes: text.as_bytes().into() })
    }
    fn set_part_folder(&mut self, folder: Option<&str>) -> Result<String, HostError> {
        self.folder = folder.unwrap_or("/").to_string();
        Ok(self.folder.clone())
    }
    fn open(&mut self, number: u8, path: &str, mode: FileMode) -> Result<String, HostError> {
        let path = key(path);
        match mode {
            FileMode::Input if !self.files.contains_key(&path) => {
                return Err(HostError::NotFound(path));
            }
            FileMode::Output => drop(self.files.insert(path.clone(), String::new())),
            _ => drop(self.files.entry(path.clone()).or_default()),
        }
        self.open.insert(number, (path.clone(), 0));
        Ok(path)
    }
    fn write(&mut self, number: u8, text: &str) -> Result<(), HostError> {
        let (path, _) = &self.open[&number];
        self.files.entry(path.clone()).or_default().push_str(text);
        Ok(())
    }
    fn read_line(&mut self, number: u8) -> Result<String, HostError> {
        let (path, line) = self.open.get_mut(&number).ok_or(HostError::EndOfFile)?;
        let text = self.files[path].lines().nth(*line).ok_or(HostError::EndOfFile)?;
        *line += 1;
        Ok(text.to_string())
    }
    fn close(&mut self, number: u8) -> Result<(), HostError> {
        self.open.remove(&number);
        Ok(())
    }
    fn stored(&mut self, key: &str) -> Option<String> {
        self.stored.get(key).cloned()
    }
    fn store(&mut self, key: &str, value: Option<&str>) {
        match value {
            Some(v) => drop(self.stored.insert(key.into(), v.into())),
            None => drop(self.stored.remove(key)),
        }
    }
    fn shell(&mut self, call: &ShellCall) -> Poll<Result<(), HostError>> {
        if self.hesitates() {
            return Poll::Pending;
        }
        self.shells.push(call.clone());
        Poll::Ready(Ok(()))
    }
    fn machine_position(&mut self) -> [f64; 6] {
        self.strays_to.unwrap_or(self.machine)
    }
    fn user_path(&mut self) -> String {
        "/user".into()
    }
    fn app_path(&mut self) -> String {
        "/app".into()
    }
    fn firmware(&mut self) -> i32 {
        0
    }
    fn settings_files(&mut self) -> Vec<String> {
        self.settings.keys().cloned().collect()
    }
    fn keep_settings(&mut self, name: &str, text: &str) -> Result<String, HostError> {
        let name = format!("{name}.sbd");
        self.settings.insert(name.clone(), text.into());
        Ok(name)
    }
    fn forget_system_log(&mut self) -> Result<(), HostError> {
        self.log_forgotten = true;
        Ok(())
    }
    fn tool(&mut self, call: &ToolCall) -> Result<Vec<String>, HostError> {
        if !self.tools.contains(call.letter) {
            return Err(HostError::NotFound(no_such_tool(call.letter)));
        }
        self.called.push(format!("{}:{}", call.letter, call.arguments));
        Ok(Vec::new())
    }
    fn install_firmware(&mut self) -> Result<String, HostError> {
        let none = || HostError::Refused("no firmware on the simulated machine".into());
        self.firmware.map(str::to_owned).ok_or_else(none)
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
    /// Lines executed, and motion commands given.
    pub(crate) counts: (u64, u64),
}

/// Runs a program from the fresh state; `⏎` separates lines too.
pub(crate) fn run(text: &str) -> Ran {
    run_with(text, FakeHost::default(), Session::default())
}

/// Runs a program with a host and a session.
pub(crate) fn run_with(text: &str, host: FakeHost, session: Session) -> Ran {
    run_as(text, host, session, Options { max_lines: 100_000, ..Options::default() })
}

/// Runs a program with everything given.
pub(crate) fn run_as(text: &str, host: FakeHost, session: Session, options: Options) -> Ran {
    drive(text, host, session, options, |interpreter, host, out| interpreter.step(host, out))
}

/// Runs a program with everything given; `advance` takes it further each time.
pub(crate) fn drive(
    text: &str,
    mut host: FakeHost,
    session: Session,
    options: Options,
    mut advance: impl FnMut(&mut Interpreter, &mut FakeHost, &mut Vec<Sourced>) -> Step,
) -> Ran {
    let text: String = text.split('⏎').map(str::trim).collect::<Vec<_>>().join("\n");
    let program = read_as(Arc::from("test.sbp"), text.as_bytes(), options.dialect);
    let first_error = program.diagnostics.iter().find(|d| d.is_error()).cloned();
    let mut commands = Vec::new();
    if let Some(error) = first_error {
        let error = Some(Box::new(error));
        return Ran { commands, status: Status::Failed, error, host, session, counts: (0, 0) };
    }
    let mut interpreter = Interpreter::new(program, session, options);
    loop {
        let given = commands.len();
        let step = advance(&mut interpreter, &mut host, &mut commands);
        commands[given..].iter().for_each(|c: &Sourced| host.carry_out(&c.command));
        if let Step::Done(status, error) = step {
            let counts = (interpreter.lines(), interpreter.motions());
            let session = interpreter.into_session();
            return Ran { commands, status, error, host, session, counts };
        }
    }
}

impl Ran {
    /// Returns the place of the tool in the user's units.
    pub(crate) fn location(&self) -> Axes {
        let s = &self.session;
        s.settings.to_user(s.frame.working(s.position))
    }

    /// Checks X, Y, Z within half a thousandth.
    #[track_caller]
    pub(crate) fn ends_at(&self, x: f64, y: f64, z: f64) -> &Self {
        let at = self.location().first3();
        let near = at.iter().zip([x, y, z]).all(|(a, b)| (a - b).abs() < 5e-4);
        assert!(near, "at {at:?}, expected {:?}; {:?}", [x, y, z], self.error);
        self
    }

    /// Checks that the run failed with a message that contains a text.
    #[track_caller]
    pub(crate) fn fails_with(&self, part: &str) -> &Self {
        let message =
            self.error.as_ref().map_or(String::new(), |e| format!("{} {}", e.message, e.hint));
        assert!(
            message.to_lowercase().contains(&part.to_lowercase()),
            "{:?} / {message}",
            self.status
        );
        self
    }

    /// The value of a variable as text.
    pub(crate) fn variable(&self, name: &str) -> String {
        self.session.variables.get(name).map_or("(none)".into(), Value::display)
    }

    /// Straight moves: kind and end in inches of the machine frame.
    pub(crate) fn moves(&self) -> Vec<(MoveKind, [f64; 3])> {
        self.commands
            .iter()
            .filter_map(|c| match &c.command {
                Command::Line(Line { kind, to, .. }) => Some((
                    *kind,
                    [to[Axis::X], to[Axis::Y], to[Axis::Z]].map(|v| (v / 25.4 * 1e6).round() / 1e6),
                )),
                _ => None,
            })
            .collect()
    }

    /// Returns the text that was printed, lines joined by `\n`.
    pub(crate) fn printed(&self) -> String {
        self.commands.iter().fold(String::new(), |mut all, c| {
            if let Command::Print { text, newline } = &c.command {
                all.push_str(text);
                all.push_str(if *newline { "\n" } else { "" });
            }
            all
        })
    }
}
