//! From one shape, smoothed already, to the paths that cut it: the order of the Profiler reference is
//! offset, tag, lead-in and lead-out.

use crate::lead::{Side, lead_in, lead_out, with_leads};
use crate::tag::without_tag;
use crate::warning::Warning;
use kerf_drawing::{GroupSettings, Kind, Shape, spot};
use kerf_geom::{Coarse, GeomError, Offsetter, Point2, Polyarc, parallel_path};
use serde::{Deserialize, Serialize};

/// Which cut of a shape a path is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Pass {
    /// The first one, which leaves some material.
    Rough,
    /// The one that gives the part its size.
    #[default]
    Final,
    /// No cut: the head only follows it.
    Traversal,
}

/// A path of a shape.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ShapePath {
    pub pass: Pass,
    pub path: Polyarc,
    pub z_mm: Option<Vec<f64>>,
    /// The offset it was made with.
    pub offset_mm: f64,
    /// Its leads, for those who ask whether they cut into something.
    pub leads: Vec<(&'static str, Polyarc)>,
}

/// The paths of a shape, in cutting order; the offsetter is that of the whole job.
pub(crate) fn paths(
    number: usize,
    shape: &Shape,
    settings: &GroupSettings,
    offsetter: &Offsetter,
    warnings: &mut Vec<Warning>,
) -> Vec<ShapePath> {
    if settings.traversal || shape.kind() == Kind::Point {
        let pass = if settings.traversal { Pass::Traversal } else { Pass::Final };
        return vec![plain(shape, pass)];
    }
    let mut paths = Vec::new();
    let passes = passes(settings);
    let has_offset = passes.iter().any(|(_, distance)| *distance != 0.0);
    let crossing = has_offset.then(|| shape.path.crosses_itself()).flatten().map(|it| it.first.at);
    for side in sides(shape, settings) {
        for &(pass, distance) in &passes {
            match offset_paths(shape, side * distance, crossing.is_some(), offsetter) {
                Ok((found, coarse)) => {
                    warnings.extend(coarse.map(|coarse| Warning::new(number, coarse.to_string())));
                    if found.is_empty() {
                        warnings.push(gone(number, side * distance));
                    }
                    let leads = |base| with_tag_and_leads(number, base, pass, settings, warnings);
                    paths.extend(found.into_iter().filter_map(leads));
                }
                Err(error) => warnings.push(failed(number, &error)),
            }
        }
    }
    // Where there is no path it was told already why.
    let doubtful = crossing.filter(|_| !paths.is_empty());
    warnings.extend(doubtful.map(|at| crosses_itself(number, at)));
    paths
}

/// The caution that a shape with loops always gets (Profiler reference, "Offsets of Shapes with Self Loops").
fn crosses_itself(number: usize, at: Point2) -> Warning {
    let place = spot(Some(at));
    let text = format!(
        "it crosses itself{place}: look at its offset before it is cut, it may not be what is meant"
    );
    Warning::new(number, text)
}

fn plain(shape: &Shape, pass: Pass) -> ShapePath {
    let (path, z_mm) = (shape.path.clone(), shape.z_mm.clone());
    ShapePath { pass, path, z_mm, offset_mm: 0.0, leads: Vec::new() }
}

/// 1 for the side of the offset, −1 for the other one. A double line is cut on both, of a closed
/// shape the inner one first.
fn sides(shape: &Shape, settings: &GroupSettings) -> Vec<f64> {
    if !settings.double_line || settings.offset_mm == 0.0 {
        return vec![1.0];
    }
    // Right of travel is outside when travel is counter-clockwise.
    let outward = settings.offset_mm * shape.path.signed_area();
    if shape.is_closed() && outward > 0.0 { vec![-1.0, 1.0] } else { vec![1.0, -1.0] }
}

fn passes(settings: &GroupSettings) -> Vec<(Pass, f64)> {
    let rough = settings.rough_offset_mm().map(|distance| (Pass::Rough, distance));
    rough.into_iter().chain([(Pass::Final, settings.offset_mm)]).collect()
}

fn gone(number: usize, distance: f64) -> Warning {
    let text = format!("too small for an offset of {} mm: no path", distance.abs());
    Warning::new(number, text)
}

fn failed(number: usize, error: &GeomError) -> Warning {
    let why = match error {
        GeomError::Crosses { at, .. } => format!("it crosses itself{}", spot(Some(*at))),
        other => other.to_string(),
    };
    Warning::new(number, format!("offset failed: {why}: no path"))
}

