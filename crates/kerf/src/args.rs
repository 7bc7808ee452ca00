//! Options that several subcommands share.

use crate::data_args::DataArgs;
use crate::machine_choice::MachineChoice;
use crate::parse::{self, Dialects};
use clap::{Args, ValueEnum};
use kerf_control::{OperatorRequest, Script};
use kerf_machine::driver::Override;
use kerf_model::Change;
use kerf_program::RampModel;
use kerf_program::settings::LinearUnit;
use kerf_sbp::Value;
use kerf_sim::Push;
use kerf_sim::Sheet;
use std::path::PathBuf;

/// Options of everything that runs a part file, on a machine or as a preview.
#[derive(Args, Clone, Debug)]
pub struct RunArgs {
    /// Units at the start, in or mm [default: in]
    #[arg(long, value_name = "UNIT", value_parser = parse::units)]
    pub units: Option<LinearUnit>,
    /// Answers to the program's questions, one a line: OK, or LINE:OK, or pause=OK
    #[arg(long, value_name = "FILE")]
    pub answers: Option<PathBuf>,
    /// Sets a variable before the start
    #[arg(long, value_name = "NAME=VALUE", value_parser = parse::variable)]
    pub set: Vec<(String, Value)>,
    /// Changes an input of the simulated machine, a number or a name, at a time in seconds; `cable` is
    /// the one to the controller, `stall` has a motor stall; may be repeated
    #[arg(long, value_name = "N@T=0|1", value_parser = parse::input)]
    pub input: Vec<Change>,
    /// What the inputs of the simulated machine do by time and by place, a statement a line: `input 3 on at
    /// 2.5`, `input 1 on in box 1,2,-1 3,4,0` (also sphere and cylinder, `*` for no bound; mm unless a line
    /// says `units in`)
    #[arg(long, value_name = "FILE")]
    pub script: Option<PathBuf>,
    /// Lays a sheet on the table of the simulated machine: how high it lies, how it rises along X and Y, height
    /// and length of its waves along X
    #[arg(long, value_name = "Z[,X,Y[,WAVE,LENGTH]]", value_parser = parse::sheet)]
    pub sheet: Option<Sheet>,
    /// Pushes an axis of the simulated machine by hand, by a distance, at a time in seconds; may be repeated
    #[arg(long, value_name = "AXIS@T=BY", value_parser = parse::hand_move)]
    pub hand_move: Vec<Push>,
    /// Dialect of the program: sb3, fabmo or strict for OpenSBP; generic, linuxcnc or grbl for G-code
    #[arg(long, default_value = "sb3", value_parser = parse::dialect)]
    pub dialect: Dialects,
    /// Bound on executed lines; 0 for none [default: 50 million]. Checks and pictures also stop after this many moves
    /// and other commands [default: 2 million, or twice the lines of the file where that is more]
    #[arg(long, value_name = "N")]
    pub max_lines: Option<u64>,
    /// Runs a file with errors up to the first bad line that is reached
    #[arg(long)]
    pub allow_errors: bool,
    /// Seed of random numbers
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub seed: u64,
    #[command(flatten)]
    pub place: PlaceArgs,
    #[command(flatten)]
    pub file: FileArgs,
    #[command(flatten)]
    pub motion: MotionArgs,
    #[command(flatten)]
    pub operator: OperatorArgs,
}

/// What the operator does while the program runs.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "The operator, at times in seconds of machine time")]
pub struct OperatorArgs {
    /// Stops the machine; the run is over
    #[arg(long, value_name = "SECONDS", value_parser = parse::not_negative)]
    pub stop_at: Option<f64>,
    /// Holds the machine, which ramps down and stands; may be repeated
    #[arg(long, value_name = "SECONDS", value_parser = parse::not_negative)]
    pub hold_at: Vec<f64>,
    /// Lets a held machine go on, one time for each hold; a hold without one ends the run
    #[arg(long, value_name = "SECONDS", value_parser = parse::not_negative)]
    pub resume_at: Vec<f64>,
    /// From a time on, cuts run at this percentage of their feed, 10 to 200; may be repeated
    #[arg(long = "override", value_name = "PERCENT@SECONDS", value_parser = parse::feed_override)]
    pub feed: Vec<(f64, f32)>,
    /// Override of rapid moves, where the controller has one: 25, 50 or 100 percent; may be repeated
    #[arg(long, value_name = "PERCENT@SECONDS", value_parser = parse::rapid_override)]
    pub rapids: Vec<(f64, u8)>,
    /// Override of the spindle, where the controller has one: 10 to 200 percent; may be repeated
    #[arg(long, value_name = "PERCENT@SECONDS", value_parser = parse::spindle_override)]
    pub spindle: Vec<(f64, u8)>,
}

impl OperatorArgs {
    /// All of it in order of time.
    pub fn script(&self) -> Script {
        let stops = self.stop_at.iter().map(|at_s| (*at_s, OperatorRequest::Stop));
        let holds = self.hold_at.iter().map(|at_s| (*at_s, OperatorRequest::Hold));
        let feeds = self.feed.iter().map(|(at_s, share)| (*at_s, OperatorRequest::Feed(*share)));
        let rapids = self.rapids.iter().map(|(at_s, of)| (*at_s, Override::Rapid(*of)));
        let spindle = self.spindle.iter().map(|(at_s, of)| (*at_s, Override::Spindle(*of)));
        Script::new(stops.chain(holds).chain(feeds).collect(), self.resume_at.clone())
            .turning(rapids.chain(spindle).collect())
    }
}

