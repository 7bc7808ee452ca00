//! `kerf convert`: part files to G-code and back.

use crate::args::RunArgs;
use crate::exit::{Exit, Usage};
use crate::outputs::{ForceArgs, Outputs};
use crate::report::Diagnostics;
use crate::{date, drawings, given, out, parse, setup};
use anyhow::{Result, bail};
use clap::{Args, ValueEnum};
use kerf_control::answers::{Answers, Operator as _, meaning};
use kerf_convert::{Conversion, Language, Passage, Source};
use kerf_formats::{FORMATS, Format, ending};
use kerf_gcode::Dialect;
use kerf_gcode::{Writer, Writing};
use kerf_geom::Vec2;
use kerf_import::ConversionHost;
use kerf_import::drawn::{self, Drawn};
use kerf_program::settings::LinearUnit;
use kerf_program::{Answer, Printer, Question, Settings};
use kerf_sbp::{Printing, SbpPrinter, Variables};
use std::path::{Path, PathBuf};

/// Converts part files to G-code and back, and drawings and pictures to either
///
/// The extensions say from what to what: .sbp, and .nc, .tap, .ngc or .gcode. Drawings are .dxf, .svg,
/// .plt, .hpg, .hpgl, .rsg and .rsm; pictures, .bmp, .jpg and .png, become reliefs. A program is followed
/// as in a preview and written as the moves it makes: arcs stay arcs, comments stay beside what they
/// belong to. The result is read back and compared before it is written. What the other language
/// cannot say is told, and stands in the result as a comment.
#[derive(Args)]
#[command(after_help = "Examples:\n  kerf convert box.sbp box.nc\n  \
    kerf convert box.sbp box.nc --to grbl\n  kerf convert box.nc box.sbp\n  \
    kerf convert sign.plt sign.sbp --depth 0.1\n  kerf convert face.png face.sbp --size 6,8 --depth 0.5\n\n\
    Exit codes: 0 converted, 1 not converted, 2 the command line was wrong")]
pub struct ConvertArgs {
    /// The file to convert
    #[arg(value_name = "IN")]
    source: PathBuf,
    /// The file to write
    #[arg(value_name = "OUT")]
    target: PathBuf,
    /// Kind of IN, where its name does not say it: an extension, as nc or sbp
    #[arg(long = "type", value_name = "EXTENSION")]
    kind: Option<String>,
    /// The controller that the G-code is written for
    #[arg(long, value_enum, default_value = "linuxcnc", value_name = "CONTROLLER")]
    to: Controller,
    /// The controller that the G-code was written for
    #[arg(long, value_enum, default_value = "generic", value_name = "CONTROLLER")]
    from: Controller,
    /// Keeps variables, loops, conditions and subroutines where both languages can say them (LinuxCNC)
    #[arg(long)]
    keep_variables: bool,
    /// The output that switches mist coolant (M7); 0 for none
    #[arg(long, value_name = "N", default_value_t = 0, value_parser = clap::value_parser!(u8).range(0..=12))]
    mist_output: u8,
    /// The output that switches flood coolant (M8); 0 for none
    #[arg(long, value_name = "N", default_value_t = 0, value_parser = clap::value_parser!(u8).range(0..=12))]
    flood_output: u8,
    #[command(flatten)]
    drawn: DrawnArgs,
    #[command(flatten)]
    run: RunArgs,
    #[command(flatten)]
    force: ForceArgs,
}

impl ConvertArgs {
    /// The files that it writes.
    pub fn outputs(&self) -> Outputs {
        Outputs::of([self.target.as_path()], self.force.force, None)
    }
}

