//! `kerf machine`: the configuration of a machine.

use super::which::Which;
use crate::args::Format;
use crate::commands::board::{self, SettingsAction};
use crate::commands::by_hand::{self, MoveArgs, ServerArgs};
use crate::commands::controller_card::{self, CardAction};
use crate::commands::datum::{self, SpecialHeight};
use crate::commands::tool_table::{self, ToolsAction};
use crate::commands::zeros::{self, ZerosAction};
use crate::commands::{known_boards, pace, protect, prove, step_board, wire};
use crate::data_args::DataArgs;
use crate::exit::{Exit, Usage};
use crate::machine_name::{DriverName, MachineName};
use crate::named_machine;
use crate::{given, machine_file, out, parse};
use anyhow::{Result, bail};
use clap::{Args, Subcommand};
use kerf_journal::machine_file::{MachineFile, mistake_lines};
use kerf_machine::contradictions::contradictions;
use kerf_machine::profile::{PROFILES, profile};
use kerf_machine::table::{self, Setting};
use kerf_machine::{Configuration, Value, file};
use kerf_program::Axis;
use std::iter::once;
use std::path::PathBuf;

/// Shows and changes what a machine is like: axes, motors, heights, delays, inputs and the rest
///
/// `kerf get` and `kerf set` read and change single settings. The machine is the one that --machine names (a file, a saved machine, a ready-made one), else the one in the
/// data folder.
#[derive(Args)]
#[command(after_help = "Examples:\n  kerf machine profiles\n  kerf machine use router-96x48\n  \
    kerf machine save shop\n  kerf machine list\n  kerf machine show > mine.toml\n  kerf machine home\n  kerf machine move to 10,20,-5 --flat\n  \
      kerf machine check mine.toml\n\nExit codes: 0 done, 1 failed, 2 the command line was wrong")]
pub struct MachineArgs {
    #[command(subcommand)]
    action: Action,
    #[command(flatten)]
    which: Which,
}

