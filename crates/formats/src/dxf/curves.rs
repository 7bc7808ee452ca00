//! ELLIPSE and SPLINE, and chords of arcs.

use super::file::Entity;
use super::importing::{Destination, Import};
use super::map::Vec3;
use super::through::through;
use kerf_drawing::Shape;
use kerf_geom::fit::{Ellipse, Nurbs};
use kerf_geom::{Point2, Polyarc, Vec2};
use std::f64::consts::TAU;

pub(super) fn ellipse<'f, 'a>(
    import: &mut Import<'f, 'a, '_>,
    entity: &Entity<'f, 'a>,
    place: &Destination<'a>,
) {
    let (centre, major) = (import.corner(entity, 0), import.corner(entity, 1));
    let (Some(centre), Some(major)) = (centre, major) else { return };
    let mut real = |code, default| entity.real_or(code, default, &mut import.findings);
    let (ratio, from) = (real(40, 1.0), real(41, 0.0));
    let to = real(42, TAU);
    let normal = Vec3::new(real(210, 0.0), real(220, 0.0), real(230, 1.0));
    let minor = normal.cross(major);
    let size = |v: Vec3| (v.x * v.x + v.y * v.y + v.z * v.z).sqrt();
    if size(minor) == 0.0 || ratio == 0.0 {
        return import.findings.warn("radius", entity.line, "ELLIPSE without a size: left out");
    }
    let share = ratio * size(major) / size(minor);
    let minor = Vec3::new(minor.x * share, minor.y * share, minor.z * share);
    // Parameters run counter-clockwise; a full turn may be written as equal angles.
    let sweep = (to - from).rem_euclid(TAU);
    let to_rad = from + if sweep < 1e-12 { TAU } else { sweep };
    let map = place.map;
    let (centre, major, minor) = (map.apply(centre), map.turn(major), map.turn(minor));
    let flat = |v: Vec3| Vec2::new(v.x, v.y);
    let seen = Ellipse {
        centre: centre.flat(),
        major: flat(major),
        minor: flat(minor),
        from_rad: from,
        to_rad,
    };
    if major.z == 0.0 && minor.z == 0.0 {
        let path = seen.polyarc(import.options.tolerance_mm);
        return import.add(entity, place, Shape::flat(path));
    }
    let at = |t: f64| {
        let (sin, cos) = t.sin_cos();
        let flat = seen.at(t).0;
        Vec3::new(flat.x, flat.y, centre.z + major.z * cos + minor.z * sin)
    };
    let places =
        (0..=SLANTED_CHORDS).map(|n| from + (to_rad - from) * n as f64 / SLANTED_CHORDS as f64);
    import.in_space(entity, place, places.map(at).collect(), false);
}

/// Chords of an ellipse or a span of a spline that does not lie level: within 0.01 mm up to a radius
/// of two metres.
const SLANTED_CHORDS: usize = 720;

/// Bit of group code 70 of a SPLINE: it returns to its beginning.
const CLOSED: i64 = 1;

pub(super) fn spline<'f, 'a>(
    import: &mut Import<'f, 'a, '_>,
    entity: &Entity<'f, 'a>,
    place: &Destination<'a>,
) {
    let Some(mut parts) = parts(import, entity) else { return };
    // Numbers of codes 70 to 74 are small; what does not fit is refused by the spline.
    let mut degree = usize::try_from(entity.whole(71, &mut import.findings)).unwrap_or_default();
    if parts.points.is_empty() && !parts.through.is_empty() {
        let closed = entity.whole(70, &mut import.findings) & CLOSED != 0;
        let Some(curve) = through(&parts.through, closed, parts.ends) else {
            let text = "SPLINE with fewer than two different points: left out";
            return import.findings.warn("length", entity.line, text);
        };
        let text =
            "SPLINE given only by points it goes through: drawn as the cubic spline through them";
        import.findings.note("spline", entity.line, text);
        (degree, parts.knots, parts.points) = (3, curve.knots, curve.points);
        parts.weights.clear();
    }
    let world: Vec<Vec3> = parts.points.iter().map(|p| place.map.apply(*p)).collect();
    let flat: Vec<Point2> = world.iter().map(|p| p.flat()).collect();
    let level = world.iter().all(|p| p.z == world[0].z);
    match Nurbs::new(degree, parts.knots.clone(), &flat, &parts.weights) {
        Err(error) => {
            import.findings.warn("spline", entity.line, format!("SPLINE: {error}: left out"));
        }
        Ok(curve) if level => {
            let path = curve.polyarc(import.options.tolerance_mm);
            import.add(entity, place, Shape::flat(path));
        }
        Ok(curve) => {
            let heights: Vec<Point2> = world.iter().map(|p| Point2::new(p.z, 0.0)).collect();
            let Ok(height) = Nurbs::new(degree, parts.knots, &heights, &parts.weights) else {
                return;
            };
            let world = sampled(&curve, &height);
            lines(import, entity, place, world);
        }
    }
}

