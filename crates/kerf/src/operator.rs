//! The person at the terminal: answers, Ctrl-C, and the time of the world.

use anyhow::{Context, Result};
use kerf_control::answers::{Answers, Operator, default_answer, meaning, words};
use kerf_control::{Pace, Script, Wish};
use kerf_program::{Question, QuestionKind};
use std::cell::Cell;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::sync::{Arc, OnceLock};
use std::thread::{sleep, spawn};
use std::time::{Duration, Instant};

/// Whether Ctrl-C was pressed.
pub type Pressed = Arc<AtomicBool>;

/// Answers from a script, then from a person when there is one.
pub struct Person {
    script: Answers,
    /// What somebody types at the terminal.
    keyboard: Option<Keyboard>,
    /// The program that shows files (UN), and the folder they lie in.
    editor: Option<(String, PathBuf)>,
}

impl Person {
    /// `present` when somebody sits at a terminal.
    pub fn new(script: Answers, present: bool, pace: &RealPace) -> Self {
        let keyboard = present.then(|| Keyboard::new(pace.pressed.clone()));
        Self { script, keyboard, editor: None }
    }

    /// The same, with a program that shows files below a folder.
    #[must_use]
    pub fn with_editor(mut self, editor: Option<(String, PathBuf)>) -> Self {
        self.editor = editor;
        self
    }

    /// Shows the file of FE until the person closes it.
    fn shows(&self, question: &Question) -> Option<String> {
        let (program, folder) = self.editor.as_ref().filter(|_| self.keyboard.is_some())?;
        let edits = question.kind == QuestionKind::Editor;
        let closed = edits.then(|| edit(program, folder, &question.text))?;
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
    pressed: Pressed,
    /// A line is wanted that has not come.
    waits: Cell<bool>,
}

impl Keyboard {
    fn new(pressed: Pressed) -> Self {
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
        Self { wants, lines, pressed, waits: Cell::new(false) }
    }

    /// The next line; nothing when Ctrl-C is pressed or the terminal has gone.
    fn line(&self) -> Option<String> {
        if !self.waits.replace(true) {
            // Whoever has gone tells so where the line is waited for.
            let _ = self.wants.send(());
        }
        loop {
            match self.lines.recv_timeout(NAP) {
                Ok(line) => {
                    self.waits.set(false);
                    return Some(line);
                }
                Err(RecvTimeoutError::Timeout) if !self.pressed.load(Ordering::Relaxed) => {}
                Err(_) => {
                    eprintln!();
                    return None;
                }
            }
        }
    }

    fn ask(&self, question: &Question, line: u32) -> Option<String> {
        let default = words(&default_answer(question));
        let buttons: Vec<_> = question.buttons.iter().map(|b| b.word()).collect();
        loop {
            let text = shown(question, line);
            eprint!("? {text} [{}] ({default}): ", buttons.join("/"));
            io::stderr().flush().ok()?;
            let line = self.line()?;
            let line = line.trim_end_matches('\r');
            if line.is_empty() {
                return Some(default);
            }
            if meaning(question, line).is_some() {
                return Some(line.to_owned());
            }
            let or =
                if question.kind == QuestionKind::Step { ", or the number of a line" } else { "" };
            eprintln!("  answer one of {}{or}", buttons.join(", "));
        }
    }
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
        let scripted = self.script.answer(question, line);
        scripted
            .or_else(|| self.shows(question))
            .or_else(|| self.keyboard.as_ref()?.ask(question, line))
    }
}

/// How machine time passes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Clock {
    /// As fast as can be computed.
    Fast,
    /// A second takes a second.
    Real,
}

/// How long a nap is while machine time passes: what Ctrl-C may wait.
const NAP: Duration = Duration::from_millis(10);

/// Machine time against the time of the world; Ctrl-C stops the machine, the script says what else
/// the operator does.
pub struct RealPace {
    clock: Clock,
    script: Script,
    pressed: Pressed,
    /// The moment of the world at which machine time was last seen, and that machine time.
    seen: Option<(Instant, f64)>,
}

impl RealPace {
    /// Listens to Ctrl-C from now on.
    pub fn new(clock: Clock, script: Script) -> Result<Self> {
        let pressed = listen()?;
        Ok(Self { clock, script, pressed, seen: None })
    }

    /// Whether Ctrl-C was pressed.
    pub fn is_stopped(&self) -> bool {
        self.pressed.load(Ordering::Relaxed)
    }

    /// Sleeps until the moment of the world at which a machine time is reached; earlier, and with
    /// the machine time, when Ctrl-C is pressed.
    fn sleep(&mut self, from_s: f64, to_s: f64) -> Option<f64> {
        if self.clock == Clock::Fast {
            return self.pressed.load(Ordering::Relaxed).then_some(from_s);
        }
        let (since, since_s) = *self.seen.get_or_insert_with(|| (Instant::now(), from_s));
        loop {
            let now_s = since_s + since.elapsed().as_secs_f64();
            if self.pressed.load(Ordering::Relaxed) {
                return Some(now_s.clamp(from_s, to_s));
            }
            let left_s = to_s - now_s;
            if left_s <= 0.0 {
                return None;
            }
            sleep(NAP.min(Duration::from_secs_f64(left_s)));
        }
    }
}

/// Whether Ctrl-C was pressed, from the first time this is asked; a process has one such handler.
pub fn listen() -> Result<Pressed> {
    static PRESSED: OnceLock<Pressed> = OnceLock::new();
    if let Some(pressed) = PRESSED.get() {
        return Ok(pressed.clone());
    }
    let pressed = PRESSED.get_or_init(Pressed::default).clone();
    let flag = pressed.clone();
    ctrlc::set_handler(move || flag.store(true, Ordering::Relaxed))
        .context("cannot listen to Ctrl-C")?;
    Ok(pressed)
}

impl Pace for RealPace {
    fn pass(&mut self, from_s: f64, to_s: f64) -> Option<(f64, Wish)> {
        let wish = self.script.pass(from_s, to_s);
        let end_s = wish.map_or(to_s, |(at_s, _)| at_s);
        let stopped = self.sleep(from_s, end_s).map(|at_s| (at_s, Wish::Stop));
        stopped.or(wish)
    }

    fn is_real(&self) -> bool {
        self.clock == Clock::Real
    }

    fn resumes(&mut self, held_s: f64) -> Option<f64> {
        let at_s = self.script.resumes(held_s)?;
        match self.sleep(held_s, at_s) {
            Some(_) => None,
            None => Some(at_s),
        }
    }

    fn heard(&mut self) {
        self.pressed.store(false, Ordering::Relaxed);
        self.seen = None;
    }
}
