//! A job as a part program, in whatever language the printer writes.
//!
//! ```text
//!  ZTop ──►─┐   ┌──►   the head travels at ZTop, plunges, cuts, rises; a closed path goes to its next
//!           │   │      pass straight down, an open one by way of ZTop (readings, P-41)
//!           └─►─┘
//! ```
//!
//! The origin of the program is the job's origin, its Z zero ZSurface.

use crate::depth::{Depths, Heights};
use crate::job::{CutPath, Job, too_deep};
use crate::neutral::plunge;
use crate::shape_paths::Pass;
use crate::warning::Warning;
use kerf_drawing::{Group, Kind};
use kerf_geom::{Point2, Polyarc, Segment};
use kerf_program::job::Plunge;
use kerf_program::{
    AXES, Arc, At, Axes, Command, Feed, Hold, Line, MoveKind, Printer, Sourced, ToolPathStart,
};

/// The output of the router or spindle, as OpenSBP and the writers of G-code have it.
const ROUTER: u8 = 1;

/// Chords that a machine without arcs makes of a full circle.
const CHORDS: u32 = 360;

/// Writes a job.
///
/// # Errors
/// Paths that would go below ZBottom; then nothing was written.
pub fn print(job: &Job, heights: &Heights, printer: &mut dyn Printer) -> Result<(), Vec<Warning>> {
    let wrong = too_deep(job, heights);
    if !wrong.is_empty() {
        return Err(wrong);
    }
    let depths = job.paths.iter().map(|path| job.depths(path, heights));
    let surface = heights.surface_mm;
    let rest = Spot { at: Point2::default(), z: surface };
    let (at, top) = (At::default(), heights.top_mm);
    let mut writing = Writing { printer, surface, top, at, group: None, head: rest };
    job.drawing.comments().iter().for_each(|line| writing.printer.comment(line));
    writing.command(Command::Output { number: ROUTER, on: true });
    let first = job.start.saturating_sub(1);
    for (path, depths) in job.paths.iter().zip(depths.flatten()).skip(first) {
        writing.path(path, job, &depths);
    }
    writing.jog_up();
    writing.command(Command::Output { number: ROUTER, on: false });
    writing.jog_to(job.finish.unwrap_or_default());
    Ok(())
}

struct Writing<'a> {
    printer: &'a mut dyn Printer,
    surface: f64,
    top: f64,
    at: At,
    group: Option<Group>,
    /// Place of the head.
    head: Spot,
}

/// A place of the head: in the plane and above home.
#[derive(Clone, Copy, PartialEq)]
struct Spot {
    at: Point2,
    z: f64,
}

impl Writing<'_> {
    fn path(&mut self, path: &CutPath, job: &Job, depths: &Depths) {
        // The line is the shape's number: it is what a person knows.
        self.at.line = u32::try_from(path.from).unwrap_or_default();
        self.name_group(path.shape.group, job);
        self.jog_up();
        self.jog_to(path.shape.start());
        if path.shape.pause {
            let text = format!("Shape {}", path.from);
            self.printer.hold(&Hold { at: self.at, text, until: None });
        }
        let feed = feed(job, path.shape.group);
        match (path.pass, depths) {
            (Pass::Traversal, Depths::Level(_)) => self.travel(&path.shape.path),
            (Pass::Traversal, Depths::Along(base)) => self.cut_along(path, *base, Feed::Axis),
            (_, Depths::Along(base)) => self.cut_along(path, *base, feed),
            (_, Depths::Level(levels)) => {
                let settings = job.drawing.settings(path.shape.group);
                self.passes(path, levels, feed, plunge(settings, path.room_mm));
            }
        }
    }

    fn name_group(&mut self, group: Group, job: &Job) {
        if self.group != Some(group) {
            self.group = Some(group);
            let tool = job.drawing.settings(group).tool.to_string();
            let (name, tool) = (Some(group.name().into()), Some(tool.as_str().into()));
            self.command(Command::ToolPath(ToolPathStart { name, tool }));
        }
    }

    fn passes(&mut self, path: &CutPath, levels: &[f64], feed: Feed, plunge: Plunge) {
        let start = path.shape.start();
        let mut before = self.surface;
        for (n, z) in levels.iter().enumerate() {
            if n > 0 && !path.shape.is_closed() && path.shape.kind() != Kind::Point {
                self.jog_up();
                self.jog_to(start);
            }
            let slopes = plunge.slopes(&path.shape.path, before, *z);
            let straight = if slopes.is_empty() { *z } else { before };
            self.line(MoveKind::Cut, Spot { at: start, z: straight }, Feed::Axis);
            for slope in slopes {
                self.segment(&slope.segment, slope.z_mm, feed);
            }
            for segment in path.shape.path.segments() {
                self.segment(&segment, *z, feed);
            }
            before = *z;
        }
    }

    fn cut_along(&mut self, path: &CutPath, base: f64, feed: Feed) {
        let shape = &path.shape;
        let count = shape.path.vertices.len();
        let z = |n: usize| base + shape.height_mm(n % count);
        self.line(MoveKind::Cut, Spot { at: shape.start(), z: z(0) }, Feed::Axis);
        for (n, segment) in shape.path.segments().enumerate() {
            self.segment(&segment, z(n + 1), feed);
        }
    }

    /// Follows a path at the height of travel.
    fn travel(&mut self, path: &Polyarc) {
        let z = self.top;
        for segment in path.segments() {
            self.segment(&segment, z, Feed::Axis);
        }
    }

    fn segment(&mut self, segment: &Segment, z: f64, feed: Feed) {
        let end = Spot { at: segment.end(), z };
        match *segment {
            Segment::Line { .. } => self.line(MoveKind::Cut, end, feed),
            Segment::Arc { centre, sweep_rad, .. } => {
                self.head = end;
                let (kind, to) = (MoveKind::Cut, self.axes(end));
                let centre = [centre.x, centre.y];
                let arc = Arc { kind, centre, sweep_rad, to, feed, chords: CHORDS, small: false };
                self.command(Command::Arc(arc));
            }
        }
    }

    /// Straight up to the height of travel.
    fn jog_up(&mut self) {
        let up = Spot { z: self.top, ..self.head };
        if up != self.head {
            self.line(MoveKind::Jog, up, Feed::Axis);
        }
    }

    fn jog_to(&mut self, at: Point2) {
        let to = Spot { at, z: self.top };
        if to != self.head {
            self.line(MoveKind::Jog, to, Feed::Axis);
        }
    }

    fn line(&mut self, kind: MoveKind, to: Spot, feed: Feed) {
        self.head = to;
        let to = self.axes(to);
        self.command(Command::Line(Line { kind, to, feed }));
    }

    fn axes(&self, spot: Spot) -> Axes {
        let mut axes = [0.0; AXES];
        (axes[0], axes[1], axes[2]) = (spot.at.x, spot.at.y, spot.z - self.surface);
        Axes(axes)
    }

    fn command(&mut self, command: Command) {
        self.printer.command(&Sourced { at: self.at, command });
    }
}

fn feed(job: &Job, group: Group) -> Feed {
    let speed = job.drawing.settings(group).speed_mm_min;
    speed.map_or(Feed::Axis, |mm_min| Feed::Path(mm_min / 60.0))
}
