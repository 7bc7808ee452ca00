//! `kerf get` and `kerf set`: everything that has a value, by one grammar.

use super::by_hand::ServerArgs;
use super::card::{CardArgs, Line};
use super::io::{State, Switches};
use super::kept_values::KeptValues;
use super::which::Which;
use super::{machine, settings, sysvars};
use crate::data_args::DataArgs;
use crate::exit::{Exit, Usage};
use crate::machine_choice::MachineChoice;
use crate::out;
use anyhow::{Result, bail};
use clap::Args;
use kerf_machine::Value;
use kerf_machine::table::{self, Setting};
use kerf_machine::wiring::{Bit, INPUT_BITS, OUTPUT_BITS};

/// Prints values: settings, inputs and outputs, V commands, system variables, values of programs
///
/// A name alone prints its value. A part of a name lists every name with that part, with its meaning; without a name
/// everything is listed.
#[derive(Args)]
#[command(
    after_help = "Examples:\n  kerf get delays.end_s        a setting\n  kerf get homing              all \
    settings of homing\n  kerf get tool2 in.xhome      an output, an input\n  kerf get VC                  what a V \
    command is set to\n  kerf get '%(1)'              a system variable\n  kerf get uValue              a value of \
    programs\n\nExit codes: 0 done, 1 a key of programs has no value, 2 nothing has such a name"
)]
pub struct GetArgs {
    /// What to print
    #[arg(value_name = "NAME")]
    names: Vec<String>,
    /// Prints the values of programs that a running `kerf serve` at this address has
    #[arg(long, value_name = "URL")]
    server: Option<String>,
    #[command(flatten)]
    machine: MachineChoice,
    #[command(flatten)]
    data: DataArgs,
}

/// Sets settings, inputs and outputs, and values of programs
#[derive(Args)]
#[command(
    after_help = "Examples:\n  kerf set delays.end_s=0.5     a setting; everything else in the file stays\n  \
    kerf set tool2=1              an output by hand\n  kerf set in.xhome=1           the level at a pin of the \
    simulated machine\n  kerf set uValue=hello         a value of programs\n  kerf set uValue=              removes \
    it\n\nA V command is carried out: kerf send VC,.375\n\nExit codes: 0 done, 1 failed, 2 the command line was wrong"
)]
pub struct SetArgs {
    /// What gets which value; a list is separated by commas
    #[arg(required = true, value_name = "NAME=VALUE", value_parser = pair)]
    pairs: Vec<(String, String)>,
    /// Sets the values of programs that a running `kerf serve` at this address has
    #[arg(long, value_name = "URL")]
    server: Option<String>,
    /// Arms the machine before an output is set, where a running kerf serve has it
    #[arg(long)]
    arm: bool,
    #[command(flatten)]
    which: Which,
}

fn pair(text: &str) -> Result<(String, String), String> {
    let (name, value) = text.split_once('=').ok_or("give NAME=VALUE")?;
    Ok((name.trim().to_owned(), value.to_owned()))
}

/// Something that has a value.
enum Named {
    Setting(&'static Setting),
    Line(Line),
    /// A V command, by its letters.
    Command(String),
    /// A system variable, by its number.
    Variable(String),
    /// A value of programs, by its key.
    Kept(String),
}

impl Named {
    fn of(name: &str, machine: &MachineChoice) -> Self {
        let variable = name.strip_prefix("%(").and_then(|rest| rest.strip_suffix(')'));
        let letters = name.to_ascii_uppercase();
        let is_command = letters.len() == 2 && letters.starts_with('V');
        let setting = table::setting(name).map(Self::Setting);
        match (variable, setting, Line::named(name, machine)) {
            (Some(number), ..) => Self::Variable(number.trim().to_owned()),
            (_, Some(setting), _) => setting,
            _ if is_command && kerf_sbp::table::find(&letters).is_some() => Self::Command(letters),
            (.., Some(line)) => Self::Line(line),
            _ => Self::Kept(name.to_owned()),
        }
    }
}

/// Where values are looked for.
struct Places {
    which: Which,
    kept: KeptValues,
}

impl Places {
    fn new(which: Which, server: Option<&str>) -> Self {
        let kept = KeptValues { server: server.map(str::to_owned), data: which.folder() };
        Self { which, kept }
    }

    fn card(&self) -> CardArgs {
        CardArgs { data: self.which.folder(), machine: self.which.machine.clone() }
    }

    /// The value of a name; nothing where it has none.
    fn value(&self, named: &Named) -> Result<Option<String>> {
        Ok(match named {
            Named::Setting(setting) => Some(setting.get(&self.which.machine()?).to_string()),
            Named::Line(line) => Some(u8::from(self.card().is_on(*line)?).to_string()),
            Named::Command(letters) => {
                let lines = settings::lines(&self.which.place())?;
                let values = |line: &String| Some(line.strip_prefix(letters)?[1..].to_owned());
                lines.iter().find_map(values)
            }
            Named::Variable(number) => {
                let all = sysvars::all(&self.which.place(), None)?;
                let mut values = all.into_iter().map(|(it, value)| (it.number.to_string(), value));
                values.find(|(it, _)| it == number).map(|(_, value)| value.display())
            }
            Named::Kept(key) => self.kept.get(key)?,
        })
    }

