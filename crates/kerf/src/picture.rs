//! From the events of a run to a picture.

use crate::args::OperatorArgs;
use crate::out;
use crate::picture_format::PictureFormat;
use crate::report::Diagnostics;
use crate::setup::PreparedRun;
use anyhow::Result;
use kerf_control::{RunContext, Session};
use kerf_diag::{Repetitions, Severity};
use kerf_journal::Work;
use kerf_preview::{Finding, Options, Scene, Segment, Shape, TableView, ToolPath, Trail};
use kerf_program::settings::{AxisUnit, MM_PER_INCH};
use kerf_program::{Axis, Settings};
use kerf_trace::{
    Event, Sink, Summary, ToolPathTime,
    event::{ArcEvent, Location, MoveEvent},
};
use std::path::Path;

/// Kinds of file that a picture of a tool path is written as.
const WRITTEN: [PictureFormat; 3] = [PictureFormat::Svg, PictureFormat::Png, PictureFormat::Html];

/// Returns the kind of picture that the ending of a file names.
pub fn format_of(path: &Path) -> Result<PictureFormat> {
    PictureFormat::of(path, "pictures", &WRITTEN)
}

/// Collects the scene of a run.
#[derive(Debug)]
pub struct Picture {
    scene: Scene,
    /// Its motion.
    trail: Trail,
    /// Millimetres in the user's unit.
    mm: f64,
    /// Findings that come again and again.
    again: Repetitions,
}

impl Picture {
    /// An empty scene with a heading.
    pub fn new(title: &Path) -> Self {
        let title = title.file_name().unwrap_or_default().to_string_lossy().into_owned();
        Self {
            scene: Scene { title, ..Scene::default() },
            mm: MM_PER_INCH,
            trail: Trail::default(),
            again: Repetitions::default(),
        }
    }

    /// Runs what is prepared, with its findings told, and takes the picture of it.
    pub fn follow(mut job: PreparedRun, title: &Path, operator: &OperatorArgs) -> (Scene, Summary) {
        let surface_mm = match &job.work {
            Work::Job(_, machine) => Some(machine.zpos.surface_mm),
            _ => None,
        };
        let mut sink = (Diagnostics::default(), Self::new(title));
        let mut pace = operator.script();
        let context = RunContext {
            sink: &mut sink,
            operator: &mut job.answers,
            requests: &mut pace,
            machine: kerf_control::simulated(),
        };
        let summary = job.session.run(job.work, job.options, &mut job.workspace, context);
        let mut scene = sink.1.finish(&summary, &job.session);
        if let Some(surface_mm) = surface_mm {
            let frame = &job.session.memory.frame;
            scene.surface_z_mm = surface_mm + frame.base_zero.0[2] - frame.working_zero.0[2];
        }
        (scene, summary)
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
        (self.scene.simulate, self.scene.draw_tool) = (view.simulate, view.draw_tool);
        self.scene.cutter_mm = memory.settings.cutter.diameter_mm;
        self.scene.cutter_known = self.scene.cutter_mm != Settings::default().cutter.diameter_mm;
        let rotary = memory.settings.axis_count > 4
            && memory.settings.axis_unit(Axis::B) == AxisUnit::Degrees;
        if !rotary {
            self.trail.turns_deg.clear();
        }
        self.tell_thinned();
        self.scene.duration_s = summary.seconds;
        (self.scene.cut_mm, self.scene.jog_mm) = (tally.cut_mm, tally.jog_mm);
        self.scene.bounds = tally.bounds;
        self.scene.lines_executed = summary.lines;
        self.scene.toolpaths = tally.toolpaths.iter().map(|path| self.toolpath(path)).collect();
        let Trail { segments, times_s, turns_deg, .. } = self.trail;
        Scene { segments, times_s, turns_deg, ..self.scene }
    }

    /// A long program is drawn without its smallest bends.
    fn tell_thinned(&mut self) {
        let off_mm = self.trail.tolerance_mm();
        if off_mm == 0.0 {
            return;
        }
        let (made, drawn) = (self.trail.moves(), self.trail.segments.len());
        let text = format!(
            "{made} moves are drawn as {drawn}: bends below {off_mm:.3} mm are left out of the picture"
        );
        self.scene.findings.push(Finding { severity: Severity::Note, text, line: 0 });
    }

