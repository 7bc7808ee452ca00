//! `kerf map`: the height map that programs follow.

use crate::args::PlaceArgs;
use crate::exit::{Exit, Usage};
use crate::{given, out, setup};
use anyhow::{Result, bail};
use clap::{Args, Subcommand};
use kerf_program::{HeightMap, decimal};
use kerf_workspace::height_map::{height_map, take_height_map_off, use_height_map};
use std::path::{Path, PathBuf};

/// The height map in force: a probed surface that every part file and G-code file follows with Z
///
/// The command TM makes the program that probes it.
#[derive(Args)]
#[command(after_help = "Example: kerf map use heights.map")]
pub struct MapArgs {
    #[command(subcommand)]
    act: Act,
    #[command(flatten)]
    place: PlaceArgs,
}

#[derive(Subcommand)]
enum Act {
    /// Applies a file of heights
    Use {
        /// The file: its first line says "kerf heights, mm", each other one X,Y,Z of a place
        #[arg(value_name = "FILE")]
        file: PathBuf,
    },
    /// Switches the map off: surfaces are flat
    Off,
    /// Shows the map in force
    Show,
}

pub fn run(args: &MapArgs) -> Result<Exit> {
    let looks = matches!(args.act, Act::Show);
    let mut workspace = setup::workspace(Path::new(""), &args.place, looks)?;
    let told = match &args.act {
        Act::Use { file } => {
            let text = given::text(file)?;
            let map = use_height_map(&mut workspace, &text)
                .map_err(|why| Usage(format!("{}: {why}", file.display())))?;
            format!("Z follows the map: {}\n", extent(&map))
        }
        Act::Off => {
            take_height_map_off(&mut workspace).map_err(anyhow::Error::msg)?;
            "no height map is in force\n".to_owned()
        }
        Act::Show => match height_map(&workspace) {
            Ok(Some(map)) => shown(&map),
            Ok(None) => "no height map is in force\n".to_owned(),
            Err(why) => bail!("height.map in the data folder: {why}"),
        },
    };
    out::print(&told);
    Ok(Exit::Good)
}

/// Size, place and heights of a map.
fn extent(map: &HeightMap) -> String {
    let (columns, rows, heights) = map.grid();
    let [[x0, y0], [x1, y1]] = map.bounds().map(|corner| corner.map(|v| decimal(v, 3)));
    let lowest = heights.iter().copied().fold(f64::INFINITY, f64::min);
    let highest = heights.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let (lowest, highest) = (decimal(lowest, 3), decimal(highest, 3));
    format!(
        "{} by {} places, X {x0} … {x1}, Y {y0} … {y1}, Z {lowest} … {highest} mm",
        columns.len(),
        rows.len()
    )
}

/// The heights, the farthest row first, as they lie on the table.
fn shown(map: &HeightMap) -> String {
    let (columns, rows, heights) = map.grid();
    let line = |row: &[f64]| row.iter().map(|z| format!("{z:>9.3}")).collect::<String>() + "\n";
    let mut text = extent(map) + "\n" + &format!("{:>10}", "") + &line(columns);
    for (y, row) in rows.iter().zip(heights.chunks(columns.len())).rev() {
        text += &(format!("{y:>9.3} ") + &line(row));
    }
    text
}