/// Where things lie.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Folders")]
pub struct PlaceArgs {
    #[command(flatten)]
    pub machine: MachineChoice,
    /// The part folder [default: where the part file lies]
    #[arg(long, value_name = "DIR")]
    pub parts: Option<PathBuf>,
    /// The folder of custom cuts [default: `custom` in the data folder]
    #[arg(long, value_name = "DIR")]
    pub custom: Option<PathBuf>,
    /// Lets programs use files in another folder too; may be repeated
    #[arg(long, value_name = "DIR")]
    pub allow_path: Vec<PathBuf>,
    #[command(flatten)]
    pub data: DataArgs,
    /// Start from the machine as it was left, or from inches and zeros, with speeds as Kerf comes with them
    /// unless --machine tells what the machine is like [default: kept for send and, where a data folder is named or
    /// a controller, for run; fresh for the others]
    #[arg(long, value_enum, value_name = "HOW")]
    pub start: Option<Start>,
    /// Lets SHELL start programs; never in a preview
    #[arg(long)]
    pub allow_shell: bool,
}

impl PlaceArgs {
    /// `kerf run` on the simulated machine goes on from the last run only where a data folder is
    /// named: else the same file run twice would begin at two places. A real machine is as it was left.
    pub fn start_run(&mut self) {
        let named = self.data.folder.is_some() || std::env::var_os("KERF_DATA").is_some();
        if !named && self.machine.controller().is_none() {
            self.start = self.start.or(Some(Start::Fresh));
        }
    }
}

/// What a run starts from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Start {
    /// The machine of the data folder: its settings, and the locations that the last run left; this one
    /// leaves its own.
    Kept,
    /// The machine as Kerf comes with it: inches, every location 0, none of the settings of the data folder;
    /// nothing is left.
    Fresh,
}

/// The parameters of the FP command, for the file at the top.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "File parameters, as those of FP")]
pub struct FileArgs {
    /// Scales the file
    #[arg(long, value_name = "X,Y,Z", value_parser = parse::three)]
    pub proportion: Option<[f64; 3]>,
    /// Runs the file or the job this many times
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..))]
    pub repeat: u32,
    /// Takes the tool's present place as the file's zero: 3d, or 2d without Z
    #[arg(long, value_name = "3d|2d", value_parser = parse::offset)]
    pub offset: Option<u8>,
    /// Moves Z by this before each repetition
    #[arg(long, value_name = "Z", value_parser = parse::number)]
    pub plunge: Option<f64>,
    /// Leaves tabs in the last repetition
    #[arg(long)]
    pub tabs: bool,
    /// Plunges from Z 0
    #[arg(long)]
    pub plunge_from_zero: bool,
    /// Goes through the file line by line, as FG: step, go to a line, run from here, quit
    #[arg(long)]
    pub step: bool,
    /// Begins at a line, or at the one executed last when the last run ended early; with "N
    /// settings" settings and assignments before it are carried out. In a job, N is the number of a shape
    #[arg(long, value_name = "N|last", value_parser = parse::from_line)]
    pub from_line: Option<String>,
}

/// How motion is planned.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Motion")]
pub struct MotionArgs {
    /// The model of ramps, of part files and jobs alike [default: that of the configuration; else optimal where it
    /// or --accel, --axis-speed, --jerk or --tolerance tell what the axes can do; else shopbot]
    #[arg(long, value_parser = parse::ramps)]
    pub ramps: Option<RampModel>,
    /// With --ramps optimal: how far the path may leave the programmed one, mm [default: 0.01]
    #[arg(long, value_name = "MM", value_parser = parse::not_negative)]
    pub tolerance: Option<f64>,
    /// With --ramps optimal or profiler: greatest speed of each axis, mm/s [default: jog speeds]
    #[arg(long, value_name = "X,Y,Z", value_parser = parse::three_positive)]
    pub axis_speed: Option<[f64; 3]>,
    /// With --ramps optimal or profiler: greatest acceleration of each axis, mm/s² [default: 500]
    #[arg(long, value_name = "X,Y,Z", value_parser = parse::three_positive)]
    pub accel: Option<[f64; 3]>,
    /// With --ramps optimal: greatest jerk of each axis, mm/s³; 0 for no limit [default: 0]
    #[arg(long, value_name = "X,Y,Z", value_parser = parse::three_not_negative)]
    pub jerk: Option<[f64; 3]>,
    /// With --ramps profiler: how far a smooth curve may leave the segments, in tenths of a
    /// millimetre; 0 for no smoothing [default: 0.6]
    #[arg(long, value_name = "FACTOR", value_parser = parse::not_negative)]
    pub smoothing: Option<f64>,
    /// With --ramps profiler: corners that turn by less are passed without slowing [default: 1]
    #[arg(long, value_name = "DEGREES", value_parser = parse::degrees)]
    pub stop_angle: Option<f64>,
    /// With --ramps profiler: acceleration in curves, percent of the axes' own [default: 100]
    #[arg(long, value_name = "PERCENT", value_parser = parse::percent)]
    pub centripetal: Option<f64>,
}

impl MotionArgs {
    /// Returns `true` if an option tells what the axes can do, which `optimal` plans by.
    pub const fn tells_limits(&self) -> bool {
        let [accel, speed] = [self.accel.is_some(), self.axis_speed.is_some()];
        accel || speed || self.jerk.is_some() || self.tolerance.is_some()
    }
}

/// How reports are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// For people.
    Text,
    /// For programs.
    Json,
}
