//! Small pictures of files that were previewed and of drawings, kept in the data folder for lists of files.

use crate::desk::drawing_in;
use crate::files::PartFolder;
use crate::preview::thumbnail_of;
use kerf_files::{Disk, RealDisk};
use kerf_wire::Problem;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

/// The most pictures that are kept; the oldest goes first.
const MOST: usize = 500;

/// Longest drawing of which a picture is made, bytes: a longer one is read when it is opened.
const LONGEST: u64 = 16 << 20;

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
        if place.is_file() { Ok(()) } else { self.write(&place, picture) }
    }

    fn write(&self, place: &Path, picture: &str) -> io::Result<()> {
        RealDisk.make_folder(&self.folder)?;
        self.forget_oldest()?;
        RealDisk.write(place, picture.as_bytes())
    }

    /// The picture of a file as it is now, where one is kept.
    pub fn kept(&self, parts: &PartFolder, name: &str) -> Option<Vec<u8>> {
        self.place(parts, name).ok().and_then(|place| fs::read(place).ok()).map(shown)
    }

    /// The same; an empty one where none is kept.
    pub fn of(&self, parts: &PartFolder, name: &str) -> Vec<u8> {
        self.kept(parts, name).unwrap_or_else(|| NOTHING.into())
    }

    /// Makes the picture of a drawing as it is now, and keeps it; an empty one of what cannot be read.
    pub fn of_drawing(&self, parts: &PartFolder, name: &str) -> Vec<u8> {
        let Ok(place) = self.place(parts, name) else { return NOTHING.into() };
        let is_short = fs::metadata(parts.root().join(name)).is_ok_and(|it| it.len() <= LONGEST);
        let bytes = parts.read(name).ok().filter(|_| is_short);
        let read = bytes.and_then(|bytes| drawing_in(name, &bytes).ok());
        let picture = read.map(|read| thumbnail_of(&read.drawing)).unwrap_or_default();
        // One that cannot be kept is made anew when it is asked for again.
        _ = self.write(&place, &picture);
        shown(picture.into_bytes())
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

/// A picture as it is shown: an empty one too.
fn shown(picture: Vec<u8>) -> Vec<u8> {
    if picture.is_empty() { NOTHING.into() } else { picture }
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
    fn the_picture_of_a_drawing_is_made_once() {
        let dir = tempfile::tempdir().unwrap();
        let (parts, kept) =
            (PartFolder::new(dir.path()).unwrap(), Thumbnails::in_data(&dir.path().join("data")));
        parts.write("a.plt", b"IN;PU0,0;PD400,0,400,400;PU;").unwrap();
        parts.write("b.rsg", b"no drawing at all").unwrap();
        assert_eq!(kept.kept(&parts, "a.plt"), None);
        let made = kept.of_drawing(&parts, "a.plt");
        assert!(String::from_utf8(made.clone()).unwrap().contains("<path d=\"M"));
        assert_eq!(kept.kept(&parts, "a.plt"), Some(made));
        assert_eq!(kept.of_drawing(&parts, "b.rsg"), NOTHING.as_bytes());
        assert_eq!(kept.kept(&parts, "b.rsg"), Some(NOTHING.into()), "it is not read again");
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
