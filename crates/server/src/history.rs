//! History of runs and the list of what is to be done, kept in the data folder.

use crate::digested::{checked, with_digest};
use crate::locks::lock;
use crate::refusal::problem;
use kerf_files::{Disk, RealDisk};
use kerf_wire::{Problem, RunRecord, ToDo, Why};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, OnceLock};

/// The most runs that are remembered; the oldest goes first.
const MOST: usize = 2000;

/// So much may be on the list.
const MOST_TO_DO: usize = 200;

/// It lies under this name in the data folder.
const FILE: &str = "runs";

/// Word for the end of a run whose server ended before it.
const CUT_SHORT: &str = "cut short";

/// Runs, and what is to be done.
#[derive(Debug, Default)]
pub struct History {
    kept: Mutex<Kept>,
    /// File in which it is kept; none in a hub of a test.
    file: OnceLock<PathBuf>,
}

#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
struct Kept {
    /// Oldest first.
    runs: Vec<RunRecord>,
    todo: Vec<ToDo>,
    /// The names that files had before, by the names that they have now.
    #[serde(default)]
    renamed: BTreeMap<String, String>,
}

impl History {
    /// Keeps it in a data folder from now on, and knows what is kept there. A run that has no end was cut short.
    ///
    /// # Errors
    /// It cannot be read: nothing is known then.
    pub fn keep_in(&self, data: &Path) -> io::Result<()> {
        let file = self.file.get_or_init(|| data.join(FILE));
        if !file.is_file() {
            return Ok(());
        }
        let known: io::Result<Kept> =
            RealDisk.read(file).and_then(|bytes| Ok(serde_json::from_slice(checked(&bytes)?)?));
        let mut known = known?;
        let open = known.runs.iter_mut().filter(|run| run.ended.is_none());
        open.for_each(|run| run.ended = Some(CUT_SHORT.into()));
        *lock(&self.kept) = known;
        Ok(())
    }

    /// A run begins.
    ///
    /// # Errors
    /// It cannot be written down.
    pub fn begins(&self, run: RunRecord) -> io::Result<()> {
        self.change(|kept| {
            kept.runs.push(run);
            let too_many = kept.runs.len().saturating_sub(MOST);
            kept.runs.drain(..too_many);
        })
    }

    /// A run is over: the one of this file that has no end, or one that began unnoticed. What is to be done counts it
    /// where it came to its end.
    ///
    /// # Errors
    /// It cannot be written down.
    pub fn ends(&self, over: RunRecord) -> io::Result<()> {
        self.change(|kept| {
            if over.ended.as_deref() == Some("ok") {
                let wanted = kept
                    .todo
                    .iter_mut()
                    .find(|todo| todo.file == over.file && todo.made < todo.wanted);
                wanted.into_iter().for_each(|todo| todo.made += 1);
            }
            let mine = |run: &&mut RunRecord| run.ended.is_none() && run.file == over.file;
            match kept.runs.iter_mut().rev().find(mine) {
                Some(run) => *run = RunRecord { begun: run.begun, by: run.by.clone(), ..over },
                None => kept.runs.push(over),
            }
        })
    }

    /// A file has another name: its runs, and what is to be done with it, are those of that name.
    ///
    /// # Errors
    /// It cannot be written down.
    pub fn renamed(&self, from: &str, to: &str) -> io::Result<()> {
        self.change(|kept| {
            let runs = kept.runs.iter_mut().map(|run| &mut run.file);
            let files = runs.chain(kept.todo.iter_mut().map(|todo| &mut todo.file));
            files.filter(|file| *file == from).for_each(|file| *file = to.to_owned());
            kept.renamed.insert(to.to_owned(), from.to_owned());
        })
    }

    /// The name of a file and those that it had before, the newest first.
    pub fn names_of(&self, name: &str) -> Vec<String> {
        let renamed = &lock(&self.kept).renamed;
        let mut names = vec![name.to_owned()];
        while let Some(before) = names.last().and_then(|name| renamed.get(name)) {
            if names.contains(before) {
                break;
            }
            names.push(before.clone());
        }
        names
    }

    /// The runs, the newest first.
    pub fn runs(&self) -> Vec<RunRecord> {
        lock(&self.kept).runs.iter().rev().cloned().collect()
    }

