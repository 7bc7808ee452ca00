//! From segments to lines on paper: cuts sorted by shade, jogs, plunges, start and end.

use super::depth::{DepthScale, SHADES};
use crate::scene::{Scene, Segment, Shape};
use crate::sheet::{Outline, simplify};
use kerf_geom::{Arc2, Point2};
use kerf_program::MoveKind;
use std::collections::BTreeMap;

/// Outlines that are drawn of the motion.
///
/// All cuts of one shade are one path, so that a long program needs few elements and the deepest
/// cuts lie on top.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tracks {
    /// Cuts above the surface.
    pub air: Outline,
    /// Cuts by shade.
    pub cuts: Vec<Outline>,
    /// Jogs.
    pub jogs: Outline,
    /// Places of straight plunges with their deepest shade (none above the surface).
    pub plunges: Vec<(Point2, Option<usize>)>,
    /// Start and end of the motion.
    pub ends: Option<[Point2; 2]>,
}

/// Detail in which tracks follow the program.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Detail {
    /// Moves shorter than this in X and Y are points when they go up or down, mm.
    pub point_mm: f64,
    /// Moves shorter than this get one shade, mm.
    pub shade_mm: f64,
    /// Allowed deviation of lines, mm; none draws everything.
    pub tolerance_mm: Option<f64>,
}

impl Tracks {
    /// Draws the segments.
    pub fn of(scene: &Scene, scale: &DepthScale, detail: &Detail) -> Self {
        let mut pen = Pen::new(*scale, *detail, scene.show_jogs);
        pen.tracks.cuts.resize(SHADES.max(scene.colours.len()), Outline::default());
        for (n, segment) in scene.segments.iter().enumerate().filter(|(_, s)| s.is_drawable()) {
            pen.colour = scene.colour_of(n);
            pen.segment(segment);
        }
        pen.finish()
    }
}

struct Pen {
    scale: DepthScale,
    detail: Detail,
    show_jogs: bool,
    tracks: Tracks,
    /// Deepest shade by place on a grid of `point_mm`.
    plunges: BTreeMap<[i64; 2], (Point2, Option<usize>)>,
    shade: Option<usize>,
    /// The colour of the segment, when it is not that of its depth.
    colour: Option<usize>,
}

impl Pen {
    fn new(scale: DepthScale, detail: Detail, show_jogs: bool) -> Self {
        let tracks = Tracks { cuts: vec![Outline::default(); SHADES], ..Tracks::default() };
        Self {
            scale,
            detail,
            show_jogs,
            tracks,
            plunges: BTreeMap::new(),
            shade: None,
            colour: None,
        }
    }

    fn segment(&mut self, segment: &Segment) {
        let (from, to) = (flat(segment.from), flat(segment.to));
        if segment.kind == MoveKind::Cut || self.show_jogs {
            let start = self.tracks.ends.map_or(from, |e| e[0]);
            self.tracks.ends = Some([start, to]);
        }
        let length = length(segment);
        match segment.kind {
            MoveKind::Jog if self.show_jogs && length > self.detail.point_mm => {
                draw(&mut self.tracks.jogs, segment, from, to);
            }
            MoveKind::Jog => {}
            MoveKind::Cut if self.is_plunge(segment, from.distance(to).max(length)) => {
                self.plunge(to, segment.from[2].min(segment.to[2]));
            }
            MoveKind::Cut => self.cut(segment, length),
        }
    }

    /// Returns `true` if a cut goes down on the spot. Many cuts too short to be seen are a line together when they do
    /// not.
    fn is_plunge(&self, segment: &Segment, length: f64) -> bool {
        let steep = (segment.to[2] - segment.from[2]).abs() >= length;
        steep && length <= self.detail.point_mm
    }

    fn cut(&mut self, segment: &Segment, length: f64) {
        if length < self.detail.shade_mm || self.colour.is_some() {
            return self.piece(segment);
        }
        let [z0, z1] = [segment.from[2], segment.to[2]];
        let mut shares = self.scale.crossings(z0, z1);
        shares.push(1.0);
        let mut at = 0.0;
        for share in shares {
            self.piece(&part(segment, at, share));
            at = share;
        }
    }

