//! The same offset by Kerf and by others. Polygon libraries get arcs and round joins at a micrometre.

use crate::flattened::flattened;
use crate::outcome::Outcome;
use cavalier_contours::polyline::{
    CoincidentSegmentBehavior, PlineCreation, PlineOffsetOptions, PlineSource, PlineSourceMut,
    PlineVertex, Polyline,
};
use clipper2_rust::{EndType, JoinType, PathsD, PointD};
use i_overlay::mesh::float::outline::offset::OutlineOffset;
use i_overlay::mesh::float::style::{LineJoin, OutlineStyle};
use kerf_geom::{Offsetter, Point2, Polyarc, Vertex};

/// Rings that are kept to be looked at; while time is measured they are not.
type Kept<'a> = Option<&'a mut Vec<Polyarc>>;

/// Offsets contours one by one, positive outwards, and sums what comes out. Kerf's buffers are kept from run
/// to run, as in a whole job.
type Offset = fn(&Offsetter, &[Polyarc], f64, Kept) -> Outcome;

pub const ALL: &[(&str, Offset)] = &[
    ("Kerf, checked", kerf),
    ("cavalier_contours, tuned", |_, c, d, kept| cavalier(c, d, true, kept)),
    ("cavalier_contours, defaults", |_, c, d, kept| cavalier(c, d, false, kept)),
    ("clipper2-rust", clipper),
    ("i_overlay", overlay),
];

const CHORD_MM: f64 = 0.001;

fn kerf(offsetter: &Offsetter, contours: &[Polyarc], distance: f64, mut kept: Kept) -> Outcome {
    let mut outcome = Outcome::default();
    for contour in contours {
        let Ok(found) = offsetter.offset(contour, distance) else { return Outcome::default() };
        for ring in found {
            outcome.add(ring.path.vertices.len(), ring.path.signed_area());
            keep(&mut kept, || ring.path);
        }
    }
    outcome
}

fn cavalier(contours: &[Polyarc], distance: f64, tuned: bool, mut kept: Kept) -> Outcome {
    let mut outcome = Outcome::default();
    let mut options: PlineOffsetOptions<f64> = PlineOffsetOptions::new();
    if tuned {
        options.coincident_segment_behavior = CoincidentSegmentBehavior::Discard;
        options.pos_equal_eps = 1e-8;
        options.offset_dist_eps = 1e-6;
    }
    for contour in contours {
        let mut line = Polyline::with_capacity(contour.vertices.len(), true);
        contour.vertices.iter().for_each(|v| line.add(v.at.x, v.at.y, v.bulge));
        // There, positive is left of travel.
        for ring in line.parallel_offset_opt(-distance, &options) {
            outcome.add(ring.vertex_count(), if ring.is_closed() { ring.area() } else { 0.0 });
            let vertex = |v: &PlineVertex<f64>| Vertex::new(v.x, v.y, v.bulge);
            keep(&mut kept, || Polyarc {
                vertices: ring.vertex_data.iter().map(vertex).collect(),
                closed: ring.is_closed(),
            });
        }
    }
    outcome
}

fn clipper(_: &Offsetter, contours: &[Polyarc], distance: f64, mut kept: Kept) -> Outcome {
    let mut outcome = Outcome::default();
    for contour in contours {
        let path =
            flattened(contour, CHORD_MM).iter().map(|p| PointD { x: p[0], y: p[1] }).collect();
        let paths: PathsD = vec![path];
        let (join, end) = (JoinType::Round, EndType::Polygon);
        for ring in clipper2_rust::inflate_paths_d(&paths, distance, join, end, 2.0, 6, CHORD_MM) {
            let places: Vec<[f64; 2]> = ring.iter().map(|p| [p.x, p.y]).collect();
            outcome.add(places.len(), area(&places));
            keep(&mut kept, || polygon(&places));
        }
    }
    outcome
}

fn overlay(_: &Offsetter, contours: &[Polyarc], distance: f64, mut kept: Kept) -> Outcome {
    let mut outcome = Outcome::default();
    let step = 2.0 * (2.0 * CHORD_MM / distance.abs()).sqrt();
    let style = OutlineStyle::new(distance).line_join(LineJoin::Round(step));
    for contour in contours {
        for ring in flattened(contour, CHORD_MM).outline(&style).into_iter().flatten() {
            outcome.add(ring.len(), area(&ring));
            keep(&mut kept, || polygon(&ring));
        }
    }
    outcome
}

fn keep(kept: &mut Kept, ring: impl FnOnce() -> Polyarc) {
    if let Some(kept) = kept {
        kept.push(ring());
    }
}

fn polygon(places: &[[f64; 2]]) -> Polyarc {
    Polyarc::lines(places.iter().map(|[x, y]| Point2::new(*x, *y)), true)
}

/// Signed area of a polygon.
fn area(places: &[[f64; 2]]) -> f64 {
    let next = places.iter().cycle().skip(1);
    places.iter().zip(next).map(|(a, b)| a[0] * b[1] - a[1] * b[0]).sum::<f64>() * 0.5
}
