//! A drawing: shapes in cutting order, with everything that is kept beside them.

use crate::{Arrays, Group, GroupSettings, Shape};
use kerf_geom::{Bounds2, Vec2};
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use thiserror::Error;

/// Lines of comment a drawing may have.
pub const MAX_COMMENTS: usize = 10;
/// Characters a line of comment may have.
pub const MAX_COMMENT_LENGTH: usize = 50;

/// A comment that does not fit.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum CommentError {
    /// Too many lines.
    #[error("{0} lines of comment: a drawing keeps 10 at the most")]
    Lines(usize),
    /// A line is too long.
    #[error("line {line} of the comment has {length} characters: 50 at the most")]
    Length {
        /// Which line, counted from 1.
        line: usize,
        /// Its characters.
        length: usize,
    },
}

/// Shapes in cutting order, the settings of the groups, arrays, comments.
///
/// Shapes are shared: a copy of a drawing costs a pointer a shape, so that undo can keep them all.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Drawing {
    /// The shapes in the order in which they are cut. Shape `n` of the user is `shapes[n - 1]`.
    pub shapes: Vec<Arc<Shape>>,
    /// Settings by which the shapes of each group are cut, in the order of [`Group::ALL`].
    pub groups: [GroupSettings; 8],
    /// Both levels of arrays.
    pub arrays: Arrays,
    /// Displacement of the drawing since it was read (Left Justify, Change Origin), so that its
    /// own origin can be given back.
    pub moved: Vec2,
    /// A person set the order of the shapes: it is not changed when they are cut.
    #[serde(default)]
    pub ordered_by_hand: bool,
    comments: Vec<String>,
}

impl Drawing {
    /// A drawing of these shapes.
    pub fn of(shapes: impl IntoIterator<Item = Shape>) -> Self {
        Self { shapes: shapes.into_iter().map(Arc::new).collect(), ..Self::default() }
    }

    /// Other shapes with the settings, arrays and comments of this drawing.
    #[must_use]
    pub fn with_shapes(&self, shapes: Vec<Arc<Shape>>) -> Self {
        Self { shapes, comments: self.comments.clone(), ..*self }
    }

    /// Settings of a group.
    pub fn settings(&self, group: Group) -> &GroupSettings {
        &self.groups[group.index()]
    }

    /// Settings of a group, to be changed.
    pub fn settings_mut(&mut self, group: Group) -> &mut GroupSettings {
        &mut self.groups[group.index()]
    }

    /// Puts a shape at the end of the sequence.
    pub fn add(&mut self, shape: Shape) {
        self.shapes.push(Arc::new(shape));
    }

    /// Bounds of all shapes with arcs counted exactly; nothing for a drawing without shapes.
    pub fn bounds(&self) -> Option<Bounds2> {
        bounds_of(self.shapes.iter().map(Arc::as_ref))
    }

    /// The comments.
    pub fn comments(&self) -> &[String] {
        &self.comments
    }

    /// Changes the comments.
    ///
    /// # Errors
    /// Too many lines, or one too long; then nothing is changed.
    pub fn set_comments(&mut self, comments: Vec<String>) -> Result<(), CommentError> {
        if comments.len() > MAX_COMMENTS {
            return Err(CommentError::Lines(comments.len()));
        }
        let long = |line: &String| line.chars().count() > MAX_COMMENT_LENGTH;
        if let Some(at) = comments.iter().position(long) {
            let length = comments[at].chars().count();
            return Err(CommentError::Length { line: at + 1, length });
        }
        self.comments = comments;
        Ok(())
    }
}

/// Bounds of some shapes; nothing for none.
pub fn bounds_of<'a>(shapes: impl IntoIterator<Item = &'a Shape>) -> Option<Bounds2> {
    let mut bounds = Bounds2::default();
    shapes.into_iter().for_each(|shape| bounds.merge(&shape.path.bounds()));
    (!bounds.is_empty()).then_some(bounds)
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn pro_files_comments_limit() {
        let mut drawing = Drawing::default();
        drawing.set_comments(vec!["x".repeat(50); 10]).unwrap();
        let told = drawing.set_comments(vec![String::new(); 11]).unwrap_err().to_string();
        assert_eq!(told, "11 lines of comment: a drawing keeps 10 at the most");
        let told = drawing.set_comments(vec![String::new(), "ä".repeat(51)]).unwrap_err();
        assert_eq!(told.to_string(), "line 2 of the comment has 51 characters: 50 at the most");
        assert_eq!(drawing.comments().len(), 10);
    }

    #[test]
    fn pro_group_default() {
        let shape = Shape::point(kerf_geom::Point2::new(1.0, 2.0));
        assert_eq!(shape.group, Group::Black);
        assert!(Drawing::of([shape]).groups.iter().all(|group| group.on));
    }
}
