//! The order that is being picked.

use crate::{Drawing, Group};

/// Shapes or groups that have been picked so far, in order. They last until the drawing changes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Picks {
    /// Shapes, as places in the drawing.
    Shapes(Vec<usize>),
    /// Groups.
    Groups(Vec<Group>),
}

impl Default for Picks {
    fn default() -> Self {
        Self::Shapes(Vec::new())
    }
}

impl Picks {
    /// Tells whether nothing is picked.
    pub const fn is_empty(&self) -> bool {
        match self {
            Self::Shapes(places) => places.is_empty(),
            Self::Groups(groups) => groups.is_empty(),
        }
    }

    /// The shapes picked, as places in the drawing, in the new order.
    pub fn shapes(&self, drawing: &Drawing) -> Vec<usize> {
        let of_group = |group: &Group| {
            let group = *group;
            (0..drawing.shapes.len()).filter(move |n| drawing.shapes[*n].group == group)
        };
        match self {
            Self::Shapes(places) => places.clone(),
            Self::Groups(groups) => groups.iter().flat_map(of_group).collect(),
        }
    }
}