/// What a drawing or a picture does not say.
#[derive(Args, Clone, Copy, Debug)]
#[command(next_help_heading = "Drawings and pictures, in the unit of --units")]
struct DrawnArgs {
    /// Depth of cut; in a picture the depth of its deepest place [default: 0.125 in, 3 mm]
    #[arg(long, value_name = "DEPTH", value_parser = parse::not_negative)]
    depth: Option<f64>,
    /// Height of travel above the surface [default: 0.5 in, 12 mm]
    #[arg(long, value_name = "HEIGHT", value_parser = parse::not_negative)]
    safe_height: Option<f64>,
    /// Factor by which the drawing is scaled
    #[arg(long, value_name = "FACTOR", value_parser = parse::positive, default_value_t = 1.0)]
    scale: f64,
    /// Size of the picture, from the first dot to the last [default: 0.1 mm a dot]
    #[arg(long, value_name = "X,Y", value_parser = parse::size)]
    size: Option<[f64; 2]>,
    /// What is deepest in a picture
    #[arg(long, value_enum, value_name = "SHADE", default_value = "black")]
    deepest: Shade,
}

/// An end of the grey scale.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Shade {
    /// Black is deepest, white is the surface
    Black,
    /// White is deepest, black is the surface
    White,
}

impl DrawnArgs {
    /// In millimetres, what is not said as usual.
    fn taken(&self, unit: LinearUnit) -> Result<Drawn> {
        let usual = Drawn::usual(unit);
        let mm = |length: Option<f64>, usual: f64| length.map_or(usual, |l| l * unit.mm());
        let taken = Drawn {
            depth_mm: mm(self.depth, usual.depth_mm),
            safe_mm: mm(self.safe_height, usual.safe_mm),
            scale: self.scale,
            size: self.size.map(|[x, y]| Vec2::new(x, y) * unit.mm()),
            white_deepest: self.deepest == Shade::White,
        };
        let positive = [taken.depth_mm, taken.safe_mm, taken.scale].iter().all(|v| *v > 0.0);
        if !positive {
            bail!(Usage("--depth, --safe-height and --scale are above 0".into()));
        }
        Ok(taken)
    }
}

/// Whose G-code.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Controller {
    /// LinuxCNC
    Linuxcnc,
    /// grbl 1.1
    Grbl,
    /// grblHAL
    Grblhal,
    /// Mach3
    Mach3,
    /// Any router: only what all agree on
    Generic,
}

impl Controller {
    const fn dialect(self) -> Dialect {
        match self {
            Self::Linuxcnc => Dialect::LinuxCnc,
            Self::Grbl => Dialect::Grbl,
            Self::Grblhal => Dialect::GrblHal,
            Self::Mach3 => Dialect::Mach3,
            Self::Generic => Dialect::Generic,
        }
    }
}

pub fn run(args: &ConvertArgs) -> Result<Exit> {
    let kind = args.kind.clone().unwrap_or_else(|| ending(&args.source));
    if Format::of_ending(&kind).is_some() {
        return drawing(args, &kind);
    }
    let from = match &args.kind {
        Some(kind) => language(&args.source.with_extension(kind), args.from)?,
        None => language(&args.source, args.from)?,
    };
    let to = language(&args.target, args.to)?;
    let bytes = given::bytes(&args.source)?;
    let source =
        Source { name: args.source.display().to_string().into(), bytes: &bytes, language: from };
    let converted = {
        let answers = match &args.run.answers {
            Some(path) => Answers::read(&given::text(path)?),
            None => Answers::default(),
        };
        let parts = args.source.parent().unwrap_or(Path::new(""));
        // That it can be made is known from here on.
        setup::workspace(parts, &args.run.place, true)?;
        let conversion = conversion(args, from, to)?;
        kerf_convert::convert(&source, &conversion, &mut |follow| {
            let mut answers = answers.clone();
            match setup::workspace(parts, &args.run.place, true) {
                Ok(mut workspace) => {
                    follow(&mut ConversionHost::new(&mut workspace, &mut |question| {
                        answered(&mut answers, question)
                    }))
                }
                Err(_) => Passage::default(),
            }
        })
    };
    let shown = Diagnostics::default();
    converted.diagnostics.iter().for_each(|d| shown.show(d));
    let Some(text) = converted.text else { return Ok(Exit::Failed) };
    keep(args, &text)
}

