//! `kerf parts`: the part files of a folder.

use crate::args::{Format, PlaceArgs};
use crate::exit::{Exit, Usage};
use crate::{out, setup};
use anyhow::{Context, Result};
use clap::Args;
use kerf_control::{Listing, PartFile};
use serde_json::json;
use std::path::{Path, PathBuf};

/// Lists the part files of a folder; ! marks those whose head tells about the job
///
/// The list is the one that the dialogs of FP and FG show.
#[derive(Args)]
#[command(after_help = "Examples:\n  kerf parts\n  kerf parts doors --mask 'proj??.sbp'\n  \
    kerf parts --headers")]
pub struct PartsArgs {
    /// The folder [default: the part folder, else the present one]
    #[arg(value_name = "FOLDER")]
    listed: Option<PathBuf>,
    /// Which files: * stands for any characters, ? for one
    #[arg(long, value_name = "MASK", default_value = "*.sb?")]
    mask: String,
    /// Prints what the heads tell
    #[arg(long)]
    headers: bool,
    /// How the list is written
    #[arg(long, value_enum, default_value = "text")]
    format: Format,
    #[command(flatten)]
    place: PlaceArgs,
}

pub fn run(args: &PartsArgs) -> Result<Exit> {
    let folder = args.listed.as_deref().or(args.place.parts.as_deref()).unwrap_or(Path::new(""));
    let place = PlaceArgs { parts: None, ..args.place.clone() };
    let mut shelf = setup::shelf(folder, &place, true)?;
    shelf.set_mask(Some(&args.mask));
    let cannot = || Usage(format!("cannot list {}", folder.display()));
    let listing = shelf.listing().with_context(cannot)?;
    out::print(&match args.format {
        Format::Text => as_text(&listing, args.headers),
        Format::Json => as_json(&listing),
    });
    Ok(Exit::Good)
}

fn as_text(listing: &Listing, headers: bool) -> String {
    let folders = listing.folders.iter().map(|name| format!("  {name}/\n"));
    folders.chain(listing.files.iter().map(|file| line(file, headers))).collect()
}

fn line(file: &PartFile, headers: bool) -> String {
    let Some(header) = &file.header else { return format!("  {}\n", file.name) };
    let mut text = format!("! {}\n", file.name);
    if headers {
        let lines = header.text.lines().filter(|line| !line.is_empty());
        text.extend(lines.map(|line| format!("      {line}\n")));
    }
    text
}

fn as_json(listing: &Listing) -> String {
    let file = |file: &PartFile| json!({ "name": file.name, "header": file.header.as_ref().map(|h| &h.text) });
    let files: Vec<_> = listing.files.iter().map(file).collect();
    json!({ "folders": listing.folders, "files": files }).to_string() + "\n"
}
