//! Path data: `M 0 0 L 10 0 A …`.

use super::arc::{ArcWords, ellipse};
use super::shapes::Drawn;
use kerf_geom::fit::{Bezier, Ellipse, curve};
use kerf_geom::{Point2, Polyarc, Segment, Transform2, Vec2, tol};
use svgtypes::{PathParser, PathSegment};

/// The paths in path data, mapped to millimetres. What comes before a mistake is kept; then the
/// mistake is told too.
pub fn paths(data: &str, map: &Transform2, tolerance: f64) -> Drawn {
    let mut pen = Pen::new(map, tolerance);
    for segment in PathParser::from(data) {
        match segment {
            Ok(segment) => pen.follow(&segment),
            Err(error) => {
                pen.lift(false);
                let wrong = Some(error.to_string());
                return Drawn { paths: pen.done, wrong, repeated: pen.repeated };
            }
        }
    }
    pen.lift(false);
    Drawn { paths: pen.done, wrong: None, repeated: pen.repeated }
}

/// Follows path data in the units of the file; what it draws is in millimetres.
struct Pen<'a> {
    map: &'a Transform2,
    tolerance: f64,
    at: Point2,
    start: Point2,
    /// The control point that a smooth curve mirrors.
    control: Option<Control>,
    drawn: Vec<Segment>,
    done: Vec<Polyarc>,
    /// Lines without length.
    repeated: usize,
}

#[derive(Clone, Copy)]
enum Control {
    Cubic(Point2),
    Quadratic(Point2),
}

impl<'a> Pen<'a> {
    fn new(map: &'a Transform2, tolerance: f64) -> Self {
        let (at, start) = (Point2::default(), Point2::default());
        let (drawn, done) = (Vec::new(), Vec::new());
        Self { map, tolerance, at, start, control: None, drawn, done, repeated: 0 }
    }

    /// A place of a command, relative to the pen unless it is absolute.
    fn place(&self, abs: bool, x: f64, y: f64) -> Point2 {
        if abs { Point2::new(x, y) } else { self.at + Vec2::new(x, y) }
    }

    fn follow(&mut self, segment: &PathSegment) {
        use PathSegment as S;
        match *segment {
            S::MoveTo { abs, x, y } => {
                self.lift(false);
                self.at = self.place(abs, x, y);
                self.start = self.at;
                self.control = None;
            }
            S::LineTo { abs, x, y } => self.line(self.place(abs, x, y)),
            S::HorizontalLineTo { abs, x } => {
                let x = if abs { x } else { self.at.x + x };
                self.line(Point2::new(x, self.at.y));
            }
            S::VerticalLineTo { abs, y } => {
                let y = if abs { y } else { self.at.y + y };
                self.line(Point2::new(self.at.x, y));
            }
            S::CurveTo { abs, x1, y1, x2, y2, x, y } => {
                let (a, b) = (self.place(abs, x1, y1), self.place(abs, x2, y2));
                self.cubic(a, b, self.place(abs, x, y));
            }
            S::SmoothCurveTo { abs, x2, y2, x, y } => {
                let a = match self.control {
                    Some(Control::Cubic(before)) => self.at + (self.at - before),
                    _ => self.at,
                };
                self.cubic(a, self.place(abs, x2, y2), self.place(abs, x, y));
            }
            S::Quadratic { abs, x1, y1, x, y } => {
                self.quadratic(self.place(abs, x1, y1), self.place(abs, x, y));
            }
            S::SmoothQuadratic { abs, x, y } => {
                let control = match self.control {
                    Some(Control::Quadratic(before)) => self.at + (self.at - before),
                    _ => self.at,
                };
                self.quadratic(control, self.place(abs, x, y));
            }
            S::EllipticalArc { abs, rx, ry, x_axis_rotation, large_arc, sweep, x, y } => {
                let rotation_deg = x_axis_rotation;
                let words = ArcWords { rx, ry, rotation_deg, large: large_arc, sweep };
                self.arc(self.place(abs, x, y), &words);
            }
            S::ClosePath { .. } => {
                self.lift(true);
                self.at = self.start;
                self.control = None;
            }
        }
    }

    fn line(&mut self, to: Point2) {
        self.repeated += usize::from(to == self.at);
        self.draw(&[Segment::line(self.map.apply(self.at), self.map.apply(to))]);
        (self.at, self.control) = (to, None);
    }

    fn cubic(&mut self, a: Point2, b: Point2, to: Point2) {
        let points = [self.at, a, b, to].map(|point| self.map.apply(point));
        self.draw_path(&Bezier { points }.polyarc(self.tolerance));
        (self.at, self.control) = (to, Some(Control::Cubic(b)));
    }

    fn quadratic(&mut self, control: Point2, to: Point2) {
        let [a, b, c] = [self.at, control, to].map(|point| self.map.apply(point));
        self.draw_path(&Bezier::quadratic(a, b, c).polyarc(self.tolerance));
        (self.at, self.control) = (to, Some(Control::Quadratic(control)));
    }

    fn arc(&mut self, to: Point2, words: &ArcWords) {
        match ellipse(self.at, to, words) {
            None if to == self.at => {}
            None => self.line(to),
            Some(ellipse) => {
                let path = mapped(&ellipse, self.map, self.tolerance);
                self.draw_path(&path);
                (self.at, self.control) = (to, None);
            }
        }
    }

    fn draw_path(&mut self, path: &Polyarc) {
        let segments: Vec<Segment> = path.segments().collect();
        self.draw(&segments);
    }

    fn draw(&mut self, segments: &[Segment]) {
        let long = segments.iter().filter(|segment| segment.length() > tol::SAME_PLACE_MM);
        self.drawn.extend(long.copied());
    }

    /// Ends the path being drawn.
    fn lift(&mut self, close: bool) {
        let drawn = std::mem::take(&mut self.drawn);
        let Some((first, last)) = drawn.first().zip(drawn.last()) else { return };
        let (start, end) = (first.start(), last.end());
        let meets = start.distance(end) <= tol::SAME_PLACE_MM;
        let mut segments = drawn.clone();
        if close && !meets {
            segments.push(Segment::line(end, start));
        }
        self.done.push(Polyarc::from_segments(&segments, close || meets && drawn.len() > 1));
    }
}

/// An arc of an ellipse under a map, always open: a full circle where it is one.
pub fn mapped(ellipse: &Ellipse, map: &Transform2, tolerance: f64) -> Polyarc {
    let turned = Ellipse {
        centre: map.apply(ellipse.centre),
        major: map.turn(ellipse.major),
        minor: map.turn(ellipse.minor),
        ..*ellipse
    };
    let sweep = turned.to_rad - turned.from_rad;
    let parts = 4u32;
    let share = |n: u32| turned.from_rad + sweep * f64::from(n) / f64::from(parts);
    let breaks: Vec<f64> = (0..=parts).map(share).collect();
    if is_circle(&turned) {
        let turn = turned.major.cross(turned.minor).signum();
        let from = (turned.at(turned.from_rad).0 - turned.centre).angle();
        return Polyarc::arc(turned.centre, turned.major.length(), from, sweep * turn);
    }
    curve(&|t| turned.at(t), &breaks, tolerance)
}

fn is_circle(ellipse: &Ellipse) -> bool {
    let (a, b) = (ellipse.major, ellipse.minor);
    let size = a.dot(a);
    a.dot(b).abs() <= 1e-12 * size && (size - b.dot(b)).abs() <= 1e-12 * size
}
