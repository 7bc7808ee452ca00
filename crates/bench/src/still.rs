//! A host for programs that are run without a machine: everything is done at once, nothing is there.

use kerf_program::{
    AXES, Answer, FileMode, FileRequest, Host, HostError, Question, ShellCall, SourceFile,
};
use std::task::Poll;

/// Answers everything at once.
pub struct Still;

fn nothing<T>() -> Result<T, HostError> {
    Err(HostError::NotFound("no files here".into()))
}

impl Host for Still {
    fn settle(&mut self) -> Poll<()> {
        Poll::Ready(())
    }

    fn input(&mut self, _: u8) -> bool {
        false
    }

    fn output(&mut self, _: u8) -> bool {
        false
    }

    fn ask(&mut self, question: &Question) -> Poll<Answer> {
        let button = question.buttons.get(question.default).or(question.buttons.first()).copied();
        Poll::Ready(button.map_or_else(|| Answer::Text(question.prefill.clone()), Answer::Button))
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
