//! The person at the terminal: answers, Ctrl-C, and the time of the world.

use crate::stop::Stop;
use anyhow::Result;
use kerf_control::answers::{Answers, Operator, changed_input, meaning, words};
use kerf_control::{OperatorRequest, Requests, Script, WorldClock};
use kerf_journal::{Hurry, Press};
use kerf_machine::Driven;
use kerf_machine::driver::Override;
use kerf_program::{Question, QuestionKind};
use kerf_sim::{Opened, Simulated};
use std::cell::Cell;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::thread::{sleep, spawn};
use std::time::{Duration, Instant};

/// Answers from a script, then from a person when there is one.
pub struct Person {
    script: Answers,
    stop: Stop,
    /// Input that somebody types at the terminal.
    keyboard: Option<Keyboard>,
    /// The program that shows files (UN), and the folder they lie in.
    editor: Option<(String, PathBuf)>,
    /// The controller whose inputs are looked at while he is asked.
    machine: Option<Driven>,
}

impl Person {
    /// `present` when somebody sits at a terminal.
    pub fn new(script: Answers, present: bool, terminal: &Terminal) -> Self {
        let stop = terminal.stop.clone();
        let keyboard = present.then(|| Keyboard::new(stop.clone()));
        Self { script, stop, keyboard, editor: None, machine: None }
    }

    /// The same, with a program that shows files below a folder.
    #[must_use]
    pub fn with_editor(mut self, editor: Option<(String, PathBuf)>) -> Self {
        self.editor = editor;
        self
    }

    /// The machine that is driven is a controller: an input that changes is heard while a question is open.
    pub fn follows(&mut self, machine: &Driven) {
        self.machine = Some(machine.clone());
    }

    /// Shows the file of FE until the person closes it.
    fn shows(&self, question: &Question) -> Option<String> {
        let (program, folder) = self.editor.as_ref().filter(|_| self.keyboard.is_some())?;
        let edits = question.kind == QuestionKind::Editor;
        let closed =
            edits.then(|| self.stop.lending_terminal(|| edit(program, folder, &question.text)))?;
        if let Err(error) = closed {
            eprintln!("kerf: cannot start {program}: {error}");
        }
        Some("OK".into())
    }
}

/// Lines typed at a terminal; a thread reads them so that Ctrl-C is noticed meanwhile. It reads only while
/// a line is wanted: at other times what is typed belongs to the editor that FE started.
struct Keyboard {
    wants: Sender<()>,
    lines: Receiver<String>,
    stop: Stop,
    /// A line is wanted that has not come.
    waits: Cell<bool>,
}

impl Keyboard {
    fn new(stop: Stop) -> Self {
        let ((wants, wanted), (typed, lines)) = (channel(), channel());
        spawn(move || {
            let mut keyed = io::stdin().lines().map_while(Result::ok);
            while wanted.recv().is_ok() {
                let sent = keyed.next().map(|line| typed.send(line));
                if !matches!(sent, Some(Ok(()))) {
                    break;
                }
            }
        });
        Self { wants, lines, stop, waits: Cell::new(false) }
    }

    /// The next line, or the input of a controller that changes before; nothing when Kerf is asked to stop or the terminal has gone.
    fn line(&self, machine: Option<&Driven>) -> Option<Typed> {
        if !self.waits.replace(true) {
            // Whoever has gone tells so where the line is waited for.
            let _ = self.wants.send(());
        }
        loop {
            match self.lines.recv_timeout(NAP) {
                Ok(line) => {
                    self.waits.set(false);
                    return Some(Typed::Line(line));
                }
                Err(RecvTimeoutError::Timeout) if !self.stop.is_wanted() && !self.stop.leaves() => {
                    if let Some(press) = machine.and_then(changed_input) {
                        eprintln!();
                        return Some(Typed::Before(press));
                    }
                }
                Err(_) => {
                    eprintln!();
                    return None;
                }
            }
        }
    }

    fn ask(&self, question: &Question, line: u32, machine: Option<&Driven>) -> Option<String> {
        let default = words(&question.default_answer());
        let buttons: Vec<_> = question.buttons.iter().map(|b| b.word()).collect();
        loop {
            let text = shown(question, line);
            eprint!("? {text} [{}] ({default}): ", buttons.join("/"));
            io::stderr().flush().ok()?;
            let line = match self.line(machine)? {
                Typed::Line(line) => line,
                Typed::Before(press) => return Some(press.to_string()),
            };
            let line = line.trim_end_matches('\r');
            if line.is_empty() {
                return Some(default);
            }
            if meaning(question, line).is_some() {
                return Some(line.to_owned());
            }
            let or = match question.kind {
                QuestionKind::Step => ", or the number of a line",
                QuestionKind::Pause | QuestionKind::Msgbox => ", or lift",
                _ => "",
            };
            eprintln!("  answer one of {}{or}", buttons.join(", "));
        }
    }
}

/// Event that ends the wait for a line.
enum Typed {
    Line(String),
    /// An input of the controller changes before.
    Before(Press),
}

/// The text of a question. Of a file that is stepped through the line is shown with its number, and
/// where the last run of it ended.
fn shown(question: &Question, line: u32) -> String {
    let Question { kind, text, title, prefill, .. } = question;
    match (kind, prefill.as_str()) {
        (QuestionKind::Step, "") => format!("{title}:{line}  {text}"),
        (QuestionKind::Step, last) => {
            format!("{title}:{line}  {text}  (last line executed: {last}, answer last)")
        }
        _ => text.clone(),
    }
}

