//! The height map that programs follow, as pages change and see it.

use crate::app::App;
use crate::asker::Asker;
use crate::machine::Order;
use crate::refusal::problem;
use kerf_program::HeightMap;
use kerf_wire::{HeightMapChange, Problem, Why};
use kerf_workspace::{Workspace, height_map};

/// Takes a file of the part folder into force, or the map off.
///
/// # Errors
/// The file cannot be read or is no map, or the machine is busy.
pub fn change(app: &App, asker: &Asker, change: HeightMapChange) -> Result<(), Problem> {
    let text = match change {
        HeightMapChange::Off => None,
        HeightMapChange::File { name } => {
            let text = String::from_utf8_lossy(&app.files.folder.read(&name)?).into_owned();
            HeightMap::read(&text).map_err(|(line, why)| {
                problem(Why::Mistake, format!("{name}, line {line}: {why}"))
            })?;
            Some(text)
        }
    };
    app.orders.order_of(asker, Order::HeightMap(text))
}

/// The map in force, as pages are told it. One that is damaged is told by each run.
pub fn told(workspace: &Workspace) -> Option<kerf_wire::HeightMap> {
    let map = height_map::height_map(workspace).ok().flatten()?;
    let (xs, ys, zs) = map.grid();
    Some(kerf_wire::HeightMap::of(xs, ys, zs))
}
