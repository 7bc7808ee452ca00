//! Names by number: variables and labels mean the same in any case.

use rustc_hash::FxHashMap;
use std::sync::Arc;

/// Names in capitals, numbered in order of appearance.
#[derive(Debug, Default)]
pub(super) struct Names {
    // By bytes: a name is looked up for each variable of each line, and was text before.
    ids: FxHashMap<Box<[u8]>, u32>,
    list: Vec<Arc<str>>,
}

impl Names {
    /// The number of a name, in any case.
    pub(super) fn id(&mut self, name: &str) -> u32 {
        let mut buffer = [0; 48];
        match buffer.get_mut(..name.len()) {
            Some(short) if name.is_ascii() => {
                short.copy_from_slice(name.as_bytes());
                short.make_ascii_uppercase();
                self.known(short).unwrap_or_else(|| self.add(name))
            }
            _ => self.known(name.to_uppercase().as_bytes()).unwrap_or_else(|| self.add(name)),
        }
    }

    fn known(&self, capitals: &[u8]) -> Option<u32> {
        self.ids.get(capitals).copied()
    }

    fn add(&mut self, name: &str) -> u32 {
        let id = self.list.len() as u32;
        let capitals = name.to_uppercase();
        self.list.push(capitals.as_str().into());
        self.ids.insert(capitals.into_bytes().into(), id);
        id
    }

    /// All names by number.
    pub(super) fn into_list(self) -> Vec<Arc<str>> {
        self.list
    }
}

#[cfg(test)]
mod tests {
    use super::Names;

    #[test]
    fn names_are_the_same_in_any_case() {
        let mut names = Names::default();
        let long = "a".repeat(50);
        let written = ["one", "Größe", "ONE", &long, "GRÖSSE", &long.to_uppercase(), "two"];
        assert_eq!(written.map(|name| names.id(name)), [0, 1, 0, 2, 1, 2, 3]);
        assert_eq!(names.into_list().get(1).map(|name| &**name), Some("GRÖSSE"));
    }
}
