//! Level lines within rings, joined along the rings to chains that run to and fro.

use kerf_geom::{Point2, Polyarc, PolyarcPlace, Segment};

/// End of a line, on a ring.
#[derive(Clone, Copy)]
struct End {
    ring: usize,
    place: PolyarcPlace,
}

/// A line between two rings, or between two places of one.
struct Span {
    line: usize,
    ends: [End; 2],
}

/// The chains of the lines at these heights.
pub(crate) fn chains(rings: &[Polyarc], heights: &[f64]) -> Vec<Polyarc> {
    let lines = heights.iter().enumerate();
    let spans: Vec<Span> = lines.flat_map(|(line, y)| spans(rings, line, *y)).collect();
    let order = Order::of(rings, &spans);
    let mut walk = Walk { rings, spans: &spans, order, seen: vec![false; spans.len()] };
    (0..spans.len()).filter_map(|start| walk.chain(start)).collect()
}

/// The spans of one line, from left to right.
fn spans(rings: &[Polyarc], line: usize, y: f64) -> Vec<Span> {
    let mut ends: Vec<End> = Vec::new();
    for (ring, path) in rings.iter().enumerate() {
        for (segment, found) in path.segments().enumerate() {
            let end =
                |at| End { ring, place: PolyarcPlace { segment, share: found.share_of(at), at } };
            ends.extend(crossings(&found, y).into_iter().flatten().map(end));
        }
    }
    ends.sort_by(|a, b| a.place.at.x.total_cmp(&b.place.at.x));
    ends.chunks_exact(2).map(|pair| Span { line, ends: [pair[0], pair[1]] }).collect()
}

/// Returns the places where a segment crosses a height. Each stretch that only rises or falls counts its lower end
/// and not its upper one, so that rings are crossed an even number of times.
fn crossings(segment: &Segment, y: f64) -> [Option<Point2>; 3] {
    let (start, end) = (segment.start(), segment.end());
    let crosses = |a: f64, b: f64| (a <= y) != (b <= y);
    match *segment {
        Segment::Line { .. } => {
            let at = |share: f64| Point2::new(start.x + (end.x - start.x) * share, y);
            [crosses(start.y, end.y).then(|| at((y - start.y) / (end.y - start.y))), None, None]
        }
        Segment::Arc { centre, radius, .. } => {
            let half = (radius * radius - (y - centre.y).powi(2)).max(0.0).sqrt();
            let mut found = [None; 3];
            for (slot, [from, to]) in found.iter_mut().zip(rising_and_falling(segment)) {
                let right = segment.at(0.5 * (from + to)).x > centre.x;
                let x = if right { centre.x + half } else { centre.x - half };
                let crosses = crosses(segment.at(from).y, segment.at(to).y);
                *slot = crosses.then_some(Point2::new(x, y));
            }
            found
        }
    }
}

/// The shares of an arc between which it only rises or falls: it is cut at the top and the bottom of its
/// circle.
fn rising_and_falling(arc: &Segment) -> [[f64; 2]; 3] {
    let Segment::Arc { centre, radius, .. } = *arc else { return [[0.0, 1.0]; 3] };
    let share = |up: f64| {
        let top = Point2::new(centre.x, centre.y + up);
        let share = arc.share_of(top);
        let on_arc = arc.at(share).distance(top) <= 1e-9 * radius;
        if on_arc { share.clamp(0.0, 1.0) } else { 1.0 }
    };
    let (a, b) = (share(radius), share(-radius));
    let (first, second) = (a.min(b), a.max(b));
    [[0.0, first], [first, second], [second, 1.0]]
}

/// The ends of spans in their order along each ring.
struct Order {
    /// Span and side.
    ends: Vec<Vec<(usize, usize)>>,
    /// For each span and side its number in that list.
    number: Vec<[usize; 2]>,
}

