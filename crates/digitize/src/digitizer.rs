//! The list of points and the edits on it.

use crate::{Dimension, Kind, Point, Refusal, Stand};
use serde::{Deserialize, Serialize};

/// Points that are being digitized.
///
/// ```
/// use kerf_digitize::{Digitizer, Stand};
/// let mut points = Digitizer::default();
/// points.append(Stand::new(0.0, 0.0, 0.0))?;
/// points.append(Stand::new(100.0, 0.0, 0.0))?;
/// assert_eq!((points.current(), points.points().len()), (2, 2));
/// let shape = points.shape(false, 0.0)?;
/// assert_eq!(shape.path.length(), 100.0);
/// # Ok::<(), kerf_digitize::Refusal>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Digitizer {
    pub(crate) points: Vec<Point>,
    /// Number of the current point, from 1; 0 without points.
    pub(crate) current: usize,
    pub(crate) dimension: Dimension,
    pub(crate) next: Kind,
    pub(crate) unsaved: bool,
}

impl Digitizer {
    /// The points in order.
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    /// Number of the current point, from 1; 0 without points.
    pub const fn current(&self) -> usize {
        self.current
    }

    /// Tells whether heights count.
    pub const fn dimension(&self) -> Dimension {
        self.dimension
    }

    /// The kind of the next point.
    pub const fn next(&self) -> Kind {
        self.next
    }

    /// Returns `true` if there are points that no shape was saved of as they are.
    pub fn is_unsaved(&self) -> bool {
        self.unsaved && !self.points.is_empty()
    }

    /// A shape was saved of the points as they are.
    pub const fn saved(&mut self) {
        self.unsaved = false;
    }

    /// Lets the next point be of the other kind.
    ///
    /// # Errors
    /// There are no arcs in 3D.
    pub fn toggle(&mut self) -> Result<(), Refusal> {
        if self.dimension == Dimension::Three {
            return Err(Refusal::ArcInSpace);
        }
        self.next = self.next.other();
        Ok(())
    }

    /// Lets heights count, or not. In 3D the next point is one of a line.
    ///
    /// # Errors
    /// There are arc points, and are no arcs in 3D.
    pub fn set_dimension(&mut self, dimension: Dimension) -> Result<(), Refusal> {
        if dimension == Dimension::Three {
            if self.points.iter().any(|point| point.kind == Kind::Arc) {
                return Err(Refusal::ArcInSpace);
            }
            self.next = Kind::Line;
        }
        self.unsaved |= dimension != self.dimension;
        self.dimension = dimension;
        Ok(())
    }

    /// Adds a point behind the last one, which must be the current one.
    ///
    /// # Errors
    /// It is not, or the point would be an arc point behind another.
    pub fn append(&mut self, tool: Stand) -> Result<(), Refusal> {
        if self.current != self.points.len() {
            return Err(Refusal::NotAtEnd);
        }
        self.insert_after(tool)
    }

    /// Adds a point behind the current one; it becomes the current one.
    ///
    /// # Errors
    /// It would be an arc point beside another.
    pub fn insert_after(&mut self, tool: Stand) -> Result<(), Refusal> {
        let place = self.current;
        self.insert(place, tool)
    }

    /// Adds a point before the current one; it becomes the current one.
    ///
    /// # Errors
    /// It would be an arc point beside another.
    pub fn insert_before(&mut self, tool: Stand) -> Result<(), Refusal> {
        self.insert(self.current.saturating_sub(1), tool)
    }

    fn insert(&mut self, place: usize, tool: Stand) -> Result<(), Refusal> {
        let mut points = self.points.clone();
        points.insert(place, Point::new(tool, self.next));
        self.take(points, place + 1)
    }

    /// Takes the current point out; the one behind it becomes current, or else the last one.
    ///
    /// # Errors
    /// There is none, or two arc points would be left beside each other.
    pub fn delete(&mut self) -> Result<(), Refusal> {
        let place = self.place()?;
        let mut points = self.points.clone();
        points.remove(place);
        let current = self.current.min(points.len());
        self.take(points, current)
    }

    /// Puts the current point where the tool stands, of the kind of the next point.
    ///
    /// # Errors
    /// There is none, or it would be an arc point beside another.
    pub fn modify(&mut self, tool: Stand) -> Result<(), Refusal> {
        let place = self.place()?;
        let mut points = self.points.clone();
        points[place] = Point::new(tool, self.next);
        self.take(points, self.current)
    }

    /// Forgets all points; dimension and kind of the next point stay.
    pub fn clear(&mut self) {
        *self = Self { dimension: self.dimension, next: self.next, ..Self::default() };
    }

    /// Number of the point nearest to the tool, the first of those equally near; in 2D whatever their
    /// height.
    ///
    /// # Errors
    /// There are none.
    pub fn nearest(&self, tool: &Stand) -> Result<usize, Refusal> {
        let far = |point: &Point| point.distance(tool, self.dimension);
        let found = self.points.iter().zip(1..).min_by(|(a, _), (b, _)| far(a).total_cmp(&far(b)));
        found.map(|(_, number)| number).ok_or(Refusal::NoPoints)
    }

    /// Returns the place of the current point in the list.
    fn place(&self) -> Result<usize, Refusal> {
        self.current.checked_sub(1).ok_or(Refusal::NoPoints)
    }

    /// Takes points over, if no two arc points of them are neighbours.
    fn take(&mut self, points: Vec<Point>, current: usize) -> Result<(), Refusal> {
        let arcs = |pair: &[Point]| pair.iter().all(|point| point.kind == Kind::Arc);
        if points.windows(2).any(arcs) {
            return Err(Refusal::ArcBesideArc);
        }
        (self.points, self.current, self.unsaved) = (points, current, true);
        Ok(())
    }
}
