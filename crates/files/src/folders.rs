//! From names in part files to paths on a disk.
//!
//! Part files come from Windows: any case, `\` or `/`, drives. `C:\SbParts` and `C:\ShopBot\Parts` stand for the part
//! folder, wherever that is; everything else on a drive is looked for in the folders that were allowed besides, each of
//! which may be meant itself (`D:\Jobs\a.sbp` with `/srv/jobs`) or stand for the whole drive.

use crate::Disk;
use kerf_program::{Folder, HostError};
use serde::{Deserialize, Serialize};
use std::path::{Component, Path, PathBuf};

/// Paths of the folder of part files in Windows installations.
const WINDOWS_PARTS: [&[&str]; 2] = [&["sbparts"], &["shopbot", "parts"]];

/// Name of the folder of custom cuts in it.
const CUSTOM: &str = "custom";

/// The folders that programs may name files in.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Folders {
    /// Folder of part files at the start.
    start: PathBuf,
    /// Folder of part files now (FS).
    parts: PathBuf,
    /// Folders of custom cuts, the first that has a file wins.
    custom: Vec<PathBuf>,
    /// Folders allowed besides.
    allowed: Vec<PathBuf>,
}

/// Purpose for which a path is wanted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Purpose {
    /// The file has to be there.
    Read,
    /// Its folder has to be there.
    Write,
    /// The same, but a folder below the part folder may still have to be made.
    Make,
    /// It has to be a folder.
    Enter,
}

impl Folders {
    /// Part files lie in `parts`, custom cuts in `custom`; files may also be in `allowed`.
    pub fn new(parts: PathBuf, custom: Vec<PathBuf>, allowed: Vec<PathBuf>) -> Self {
        Self { start: parts.clone(), parts, custom, allowed }
    }

    /// The same, wherever the process is.
    #[must_use]
    pub fn rooted(&self) -> Self {
        let absolute = |path: &PathBuf| std::path::absolute(path).unwrap_or_else(|_| path.clone());
        let all = |paths: &[PathBuf]| paths.iter().map(absolute).collect();
        Self {
            start: absolute(&self.start),
            parts: absolute(&self.parts),
            custom: all(&self.custom),
            allowed: all(&self.allowed),
        }
    }

    /// The current part folder.
    pub fn parts(&self) -> &Path {
        &self.parts
    }

    /// The folder that custom cuts are written into.
    pub fn custom(&self) -> Option<&Path> {
        self.custom.first().map(PathBuf::as_path)
    }

    /// Changes the current part folder; `None` goes back to the one at the start.
    pub fn enter(&mut self, disk: &dyn Disk, name: Option<&str>) -> Result<(), HostError> {
        self.parts = match name {
            None => self.start.clone(),
            Some(name) => self.find(disk, Folder::Parts, name, Purpose::Enter)?,
        };
        Ok(())
    }

    /// The path that a name stands for.
    pub fn find(
        &self,
        disk: &dyn Disk,
        folder: Folder,
        name: &str,
        purpose: Purpose,
    ) -> Result<PathBuf, HostError> {
        let places = self.places(disk, folder, &clean(name))?;
        let mut refused = None;
        for (base, rest) in &places {
            let path = walk(disk, base, rest);
            if !self.is_allowed(disk, &path) {
                refused = Some(path);
                continue;
            }
            if fits(disk, &path, purpose) {
                return Ok(path);
            }
        }
        if purpose == Purpose::Make
            && let Some(path) = self.to_be_made(disk, &places)
        {
            return Ok(path);
        }
        Err(match (refused, places.first()) {
            (Some(path), _) if path.as_os_str().is_empty() => outside(name.trim()),
            (Some(path), _) => outside(&path.display().to_string()),
            (None, Some((base, _))) => missing(name.trim(), base, purpose),
            (None, None) => outside(name.trim()),
        })
    }

