//! The diagram of height control: the tool over the sheet along the path, and how far the gap was from what
//! was wanted.
//!
//! ```text
//!  z      tool  ‾‾╲__╱‾‾      the sheet below it
//!  error  ──┬╲╱──┬─────       inside a band; what lies outside is red
//! ```

use crate::palette::{AXIS_X, BOARD, EDGE, FINE, INK, PAPER, SOFT, depth_colour};
use crate::png::{self, PngError};
use crate::sheet::{Anchor, Frame, Layer, Mark, Outline, Paint, Rect, Sheet, Text};
use crate::svg;
use kerf_geom::Point2;
use kerf_program::rounded;

/// Width of the page, mm.
const WIDTH: f64 = 250.0;
const MARGIN: f64 = 8.0;
/// Room for the numbers beside the panels.
const NUMBERS: f64 = 20.0;
/// Room for heading and note.
const HEAD: f64 = 22.0;
/// Heights of the panels, and the room between them.
const HIGH: f64 = 48.0;
const GAP: f64 = 14.0;
/// Letters, mm.
const EM: f64 = 2.6;

/// A reading of the height sensor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reading {
    /// Place on the path, mm.
    pub at_mm: f64,
    /// Z of the tool, mm.
    pub z_mm: f64,
    /// Z of the sheet below it, mm.
    pub sheet_mm: f64,
    /// Difference of the gap from what is wanted, mm.
    pub error_mm: f64,
}

/// A diagram of readings.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct HeightPlot {
    /// The heading.
    pub title: String,
    /// Text below the heading.
    pub note: String,
    /// Errors inside this are good, mm.
    pub accuracy_mm: f64,
    /// In the order of the path.
    pub readings: Vec<Reading>,
}

impl HeightPlot {
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
        let page = Rect { x: 0.0, y: 0.0, w: WIDTH, h: HEAD + 2.0 * HIGH + GAP + 2.0 * MARGIN };
        let mut layer = Layer::new("heights", Frame::Page, false);
        layer.path(Outline::of_rect(page), Paint::fill(BOARD));
        layer.marks.push(text(Point2::new(MARGIN, 11.0), Anchor::Start, 5.0, self.title.clone()));
        layer.marks.push(small(Point2::new(MARGIN, 17.0), Anchor::Start, self.note.clone()));
        self.heights(&mut layer);
        self.errors(&mut layer);
        Sheet {
            title: self.title.clone(),
            description: format!("Height control: {}. {}", self.title, self.note),
            page,
            panel: page,
            origin: Point2::default(),
            decimals: 2,
            layers: vec![layer],
        }
    }

    fn heights(&self, layer: &mut Layer) {
        let both = self.readings.iter().flat_map(|it| [it.z_mm, it.sheet_mm]);
        let panel = self.panel(HEAD, span(both), "Z, mm");
        layer.path(Outline::of_rect(panel.frame), Paint::fill(PAPER));
        panel.draw(layer);
        let sheet = self.readings.iter().map(|it| (it.at_mm, it.sheet_mm));
        layer.path(panel.curve(sheet), Paint::line(SOFT, 0.5));
        let tool = self.readings.iter().map(|it| (it.at_mm, it.z_mm));
        layer.path(panel.curve(tool), Paint::line(depth_colour(0.8), 0.5));
        if let Some(last) = self.readings.last() {
            for (z_mm, word) in [(last.z_mm, "tool"), (last.sheet_mm, "sheet")] {
                let at = Point2::new(panel.frame.right() - 2.0, panel.y(z_mm) + 5.0);
                layer.marks.push(small(at, Anchor::End, word.into()));
            }
        }
    }

    fn errors(&self, layer: &mut Layer) {
        let reach = 1.2 * self.accuracy_mm.max(1e-6);
        let worst = self.readings.iter().map(|it| it.error_mm.abs()).fold(reach, f64::max);
        let panel = self.panel(HEAD + HIGH + GAP, [-worst, worst], "error of the gap, mm");
        let [low, high] = [-self.accuracy_mm, self.accuracy_mm].map(|mm| panel.y(mm));
        let frame = panel.frame;
        let band = Rect { x: frame.x, y: high, w: frame.w, h: low - high };
        layer.path(Outline::of_rect(frame), Paint::fill(PAPER));
        layer.path(Outline::of_rect(band), Paint::fill(depth_colour(0.0).mixed(PAPER, 0.8)));
        panel.draw(layer);
        for stretch in self.readings.chunk_by(|a, b| self.is_off(a) == self.is_off(b)) {
            let points = stretch.iter().map(|it| (it.at_mm, it.error_mm));
            let off = stretch.first().is_some_and(|it| self.is_off(it));
            let colour = if off { AXIS_X } else { INK };
            layer.path(panel.curve(points), Paint::line(colour, 0.35));
        }
        let at = Point2::new(frame.x + 0.5 * frame.w, frame.bottom() + 8.0);
        layer.marks.push(small(at, Anchor::Middle, "way along the path, mm".into()));
    }

    const fn is_off(&self, reading: &Reading) -> bool {
        reading.error_mm.abs() > self.accuracy_mm
    }

    /// Returns where the readings begin and end on the path.
    fn along(&self) -> [f64; 2] {
        span(self.readings.iter().map(|it| it.at_mm))
    }

    fn panel(&self, y: f64, values: [f64; 2], name: &'static str) -> Panel {
        let x = MARGIN + NUMBERS;
        let frame = Rect { x, y, w: WIDTH - x - MARGIN, h: HIGH };
        Panel { frame, along: self.along(), values, name }
    }
}

