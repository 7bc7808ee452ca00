//! `kerf convert`: part files to G-code and back.

use crate::args::RunArgs;
use crate::exit::{Exit, Usage};
use crate::report::Diagnostics;
use crate::{date, drawings, out, setup};
use anyhow::{Context, Result, bail};
use clap::{Args, ValueEnum};
use kerf_control::Desk;
use kerf_control::answers::Answers;
use kerf_control::files::{Disk, RealDisk};
use kerf_convert::{Conversion, Language, Passage, Source};
use kerf_gcode::Dialect;
use kerf_program::Settings;
use kerf_sbp::Variables;
use kerf_toolpath::Heights;
use std::path::{Path, PathBuf};

/// Converts part files to G-code and G-code to part files
///
/// The extensions say from what to what: .sbp, and .nc, .tap, .ngc or .gcode. The program is followed
/// as in a preview and written as the moves it makes: arcs stay arcs, comments stay beside what they
/// belong to. The result is read back and compared before it is written. What the other language
/// cannot say is told, and stands in the result as a comment.
#[derive(Args)]
#[command(after_help = "Examples:\n  kerf convert box.sbp box.nc\n  \
    kerf convert box.sbp box.nc --to grbl\n  kerf convert box.nc box.sbp\n\n\
    Exit codes: 0 converted, 1 not converted")]
pub struct ConvertArgs {
    /// The file to convert
    #[arg(value_name = "IN")]
    source: PathBuf,
    /// The file to write
    #[arg(value_name = "OUT")]
    target: PathBuf,
    /// What IN is, where its name does not say it: an extension, as nc or sbp
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
    /// Writes over a file that is there
    #[arg(long)]
    force: bool,
    #[command(flatten)]
    run: RunArgs,
}

/// Whose G-code.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Controller {
    /// LinuxCNC
    Linuxcnc,
    /// grbl 1.1
    Grbl,
    /// Any router: only what all agree on
    Generic,
}

impl Controller {
    const fn dialect(self) -> Dialect {
        match self {
            Self::Linuxcnc => Dialect::LinuxCnc,
            Self::Grbl => Dialect::Grbl,
            Self::Generic => Dialect::Generic,
        }
    }
}

pub fn run(args: &ConvertArgs) -> Result<Exit> {
    if drawings::is_drawing(&args.source) {
        return drawing(args);
    }
    let from = match &args.kind {
        Some(kind) => language(&args.source.with_extension(kind), args.from)?,
        None => language(&args.source, args.from)?,
    };
    let to = language(&args.target, args.to)?;
    let bytes = setup::read_bytes(&args.source)?;
    refuse_to_overwrite(args)?;
    let source =
        Source { name: args.source.display().to_string().into(), bytes: &bytes, language: from };
    let converted = {
        let answers = match &args.run.answers {
            Some(path) => Answers::read(&setup::read_text(path)?),
            None => Answers::default(),
        };
        let parts = args.source.parent().unwrap_or(Path::new(""));
        // That it can be made is known from here on.
        setup::shelf(parts, &args.run.place, true)?;
        let conversion = conversion(args, from, to)?;
        kerf_convert::convert(&source, &conversion, &mut |follow| {
            let mut answers = answers.clone();
            match setup::shelf(parts, &args.run.place, true) {
                Ok(mut shelf) => follow(&mut Desk::new(&mut shelf, &mut answers)),
                Err(_) => Passage::default(),
            }
        })
    };
    let shown = Diagnostics::default();
    converted.diagnostics.iter().for_each(|d| shown.show(d));
    let Some(text) = converted.text else { return Ok(Exit::Failed) };
    keep(args, &text)
}

/// Writes the tool paths of a drawing as a program.
fn drawing(args: &ConvertArgs) -> Result<Exit> {
    let to = language(&args.target, args.to)?;
    refuse_to_overwrite(args)?;
    let (job, heights) = (drawings::job(&args.source)?, Heights::default());
    let written = match to {
        Language::OpenSbp => drawings::part_program(&args.source, &job, &heights)?,
        Language::Gcode(_) => drawings::gcode_program(&args.source, &job, &heights)?,
    };
    for lost in &written.lost {
        eprintln!("{}: warning: not written: {}", args.target.display(), lost.what);
    }
    keep(args, &written.text)
}

fn refuse_to_overwrite(args: &ConvertArgs) -> Result<()> {
    if args.target.exists() && !args.force {
        bail!(Usage(format!("{} is there already; --force writes over it", args.target.display())));
    }
    Ok(())
}

fn keep(args: &ConvertArgs, text: &str) -> Result<Exit> {
    RealDisk
        .write(&args.target, text.as_bytes())
        .with_context(|| format!("cannot write {}", args.target.display()))?;
    out::print(&format!("{}: {} lines\n", args.target.display(), text.lines().count()));
    Ok(Exit::Good)
}

fn language(file: &Path, controller: Controller) -> Result<Language> {
    let name = file.display().to_string();
    let Some(language) = Language::of_file(&name, controller.dialect()) else {
        let known = ".sbp, .nc, .tap, .ngc and .gcode and drawings as .dxf, .svg, .rsg and .rsm are converted";
        bail!(Usage(format!("{name}: {known}; pictures and plotter files are not there yet")));
    };
    Ok(language)
}

fn conversion(args: &ConvertArgs, from: Language, to: Language) -> Result<Conversion> {
    let mut settings = setup::settings(&args.run.place, Settings::default())?;
    if let Some(unit) = args.run.units {
        settings.use_linear_unit(unit);
    }
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