#[derive(Subcommand)]
enum Action {
    /// Prints the whole configuration as a commented file
    Show,
    /// Lists the machines that --machine can name
    List {
        /// Lists settings with this word in their key instead, as kerf get does.
        #[arg(hide = true)]
        word: Option<String>,
    },
    /// Prints the value of a setting, as kerf get does
    #[command(hide = true)]
    Get {
        /// Its key
        key: String,
    },
    /// Changes a setting, as kerf set does
    #[command(hide = true)]
    Set {
        /// Its key
        key: String,
        /// The value; a list is separated by commas
        #[arg(allow_hyphen_values = true)]
        value: String,
    },
    /// Checks configuration files; prints every mistake
    Check {
        /// The files [default: that of the machine]
        files: Vec<PathBuf>,
    },
    /// Lists the ready-made machines, or prints the file of one
    Profiles {
        /// Its name
        name: Option<String>,
    },
    /// Makes a machine the one of the data folder
    Use {
        /// A ready-made machine, a saved one, or a file
        name: String,
    },
    /// Saves the machine under a name, which --machine NAME means from then on, with the controller that --machine names
    Save {
        /// Its name
        name: String,
    },
    /// Lists the axes with their motors, lengths, speeds and switches
    Axes,
    /// Homes axes and tells each step
    Home {
        /// Their letters, as xyz; all that have a switch when not given
        axes: Option<String>,
        /// Unlocks the controller first, or switches it on: look first why it stopped
        #[arg(long)]
        unlock: bool,
        #[command(flatten)]
        there: ServerArgs,
    },
    /// Warms the spindle up where the machine stands, in steps of speed and time; Ctrl-C ends it with the spindle off
    WarmUp {
        /// Percent of the spindle's greatest speed and minutes: 25:2,50:2 [default: options.warm_up]
        steps: Option<String>,
        #[command(flatten)]
        there: ServerArgs,
    },
    /// Moves the machine by hand: to home, to the job origin, to a place, as a key that is held
    Move(MoveArgs),
    /// Records the height at which Z is as top, surface or bottom
    Zset {
        /// Which
        #[arg(value_enum)]
        height: SpecialHeight,
        /// Goes to this height first, millimetres from home
        #[arg(allow_hyphen_values = true, value_parser = parse::number, conflicts_with = "by")]
        to: Option<f64>,
        /// Puts the height by so much instead, negative down
        #[arg(long, value_parser = parse::number, value_name = "MM")]
        by: Option<f64>,
    },
    /// Prints where the axes are, and which are homed
    Pos,
    /// Looks for controllers and boards with step queues at all serial ports, and for controllers in the network, in some
    /// seconds, and shows their firmware
    Connect {
        /// Where else to look: a port, tcp:HOST[:PORT] or ws:HOST[:PORT]; or the boards with step queues to show,
        /// klipper:PORT
        more: Vec<String>,
    },
    /// Asks which pin of a board with step queues does what, turns each motor a millimetre to be looked at, looks at
    /// switches and outputs, tries speeds, and writes the machine's file; q stops at each question
    Wire {
        /// The board, klipper:PORT
        board: String,
        /// The file to be written
        #[arg(long, value_name = "FILE", default_value = "board.toml")]
        into: PathBuf,
        /// Begins with the pins of a board that is sold (kerf machine boards)
        #[arg(long = "board", value_name = "NAME")]
        known: Option<String>,
    },
    /// Lists boards with step queues whose pins are known, or prints the pins of one
    Boards {
        /// Its name
        name: Option<String>,
    },
    /// Prints what a printer's configuration (printer.cfg) tells of a board with step queues, as the lines of a machine's
    /// file; notes tell what was left out
    Import {
        /// The configuration
        file: PathBuf,
    },
    /// Runs the list that every machine has to hold against the board that --machine names, and writes a report: on the
    /// bench, without a tool; X moves 50 mm, the spindle turns
    Prove {
        /// The report
        #[arg(long, value_name = "FILE", default_value = "prove.md")]
        report: PathBuf,
        /// Form in which the outcome is printed
        #[arg(long, default_value = "text", value_name = "FORMAT")]
        format: Format,
        /// Has it go home first: its axes move to their switches
        #[arg(long)]
        home: bool,
    },
    /// Lists the settings ($$) of the controller that --machine names, with names, units and bounds; changes them, keeps
    /// them in a file, compares them
    #[command(args_conflicts_with_subcommands = true)]
    Settings {
        /// Tells below each what it does
        #[arg(long)]
        explain: bool,
        #[command(subcommand)]
        action: Option<SettingsAction>,
    },
    /// Lists the zero points (G54 to G59.3, G92) that the controller that --machine names keeps, millimetres from home; sets
    /// them, chooses the one that holds
    Zeros {
        #[command(subcommand)]
        action: Option<ZerosAction>,
    },
    /// Lists the files on the card (SD) of the controller that --machine names, which it runs by itself; uploads, runs, follows,
    /// shows and deletes them
    Card {
        #[command(subcommand)]
        action: Option<CardAction>,
    },
    /// Tells how much longer runs on the controller that --machine names take than estimated, as they have shown; the time
    /// told of files has it in it
    Pace {
        /// Forgets it: after the machine was changed
        #[arg(long)]
        forget: bool,
    },
    /// Lists the tools by their numbers (T of G-code, &Tool of C9), with diameter, length and name; sets and forgets them
    Tools {
        #[command(subcommand)]
        action: Option<ToolsAction>,
    },
    /// Prints the job origin, or sets it
    Origin {
        /// `here`, where the tool is, or X,Y: millimetres from home
        #[arg(allow_hyphen_values = true)]
        place: Option<String>,
    },
    /// Protects the settings with a password, which is asked for twice, or no longer
    Password {
        /// Takes the protection away
        #[arg(long)]
        off: bool,
    },
}

