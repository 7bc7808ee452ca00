//! Places where two segments meet.

use super::{Segment, square};
use crate::{Point2, Vec2, tol};

/// A place that two segments share.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Contact {
    /// The place.
    pub at: Point2,
    /// Share of the first segment's path.
    pub on_first: f64,
    /// Share of the second segment's path.
    pub on_second: f64,
}

/// The places two segments share: at most two crossings, or the ends of the stretches they share
/// when they lie on one line or one circle (at most four).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Contacts {
    list: [Contact; 4],
    count: usize,
    /// The segments run along each other; the contacts are the ends of where they do.
    pub along: bool,
}

impl std::ops::Deref for Contacts {
    type Target = [Contact];
    fn deref(&self) -> &[Contact] {
        &self.list[..self.count]
    }
}

impl Contacts {
    fn push(&mut self, contact: Contact) {
        let near = |c: &Contact| square(c.at - contact.at) < tol::CONTACT_MM * tol::CONTACT_MM;
        if self.count < self.list.len() && !self.iter().any(near) {
            self.list[self.count] = contact;
            self.count += 1;
        }
    }

    fn swapped(mut self) -> Self {
        for c in &mut self.list[..self.count] {
            std::mem::swap(&mut c.on_first, &mut c.on_second);
        }
        self
    }
}

impl Segment {
    /// All places shared with another segment. Ends count, and so do near misses below
    /// [`tol::CONTACT_MM`].
    pub fn meet(&self, other: &Self) -> Contacts {
        match (self, other) {
            (Self::Line { .. }, Self::Line { .. }) => line_line(self, other),
            (Self::Line { .. }, Self::Arc { .. }) => line_arc(self, other),
            (Self::Arc { .. }, Self::Line { .. }) => line_arc(other, self).swapped(),
            (Self::Arc { .. }, Self::Arc { .. }) => arc_arc(self, other),
        }
    }

    /// The share of the path at a place of the supporting line or circle, when that place lies on the
    /// path or within [`tol::CONTACT_MM`] of its ends.
    fn share_within(&self, place: Point2) -> Option<f64> {
        // Most places that are asked about are far from an arc, which is seen without its angle.
        let near = |end: Point2| square(place - end) <= 4.0 * tol::CONTACT_MM * tol::CONTACT_MM;
        if !(self.faces(place) || near(self.start()) || near(self.end())) {
            return None;
        }
        let share = self.share_of(place);
        let slack = tol::CONTACT_MM / self.length();
        (-slack <= share && share <= 1.0 + slack).then(|| share.clamp(0.0, 1.0))
    }

    fn take(&self, other: &Self, at: Point2, into: &mut Contacts) {
        let Some(on_first) = self.share_within(at) else { return };
        let Some(on_second) = other.share_within(at) else { return };
        into.push(Contact { at, on_first, on_second });
    }
}

fn line_line(a: &Segment, b: &Segment) -> Contacts {
    let mut found = Contacts::default();
    let (p, u) = (a.start(), a.end() - a.start());
    let (q, v) = (b.start(), b.end() - b.start());
    let (long_u, long_v) = (square(u).sqrt(), square(v).sqrt());
    if long_u == 0.0 || long_v == 0.0 {
        return point_on(a, b);
    }
    let cross = u.cross(v);
    // Parallel when neither end of one line leaves the other by what can be told.
    let apart = |w: Vec2| u.cross(w).abs() / long_u;
    if cross.abs() <= long_u * tol::CONTACT_MM {
        if apart(q - p) <= tol::CONTACT_MM || apart(b.end() - p) <= tol::CONTACT_MM {
            return ends_on_each_other(a, b);
        }
        if cross == 0.0 {
            return found;
        }
    }
    let t = (q - p).cross(v) / cross;
    let s = (q - p).cross(u) / cross;
    let (slack_t, slack_s) = (tol::CONTACT_MM / long_u, tol::CONTACT_MM / long_v);
    if t >= -slack_t && t <= 1.0 + slack_t && s >= -slack_s && s <= 1.0 + slack_s {
        let (t, s) = (t.clamp(0.0, 1.0), s.clamp(0.0, 1.0));
        // An end is a better place than a computed crossing.
        let at = if s == 0.0 || s == 1.0 { b.at(s) } else { a.at(t) };
        found.push(Contact { at, on_first: t, on_second: s });
    }
    found
}

