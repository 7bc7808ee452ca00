//! Work of a run, as it is kept: the text of a part file, or a job with the machine whose
//! sequence it takes.

use super::contents::hash;
use super::{JournalError, Work};
use kerf_machine::file;
use kerf_program::Settings;
use kerf_program::job::Job;
use kerf_sbp::Dialect;
use serde::{Deserialize, Serialize};
use std::borrow::Cow;
use std::sync::Arc;

/// Format in which bytes are read back.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum WorkKind {
    /// A part file.
    Part(Dialect),
    /// A job.
    Job,
}

/// Something to run and everything that decides it, as bytes.
#[derive(Debug)]
pub struct KeptWork<'a> {
    /// Name shown to people.
    pub name: String,
    /// Format of the bytes.
    pub kind: WorkKind,
    /// The bytes.
    pub bytes: Cow<'a, [u8]>,
}

/// A job as it is kept.
#[derive(Serialize, Deserialize)]
struct KeptJob {
    job: Job,
    /// The machine, as its file would be written.
    machine: String,
    /// Its settings of motion, as options of the run have changed them.
    program: Settings,
}

impl<'a> KeptWork<'a> {
    /// Turns work into what is kept of it.
    ///
    /// # Errors
    /// A job holds what cannot be written.
    pub fn of(work: &'a Work) -> Result<Self, JournalError> {
        let (kind, bytes) = match work {
            Work::Part(program) => {
                let part = &program.sbp;
                (WorkKind::Part(part.dialect), Cow::Borrowed(part.text.as_bytes()))
            }
            Work::Job(job, machine) => {
                let kept = KeptJob {
                    job: (**job).clone(),
                    machine: file::write(machine),
                    program: machine.program.clone(),
                };
                let bytes = serde_json::to_vec(&kept);
                let bytes = bytes.map_err(|error| JournalError::Unfit(error.to_string()))?;
                (WorkKind::Job, bytes.into())
            }
            // A move by hand is told anew.
            Work::Hand(..) => {
                return Err(JournalError::Unfit("moves by hand are not taken up".into()));
            }
        };
        Ok(Self { name: work.name().to_string(), kind, bytes })
    }

    /// The hash of the bytes.
    pub(super) fn hash(&self) -> String {
        hash(&self.bytes)
    }
}

/// Reads back the work of which this is kept.
pub(super) fn read_back(kind: WorkKind, name: &str, bytes: &[u8]) -> Result<Work, JournalError> {
    match kind {
        WorkKind::Part(dialect) => Ok(kerf_part::read_as(name.into(), bytes, dialect).into()),
        WorkKind::Job => job(bytes).map_err(JournalError::Unfit),
    }
}

fn job(bytes: &[u8]) -> Result<Work, String> {
    let kept: KeptJob = serde_json::from_slice(bytes).map_err(|error| error.to_string())?;
    let mut machine = file::read_back(&kept.machine).map_err(|error| error.message)?;
    machine.program = kept.program;
    Ok(Work::Job(Arc::new(kept.job), Arc::new(machine)))
}