/// A panel with its two scales.
struct Panel {
    frame: Rect,
    along: [f64; 2],
    values: [f64; 2],
    name: &'static str,
}

impl Panel {
    fn x(&self, at_mm: f64) -> f64 {
        self.frame.x + self.frame.w * share(at_mm, self.along)
    }

    fn y(&self, value: f64) -> f64 {
        self.frame.bottom() - 2.0 - (self.frame.h - 4.0) * share(value, self.values)
    }

    /// Frame and grid.
    fn draw(&self, layer: &mut Layer) {
        let frame = self.frame;
        let at = Point2::new(frame.x, frame.y - 1.5);
        layer.marks.push(small(at, Anchor::Start, self.name.into()));
        let mut lines = Outline::default();
        for value in round_values(self.values, 6.0) {
            let y = self.y(value);
            lines.segment(Point2::new(frame.x, y), Point2::new(frame.right(), y));
            let at = Point2::new(frame.x - 1.5, y + 0.9);
            layer.marks.push(small(at, Anchor::End, rounded(value, 6).to_string()));
        }
        for at_mm in round_values(self.along, 12.0) {
            let x = self.x(at_mm);
            lines.segment(Point2::new(x, frame.y), Point2::new(x, frame.bottom()));
            let at = Point2::new(x, frame.bottom() + 4.0);
            layer.marks.push(small(at, Anchor::Middle, rounded(at_mm, 6).to_string()));
        }
        layer.path(lines, Paint::line(FINE, 0.2));
        layer.path(Outline::of_rect(frame), Paint::line(EDGE, 0.2));
    }

    fn curve(&self, points: impl Iterator<Item = (f64, f64)>) -> Outline {
        let mut line = Outline::default();
        for (n, (at_mm, value)) in points.enumerate() {
            let at = Point2::new(self.x(at_mm), self.y(value));
            if n == 0 { line.move_to(at) } else { line.line_to(at) }
        }
        line
    }
}

/// Round values inside a stretch, so many at most.
fn round_values([low, high]: [f64; 2], most: f64) -> Vec<f64> {
    let rough = ((high - low) / most).max(1e-9);
    let ten = 10f64.powf(rough.log10().floor());
    let step = [1.0, 2.0, 5.0, 10.0].into_iter().map(|n| n * ten).find(|step| *step >= rough);
    let step = step.unwrap_or(rough);
    let first = (low / step - 1e-3).ceil() as i64;
    let last = (high / step + 1e-3).floor() as i64;
    (first..=last).map(|n| n as f64 * step).collect()
}

/// The least and the greatest of some values.
fn span(values: impl Iterator<Item = f64>) -> [f64; 2] {
    let [low, high] = values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| {
        [low.min(value), high.max(value)]
    });
    if low > high { [0.0, 1.0] } else { [low, high] }
}

fn share(value: f64, [low, high]: [f64; 2]) -> f64 {
    (value - low) / (high - low).max(1e-9)
}

fn small(at: Point2, anchor: Anchor, words: String) -> Mark {
    Mark::Text(Text { at, size: EM, anchor, bold: false, colour: SOFT, halo: false, text: words })
}

fn text(at: Point2, anchor: Anchor, size: f64, words: String) -> Mark {
    Mark::Text(Text { at, size, anchor, bold: true, colour: INK, halo: false, text: words })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_beyond_the_accuracy_have_another_colour() {
        let reading = |at_mm: f64, error_mm| {
            let (z_mm, sheet_mm) = (-14.3 + error_mm, -20.0);
            Reading { at_mm, z_mm, sheet_mm, error_mm }
        };
        let readings = vec![reading(0.0, 0.0), reading(1.0, 0.05), reading(2.0, 0.2)];
        let (title, note) = ("Warped".to_owned(), "note".to_owned());
        let good = HeightPlot { title, note, accuracy_mm: 0.1, readings };
        assert!(good.svg().contains(&AXIS_X.hex()) && good.svg().contains(">Warped<"));
        let better = HeightPlot { accuracy_mm: 0.3, ..good };
        assert!(!better.svg().contains(&AXIS_X.hex()));
    }

    #[test]
    fn scales_have_round_numbers() {
        assert_eq!(round_values([-0.12, 0.12], 6.0), [-0.1, -0.05, 0.0, 0.05, 0.1]);
        assert_eq!(
            round_values([0.0, 300.0], 12.0),
            [0.0, 50.0, 100.0, 150.0, 200.0, 250.0, 300.0]
        );
    }
}