pub fn run(args: &MachineArgs) -> Result<Exit> {
    match &args.action {
        Action::Check { files } if files.is_empty() => {
            return check(&[args.which.file()?.name().into()]);
        }
        Action::Check { files } => return check(files),
        Action::Profiles { name } => profiles(name.as_deref())?,
        Action::Show => out::print(&file::write(&args.which.machine()?)),
        Action::List { word: None } => out::print(&machines(&args.which.folder())?),
        Action::List { word: Some(word) } => {
            let lines = listed(Some(word), &args.which.machine()?);
            if lines.is_empty() {
                bail!(Usage(format!("no setting has {word} in its key")));
            }
            out::print(&lines);
        }
        Action::Get { key } => {
            let value = known(key)?.get(&args.which.machine()?);
            out::print(&format!("{value}\n"));
        }
        Action::Set { key, value } => set(&args.which, known(key)?, &Value::typed(value))?,
        Action::Use { name } => {
            args.which.to_change()?;
            let text = named_machine::text(name.as_ref(), &args.which.folder())?;
            replace(&machine_file::of_data_to_change(&args.which.folder())?, &text)?;
        }
        Action::Save { name } => save(&args.which, name)?,
        Action::Axes => out::print(&axes(&args.which.machine()?)),
        Action::Home { axes, unlock, there } => {
            return by_hand::home(&args.which, axes.as_deref(), *unlock, *there);
        }
        Action::WarmUp { steps, there } => return by_hand::warm_up(&args.which, steps, *there),
        Action::Move(moves) => return by_hand::moves(&args.which, moves),
        Action::Zset { height, to, by } => return datum::zset(&args.which, *height, *to, *by),
        Action::Pos => return by_hand::pos(&args.which),
        Action::Connect { more } => return connect(more, &args.which),
        Action::Wire { board, into, known } => {
            let name = board_name(board)
                .ok_or_else(|| Usage(format!("{board} is no board: name it as klipper:PORT")))?;
            let known = known.as_deref().map(known_boards::named).transpose()?;
            return wire::wire(&name, args.which.machine()?, into, known.as_ref());
        }
        Action::Boards { name } => known_boards::print(name.as_deref())?,
        Action::Import { file } => return step_board::import(file),
        Action::Prove { report, format, home } => {
            let name = controller(&args.which)?;
            if name.is_board() {
                return step_board::prove(name, &args.which.machine()?, report, *format);
            }
            return prove::prove(name, report, *format, *home);
        }
        Action::Settings { explain, action } => {
            return board::settings(controller(&args.which)?, action.as_ref(), *explain);
        }
        Action::Zeros { action } => return zeros::run(&args.which, action.as_ref()),
        Action::Card { action } => return card(&args.which, action.as_ref()),
        Action::Pace { forget } => return pace::run(&args.which, *forget),
        Action::Tools { action } => return tool_table::run(&args.which, action.as_ref()),
        Action::Origin { place } => return datum::origin(&args.which, place.as_deref()),
        Action::Password { off } => protect::change(&args.which.to_change()?, *off)?,
    }
    Ok(Exit::Good)
}

/// Saves the machine under a name.
fn save(which: &Which, name: &str) -> Result<()> {
    let file = machine_file::to_save(name, &which.folder())?;
    let mut machine = which.machine()?;
    // What drives it belongs to it: its name alone is enough from then on.
    if let Some(controller) = which.machine.controller() {
        machine.options.controller.clone_from(&controller.words);
    }
    replace(&file, &file::write(&machine))
}

/// Lists the files on the card of the controller that is named, or does something there.
fn card(which: &Which, action: Option<&CardAction>) -> Result<Exit> {
    controller_card::run(which, controller(which)?, action)
}

/// Looks for controllers, or opens the boards with step queues that are named.
fn connect(more: &[String], which: &Which) -> Result<Exit> {
    let boards: Option<Vec<DriverName>> = more.iter().map(|it| board_name(it)).collect();
    match boards {
        Some(boards) if !boards.is_empty() => step_board::connect(&boards, &which.machine()?),
        _ => board::connect(more),
    }
}

/// Reads the name of a board with step queues; nothing where it is that of something else.
fn board_name(words: &str) -> Option<DriverName> {
    match MachineName::read(words) {
        Ok(MachineName::Controller(name)) => Some(name).filter(DriverName::is_board),
        _ => None,
    }
}

/// Returns the controller that is named.
pub fn controller(which: &Which) -> Result<&DriverName> {
    let named = which.machine.controller();
    named.ok_or_else(|| Usage("name the controller: --machine grbl:PORT".into()).into())
}

/// The machines that have a name, a line each: the simulated one, saved ones, ready-made ones.
fn machines(data: &DataArgs) -> Result<String> {
    let usual =
        ("sim".to_owned(), "the simulated machine, set up as the data folder says".to_owned());
    let saved = named_machine::all_saved(data)?;
    let saved = saved.into_iter().map(|(name, path)| (name, format!("saved: {}", path.display())));
    let is_taken = |name: &str| MachineName::read(name) == Ok(MachineName::Sim);
    let ready = PROFILES.iter().filter(|it| !is_taken(it.name));
    let ready = ready.map(|it| (it.name.to_owned(), it.about()));
    let all = once(usual).chain(saved).chain(ready);
    Ok(all.map(|(name, about)| format!("{name:<16} {about}\n")).collect())
}

