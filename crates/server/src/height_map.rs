//! The height map that programs follow, as pages change it.

use crate::app::App;
use crate::asker::Asker;
use crate::machine::Order;
use crate::refusal::problem;
use kerf_program::HeightMap;
use kerf_wire::{HeightMapChange, Problem, Why};

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
