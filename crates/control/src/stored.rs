//! Values that survive the end of the program: what SetUsrVal, `$name` and the external control
//! keep under a key.

use crate::files::Disk;
use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};

/// Values by key, and the file they are kept in.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Stored {
    values: BTreeMap<String, String>,
    /// `None` keeps them in memory only.
    file: Option<PathBuf>,
    changed: bool,
}

impl Stored {
    /// Values that end with the process.
    pub fn in_memory(values: BTreeMap<String, String>) -> Self {
        Self { values, file: None, changed: false }
    }

    /// Values kept in a file; a missing file is an empty one.
    pub fn read(disk: &dyn Disk, file: &Path) -> io::Result<Self> {
        let values = if disk.is_file(file) {
            serde_json::from_slice(&disk.read(file)?)?
        } else {
            BTreeMap::new()
        };
        Ok(Self { values, file: Some(file.to_owned()), changed: false })
    }

    /// The same values in memory only, for a preview.
    #[must_use]
    pub fn copy(&self) -> Self {
        Self::in_memory(self.values.clone())
    }

    /// The value of a key.
    pub fn get(&self, key: &str) -> Option<&str> {
        self.values.get(key).map(String::as_str)
    }

    /// Gives a key a value; `None` removes it.
    pub fn set(&mut self, key: &str, value: Option<&str>) {
        let before = match value {
            Some(value) => self.values.insert(key.to_owned(), value.to_owned()),
            None => self.values.remove(key),
        };
        self.changed |= before.as_deref() != value;
    }

    /// Keys and values in order.
    pub fn iter(&self) -> impl Iterator<Item = (&str, &str)> {
        self.values.iter().map(|(k, v)| (k.as_str(), v.as_str()))
    }

    /// Puts what changed into the file.
    pub fn save(&mut self, disk: &mut dyn Disk) -> io::Result<()> {
        if let (true, Some(file)) = (self.changed, &self.file) {
            disk.make_folder(file.parent().unwrap_or(Path::new("")))?;
            disk.write(file, &serde_json::to_vec_pretty(&self.values)?)?;
            self.changed = false;
        }
        Ok(())
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::files::MemoryDisk;

    #[test]
    fn values_come_back_and_a_copy_leaves_them_alone() {
        let mut disk = MemoryDisk::default();
        let mut stored = Stored::read(&disk, Path::new("values.json")).unwrap();
        stored.set("uValue", Some("hello"));
        stored.set("gone", Some("x"));
        stored.set("gone", None);
        stored.save(&mut disk).unwrap();
        let mut copy = Stored::read(&disk, Path::new("values.json")).unwrap().copy();
        copy.set("uValue", None);
        copy.save(&mut disk).unwrap();
        let again = Stored::read(&disk, Path::new("values.json")).unwrap();
        assert_eq!(again.iter().collect::<Vec<_>>(), [("uValue", "hello")]);
    }
}