    fn toolpath(&self, path: &ToolPathTime) -> ToolPath {
        let first_segment = self.trail.segment_of(path.first_move as u32);
        let (name, tool) = (path.name.to_string(), path.tool.to_string());
        ToolPath { name, tool, seconds: path.seconds, first_segment }
    }

    fn segment(&mut self, made: &MoveEvent, shape: Shape) {
        let point = |p: Location| [p.x * self.mm, p.y * self.mm, p.z * self.mm];
        let (from, to) = (point(made.from), point(made.to));
        let segment = Segment { kind: made.kind, from, to, shape, line: made.line };
        self.trail.push(segment, made.t1 as f32, [made.from.b as f32, made.to.b as f32]);
    }

    fn arc(&mut self, arc: &ArcEvent) {
        let far = |centre: f64| (centre * self.mm).abs() > kerf_preview::FARTHEST_MM;
        if far(arc.centre.x) || far(arc.centre.y) {
            // So far away that nobody tells the arc from a line.
            return self.segment(&arc.made, Shape::Line);
        }
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
            Event::Clear { .. } => self.trail.clear(),
            Event::Diag(d) if d.severity != Severity::Note && self.again.is_new(d) => {
                self.scene.findings.push(Finding {
                    severity: d.severity,
                    text: d.message.clone(),
                    line: d.place.line,
                })
            }
            _ => {}
        }
    }
}