/// Shows a file of a folder in a program, and waits until it is closed.
fn edit(program: &str, folder: &Path, name: &str) -> io::Result<()> {
    let mut command = Command::new(program);
    if !name.is_empty() {
        command.arg(folder.join(name));
    }
    command.status().map(drop)
}

impl Operator for Person {
    fn answer(&mut self, question: &Question, line: u32) -> Option<String> {
        if self.stop.leaves() {
            return None;
        }
        let scripted = self.script.answer(question, line);
        scripted
            .or_else(|| self.shows(question))
            .or_else(|| self.keyboard.as_ref()?.ask(question, line, self.machine.as_ref()))
    }

    fn script_line(&self) -> Option<usize> {
        self.script.script_line()
    }

    fn gives_up(&self) -> bool {
        self.stop.leaves()
    }
}

/// Passing of machine time on the simulated machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Clock {
    /// As fast as can be computed.
    Fast,
    /// A second takes a second.
    Real,
}

/// Length of a nap while machine time passes: so long Ctrl-C may wait.
const NAP: Duration = Duration::from_millis(10);

/// A second of machine time takes a second.
struct RealTime(WorldClock);

impl kerf_sim::Clock for RealTime {
    fn pass(&mut self, from_s: f64, until_s: f64) -> f64 {
        self.0.pass(from_s, until_s, NAP, sleep)
    }

    fn in_real_time(&self) -> bool {
        true
    }

    fn begin_anew(&mut self) {
        self.0.begin_anew();
    }
}

/// Requests from a terminal: Ctrl-C stops the machine, a script says what else the operator does.
pub struct Terminal {
    clock: Clock,
    script: Script,
    stop: Stop,
    /// The machine that is asked for what it waits, where it has controls of its own.
    machine: Option<Driven>,
    waits: Option<&'static str>,
}

impl Terminal {
    /// Listens to Ctrl-C and signals from now on.
    pub fn new(clock: Clock, script: Script) -> Result<Self> {
        let stop = Stop::listen()?;
        stop.instead_of_suspending()?;
        Ok(Self { clock, script, stop, machine: None, waits: None })
    }

    /// The machine that is driven is a controller: time is that of the world, and for what it waits at its own controls is
    /// told.
    pub fn follows(&mut self, machine: &Driven) {
        (self.machine, self.clock) = (Some(machine.clone()), Clock::Real);
    }

    /// Tells for what the machine waits at its own controls, where that is news.
    fn tell_waits(&mut self) {
        let Some(machine) = &self.machine else { return };
        let Ok(mut machine) = machine.try_borrow_mut() else { return };
        let waits = machine.waits();
        if waits != self.waits {
            let news = waits.map_or("it goes on".into(), |why| format!("waiting: {why}"));
            eprintln!("kerf: {}: {news}", machine.name());
            self.waits = waits;
        }
    }

    /// Looks at a held machine; tells whether somebody at its own controls has had it go on.
    fn went_on(&mut self) -> bool {
        let went_on = self.machine.as_ref().is_some_and(|machine| {
            machine.try_borrow_mut().is_ok_and(|mut machine| {
                machine.look();
                machine.went_on()
            })
        });
        self.tell_waits();
        went_on
    }

    /// Returns `true` if Kerf was asked to stop.
    pub fn is_stopped(&self) -> bool {
        self.stop.is_wanted()
    }

    /// Returns the simulated machine in the time that was asked for.
    pub fn simulated(&self) -> Opened {
        match self.clock {
            Clock::Fast => kerf_control::simulated(),
            Clock::Real => Simulated::opened(RealTime(WorldClock::new(1.0))),
        }
    }

    /// Sleeps so long, where a second takes a second; tells whether Kerf was asked to stop.
    fn is_stopped_within(&mut self, seconds: f64) -> bool {
        let begin = Instant::now();
        while self.clock == Clock::Real && !self.is_stopped() && !self.went_on() {
            let left_s = seconds - begin.elapsed().as_secs_f64();
            if left_s <= 0.0 {
                break;
            }
            sleep(NAP.min(Duration::from_secs_f64(left_s.min(1.0))));
        }
        self.is_stopped()
    }
}

impl Requests for Terminal {
    fn take(&mut self, from_s: f64, to_s: f64) -> Option<(f64, OperatorRequest)> {
        self.tell_waits();
        let stop = self.is_stopped().then_some((from_s, OperatorRequest::Stop));
        stop.or_else(|| self.script.take(from_s, to_s))
    }

    fn turned(&mut self, now_s: f64) -> Option<Override> {
        self.script.turned(now_s)
    }

    fn hurry(&self) -> Option<Hurry> {
        let stop = self.stop.clone();
        Some(Hurry::new(move || stop.is_wanted()))
    }

    fn resumes(&mut self, held_s: f64) -> Option<f64> {
        let at_s = self.script.resumes(held_s).filter(|_| !self.stop.leaves())?;
        (!self.is_stopped_within(at_s - held_s)).then_some(at_s)
    }

    fn heard(&mut self) {
        self.stop.hear();
    }
}
