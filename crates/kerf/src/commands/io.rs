//! `kerf io`: the inputs and outputs of the simulated machine, by hand.

use super::by_hand::Beside;
use crate::args::DataArgs;
use crate::exit::{Exit, Usage};
use crate::machine_name::MachineChoice;
use crate::remote::{Card, beside};
use crate::summary::told_by_server;
use crate::waveforms::VcdArgs;
use crate::{memory, out, parse, setup};
use anyhow::{Result, bail};
use clap::{Args, Subcommand, ValueEnum};
use kerf_control::journal::Journal;
use kerf_control::{Event, Press, Sink};
use kerf_machine::Configuration;
use kerf_machine::lines::{Input, Output, line_of_pin};
use kerf_machine::settings::motors::Motor;
use kerf_machine::wiring::{self, Bit, CARDS, INPUT_BITS, OUTPUT_BITS, Port, Terminal};
use kerf_program::{AxisSet, OutputReason};
use kerf_sim::Machine;
use kerf_sim::ports::Ports;
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
    data: DataArgs,
    #[command(flatten)]
    machine: MachineChoice,
}

#[derive(Subcommand)]
enum Action {
    /// Lists every bit with its state
    List,
    /// Prints the state of a bit, 0 or 1; of an input what it reads
    Get {
        /// Its name, or port and bit: tool2, B2, in.jig1
        name: String,
    },
    /// Switches an output, or sets an input of the simulated machine
    Set {
        /// Its name
        name: String,
        /// 0 or 1; of an input the level of its pin
        #[arg(value_parser = clap::value_parser!(u8).range(0..=1))]
        value: u8,
        #[command(flatten)]
        vcd: VcdArgs,
        #[command(flatten)]
        beside: Beside,
    },
    /// Steps a motor once
    Step {
        /// x, y, z, w, q or r
        motor: String,
        /// + or -
        #[arg(value_enum, allow_hyphen_values = true)]
        way: Way,
        #[command(flatten)]
        beside: Beside,
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

/// Under which key the ports are kept.
const KEY: &str = "IoPorts";

/// Interval at which changes are looked for.
const LOOK: Duration = Duration::from_millis(50);

pub fn run(args: &IoArgs) -> Result<Exit> {
    args.machine.simulated("kerf io")?;
    match &args.action {
        Action::List => {
            list(&args.ports()?, &args.machine()?);
        }
        Action::Get { name } => {
            let (is_output, bit) = known(name)?;
            out::print(&format!("{}\n", u8::from(args.ports()?.is_on(is_output, bit))));
        }
        Action::Set { name, value, vcd, beside } => set(args, name, *value == 1, vcd, *beside)?,
        Action::Step { motor, way, beside } => {
            return step(args, motor, *way == Way::Forward, *beside);
        }
        Action::Watch { seconds } => watch(args, *seconds)?,
        Action::Map { card, notes } => map(card, *notes)?,
    }
    Ok(Exit::Good)
}

impl IoArgs {
    fn folder(&self) -> DataArgs {
        self.data.clone()
    }

    fn journal(&self, looks: bool) -> Result<Option<Journal>> {
        memory::journal(&setup::data_folder(&self.folder())?, looks)
    }

    fn machine(&self) -> Result<Configuration> {
        setup::machine(&self.machine, &self.folder())
    }

    /// The card of the machine that a running server has; it is armed first where that is wanted.
    fn served(&self, arm: bool) -> Result<Option<Card>> {
        let server = beside(&self.folder(), &self.machine)?;
        Ok(server.map(|server| Card::of(server, arm)))
    }

    /// The ports as they are; of inputs what they read.
    fn ports(&self) -> Result<Ports> {
        if let Some(card) = self.served(false)? {
            return card.ports();
        }
        self.kept()
    }

    /// The ports of the data folder, which nobody serves.
    fn kept(&self) -> Result<Ports> {
        let journal = self.journal(true)?;
        let (mut ports, mut moved) = (Ports::default(), Vec::new());
        if let Some(journal) = &journal {
            ports = journal.value(KEY)?.as_deref().and_then(Ports::read).unwrap_or_default();
            moved = journal.switches()?;
        }
        let machine = self.machine()?;
        let untouched = Machine::default().equipped(&machine, AxisSet::EMPTY);
        for bit in INPUT_BITS {
            let line = line_of_pin(bit);
            let level = moved.iter().find(|(number, _)| *number == line).map(|(_, level)| *level);
            let reads = |level: bool| machine.io.line_reads(line, level);
            ports.set_input(bit, level.map_or_else(|| untouched.input(line), reads));
        }
        Ok(ports)
    }

    /// Changes the ports, unless a run owns the machine.
    fn change<T>(
        &self,
        change: impl FnOnce(&mut Ports, Option<&Journal>) -> Result<T>,
    ) -> Result<(Ports, T)> {
        let journal = self.journal(false)?;
        let _owner = journal.as_ref().map(Journal::own).transpose()?;
        let mut ports = self.kept()?;
        let answer = change(&mut ports, journal.as_ref())?;
        if let Some(journal) = &journal {
            journal.set_value(KEY, Some(&ports.write()))?;
        }
        Ok((ports, answer))
    }
}

fn known(name: &str) -> Result<(bool, &'static Bit)> {
    match wiring::bit(name) {
        Some(found) => Ok(found),
        None => {
            let names = OUTPUT_BITS.iter().chain(INPUT_BITS).map(|bit| bit.name);
            let hint = kerf_diag::did_you_mean(name, names)
                .unwrap_or_else(|| "kerf io list shows every bit".into());
            bail!(Usage(format!("no bit is called {name}; {hint}")))
        }
    }
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

fn set(args: &IoArgs, name: &str, on: bool, vcd: &VcdArgs, beside: Beside) -> Result<()> {
    let (is_output, bit) = known(name)?;
    let reads = || Ok::<_, anyhow::Error>(args.machine()?.io.line_reads(line_of_pin(bit), on));
    let ports = match args.served(beside.arm)? {
        Some(card) if is_output => card.switch(bit, on)?,
        Some(card) => card.press(bit, reads()?)?,
        None => set_here(args, is_output, bit, on)?,
    };
    let byte = if is_output { ports.output(bit.port) } else { ports.input(bit.port) };
    let side = if is_output { "output" } else { "input" };
    out::print(&format!("{side} port {} = 0x{byte:02X}\n", bit.port.letter()));
    traced(args, vcd, is_output, bit.name, ports.is_on(is_output, bit))
}

/// Sets a bit of a machine that nobody serves.
fn set_here(args: &IoArgs, is_output: bool, bit: &Bit, on: bool) -> Result<Ports> {
    let machine = args.machine()?;
    let (ports, ()) = args.change(|ports, journal| {
        if is_output {
            return Ok(ports.set_output(bit, on, false)?);
        }
        let number = line_of_pin(bit);
        ports.set_input(bit, machine.io.line_reads(number, on));
        // Whatever runs next finds the switch where it was left.
        journal.map_or(Ok(()), |journal| journal.move_switch(Press { number, on }))?;
        Ok(())
    })?;
    Ok(ports)
}

/// The change as signals, where a file for them is named.
fn traced(args: &IoArgs, vcd: &VcdArgs, is_output: bool, name: &str, on: bool) -> Result<()> {
    let mut signals = vcd.sink(args.machine()?)?;
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

fn step(args: &IoArgs, name: &str, forward: bool, beside: Beside) -> Result<Exit> {
    let Some(motor) = Motor::ALL.into_iter().find(|it| it.word().eq_ignore_ascii_case(name)) else {
        bail!(Usage(format!("there is no motor {name}: x, y, z, w, q or r")));
    };
    let machine = args.machine()?;
    let way = machine.motors.axis_of(motor).map(|axis| {
        let by = 1.0 / machine.program.resolution.steps_per_unit[axis];
        format!(", {} {:+.4}", machine.motors.axis_name(axis), if forward { by } else { -by })
    });
    if let Some(card) = args.served(beside.arm)? {
        let exit = told_by_server(&card.step(motor.word(), forward)?, true);
        if exit == Exit::Good {
            out::print(&format!("{name} step{}\n", way.unwrap_or_default()));
        }
        return Ok(exit);
    }
    let (ports, bytes) = args.change(|ports, _| Ok(ports.step(motor, forward, false)?))?;
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
    let mut before = args.ports()?;
    while seconds.is_none_or(|most| began.elapsed().as_secs_f64() < most) {
        thread::sleep(LOOK);
        let now = args.ports()?;
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
