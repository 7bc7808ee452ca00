//! What a program asks, answered by the world it runs in.

use crate::conversion;
use crate::world::World;
use kerf_program::{
    AXES, Answer, FileConversion, FileMode, FileRequest, Host, HostError, Question, ShellCall,
    SourceFile,
};
use std::task::Poll;

/// Version number that `%(49)` reads: the simulated machine has no firmware.
const FIRMWARE: i32 = 0;

impl Host for World<'_> {
    fn settle(&mut self) -> Poll<()> {
        if std::mem::take(&mut self.settled) { Poll::Ready(()) } else { Poll::Pending }
    }

    fn input(&mut self, number: u8) -> bool {
        self.machine.input(number)
    }

    fn output(&mut self, number: u8) -> bool {
        self.machine.outputs().is_on(number)
    }

    fn ask(&mut self, question: &Question) -> Poll<Answer> {
        if let Some(answer) = self.answer.take() {
            return Poll::Ready(answer);
        }
        self.question = Some(question.clone());
        Poll::Pending
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

    fn last_line(&mut self, file: &str) -> Option<u32> {
        self.shelf.last_line(file)
    }

    fn stored(&mut self, key: &str) -> Option<String> {
        self.shelf.stored.get(key).map(str::to_owned)
    }

    fn store(&mut self, key: &str, value: Option<&str>) {
        self.shelf.stored.set(key, value);
    }

    fn convert(
        &mut self,
        name: &str,
        kind: Option<&str>,
        overwrite: bool,
    ) -> Result<FileConversion, HostError> {
        let settings = self.machine.settings().clone();
        conversion::convert(self.shelf, &settings, name, kind, overwrite)
    }

    fn shell(&mut self, call: &ShellCall) -> Poll<Result<(), HostError>> {
        Poll::Ready(self.shelf.shell(call))
    }

    fn machine_position(&mut self) -> [f64; AXES] {
        self.machine.true_position().0
    }

    fn user_path(&mut self) -> String {
        self.shelf.user_path()
    }

    fn app_path(&mut self) -> String {
        self.shelf.app_path()
    }

    fn firmware(&mut self) -> i32 {
        FIRMWARE
    }
}
