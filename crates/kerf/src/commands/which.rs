//! The machine whose configuration a command shows or changes.

use super::protect;
use crate::args::{PlaceArgs, Start};
use crate::data_args::DataArgs;
use crate::machine_choice::MachineChoice;
use crate::{machine_file, setup};
use anyhow::Result;
use clap::Args;
use kerf_journal::machine_file::MachineFile;
use kerf_machine::Configuration;

/// The machine whose configuration is meant.
#[derive(Args, Clone, Debug)]
pub struct Which {
    #[command(flatten)]
    pub machine: MachineChoice,
    #[command(flatten)]
    data: DataArgs,
    /// The password of the settings, where they are protected [default: KERF_PASSWORD]; asked for at a
    /// terminal
    #[arg(long, value_name = "WORD", global = true)]
    password: Option<String>,
}

impl Which {
    /// The machine as a command looks at it that changes nothing.
    pub fn looking(machine: &MachineChoice, data: &DataArgs) -> Self {
        Self { machine: machine.clone(), data: data.clone(), password: None }
    }

    pub fn folder(&self) -> DataArgs {
        self.data.clone()
    }

    /// The machine as it was left, with its folders.
    pub fn place(&self) -> PlaceArgs {
        PlaceArgs {
            machine: self.machine.clone(),
            parts: None,
            custom: None,
            allow_path: Vec::new(),
            data: self.folder(),
            start: Some(Start::Kept),
            allow_shell: false,
        }
    }

    /// The machine.
    pub fn machine(&self) -> Result<Configuration> {
        setup::machine(&self.machine, &self.folder())
    }

    /// The file that changes go to, once the password was given.
    pub fn to_change(&self) -> Result<MachineFile> {
        let file = self.file()?;
        let text = file.text()?.unwrap_or_default();
        // A file with mistakes has to be mended: it protects nothing.
        if let Ok(said) = file.read(&text) {
            protect::open(&said, self.password.as_deref())?;
        }
        match self.machine.configuration() {
            Some(_) => Ok(file),
            None => machine_file::of_data_to_change(&self.folder()),
        }
    }

    /// The configuration's file.
    pub fn file(&self) -> Result<MachineFile> {
        machine_file::of(&self.machine, &self.folder())
    }
}
