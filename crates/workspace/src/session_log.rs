//! The lines that a session writes into the system log.

use crate::Workspace;
use crate::system_log::{OWNER, SYSTEM_LOG, SystemLog, clock, mode_word};
use kerf_program::{HostError, Settings};

impl Workspace {
    /// The session begins: so does the log of it, where one is wanted (VD).
    pub fn open_system_log(&mut self, log: SystemLog, settings: &Settings, draws: bool) {
        let line = log.mode(draws);
        self.system_log = Some(log);
        self.log(settings, &line);
    }

    /// Deletes what was logged so far, and begins a new log.
    pub fn begin_system_log_anew(
        &mut self,
        settings: &Settings,
        draws: bool,
    ) -> Result<(), HostError> {
        self.put_data(SYSTEM_LOG, "").map_err(HostError::Refused)?;
        self.log_mode(settings, draws);
        Ok(())
    }

    /// The session is over.
    pub fn close_system_log(&mut self, settings: &Settings, kind: &str) {
        if let Some(log) = self.system_log.take() {
            let line = log.close(kind);
            self.system_log = Some(log);
            self.log(settings, &line);
            self.system_log = None;
        }
    }

    /// From here on the machine only draws, or moves again.
    pub fn log_mode(&mut self, settings: &Settings, draws: bool) {
        if let Some(line) = self.system_log.as_ref().map(|log| log.mode(draws)) {
            self.log(settings, &line);
        }
    }

    /// A part file was run, or refused, and took so many seconds of machine time; an error ended it at
    /// a line.
    pub fn log_file(
        &mut self,
        settings: &Settings,
        file: &str,
        draws: bool,
        seconds: f64,
        error: Option<u32>,
    ) {
        // Typed lines and what comes with Kerf are no files of the user.
        if !self.is_file(file) {
            return;
        }
        let path = self.full_path(file);
        let path = if path.contains(',') { format!("\"{path}\"") } else { path };
        let remark = error.map_or_else(String::new, |line| format!("error in line {line}"));
        self.log_with(
            settings,
            &format!("{path},{},{}", mode_word(draws), clock(seconds)),
            &remark,
        );
    }

    fn log(&mut self, settings: &Settings, head: &str) {
        self.log_with(settings, head, "");
    }

    /// Adds time, date and the tail. A log that cannot be written stops nothing.
    pub fn log_with(&mut self, settings: &Settings, head: &str, remark: &str) {
        let Some(log) = self.system_log.as_ref().filter(|_| settings.display.system_log) else {
            return;
        };
        let owner = OWNER.map(|key| self.stored.get(key).unwrap_or_default().replace(',', " "));
        let line = log.line(head, remark, owner);
        if let Err(error) = self.add_to_data(SYSTEM_LOG, &line) {
            self.stored.tell_trouble(format!("{SYSTEM_LOG}: {error}"));
        }
    }
}
