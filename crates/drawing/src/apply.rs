//! Operations carried out on a drawing, wholly or not at all.

use crate::op::{OpError, Operation, Outcome, act};
use crate::{Drawing, Editor};
use std::sync::Arc;

impl Editor {
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
