//! The layers that shapes come from, in the order of the file.

use std::collections::BTreeMap;

/// Layers by name, each with its shapes as places in the drawing.
#[derive(Debug, Default)]
pub struct Layers {
    /// In the order of the file.
    pub list: Vec<(String, Vec<usize>)>,
    places: BTreeMap<Vec<u8>, usize>,
}

impl Layers {
    /// Adds a shape to the layer of a name, which is as the file has it.
    pub fn add(&mut self, name: &[u8], shape: usize, shown: impl FnOnce() -> String) {
        if let Some(place) = self.places.get(name) {
            return self.list[*place].1.push(shape);
        }
        self.places.insert(name.to_owned(), self.list.len());
        self.list.push((shown(), vec![shape]));
    }
}
