//! The height map in force: a file in the data folder; where there is none or an empty one, surfaces are flat.

use crate::Workspace;
use kerf_program::HeightMap;

/// Name of the file in the data folder.
pub const HEIGHT_MAP: &str = "height.map";

/// The height map in force.
///
/// # Errors
/// What is wrong with its file.
pub fn height_map(workspace: &Workspace) -> Result<Option<HeightMap>, String> {
    let text = workspace.data_text(HEIGHT_MAP).filter(|text| !text.is_empty());
    text.map(|text| read(&text)).transpose()
}

/// Takes a file of heights into force.
///
/// # Errors
/// What is wrong with it, or why it cannot be kept.
pub fn use_height_map(workspace: &mut Workspace, text: &str) -> Result<HeightMap, String> {
    let map = read(text)?;
    workspace.put_data(HEIGHT_MAP, text)?;
    Ok(map)
}

/// Takes the map off: an empty file is none.
///
/// # Errors
/// The data folder cannot be written.
pub fn take_height_map_off(workspace: &mut Workspace) -> Result<(), String> {
    workspace.put_data(HEIGHT_MAP, "")
}

fn read(text: &str) -> Result<HeightMap, String> {
    HeightMap::read(text).map_err(|(line, why)| match line {
        0 => why,
        _ => format!("line {line}: {why}"),
    })
}
