//! Timing diagrams: lines that go on and off, and values that change, under one another over time.
//!
//! ```text
//!  z       ──╲________╱──
//!  router  __▔▔▔▔▔▔▔▔▔▔__
//!  cut1    ____▔▔▔▔▔▔____
//! ```

use crate::palette::{BOARD, EDGE, FINE, INK, PAPER, SOFT};
use crate::png::{self, PngError};
use crate::sheet::{Anchor, Frame, Layer, Mark, Outline, Paint, Rect, Sheet, Text};
use crate::svg;
use kerf_geom::Point2;
use kerf_program::rounded;

/// Width of the page, mm.
const WIDTH: f64 = 250.0;
const MARGIN: f64 = 8.0;
/// Room for the names.
const NAMES: f64 = 34.0;
/// Room for the heading.
const HEAD: f64 = 20.0;
/// Height of a track that is on or off, and of one with values.
const LOW: f64 = 11.0;
const HIGH: f64 = 20.0;
/// Letters, mm.
const EM: f64 = 2.6;
/// Times stand no closer than this, mm.
const CLOSE: f64 = 9.0;

/// Course of a track.
#[derive(Clone, Debug, PartialEq)]
pub enum Course {
    /// The place of an axis, mm; it goes evenly between these moments.
    Place(Vec<(f64, f64)>),
    /// A value that is 0, then this from these moments on.
    Value(Vec<(f64, f64)>),
    /// An output: on or off, from these moments on; off before the first.
    Output(Vec<(f64, bool)>),
    /// An input, likewise.
    Input(Vec<(f64, bool)>),
}

/// One line of a diagram.
#[derive(Clone, Debug, PartialEq)]
pub struct Track {
    /// Its name.
    pub name: String,
    /// Course of the track.
    pub course: Course,
    /// Grain, seconds: where this is not 0, of each grain only the first, the least, the greatest and the last
    /// point are here.
    pub grain_s: f64,
}

/// The corners of a value that changes in steps.
pub fn corners(steps: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let before = std::iter::once(0.0).chain(steps.iter().map(|(_, value)| *value));
    steps.iter().zip(before).flat_map(|((t_s, to), from)| [(*t_s, from), (*t_s, *to)]).collect()
}

/// A diagram.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Timing {
    /// The heading.
    pub title: String,
    /// End of the diagram, seconds.
    pub end_s: f64,
    /// The lines, from above.
    pub tracks: Vec<Track>,
}

impl Timing {
    /// The diagram as SVG.
    pub fn svg(&self) -> String {
        svg::write(&self.sheet())
    }

    /// The diagram as PNG, its longer side so many pixels long.
    ///
    /// # Errors
    /// [`PngError`] when the picture would be larger than memory allows.
    pub fn png(&self, pixels: u32) -> Result<Vec<u8>, PngError> {
        png::paint(&self.sheet(), pixels)
    }

    fn sheet(&self) -> Sheet {
        let height: f64 = self.tracks.iter().map(Track::height).sum();
        let page = Rect { x: 0.0, y: 0.0, w: WIDTH, h: HEAD + height + 2.0 * MARGIN };
        let mut layer = Layer::new("timing", Frame::Page, false);
        layer.path(Outline::of_rect(page), Paint::fill(BOARD));
        let panel = Rect { x: MARGIN + NAMES, y: HEAD, w: WIDTH - NAMES - 2.0 * MARGIN, h: height };
        layer.path(Outline::of_rect(panel), Paint::edged(PAPER, EDGE, 0.2));
        heading(&mut layer, &self.title);
        let time = TimeAxis { panel, end_s: self.end_s.max(1e-3) };
        time.grid(&mut layer);
        let mut y = panel.y;
        for track in &self.tracks {
            track.draw(&mut layer, &time, y);
            y += track.height();
        }
        Sheet {
            title: self.title.clone(),
            description: format!("Timing diagram: {}.", self.title),
            page,
            panel: page,
            origin: Point2::default(),
            decimals: 2,
            layers: vec![layer],
        }
    }
}

/// Time along the page.
struct TimeAxis {
    panel: Rect,
    end_s: f64,
}

impl TimeAxis {
    fn x(&self, t_s: f64) -> f64 {
        self.panel.x + self.panel.w * (t_s / self.end_s).clamp(0.0, 1.0)
    }

    /// A line a second, or fewer.
    fn grid(&self, layer: &mut Layer) {
        let step = (self.end_s / 12.0).ceil().max(1.0);
        let mut lines = Outline::default();
        let count = (self.end_s / step).floor() as u32;
        for n in 0..=count {
            let t_s = f64::from(n) * step;
            let x = self.x(t_s);
            lines.segment(Point2::new(x, self.panel.y), Point2::new(x, self.panel.bottom()));
            let at = Point2::new(x, self.panel.bottom() + 4.0);
            layer.marks.push(words(at, Anchor::Middle, format!("{t_s} s")));
        }
        layer.path(lines, Paint::line(FINE, 0.2));
    }
}

impl Track {
    /// Its name, with the unit of its values where it has one.
    pub fn label(&self) -> String {
        match self.course {
            Course::Place(_) => format!("{}, mm", self.name),
            _ => self.name.clone(),
        }
    }

    const fn height(&self) -> f64 {
        match self.course {
            Course::Output(_) | Course::Input(_) => LOW,
            Course::Place(_) | Course::Value(_) => HIGH,
        }
    }

