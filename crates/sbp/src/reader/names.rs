//! Names by number: variables and labels mean the same in any case.

use std::collections::HashMap;
use std::sync::Arc;

/// Names in capitals, numbered in order of appearance.
#[derive(Debug, Default)]
pub(super) struct Names {
    ids: HashMap<Arc<str>, u32>,
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
                self.exact(std::str::from_utf8(short).unwrap_or(name))
            }
            _ => self.exact(&name.to_uppercase()),
        }
    }

    fn exact(&mut self, capitals: &str) -> u32 {
        if let Some(id) = self.ids.get(capitals) {
            return *id;
        }
        let id = self.list.len() as u32;
        let name: Arc<str> = capitals.into();
        self.list.push(name.clone());
        self.ids.insert(name, id);
        id
    }

    /// All names by number.
    pub(super) fn into_list(self) -> Vec<Arc<str>> {
        self.list
    }
}
