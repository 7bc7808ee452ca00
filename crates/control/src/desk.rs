//! A program's files and answers without a machine.
//!
//! Whoever follows a program on paper, to convert it, has no machine that takes time: everything given
//! counts as done, inputs are off. Files and questions are as in a run.

use crate::answers::{self, Operator};
use crate::shelf::Shelf;
use kerf_program::{
    AXES, Answer, FileMode, FileRequest, Host, HostError, Question, ShellCall, SourceFile,
};
use std::task::Poll;

/// Files and answers.
pub struct Desk<'a> {
    shelf: &'a mut Shelf,
    operator: &'a mut dyn Operator,
}

impl<'a> Desk<'a> {
    /// A desk with these; the shelf has to be one for previews.
    pub fn new(shelf: &'a mut Shelf, operator: &'a mut dyn Operator) -> Self {
        Self { shelf, operator }
    }
}

impl Host for Desk<'_> {
    fn settle(&mut self) -> Poll<()> {
        Poll::Ready(())
    }

    fn input(&mut self, _: u8) -> bool {
        false
    }

    fn output(&mut self, _: u8) -> bool {
        false
    }

    /// An answer that the box does not have counts as none.
    fn ask(&mut self, question: &Question) -> Poll<Answer> {
        let given = self.operator.answer(question, 0);
        let meant = given.and_then(|words| answers::meaning(question, &words));
        Poll::Ready(meant.unwrap_or_else(|| answers::default_answer(question)))
    }

    fn source(&mut self, request: &FileRequest) -> Result<SourceFile, HostError> {
        self.shelf.source(request)
    }

    fn set_part_folder(&mut self, folder: Option<&str>) -> Result<String, HostError> {
        self.shelf.enter(folder)
    }

    fn set_file_mask(&mut self, mask: &str) {
        self.shelf.set_mask(Some(mask));
    }

    fn file_mask(&mut self) -> String {
        self.shelf.mask().to_owned()
    }

    fn full_path(&mut self, name: &str) -> String {
        self.shelf.full_path(name)
    }

    fn open(&mut self, number: u8, path: &str, mode: FileMode) -> Result<String, HostError> {
        self.shelf.open(number, path, mode)
    }

    fn write(&mut self, number: u8, text: &str) -> Result<(), HostError> {
        self.shelf.write(number, text)
    }

    fn read_line(&mut self, number: u8) -> Result<String, HostError> {
        self.shelf.read_line(number)
    }

    fn close(&mut self, number: u8) -> Result<(), HostError> {
        self.shelf.close(number)
    }

    fn stored(&mut self, key: &str) -> Option<String> {
        self.shelf.stored.get(key).map(str::to_owned)
    }

    fn store(&mut self, key: &str, value: Option<&str>) {
        self.shelf.stored.set(key, value);
    }

    fn shell(&mut self, call: &ShellCall) -> Poll<Result<(), HostError>> {
        Poll::Ready(self.shelf.shell(call))
    }

    fn machine_position(&mut self) -> [f64; AXES] {
        [0.0; AXES]
    }

    fn user_path(&mut self) -> String {
        self.shelf.user_path()
    }

    fn app_path(&mut self) -> String {
        self.shelf.app_path()
    }

    fn firmware(&mut self) -> i32 {
        0
    }
}
