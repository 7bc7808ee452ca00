//! `kerf io`: the inputs and outputs of the simulated machine, by hand.

use super::by_hand::ServerArgs;
use super::card::{self, CardArgs};
use crate::exit::{Exit, Usage};
use crate::summary::told_by_server;
use crate::waveforms::VcdArgs;
use crate::{out, parse};
use anyhow::{Result, bail};
use clap::{Args, Subcommand, ValueEnum};
use kerf_machine::Configuration;
use kerf_machine::lines::{Input, Output};
use kerf_machine::settings::motors::Motor;
use kerf_machine::wiring::{self, Bit, CARDS, INPUT_BITS, OUTPUT_BITS, Port, Terminal};
use kerf_model::ports::Ports;
use kerf_program::OutputReason;
use kerf_trace::{Event, Sink};
use std::thread;
use std::time::{Duration, Instant};

/// Lists, reads and sets the ports of the simulated machine, steps its motors, shows how cards are wired
#[derive(Args)]
#[command(
    after_help = "Examples:\n  kerf io list\n  kerf io set tool2 1\n  kerf io set in.xhome 1\n  \
    kerf io step x +\n  kerf io map --card pci --notes\n\nWhere a kerf serve has the machine of the data folder, its ports are meant: what is set and \
    stepped goes through it,\nas whoever drives it. Outputs and motors take an armed machine (--arm).\n\nExit codes: 0 done, 1 failed, 2 the command line was wrong"
)]
pub struct IoArgs {
    #[command(subcommand)]
    action: Action,
    #[command(flatten)]
    card: CardArgs,
}

#[derive(Subcommand)]
enum Action {
    /// Lists every bit with its state
    List,
    /// Prints the state of a bit, 0 or 1, as kerf get does; of an input what it reads
    #[command(hide = true)]
    Get {
        /// Its name, or port and bit: tool2, B2, in.jig1
        name: String,
    },
    /// Switches an output, or sets an input of the simulated machine, as kerf set does; --vcd traces it
    Set {
        /// Its name
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
        way: Way,
        #[command(flatten)]
        there: ServerArgs,
    },
    /// Prints every change of a bit as it happens
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
enum Way {
    #[value(name = "+")]
    Forward,
    #[value(name = "-")]
    Back,
}

/// Interval at which changes are looked for.
const LOOK: Duration = Duration::from_millis(50);

pub fn run(args: &IoArgs) -> Result<Exit> {
    args.card.machine.simulated("kerf io switches")?;
    match &args.action {
        Action::List => {
            list(&args.card.ports()?, &args.card.machine()?);
        }
        Action::Get { name } => {
            let (is_output, bit) = card::known(name)?;
            out::print(&format!("{}\n", u8::from(args.card.ports()?.is_on(is_output, bit))));
        }
        Action::Set { name, value, vcd, there } => set(args, name, *value == 1, vcd, *there)?,
        Action::Step { motor, way, there } => {
            return step(args, motor, *way == Way::Forward, *there);
        }
        Action::Watch { seconds } => watch(args, *seconds)?,
        Action::Map { card, notes } => map(card, *notes)?,
    }
    Ok(Exit::Good)
}

fn list(ports: &Ports, machine: &Configuration) {
    let mut lines = String::new();
    for (word, is_output, bits) in [("output", true, OUTPUT_BITS), ("input", false, INPUT_BITS)] {
        for bit in bits {
            let aliases = bit.aliases.join(", ");
            let input = Input::named(bit.name).filter(|_| !is_output);
            let name = input.and_then(|it| machine.name_in_use(it)).unwrap_or(bit.name);
            lines.push_str(&format!(
                "{word:<7}{:<4}{name:<18}{} {aliases:<22}{}\n",
                bit.address(),
                u8::from(ports.is_on(is_output, bit)),
                bit.about
            ));
        }
    }
    out::print(&lines);
}

fn set(args: &IoArgs, name: &str, on: bool, vcd: &VcdArgs, there: ServerArgs) -> Result<()> {
    let (is_output, bit) = card::known(name)?;
    let ports = args.card.switch((is_output, bit), on, there.arm)?;
    let byte = if is_output { ports.output(bit.port) } else { ports.input(bit.port) };
    let side = if is_output { "output" } else { "input" };
    out::print(&format!("{side} port {} = 0x{byte:02X}\n", bit.port.letter()));
    traced(args, vcd, is_output, bit.name, ports.is_on(is_output, bit))
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

fn watch(args: &IoArgs, seconds: Option<f64>) -> Result<()> {
    let began = Instant::now();
    let mut before = args.card.ports()?;
    while seconds.is_none_or(|most| began.elapsed().as_secs_f64() < most) {
        thread::sleep(LOOK);
        let now = args.card.ports()?;
        for (side, is_output, bits) in [("output", true, OUTPUT_BITS), ("input", false, INPUT_BITS)]
        {
            let changed = |bit: &&Bit| before.is_on(is_output, bit) != now.is_on(is_output, bit);
            for bit in bits.iter().filter(changed) {
                let on = u8::from(now.is_on(is_output, bit));
                out::print(&format!("{side} {} {} {on}\n", bit.address(), bit.name));
            }
        }
        before = now;
    }
    Ok(())
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