impl Order {
    fn of(rings: &[Polyarc], spans: &[Span]) -> Self {
        let mut ends: Vec<Vec<(usize, usize)>> = vec![Vec::new(); rings.len()];
        for (n, span) in spans.iter().enumerate() {
            (0..2).for_each(|side| ends[span.ends[side].ring].push((n, side)));
        }
        let key = |end: &(usize, usize)| spans[end.0].ends[end.1].place;
        let mut number = vec![[0; 2]; spans.len()];
        for list in &mut ends {
            list.sort_by(|a, b| {
                let (a, b) = (key(a), key(b));
                a.segment.cmp(&b.segment).then(a.share.total_cmp(&b.share))
            });
            list.iter().enumerate().for_each(|(n, (span, side))| number[*span][*side] = n);
        }
        Self { ends, number }
    }

    /// The ends after and before an end on its ring.
    fn beside(&self, ring: usize, (span, side): (usize, usize)) -> [(usize, usize); 2] {
        let list = &self.ends[ring];
        let (n, count) = (self.number[span][side], list.len());
        [list[(n + 1) % count], list[(n + count - 1) % count]]
    }
}

struct Walk<'a> {
    rings: &'a [Polyarc],
    spans: &'a [Span],
    order: Order,
    seen: Vec<bool>,
}

impl Walk<'_> {
    /// The lines from one on, as long as one of a neighbouring height follows along the ring.
    fn chain(&mut self, start: usize) -> Option<Polyarc> {
        if std::mem::replace(self.seen.get_mut(start)?, true) {
            return None;
        }
        let mut path = Vec::new();
        let mut exit = (start, 1);
        loop {
            let span = &self.spans[exit.0];
            let (from, to) = (span.ends[1 - exit.1], span.ends[exit.1]);
            path.push(Segment::line(from.place.at, to.place.at));
            let Some((way, next)) = self.onward(exit) else { break };
            path.extend(way.segments());
            self.seen[next.0] = true;
            exit = (next.0, 1 - next.1);
        }
        Some(Polyarc::from_segments(&path, false))
    }

    /// The shorter way along the ring to the next line above or below that was not cut yet.
    fn onward(&self, exit: (usize, usize)) -> Option<(Polyarc, (usize, usize))> {
        let from = self.spans[exit.0].ends[exit.1];
        let ring = &self.rings[from.ring];
        let [after, before] = self.order.beside(from.ring, exit);
        let follows = |end: &(usize, usize)| {
            let apart = self.spans[end.0].line.abs_diff(self.spans[exit.0].line);
            !self.seen[end.0] && apart == 1
        };
        let place = |end: (usize, usize)| self.spans[end.0].ends[end.1].place;
        let forward = Some(after).filter(follows);
        let forward = forward.map(|end| (ring.between(&from.place, &place(end)), end));
        let back = Some(before).filter(follows);
        let back = back.map(|end| (ring.between(&place(end), &from.place).reversed(), end));
        let ways = forward.into_iter().chain(back);
        ways.min_by(|a, b| a.0.length().total_cmp(&b.0.length()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Between which places the line at a height lies inside a circle.
    fn check(circle: &Polyarc, y: f64, expected: [f64; 2]) {
        let found = spans(std::slice::from_ref(circle), 0, y);
        assert_eq!(found.len(), 1);
        let ends = found[0].ends.map(|end| end.place.at);
        assert!(ends.iter().zip(expected).all(|(end, x)| (end.x - x).abs() < 1e-9), "{ends:?}");
    }

    #[test]
    fn lines_end_on_both_sides_of_a_circle_wherever_it_begins() {
        let circle = Polyarc::circle(Point2::new(0.0, 0.0), 5.0);
        for k in 0..16 {
            let place = circle.place_after(circle.length() * f64::from(k) / 16.0);
            let begun = place.map_or(circle.clone(), |place| circle.started_at(&place)).merged();
            for y in [-3.0_f64, 0.0, 3.0] {
                let half = (25.0 - y * y).sqrt();
                check(&begun, y, [-half, half]);
            }
        }
    }
}
