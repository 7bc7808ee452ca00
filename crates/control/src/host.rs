//! Questions of a program, answered by the world it runs in.

use crate::world::World;
use kerf_program::settings::LinearUnit;
use kerf_program::{
    AXES, Answer, ConversionRequest, FileConversion, Host, HostError, Question, ToolCall,
};
use std::task::Poll;

/// Version number that `%(49)` reads: the simulated machine has no firmware.
const FIRMWARE: i32 = 0;

/// Name of the file of UD in the data folder.
const PROBLEM_LOG: &str = "problem.log";

impl Host for World<'_> {
    fn settle(&mut self) -> Poll<()> {
        if std::mem::take(&mut self.settled) { Poll::Ready(()) } else { Poll::Pending }
    }

    fn input(&mut self, number: u8) -> bool {
        self.model.input(number)
    }

    fn output(&mut self, number: u8) -> bool {
        self.model.outputs().is_on(number)
    }

    fn ask(&mut self, question: &Question) -> Poll<Answer> {
        if let Some(answer) = self.answer.take() {
            return Poll::Ready(answer);
        }
        self.question = Some(question.clone());
        Poll::Pending
    }

    kerf_workspace::answered_by_the_workspace!();

    fn last_line(&mut self, file: &str) -> Option<u32> {
        self.workspace.last_line(file)
    }

    fn convert(&mut self, request: &ConversionRequest) -> Result<FileConversion, HostError> {
        let settings = self.model.settings().clone();
        kerf_import::convert(self.workspace, &settings, request)
    }

    fn machine_position(&mut self) -> [f64; AXES] {
        self.model.true_position().0
    }

    fn keep_problem_log(&mut self, text: &str) -> Result<(), HostError> {
        if self.previews {
            return Ok(());
        }
        self.workspace.add_to_data(PROBLEM_LOG, text).map_err(HostError::Refused)
    }

    fn forget_system_log(&mut self) -> Result<(), HostError> {
        if self.previews {
            return Ok(());
        }
        let settings = self.model.settings().clone();
        self.workspace.begin_system_log_anew(&settings, self.model.draws())
    }

    fn tool(&mut self, call: &ToolCall) -> Result<Vec<String>, HostError> {
        let metric = self.model.settings().linear_unit == LinearUnit::Mm;
        kerf_workspace::virtual_tools::start(self.workspace, call, metric)
    }

    fn is_connected(&mut self) -> bool {
        self.model.is_connected()
    }

    fn install_firmware(&mut self) -> Result<String, HostError> {
        self.workspace.install_firmware()
    }

    fn firmware(&mut self) -> i32 {
        FIRMWARE
    }
}
