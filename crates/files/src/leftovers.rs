//! Files that a writer left half written: it was killed before it could put them in their place.

use std::fs::{self, DirEntry, File};
use std::path::Path;
use std::process;
use std::time::{Duration, SystemTime};

/// End of the name of a file that is not in its place yet; it begins with [`prefix`].
pub(crate) const SUFFIX: &str = ".tmp";

const OURS: &str = ".kerf-";

/// A file that was written to so lately is left alone.
const LATELY: Duration = Duration::from_secs(60);

/// Folders are looked into down to this depth.
const DEPTH: usize = 4;

/// Begins the name of a file that is not in its place yet: with the number of the process.
pub(crate) fn prefix() -> String {
    format!("{OURS}{}-", process::id())
}

/// Removes what killed writers left in a folder and below it, and gives the number of files. What somebody writes at
/// this moment stays, and so does whatever is not Kerf's.
pub fn sweep(folder: &Path) -> usize {
    sweep_to(folder, DEPTH)
}

fn sweep_to(folder: &Path, depth: usize) -> usize {
    // A folder that cannot be read is told by whoever needs it.
    let Ok(entries) = fs::read_dir(folder) else { return 0 };
    let in_it = |entry: DirEntry| match entry.file_type() {
        Ok(kind) if kind.is_dir() && depth > 1 => sweep_to(&entry.path(), depth - 1),
        Ok(kind) if kind.is_file() && is_left(&entry) => {
            usize::from(fs::remove_file(entry.path()).is_ok())
        }
        _ => 0,
    };
    entries.filter_map(Result::ok).map(in_it).sum()
}

fn is_left(entry: &DirEntry) -> bool {
    let name = entry.file_name();
    let ours = name.to_str().and_then(|name| name.strip_prefix(OURS)?.strip_suffix(SUFFIX));
    let numbered = |rest: &str| {
        rest.split_once('-').is_some_and(|(process, _)| process.parse::<u32>().is_ok())
    };
    ours.is_some_and(numbered) && is_old(entry) && nobody_writes(&entry.path())
}

/// A clock that was put back makes files of the future: they are as old as they are young.
fn is_old(entry: &DirEntry) -> bool {
    let Ok(written) = entry.metadata().and_then(|file| file.modified()) else { return false };
    let now = SystemTime::now();
    let apart = now.duration_since(written).or_else(|_| written.duration_since(now));
    apart.is_ok_and(|apart| apart > LATELY)
}

fn nobody_writes(path: &Path) -> bool {
    File::open(path).is_ok_and(|file| file.try_lock().is_ok())
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn only_old_files_of_killed_writers_are_swept() {
        let folder = tempfile::tempdir().unwrap();
        let file = |name: &str, age_s: u64| {
            let path = folder.path().join(name);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            let file = File::create(&path).unwrap();
            file.set_modified(SystemTime::now() - Duration::from_secs(age_s)).unwrap();
            file
        };
        let left = ["a/.kerf-7-x1Y2z3.tmp", ".kerf-12-abcdef.tmp"];
        left.iter().for_each(|name| drop(file(name, 100)));
        let stays =
            [".kerf-7-young.tmp", ".kerf-x-abcdef.tmp", ".tmpAbCdEf", "part.sbp", ".kerf-7.tmp"];
        stays
            .iter()
            .for_each(|name| drop(file(name, if name.contains("young") { 1 } else { 100 })));
        let held = file(".kerf-9-abcdef.tmp", 100);
        held.try_lock().unwrap();
        assert_eq!(sweep(folder.path()), left.len());
        assert!(left.iter().all(|name| !folder.path().join(name).exists()));
        assert!(stays.iter().all(|name| folder.path().join(name).exists()));
        drop(held);
        assert_eq!(sweep(folder.path()), 1, "who wrote it has ended");
    }
}
