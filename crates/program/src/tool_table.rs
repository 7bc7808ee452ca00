//! The tools of a machine by their numbers, as G-code counts them (`T2`) and C9 does (`&Tool`).

use crate::{Axes, Axis, decimal};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::sync::Arc;

/// A tool of the tool table.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Tool {
    /// Its name as its owner calls it, as "end mill"; nothing where it has none.
    #[serde(default)]
    pub name: Option<Arc<str>>,
    /// Cutter diameter, mm.
    pub diameter_mm: f64,
    /// Its offset, mm: Z is its length.
    pub offset: Axes,
    /// Its length is the height, Z of the table base, at which its tip touched the sensor for tools. Z zero
    /// goes with such a length when the tool is changed; the others are for G43.
    #[serde(default)]
    pub measured: bool,
}

impl Tool {
    /// Returns its length at the sensor for tools, mm of the table base; nothing where it was not measured there.
    pub fn touch_mm(&self) -> Option<f64> {
        self.measured.then_some(self.offset[Axis::Z])
    }

    /// Keeps the height at which it touched the sensor, mm of the table base.
    pub fn touched(&mut self, z_mm: f64) {
        (self.offset[Axis::Z], self.measured) = (z_mm, true);
    }

    /// Returns the words for it beside its number: `6 mm end mill`, `6 mm`, `end mill`; nothing where nothing is known.
    pub fn words(&self) -> String {
        let size = (self.diameter_mm > 0.0).then(|| format!("{} mm", decimal(self.diameter_mm, 3)));
        let told = [size.as_deref(), self.name.as_deref()];
        told.into_iter().flatten().collect::<Vec<_>>().join(" ")
    }
}

/// All tools that are known, and the one in the spindle.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ToolTable {
    /// The tools by their numbers.
    pub tools: BTreeMap<u32, Tool>,
    /// Number of the one in the spindle; 0 for none that is known.
    pub in_spindle: u32,
}

impl ToolTable {
    /// Returns the words by which the operator is asked for a tool: `2 (6 mm end mill)`.
    pub fn asked_for(&self, number: u32) -> String {
        match self.tools.get(&number).map(Tool::words).filter(|words| !words.is_empty()) {
            Some(words) => format!("{number} ({words})"),
            None => number.to_string(),
        }
    }

    /// Returns the length of a tool at the sensor for tools, mm of the table base.
    pub fn touch_mm(&self, number: u32) -> Option<f64> {
        self.tools.get(&number)?.touch_mm()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(diameter_mm: f64, name: Option<&str>, asked: &str) {
        let tool = Tool { diameter_mm, name: name.map(Arc::from), ..Tool::default() };
        let table = ToolTable { tools: BTreeMap::from([(2, tool)]), in_spindle: 0 };
        assert_eq!(table.asked_for(2), asked);
    }

    #[test]
    fn a_tool_is_asked_for_by_number_size_and_name() {
        check(6.0, Some("end mill"), "2 (6 mm end mill)");
        check(3.175, None, "2 (3.175 mm)");
        check(0.0, Some("V-bit"), "2 (V-bit)");
        check(0.0, None, "2");
        assert_eq!(ToolTable::default().asked_for(7), "7");
    }

    #[test]
    fn only_a_length_of_the_sensor_moves_z_zero() {
        let mut table = ToolTable::default();
        table.tools.insert(1, Tool { offset: Axes::xyz(0.0, 0.0, 40.0), ..Tool::default() });
        assert_eq!(table.touch_mm(1), None);
        table.tools.entry(1).or_default().touched(-31.5);
        assert_eq!((table.touch_mm(1), table.touch_mm(2)), (Some(-31.5), None));
    }
}
