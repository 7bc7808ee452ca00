//! A job as a part program: the very commands of its run, as far as part programs have words for them.
//!
//! ```text
//!  ZTop ──►─┐   ┌──►   the head rises to ZTop, travels, plunges, cuts, rises; between the passes of a path it
//!           │   │      goes by way of ZTop where an open path begins elsewhere than it ends (readings, P-41)
//!           └─►─┘
//! ```
//!
//! The origin of the program is the job's origin, its Z zero ZSurface. The router is its output 1. A part program
//! knows no plasma start, no height control, no beam and no knife: the path is written without them, and a
//! [`Lost`] tells of each.

use crate::begin::lies;
use crate::place::Stage;
use crate::sequence::Sequence;
use crate::step::Step;
use kerf_diag::Diagnostic;
use kerf_geom::Point2;
use kerf_machine::Configuration;
use kerf_machine::State;
use kerf_machine::lines::Output;
use kerf_machine::settings::delays::BottomDelayType;
use kerf_machine::settings::job::Heads;
use kerf_program::job::Job;
use kerf_program::{At, Axes, Axis, Command, Feed, Hold, Lost, Printer, Sourced, Step as Stepped};
use std::sync::Arc;

/// The output of the router or spindle, as OpenSBP and the writers of G-code have it.
const ROUTER: u8 = 1;

/// Speeds of a part program where the groups of the job name none.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Speeds {
    /// Those with which the machine at hand cuts the job: the program takes as long.
    Written,
    /// Those of the machine that runs the program.
    OfRun,
}

/// Writes a job as the machine cuts it, once; what is noticed on the way is returned.
///
/// # Errors
/// A path that would go below ZBottom; then nothing was written.
pub fn print(
    job: &Job,
    machine: &Configuration,
    speeds: Speeds,
    printer: &mut dyn Printer,
) -> Result<Vec<Diagnostic>, Box<Diagnostic>> {
    let (machine, mut lost) = plain(machine);
    if job.shapes.iter().any(|shape| (shape.tool, shape.cut) != (1, 1)) {
        lost.push(("the tool and cut outputs of its groups", false));
    }
    let surface_mm = machine.zpos.surface_mm;
    let mut cut = sequence(job, machine);
    if let Some(low) = cut.too_low_to_cut() {
        return Err(Box::new(low));
    }
    for (what, is_motion) in lost {
        printer.lose(Lost { at: At::default(), what: what.into(), is_motion });
    }
    let mut writing = Writing { printer, surface_mm, speeds, noticed: Vec::new() };
    while writing.step(&mut cut) {}
    Ok(writing.noticed)
}

/// The machine as far as part programs have words for it, and what is left out; `true` where the tool would go
/// another way with it.
fn plain(machine: &Configuration) -> (Configuration, Vec<(&'static str, bool)>) {
    let mut plain = machine.clone();
    let by_input = plain.delays.bottom_type == BottomDelayType::Input;
    let parts = [
        ("the start of a plasma cut", plain.plasma.use_sequence, false),
        ("the piercing and the gas of a laser", plain.laser.use_laser, false),
        ("the intensity of a beam", plain.intensity.output, false),
        ("height control", plain.height.on, true),
        ("the turns of a knife", plain.misc.tangential, true),
        ("a second head", plain.job.heads == Heads::Both, true),
        ("the input that ends the bottom delay", by_input, false),
    ];
    plain.plasma.use_sequence = false;
    plain.laser.use_laser = false;
    plain.intensity.output = false;
    plain.height.on = false;
    plain.misc.tangential = false;
    plain.job.heads = Heads::default();
    plain.delays.bottom_type = BottomDelayType::default();
    plain.job.change_origin_at_start = false;
    plain.job.repeats = 1;
    let lost = parts.into_iter().filter(|(_, used, _)| *used);
    (plain, lost.map(|(what, _, is_motion)| (what, is_motion)).collect())
}

/// The job at its origin, begun: the head rises to the height of travel first, wherever it stands.
fn sequence(job: &Job, machine: Configuration) -> Sequence {
    let [_, finish] = lies(job, &machine);
    let (origin, finish) = (Some(Point2::default()), Some(finish));
    let job = Job { origin, finish, repeats: 1, ..job.clone() };
    let stands = Axes::xyz(0.0, 0.0, machine.zpos.surface_mm);
    let mut cut = Sequence::new(Arc::new(job), Arc::new(machine), stands);
    (cut.progress.stage, cut.halt.state) = (Stage::Approach, State::Running);
    cut.queue.steps = cut.schedule().approach(true).into();
    cut
}

/// The step at hand goes at a speed that the group of the shape names.
fn names_speed(cut: &Sequence) -> bool {
    let along = matches!(cut.queue.steps.front(), Some(Step::Slope | Step::Follow));
    let shape = cut.progress.here.shape(&cut.setup.job).filter(|shape| !shape.traversal);
    along && shape.is_some_and(|shape| shape.speed_mm_s.is_some())
}

struct Writing<'a> {
    printer: &'a mut dyn Printer,
    surface_mm: f64,
    speeds: Speeds,
    noticed: Vec<Diagnostic>,
}

impl Writing<'_> {
    /// Carries out the next step, of which all is over at once; `false` at the end.
    fn step(&mut self, cut: &mut Sequence) -> bool {
        let mut out = Vec::new();
        let at = cut.progress.at(&cut.setup.job);
        let named = names_speed(cut);
        let more = match cut.queue.steps.pop_front() {
            None => cut.advance(&mut out) == Stepped::Ran,
            Some(Step::Ask) => {
                let text = cut.question().text;
                self.printer.hold(&Hold { at, text, until: None });
                cut.answered("continue");
                true
            }
            Some(step) => {
                cut.begin_step(&step, &mut out);
                true
            }
        };
        let named = named || self.speeds == Speeds::Written;
        out.into_iter().for_each(|sourced| self.write(sourced, named));
        more
    }

    /// Writes a command in the places of the program; what only a run tells is left out.
    fn write(&mut self, Sourced { at, command }: Sourced, named: bool) {
        let feed = |feed| if named { feed } else { Feed::Axis };
        let command = match command {
            Command::Output { number, on } if number == Output::Router.number() => {
                Command::Output { number: ROUTER, on }
            }
            Command::Line(mut line) => {
                line.to[Axis::Z] -= self.surface_mm;
                line.feed = feed(line.feed);
                Command::Line(line)
            }
            Command::Arc(mut arc) => {
                arc.to[Axis::Z] -= self.surface_mm;
                arc.feed = feed(arc.feed);
                Command::Arc(arc)
            }
            Command::Diagnostic(noticed) => return self.noticed.push(*noticed),
            Command::Wait { .. } | Command::ToolPath(_) => command,
            _ => return,
        };
        self.printer.command(&Sourced { at, command });
    }
}