    /// Lists everything that has a word in its name; `true` where there is something.
    fn list(&self, word: &str) -> Result<bool> {
        let small = word.to_lowercase();
        let fits = |name: &str| name.to_lowercase().contains(&small);
        let mut text = machine::listed(Some(word), &self.which.machine()?);
        text.push_str(&match self.which.machine.controller() {
            Some(_) => switch_lines(&self.card(), fits)?,
            None => card_lines(&self.card(), fits)?,
        });
        for (variable, value) in sysvars::all(&self.which.place(), None)? {
            if fits(variable.name) {
                text.push_str(&sysvars::line(&variable, &value));
            }
        }
        for (key, value) in self.kept.all()?.into_iter().filter(|(key, _)| fits(key)) {
            text.push_str(&format!("{key} = {value}\n"));
        }
        out::print(&text);
        Ok(!text.is_empty())
    }
}

/// The inputs and outputs whose names fit, a line each.
fn card_lines(card: &CardArgs, fits: impl Fn(&str) -> bool) -> Result<String> {
    let ports = card.ports()?;
    let sides = [("out", true, OUTPUT_BITS), ("in", false, INPUT_BITS)];
    let all = sides.into_iter().flat_map(|(side, is_output, bits)| {
        bits.iter().map(move |bit| (format!("{side}.{}", bit.name), is_output, bit))
    });
    let fitting = all.filter(|(name, ..)| fits(name));
    let line = |(name, is_output, bit): (String, bool, &Bit)| {
        format!("{name} = {}  {}\n", u8::from(ports.is_on(is_output, bit)), bit.about)
    };
    Ok(fitting.map(line).collect())
}

/// The inputs and outputs of a controller whose names fit, a line each.
fn switch_lines(card: &CardArgs, fits: impl Fn(&str) -> bool) -> Result<String> {
    let name = |it: &State| {
        let side = if it.is_output { "out" } else { "in" };
        format!("{side}.{}", it.address)
    };
    let all = Switches::of(card).states()?()?;
    let fitting = all.iter().filter(|it| fits(&name(it)) || fits(&it.name));
    let line = |it: &State| format!("{} = {}  {}\n", name(it), u8::from(it.on), it.name);
    Ok(fitting.map(line).collect())
}

/// Tells that nothing has a name, and which one may be meant. A key of programs may have no value yet.
fn nothing_called(name: &str) -> Result<Exit> {
    if is_usual(name) {
        eprintln!("kerf: {name} has no value");
        return Ok(Exit::Failed);
    }
    let bits = OUTPUT_BITS.iter().chain(INPUT_BITS).map(|bit| bit.name);
    let names = table::settings().map(|setting| setting.key).chain(bits);
    let near = kerf_diag::did_you_mean(name, names);
    let hint = near.unwrap_or_else(|| "kerf get lists everything that has a value".into());
    bail!(Usage(format!("{name} has no value; {hint}")))
}

pub fn get(args: &GetArgs) -> Result<Exit> {
    let which = Which::looking(&args.machine, &args.data);
    let places = Places::new(which, args.server.as_deref());
    if args.names.is_empty() {
        places.list("")?;
    }
    for name in &args.names {
        match places.value(&Named::of(name, &args.machine))? {
            Some(value) if args.names.len() == 1 => out::print(&format!("{value}\n")),
            Some(value) => out::print(&format!("{name} = {value}\n")),
            None if places.list(name)? => {}
            None => return nothing_called(name),
        }
    }
    Ok(Exit::Good)
}

pub fn set(args: &SetArgs) -> Result<Exit> {
    let places = Places::new(args.which.clone(), args.server.as_deref());
    for (name, value) in &args.pairs {
        match Named::of(name, &args.which.machine) {
            Named::Setting(setting) => machine::set(&args.which, setting, &Value::typed(value))?,
            Named::Line(line) => {
                let on = level(name, value)?;
                let exit = switched(&places.card(), line, on, args.arm)?;
                if exit != Exit::Good {
                    return Ok(exit);
                }
            }
            Named::Command(letters) => bail!(Usage(format!(
                "{letters} is a command, which is carried out: kerf send '{letters},{value}'"
            ))),
            Named::Variable(number) => bail!(Usage(format!(
                "%({number}) is a system variable: the machine sets it, everybody else reads it"
            ))),
            Named::Kept(key) => set_kept(&places.kept, &key, value)?,
        }
    }
    Ok(Exit::Good)
}

fn switched(card: &CardArgs, line: Line, on: bool, arm: bool) -> Result<Exit> {
    match line {
        Line::Bit(is_output, bit) => card.switch((is_output, bit), on, arm).map(|_| Exit::Good),
        Line::Switch(switch) => Switches::of(card).set(switch, on, ServerArgs { arm }),
    }
}

fn level(name: &str, value: &str) -> Result<bool> {
    match value.trim() {
        "0" => Ok(false),
        "1" => Ok(true),
        _ => bail!(Usage(format!("{name} is 0 or 1, not '{value}'"))),
    }
}

/// Tells whether a key begins as those of the handbook do, with u or $.
fn is_usual(key: &str) -> bool {
    let mut letters = key.rsplit(['/', '\\']).next().unwrap_or(key).chars();
    match letters.next() {
        Some('$') => true,
        Some('u') => letters.next().is_some_and(char::is_uppercase),
        _ => false,
    }
}

/// Sets a value of programs. A key that is new begins as those of the handbook do, with u or $: anything else is taken
/// for a misspelt name.
fn set_kept(kept: &KeptValues, key: &str, value: &str) -> Result<()> {
    if !is_usual(key) && kept.get(key)?.is_none() {
        let names = table::settings().map(|setting| setting.key);
        let near = kerf_diag::did_you_mean(key, names);
        let near = near.map_or_else(String::new, |it| format!("{it} "));
        bail!(Usage(format!(
            "there is no setting and no output {key}; {near}kerf get lists them; kerf registry set {key} '{value}' keeps a value of this \
             name for programs"
        )));
    }
    kept.set(key, Some(value).filter(|value| !value.is_empty()))
}
