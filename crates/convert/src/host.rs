//! The host of a program that is converted: a machine that does at once what it is told.
//!
//! Inputs are off, questions are answered by whoever stands behind it. Whatever a program learns that
//! way holds for this conversion only, so it is kept and told.

use kerf_program::{
    AXES, Answer, Button, Command, FileMode, FileRequest, Host, HostError, Question, QuestionKind,
    ShellCall, SourceFile,
};
use std::collections::BTreeSet;
use std::task::Poll;

/// Outputs, counted from 1.
const OUTPUTS: usize = 13;

/// Something that a program learnt from the world, or did to it, in one step.
#[derive(Clone, Debug, PartialEq)]
pub enum Seen {
    /// A question and its answer.
    Asked(Question, Answer),
    /// Anything else, as part of a sentence.
    Other(String),
}

/// A machine on paper.
pub struct MachineAtOnce<'a> {
    behind: &'a mut dyn Host,
    outputs: [bool; OUTPUTS],
    position: [f64; AXES],
    /// Things that were seen since they were last taken.
    seen: Vec<Seen>,
    /// Things that are told only once.
    told: BTreeSet<String>,
}

impl<'a> MachineAtOnce<'a> {
    /// A machine whose files and answers come from another host.
    pub fn new(behind: &'a mut dyn Host, position: [f64; AXES]) -> Self {
        let (seen, told) = (Vec::new(), BTreeSet::new());
        Self { behind, outputs: [false; OUTPUTS], position, seen, told }
    }

    /// Does what a machine does with a command.
    pub fn carry_out(&mut self, command: &Command) {
        match command {
            Command::Line(line) => self.position = line.to.0,
            Command::Arc(arc) => self.position = arc.to.0,
            Command::Output { number, on } => {
                if let Some(output) = self.outputs.get_mut(usize::from(*number)) {
                    *output = *on;
                }
            }
            Command::MotorsOff => self.outputs = [false; OUTPUTS],
            _ => {}
        }
    }

    /// Takes what was seen since the last time.
    pub fn take_seen(&mut self) -> Vec<Seen> {
        std::mem::take(&mut self.seen)
    }

    /// Keeps something that was not kept before.
    pub fn see_once(&mut self, what: String) {
        if self.told.insert(what.clone()) {
            self.seen.push(Seen::Other(what));
        }
    }
}

fn of_input(number: u8) -> String {
    format!("input {number}, which was taken as off")
}

impl Host for MachineAtOnce<'_> {
    fn settle(&mut self) -> Poll<()> {
        Poll::Ready(())
    }

    fn input(&mut self, number: u8) -> bool {
        self.see_once(of_input(number));
        false
    }

    fn output(&mut self, number: u8) -> bool {
        self.outputs.get(usize::from(number)).copied().unwrap_or_default()
    }

    fn ask(&mut self, question: &Question) -> Poll<Answer> {
        // A message about the machine itself is no part of the program.
        let machine = matches!(question.kind, QuestionKind::Spindle | QuestionKind::Limit);
        if machine {
            return Poll::Ready(Answer::Button(Button::OK));
        }
        if let Some((input, _)) = question.until {
            // The waiting says all about the input.
            self.seen.retain(|seen| *seen != Seen::Other(of_input(input)));
        }
        let answer = self.behind.ask(question);
        if let Poll::Ready(answer) = &answer {
            self.seen.push(Seen::Asked(question.clone(), answer.clone()));
        }
        answer
    }

    fn source(&mut self, request: &FileRequest) -> Result<SourceFile, HostError> {
        self.behind.source(request)
    }

    fn set_part_folder(&mut self, folder: Option<&str>) -> Result<String, HostError> {
        self.behind.set_part_folder(folder)
    }

    fn set_file_mask(&mut self, mask: &str) {
        self.behind.set_file_mask(mask);
    }

    fn file_mask(&mut self) -> String {
        self.behind.file_mask()
    }

    fn full_path(&mut self, name: &str) -> String {
        self.behind.full_path(name)
    }

    fn open(&mut self, number: u8, path: &str, mode: FileMode) -> Result<String, HostError> {
        self.behind.open(number, path, mode)
    }

    fn write(&mut self, number: u8, text: &str) -> Result<(), HostError> {
        self.behind.write(number, text)
    }

    fn read_line(&mut self, number: u8) -> Result<String, HostError> {
        self.behind.read_line(number)
    }

    fn close(&mut self, number: u8) -> Result<(), HostError> {
        self.behind.close(number)
    }

    fn stored(&mut self, key: &str) -> Option<String> {
        self.behind.stored(key)
    }

    fn store(&mut self, key: &str, value: Option<&str>) {
        let own = [kerf_sbp::SPINDLE_STATUS, kerf_sbp::POSITION_LOST];
        if !own.iter().any(|k| key.starts_with(k)) {
            self.see_once(format!("the value kept as {key}"));
        }
        self.behind.store(key, value);
    }

    fn shell(&mut self, call: &ShellCall) -> Poll<Result<(), HostError>> {
        self.see_once(format!("the program {}", call.line));
        Poll::Ready(Ok(()))
    }

    fn machine_position(&mut self) -> [f64; AXES] {
        self.position
    }

    fn user_path(&mut self) -> String {
        self.behind.user_path()
    }

    fn app_path(&mut self) -> String {
        self.behind.app_path()
    }

    fn is_connected(&mut self) -> bool {
        self.behind.is_connected()
    }

    fn firmware(&mut self) -> i32 {
        self.behind.firmware()
    }
}