/// Contacts when one of the segments has no length.
fn point_on(a: &Segment, b: &Segment) -> Contacts {
    let mut found = Contacts::default();
    let foot = if a.length() == 0.0 { b.nearest(a.start()) } else { a.nearest(b.start()) };
    if foot.distance <= tol::CONTACT_MM {
        let (on_first, on_second) =
            if a.length() == 0.0 { (0.0, foot.share) } else { (foot.share, 0.0) };
        found.push(Contact { at: foot.at, on_first, on_second });
    }
    found
}

/// Contacts of segments on one line or circle: the ends of each that lie on the other.
fn ends_on_each_other(a: &Segment, b: &Segment) -> Contacts {
    let mut found = Contacts::default();
    for (share, at) in [(0.0, a.start()), (1.0, a.end())] {
        if let Some(on_second) = b.share_within(at) {
            found.push(Contact { at, on_first: share, on_second });
        }
    }
    for (share, at) in [(0.0, b.start()), (1.0, b.end())] {
        if let Some(on_first) = a.share_within(at) {
            found.push(Contact { at, on_first, on_second: share });
        }
    }
    let count = found.count;
    found.list[..count].sort_by(|x, y| x.on_first.total_cmp(&y.on_first));
    // Half circles that only share their ends do not run along each other.
    let shared = |pair: &[Contact]| {
        let middle = a.at((pair[0].on_first + pair[1].on_first) * 0.5);
        b.distance(middle) <= 2.0 * tol::CONTACT_MM
    };
    found.along = found.windows(2).any(shared);
    found
}

fn line_arc(line: &Segment, arc: &Segment) -> Contacts {
    let mut found = Contacts::default();
    let Segment::Arc { centre, radius, .. } = *arc else { return found };
    let way = line.end() - line.start();
    let long = square(way).sqrt();
    if long == 0.0 {
        return point_on(line, arc);
    }
    let along = way / long;
    let to_centre = centre - line.start();
    let foot = line.start() + along * to_centre.dot(along);
    let miss = along.cross(to_centre).abs();
    if miss > radius + tol::CONTACT_MM {
        return found;
    }
    // (r − m)(r + m) keeps the digits that r² − m² loses where the line only touches.
    let half = ((radius - miss) * (radius + miss)).max(0.0).sqrt();
    if half < tol::CONTACT_MM {
        line.take(arc, foot, &mut found);
    } else {
        line.take(arc, foot - along * half, &mut found);
        line.take(arc, foot + along * half, &mut found);
    }
    found
}

fn arc_arc(a: &Segment, b: &Segment) -> Contacts {
    let mut found = Contacts::default();
    let (Segment::Arc { centre: ca, radius: ra, .. }, Segment::Arc { centre: cb, radius: rb, .. }) =
        (*a, *b)
    else {
        return found;
    };
    let between = cb - ca;
    let apart = square(between).sqrt();
    if apart <= tol::CONTACT_MM && (ra - rb).abs() <= tol::CONTACT_MM {
        return ends_on_each_other(a, b);
    }
    // From the centre of the smaller circle: that of an arc that is all but a line lies so far away that its
    // digits do not reach here.
    if ra > rb {
        return arc_arc(b, a).swapped();
    }
    let inner = (ra - rb).abs();
    if apart > ra + rb + tol::CONTACT_MM || apart < inner - tol::CONTACT_MM || apart == 0.0 {
        return found;
    }
    let along = between / apart;
    let reach = (apart + (ra - rb) * (ra + rb) / apart) * 0.5;
    let half = ((ra - reach) * (ra + reach)).max(0.0).sqrt();
    let foot = ca + along * reach;
    if half < tol::CONTACT_MM {
        let touch = ca + along * (ra * reach.signum());
        a.take(b, touch, &mut found);
    } else {
        a.take(b, foot + along.left() * half, &mut found);
        a.take(b, foot - along.left() * half, &mut found);
    }
    found
}
