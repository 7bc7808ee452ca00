//! A drawing being worked on: selection, clipboard, undo.

use crate::op::{OpError, Picks};
use crate::{Drawing, Shape};
use std::sync::Arc;

/// A drawing with what a person working on it needs besides.
///
/// Operations are carried out wholly or not at all. Every change can be undone.
#[derive(Clone, Debug, PartialEq)]
pub struct Editor {
    /// The drawing.
    pub drawing: Drawing,
    /// The shapes that operations act on: places in [`Drawing::shapes`], in order.
    pub selection: Vec<usize>,
    /// Shapes to be pasted.
    pub clipboard: Vec<Arc<Shape>>,
    /// The order that is being picked.
    pub picks: Picks,
    /// Distance within which ends are joined when nothing else is said: that of the last time, millimetres.
    pub join_mm: f64,
    undo: Vec<Past>,
    redo: Vec<Past>,
}

/// State that an undo gives back. Shapes are shared, so a past costs a pointer a shape.
#[derive(Clone, Debug, PartialEq)]
struct Past {
    drawing: Drawing,
    selection: Vec<usize>,
}

impl Default for Editor {
    fn default() -> Self {
        Self {
            drawing: Drawing::default(),
            selection: Vec::new(),
            clipboard: Vec::new(),
            picks: Picks::default(),
            join_mm: kerf_geom::tol::JOIN_MM,
            undo: Vec::new(),
            redo: Vec::new(),
        }
    }
}

impl Editor {
    /// An editor of a drawing, nothing selected.
    pub fn of(drawing: Drawing) -> Self {
        Self { drawing, ..Self::default() }
    }

    /// Takes a draft over. What it changed of the drawing can be undone.
    pub(crate) fn take(&mut self, draft: Self) {
        self.clipboard = draft.clipboard;
        self.join_mm = draft.join_mm;
        if draft.drawing == self.drawing {
            (self.selection, self.picks) = (draft.selection, draft.picks);
            return;
        }
        let drawing = std::mem::replace(&mut self.drawing, draft.drawing);
        let selection = std::mem::replace(&mut self.selection, draft.selection);
        self.undo.push(Past { drawing, selection });
        self.redo.clear();
        // Numbers of shapes mean others now.
        self.picks = Picks::default();
    }

    /// A copy that an operation may change, without what an undo gives back.
    pub(crate) fn clone_without_past(&self) -> Self {
        Self {
            drawing: self.drawing.clone(),
            selection: self.selection.clone(),
            clipboard: self.clipboard.clone(),
            picks: self.picks.clone(),
            join_mm: self.join_mm,
            ..Self::default()
        }
    }

    /// Takes the last change back.
    ///
    /// # Errors
    /// There is none.
    pub fn undo(&mut self) -> Result<(), OpError> {
        let past = self.undo.pop().ok_or(OpError::NoHistory("undo"))?;
        let present = self.exchange(past);
        self.redo.push(present);
        Ok(())
    }

    /// Makes the change again that was last taken back.
    ///
    /// # Errors
    /// There is none.
    pub fn redo(&mut self) -> Result<(), OpError> {
        let past = self.redo.pop().ok_or(OpError::NoHistory("redo"))?;
        let present = self.exchange(past);
        self.undo.push(present);
        Ok(())
    }

    /// Tells whether there is a change to be taken back.
    pub const fn can_undo(&self) -> bool {
        !self.undo.is_empty()
    }

    /// Tells whether there is a change to be made again.
    pub const fn can_redo(&self) -> bool {
        !self.redo.is_empty()
    }

    fn exchange(&mut self, past: Past) -> Past {
        self.picks = Picks::default();
        Past {
            drawing: std::mem::replace(&mut self.drawing, past.drawing),
            selection: std::mem::replace(&mut self.selection, past.selection),
        }
    }

    /// The shape of that number, counted from 1, and its place.
    ///
    /// # Errors
    /// There is no such shape.
    pub(crate) fn shape(&self, number: usize) -> Result<(usize, &Arc<Shape>), OpError> {
        let count = self.drawing.shapes.len();
        let place = number.wrapping_sub(1);
        let shape = self.drawing.shapes.get(place);
        shape.map(|shape| (place, shape)).ok_or(OpError::NoShape { number, count })
    }

    /// The selection.
    ///
    /// # Errors
    /// Nothing is selected.
    pub(crate) fn selected(&self) -> Result<Vec<usize>, OpError> {
        if self.selection.is_empty() {
            return Err(OpError::NothingSelected);
        }
        Ok(self.selection.clone())
    }

    /// Replaces each selected shape by what `change` makes of it.
    ///
    /// # Errors
    /// Nothing is selected, or what `change` says of a shape.
    pub(crate) fn change_selected(
        &mut self,
        mut change: impl FnMut(usize, &Shape) -> Result<Shape, OpError>,
    ) -> Result<(), OpError> {
        for place in self.selected()? {
            let changed = change(place + 1, &self.drawing.shapes[place])?;
            self.drawing.shapes[place] = Arc::new(changed);
        }
        Ok(())
    }

    /// Takes shapes out; the selection goes along with those that stay.
    pub(crate) fn remove(&mut self, gone: &[bool]) {
        let mut left = 0..;
        let new: Vec<Option<usize>> =
            gone.iter().map(|gone| if *gone { None } else { left.next() }).collect();
        self.selection = self.selection.iter().filter_map(|n| new[*n]).collect();
        let mut gone = gone.iter();
        self.drawing.shapes.retain(|_| gone.next() != Some(&true));
    }

    /// Puts other shapes into the place of the shape at a place. The numbers of those after it change,
    /// and so does the selection; the new ones are selected when the old one was.
    pub(crate) fn replace(&mut self, place: usize, with: Vec<Shape>) {
        let more = with.len();
        let was_selected = self.selection.contains(&place);
        let moved = |n: usize| if n > place { n + more - 1 } else { n };
        let others = self.selection.iter().filter(|n| **n != place).map(|n| moved(*n));
        let mut selection: Vec<usize> = others.collect();
        if was_selected {
            selection.extend(place..place + more);
            selection.sort_unstable();
        }
        self.selection = selection;
        self.drawing.shapes.splice(place..=place, with.into_iter().map(Arc::new));
    }

    /// Adds what `make` makes of each selected shape at the end of the sequence, and selects it.
    ///
    /// # Errors
    /// Nothing is selected.
    pub(crate) fn add_from_selected(
        &mut self,
        make: impl Fn(&Shape) -> Shape,
    ) -> Result<(), OpError> {
        let first = self.drawing.shapes.len();
        for place in self.selected()? {
            let made = make(&self.drawing.shapes[place]);
            self.drawing.add(made);
        }
        self.selection = (first..self.drawing.shapes.len()).collect();
        Ok(())
    }
}
