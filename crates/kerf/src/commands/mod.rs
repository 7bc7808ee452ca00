//! The subcommands, one file each.

mod axis_words;
mod board;
mod by_hand;
mod card;
mod check;
mod controller_card;
mod controller_settings;
mod convert;
mod datum;
mod draw;
mod explain;
mod fmt;
mod heights;
mod help;
mod io;
mod kept_values;
mod known_boards;
mod log;
mod machine;
mod map;
mod pace;
mod parts;
mod plot;
mod preview;
mod protect;
mod prove;
mod receive;
mod registry;
mod run;
mod samples;
mod sb3;
mod send;
mod serve;
mod settings;
mod shop;
mod step_board;
mod sysvars;
mod time;
mod timing;
mod tool_table;
mod toolpath;
mod trace;
mod values;
mod wavlength;
mod which;
mod wire;
mod zeros;

use crate::exit::{Exit, Usage};
use crate::folders;
use crate::machine_choice::MachineChoice;
use crate::machine_file;
use crate::outputs::Outputs;
use crate::unused;
use anyhow::{Result, bail};
use clap::{ArgMatches, Subcommand};

/// What `kerf` can be told to do.
#[derive(Subcommand)]
pub enum Command {
    Run(run::RunCommand),
    Send(send::SendArgs),
    Receive(receive::ReceiveArgs),
    Serve(serve::ServeArgs),
    Settings(settings::SettingsArgs),
    Check(check::CheckArgs),
    Preview(preview::PreviewArgs),
    Plot(plot::PlotArgs),
    Time(time::TimeArgs),
    Timing(timing::TimingArgs),
    Heights(heights::HeightsArgs),
    Map(map::MapArgs),
    Trace(trace::TraceArgs),
    Fmt(fmt::FmtArgs),
    Draw(draw::DrawArgs),
    Convert(convert::ConvertArgs),
    #[command(visible_alias = "path")]
    Toolpath(toolpath::ToolpathArgs),
    Explain(explain::ExplainArgs),
    Help(help::HelpArgs),
    Wavlength(wavlength::WavlengthArgs),
    #[command(visible_alias = "reg")]
    Registry(registry::RegistryArgs),
    Log(log::LogArgs),
    Sb3(sb3::Sb3Args),
    Sysvars(sysvars::SysvarsArgs),
    Samples(samples::SamplesArgs),
    Parts(parts::PartsArgs),
    Get(values::GetArgs),
    Set(values::SetArgs),
    Machine(machine::MachineArgs),
    Io(io::IoArgs),
}

impl Command {
    /// The command as the version for editing alone has it; what it has not is refused.
    pub fn restricted(self, edit_only: bool) -> Result<Self> {
        let moves_a_machine = matches!(
            self,
            Self::Run(_)
                | Self::Sb3(_)
                | Self::Set(_)
                | Self::Machine(_)
                | Self::Io(_)
                | Self::Map(_)
                | Self::Registry(_)
        );
        let moves_a_machine =
            moves_a_machine || matches!(&self, Self::Send(args) if !args.is_file());
        match self {
            _ if edit_only && moves_a_machine => {
                bail!(Usage("not available in editing version".into()))
            }
            Self::Serve(args) => Ok(Self::Serve(args.drawing_only(edit_only))),
            other => Ok(other),
        }
    }

    /// The command as it was given, unless not all of it would be heeded.
    pub fn heeding(self, cli: &clap::Command, given: &ArgMatches) -> Result<Self> {
        MachineChoice::refuse_two(given)?;
        machine_file::refuse_missing(given)?;
        folders::refuse_missing(given)?;
        unused::refuse(cli, given)?;
        let heeded = match &self {
            Self::Run(args) => args.heeded(),
            Self::Send(args) => args.heeded(),
            _ => None,
        };
        if let Some(heeded) = heeded {
            heeded.refuse_others(cli, given)?;
        }
        Ok(self)
    }
}

impl Command {
    /// The files that it writes, as its options name them.
    fn outputs(&self) -> Outputs {
        match self {
            Self::Run(args) => args.outputs(),
            Self::Send(args) => args.outputs(),
            Self::Preview(args) => args.outputs(),
            Self::Plot(args) => args.outputs(),
            Self::Timing(args) => args.outputs(),
            Self::Heights(args) => args.outputs(),
            Self::Draw(args) => args.outputs(),
            Self::Convert(args) => args.outputs(),
            Self::Toolpath(args) => args.outputs(),
            _ => Outputs::default(),
        }
    }
}

/// Does it, unless it would replace a file that may not be replaced.
pub fn run(command: Result<Command>) -> Result<Exit> {
    let command = command?;
    if let Command::Run(args) = &command {
        args.spare_what_it_reads()?;
    }
    let outputs = command.outputs();
    outputs.around(|| carry_out(command))
}

fn carry_out(command: Command) -> Result<Exit> {
    match command {
        Command::Run(args) => run::run(&args),
        Command::Send(args) => send::run(&args),
        Command::Receive(args) => receive::run(&args),
        Command::Serve(args) => serve::run(&args),
        Command::Settings(args) => settings::run(args),
        Command::Check(args) => check::run(&args),
        Command::Preview(args) => preview::run(&args),
        Command::Plot(args) => plot::run(&args),
        Command::Time(args) => time::run(&args),
        Command::Timing(args) => timing::run(&args),
        Command::Heights(args) => heights::run(&args),
        Command::Trace(args) => trace::run(&args),
        Command::Fmt(args) => fmt::run(&args),
        Command::Draw(args) => draw::run(&args),
        Command::Convert(args) => convert::run(&args),
        Command::Toolpath(args) => toolpath::run(&args),
        Command::Samples(args) => samples::run(&args),
        Command::Parts(args) => parts::run(&args),
        Command::Get(args) => values::get(&args),
        Command::Set(args) => values::set(&args),
        Command::Machine(args) => machine::run(&args),
        Command::Io(args) => io::run(&args),
        Command::Map(args) => map::run(&args),
        Command::Sysvars(args) => sysvars::run(&args),
        Command::Registry(args) => registry::run(&args),
        Command::Log(args) => log::run(&args),
        Command::Sb3(args) => sb3::run(&args),
        Command::Wavlength(args) => wavlength::run(&args),
        Command::Explain(args) => explain::run(&args),
        Command::Help(args) => help::run(&args),
    }
}
