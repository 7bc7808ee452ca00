//! A job and its part program are one work: the same path, in the same time, on the same machine.

use crate::simulated::dice::Dice;
use crate::simulated::jobs;
use kerf_control::answers::Answers;
use kerf_control::{RunContext, Script, Session};
use kerf_files::MemoryDisk;
use kerf_geom::Point2;
use kerf_journal::RunOptions;
use kerf_ledger::jobs::{JobRun, sim};
use kerf_machine::Configuration;
use kerf_machine::profile::profile;
use kerf_program::job::{Job, JobShape};
use kerf_program::settings::LinearUnit;
use kerf_program::{MoveKind, RampModel, Status};
use kerf_sbp::{Printing, SbpPrinter};
use kerf_sequence::Speeds;
use kerf_trace::{Event, Summary};
use kerf_workspace::Workspace;
use std::sync::Arc;

/// Times of a job and its part program that differ by less are equal: the printer's own tolerance of speeds.
const SAME_SHARE: f64 = 0.005;

/// Places of a part program are rounded, and CG corrects its centre, mm.
const SAME_MM: f64 = 1e-3;

/// The job as a part program in millimetres.
fn part_program(job: &Job, machine: &Configuration) -> String {
    let printing = Printing { unit: LinearUnit::Mm, ..Printing::default() };
    let mut printer = Box::new(SbpPrinter::new(&printing));
    let noticed = kerf_sequence::print(job, machine, Speeds::Written, printer.as_mut());
    assert!(noticed.is_ok(), "{noticed:?}");
    kerf_program::Printer::finish(printer).text
}

/// Runs a part program on the machine, its zero at the surface of the material.
fn run(text: String, machine: &Configuration) -> (Vec<Event>, Summary) {
    let (mut session, mut events) = (Session::default(), Vec::new());
    session.memory.settings = machine.program.clone();
    session.memory.settings.use_linear_unit(LinearUnit::Mm);
    session.memory.settings.limits.check = false;
    session.machine_is = Arc::new(machine.clone());
    let mut workspace = Workspace::in_memory(MemoryDisk::new(std::iter::empty()));
    let (mut operator, mut requests) = (Answers::default(), Script::new(Vec::new(), Vec::new()));
    let context = RunContext {
        sink: &mut events,
        operator: &mut operator,
        requests: &mut requests,
        machine: kerf_control::simulated(),
    };
    let program = kerf_part::read("job.sbp".into(), text.into_bytes());
    let summary = session.run(program, RunOptions::default(), &mut workspace, context);
    (events, summary)
}

/// The places where cutting moves end, heights counted from the surface.
fn cut_to(events: &[Event], surface_mm: f64) -> Vec<[f64; 3]> {
    let moves = events.iter().filter_map(|event| match event {
        Event::Move(made) => Some(made),
        Event::Arc(arc) => Some(&arc.made),
        _ => None,
    });
    let cuts = moves.filter(|made| made.kind == MoveKind::Cut);
    cuts.map(|made| [made.to.x, made.to.y, made.to.z - surface_mm]).collect()
}

/// A shape as part programs can say it: OpenSBP knows no circular jog, so that a traversal round arcs is a cut there.
fn spoken(shape: &JobShape) -> JobShape {
    let arcs = shape.path.vertices.iter().any(|vertex| vertex.bulge != 0.0);
    JobShape { traversal: shape.traversal && !arcs, ..shape.clone() }
}

/// Holds the part program of a job against the job; `false` for a job that does not run to its end.
fn check(told: &str, job: Job, machine: &Configuration) -> bool {
    let shapes = job.shapes.iter().map(spoken).collect();
    let job = Job { shapes, origin: Some(Point2::default()), repeats: 1, ..job };
    let cut = JobRun::new(job.clone()).with(|own| *own = machine.clone()).run();
    if cut.summary.status != Status::Ok {
        return false;
    }
    let text = part_program(&job, machine);
    let (events, summary) = run(text.clone(), machine);
    assert_eq!(summary.status, Status::Ok, "{told}: {:?}\n{text}", summary.error);
    let (ours, theirs) = (cut.summary.seconds, summary.seconds);
    assert!(
        (ours - theirs).abs() <= SAME_SHARE * ours,
        "{told}: the job takes {ours} s, its part program {theirs} s\n{text}"
    );
    let way = |summary: &Summary| summary.tally.cut_mm + summary.tally.jog_mm;
    let (ours, theirs) = (way(&cut.summary), way(&summary));
    assert!((ours - theirs).abs() <= SAME_MM * ours, "{told}: {ours} mm and {theirs} mm\n{text}");
    // A part program may part an arc; it leaves no place out.
    let mut program = cut_to(&events, 0.0).into_iter();
    for place in cut_to(&cut.events, machine.zpos.surface_mm) {
        let near = |at: &[f64; 3]| (0..3).all(|i| (at[i] - place[i]).abs() < SAME_MM);
        assert!(program.any(|at| near(&at)), "{told}: nothing is cut to {place:?}\n{text}");
    }
    true
}

