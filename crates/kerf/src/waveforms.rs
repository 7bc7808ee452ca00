//! `--vcd` and `--readings`: the signals of a run in a file.

use crate::streamed::Streamed;
use anyhow::{Context, Result};
use clap::Args;
use kerf_control::Session;
use kerf_journal::Work;
use kerf_machine::Configuration;
use kerf_trace::{Event, Sink, vcd::VcdSink};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

/// Where signals are written.
#[derive(Args, Clone, Debug, Default)]
pub struct VcdArgs {
    /// Writes every output, input, step and pulse width with its time, for GTKWave
    #[arg(long, value_name = "FILE")]
    vcd: Option<PathBuf>,
}

type Signals = VcdSink<BufWriter<Streamed>>;

impl VcdArgs {
    /// The machine whose signals are traced: the one that runs the work.
    pub fn machine(work: &Work, session: &Session) -> Configuration {
        match work {
            Work::Job(_, machine) => (**machine).clone(),
            Work::Part(_) | Work::Hand(..) => session.configuration(),
        }
    }

    /// The file that is named.
    pub fn path(&self) -> Option<&Path> {
        self.vcd.as_deref()
    }

    /// The sink, where a file is named; the data folder keeps the note of it.
    pub fn sink(&self, machine: Configuration, data: Option<&Path>) -> Result<Option<Signals>> {
        let Some(path) = &self.vcd else { return Ok(None) };
        let file = Streamed::create(path, data).with_context(|| self.cannot())?;
        Ok(Some(VcdSink::new(BufWriter::new(file), machine)))
    }

    /// The run is over.
    pub fn finish(&self, signals: Option<Signals>) -> Result<()> {
        let finished = signals.map_or(Ok(()), VcdSink::finish);
        finished.with_context(|| self.cannot())
    }

    fn cannot(&self) -> String {
        let path = self.vcd.as_deref().map(|path| path.display().to_string());
        format!("cannot write {}", path.unwrap_or_default())
    }
}

/// Writes the readings of the height sensor, a byte each.
pub struct ReadingBytes {
    out: Streamed,
    path: PathBuf,
    failed: Option<io::Error>,
}

impl ReadingBytes {
    /// To a file or a device; the data folder keeps the note of it.
    pub fn to(path: &Path, data: Option<&Path>) -> Result<Self> {
        let out = Streamed::create(path, data);
        let out = out.with_context(|| format!("cannot write {}", path.display()))?;
        Ok(Self { out, path: path.into(), failed: None })
    }

    /// The run is over.
    pub fn finish(self) -> Result<()> {
        let finished = self.failed.map_or(Ok(()), Err);
        finished.with_context(|| format!("cannot write {}", self.path.display()))
    }
}

impl Sink for ReadingBytes {
    fn event(&mut self, event: &Event) {
        if let (Event::Height { reading, .. }, None) = (event, &self.failed) {
            self.failed = self.out.write_all(&[*reading]).err();
        }
    }
}
