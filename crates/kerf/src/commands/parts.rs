//! `kerf parts`: the part files of a folder.

use crate::args::{Format, PlaceArgs};
use crate::data_args::data_folder;
use crate::exit::{Exit, Usage};
use crate::{clock, folders, out, setup};
use anyhow::{Context, Result};
use clap::Args;
use kerf_files::versions::{Version, Versions};
use kerf_workspace::{parts::Listing, parts::PartFile};
use serde_json::json;
use std::path::{Path, PathBuf};
use std::time::{Duration, UNIX_EPOCH};

/// Lists the part files of a folder; ! marks those whose head tells about the job
///
/// The list is the one that the dialogs of FP and FG show.
#[derive(Args)]
#[command(after_help = "Examples:\n  kerf parts\n  kerf parts doors --mask 'proj??.sbp'\n  \
    kerf parts --headers\n  kerf parts --versions door.sbp\n  kerf parts --versions door.sbp --restore 3")]
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
    /// Lists the earlier versions of a file, the newest first
    #[arg(long, value_name = "NAME")]
    versions: Option<String>,
    /// Restores a version; the present file becomes a version too
    #[arg(long, value_name = "NUMBER", requires = "versions")]
    restore: Option<u32>,
    #[command(flatten)]
    place: PlaceArgs,
}

pub fn run(args: &PartsArgs) -> Result<Exit> {
    let folder = args.listed.as_deref().or(args.place.parts.as_deref()).unwrap_or(Path::new(""));
    if let Some(name) = &args.versions {
        let versions = Versions::in_data(&data_folder(&args.place.data)?);
        return match args.restore {
            None => list(&versions, name),
            Some(number) => restore(&versions, folder, name, number),
        };
    }
    folders::is_there(folder, "its part files are listed")?;
    let place = PlaceArgs { parts: None, ..args.place.clone() };
    let mut workspace = setup::workspace(folder, &place, true)?;
    workspace.set_mask(Some(&args.mask));
    let cannot = || Usage(format!("cannot list {}", folder.display()));
    let listing = kerf_workspace::parts::listing(&workspace).with_context(cannot)?;
    out::print(&match args.format {
        Format::Text => as_text(&listing, args.headers),
        Format::Json => as_json(&listing),
    });
    Ok(Exit::Good)
}

/// Prints what a file was.
fn list(versions: &Versions, name: &str) -> Result<Exit> {
    let kept = versions.list(name).with_context(|| format!("versions of {name}"))?;
    if kept.is_empty() {
        out::print(&format!("no version of {name} is kept\n"));
    }
    for Version { number, changed, bytes } in kept {
        let since = clock::told(UNIX_EPOCH + Duration::from_secs(changed));
        out::print(&format!("{number:>4}  {since}  {}\n", out::count(bytes, "byte")));
    }
    Ok(Exit::Good)
}

/// Brings a version back, as any other save: what lies there is kept.
fn restore(versions: &Versions, folder: &Path, name: &str, number: u32) -> Result<Exit> {
    let of = || format!("version {number} of {name}");
    let (bytes, file) = (versions.read(name, number).with_context(of)?, folder.join(name));
    if file.is_file() {
        versions.keep(name, &file).with_context(|| format!("{name} stays as it is"))?;
    }
    out::file(&file, bytes)?;
    out::print(&format!("{} is version {number} again\n", file.display()));
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
