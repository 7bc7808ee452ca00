//! Previews: a run on copies, and its path in pieces that a page can draw.
//!
//! ```text
//!  program ── Session::run, as a preview ──► Collector ──► Path ──► coarser ──► coarser …
//!                                                            └─ piece ─► bytes over HTTP
//! ```
//!
//! The timing chart is another run of the same kind, made when somebody asks for it.

mod basis;
mod charts;
mod collect;
mod path;
mod pen;
mod rotary;
mod samples;
mod thumbnail;
mod timing;
mod typed;

pub use basis::Basis;
pub use charts::{Answer, Asked, Chart, Charts};
pub use path::Path;
pub use thumbnail::{thumbnail, thumbnail_of};
pub use timing::timing;
pub use typed::Typed;

use crate::job_findings;
use crate::locks::lock;
use crate::machine::Planned;
use crate::to_wire;
use collect::Collector;
use kerf_control::answers::Answers;
use kerf_control::{DrivenBy, OperatorRequest, OwnTime, Requests, RunContext, Session};
use kerf_journal::{RunOptions, Work};
use kerf_machine::Configuration;
use kerf_program::settings::Mode;
use kerf_program::{Axis, Frame, Settings};
use kerf_sbp::{FileParameters, Status};
use kerf_sequence::straddling;
use kerf_trace::{Sink, Summary, Tally};
use kerf_wire::preview::{Detail, PreviewInfo, Timing, ToolPathInfo};
use kerf_wire::{Finding, SampleAnswer};
use kerf_workspace::Workspace;
use samples::Samples;
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex};

/// Segments that a page can turn smoothly.
const FEW: usize = 40_000;

/// Lines that a preview executes, and commands that it carries out: a program that waits for something in a loop never ends by itself.
const MOST_LINES: u64 = 5_000_000;

/// A preview that is ready.
#[derive(Debug)]
pub struct Preview {
    /// Facts that pages are told of it.
    pub info: PreviewInfo,
    /// The path, from all of it to the coarsest.
    pub paths: Vec<Path>,
    /// The same on the cylinder that a rotary axis turns, where there is one.
    pub rolled: Option<Rolled>,
    /// The moves, as whoever follows the run needs them.
    pub planned: Planned,
    /// The findings.
    pub findings: Vec<Finding>,
    /// Questions of the program, with their answers.
    pub samples: Vec<SampleAnswer>,
    /// It has mistakes that keep it from running at all.
    pub failed: bool,
    /// The settings and frame that it was made with.
    pub start: (Settings, Frame),
    /// The machine that a job was made with.
    pub machine: Option<Arc<Configuration>>,
    /// The controller in whose time it is told.
    pub driven_by: Option<DrivenBy>,
    /// The height map that it follows.
    pub height_map: Option<kerf_wire::HeightMap>,
    /// Other program files that it called, as they were.
    pub called: Called,
    /// The timing chart without inputs that was made last, and what its run began with.
    timing: Mutex<Option<(Basis, Arc<Timing>)>>,
}

/// A path on a cylinder.
#[derive(Debug)]
pub struct Rolled {
    /// Facts that pages are told of it.
    pub info: PreviewInfo,
    /// The path, from all of it to the coarsest.
    pub paths: Vec<Path>,
}

impl Preview {
    /// Returns `true` if the machine is not any more what it was made with.
    pub fn is_stale(&self, session: &Session) -> bool {
        let pace = |by: &Option<DrivenBy>| by.as_ref().and_then(|by| by.pace.clone());
        if pace(&self.driven_by) != pace(&session.driven_by) {
            return true;
        }
        match &self.machine {
            // A job brings its own frame.
            Some(machine) => **machine != session.configuration(),
            None => self.start != (session.memory.settings.clone(), session.memory.frame),
        }
    }

    /// The timing chart without inputs, if it was made and its run would begin with the same now.
    pub fn timing(&self, session: &Session) -> Option<Arc<Timing>> {
        let made = lock(&self.timing);
        let (_, timing) = made.as_ref().filter(|(basis, _)| *basis == Basis::of(session))?;
        Some(timing.clone())
    }

    /// Keeps the timing chart without inputs.
    pub fn keep_timing(&self, basis: Basis, timing: Arc<Timing>) {
        *lock(&self.timing) = Some((basis, timing));
    }
}

