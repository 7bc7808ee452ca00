//! Signs on the path: direction arrows, plunges, start and end.

use super::tracks::{Tracks, arc, flat, length, place};
use super::view::View;
use crate::font::Font;
use crate::palette::{AIR, AXIS_Y, BEGIN, INK, JOG, PAPER, Rgb};
use crate::scene::{Scene, Segment};
use crate::sheet::{Anchor, Frame, Layer, Mark, Outline, Paint, Text};
use kerf_geom::{Point2, Vec2};
use kerf_program::MoveKind;
use std::collections::BTreeSet;

/// About so many arrows on all cuts, and on all jogs.
const ARROWS: f64 = 28.0;
/// Arrows are at least so far apart along the path, em.
const APART_EM: f64 = 9.0;
/// Only one arrow in each square of this side, em.
const CELL_EM: f64 = 5.5;
/// A sign where a cut begins is no larger than this share of the way to the next one,
const BEGIN_SHARE: f64 = 0.35;
/// but not so small that nobody sees it, em.
const BEGIN_LEAST: f64 = 0.2;

/// Direction arrows of cuts and jogs.
pub fn arrows(scene: &Scene, view: &View) -> Layer {
    let mut layer = Layer::new("arrows", Frame::Working, true);
    let mut taken = BTreeSet::new();
    for (kind, colour) in [(MoveKind::Cut, INK), (MoveKind::Jog, JOG)] {
        if kind == MoveKind::Jog && !scene.show_jogs {
            continue;
        }
        let moves = || scene.segments.iter().filter(move |s| s.kind == kind && s.is_drawable());
        let heads = along(moves, view.em, &mut taken);
        layer.path(heads, Paint::edged(colour, PAPER, 0.1 * view.em));
    }
    layer
}

/// The smallest upright rectangle around the cuts, as drawings have it.
pub fn bounds(scene: &Scene, em: f64) -> Layer {
    let mut layer = Layer::new("bounds", Frame::Working, true);
    let b = &scene.bounds;
    if !b.is_empty() {
        let mut outline = Outline::default();
        outline.polygon(&[
            Point2::new(b.min[0], b.min[1]),
            Point2::new(b.max[0], b.min[1]),
            Point2::new(b.max[0], b.max[1]),
            Point2::new(b.min[0], b.max[1]),
        ]);
        layer.path(outline, bounds_paint(em));
    }
    layer
}

/// The line of [`bounds`].
pub fn bounds_paint(em: f64) -> Paint {
    Paint::dashed(AXIS_Y, 0.08 * em, [0.5 * em, 0.35 * em])
}

/// Draws signs where cuts begin, and in which direction: smaller ones for many, and one where they would lie on each
/// other.
pub fn starts(scene: &Scene, em: f64) -> Layer {
    let mut layer = Layer::new("starts", Frame::Working, true);
    let begins = begins(scene);
    let size = em * (BEGIN_SHARE * spacing(scene, begins.len()) / em).clamp(BEGIN_LEAST, 1.0);
    let (mut taken, mut signs) = (BTreeSet::new(), Outline::default());
    for (at, along) in begins {
        if taken.insert([at.x, at.y].map(|v| (v / size).floor() as i64)) {
            begin_shape(&mut signs, at, along, size);
        }
    }
    layer.path(signs, begin_paint(size));
    layer
}

/// The first places of cuts, with their directions.
fn begins(scene: &Scene) -> Vec<(Point2, Vec2)> {
    let (mut begins, mut travels) = (Vec::new(), true);
    for segment in scene.segments.iter().filter(|s| s.is_drawable()) {
        let flat_cut = segment.kind == MoveKind::Cut && length(segment) > 0.0;
        if flat_cut && travels {
            begins.push((flat(segment.from), direction(segment, 0.0)));
        }
        travels = segment.kind == MoveKind::Jog || (travels && !flat_cut);
    }
    begins
}

