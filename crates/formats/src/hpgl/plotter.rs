//! A plotter that remembers what it has drawn.

use super::instructions::Instruction;
use super::packed::{Step, steps};
use super::scale::Scale;
use crate::finding::Findings;
use kerf_drawing::{Drawing, Group, Shape};
use kerf_geom::{Point2, Polyarc, Vec2, Vertex, tol};

/// Angle of the chords that stand for an arc whose scale is not the same in both directions, degrees: the
/// plotters' own.
const CHORD_DEG: f64 = 5.0;

/// State of a plotter between two instructions. Places are in the units of the file.
#[derive(Debug, Default)]
pub(super) struct Plotter {
    scale: Scale,
    at: Point2,
    down: bool,
    /// Nothing was drawn since the pen went down.
    lowered: bool,
    relative: bool,
    /// The pen: none before the first SP, 0 when it was put away.
    pen: Option<u32>,
    /// Path that the pen has drawn since it went down, millimetres.
    run: Vec<Vertex>,
    /// A polygon is being defined (PM); `polygon` has its contours.
    in_polygon: bool,
    polygon: Vec<Polyarc>,
    /// The line of the instruction at hand.
    line: u32,
    /// Shapes that were drawn: the pen, the line at which it was done, the shape.
    shapes: Vec<(u32, u32, Shape)>,
}

/// Instructions that change how lines look, what paper is used or how the plotter talks: no paths.
const LOOKS: &[&[u8; 2]] = &[
    b"AC", b"AD", b"BP", b"CF", b"CO", b"CP", b"CR", b"CS", b"CA", b"DI", b"DR", b"DT", b"DV",
    b"EC", b"ES", b"FI", b"FN", b"FR", b"FS", b"FT", b"IW", b"LA", b"LO", b"LT", b"MC", b"MG",
    b"MT", b"NP", b"NR", b"OE", b"OI", b"OS", b"PC", b"PG", b"PS", b"PT", b"PW", b"PP", b"QL",
    b"RF", b"SA", b"SB", b"SD", b"SI", b"SL", b"SM", b"SR", b"SS", b"ST", b"SV", b"TD", b"TL",
    b"TR", b"UL", b"VS", b"WU", b"XT", b"YT", b"IM", b"CT",
];

impl Plotter {
    /// Carries out an instruction; what it cannot do is told.
    pub fn carry_out(&mut self, instruction: &Instruction<'_>, findings: &mut Findings) {
        let Instruction { name, numbers, bytes, line } = instruction;
        self.line = *line;
        match name {
            b"IN" | b"DF" => self.begin_anew(),
            b"SP" => self.take(numbers.first().copied().unwrap_or_default()),
            b"PU" => self.lift_or_lower(false, numbers),
            b"PD" => self.lift_or_lower(true, numbers),
            b"PA" => self.moves(false, numbers),
            b"PR" => self.moves(true, numbers),
            b"AA" | b"AR" => self.arc(*name == *b"AR", numbers, findings, *line),
            b"AT" | b"RT" => self.arc_through(*name == *b"RT", numbers, findings, *line),
            b"CI" => self.circle(numbers, findings, *line),
            b"EA" | b"RA" | b"ER" | b"RR" => self.rectangle(name, numbers, findings, *line),
            b"EW" | b"WG" => self.wedge(numbers, findings, *line),
            b"PE" => steps(bytes).into_iter().for_each(|step| self.step(step)),
            b"PM" => self.polygon_mode(numbers.first().copied().unwrap_or_default()),
            b"EP" | b"FP" => self.draw_polygon(),
            b"IP" | b"IR" | b"SC" | b"RO" => self.rescale(name, numbers, findings, *line),
            b"LB" | b"PB" => findings.skip("lettering"),
            _ if LOOKS.contains(&name) => {}
            _ => findings.skip(&String::from_utf8_lossy(name)),
        }
    }

    /// The drawing, each pen a group, and the shapes of each pen. What lies too far away is told and left out.
    pub fn finish(mut self, findings: &mut Findings) -> (Drawing, Vec<(String, Vec<usize>)>) {
        self.end_run();
        self.shapes.retain(|(_, line, shape)| {
            let wrong = shape.path.check().err();
            wrong.iter().for_each(|why| findings.warn("place", *line, format!("{why}: left out")));
            wrong.is_none()
        });
        let mut layers: Vec<(u32, Vec<usize>)> = Vec::new();
        for (n, (pen, ..)) in self.shapes.iter().enumerate() {
            match layers.iter_mut().find(|layer| layer.0 == *pen) {
                Some(layer) => layer.1.push(n),
                None => layers.push((*pen, vec![n])),
            }
        }
        let layers = layers.into_iter().map(|(pen, shapes)| (format!("pen {pen}"), shapes));
        (Drawing::of(self.shapes.into_iter().map(|(.., shape)| shape)), layers.collect())
    }

