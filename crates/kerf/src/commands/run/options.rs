//! The options of everything that moves a machine.

use crate::args::RunArgs;
use crate::controller::{Beginning, First};
use crate::data_args::DataArgs;
use crate::exit::Usage;
use crate::outputs::{ForceArgs, Outputs};
use crate::waveforms::VcdArgs;
use anyhow::{Result, bail};
use clap::{Args, ValueEnum};
use std::path::{Path, PathBuf};

/// The name of standard output where a file is asked for.
pub(super) const STANDARD_OUTPUT: &str = "-";

/// What everything that moves a machine can be told.
#[derive(Args, Clone)]
pub struct MachineArgs {
    #[command(flatten)]
    pub first: First,
    /// How machine time passes
    #[arg(long, value_enum, default_value = "fast")]
    pub(super) pace: PaceName,
    /// Draws the tool path as it was run: .svg, .png or .html
    #[arg(long, value_name = "OUT")]
    pub(super) picture: Option<PathBuf>,
    /// Writes everything that the run does to a file, an event a line, as `kerf trace` prints it; with `-` to
    /// standard output, and nothing else there
    #[arg(long, value_name = "OUT")]
    pub(super) trace: Option<PathBuf>,
    /// Writes every reading of the height sensor to a file or a device, a byte each, as a potentiometer sends
    /// them on its serial line
    #[arg(long, value_name = "FILE")]
    pub(super) readings: Option<PathBuf>,
    #[command(flatten)]
    pub(super) vcd: VcdArgs,
    /// Writes what is sent to the controller and what it answers into a file, a line each, with its time and what
    /// numbers of errors and alarms mean
    #[arg(long, value_name = "FILE")]
    pub(super) controller_log: Option<PathBuf>,
    /// The password of the settings, where they are protected [default: KERF_PASSWORD]: what the program
    /// sets stays
    #[arg(long, value_name = "WORD")]
    pub password: Option<String>,
    /// No progress, no summary
    #[arg(short, long)]
    pub(super) quiet: bool,
    #[command(flatten)]
    pub(super) force: ForceArgs,
}

/// How machine time passes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum PaceName {
    /// As fast as can be computed.
    Fast,
    /// A second of machine time takes a second.
    Real,
}

impl MachineArgs {
    /// The files that the run writes besides those of the program.
    pub fn outputs(&self, data: &DataArgs) -> Outputs {
        let files = self.written().into_iter().filter_map(|(_, file)| file);
        Outputs::of(files, self.force.force, Some(data))
    }

    /// Files are replaced without a question.
    pub fn replaces(&self) -> bool {
        self.force.force
    }

    /// Every option that names a file to be written.
    fn written(&self) -> [(&'static str, Option<&Path>); 5] {
        [
            ("--controller-log", self.controller_log.as_deref()),
            ("--trace", self.trace.as_deref().filter(|_| !self.traces_out())),
            ("--picture", self.picture.as_deref()),
            ("--readings", self.readings.as_deref()),
            ("--vcd", self.vcd.path()),
        ]
    }

    /// Steps with which the controller is begun.
    pub fn beginning(&self) -> Beginning<'_> {
        Beginning { first: self.first, quiet: self.quiet(), log: self.controller_log.as_deref() }
    }

    /// No summary is wanted.
    pub fn quiet(&self) -> bool {
        self.quiet || self.traces_out()
    }

    /// Refuses to write over what is run, or what the run reads.
    pub(super) fn spare(&self, file: &Path, run: &RunArgs) -> Result<()> {
        let written = self.written();
        let read = [
            Some(file),
            run.answers.as_deref(),
            run.script.as_deref(),
            run.place.machine.configuration(),
        ];
        let whole: Vec<PathBuf> =
            read.into_iter().flatten().filter_map(|path| path.canonicalize().ok()).collect();
        for (option, path) in written {
            let there = path.and_then(|path| path.canonicalize().ok());
            if let Some(there) = there.filter(|there| whole.contains(there)) {
                let name = there.display();
                bail!(Usage(format!(
                    "{option} would write over {name}, which the run reads: name another file"
                )));
            }
        }
        Ok(())
    }

    /// Standard output belongs to the trace.
    pub(super) fn traces_out(&self) -> bool {
        self.trace.as_deref() == Some(Path::new(STANDARD_OUTPUT))
    }

    /// Refuses options of a controller where none is named.
    pub fn check(&self, run: &RunArgs) -> Result<()> {
        let log = self.controller_log.as_ref().map(|_| "--controller-log");
        match self.first.option().or(log) {
            Some(option) if run.place.machine.controller().is_none() => bail!(Usage(format!(
                "{option} is for a controller: name it with --machine grbl:PORT"
            ))),
            _ => Ok(()),
        }
    }
}