/// Returns the distance between so many places that are spread over all cuts, mm.
fn spacing(scene: &Scene, count: usize) -> f64 {
    let ([w, h, _], count) = (scene.bounds.size(), count.max(1) as f64);
    (w * h / count).sqrt().max(w.max(h) / count)
}

/// Yellow, as drawings have it.
pub fn begin_sign(layer: &mut Layer, at: Point2, along: Vec2, em: f64) {
    let mut sign = Outline::default();
    begin_shape(&mut sign, at, along, em);
    layer.path(sign, begin_paint(em));
}

fn begin_shape(signs: &mut Outline, at: Point2, along: Vec2, em: f64) {
    let side = along.left() * (0.3 * em);
    signs.polygon(&[at + side, at + along * (0.75 * em), at + -side]);
}

fn begin_paint(em: f64) -> Paint {
    Paint::edged(BEGIN, INK, 0.06 * em)
}

fn along<'a, I: Iterator<Item = &'a Segment>>(
    moves: impl Fn() -> I,
    em: f64,
    taken: &mut BTreeSet<[i64; 2]>,
) -> Outline {
    let total: f64 = moves().map(length).sum();
    let spacing = (total / ARROWS).max(APART_EM * em);
    let mut heads = Outline::default();
    // The first arrow comes early, so that short paths have one.
    let mut next = 0.4 * total.min(spacing);
    let mut done = 0.0;
    for segment in moves() {
        let own = length(segment);
        while next <= done + own && own > 0.0 {
            let share = (next - done) / own;
            let at = flat(place(segment, share));
            if taken.insert([at.x, at.y].map(|v| (v / (CELL_EM * em)).floor() as i64)) {
                head(&mut heads, at, direction(segment, share), em);
            }
            next += spacing;
        }
        done += own;
    }
    heads
}

fn direction(segment: &Segment, share: f64) -> Vec2 {
    match arc(segment) {
        Some(arc) => arc.direction(share),
        None => (flat(segment.to) - flat(segment.from)).normalized().unwrap_or_default(),
    }
}

pub fn head(heads: &mut Outline, at: Point2, along: Vec2, em: f64) {
    let side = along.left() * (0.42 * em);
    let tail = at + along * (-0.5 * em);
    heads.polygon(&[
        at + along * (0.7 * em),
        tail + side,
        tail + along * (0.22 * em),
        tail + -side,
    ]);
}

/// Places where the tool goes straight down, each in the colour of its cuts.
pub fn plunges(tracks: &Tracks, radius: f64, em: f64, colour: impl Fn(usize) -> Rgb) -> Layer {
    let mut layer = Layer::new("plunges", Frame::Working, true);
    for same in tracks.plunges.chunk_by(|a, b| a.1 == b.1) {
        let mut dots = Outline::default();
        same.iter().for_each(|(at, _)| dots.circle(*at, radius));
        let colour = same[0].1.map_or(AIR, &colour);
        layer.path(dots, Paint::edged(colour, PAPER, 0.06 * em));
    }
    layer
}

/// Returns the discs that the cutter takes away where it plunges to a shade.
pub fn bores(tracks: &Tracks, shade: usize, cutter_mm: f64) -> Outline {
    let mut discs = Outline::default();
    let same = tracks.plunges.iter().filter(|p| p.1 == Some(shade));
    same.for_each(|(at, _)| discs.circle(*at, 0.5 * cutter_mm));
    discs
}

/// Start and end of the motion.
pub fn ends(tracks: &Tracks, view: &View) -> Layer {
    let em = view.em;
    let mut layer = Layer::new("ends", Frame::Page, true);
    let Some([start, end]) = tracks.ends.map(|e| e.map(|p| Point2::new(p.x, -p.y))) else {
        return layer;
    };
    start_sign(&mut layer, start, em);
    end_sign(&mut layer, end, em);
    if start.distance(end) < 3.0 * em {
        layer.marks.push(name(start, view, "start, end"));
    } else {
        layer.marks.push(name(start, view, "start"));
        layer.marks.push(name(end, view, "end"));
    }
    layer
}

