//! Areas that shapes bound: outer shapes with their holes.

use super::{OpError, spot};
use crate::{Drawing, Kind, Nesting, Shape};
use kerf_geom::{Combine, GeomError, Polyarc, combine, outline};
use kerf_pocket::PocketError;
use std::sync::Arc;

/// An area: an outer contour with its holes, or several where shapes cross.
#[derive(Debug, Default)]
pub(super) struct Region {
    /// Outer ones counter-clockwise, holes clockwise.
    pub contours: Vec<Polyarc>,
    /// The shapes they are or come from, as places in the drawing; then those that lie on one of them.
    pub shapes: Vec<usize>,
}

impl Region {
    /// An error with the number of its shape.
    pub fn told(&self, error: PocketError) -> OpError {
        let contour = match error {
            PocketError::Geometry(GeomError::Crosses { second, .. }) => second,
            PocketError::Open { contour } => contour,
            _ => 0,
        };
        let place = self.shapes.get(contour).or(self.shapes.first());
        let shape = place.map_or(0, |place| place + 1);
        OpError::Shape { shape, at: None, why: error.to_string() }
    }

    /// The same area without crossings and touches.
    pub fn untangled(&self) -> Result<Self, OpError> {
        let parted = self.contours.iter().map(parted);
        let simple = parted.collect::<Result<Vec<_>, _>>().and_then(|all| outline(&all.concat()));
        match simple {
            Ok(contours) => Ok(Self { contours, shapes: self.shapes.clone() }),
            Err(error) => Err(self.told(error.into())),
        }
    }
}

/// The loops of a contour that crosses itself: what it goes round once, but not what it goes round twice.
fn parted(contour: &Polyarc) -> Result<Vec<Polyarc>, GeomError> {
    if contour.crosses_itself().is_none() {
        return Ok(vec![contour.clone()]);
    }
    let loops = combine(std::slice::from_ref(contour), &[], Combine::Union)?;
    let hole = contour.signed_area() < 0.0;
    Ok(loops.into_iter().map(|path| if hole { path.reversed() } else { path }).collect())
}

/// The regions of the chosen shapes, and what a person should know of them.
pub(super) fn regions(
    drawing: &Drawing,
    chosen: &[usize],
) -> Result<(Vec<Region>, Vec<String>), OpError> {
    let (closed, others): (Vec<usize>, Vec<usize>) =
        chosen.iter().partition(|place| bounds_an_area(&drawing.shapes[**place]));
    let left_out = |place: &usize| {
        let at = spot(drawing.shapes[*place].path.start());
        format!("shape {}{at}: only closed flat shapes bound an area; it is left out", place + 1)
    };
    let mut warnings: Vec<String> = others.iter().map(left_out).collect();
    let shape = |place: &usize| drawing.shapes[*place].clone();
    let (closed, doubles) = without_doubles(closed, &shape, &mut warnings);
    let layout = Layout::of(closed.clone(), closed.iter().map(shape).collect())?;
    layout.crossings(&mut warnings);
    let mut regions = layout.regions()?;
    for (first, double) in doubles {
        let region = regions.iter_mut().find(|region| region.shapes.contains(&first));
        region.into_iter().for_each(|region| region.shapes.push(double));
    }
    Ok((regions, warnings))
}

/// A shape drawn twice bounds one area. Those left out come with the one they lie on.
fn without_doubles(
    closed: Vec<usize>,
    shape: &impl Fn(&usize) -> Arc<Shape>,
    warnings: &mut Vec<String>,
) -> (Vec<usize>, Vec<(usize, usize)>) {
    let shapes: Vec<Arc<Shape>> = closed.iter().map(shape).collect();
    let nesting = Nesting::of(&shapes);
    let (mut double, mut pairs) = (vec![false; closed.len()], Vec::new());
    for (first, second) in nesting.same() {
        let (a, b) = (closed[*first] + 1, closed[*second] + 1);
        if !std::mem::replace(&mut double[*second], true) {
            warnings.push(format!("shape {b} lies on shape {a}: it is left out"));
            pairs.push((closed[*first], closed[*second]));
        }
    }
    let kept = closed.into_iter().zip(double).filter(|(_, double)| !double);
    (kept.map(|(place, _)| place).collect(), pairs)
}