    fn piece(&mut self, segment: &Segment) {
        let middle = 0.5 * (segment.from[2] + segment.to[2]);
        self.shade = match self.detail.tolerance_mm {
            _ if self.colour.is_some() => self.colour,
            Some(_) => self.scale.steady_shade(middle, self.shade),
            None => self.scale.shade(middle),
        };
        let outline = match self.shade {
            Some(shade) => &mut self.tracks.cuts[shade],
            None => &mut self.tracks.air,
        };
        draw(outline, segment, flat(segment.from), flat(segment.to));
    }

    fn plunge(&mut self, at: Point2, z: f64) {
        let cell = [at.x, at.y].map(|v| (v / self.detail.point_mm).round() as i64);
        let shade = self.colour.or(self.scale.shade(z));
        let known = self.plunges.entry(cell).or_insert((at, shade));
        known.1 = known.1.max(shade);
    }

    fn finish(self) -> Tracks {
        let mut tracks = self.tracks;
        tracks.plunges = self.plunges.into_values().collect();
        tracks.plunges.sort_by_key(|p| p.1);
        if let Some(tolerance) = self.detail.tolerance_mm {
            let paths = tracks.cuts.iter_mut().chain([&mut tracks.air, &mut tracks.jogs]);
            paths.for_each(|path| *path = simplify(path, tolerance));
        }
        tracks
    }
}

/// X and Y of a place.
pub fn flat(place: [f64; 3]) -> Point2 {
    Point2::new(place[0], place[1])
}

/// Length of a segment in X and Y, mm.
pub fn length(segment: &Segment) -> f64 {
    match segment.shape {
        Shape::Line => flat(segment.from).distance(flat(segment.to)),
        Shape::Arc { .. } => arc(segment).map_or(0.0, |a| a.length()),
    }
}

/// The arc of a round segment.
pub fn arc(segment: &Segment) -> Option<Arc2> {
    match segment.shape {
        Shape::Line => None,
        Shape::Arc { centre: [x, y], sweep_rad } => {
            Some(Arc2 { start: flat(segment.from), centre: Point2::new(x, y), sweep_rad })
        }
    }
}

/// The place after a share of a segment.
pub fn place(segment: &Segment, share: f64) -> [f64; 3] {
    if share <= 0.0 {
        return segment.from;
    }
    if share >= 1.0 {
        return segment.to;
    }
    let even = |i: usize| segment.from[i] + (segment.to[i] - segment.from[i]) * share;
    match arc(segment) {
        None => [even(0), even(1), even(2)],
        Some(arc) => {
            let p = arc.at(share) + (flat(segment.to) - arc.end()) * share;
            [p.x, p.y, even(2)]
        }
    }
}

fn part(segment: &Segment, start: f64, end: f64) -> Segment {
    let shape = match segment.shape {
        Shape::Arc { centre, sweep_rad } => {
            Shape::Arc { centre, sweep_rad: sweep_rad * (end - start) }
        }
        Shape::Line => Shape::Line,
    };
    Segment { from: place(segment, start), to: place(segment, end), shape, ..*segment }
}

fn draw(outline: &mut Outline, segment: &Segment, from: Point2, to: Point2) {
    outline.move_to(from);
    match segment.shape {
        Shape::Line => outline.line_to(to),
        Shape::Arc { centre: [x, y], sweep_rad } => {
            outline.arc_to(Point2::new(x, y), to, sweep_rad)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A circle of a million places was a hundred thousand plunges and as many bits of line.
    #[test]
    fn cuts_too_short_to_be_seen_are_a_line_together() {
        let detail = Detail { point_mm: 0.01, shade_mm: 1.0, tolerance_mm: Some(0.1) };
        let place = |k: u32| [f64::from(k) * 0.002, 0.0, -1.0];
        let cut = |from, to| Segment { kind: MoveKind::Cut, from, to, shape: Shape::Line, line: 1 };
        let down = cut([0.0, 0.0, 0.0], place(0));
        let along = (0..5000).map(|k| cut(place(k), place(k + 1)));
        let segments = [down].into_iter().chain(along).collect();
        let scene = Scene { segments, ..Scene::default() };
        let tracks = Tracks::of(&scene, &DepthScale::new(0.0, -1.0, 0.0), &detail);
        let places: Vec<Point2> = tracks.plunges.iter().map(|(at, _)| *at).collect();
        assert_eq!(places, [Point2::default()]);
        let steps: Vec<usize> =
            tracks.cuts.iter().map(|cut| cut.ops.len()).filter(|n| *n > 0).collect();
        assert_eq!(steps, [2]);
    }
}