/// A ring.
pub fn start_sign(layer: &mut Layer, at: Point2, em: f64) {
    for (radius, width, colour) in [(0.62, 0.5, PAPER), (0.62, 0.26, AXIS_Y)] {
        let mut ring = Outline::default();
        ring.circle(at, radius * em);
        layer.path(ring, Paint::line(colour, width * em));
    }
}

/// A square.
pub fn end_sign(layer: &mut Layer, at: Point2, em: f64) {
    let half = 0.32 * em;
    let corners = [(-half, -half), (half, -half), (half, half), (-half, half)];
    let mut square = Outline::default();
    square.polygon(&corners.map(|(x, y)| at + Vec2::new(x, y)));
    layer.path(square, Paint::edged(INK, PAPER, 0.12 * em));
}

/// Right below a place, or left of it where the frame ends.
fn name(at: Point2, view: &View, text: &str) -> Mark {
    let em = view.em;
    let long = Font::new(true).width(text) * em;
    let fits = at.x + 0.9 * em + long <= view.panel.x + view.panel.w;
    let (anchor, side) = if fits { (Anchor::Start, 0.9) } else { (Anchor::End, -0.9) };
    Mark::Text(Text {
        at: at + Vec2::new(side * em, 1.5 * em),
        size: em,
        anchor,
        bold: true,
        colour: INK,
        halo: true,
        text: text.into(),
    })
}

#[cfg(test)]
mod tests {
    use super::super::extent::Extent;
    use super::*;
    use crate::scene::Shape;
    use crate::sheet::Op;

    /// The corners of the signs where so many rows of so many cuts begin, 10 mm apart.
    fn corners_of_starts(rows: usize) -> Vec<Point2> {
        let segment = |n: usize| {
            let from = [10.0 * (n % rows) as f64, 10.0 * (n / rows) as f64, 0.0];
            let jog = Segment { kind: MoveKind::Jog, from, to: from, shape: Shape::Line, line: 1 };
            let cut = Segment { kind: MoveKind::Cut, to: [from[0] + 5.0, from[1], 0.0], ..jog };
            [jog, cut]
        };
        let segments = (0..rows * rows).flat_map(segment).collect();
        let mut scene = Scene { segments, ..Scene::default() };
        scene.segments.iter().for_each(|s| {
            scene.bounds.add(s.from);
            scene.bounds.add(s.to);
        });
        let em = Extent::of(&scene).cut.size()[0] / 66.0;
        let [Mark::Path { outline, .. }] = &starts(&scene, em).marks[..] else {
            panic!("one path is wanted")
        };
        let place = |op: &Op| match *op {
            Op::Move(at) | Op::Line(at) => Some(at),
            _ => None,
        };
        outline.ops.iter().filter_map(place).collect()
    }

    #[test]
    fn signs_where_many_cuts_begin_leave_room_between_them() {
        for rows in [2, 20, 100] {
            let corners = corners_of_starts(rows);
            assert_eq!(corners.len(), 3 * rows * rows);
            let right = corners.iter().map(|at| at.x.rem_euclid(10.0)).fold(0.0, f64::max);
            assert!(right > 0.1 && right < 5.0, "{rows}: {right}");
        }
    }

    #[test]
    fn a_name_at_the_right_edge_stands_left_of_its_place() {
        let from = |x: f64| Segment {
            kind: MoveKind::Cut,
            from: [x, 0.0, 0.0],
            to: [0.0, 50.0, 0.0],
            shape: Shape::Line,
            line: 1,
        };
        let anchor = |x: f64| {
            let scene = Scene { segments: vec![from(100.0)], ..Scene::default() };
            let view = View::of(&scene, &Extent::of(&scene), 0.0);
            match name(Point2::new(x, 0.0), &view, "start, end") {
                Mark::Text(text) => (text.anchor, text.at.x),
                Mark::Path { .. } => panic!("a text is wanted"),
            }
        };
        let (left, at) = anchor(0.0);
        assert!(left == Anchor::Start && at > 0.0);
        let (right, at) = anchor(100.0);
        assert!(right == Anchor::End && at < 100.0);
    }
}