/// A path beside a shape, with heights, before tag and leads.
struct Base {
    path: Polyarc,
    z_mm: Option<Vec<f64>>,
    offset_mm: f64,
}

fn offset_paths(
    shape: &Shape,
    distance: f64,
    crosses: bool,
    offsetter: &Offsetter,
) -> Result<(Vec<Base>, Option<Coarse>), GeomError> {
    if distance == 0.0 {
        let base = Base { path: shape.path.clone(), z_mm: shape.z_mm.clone(), offset_mm: 0.0 };
        return Ok((vec![base], None));
    }
    let (found, coarse) = if crosses && !shape.is_closed() && shape.z_mm.is_none() {
        (vec![parallel_path(&shape.path, distance)?], None)
    } else {
        let found = offsetter.offset(&shape.path, distance)?;
        let coarse = Coarse::of(&found);
        (found.into_iter().map(|found| found.path).collect(), coarse)
    };
    let base = |path: Polyarc| {
        let z_mm = shape.z_mm.as_ref().map(|_| heights_beside(shape, &path));
        Base { path, z_mm, offset_mm: distance }
    };
    Ok((found.into_iter().map(base).collect(), coarse))
}

/// The height of each vertex: that of the nearest place of the shape (readings, P-45).
fn heights_beside(shape: &Shape, path: &Polyarc) -> Vec<f64> {
    let nearest = |at| shape.path.nearest(at).map_or(0.0, |(place, _)| shape.height_at(&place));
    path.vertices.iter().map(|vertex| nearest(vertex.at)).collect()
}

fn with_tag_and_leads(
    number: usize,
    base: Base,
    pass: Pass,
    settings: &GroupSettings,
    warnings: &mut Vec<Warning>,
) -> Option<ShapePath> {
    let Some(path) = without_tag(&base.path, settings.tag_mm) else {
        let (tag, long) = (settings.tag_mm, base.path.length());
        let text = format!("the tag of {tag} mm is longer than its path of {long:.3} mm: no path");
        warnings.push(Warning::new(number, text));
        return None;
    };
    let side = Side::of_offset(base.offset_mm);
    let (first, last) = (path.segment(0), path.segment(path.segment_count() - 1));
    let lead_in = lead_in(settings.lead_in, first.start(), first.direction(0.0), side);
    let lead_out = lead_out(settings.lead_out, last.end(), last.direction(1.0), side);
    let named = [("lead-in", lead_in.clone()), ("lead-out", lead_out.clone())];
    let long = with_leads(&path, lead_in, lead_out);
    let leads = named.into_iter().filter_map(|(name, lead)| Some((name, lead?))).collect();
    let z_mm = base.z_mm.map(|z| heights_along(&base.path, &z, &long));
    Some(ShapePath { pass, path: long, z_mm, offset_mm: base.offset_mm, leads })
}

/// Heights of a path made from another by tag and leads: those of the nearest place, so that a lead
/// has the height of the end it belongs to.
fn heights_along(base: &Polyarc, z_mm: &[f64], path: &Polyarc) -> Vec<f64> {
    let shape = Shape::with_heights(base.clone(), z_mm.to_vec());
    heights_beside(&shape, path)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::families;

    /// An offset that only the second engine makes, and not exactly: the person is told, and what is cut stays
    /// within what was told.
    #[test]
    fn an_offset_that_is_not_exact_is_told() {
        let shape = families::half_circles();
        let settings = GroupSettings { offset_mm: -2.0, ..GroupSettings::default() };
        let (none, mut warnings) = (|_: &[Polyarc], _: f64| None, Vec::new());
        let by_chords = Offsetter::with_first(&none);
        let found = paths(1, &Shape::flat(shape.clone()), &settings, &by_chords, &mut warnings);
        let told: Vec<_> = warnings.iter().map(ToString::to_string).collect();
        let text = "shape 1: its offset could not be made exactly: it may be off by 0.001 mm";
        assert_eq!(told, [text]);
        for path in found.iter().map(|found| &found.path) {
            assert!(path.vertices.iter().any(|vertex| vertex.bulge != 0.0));
            for place in path.segments().flat_map(|s| [0.0, 0.5].map(|share| s.at(share))) {
                let far = shape.nearest(place).map_or(0.0, |(_, far)| far);
                assert!((far - 2.0).abs() <= 1e-3, "{place:?} {far}");
            }
        }
    }
}
