//! A host whose operator takes time to answer.

use kerf_program::{
    AXES, Answer, FileMode, FileRequest, Host, HostError, Question, ShellCall, SourceFile,
};
use std::task::Poll;

/// Motion is over at once; nobody answers until an answer is there.
#[derive(Default)]
pub struct Patient {
    /// The answer, when the operator has one.
    pub answer: Option<String>,
    /// What was asked, as often as it was.
    pub asked: Vec<String>,
}

fn nothing<T>() -> Result<T, HostError> {
    Err(HostError::NotFound("no files here".into()))
}

impl Host for Patient {
    fn settle(&mut self) -> Poll<()> {
        Poll::Ready(())
    }

    fn ask(&mut self, question: &Question) -> Poll<Answer> {
        self.asked.push(question.text.clone());
        self.answer.take().map_or(Poll::Pending, |text| Poll::Ready(Answer::Text(text)))
    }

    fn input(&mut self, _: u8) -> bool {
        false
    }

    fn output(&mut self, _: u8) -> bool {
        false
    }

    fn source(&mut self, _: &FileRequest) -> Result<SourceFile, HostError> {
        nothing()
    }

    fn set_part_folder(&mut self, _: Option<&str>) -> Result<String, HostError> {
        nothing()
    }

    fn open(&mut self, _: u8, _: &str, _: FileMode) -> Result<String, HostError> {
        nothing()
    }

    fn write(&mut self, _: u8, _: &str) -> Result<(), HostError> {
        nothing()
    }

    fn read_line(&mut self, _: u8) -> Result<String, HostError> {
        nothing()
    }

    fn close(&mut self, _: u8) -> Result<(), HostError> {
        nothing()
    }

    fn stored(&mut self, _: &str) -> Option<String> {
        None
    }

    fn store(&mut self, _: &str, _: Option<&str>) {}

    fn shell(&mut self, _: &ShellCall) -> Poll<Result<(), HostError>> {
        Poll::Ready(nothing())
    }

    fn machine_position(&mut self) -> [f64; AXES] {
        [0.0; AXES]
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
