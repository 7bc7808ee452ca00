//! The machine that a command means, as its options name it.

use crate::data_args::DataArgs;
use crate::exit::Usage;
use crate::machine_name::{DriverName, MachineName};
use crate::named_machine;
use clap::error::ErrorKind;
use clap::{ArgMatches, Args, Command, FromArgMatches};
use std::path::{Path, PathBuf};

/// The names of a machine on the command line.
#[derive(Args, Clone, Debug, Default)]
struct Names {
    /// The machine: sim, the simulated one; grbl:PORT or grbl:PORT@BAUD, a controller of the grbl family at a serial
    /// port; grbl:tcp:HOST[:PORT] or grbl:ws:HOST[:PORT], one in the network; klipper:PORT, a board with step queues;
    /// linuxcnc:local, LinuxCNC on this computer, or linuxcnc:HOST[:PORT], where its bridge listens; or what it is like: a .toml file, a saved machine, a ready-made one. A controller and what the machine
    /// is like may both be given [default: sim, as the data folder has it]
    #[arg(
        id = MACHINE,
        long = MACHINE,
        alias = "driver",
        value_name = "NAME",
        value_parser = MachineName::read,
        global = true
    )]
    names: Vec<MachineName>,
    /// What the machine is like, as scripts name it: always a configuration, so that `sim` is the ready-made one.
    #[arg(id = CONFIG, long = CONFIG, value_name = "FILE", hide = true, global = true)]
    configuration: Option<PathBuf>,
}

/// The machine that a command means.
#[derive(Clone, Debug, Default)]
pub struct MachineChoice {
    given: Names,
    /// The controller that the named configuration tells of, where the command line names none.
    its_own: Option<DriverName>,
}

impl Args for MachineChoice {
    fn augment_args(command: Command) -> Command {
        Names::augment_args(command)
    }

    fn augment_args_for_update(command: Command) -> Command {
        Names::augment_args_for_update(command)
    }
}

impl FromArgMatches for MachineChoice {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        let names = Names::from_arg_matches(matches)?;
        let wrong = |Usage(why)| clap::Error::raw(ErrorKind::ValueValidation, why + "\n");
        Self::of(names, &DataArgs::given(matches)).map_err(wrong)
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}

/// The option.
const MACHINE: &str = "machine";

/// The older option that names a configuration only.
const CONFIG: &str = "config";

impl Names {
    /// A machine is named that is no configuration.
    fn driven(&self) -> Option<&MachineName> {
        self.names.iter().find(|name| !matches!(name, MachineName::Configured(_)))
    }

    fn configured(&self) -> Option<&Path> {
        self.names.iter().find_map(|name| match name {
            MachineName::Configured(path) => Some(&**path),
            _ => None,
        })
    }
}

impl MachineChoice {
    fn of(given: Names, data: &DataArgs) -> Result<Self, Usage> {
        let configured = given.configured().filter(|_| given.driven().is_none());
        let its_own = configured.map(|name| named_machine::controller(name, data)).transpose()?;
        Ok(Self { given, its_own: its_own.flatten() })
    }

    /// The machine of one name, with the folder in which saved machines lie.
    ///
    /// # Errors
    /// Its configuration names something that is no controller.
    pub fn named(name: MachineName, data: &DataArgs) -> Result<Self, Usage> {
        Self::of(Names { names: vec![name], configuration: None }, data)
    }

    /// Returns the name that stands for it: the configuration's, else the controller's.
    pub fn words(&self) -> String {
        let configured = self.configuration().map(|path| path.display().to_string());
        let driven = self.given.driven().map(ToString::to_string);
        configured.or(driven).unwrap_or_else(|| MachineName::Sim.to_string())
    }

    /// Returns the controller, where one is named, or the named configuration tells of one.
    pub fn controller(&self) -> Option<&DriverName> {
        self.named_controller().or(self.its_own.as_ref())
    }

    /// Returns the controller that the command line names itself.
    pub fn named_controller(&self) -> Option<&DriverName> {
        match self.given.driven()? {
            MachineName::Controller(name) => Some(name),
            _ => None,
        }
    }

    /// Returns the name of the configuration, where one is named: else that of the data folder holds.
    pub fn configuration(&self) -> Option<&Path> {
        self.given.configured().or(self.given.configuration.as_deref())
    }

    /// Refuses names that contradict each other, wherever a command has the option.
    ///
    /// # Errors
    /// Two machines, or two configurations.
    pub fn refuse_two(given: &ArgMatches) -> Result<(), Usage> {
        let Some((_, given)) = given.subcommand() else { return Ok(()) };
        let names = given.try_get_many::<MachineName>(MACHINE).ok().flatten();
        let configuration = given.try_get_one::<PathBuf>(CONFIG).ok().flatten();
        let configuration = configuration.map(|path| MachineName::Configured(path.clone()));
        let all: Vec<&MachineName> = names.into_iter().flatten().chain(&configuration).collect();
        let (configured, driven): (Vec<_>, Vec<_>) =
            all.into_iter().partition(|name| matches!(name, MachineName::Configured(_)));
        for of_kind in [configured, driven] {
            if let [first, second, ..] = of_kind.as_slice() {
                return Err(Usage(format!(
                    "--machine {first} and --machine {second} are two machines: leave one out"
                )));
            }
        }
        Self::refuse_two(given)
    }

    /// The configurations that the options of a command name.
    pub fn configured<'a>(given: &'a ArgMatches) -> Vec<&'a Path> {
        let names = given.try_get_many::<MachineName>(MACHINE).ok().flatten();
        let configured = |name: &'a MachineName| match name {
            MachineName::Configured(path) => Some(&**path),
            _ => None,
        };
        names.into_iter().flatten().filter_map(configured).collect()
    }
}
