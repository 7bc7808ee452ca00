//! `kerf io`: the inputs and outputs of a machine, by hand.

mod states;
mod switches;

pub use states::State;
pub use switches::{Switch, Switches};

use super::by_hand::ServerArgs;
use super::card::{CardArgs, Line};
use crate::exit::{Exit, Usage};
use crate::summary::told_by_server;
use crate::waveforms::VcdArgs;
use crate::{out, parse};
use anyhow::{Result, bail};
use clap::{Args, Subcommand, ValueEnum};
use kerf_machine::lines::{Input, Output};
use kerf_machine::settings::motors::Motor;
use kerf_machine::wiring::{self, Bit, CARDS, Port, Terminal};
use kerf_program::OutputReason;
use kerf_trace::{Event, Sink};
use states::States;

/// Lists, reads and switches inputs and outputs, steps motors, shows how cards are wired
#[derive(Args)]
#[command(
    after_help = "Examples:\n  kerf io list\n  kerf io set tool2 1\n  kerf io set in.xhome 1\n  \
    kerf io list --machine grbl:/dev/ttyUSB0\n  kerf io set flood 1 --machine grbl:/dev/ttyUSB0\n  kerf io step x +\n  kerf io map --card pci --notes\n\nWhere a kerf serve has the machine of the data folder, its ports are meant: what is set and \
    stepped goes through it,\nas whoever drives it. Outputs and motors take an armed machine (--arm). A controller has the outputs that it tells of; one\nthat is switched on stays on until it is switched off.\n\nExit codes: 0 done, 1 failed, 2 the command line was wrong"
)]
pub struct IoArgs {
    #[command(subcommand)]
    action: Action,
    #[command(flatten)]
    card: CardArgs,
}