    /// A file whose folder is not there yet, below the part folder.
    fn to_be_made(&self, disk: &dyn Disk, places: &[(PathBuf, String)]) -> Option<PathBuf> {
        let below = |path: &PathBuf| {
            let [real, start] = [path, &self.start].map(|path| disk.real_path(path));
            self.is_allowed(disk, path) && real != start && real.starts_with(start)
        };
        let free = |path: &PathBuf| path.ancestors().all(|above| !disk.is_file(above));
        let paths = places.iter().map(|(base, rest)| walk(disk, base, rest));
        paths.filter(|path| !disk.is_folder(path)).find(|path| below(path) && free(path))
    }

    /// Returns the places where a name may lie: base folders and the rest of the name.
    fn places(
        &self,
        disk: &dyn Disk,
        folder: Folder,
        name: &str,
    ) -> Result<Vec<(PathBuf, String)>, HostError> {
        if let Some(rest) = after_drive(name) {
            return Ok(self.on_drive(disk, rest));
        }
        if name.starts_with('/') {
            return Ok(vec![(PathBuf::from("/"), name.trim_start_matches('/').to_owned())]);
        }
        let bases = match folder {
            // Settings files and sounds are no part of it: whoever has the data folder knows them.
            Folder::Parts | Folder::Settings | Folder::Media => vec![self.parts.clone()],
            Folder::Custom => {
                let inside = walk(disk, &self.start, CUSTOM);
                self.custom.iter().cloned().chain([inside]).collect()
            }
        };
        Ok(bases.into_iter().map(|base| (base, name.to_owned())).collect())
    }

    fn on_drive(&self, disk: &dyn Disk, rest: &str) -> Vec<(PathBuf, String)> {
        let mut places = Vec::new();
        if let Some(inside) = inside_parts(rest) {
            places.push((self.start.clone(), inside.to_owned()));
            let own = disk.is_folder(&walk(disk, &self.start, CUSTOM));
            if let (false, Some(inside)) = (own, strip_folder(inside, CUSTOM)) {
                let custom = self.custom.iter().rev();
                custom.for_each(|folder| places.insert(0, (folder.clone(), inside.to_owned())));
            }
        }
        for folder in &self.allowed {
            places.extend(behind_folder(rest, folder).map(|inside| (folder.clone(), inside)));
            places.push((folder.clone(), rest.to_owned()));
        }
        places
    }

    fn is_allowed(&self, disk: &dyn Disk, path: &Path) -> bool {
        let real = disk.real_path(path);
        let roots = [&self.start].into_iter().chain(&self.custom).chain(&self.allowed);
        let climbs = real.components().any(|c| c == Component::ParentDir);
        roots.into_iter().any(|root| !climbs && real.starts_with(disk.real_path(root)))
    }
}

fn fits(disk: &dyn Disk, path: &Path, purpose: Purpose) -> bool {
    match purpose {
        Purpose::Read => disk.is_file(path),
        Purpose::Enter => disk.is_folder(path),
        Purpose::Write | Purpose::Make => {
            !disk.is_folder(path) && disk.is_folder(path.parent().unwrap_or(Path::new("")))
        }
    }
}

/// The name of a custom cut that is written with the folder it has on Windows.
pub fn custom_name(name: &str) -> Option<String> {
    let name = clean(name);
    let inside = inside_parts(after_drive(&name)?)?;
    strip_folder(inside, CUSTOM).map(str::to_owned)
}

/// Blanks and quotes around a name are no part of it; `\` is `/`.
fn clean(name: &str) -> String {
    name.trim().trim_matches('"').trim().replace('\\', "/")
}

/// Returns what follows a drive, without the first slash.
fn after_drive(name: &str) -> Option<&str> {
    let mut letters = name.chars();
    let drive = letters.next()?.is_ascii_alphabetic() && letters.next()? == ':';
    drive.then(|| letters.as_str().trim_start_matches('/'))
}

/// Returns what follows the folder of part files, as Windows installations call it.
fn inside_parts(path: &str) -> Option<&str> {
    WINDOWS_PARTS.iter().find_map(|folders| {
        folders.iter().try_fold(path, |rest, folder| strip_folder(rest, folder))
    })
}