/// Writes a picture to a file.
pub fn write(scene: &Scene, format: PictureFormat, path: &Path) -> Result<()> {
    let options = Options::default();
    let bytes = match format {
        PictureFormat::Svg => kerf_preview::svg(scene, &options).into_bytes(),
        PictureFormat::Html => kerf_preview::html(scene, &options).into_bytes(),
        _ => kerf_preview::png(scene, &options)?,
    };
    out::file(path, bytes)
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use kerf_control::RunContext;
    use kerf_files::MemoryDisk;
    use kerf_journal::RunOptions;
    use kerf_program::Axes;
    use kerf_workspace::Workspace;

    /// The scene of a program, lines separated by `⏎`, with the tool at (1, 1) in.
    fn scene_as(before: &str, program: &str, preview: bool) -> Scene {
        let mut session = Session::default();
        session.memory.position = Axes::xyz(MM_PER_INCH, MM_PER_INCH, 0.0);
        let mut workspace = Workspace::in_memory(MemoryDisk::default());
        let mut one = |text: &str, options: RunOptions| {
            let program = kerf_sbp::read("part.sbp".into(), text.replace('⏎', "\n").as_bytes());
            let mut sink = Picture::new(Path::new("part.sbp"));
            let context = RunContext {
                sink: &mut sink,
                operator: &mut (),
                requests: &mut (),
                machine: kerf_control::simulated(),
            };
            let summary = session.run(program, options, &mut workspace, context);
            sink.finish(&summary, &session)
        };
        one(before, RunOptions::default());
        let mut options = RunOptions::default();
        options.program.preview = preview;
        one(program, options)
    }

    fn scene(program: &str) -> Scene {
        scene_as("", program, false)
    }

    fn start(scene: &Scene) -> [f64; 2] {
        let from = scene.segments[0].from;
        [from[0] / MM_PER_INCH, from[1] / MM_PER_INCH]
    }

    #[test]
    fn sbp_cmd_sp_start() {
        let (here, zero) = (scene("SP⏎MX,5⏎SM"), scene("VP,,,,,,,0⏎SP⏎MX,5⏎SM"));
        assert_eq!((start(&here), start(&zero)), ([1.0, 1.0], [0.0, 0.0]));
        assert_eq!(here.segments[0].to[1], MM_PER_INCH);
        assert_eq!(zero.segments[0].to[1], 0.0);
    }

    #[test]
    fn sbp_val_vp_start() {
        assert_eq!(start(&scene_as("", "MX,5", true)), [1.0, 1.0]);
        assert_eq!(start(&scene_as("VP,,,,,,,0", "MX,5", true)), [0.0, 0.0]);
        // Only previews start elsewhere.
        assert_eq!(start(&scene_as("VP,,,,,,,0", "MX,5", false)), [1.0, 1.0]);
    }

    #[test]
    fn sbp_cmd_sp_clear() {
        assert_eq!(scene("SP⏎MX,5⏎MY,5").segments.len(), 2);
        assert_eq!(scene("SP⏎MX,5⏎MY,5⏎SP").segments.len(), 0);
        let again = scene("SP⏎MX,5⏎SP⏎MX,6");
        assert_eq!((again.segments.len(), again.times_s.len()), (1, 1));
    }

    #[test]
    fn sbp_val_vp_simulate() {
        let page = |program: &str| kerf_preview::html(&scene(program), &Options::default());
        assert!(page("MX,5").contains("\"simulate\":false"));
        assert!(page("VP,,,,,1⏎MX,5").contains("\"simulate\":true"));
    }

    #[test]
    fn sbp_val_vp_drawtool() {
        let page = |program: &str| kerf_preview::html(&scene(program), &Options::default());
        assert!(page("MX,5").contains("\"draw_tool\":true"));
        assert!(page("VP,,,,,,0⏎MX,5").contains("\"draw_tool\":false"));
    }

    #[test]
    fn sbp_val_vp_rotary() {
        // The bounds of the path on the cylinder, from where the tool is at (1, 0) in; nothing where there is no toggle.
        let rolled = |program: &str| -> Option<[[f64; 3]; 2]> {
            let page = kerf_preview::html(&scene_as("J2,1,0", program, false), &Options::default());
            let (_, facts) = page.split_once("\"rolled\":").unwrap();
            let mut read = serde_json::Deserializer::from_str(facts).into_iter();
            read.next().unwrap().unwrap()
        };
        let check = |program: &str, inches: [[f64; 3]; 2]| {
            let found = rolled(program).unwrap();
            for (mm, inch) in found.into_iter().flatten().zip(inches.into_iter().flatten()) {
                assert!((mm - inch * MM_PER_INCH).abs() < 1e-3, "{program}: {found:?} {inches:?}");
            }
        };
        assert_eq!((rolled("M5,1,0,-.1,0,90"), rolled("VD,,4⏎MX,5")), (None, None));
        // About the axis of a blank of 6 inches: what is cut when B is at 90 has come to the side.
        check("VD,,5⏎M5,1,0,-.1,0,90", [[1.0, -2.9, -3.0], [1.0, 0.0, 0.0]]);
        // At the other side, and below.
        check("VD,,5⏎M5,1,0,-.1,0,-90", [[1.0, 0.0, -3.0], [1.0, 2.9, 0.0]]);
        check("VD,,5⏎MZ,-.1⏎M5,1,0,-.1,0,180", [[1.0, -2.9, -5.9], [1.0, 0.0, 0.0]]);
        // Nothing turns: it lies as it is cut.
        check("VD,,5⏎M5,3,0,-.1,0,0", [[1.0, 0.0, -0.1], [3.0, 0.0, 0.0]]);
        let turned = scene("VD,,5⏎M5,1,0,-.1,0,90⏎MB,45");
        assert_eq!(turned.turns_deg, [[0.0, 90.0], [90.0, 45.0]]);
    }

    #[test]
    fn sbp_val_vd_axes() {
        let rotary = |count: u8| scene(&format!("VD,,{count}⏎MX,2")).turns_deg.len();
        assert_eq!((rotary(3), rotary(4), rotary(5)), (0, 0, 1));
    }

    #[test]
    fn a_cutter_that_nobody_chose_is_told_and_not_drawn() {
        let picture = |program: &str| kerf_preview::svg(&scene(program), &Options::default());
        assert!(picture("MZ,-.1⏎MX,5").contains("cutter 0.25 in (default)"));
        assert!(picture("VC,.5⏎MZ,-.1⏎MX,5").contains("cutter 0.5 in wide"));
    }
}