fn lines<'f, 'a>(
    import: &mut Import<'f, 'a, '_>,
    entity: &Entity<'f, 'a>,
    place: &Destination<'a>,
    world: Vec<Vec3>,
) {
    if world.iter().all(|p| p.z == world[0].z) {
        let path = Polyarc::lines(world.into_iter().map(Vec3::flat), false).tidied();
        import.add(entity, place, Shape::flat(path));
    } else {
        import.in_space(entity, place, world, false);
    }
}

/// Places along a spline in space, each span in equal steps of its parameter.
fn sampled(curve: &Nurbs, height: &Nurbs) -> Vec<Vec3> {
    const STEPS: usize = 64;
    let breaks = curve.breaks();
    let mut world = Vec::new();
    for ends in breaks.windows(2) {
        let steps = (0..STEPS).map(|n| ends[0] + (ends[1] - ends[0]) * n as f64 / STEPS as f64);
        world.extend(steps.map(|t| in_space(curve, height, t)));
    }
    world.extend(breaks.last().map(|t| in_space(curve, height, *t)));
    world
}

fn in_space(curve: &Nurbs, height: &Nurbs, t: f64) -> Vec3 {
    let flat = curve.at(t).0;
    Vec3::new(flat.x, flat.y, height.at(t).0.x)
}

/// Knots, weights and points of a SPLINE in the order of the file.
#[derive(Default)]
struct Parts {
    knots: Vec<f64>,
    weights: Vec<f64>,
    points: Vec<Vec3>,
    through: Vec<Vec3>,
    /// Directions of the ends.
    ends: [Option<Vec3>; 2],
}

fn parts<'f, 'a>(import: &mut Import<'f, 'a, '_>, entity: &Entity<'f, 'a>) -> Option<Parts> {
    let mut parts = Parts::default();
    for tag in entity.tags {
        if !matches!(tag.code, 10..=33 | 40 | 41) {
            continue;
        }
        let Some(value) = tag.real() else {
            let text = format!("SPLINE: `{}` is no number: left out", tag.text());
            import.findings.warn("number", tag.line, text);
            return None;
        };
        match tag.code {
            40 => parts.knots.push(value),
            41 => parts.weights.push(value),
            10 => parts.points.push(Vec3::new(value, 0.0, 0.0)),
            11 => parts.through.push(Vec3::new(value, 0.0, 0.0)),
            12 | 13 => parts.ends[usize::from(tag.code) - 12] = Some(Vec3::new(value, 0.0, 0.0)),
            22 | 23 | 32 | 33 => {
                let end = parts.ends[usize::from(tag.code) % 10 - 2].as_mut();
                set(end, tag.code, value);
            }
            20 | 30 => set(parts.points.last_mut(), tag.code, value),
            21 | 31 => set(parts.through.last_mut(), tag.code, value),
            _ => {}
        }
    }
    Some(parts)
}

/// Codes of Y are in the twenties, of Z in the thirties.
fn set(point: Option<&mut Vec3>, code: u16, value: f64) {
    if let Some(point) = point {
        *(if code < 30 { &mut point.y } else { &mut point.z }) = value;
    }
}