/// Returns what follows a folder of the same name as this one.
fn behind_folder(path: &str, folder: &Path) -> Option<String> {
    let name = folder.file_name()?.to_str()?;
    let mut parts = path.split('/');
    parts.find(|part| part.eq_ignore_ascii_case(name))?;
    Some(parts.collect::<Vec<_>>().join("/"))
}

/// Returns what follows a first folder of this name, in any case.
fn strip_folder<'a>(path: &'a str, folder: &str) -> Option<&'a str> {
    let (first, rest) = path.split_once('/').unwrap_or((path, ""));
    first.eq_ignore_ascii_case(folder).then_some(rest)
}

/// Follows a name from a folder, ignoring case where there is no exact match.
fn walk(disk: &dyn Disk, base: &Path, name: &str) -> PathBuf {
    let mut path = base.to_owned();
    for part in name.split('/') {
        match part.trim() {
            "" | "." => {}
            ".." => up(disk, &mut path),
            part => step(disk, &mut path, part),
        }
    }
    path
}

fn up(disk: &dyn Disk, path: &mut PathBuf) {
    let named = matches!(path.components().next_back(), Some(Component::Normal(_)));
    if named {
        path.pop();
        return;
    }
    // The folder we are in has no name here: find it out.
    let mut real = disk.real_path(path);
    *path = if real.pop() { real } else { path.join("..") };
}

fn step(disk: &dyn Disk, path: &mut PathBuf, part: &str) {
    let exact = path.join(part);
    if disk.is_file(&exact) || disk.is_folder(&exact) {
        *path = exact;
        return;
    }
    let names = disk.names(path).unwrap_or_default();
    let same = names.iter().find(|name| name.to_lowercase() == part.to_lowercase());
    path.push(same.map_or(part, String::as_str));
}

fn outside(what: &str) -> HostError {
    HostError::NotAllowed(format!(
        "{what} is outside the folders that may be used (--parts, --allow-path)"
    ))
}