/// Program files on the disk and their bytes.
pub type Called = BTreeMap<PathBuf, Arc<[u8]>>;

/// Ends a dry run that nobody waits for any more.
pub struct Until<'a>(pub &'a AtomicBool);

impl Requests for Until<'_> {
    fn take(&mut self, from_s: f64, _: f64) -> Option<(f64, OperatorRequest)> {
        self.0.load(Ordering::Relaxed).then_some((from_s, OperatorRequest::End))
    }
}

/// Makes a preview on a copy of a session; nothing when it was given up.
pub fn make(
    work: Work,
    parameters: FileParameters,
    session: Session,
    workspace: &mut Workspace,
    given_up: &AtomicBool,
) -> Option<Preview> {
    let failed = matches!(&work, Work::Part(program) if program.has_errors());
    let not_cut = not_cut(&work);
    let (work, machine) = unattended(work);
    let is_job = machine.is_some();
    let start = (session.memory.settings.clone(), session.memory.frame);
    let height_map = to_wire::height_map(workspace);
    let driven_by = session.driven_by.clone();
    let mut sink = (Collector::of(&session), own_time(driven_by.as_ref()));
    let (summary, cutter_mm, samples) =
        silently(work, options(parameters), session, workspace, given_up, &mut sink)?;
    let (mut sink, own) = sink;
    let summary = in_own_time(summary, own.map(|own| sink.retime(own)));
    let failed = failed || is_job && summary.status == Status::Failed;
    let called = workspace.take_called();
    let mut made = finish(sink, &summary, start, cutter_mm, is_job);
    made.findings.extend(not_cut);
    Some(Preview { samples, failed, machine, height_map, called, driven_by, ..made })
}

/// Counts a run in the time of the controller that makes it, where that plans for itself.
fn own_time(driven_by: Option<&DrivenBy>) -> Option<OwnTime<'_>> {
    driven_by?.pace.as_ref().map(OwnTime::of_run)
}

/// The summary of a run with the seconds and counts of the controller that makes it.
fn in_own_time(summary: Summary, own: Option<(f64, Tally)>) -> Summary {
    match own {
        None => summary,
        Some((seconds, tally)) => Summary { seconds, tally, ..summary },
    }
}

/// The paths of a job that lie on both jigs, told before it is started: its preview waits for none.
fn not_cut(work: &Work) -> Vec<Finding> {
    let Work::Job(job, machine) = work else { return Vec::new() };
    straddling(job, machine).into_iter().map(job_findings::warning).collect()
}

/// The plan of a run from its beginning, for whoever goes on with it; answers are as they are by default.
pub fn plan(
    work: Work,
    options: RunOptions,
    session: Session,
    workspace: &mut Workspace,
) -> Planned {
    let (work, machine) = unattended(work);
    let mut options = RunOptions { controller: None, ..options };
    (options.program.preview, options.program.max_lines) = (true, MOST_LINES);
    options.program.file.stepped = false;
    let driven_by = session.driven_by.clone();
    let mut sink = (Collector::of(&session), own_time(driven_by.as_ref()));
    silently(work, options, session, workspace, &AtomicBool::new(false), &mut sink);
    let (mut sink, own) = sink;
    own.map(|own| sink.retime(own));
    sink.plan.finish(machine.is_some())
}

/// Returns the options with which a preview runs.
fn options(parameters: FileParameters) -> RunOptions {
    let mut options = RunOptions::default();
    options.program.preview = true;
    options.program.file = parameters;
    options.program.max_lines = MOST_LINES;
    options.most_commands = MOST_LINES;
    options
}

/// Runs on a copy of a session, with the answers beside its file, else by default; nothing when it was given up.
/// With it comes the diameter of the cutter at its end, as the program may have said which it cuts with, and what was
/// asked.
fn silently(
    work: Work,
    options: RunOptions,
    mut session: Session,
    workspace: &mut Workspace,
    given_up: &AtomicBool,
    sink: &mut dyn Sink,
) -> Option<(Summary, f64, Vec<SampleAnswer>)> {
    // In preview mode moves take no time: the picture tells how long they take when they are cut.
    session.memory.settings.mode = Mode::Move;
    let beside = workspace.answers_beside(&work.name());
    let mut samples = Samples::of(Answers::read(&beside.unwrap_or_default()));
    let context = RunContext {
        sink,
        operator: &mut samples,
        requests: &mut Until(given_up),
        machine: kerf_control::simulated(),
    };
    let summary = session.run(work, options, workspace, context);
    let cutter_mm = session.memory.settings.cutter.diameter_mm;
    (!given_up.load(Ordering::Relaxed)).then_some((summary, cutter_mm, samples.asked))
}

