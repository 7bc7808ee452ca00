//! The `kerf` command as a person starts it: a process of its own, with its time and peak memory.
//!
//! Linux tells the peak memory of a child only when it is over, as the greatest of all children so
//! far, and counts what its parent had when it was started. So this program starts itself, small and
//! fresh, for each run, and that process starts `kerf`.

use crate::figure::{self, Figure, Goal, Spread};
use crate::inputs::Input;
use crate::usage::{self, Usage};
use anyhow::{Context, Result, ensure};
use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Instant;
use std::{env, fs};

/// The word that makes this program the small parent.
pub const PARENT: &str = "--parent-of";

/// Time and memory that a process took.
pub struct Taken {
    /// By the clock on the wall.
    pub seconds: f64,
    /// Of the processor.
    pub cpu_s: f64,
    /// Memory, bytes.
    pub peak: f64,
}

/// The commands on an input.
pub fn figures(input: &Input) -> Result<Vec<Figure>> {
    let folder = tempfile::tempdir().context("no folder for part files")?;
    let [(name, bytes)] = &input.files[..] else { return Ok(Vec::new()) };
    let file = folder.path().join(name);
    fs::write(&file, bytes)?;
    let picture = folder.path().join("picture.svg");
    let commands: [(&'static str, &str, Vec<&Path>); 3] = [
        ("kerf time", "time", vec![&file]),
        ("kerf trace", "trace", vec![&file]),
        ("kerf preview -o x.svg", "preview", vec![&file, Path::new("-o"), &picture]),
    ];
    let lines = input.lines();
    let mut figures = Vec::new();
    for (stage, command, arguments) in commands {
        let goal =
            (stage == "kerf time" && input.name == "m3-1m").then_some(Goal::Within(0.5, 300e6));
        let mut words = vec![OsStr::new(command)];
        words.extend(arguments.iter().map(|path| path.as_os_str()));
        let what = What { input: input.name, stage, count: lines, unit: "lines", goal };
        let kerf = own()?.with_file_name("kerf");
        figures.push(what.measured(figure::RUNS, || run(&kerf, &words, folder.path()))?);
    }
    Ok(figures)
}

/// Work that is measured in processes of its own.
pub struct What {
    /// The input.
    pub input: &'static str,
    /// Name of what is done with it.
    pub stage: &'static str,
    /// Number of units that are done.
    pub count: u64,
    /// Name of the unit.
    pub unit: &'static str,
    /// Goal of the figure.
    pub goal: Option<Goal>,
}

impl What {
    /// The figure of so many runs after one to warm up.
    pub fn measured(self, runs: usize, run: impl Fn() -> Result<Taken>) -> Result<Figure> {
        run()?;
        let taken = (0..runs).map(|_| run()).collect::<Result<Vec<_>>>()?;
        let spread = |of: fn(&Taken) -> f64| Spread::of(taken.iter().map(of).collect());
        let Self { input, stage, count, unit, goal } = self;
        let (cpu_s, wall_s) = (spread(|t| t.cpu_s), spread(|t| t.seconds));
        let peak = Some(spread(|t| t.peak).median);
        Ok(Figure { input, stage, count, unit, cpu_s, wall_s, peak, goal })
    }
}

/// Returns the path of this program; `kerf` lies beside it.
pub fn own() -> Result<PathBuf> {
    env::current_exe().context("where is this program?")
}

/// Runs a program whose data and home lie in a folder.
pub fn run(program: &Path, arguments: &[&OsStr], data: &Path) -> Result<Taken> {
    let mut parent = Command::new(own()?);
    parent.arg(PARENT).arg(program).args(arguments).current_dir(data);
    parent.env("KERF_DATA", data).env("HOME", data);
    let output = parent.stderr(Stdio::inherit()).output()?;
    ensure!(output.status.success(), "{} failed", program.display());
    let text = String::from_utf8_lossy(&output.stdout);
    let mut numbers = text.split_whitespace().map(str::parse);
    let mut next = || numbers.next().context("the process told too little")?.context("no number");
    Ok(Taken { seconds: next()?, cpu_s: next()?, peak: next()? })
}

/// Runs a command and prints its seconds, its processor seconds and its peak memory in bytes.
pub fn parent(mut arguments: impl Iterator<Item = std::ffi::OsString>) -> Result<()> {
    let program = arguments.next().context("which program?")?;
    let start = Instant::now();
    let status = Command::new(program).args(arguments).stdout(Stdio::null()).status()?;
    let seconds = start.elapsed().as_secs_f64();
    // 3: stopped by the operator, as was asked.
    ensure!(status.success() || status.code() == Some(3), "it ended with {status}");
    let Usage { cpu_s, peak } = usage::children()?;
    println!("{seconds} {cpu_s} {peak}");
    Ok(())
}
