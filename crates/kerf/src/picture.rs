//! From the events of a run to a picture.

use crate::exit::Usage;
use anyhow::{Context, Result, bail};
use kerf_control::event::{ArcEvent, MoveEvent, Place};
use kerf_control::{Event, Session, Sink, Summary, ToolPathTime};
use kerf_diag::Severity;
use kerf_preview::{Finding, Options, Scene, Segment, Shape, TableView, ToolPath};
use kerf_program::settings::MM_PER_INCH;
use std::fs;
use std::path::Path;

/// The kinds of picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Vector graphics.
    Svg,
    /// Pixels.
    Png,
    /// A page that turns in 3D.
    Html,
}

impl Format {
    /// By the extension of the file to write.
    pub fn of(path: &Path) -> Result<Self> {
        let extension = path.extension().unwrap_or_default().to_string_lossy().to_lowercase();
        Ok(match extension.as_str() {
            "svg" => Self::Svg,
            "png" => Self::Png,
            "html" | "htm" => Self::Html,
            _ => bail!(Usage(format!("{}: pictures end in .svg, .png or .html", path.display()))),
        })
    }
}

/// Collects the scene of a run.
#[derive(Debug)]
pub struct Picture {
    scene: Scene,
    /// Millimetres in the user's unit.
    mm: f64,
    /// Segments that were cleared away.
    cleared: usize,
}

impl Picture {
    /// An empty scene with a heading.
    pub fn new(title: &Path) -> Self {
        let title = title.file_name().unwrap_or_default().to_string_lossy().into_owned();
        Self { scene: Scene { title, ..Scene::default() }, mm: MM_PER_INCH, cleared: 0 }
    }

    /// The scene with the facts that are known when the run is over.
    pub fn finish(mut self, summary: &Summary, session: &Session) -> Scene {
        let memory = &session.memory;
        let tally = &summary.tally;
        let low = memory.settings.limits.low;
        let corner =
            |i: usize| low.0[i] + memory.frame.base_zero.0[i] - memory.frame.working_zero.0[i];
        let view = &memory.settings.view;
        self.scene.unit = summary.unit.into();
        self.scene.table = Some(TableView {
            origin: [corner(0), corner(1)],
            size_mm: view.table_mm,
            grid_mm: view.grid_mm,
        });
        self.scene.show_jogs = view.show_jogs;
        self.scene.cutter_mm = memory.settings.cutter.diameter_mm;
        self.scene.duration_s = summary.seconds;
        (self.scene.cut_mm, self.scene.jog_mm) = (tally.cut_mm, tally.jog_mm);
        self.scene.bounds = tally.bounds;
        self.scene.lines_executed = summary.lines;
        self.scene.toolpaths = tally.toolpaths.iter().map(|path| self.toolpath(path)).collect();
        self.scene
    }

    fn toolpath(&self, path: &ToolPathTime) -> ToolPath {
        let first_segment = (path.first_move as usize).saturating_sub(self.cleared);
        let (name, tool) = (path.name.to_string(), path.tool.to_string());
        ToolPath { name, tool, seconds: path.seconds, first_segment }
    }

    fn segment(&mut self, made: &MoveEvent, shape: Shape) {
        let point = |p: Place| [p.x * self.mm, p.y * self.mm, p.z * self.mm];
        let (from, to) = (point(made.from), point(made.to));
        self.scene.segments.push(Segment { kind: made.kind, from, to, shape, line: made.line });
        self.scene.times_s.push(made.t1 as f32);
    }

    fn arc(&mut self, arc: &ArcEvent) {
        let sweep_rad = arc.sweep.to_radians();
        self.segment(
            &arc.made,
            Shape::Arc {
                centre: [arc.centre.x * self.mm, arc.centre.y * self.mm],
                sweep_rad: if arc.dir == "cw" { -sweep_rad } else { sweep_rad },
            },
        );
    }
}

impl Sink for Picture {
    fn event(&mut self, event: &Event) {
        match event {
            Event::Start { units, .. } | Event::Units { units, .. } => {
                self.mm = if *units == "mm" { 1.0 } else { MM_PER_INCH };
            }
            Event::Move(made) => self.segment(made, Shape::Line),
            Event::Arc(arc) => self.arc(arc),
            Event::Clear { .. } => {
                self.cleared += self.scene.segments.len();
                self.scene.segments.clear();
                self.scene.times_s.clear();
            }
            Event::Diag(d) if d.severity != Severity::Note => self.scene.findings.push(Finding {
                severity: d.severity,
                text: d.message.clone(),
                line: d.place.line,
            }),
            _ => {}
        }
    }
}

/// Writes a picture to a file.
pub fn write(scene: &Scene, format: Format, path: &Path) -> Result<()> {
    let options = Options::default();
    let bytes = match format {
        Format::Svg => kerf_preview::svg(scene, &options).into_bytes(),
        Format::Html => kerf_preview::html(scene, &options).into_bytes(),
        Format::Png => kerf_preview::png(scene, &options)?,
    };
    fs::write(path, bytes).with_context(|| format!("cannot write {}", path.display()))
}
