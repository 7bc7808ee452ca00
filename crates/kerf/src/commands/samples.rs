//! `kerf samples`: part files to begin with.

use crate::exit::Exit;
use crate::out;
use anyhow::{Context, Result};
use clap::Args;
use kerf_files::{Disk, MACHINES, RealDisk, SAMPLES};
use std::path::PathBuf;

/// Puts sample part files, whose names begin with S_, into a folder
///
/// Files that are there already stay as they are.
#[derive(Args)]
#[command(after_help = "Example: kerf samples parts")]
pub struct SamplesArgs {
    /// The part folder
    #[arg(default_value = ".")]
    folder: PathBuf,
    /// Settings files of machines instead: run the one of yours once, its settings stay
    #[arg(long)]
    machines: bool,
}

pub fn run(args: &SamplesArgs) -> Result<Exit> {
    let mut disk = RealDisk;
    let folder = args.folder.display();
    disk.make_folder(&args.folder).with_context(|| format!("cannot make {folder}"))?;
    let files = if args.machines { MACHINES } else { SAMPLES };
    for sample in files {
        let path = args.folder.join(sample.name);
        if disk.is_file(&path) {
            out::print(&format!("{} is there already\n", path.display()));
            continue;
        }
        disk.write(&path, sample.text.as_bytes())
            .with_context(|| format!("cannot write {}", path.display()))?;
        out::print(&format!("{}\n", path.display()));
    }
    Ok(Exit::Good)
}