    fn begin_anew(&mut self) {
        self.end_run();
        let shapes = std::mem::take(&mut self.shapes);
        *self = Self { shapes, pen: self.pen, ..Self::default() };
    }

    fn take(&mut self, pen: f64) {
        self.end_run();
        self.pen = Some(pen.clamp(0.0, 255.0) as u32);
    }

    fn lift_or_lower(&mut self, down: bool, numbers: &[f64]) {
        self.set_down(down);
        self.moves(self.relative, numbers);
    }

    fn set_down(&mut self, down: bool) {
        if down == self.down {
            return;
        }
        self.down = down;
        if !self.in_polygon {
            self.end_run();
            self.lowered = down;
        }
    }

    fn moves(&mut self, relative: bool, numbers: &[f64]) {
        self.relative = relative;
        for pair in numbers.chunks_exact(2) {
            let by = Vec2::new(pair[0], pair[1]);
            self.line_to(if relative { self.at + by } else { Point2::default() + by });
        }
    }

    fn line_to(&mut self, to: Point2) {
        self.curve_to(to, 0.0);
    }

    /// On to a place, along a line or an arc.
    fn curve_to(&mut self, to: Point2, bulge: f64) {
        self.at = to;
        if !self.down && !self.in_polygon {
            return;
        }
        let at = self.scale.place(to);
        match self.run.last_mut() {
            Some(last) if last.at.distance(at) <= tol::SAME_PLACE_MM => {}
            Some(last) => {
                last.bulge = if self.scale.mirrors() { -bulge } else { bulge };
                self.run.push(Vertex { at, bulge: 0.0 });
            }
            None => self.run.push(Vertex { at, bulge: 0.0 }),
        }
    }

    fn step(&mut self, step: Step) {
        match step {
            Step::Pen(pen) => self.take(pen),
            Step::Move { down, absolute, by } => {
                self.set_down(down);
                self.line_to(if absolute { Point2::default() + by } else { self.at + by });
            }
        }
    }

    /// AA x,y,angle and AR: an arc about a centre.
    fn arc(&mut self, relative: bool, numbers: &[f64], findings: &mut Findings, line: u32) {
        let [x, y, degrees, ..] = *numbers else { return too_few(findings, line) };
        let by = Vec2::new(x, y);
        let centre = if relative { self.at + by } else { Point2::default() + by };
        self.swing(centre, degrees.clamp(-360.0, 360.0));
    }

    /// Along an arc about a centre, in pieces of a half circle at the most.
    fn swing(&mut self, centre: Point2, degrees: f64) {
        let exact = self.scale.keeps_circles();
        let largest = if exact { 180.0 } else { CHORD_DEG };
        let pieces = (degrees.abs() / largest).ceil().max(1.0);
        let step = (degrees / pieces).to_radians();
        let spoke = self.at - centre;
        let bulge = if exact { (0.25 * step).tan() } else { 0.0 };
        for n in 1..=pieces as usize {
            self.curve_to(centre + spoke.rotated(step * n as f64), bulge);
        }
    }

    /// AT and RT: an arc through a place to another.
    fn arc_through(&mut self, relative: bool, numbers: &[f64], findings: &mut Findings, line: u32) {
        let [x, y, u, v, ..] = *numbers else { return too_few(findings, line) };
        let base = if relative { self.at } else { Point2::default() };
        let (middle, end) = (base + Vec2::new(x, y), base + Vec2::new(u, v));
        let (a, b) = (middle - self.at, end - self.at);
        let double_area = 2.0 * a.cross(b);
        let straight = double_area.abs() <= 1e-9 * (a.dot(a) + b.dot(b));
        if straight {
            return self.line_to(end);
        }
        // The circle's centre from the bisectors of two chords.
        let (aa, bb) = (a.dot(a), b.dot(b));
        let centre = self.at
            + Vec2::new((b.y * aa - a.y * bb) / double_area, (a.x * bb - b.x * aa) / double_area);
        let (from, to) = (self.at - centre, end - centre);
        let turn = from.cross(to).atan2(from.dot(to)).to_degrees();
        let ccw = double_area > 0.0;
        let degrees = match (ccw, turn > 0.0) {
            (true, false) => turn + 360.0,
            (false, true) => turn - 360.0,
            _ => turn,
        };
        self.swing(centre, degrees);
        self.at = end;
    }

    /// CI radius: a circle about the place of the pen, drawn whether it is down or up.
    fn circle(&mut self, numbers: &[f64], findings: &mut Findings, line: u32) {
        let Some(radius) = numbers.first().map(|r| r.abs()).filter(|r| *r > 0.0) else {
            return too_few(findings, line);
        };
        let centre = self.at;
        self.apart(|plotter| {
            plotter.begin_at(centre + Vec2::new(radius, 0.0));
            plotter.swing(centre, 360.0);
        });
    }