/// A job that waits for no door, no jig and no second Start: its preview shows what is cut. With it comes the
/// machine that cuts it.
fn unattended(work: Work) -> (Work, Option<Arc<Configuration>>) {
    let Work::Job(job, machine) = work else { return (work, None) };
    let mut alone = (*machine).clone();
    (alone.misc.double_start, alone.job.external_start, alone.job.two_jigs) = (false, false, false);
    (Work::Job(job, Arc::new(alone)), Some(machine))
}

fn finish(
    mut sink: Collector,
    summary: &Summary,
    start: (Settings, Frame),
    cutter_mm: f64,
    is_job: bool,
) -> Preview {
    sink.tell_rest();
    let mut info = PreviewInfo { cutter: cutter_mm, ..info(&sink, summary, &start) };
    let turns_deg = sink.pen.turns_deg.take();
    info.rotary = turns_deg.is_some();
    let rolled = turns_deg.map(|turns| roll(&sink.pen.path, &turns, &info, &start.0));
    let paths = details(sink.pen.path);
    info.details = paths.iter().map(Path::detail).collect();
    Preview {
        info,
        paths,
        rolled,
        planned: sink.plan.finish(is_job),
        findings: sink.findings.iter().map(kerf_language::finding).collect(),
        samples: Vec::new(),
        failed: false,
        start,
        machine: None,
        driven_by: None,
        height_map: None,
        called: Called::new(),
        timing: Mutex::default(),
    }
}

fn roll(path: &Path, turns_deg: &[f32], info: &PreviewInfo, settings: &Settings) -> Rolled {
    let path = rotary::rolled(path, turns_deg, info.zero, settings.view.table_mm[2]);
    let bounds = path.cut_bounds();
    let paths = details(path);
    let details = paths.iter().map(Path::detail).collect();
    Rolled { info: PreviewInfo { bounds, details, ..info.clone() }, paths }
}

/// The path, and coarser ones of which each has a quarter of the segments at most.
fn details(path: Path) -> Vec<Path> {
    let mut tolerance = path.diagonal() / 8000.0;
    let mut paths = vec![path];
    while let Some(last) = paths.last().filter(|last| last.len() > FEW) {
        let most = (last.len() / 4).max(FEW);
        let mut coarser = last.coarser(tolerance);
        while coarser.len() > most && tolerance.is_normal() {
            tolerance *= 2.0;
            coarser = last.coarser(tolerance);
        }
        if coarser.len() >= last.len() {
            break;
        }
        paths.push(coarser);
    }
    paths
}

fn info(sink: &Collector, summary: &Summary, (settings, frame): &(Settings, Frame)) -> PreviewInfo {
    let (tally, view) = (&summary.tally, &settings.view);
    let low = |axis: Axis| settings.limits.low[axis] + frame.base_zero[axis];
    let toolpath = |path: &kerf_trace::ToolPathTime| ToolPathInfo {
        name: path.name.to_string(),
        tool: path.tool.to_string(),
        seconds: path.seconds,
        first_move: path.first_move as u32,
    };
    PreviewInfo {
        origin: sink.pen.path.origin(),
        zero: frame.working_zero.first3(),
        table: [low(Axis::X), low(Axis::Y)],
        table_size: [view.table_mm[0], view.table_mm[1]],
        grid: view.grid_mm,
        bounds: sink.pen.path.cut_bounds(),
        cutter: settings.cutter.diameter_mm,
        seconds: summary.seconds,
        cut: tally.cut_mm,
        jog: tally.jog_mm,
        moves: sink.plan.moves(),
        rotary: false,
        details: vec![Detail::default()],
        toolpaths: tally.toolpaths.iter().map(toolpath).collect(),
    }
}