    fn draw(&self, layer: &mut Layer, time: &TimeAxis, y: f64) {
        let (top, bottom) = (y + 4.0, y + self.height() - 1.5);
        let at = Point2::new(time.panel.x - 2.0, bottom - 1.0);
        layer.marks.push(words(at, Anchor::End, self.label()));
        let moments = match &self.course {
            Course::Output(changes) | Course::Input(changes) => {
                layer.path(steps(changes, time, top, bottom), Paint::line(INK, 0.35));
                changes.iter().map(|(t_s, _)| (*t_s, format!("{t_s:.3}"))).collect()
            }
            Course::Place(points) => rising(layer, points, time, [top, bottom]),
            Course::Value(steps) => rising(layer, &corners(steps), time, [top, bottom]),
        };
        let mut last = f64::NEG_INFINITY;
        for (t_s, text) in moments {
            let x = time.x(t_s);
            if x - last >= CLOSE {
                let (by, anchor) = if x > time.panel.right() - CLOSE {
                    (-0.6, Anchor::End)
                } else {
                    (0.6, Anchor::Start)
                };
                layer.marks.push(words(Point2::new(x + by, y + 3.0), anchor, text));
                last = x;
            }
        }
    }
}

/// Draws a line up and down, and tells where it rests.
fn rising(
    layer: &mut Layer,
    points: &[(f64, f64)],
    time: &TimeAxis,
    [top, bottom]: [f64; 2],
) -> Vec<(f64, String)> {
    let heights = Scale::of(points, top, bottom);
    layer.path(slopes(points, time, &heights), Paint::line(INK, 0.35));
    heights.corners(points)
}

/// Scale of the values of a track on the page.
struct Scale {
    low: f64,
    high: f64,
    top: f64,
    bottom: f64,
}

impl Scale {
    fn of(points: &[(f64, f64)], top: f64, bottom: f64) -> Self {
        let values = points.iter().map(|(_, value)| *value);
        let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
            (low.min(value), high.max(value))
        });
        Self { low, high, top, bottom }
    }

    fn y(&self, value: f64) -> f64 {
        let span = (self.high - self.low).max(1e-9);
        self.bottom - (self.bottom - self.top) * (value - self.low) / span
    }

    /// Returns the moments at which the value comes to rest, and the value there; each is told once, however
    /// long it rests.
    fn corners(&self, points: &[(f64, f64)]) -> Vec<(f64, String)> {
        let rests =
            points.windows(2).filter(|pair| pair[0].1 == pair[1].1 && pair[1].0 > pair[0].0);
        let mut told: Vec<(f64, String)> =
            rests.map(|pair| (pair[0].0, rounded(pair[0].1, 3).to_string())).collect();
        told.dedup_by(|later, first| later.1 == first.1);
        told
    }
}

fn steps(changes: &[(f64, bool)], time: &TimeAxis, top: f64, bottom: f64) -> Outline {
    let mut line = Outline::default();
    let mut y = bottom;
    line.move_to(Point2::new(time.panel.x, y));
    for (t_s, on) in changes {
        let x = time.x(*t_s);
        line.line_to(Point2::new(x, y));
        y = if *on { top } else { bottom };
        line.line_to(Point2::new(x, y));
    }
    line.line_to(Point2::new(time.panel.right(), y));
    line
}

fn slopes(points: &[(f64, f64)], time: &TimeAxis, heights: &Scale) -> Outline {
    let mut line = Outline::default();
    for (n, (t_s, value)) in points.iter().enumerate() {
        let at = Point2::new(time.x(*t_s), heights.y(*value));
        if n == 0 { line.move_to(at) } else { line.line_to(at) }
    }
    if let Some((_, value)) = points.last() {
        line.line_to(Point2::new(time.panel.right(), heights.y(*value)));
    }
    line
}

fn heading(layer: &mut Layer, title: &str) {
    let at = Point2::new(MARGIN, 12.0);
    let text = title.to_owned();
    let mark =
        Text { at, size: 5.0, anchor: Anchor::Start, bold: true, colour: INK, halo: false, text };
    layer.marks.push(Mark::Text(mark));
}

fn words(at: Point2, anchor: Anchor, text: String) -> Mark {
    Mark::Text(Text { at, size: EM, anchor, bold: false, colour: SOFT, halo: false, text })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_value_that_rests_is_told_once() {
        let rests = [0.3, 1.0, 1.7, 2.8].map(|t_s| (t_s, -10.0));
        let points = [&[(0.0, 0.0)], &rests[..], &[(3.8, -30.0), (5.0, -30.0)]].concat();
        let tracks = vec![Track { name: "z".into(), course: Course::Place(points), grain_s: 0.0 }];
        let svg = Timing { title: "Rest".into(), end_s: 8.0, tracks }.svg();
        assert_eq!(svg.matches(">-10<").count(), 1, "{svg}");
    }

    #[test]
    fn a_diagram_names_its_lines_and_the_moments_of_their_edges() {
        let switch = Course::Output(vec![(0.3, true), (7.19, false)]);
        let height = Course::Place(vec![(0.0, 0.0), (0.3, -10.0), (2.8, -10.0), (3.84, -30.0)]);
        let track = |name: &str, course| Track { name: name.into(), course, grain_s: 0.0 };
        let tracks = vec![track("z", height), track("router", switch)];
        let svg = Timing { title: "JOB-T1".into(), end_s: 7.89, tracks }.svg();
        for text in ["JOB-T1", "z, mm", "router", "0.300", "7.190", "-10"] {
            assert!(svg.contains(text), "{text}");
        }
    }
}
