//! Small pictures of files that were previewed, kept in the data folder for lists of files.

use crate::files::PartFolder;
use kerf_files::{Disk, RealDisk};
use kerf_wire::Problem;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

/// So many are kept; the oldest one goes first.
const MOST: usize = 500;

/// Drawn where there is none.
const NOTHING: &str = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"96\" height=\"96\"/>";

/// Small pictures of files, by their names and the content that they had.
#[derive(Debug)]
pub struct Thumbnails {
    folder: PathBuf,
}

impl Thumbnails {
    /// Those of a data folder.
    pub fn in_data(data: &Path) -> Self {
        // Where the data folder is the part folder no list of files shows it.
        Self { folder: data.join(".thumbnails") }
    }

    /// Keeps the picture of a file as it is now.
    ///
    /// # Errors
    /// Whatever the disk says.
    pub fn keep(&self, parts: &PartFolder, name: &str, picture: &str) -> io::Result<()> {
        let Ok(place) = self.place(parts, name) else { return Ok(()) };
        if place.is_file() {
            return Ok(());
        }
        RealDisk.make_folder(&self.folder)?;
        self.forget_oldest()?;
        RealDisk.write(&place, picture.as_bytes())
    }

    /// The picture of a file as it is now; an empty one where it was not previewed.
    pub fn of(&self, parts: &PartFolder, name: &str) -> Vec<u8> {
        let known = self.place(parts, name).ok().and_then(|place| fs::read(place).ok());
        known.filter(|picture| !picture.is_empty()).unwrap_or_else(|| NOTHING.into())
    }

    fn place(&self, parts: &PartFolder, name: &str) -> Result<PathBuf, Problem> {
        let hash = crate::digested::hash(parts.stamp(name)?.as_bytes());
        Ok(self.folder.join(format!("{}.svg", &hash[..32.min(hash.len())])))
    }

    /// Makes room for one more.
    fn forget_oldest(&self) -> io::Result<()> {
        let kept: Vec<_> =
            fs::read_dir(&self.folder)?.flatten().map(|entry| entry.path()).collect();
        if kept.len() < MOST {
            return Ok(());
        }
        let changed = |path: &PathBuf| {
            let time = fs::metadata(path).and_then(|about| about.modified());
            time.unwrap_or(SystemTime::UNIX_EPOCH)
        };
        kept.iter().min_by_key(|path| changed(path)).map_or(Ok(()), fs::remove_file)
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_is_of_the_content_that_was_previewed() {
        let dir = tempfile::tempdir().unwrap();
        let (parts, kept) =
            (PartFolder::new(dir.path()).unwrap(), Thumbnails::in_data(&dir.path().join("data")));
        parts.write("a.sbp", b"MX,1").unwrap();
        assert_eq!(kept.of(&parts, "a.sbp"), NOTHING.as_bytes());
        kept.keep(&parts, "a.sbp", "<svg/>").unwrap();
        assert_eq!(kept.of(&parts, "a.sbp"), b"<svg/>");
        parts.write("a.sbp", b"MX,12").unwrap();
        assert_eq!(kept.of(&parts, "a.sbp"), NOTHING.as_bytes());
        assert_eq!(kept.of(&parts, "none.sbp"), NOTHING.as_bytes());
    }

    #[test]
    fn the_oldest_picture_makes_room() {
        let dir = tempfile::tempdir().unwrap();
        let (parts, kept) =
            (PartFolder::new(dir.path()).unwrap(), Thumbnails::in_data(&dir.path().join("data")));
        parts.write("a.sbp", b"MX,1").unwrap();
        kept.keep(&parts, "a.sbp", "first").unwrap();
        for n in 1..MOST {
            fs::write(kept.folder.join(format!("{n}")), "x").unwrap();
        }
        parts.write("b.sbp", b"MX,1").unwrap();
        kept.keep(&parts, "b.sbp", "last").unwrap();
        assert_eq!(fs::read_dir(&kept.folder).unwrap().count(), MOST);
        assert_eq!(kept.of(&parts, "b.sbp"), b"last");
    }
}
