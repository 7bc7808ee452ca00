//! A drawing being worked on: selection, clipboard, undo.

use crate::op::{OpError, Operation, Outcome, Picks, act};
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

    /// Carries out an operation.
    ///
    /// # Errors
    /// Why it cannot be; then nothing is changed.
    pub fn apply(&mut self, operation: &Operation) -> Result<Outcome, OpError> {
        let mut draft = self.clone_without_past();
        let outcome = self.carry_out(&mut draft, operation)?;
        self.take(draft);
        Ok(outcome)
    }

    /// Carries out numbered operations as one change: all of them or none, taken back at once.
    ///
    /// # Errors
    /// The number of the one that cannot be, and why.
    pub fn apply_all(
        &mut self,
        operations: &[(usize, Operation)],
    ) -> Result<Vec<Outcome>, (usize, OpError)> {
        let mut draft = self.clone_without_past();
        let mut outcomes = Vec::with_capacity(operations.len());
        for (number, operation) in operations {
            let made = self.carry_out(&mut draft, operation);
            outcomes.push(made.map_err(|error| (*number, error))?);
        }
        self.take(draft);
        Ok(outcomes)
    }

    /// Carries an operation out on a draft, and sees that what it made can be drawn.
    fn carry_out(&self, draft: &mut Self, operation: &Operation) -> Result<Outcome, OpError> {
        let before = draft.drawing.shapes.clone();
        let placed = |error| match error {
            OpError::Shape { shape, at: None, why } => {
                let found = shape.checked_sub(1).and_then(|place| before.get(place));
                OpError::Shape { shape, at: found.and_then(|found| found.path.start()), why }
            }
            other => other,
        };
        let outcome = act(draft, operation).map_err(placed)?;
        if draft.drawing.shapes.len() > before.len() {
            fits(&draft.drawing)?;
        }
        for (place, shape) in draft.drawing.shapes.iter().enumerate() {
            // Shapes that were not touched are the same ones, and were looked at before.
            if before.get(place).is_some_and(|old| Arc::ptr_eq(old, shape)) {
                continue;
            }
            shape.path.check().map_err(|error| OpError::Shape {
                shape: place + 1,
                at: None,
                why: format!("what comes of it is no shape: {error}"),
            })?;
        }
        Ok(outcome)
    }

    /// Takes a draft over. What it changed of the drawing can be undone.
    fn take(&mut self, draft: Self) {
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

    fn clone_without_past(&self) -> Self {
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

/// The most shapes of a drawing to which an operation adds some: copies of copies double without bound.
const MOST_SHAPES: usize = 1_000_000;

/// The most vertices of them.
const MOST_VERTICES: usize = 10_000_000;

/// A drawing that was made larger is refused where it is larger than anybody cuts.
fn fits(drawing: &Drawing) -> Result<(), OpError> {
    let shapes = drawing.shapes.len();
    let vertices: usize = drawing.shapes.iter().map(|shape| shape.path.vertices.len()).sum();
    let bounds = [
        ("the number of shapes of the drawing", shapes, MOST_SHAPES, "a million at the most"),
        (
            "the number of vertices of the drawing",
            vertices,
            MOST_VERTICES,
            "10 million at the most",
        ),
    ];
    match bounds.into_iter().find(|(_, count, most, _)| count > most) {
        Some((what, count, _, bound)) => Err(OpError::Bound { what, value: count as f64, bound }),
        None => Ok(()),
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::script;

    fn after(clauses: &str) -> Result<Editor, String> {
        let mut editor = Editor::default();
        for (_, operation) in script(clauses).map_err(|error| error.to_string())? {
            editor.apply(&operation).map_err(|error| error.to_string())?;
        }
        Ok(editor)
    }

    #[test]
    fn what_no_machine_reaches_is_not_drawn() {
        let told = |clauses: &str| after(clauses).unwrap_err();
        let far = "farther than a million metres from the origin";
        for clauses in [
            "circle 1e308,0 1e308",
            "circle 0,0 5; select all; scale 1e300",
            "circle 0,0 5; select all; move 1e12,0",
            "line 0,0,1e300 5,5",
            "rect 0,0 5,5; select all; array rect 2x2 spacing 1e300,0",
        ] {
            let told = told(clauses);
            assert!(told.starts_with("shape ") && told.contains("vertex"), "{clauses}: {told}");
        }
        assert!(told("point 2e9,0").contains(far), "{}", told("point 2e9,0"));
    }

    #[test]
    fn copies_of_copies_end_at_a_million_shapes() {
        let mut editor = after("rect 0,0 1,1; select all").unwrap();
        let one = editor.drawing.shapes[0].clone();
        editor.drawing.shapes = vec![one; MOST_SHAPES - 1];
        let copy = || Operation::Copy { by: kerf_geom::Vec2::new(9.0, 0.0) };
        editor.apply(&copy()).unwrap();
        let told = editor.apply(&copy()).unwrap_err().to_string();
        let expected =
            "the number of shapes of the drawing is 1000001: it must be a million at the most";
        assert_eq!(told, expected);
    }

    #[test]
    fn a_refusal_names_the_place_of_its_shape() {
        let hole = "rect 0,0 9,9; circle 50.12345,5 2; select 2; offset -3";
        let told = after(hole).unwrap_err();
        assert_eq!(told, "shape 2 at 52.123,5: nothing is left of it at -3 mm");
    }
}
