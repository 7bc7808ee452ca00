//! A host for tests and measurements: every command counts as done at once, and nothing is there.

use crate::{
    AXES, Answer, FileMode, FileRequest, Host, HostError, Question, ShellCall, SourceFile,
};
use std::task::Poll;

/// The part of a host that a test cares about; a type with it is a [`Host`], whose rest does nothing.
///
/// ```
/// use kerf_program::{Host, testing::Bystander};
/// struct Closed;
/// impl Bystander for Closed {
///     fn input(&mut self, number: u8) -> bool {
///         number == 3
///     }
/// }
/// assert!(Host::input(&mut Closed, 3) && !Host::output(&mut Closed, 3));
/// ```
pub trait Bystander {
    /// As [`Host::settle`]: everything was carried out.
    fn settle(&mut self) -> Poll<()> {
        Poll::Ready(())
    }

    /// As [`Host::input`]: off.
    fn input(&mut self, _number: u8) -> bool {
        false
    }

    /// As [`Host::ask`]: the default button, or the text that stands there.
    fn ask(&mut self, question: &Question) -> Poll<Answer> {
        let button = question.buttons.get(question.default).or(question.buttons.first()).copied();
        Poll::Ready(button.map_or_else(|| Answer::Text(question.prefill.clone()), Answer::Button))
    }

    /// As [`Host::source`].
    ///
    /// # Errors
    /// There is no file.
    fn source(&mut self, request: &FileRequest) -> Result<SourceFile, HostError> {
        Err(HostError::NotFound(request.name.clone()))
    }

    /// As [`Host::open`].
    ///
    /// # Errors
    /// There is no file.
    fn open(&mut self, _number: u8, path: &str, _mode: FileMode) -> Result<String, HostError> {
        Err(HostError::NotFound(path.into()))
    }
}

/// A host without anything: it answers at once.
#[derive(Clone, Copy, Debug, Default)]
pub struct Still;

impl Bystander for Still {}

impl<T: Bystander> Host for T {
    fn settle(&mut self) -> Poll<()> {
        Bystander::settle(self)
    }
    fn input(&mut self, number: u8) -> bool {
        Bystander::input(self, number)
    }
    fn output(&mut self, _: u8) -> bool {
        false
    }
    fn ask(&mut self, question: &Question) -> Poll<Answer> {
        Bystander::ask(self, question)
    }
    fn source(&mut self, request: &FileRequest) -> Result<SourceFile, HostError> {
        Bystander::source(self, request)
    }
    fn set_part_folder(&mut self, _: Option<&str>) -> Result<String, HostError> {
        Ok("/".into())
    }
    fn open(&mut self, number: u8, path: &str, mode: FileMode) -> Result<String, HostError> {
        Bystander::open(self, number, path, mode)
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
