//! The user's variables: global to all files, kept until the software ends.

use crate::syntax::Value;
use kerf_program::ToolTable;
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, HashMap};
use std::sync::Arc;

/// Variables by slot; a slot is found once for each name of each file.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
#[serde(from = "BTreeMap<String, Value>", into = "BTreeMap<String, Value>")]
pub struct Variables {
    // Shared until written, because interpreter states are cloned often.
    names: Arc<Names>,
    values: Arc<Vec<Option<Value>>>,
}

#[derive(Clone, Debug, Default)]
struct Names {
    slots: HashMap<Arc<str>, u32>,
    list: Vec<Arc<str>>,
}

/// Equal when the same names have the same values, whatever their slots.
impl PartialEq for Variables {
    fn eq(&self, other: &Self) -> bool {
        self.list() == other.list()
    }
}

impl Variables {
    /// The slot of a name in capitals, made when needed.
    pub(crate) fn slot(&mut self, name: &str) -> u32 {
        if let Some(slot) = self.names.slots.get(name) {
            return *slot;
        }
        let names = Arc::make_mut(&mut self.names);
        let slot = names.list.len() as u32;
        let shared: Arc<str> = Arc::from(name);
        names.slots.insert(shared.clone(), slot);
        names.list.push(shared);
        slot
    }

    /// The value in a slot.
    pub(crate) fn at(&self, slot: u32) -> Option<&Value> {
        self.values.get(slot as usize)?.as_ref()
    }

    /// Puts a value into a slot.
    pub(crate) fn put(&mut self, slot: u32, value: Value) {
        let values = Arc::make_mut(&mut self.values);
        if values.len() <= slot as usize {
            values.resize(slot as usize + 1, None);
        }
        values[slot as usize] = Some(value.stored());
    }

    /// The value of a variable, by its name without `&`, in any case.
    pub fn get(&self, name: &str) -> Option<&Value> {
        self.at(*self.names.slots.get(name.to_uppercase().as_str())?)
    }

    /// Gives a variable a value.
    pub fn set(&mut self, name: &str, value: Value) {
        let slot = self.slot(&name.to_uppercase());
        self.put(slot, value);
    }

    /// Deletes all (SL).
    pub fn clear(&mut self) {
        self.values = Arc::default();
    }

    /// Returns the number of variables that have a value.
    pub fn count(&self) -> usize {
        self.values.iter().flatten().count()
    }

    /// Names in capitals and values, in order of names.
    pub fn list(&self) -> BTreeMap<String, Value> {
        let named = self.names.list.iter().zip(self.values.iter());
        named.filter_map(|(n, v)| Some((n.to_string(), v.clone()?))).collect()
    }
}

impl From<BTreeMap<String, Value>> for Variables {
    fn from(map: BTreeMap<String, Value>) -> Self {
        let mut variables = Self::default();
        for (name, value) in map {
            variables.set(&name, value);
        }
        variables
    }
}

impl From<Variables> for BTreeMap<String, Value> {
    fn from(variables: Variables) -> Self {
        variables.list()
    }
}

/// What a program keeps in mind by itself.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct Memory {
    pub(crate) variables: Variables,
    /// State of the random sequence.
    pub(crate) random: u64,
    /// Variables made beyond the hundredth were told of.
    pub(crate) told_many_variables: bool,
    /// The tools by their numbers; shared until one changes, because interpreter states are cloned often.
    #[serde(default)]
    pub(crate) tools: Arc<ToolTable>,
}

impl Memory {
    pub(crate) fn new(variables: Variables, random: u64) -> Self {
        Self { variables, random, told_many_variables: false, tools: Arc::default() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_fold_to_capitals_and_survive_saving() {
        let mut v = Variables::default();
        v.set("MyVar", Value::Number(1.0 / 3.0));
        v.set("myvar", Value::text("x"));
        assert_eq!(v.get("MYVAR"), Some(&Value::text("x")));
        assert_eq!(Variables::from(v.list()).list(), v.list());
        v.clear();
        assert_eq!((v.count(), v.get("myvar")), (0, None));
    }

    #[test]
    fn a_clone_is_not_changed_by_the_original() {
        let mut v = Variables::default();
        v.set("a", Value::Number(1.0));
        let kept = v.clone();
        v.set("a", Value::Number(2.0));
        assert_eq!(kept.get("a"), Some(&Value::Number(1.0)));
    }
}