/// Puts a machine into a file; another one that was there is kept beside it.
fn replace(file: &MachineFile, text: &str) -> Result<()> {
    if let Some(kept) = file.replace(text)? {
        eprintln!("kerf: the machine as it was is kept in {}", kept.display());
    }
    Ok(())
}

fn known(key: &str) -> Result<&'static Setting> {
    let Some(setting) = table::setting(key) else {
        let keys = table::settings().map(|setting| setting.key);
        let hint = kerf_diag::did_you_mean(key, keys)
            .unwrap_or_else(|| "kerf get lists every setting".into());
        bail!(Usage(format!("there is no setting {key}; {hint}")));
    };
    Ok(setting)
}

fn named(name: &str) -> Result<&'static str> {
    match profile(name) {
        Some(profile) => Ok(profile.text),
        None => bail!(Usage(format!(
            "no ready-made machine is called {name}; {}",
            named_machine::nearest(name)
        ))),
    }
}

/// Changes a setting in the file of the machine.
pub fn set(which: &Which, setting: &'static Setting, value: &Value) -> Result<()> {
    if setting.key == protect::KEY {
        bail!(Usage(format!("{} is set by `kerf machine password`", protect::KEY)));
    }
    let kept = which.to_change()?;
    let _alone = kept.alone();
    let mut configuration = which.machine()?;
    setting.set(&mut configuration, value).map_err(|refused| Usage(refused.to_string()))?;
    if let Some(crossed) = contradictions(&configuration).first() {
        bail!(Usage(format!("{}; {}", crossed.message, crossed.hint)));
    }
    let text = kept.text()?.unwrap_or_default();
    Ok(kept.write(&file::edit(&text, setting, &configuration))?)
}

/// The settings that have a word in their key, a line each, in areas.
pub fn listed(word: Option<&str>, configuration: &Configuration) -> String {
    let fits = |setting: &&Setting| word.is_none_or(|word| setting.key.contains(word));
    let mut lines = String::new();
    for area in table::areas() {
        // Asked for by its whole key a setting is shown, whatever the machine has.
        let whole =
            area.rows.iter().filter(|it| word == Some(it.key) && !it.applies(configuration));
        let mut rows = area.shown(configuration).chain(whole).filter(fits).peekable();
        if rows.peek().is_some() {
            lines.push_str(&format!("# {} ({})\n", area.title, area.manual));
        }
        for setting in rows {
            let (value, notes) = (setting.get(configuration), setting.notes());
            let advice = configuration.advice(setting.key);
            let advice = advice.map_or(String::new(), |it| format!(" ({it})"));
            let line = format!("{} = {value}  [{notes}] {}{advice}\n", setting.key, setting.doc);
            lines.push_str(&line);
        }
    }
    lines
}

fn check(files: &[PathBuf]) -> Result<Exit> {
    let mut worst = Exit::Good;
    for path in files {
        let text = given::text(path)?;
        let name = path.display().to_string().into();
        for note in file::notes(&name, &text) {
            out::print(&format!("note: {}\n", mistake_lines(&[note])));
        }
        if let Err(found) = file::read(&name, &text) {
            out::print(&format!("{}\n", mistake_lines(&found)));
            worst = Exit::Failed;
        }
    }
    Ok(worst)
}

fn profiles(name: Option<&str>) -> Result<()> {
    if let Some(name) = name {
        out::print(named(name)?);
        return Ok(());
    }
    for profile in PROFILES {
        out::print(&format!("{:<16} {}\n", profile.name, profile.about()));
    }
    Ok(())
}

/// A line for each axis that a motor drives.
fn axes(c: &Configuration) -> String {
    let dynamics = c.program.axis_dynamics();
    let mut lines =
        String::from("axis motors   steps/unit     length  max speed  max accel  home\n");
    for axis in Axis::ALL {
        let motors = c.motors.of_axis(axis);
        if motors.is_empty() {
            continue;
        }
        let words: Vec<_> = motors.iter().map(|motor| motor.word().to_uppercase()).collect();
        let switch = c.homing.of(axis);
        let home = if switch.fitted { switch.end.word() } else { "none" };
        lines.push_str(&format!(
            "{:<4} {:<8} {:>10.4} {:>10.3} {:>10.3} {:>10.3}  {home}\n",
            c.motors.axis_name(axis),
            words.join(" "),
            c.program.resolution.steps_per_unit[axis],
            c.axes.length[axis],
            dynamics.speed_mm_s[axis],
            dynamics.accel_mm_s2[axis],
        ));
    }
    lines
}
