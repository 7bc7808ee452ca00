//! Breaking a shape at a place, and taking out what lies between crossings.

use crate::{Crossing, GeomError, Point2, Polyarc, PolyarcPlace, tol};

/// A shape broken at a place of it: a closed one becomes open there, an open one becomes two.
pub fn broken(path: &Polyarc, at: &PolyarcPlace) -> Vec<Polyarc> {
    if path.closed {
        return vec![path.between(at, at)];
    }
    let (split, vertex) = path.with_vertex_at(at);
    if vertex == 0 || vertex + 1 >= split.vertices.len() {
        return vec![path.clone()];
    }
    let mut before = split.vertices[..=vertex].to_vec();
    if let Some(last) = before.last_mut() {
        last.bulge = 0.0;
    }
    vec![Polyarc::open(before), Polyarc::open(split.vertices[vertex..].to_vec())]
}

/// Returns what remains of a shape when the stretch at `picked` is taken out, from the cutter's crossing before it to
/// the one after it. A cutter equal to the shape trims the loops the shape makes with itself; what remains on both
/// sides of such a loop stays one shape.
///
/// # Errors
/// No crossing bounds the picked stretch.
pub fn trimmed(
    path: &Polyarc,
    picked: Point2,
    cutters: &[Polyarc],
) -> Result<Vec<Polyarc>, GeomError> {
    let none = || GeomError::Impossible { what: "no intersection to trim to", at: picked };
    let (place, _) = path.nearest(picked).ok_or_else(none)?;
    let cuts = cuts(path, cutters);
    let key = |p: &PolyarcPlace| (p.segment, p.share);
    let next = cuts.iter().find(|c| key(c) > key(&place));
    let before = cuts.iter().rev().find(|c| key(c) <= key(&place));
    if path.closed {
        // The stretch may run over the start.
        let (next, before) = (next.or(cuts.first()), before.or(cuts.last()));
        return match (before, next) {
            (Some(from), Some(to)) if key(from) != key(to) => Ok(vec![path.between(to, from)]),
            _ => Err(none()),
        };
    }
    open_rest(path, before, next).ok_or_else(none)
}

fn open_rest(
    path: &Polyarc,
    before: Option<&PolyarcPlace>,
    next: Option<&PolyarcPlace>,
) -> Option<Vec<Polyarc>> {
    let head = before.map(|at| broken(path, at).swap_remove(0));
    let tail = next.and_then(|at| broken(path, at).pop());
    match (before, next, head, tail) {
        (Some(from), Some(to), Some(mut head), Some(tail))
            if from.at.distance(to.at) <= tol::SAME_PLACE_MM =>
        {
            head.vertices.pop();
            head.vertices.extend(tail.vertices);
            Some(vec![head])
        }
        (None, None, ..) => None,
        (_, _, head, tail) => Some(head.into_iter().chain(tail).collect()),
    }
}

/// Finds the places where the cutters cross the path, in the order of travel.
fn cuts(path: &Polyarc, cutters: &[Polyarc]) -> Vec<PolyarcPlace> {
    let mut cuts = Vec::new();
    for cutter in cutters {
        if cutter == path {
            let both = |c: &Crossing| [c.first, c.second];
            cuts.extend(path.self_crossings().iter().flat_map(both));
        } else {
            cuts.extend(path.crossings(cutter).iter().map(|c| c.first));
        }
    }
    cuts.sort_by(|a, b| a.segment.cmp(&b.segment).then(a.share.total_cmp(&b.share)));
    cuts
}

#[cfg(test)]
mod tests {
    use super::*;

    fn p(x: f64, y: f64) -> Point2 {
        Point2::new(x, y)
    }

    fn line(a: (f64, f64), b: (f64, f64)) -> Polyarc {
        Polyarc::lines([p(a.0, a.1), p(b.0, b.1)], false)
    }

    fn check(path: &Polyarc, picked: (f64, f64), cutters: &[Polyarc], expected: &[Polyarc]) {
        let rest = trimmed(path, p(picked.0, picked.1), cutters).expect("a trim");
        assert_eq!(rest, expected);
    }

    #[test]
    fn the_picked_stretch_goes() {
        let walls = [line((20., -9.), (20., 9.)), line((80., -9.), (80., 9.))];
        let bar = line((0., 0.), (100., 0.));
        check(&bar, (50., 0.), &walls, &[line((0., 0.), (20., 0.)), line((80., 0.), (100., 0.))]);
        check(&bar, (5., 1.), &walls, &[line((20., 0.), (100., 0.))]);
        check(&bar, (95., 1.), &walls, &[line((0., 0.), (80., 0.))]);
        let away = line((30., 500.), (70., 500.));
        assert!(trimmed(&away, p(50., 500.), &walls).is_err());
        let square = Polyarc::rectangle(p(0., 0.), p(100., 5.));
        let rest = trimmed(&square, p(50., 0.), &walls).expect("a trim");
        assert_eq!((rest[0].start(), rest[0].end()), (Some(p(80., 0.)), Some(p(20., 0.))));
    }

    #[test]
    fn a_loop_of_its_own_goes_and_the_rest_stays_one() {
        let path = Polyarc::lines(
            [(0., 0.), (100., 0.), (100., 50.), (50., 50.), (50., -50.)].map(|(x, y)| p(x, y)),
            false,
        );
        let rest = Polyarc::lines([p(0., 0.), p(50., 0.), p(50., -50.)], false);
        check(&path, (100., 25.), std::slice::from_ref(&path), &[rest]);
    }

    #[test]
    fn breaking_opens_or_splits() {
        let square = Polyarc::rectangle(p(0., 0.), p(100., 100.));
        let at = |path: &Polyarc, x: f64, y: f64| path.nearest(p(x, y)).expect("near").0;
        let open = broken(&square, &at(&square, 50., 0.));
        assert_eq!((open.len(), open[0].vertices.len(), open[0].length()), (1, 6, 400.0));
        let quarter = Polyarc::arc(p(0., 0.), 10.0, 0.0, std::f64::consts::FRAC_PI_2);
        let third = quarter.place_after(quarter.length() / 3.0).expect("a place");
        let parts = broken(&quarter, &third);
        assert!((parts[0].vertices[0].bulge - 0.131652).abs() < 1e-6);
        assert!((parts[1].vertices[0].bulge - 0.267949).abs() < 1e-6);
        assert_eq!(broken(&quarter, &at(&quarter, 10., 0.)).len(), 1);
    }
}
