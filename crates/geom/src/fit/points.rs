//! Long lists of places replaced by few lines and arcs.

use crate::{GeomError, Point2, Polyarc, Segment, Vertex};

/// A polyarc that passes every place, and the lines between them, within a tolerance, with as few
/// segments as a greedy search finds: each line or arc reaches as far as it can. It begins and ends at
/// places of the list, never has an arc of more than half a circle, and keeps the order of the places.
///
/// # Errors
/// A tolerance that is not positive, places that are not finite.
pub fn points(places: &[Point2], closed: bool, tolerance: f64) -> Result<Polyarc, GeomError> {
    if !(tolerance.is_finite() && tolerance > 0.0) {
        return Err(GeomError::NotPositive { what: "the tolerance" });
    }
    let mut all = Polyarc::lines(places.iter().copied(), closed).tidied();
    all.check()?;
    if let (true, Some(&first)) = (closed, all.vertices.first()) {
        all.vertices.push(first);
    }
    let list: Vec<Point2> = all.vertices.iter().map(|v| v.at).collect();
    let mut vertices = Vec::new();
    let mut from = 0;
    while from + 1 < list.len() {
        let (to, bulge) = farthest(&list, from, tolerance);
        vertices.push(Vertex { at: list[from], bulge });
        from = to;
    }
    if let (false, Some(&at)) = (closed, list.last()) {
        vertices.push(Vertex { at, bulge: 0.0 });
    }
    Ok(Polyarc { vertices, closed })
}

/// The farthest place that one segment reaches, and its bulge: steps that double, then a search
/// between the last that fits and the first that does not.
fn farthest(list: &[Point2], from: usize, tolerance: f64) -> (usize, f64) {
    let last = list.len() - 1;
    let mut best = (from + 1, 0.0);
    let mut step = 2;
    let mut fails = last + 1;
    while from + step <= last {
        match one_segment(&list[from..=from + step], tolerance) {
            Some(bulge) => best = (from + step, bulge),
            None => {
                fails = from + step;
                break;
            }
        }
        step *= 2;
    }
    while best.0 + 1 < fails {
        let middle = best.0.midpoint(fails);
        match one_segment(&list[from..=middle], tolerance) {
            Some(bulge) => best = (middle, bulge),
            None => fails = middle,
        }
    }
    best
}

/// The bulge of a segment from the first to the last place that passes the others, if there is one.
fn one_segment(places: &[Point2], tolerance: f64) -> Option<f64> {
    let (start, end) = (*places.first()?, *places.last()?);
    let (mut low, mut high) = (-1.0f64, 1.0f64);
    for &place in &places[1..places.len() - 1] {
        let (least, most) = bulges_past(start, end, place, tolerance)?;
        low = low.max(least);
        high = high.min(most);
    }
    if low > high {
        return None;
    }
    let bulge = if low <= 0.0 && high >= 0.0 { 0.0 } else { 0.5 * (low + high) };
    let segment = Segment::bulged(start, end, bulge);
    passes(&segment, places, tolerance).then_some(bulge)
}

/// The bulges whose arcs pass a place within the tolerance, roughly.
///
/// From a place of the arc the chord is seen under π − sweep/2, which gives the bulge of the arc through
/// the place. Near it, a change of the bulge by δ moves the arc there by 2δ·x(c − x)/c, x along the chord c.
fn bulges_past(start: Point2, end: Point2, place: Point2, tolerance: f64) -> Option<(f64, f64)> {
    let (a, b) = (start - place, end - place);
    let chord = end - start;
    let square = chord.dot(chord);
    let along = (place - start).dot(chord) / square;
    let seen = a.cross(b).atan2(a.dot(b));
    let quarter_sweep = -0.5 * (std::f64::consts::PI - seen.abs()) * seen.signum();
    let exact = quarter_sweep.tan();
    if !exact.is_finite() || exact.abs() > 1.5 {
        return None;
    }
    let reach = 2.0 * along * (1.0 - along) * square.sqrt();
    let slack = if reach > 0.0 { tolerance / reach } else { 2.0 };
    Some((exact - slack, exact + slack))
}

/// The exact test: places in order along the segment, they and the middles of their lines near it.
fn passes(segment: &Segment, places: &[Point2], tolerance: f64) -> bool {
    let mut reached = 0.0;
    places.windows(2).all(|pair| {
        let share = segment.share_of(pair[1]);
        let forward = share >= reached - 1e-9;
        reached = share;
        forward
            && segment.distance(pair[1]) <= tolerance
            && segment.distance(pair[0].midpoint(pair[1])) <= tolerance
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn p(x: f64, y: f64) -> Point2 {
        Point2::new(x, y)
    }

    #[test]
    fn chords_of_arcs_become_arcs_again() {
        let slot = Polyarc::rounded_rectangle(p(0., 0.), p(60., 20.), 10.0);
        let count = 900;
        let step = slot.length() / f64::from(count);
        let places: Vec<Point2> = (0..count)
            .filter_map(|k| slot.place_after(f64::from(k) * step))
            .map(|q| q.at)
            .collect();
        for tolerance in [0.001, 0.01] {
            let found = points(&places, true, tolerance).expect("a path");
            assert!(found.vertices.len() <= 10, "{}", found.vertices.len());
            let far = |at: &Point2| found.nearest(*at).map_or(f64::MAX, |n| n.1);
            assert!(places.iter().map(far).fold(0.0, f64::max) <= tolerance);
            assert!((found.signed_area() - slot.signed_area()).abs() < tolerance * 200.0);
        }
        let zigzag = [p(0., 0.), p(1., 1.), p(2., 0.), p(1., -1.)];
        assert_eq!(points(&zigzag, false, 0.01).expect("a path").vertices.len(), 4);
        assert!(points(&zigzag, false, -1.0).is_err());
    }
}