fn bounds_an_area(shape: &Shape) -> bool {
    let flat = shape.is_closed() && shape.z_mm.is_none() && shape.kind() == Kind::Polyarc;
    flat && shape.path.signed_area().abs() > NO_AREA_MM2
}

/// Area below which a shape bounds nothing, such as a line drawn to and fro.
const NO_AREA_MM2: f64 = 1e-6;

/// Closed shapes and how they lie to each other.
struct Layout {
    /// Their places in the drawing.
    places: Vec<usize>,
    shapes: Vec<Arc<Shape>>,
    nesting: Nesting,
    crosses_itself: Vec<bool>,
}

impl Layout {
    fn of(places: Vec<usize>, shapes: Vec<Arc<Shape>>) -> Result<Self, OpError> {
        let nesting = Nesting::of(&shapes);
        for (n, shape) in shapes.iter().enumerate() {
            directed(places[n] + 1, shape, nesting.depth(n).is_multiple_of(2))?;
        }
        let crosses_itself = shapes.iter().map(|s| s.path.crosses_itself().is_some()).collect();
        Ok(Self { places, shapes, nesting, crosses_itself })
    }

    /// Tells which shapes cross.
    fn crossings(&self, warnings: &mut Vec<String>) {
        let number = |n: usize| self.places[n] + 1;
        let themselves = (0..self.shapes.len()).filter(|n| self.crosses_itself[*n]);
        warnings.extend(themselves.map(|n| {
            let at = spot(self.shapes[n].path.start());
            format!("shape {}{at} crosses itself", number(n))
        }));
        let others = self.nesting.across().iter().map(|(a, b)| {
            format!(
                "shapes {} and {} cross each other: their areas are one",
                number(*a),
                number(*b)
            )
        });
        warnings.extend(others);
    }

    /// Each outer shape with its holes; those that cross are one region.
    fn regions(&self) -> Result<Vec<Region>, OpError> {
        let outer =
            |n: usize| if self.is_outer(n) { n } else { self.nesting.parent(n).unwrap_or(n) };
        let mut leader: Vec<usize> = (0..self.shapes.len()).map(outer).collect();
        let mut tangled = self.crosses_itself.clone();
        for (a, b) in self.nesting.across() {
            let (a, b) = (leader[*a], leader[*b]);
            leader.iter_mut().filter(|n| **n == a.max(b)).for_each(|n| *n = a.min(b));
            (tangled[a], tangled[b]) = (true, true);
        }
        let mut regions: Vec<(Region, bool)> = Vec::new();
        regions.resize_with(self.shapes.len(), Default::default);
        for (n, leader) in leader.iter().enumerate() {
            let (region, is_tangled) = &mut regions[*leader];
            region.contours.push(self.shapes[n].path.clone());
            region.shapes.push(self.places[n]);
            *is_tangled |= tangled[n];
        }
        let full = regions.into_iter().filter(|(region, _)| !region.shapes.is_empty());
        full.map(|(region, tangled)| if tangled { region.untangled() } else { Ok(region) })
            .collect()
    }

    fn is_outer(&self, n: usize) -> bool {
        self.nesting.depth(n).is_multiple_of(2)
    }
}

fn directed(number: usize, shape: &Shape, outer: bool) -> Result<(), OpError> {
    let counter_clockwise = shape.path.signed_area() > 0.0;
    if counter_clockwise == outer {
        return Ok(());
    }
    let (what, wanted) =
        if outer { ("an outer shape", "counter-clockwise") } else { ("a hole", "clockwise") };
    let why = format!(
        "directions not set: {what} must run {wanted}; use `directions auto` first, or `reverse` where a hole is taken \
         for itself"
    );
    Err(OpError::Shape { shape: number, at: None, why })
}