/// Writes what a drawing or a picture cuts as a program.
fn drawing(args: &ConvertArgs, kind: &str) -> Result<Exit> {
    let to = language(&args.target, args.to)?;
    let bytes = given::bytes(&args.source)?;
    let settings = settings(args)?;
    let how = args.drawn.taken(settings.linear_unit)?;
    let title = Some(drawing_title(args, kind, &how, settings.linear_unit));
    let unit = settings.linear_unit;
    let printing = Printing { unit, title: title.clone(), ..Printing::default() };
    let writing = Writing { title, ..Writing::default() };
    let mut printer: Box<dyn Printer + '_> = match to {
        Language::OpenSbp => Box::new(SbpPrinter::new(&printing)),
        Language::Gcode(_) => Box::new(Writer::new(&writing)),
    };
    let findings = match drawn::print(&bytes, kind, &how, printer.as_mut()) {
        Ok(findings) => findings,
        Err(error) => bail!("{}: {error}", args.source.display()),
    };
    drawings::tell_all(&args.source, &findings);
    let written = printer.finish();
    for lost in &written.lost {
        eprintln!("{}: warning: not written: {}", args.target.display(), lost.what);
    }
    keep(args, &written.text)
}

/// The head of the program of a drawing: where it comes from, when, and what was taken for it.
fn drawing_title(args: &ConvertArgs, kind: &str, how: &Drawn, unit: LinearUnit) -> String {
    let name = args.source.file_name().unwrap_or_default().to_string_lossy();
    let settings = how.settings_line(kind, unit);
    format!(
        "Converted from {name} by kerf {}, {}\n{settings}",
        env!("CARGO_PKG_VERSION"),
        date::today()
    )
}

fn keep(args: &ConvertArgs, text: &str) -> Result<Exit> {
    out::file(&args.target, text)?;
    out::print(&format!("{}: {} lines\n", args.target.display(), text.lines().count()));
    Ok(Exit::Good)
}

fn language(file: &Path, controller: Controller) -> Result<Language> {
    let name = file.display().to_string();
    let Some(language) = Language::of_file(&name, controller.dialect()) else {
        let drawn: Vec<_> = FORMATS.iter().flat_map(|format| format.endings).copied().collect();
        let drawn = drawn.join(" .");
        bail!(Usage(format!(
            "{name}: .sbp .nc .tap .ngc .gcode are converted to each other, .{drawn} to .sbp"
        )));
    };
    Ok(language)
}

fn settings(args: &ConvertArgs) -> Result<Settings> {
    let mut settings = setup::settings(&args.run.place, Settings::default())?;
    if let Some(unit) = args.run.units {
        settings.use_linear_unit(unit);
    }
    Ok(settings)
}

fn conversion(args: &ConvertArgs, from: Language, to: Language) -> Result<Conversion> {
    let settings = settings(args)?;
    let mut variables = Variables::default();
    for (name, value) in &args.run.set {
        variables.set(name, value.clone());
    }
    Ok(Conversion {
        from,
        to,
        sbp: setup::run_options(&args.run, &settings, true).program,
        title: title(args, to, &settings),
        settings,
        variables,
        keep_variables: args.keep_variables,
        coolant_outputs: [args.mist_output, args.flood_output],
    })
}

/// The head of the file: where it comes from, when, and with which settings.
fn title(args: &ConvertArgs, to: Language, settings: &Settings) -> String {
    let name = args.source.file_name().unwrap_or_default().to_string_lossy();
    let controller = match to {
        Language::OpenSbp => String::new(),
        Language::Gcode(dialect) => format!(", for {}", dialect.name()),
    };
    let units = settings.linear_unit.symbol();
    format!(
        "Converted from {name} by kerf {}, {}\nSettings: machine in {units}{controller}",
        env!("CARGO_PKG_VERSION"),
        date::today()
    )
}

/// The answer of a script to a question; what the box does not have counts as none.
fn answered(answers: &mut Answers, question: &Question) -> Option<Answer> {
    let words = answers.answer(question, 0)?;
    meaning(question, &words)
}
