//! Vertices that lie too near to the one before are left out (Profiler reference, "General Options").

use kerf_geom::{Point2, Polyarc, Vertex};

/// Which vertices of a path are left out: those nearer than a distance to the last one that stays. The
/// first stays; so does the last of an open path, instead of those right before it.
pub fn too_near(path: &Polyarc, distance_mm: f64) -> Vec<usize> {
    let places: Vec<Point2> = path.vertices.iter().map(|vertex| vertex.at).collect();
    let (Some(first), true) = (places.first(), distance_mm > 0.0 && places.len() > 2) else {
        return Vec::new();
    };
    let near = |a: Point2, b: Point2| (a - b).length() < distance_mm;
    // What the end of the path has to keep away from: its own end, or the start it returns to.
    let end = if path.closed { *first } else { places[places.len() - 1] };
    let inner = if path.closed { 1..places.len() } else { 1..places.len() - 1 };
    let mut last = *first;
    let mut gone = Vec::new();
    for n in inner {
        if near(places[n], last) || near(places[n], end) && ends_here(&places[n..], end, near) {
            gone.push(n);
        } else {
            last = places[n];
        }
    }
    gone
}

/// Returns `true` if everything from here on lies near the end.
fn ends_here(rest: &[Point2], end: Point2, near: impl Fn(Point2, Point2) -> bool) -> bool {
    rest.iter().all(|at| near(*at, end))
}

/// The path without them. What leaves a vertex that goes leaves the one before it.
pub fn filtered(path: &Polyarc, distance_mm: f64) -> Polyarc {
    let gone = too_near(path, distance_mm);
    if gone.is_empty() {
        return path.clone();
    }
    let mut kept: Vec<Vertex> = Vec::with_capacity(path.vertices.len() - gone.len());
    for (n, vertex) in path.vertices.iter().enumerate() {
        match kept.last_mut() {
            Some(last) if gone.binary_search(&n).is_ok() => last.bulge = vertex.bulge,
            _ => kept.push(*vertex),
        }
    }
    Polyarc { vertices: kept, closed: path.closed }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use kerf_drawing::{Drawing, Shape};

    fn path(xs: &[f64]) -> Polyarc {
        Polyarc::open(xs.iter().map(|x| Vertex::new(*x, 0.0, 0.0)).collect())
    }

    fn check(xs: &[f64], distance_mm: f64, gone: &[usize]) {
        assert_eq!(too_near(&path(xs), distance_mm), gone);
    }

    #[test]
    fn vertices_are_counted_from_the_last_that_stays() {
        check(&[0.0, 0.01, 10.0], 0.02, &[1]);
        check(&[0.0, 0.01, 10.0], 0.0, &[]);
        check(&[0.0, 0.015, 0.03, 0.045, 10.0], 0.02, &[1, 3]);
        check(&[0.0, 9.99, 10.0], 0.02, &[1]);
        check(&[0.0, 0.01], 0.02, &[]);
    }

    #[test]
    fn a_closed_path_keeps_its_start() {
        let square = [(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0), (0.0, 0.01)];
        let path = Polyarc::closed(square.map(|(x, y)| Vertex::new(x, y, 0.0)).to_vec());
        assert_eq!(too_near(&path, 0.02), [4]);
        assert_eq!(filtered(&path, 0.02).vertices.len(), 4);
    }

    #[test]
    fn pro_options_filter() {
        let drawing = Drawing::of([Shape::flat(path(&[0.0, 0.01, 10.0]))]);
        let before = drawing.clone();
        let vertices = |filter_mm| {
            let shaping = crate::Shaping { factor: 0.0, filter_mm };
            let (job, _) = crate::shaped_job(&drawing, shaping).unwrap();
            let path = &job.paths[0].shape.path;
            path.vertices.iter().map(|vertex| vertex.at.x).collect::<Vec<_>>()
        };
        assert_eq!(vertices(0.02), [0.0, 10.0]);
        assert_eq!(vertices(0.0), [0.0, 0.01, 10.0]);
        assert_eq!(drawing, before);
    }
}