    /// Returns the jobs to do, in order.
    pub fn todo(&self) -> Vec<ToDo> {
        lock(&self.kept).todo.clone()
    }

    /// Something else is to be done.
    ///
    /// # Errors
    /// It is too much, a file is wanted no times, or it cannot be written down.
    pub fn put_todo(&self, todo: Vec<ToDo>) -> Result<(), Problem> {
        if todo.len() > MOST_TO_DO || todo.iter().any(|one| one.wanted == 0 || one.file.is_empty())
        {
            let text =
                format!("the list holds {MOST_TO_DO} files at most, each wanted once at least");
            return Err(problem(Why::Malformed, text));
        }
        let text = |error: io::Error| format!("the list is only known until Kerf ends: {error}");
        self.change(|kept| kept.todo = todo)
            .map_err(|error| problem(crate::files::why(&error), text(error)))
    }

    fn change(&self, change: impl FnOnce(&mut Kept)) -> io::Result<()> {
        let mut kept = lock(&self.kept);
        change(&mut kept);
        let Some(file) = self.file.get() else { return Ok(()) };
        RealDisk.make_folder(file.parent().unwrap_or(Path::new("")))?;
        RealDisk.write(file, &with_digest(&serde_json::to_vec(&*kept)?))
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn run(file: &str, begun: u64, ended: Option<&str>) -> RunRecord {
        let ended = ended.map(str::to_owned);
        RunRecord { file: file.into(), begun, ended, ..RunRecord::default() }
    }

    #[test]
    fn runs_of_a_renamed_file_are_those_of_its_new_name() {
        let history = History::default();
        let todo = ToDo { file: "a".into(), wanted: 2, ..ToDo::default() };
        history.put_todo(vec![todo]).unwrap();
        history.begins(run("a", 5, Some("ok"))).unwrap();
        history.renamed("a", "b").unwrap();
        history.renamed("b", "c").unwrap();
        assert_eq!(history.runs()[0].file, "c");
        assert_eq!(history.todo()[0].file, "c");
        assert_eq!(history.names_of("c"), ["c", "b", "a"]);
        history.renamed("c", "a").unwrap();
        assert_eq!(history.names_of("a"), ["a", "c", "b"]);
    }

    #[test]
    fn a_run_is_there_once_and_counts_for_what_is_to_be_done() {
        let history = History::default();
        let todo = |made| vec![ToDo { file: "a".into(), wanted: 1, made }];
        history.put_todo(todo(0)).unwrap();
        history.begins(RunRecord { by: "phone".into(), ..run("a", 5, None) }).unwrap();
        history.ends(run("a", 9, Some("ok"))).unwrap();
        assert_eq!(history.runs(), [RunRecord { by: "phone".into(), ..run("a", 5, Some("ok")) }]);
        history.ends(run("b", 10, Some("failed"))).unwrap();
        history.ends(run("a", 11, Some("ok"))).unwrap();
        let files: Vec<_> = history.runs().into_iter().map(|run| (run.file, run.begun)).collect();
        assert_eq!(files, [("a".into(), 11), ("b".into(), 10), ("a".into(), 5)]);
        assert_eq!(history.todo(), todo(1));
        assert!(history.put_todo(vec![ToDo { file: "a".into(), ..ToDo::default() }]).is_err());
    }

    #[test]
    fn a_run_without_an_end_was_cut_short() {
        let data = tempfile::tempdir().unwrap();
        let history = History::default();
        history.keep_in(data.path()).unwrap();
        history.begins(run("a", 5, None)).unwrap();
        let again = History::default();
        again.keep_in(data.path()).unwrap();
        assert_eq!(again.runs(), [run("a", 5, Some(CUT_SHORT))]);
        std::fs::write(data.path().join(FILE), "{").unwrap();
        assert!(History::default().keep_in(data.path()).is_err());
    }

    #[test]
    fn the_oldest_run_is_forgotten() {
        let history = History::default();
        (0..=MOST as u64).for_each(|n| history.begins(run("a", n, Some("ok"))).unwrap());
        assert_eq!(history.runs().last().map(|run| run.begun), Some(1));
    }
}