    /// EA, RA to a corner and ER, RR by a distance: the outline, filled or not.
    fn rectangle(&mut self, name: &[u8; 2], numbers: &[f64], findings: &mut Findings, line: u32) {
        let [x, y, ..] = *numbers else { return too_few(findings, line) };
        let relative = matches!(name, b"ER" | b"RR");
        let base = if relative { self.at } else { Point2::default() };
        let (low, high) = (self.at, base + Vec2::new(x, y));
        self.apart(|plotter| {
            plotter.begin_at(low);
            let corners = [(high.x, low.y), (high.x, high.y), (low.x, high.y), (low.x, low.y)];
            corners.iter().for_each(|(x, y)| plotter.line_to(Point2::new(*x, *y)));
        });
    }

    /// EW and WG radius,start,sweep: a piece of cake.
    fn wedge(&mut self, numbers: &[f64], findings: &mut Findings, line: u32) {
        let [radius, start, sweep, ..] = *numbers else { return too_few(findings, line) };
        let centre = self.at;
        self.apart(|plotter| {
            plotter.begin_at(centre);
            plotter.line_to(centre + Vec2::from_angle(start.to_radians()) * radius);
            plotter.swing(centre, sweep.clamp(-360.0, 360.0));
            plotter.line_to(centre);
        });
    }

    /// Draws a figure of its own; then the pen is where and as it was.
    fn apart(&mut self, draw: impl FnOnce(&mut Self)) {
        let (at, down) = (self.at, self.down);
        self.lowered = false;
        self.lift();
        draw(self);
        self.lift();
        self.at = at;
        self.set_down(down);
        self.lowered = false;
    }

    fn lift(&mut self) {
        self.set_down(false);
        self.end_run();
        self.run.clear();
    }

    fn begin_at(&mut self, at: Point2) {
        self.at = at;
        self.set_down(true);
        if self.run.is_empty() {
            self.run.push(self.here());
        }
    }

    /// PM 0 begins a polygon, 1 its next contour, 2 ends it.
    fn polygon_mode(&mut self, mode: f64) {
        self.end_run();
        self.run.clear();
        match mode {
            0.0 => {
                self.polygon.clear();
                self.in_polygon = true;
                self.run.push(self.here());
            }
            2.0 => {
                self.in_polygon = false;
                self.end_run();
            }
            _ => {}
        }
    }

    fn draw_polygon(&mut self) {
        self.end_run();
        for contour in self.polygon.clone() {
            self.keep(contour);
        }
    }

    /// Makes a shape of what was drawn, or a contour of the polygon; a pen that is down begins the next. A pen that
    /// goes down and up again has drawn a point.
    fn end_run(&mut self) {
        let vertices = std::mem::take(&mut self.run);
        let dot = std::mem::take(&mut self.lowered) && !self.in_polygon;
        match vertices.len() {
            0 => {}
            1 if !dot => {}
            _ if self.in_polygon => self.polygon.push(path(vertices, true)),
            _ => self.keep(path(vertices, false)),
        }
        if self.down || self.in_polygon {
            self.run.push(self.here());
        }
    }

    /// Returns the place of the pen, millimetres.
    fn here(&self) -> Vertex {
        Vertex { at: self.scale.place(self.at), bulge: 0.0 }
    }

    fn keep(&mut self, path: Polyarc) {
        let pen = self.pen.unwrap_or(1);
        if pen > 0 {
            let group = Group::ALL[(pen as usize - 1) % Group::ALL.len()];
            self.shapes.push((pen, self.line, Shape::flat(path).in_group(group)));
        }
    }

    /// IP, SC, RO: the place of the pen on the paper stays.
    fn rescale(&mut self, name: &[u8; 2], numbers: &[f64], findings: &mut Findings, line: u32) {
        let place = self.scale.place(self.at);
        match name {
            b"IP" => self.scale.corners(numbers),
            b"RO" => self.scale.turn(numbers.first().copied().unwrap_or_default()),
            b"SC" if self.scale.user(numbers) => {}
            b"SC" => findings.warn("scale", line, "SC without a size: the scale stays as it was"),
            _ => findings.skip("IR"),
        }
        self.at = self.scale.units(place);
        if !self.scale.keeps_circles() {
            findings.note(
                "scale",
                line,
                "X and Y have different scales: arcs become chords of 5 degrees",
            );
        }
    }
}

/// A path; it is closed when its end is its start, or when it must be.
fn path(mut vertices: Vec<Vertex>, must_close: bool) -> Polyarc {
    let ends = vertices.first().zip(vertices.last());
    let returns = ends.is_some_and(|(a, b)| a.at.distance(b.at) <= tol::SAME_PLACE_MM);
    let closed = vertices.len() > 2 && returns;
    if closed {
        vertices.pop();
    }
    Polyarc { vertices, closed: closed || must_close }
}

fn too_few(findings: &mut Findings, line: u32) {
    findings.warn("numbers", line, "numbers are missing: the instruction is left out");
}