/// A router with a model of ramps, or with that of a machine which names none.
fn router(dice: &mut Dice) -> Configuration {
    let router = profile("router-96x48").and_then(|ready| ready.configuration().ok());
    let usual = [sim(), Configuration::default(), router.unwrap_or_default()];
    let mut machine = usual[dice.below(usual.len())].clone();
    let models = [RampModel::Shopbot, RampModel::Profiler, RampModel::Optimal];
    machine.program.ramp_model =
        dice.of(&[None, Some(models[0]), Some(models[1]), Some(models[2])]);
    machine.program.warning_s = 0.0;
    machine.delays.router_start_s = dice.of(&[0.0, 2.0]);
    machine.delays.bottom_s = dice.of(&[0.0, 0.2]);
    machine.delays.end_s = dice.of(&[0.0, 0.25]);
    machine.speeds.plunge_mm_s = dice.between(5.0, 25.0);
    machine
}

#[test]
fn a_job_and_its_part_program_take_the_same_path_and_the_same_time() {
    let mut checked = 0;
    for seed in 1..=200 {
        let mut dice = Dice::new(seed);
        let (machine, job) = (router(&mut dice), jobs::random(&mut dice));
        checked += u32::from(check(&format!("seed {seed}"), job, &machine));
    }
    assert!(checked > 100, "only {checked} jobs ran");
}

#[test]
fn the_jobs_of_the_examples_and_their_part_programs_are_one() {
    let text = include_bytes!("../../../../examples/10-from-a-drawing/from-a-drawing.rsg");
    let (job, _) = kerf_toolpath::job(&kerf_formats::rsg::read(text).drawing).expect("a job");
    for model in [None, Some(RampModel::Profiler), Some(RampModel::Optimal)] {
        let mut machine = Configuration::default();
        machine.program.ramp_model = model;
        assert!(check(&format!("{model:?}"), job.machine_job("job.rsm".into()), &machine));
    }
}

/// The lines of the part program of a job on SIM, and what it does not say.
fn written(
    job: &Job,
    speeds: Speeds,
    change: impl FnOnce(&mut Configuration),
) -> (String, Vec<String>) {
    let mut machine = sim();
    change(&mut machine);
    let printing = Printing { unit: LinearUnit::Mm, ..Printing::default() };
    let mut printer = Box::new(SbpPrinter::new(&printing));
    let noticed = kerf_sequence::print(job, &machine, speeds, printer.as_mut());
    assert_eq!(noticed, Ok(Vec::new()));
    let written = kerf_program::Printer::finish(printer);
    (written.text, written.lost.into_iter().map(|lost| lost.what).collect())
}

#[test]
fn the_router_is_off_while_a_part_program_waits_at_a_pause_mark() {
    let mut job = kerf_ledger::jobs::t2();
    job.shapes = job
        .shapes
        .iter()
        .cloned()
        .map(|shape| JobShape { pause: shape.number == 2, ..shape })
        .collect();
    let (text, lost) = written(&job, Speeds::Written, |_| {});
    assert_eq!(lost, Vec::<String>::new());
    let waits = "SO,1,0\n'Shape 2\nPAUSE\nSO,1,1\nPAUSE 2\n";
    assert!(text.contains(waits), "{text}");
}

#[test]
fn what_part_programs_have_no_words_for_is_told() {
    let job = kerf_ledger::jobs::t1();
    let (_, lost) = written(&job, Speeds::Written, |machine| {
        machine.plasma.use_sequence = true;
        machine.height.on = true;
    });
    assert_eq!(lost, ["the start of a plasma cut", "height control"]);
}

#[test]
fn a_conversion_leaves_speeds_to_the_machine_that_runs_it() {
    let job = kerf_ledger::jobs::t1();
    assert!(written(&job, Speeds::Written, |_| {}).0.contains("VS,100"));
    let own = written(&job, Speeds::OfRun, |_| {}).0;
    assert!(!own.lines().any(|line| line.starts_with("VS,,,,,")), "{own}");
}