#[derive(Subcommand)]
enum Action {
    /// Lists every input and output with its state
    List,
    /// Prints the state of an input or output, 0 or 1, as kerf get does; of an input what it reads
    Get {
        /// Its name, port and bit, or number: tool2, B2, in.jig1, out.2, in.1
        name: String,
    },
    /// Switches an output, as kerf set does, or sets an input of the simulated machine; --vcd traces it
    Set {
        /// Its name, port and bit, or number: tool2, B2, in.jig1, out.2; of a controller spindle, flood, mist
        name: String,
        /// 0 or 1; of an input the level of its pin
        #[arg(value_parser = clap::value_parser!(u8).range(0..=1))]
        value: u8,
        #[command(flatten)]
        vcd: VcdArgs,
        #[command(flatten)]
        there: ServerArgs,
    },
    /// Steps a motor once
    Step {
        /// x, y, z, w, q or r
        motor: String,
        /// + or -
        #[arg(value_enum, allow_hyphen_values = true)]
        way: IoAction,
        #[command(flatten)]
        there: ServerArgs,
    },
    /// Prints every change of an input or output as it happens
    Watch {
        /// Ends after so many seconds
        #[arg(long = "for", value_name = "SECONDS", value_parser = parse::not_negative)]
        seconds: Option<f64>,
    },
    /// Prints where the bits come out on a card
    Map {
        /// pci, io or box
        #[arg(long)]
        card: String,
        /// Prints what is to be known for wiring it
        #[arg(long)]
        notes: bool,
    },
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum IoAction {
    #[value(name = "+")]
    Forward,
    #[value(name = "-")]
    Back,
}

pub fn run(args: &IoArgs) -> Result<Exit> {
    match &args.action {
        Action::List => {
            out::print(&states(args)?()?.iter().map(State::line).collect::<String>());
        }
        Action::Get { name } => {
            let on = args.card.is_on(args.card.line(name)?)?;
            out::print(&format!("{}\n", u8::from(on)));
        }
        Action::Set { name, value, vcd, there } => {
            return set(args, name, *value == 1, vcd, *there);
        }
        Action::Step { motor, way, there } => {
            return step(args, motor, *way == IoAction::Forward, *there);
        }
        Action::Watch { seconds } => states::watch(states(args)?, *seconds)?,
        Action::Map { card, notes } => map(card, *notes)?,
    }
    Ok(Exit::Good)
}

/// The inputs and outputs of the machine: those that its controller tells, else those of its card.
fn states(args: &IoArgs) -> Result<States> {
    let card = args.card.clone();
    if card.machine.controller().is_some() {
        return Switches::of(&card).states();
    }
    let machine = card.machine()?;
    Ok(Box::new(move || Ok(states::of_card(&card.ports()?, &machine))))
}

fn set(args: &IoArgs, name: &str, on: bool, vcd: &VcdArgs, there: ServerArgs) -> Result<Exit> {
    let (is_output, bit) = match args.card.line(name)? {
        Line::Bit(is_output, bit) => (is_output, bit),
        Line::Switch(switch) => {
            if vcd.path().is_some() {
                bail!(Usage(format!("--vcd traces bits of the card: {} is none", switch.name())));
            }
            let exit = Switches::of(&args.card).set(switch, on, there)?;
            if exit == Exit::Good {
                out::print(&format!("{} = {}\n", switch.name(), u8::from(on)));
            }
            return Ok(exit);
        }
    };
    let ports = args.card.switch((is_output, bit), on, there.arm)?;
    let byte = if is_output { ports.output(bit.port) } else { ports.input(bit.port) };
    let side = if is_output { "output" } else { "input" };
    out::print(&format!("{side} port {} = 0x{byte:02X}\n", bit.port.letter()));
    traced(args, vcd, is_output, bit.name, ports.is_on(is_output, bit))?;
    Ok(Exit::Good)
}

/// The change as signals, where a file for them is named.
fn traced(args: &IoArgs, vcd: &VcdArgs, is_output: bool, name: &str, on: bool) -> Result<()> {
    let mut signals = vcd.sink(args.card.machine()?, None)?;
    let changed = match is_output {
        true => Output::of_name(name).map(|line| Event::Output {
            n: line.number(),
            on,
            t: 0.0,
            why: OutputReason::Program,
            name: Some(line.name()),
        }),
        false => Input::of_name(name).map(|line| Event::Input {
            n: line.number(),
            on,
            t: 0.0,
            name: Some(line.name()),
        }),
    };
    if let (Some(signals), Some(changed)) = (&mut signals, changed) {
        signals.event(&changed);
    }
    vcd.finish(signals)
}

fn step(args: &IoArgs, name: &str, forward: bool, there: ServerArgs) -> Result<Exit> {
    if let Some(controller) = args.card.machine.controller() {
        bail!(Usage(format!(
            "{controller} makes the steps of its motors itself: kerf machine move to --relative moves an axis"
        )));
    }
    let Some(motor) = Motor::ALL.into_iter().find(|it| it.word().eq_ignore_ascii_case(name)) else {
        bail!(Usage(format!("there is no motor {name}: x, y, z, w, q or r")));
    };
    let machine = args.card.machine()?;
    let way = machine.motors.axis_of(motor).map(|axis| {
        let by = 1.0 / machine.program.resolution.steps_per_unit[axis];
        format!(", {} {:+.4}", machine.motors.axis_name(axis), if forward { by } else { -by })
    });
    if let Some(card) = args.card.served(there.arm)? {
        let exit = told_by_server(&card.step(motor.word(), forward)?, true);
        if exit == Exit::Good {
            out::print(&format!("{name} step{}\n", way.unwrap_or_default()));
        }
        return Ok(exit);
    }
    let (ports, bytes) = args.card.change(|ports, _| Ok(ports.step(motor, forward, false)?))?;
    let port = if matches!(motor, Motor::Q | Motor::R) { Port::C } else { Port::A };
    out::print(&format!(
        "{name} step {} (port {} 0x{:02X}, 0x{:02X}){}\n",
        ports.steps(motor),
        port.letter(),
        bytes[0],
        bytes[1],
        way.unwrap_or_default()
    ));
    Ok(Exit::Good)
}

fn map(card: &str, notes: bool) -> Result<()> {
    let Some(card) = wiring::wiring(card) else {
        let names: Vec<_> = CARDS.iter().map(|card| card.name).collect();
        bail!(Usage(format!("there is no card {card}: {}", names.join(", "))));
    };
    let line = |it: &Terminal| {
        let address = it.bit().map(Bit::address).unwrap_or_default();
        format!("{:<11} {:<9} {:<18} {address:<3} {}", it.group, it.pin, it.signal, it.note)
    };
    let mut lines: Vec<String> = card.terminals.iter().map(line).collect();
    if notes {
        lines.extend(card.notes.iter().map(|note| format!("# {note}")));
    }
    out::print(&lines.iter().map(|line| format!("{}\n", line.trim_end())).collect::<String>());
    Ok(())
}