fn missing(name: &str, base: &Path, purpose: Purpose) -> HostError {
    let folder = if base.as_os_str().is_empty() { Path::new(".") } else { base }.display();
    HostError::NotFound(match purpose {
        Purpose::Write | Purpose::Make => {
            format!("cannot write {name}: no such folder below {folder}")
        }
        Purpose::Enter => format!("folder {name} not found below {folder}"),
        Purpose::Read => format!("{name} not found in {folder}"),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::MemoryDisk;

    fn disk() -> MemoryDisk {
        let files = [
            "parts/Box.sbp",
            "parts/doors/a.sbp",
            "custom/Custom9.sbc",
            "shop/C/job.txt",
            "secret/key.txt",
        ];
        MemoryDisk::new(files.map(|f| (f, b"x".as_slice())))
    }

    fn folders() -> Folders {
        Folders::new("parts".into(), vec!["custom".into()], vec!["shop".into()])
    }

    #[track_caller]
    fn check(name: &str, purpose: Purpose, expected: Result<&str, &str>) {
        let found = folders().find(&disk(), Folder::Parts, name, purpose);
        match (found, expected) {
            (Ok(path), Ok(expected)) => assert_eq!(path, Path::new(expected), "{name}"),
            (Err(HostError::NotFound(_)), Err("not found")) => {}
            (Err(HostError::NotAllowed(_)), Err("not allowed")) => {}
            (found, expected) => panic!("{name}: {found:?}, expected {expected:?}"),
        }
    }

    #[test]
    fn names_as_part_files_write_them() {
        for name in
            ["Box.sbp", "BOX.SBP", " \"box.sbp\" ", r"doors\..\box.sbp", r"C:\SbParts\Box.SBP"]
        {
            check(name, Purpose::Read, Ok("parts/Box.sbp"));
        }
        check(r"DOORS\A.SBP", Purpose::Read, Ok("parts/doors/a.sbp"));
        check("nothing.sbp", Purpose::Read, Err("not found"));
        check("doors", Purpose::Read, Err("not found"));
        check("doors", Purpose::Enter, Ok("parts/doors"));
        check("c:/sbparts/doors/new.txt", Purpose::Write, Ok("parts/doors/new.txt"));
        check("nowhere/new.txt", Purpose::Write, Err("not found"));
        check(r"C:\ShopBot\Parts\box.sbp", Purpose::Read, Ok("parts/Box.sbp"));
        check(r"C:\SHOPBOT\PARTS", Purpose::Enter, Ok("parts"));
        check(r"C:\ShopBot\box.sbp", Purpose::Read, Err("not found"));
    }

    #[test]
    fn a_folder_below_the_part_folder_may_still_have_to_be_made() {
        check("nowhere/new.txt", Purpose::Make, Ok("parts/nowhere/new.txt"));
        check(r"C:\SbParts\Tools\Now\new.txt", Purpose::Make, Ok("parts/Tools/Now/new.txt"));
        check(r"C:\SbParts\Custom\new.txt", Purpose::Make, Ok("custom/new.txt"));
        let fresh = Folders::new("parts".into(), vec!["none".into()], Vec::new());
        let found = fresh.find(&disk(), Folder::Parts, r"C:\SbParts\Custom\x.txt", Purpose::Make);
        assert_eq!(found.as_deref().ok(), Some(Path::new("parts/Custom/x.txt")));
        check(r"D:\Tools\new.txt", Purpose::Make, Err("not found"));
        check("../elsewhere/new.txt", Purpose::Make, Err("not allowed"));
        check("Box.sbp/new.txt", Purpose::Make, Err("not found"));
        check("doors", Purpose::Make, Err("not found"));
    }

    #[test]
    fn drives_are_looked_for_in_the_allowed_folders() {
        check(r"C:\C\JOB.TXT", Purpose::Read, Ok("shop/C/job.txt"));
        check(r"D:\key.txt", Purpose::Read, Err("not found"));
        check(r"D:\Shop\C\job.txt", Purpose::Read, Ok("shop/C/job.txt"));
        check(r"D:\Work\SHOP\c\job.txt", Purpose::Read, Ok("shop/C/job.txt"));
        let closed = Folders::new("parts".into(), Vec::new(), Vec::new());
        let found = closed.find(&disk(), Folder::Parts, r"C:\a.txt", Purpose::Write);
        assert!(matches!(found, Err(HostError::NotAllowed(_))), "{found:?}");
        check(r"C:\SbParts\Custom\custom9.SBC", Purpose::Read, Ok("custom/Custom9.sbc"));
    }

    #[test]
    fn nothing_leads_out_of_the_allowed_folders() {
        check("../secret/key.txt", Purpose::Read, Err("not allowed"));
        check(r"doors\..\..\secret\key.txt", Purpose::Read, Err("not allowed"));
        check("/secret/key.txt", Purpose::Read, Err("not allowed"));
        check("..", Purpose::Enter, Err("not allowed"));
        check("../../../..", Purpose::Enter, Err("not allowed"));
        check("../shop/C/job.txt", Purpose::Read, Ok("shop/C/job.txt"));
    }

    #[test]
    fn custom_cuts_have_their_own_folder() {
        let found = folders().find(&disk(), Folder::Custom, "custom9.sbc", Purpose::Read);
        assert_eq!(found.as_deref().ok(), Some(Path::new("custom/Custom9.sbc")));
    }

    #[test]
    fn the_part_folder_changes_and_comes_back() {
        let mut f = folders();
        assert!(f.enter(&disk(), Some("DOORS")).is_ok());
        assert_eq!(f.parts(), Path::new("parts/doors"));
        assert!(f.enter(&disk(), Some("..")).is_ok());
        assert_eq!(f.parts(), Path::new("parts"));
        assert!(f.enter(&disk(), Some("none")).is_err() && f.parts() == Path::new("parts"));
        let _ = f.enter(&disk(), Some("doors"));
        assert!(f.enter(&disk(), None).is_ok() && f.parts() == Path::new("parts"));
    }
}
