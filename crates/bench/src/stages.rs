//! The stages of a preview, one after the other, each timed in this process.

use crate::figure::{Figure, Goal, timed};
use crate::inputs::Input;
use anyhow::Result;
use kerf_control::answers::Answers;
use kerf_control::{RunContext, Session};
use kerf_files::MemoryDisk;
use kerf_journal::RunOptions;
use kerf_motion::{Move, Mover, plan_stack};
use kerf_program::testing::Still;
use kerf_program::{Axes, Command, Settings};
use kerf_sbp::{Interpreter, Options, Program, Step};
use kerf_workspace::Workspace;

/// Lines that a real file may execute here: some wait for ever for what is not there.
const MOST_LINES: u64 = 100_000;

/// Lines between two looks at the commands.
const LINES_A_LOOK: u64 = 4096;

/// Every stage of an input.
pub fn figures(input: &Input) -> Result<Vec<Figure>> {
    let mut figures = vec![read(input)?, interpret(input)?];
    if input.files.len() == 1 {
        figures.push(plan(input)?);
    }
    figures.push(preview(input)?);
    Ok(figures)
}

fn read(input: &Input) -> Result<Figure> {
    let files = || input.files.iter().map(|(_, bytes)| bytes.clone()).collect::<Vec<_>>();
    let read = |bytes| kerf_sbp::read("".into(), bytes);
    let (count, cpu_s, wall_s) = timed(
        files,
        |files| files.into_iter().map(read).collect::<Vec<Program>>(),
        |programs| programs.iter().map(|program| program.lines.len() as u64).sum(),
    )?;
    let goal = match input.name {
        "m3-1m" => Some(Goal::Rate(10e6)),
        "logic-100k" => Some(Goal::Rate(2e6)),
        _ => None,
    };
    Ok(Figure {
        input: input.name,
        stage: "read",
        count,
        unit: "lines",
        cpu_s,
        wall_s,
        peak: None,
        goal,
    })
}

fn interpret(input: &Input) -> Result<Figure> {
    let files = || input.files.iter().map(|(_, bytes)| bytes.clone()).collect::<Vec<_>>();
    let (count, cpu_s, wall_s) = timed(
        files,
        |files| files.into_iter().map(|bytes| interpreted(bytes, &mut drop)).sum::<u64>(),
        |lines| *lines,
    )?;
    let goal = match input.name {
        "m3-1m" => Some(Goal::Rate(4e6)),
        "logic-100k" => Some(Goal::Rate(2e6)),
        _ => None,
    };
    let stage = "read and interpret to moves";
    Ok(Figure { input: input.name, stage, count, unit: "lines", cpu_s, wall_s, peak: None, goal })
}

/// Reads and runs a program without a machine; gives its moves away and the lines it executed.
fn interpreted(bytes: Vec<u8>, take: &mut impl FnMut(Move)) -> u64 {
    let program = kerf_sbp::read("".into(), bytes);
    let options =
        Options { max_lines: 2 * MOST_LINES.max(program.lines.len() as u64), ..Options::default() };
    let settings = Settings::default();
    let mut interpreter = Interpreter::new(program, kerf_sbp::Session::default(), options);
    let mut mover = Mover::new(Axes::default(), &settings);
    let mut out = Vec::new();
    loop {
        let step = interpreter.run(&mut Still, &mut out, LINES_A_LOOK);
        for sourced in out.drain(..) {
            let made = match &sourced.command {
                Command::Line(line) => mover.line(sourced.at, line),
                Command::Arc(arc) => mover.arc(sourced.at, arc),
                Command::Settings(settings) => {
                    mover.settings(settings);
                    None
                }
                _ => None,
            };
            made.into_iter().for_each(&mut *take);
        }
        if matches!(step, Step::Done(..)) {
            return interpreter.lines();
        }
    }
}

fn plan(input: &Input) -> Result<Figure> {
    let mut moves = Vec::new();
    for (_, bytes) in &input.files {
        interpreted(bytes.clone(), &mut |made| moves.push(made));
    }
    let ramps = Settings::default().ramps;
    let (count, cpu_s, wall_s) = timed(
        || moves.clone(),
        |moves| plan_stack(moves, &ramps),
        |plan| plan.moves().len() as u64,
    )?;
    let stage = "plan, one stack";
    let goal = (input.name == "m3-1m").then_some(Goal::Rate(5e6));
    Ok(Figure { input: input.name, stage, count, unit: "moves", cpu_s, wall_s, peak: None, goal })
}

/// All that `kerf time` does, without a process, a file and the words at the end.
fn preview(input: &Input) -> Result<Figure> {
    let files = || {
        input.files.iter().map(|(name, bytes)| (name.clone(), bytes.clone())).collect::<Vec<_>>()
    };
    let (count, cpu_s, wall_s) = timed(
        files,
        |files| files.into_iter().map(|(name, bytes)| previewed(&name, bytes)).sum::<u64>(),
        |lines| *lines,
    )?;
    let stage = "preview in one process";
    Ok(Figure {
        input: input.name,
        stage,
        count,
        unit: "lines",
        cpu_s,
        wall_s,
        peak: None,
        goal: None,
    })
}

fn previewed(name: &str, bytes: Vec<u8>) -> u64 {
    let program = kerf_sbp::read(name.into(), bytes);
    let max_lines = 2 * MOST_LINES.max(program.lines.len() as u64);
    let program_options = Options { max_lines, preview: true, ..Options::default() };
    let options = RunOptions { program: program_options, ..RunOptions::default() };
    let mut workspace = Workspace::in_memory(MemoryDisk::new([]));
    let context = RunContext {
        sink: &mut (),
        operator: &mut Answers::default(),
        requests: &mut (),
        machine: kerf_control::simulated(),
    };
    Session::default().run(program, options, &mut workspace, context).lines
}
