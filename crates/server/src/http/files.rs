//! Files of the part folder.

use super::guard::Caller;
use super::rest::demand;
use super::{Refused, aside};
use crate::app::App;
use axum::body::Bytes;
use axum::extract::{Path, Query, State};
use axum::http::header;
use axum::response::IntoResponse;
use axum::{Extension, Json};
use kerf_control::parts;
use kerf_wire::{FileInfo, Role};
use serde::Deserialize;
use std::sync::Arc;

/// Which folder is listed.
#[derive(Debug, Default, Deserialize)]
pub struct Folder {
    /// Below the part folder; itself when empty.
    #[serde(default)]
    folder: String,
    /// Which files are listed: all when nothing is given.
    mask: Option<String>,
}

/// What a folder holds.
pub async fn list(
    State(app): State<Arc<App>>,
    Query(query): Query<Folder>,
) -> Result<Json<Vec<FileInfo>>, Refused> {
    let list = move || {
        let mut files = app.parts.list(&query.folder)?;
        let parts = app.hub.read(|now| now.folder.mask.clone());
        files.iter_mut().filter(|file| !file.folder).for_each(|file| app.look(file, &parts));
        if let Some(mask) = &query.mask {
            files.retain(|file| file.folder || parts::fits(mask, file_name(&file.name)));
        }
        Ok(files)
    };
    Ok(Json(aside(list).await?))
}

impl App {
    /// Whether it is a part file, by the mask of part files, and what its head tells.
    fn look(&self, file: &mut FileInfo, mask: &str) {
        let name = file_name(&file.name);
        let gcode = kerf_sbp::is_gcode_name(name);
        file.part = gcode || parts::fits(mask, name);
        if file.part && !gcode {
            let head = self.parts.head(&file.name).unwrap_or_default();
            file.header = kerf_sbp::Header::read(&head).map(|header| header.text);
        }
    }
}

/// The last part of a name.
fn file_name(name: &str) -> &str {
    name.rsplit('/').next().unwrap_or(name)
}

/// A file as it is.
pub async fn read(
    State(app): State<Arc<App>>,
    Path(name): Path<String>,
) -> Result<impl IntoResponse, Refused> {
    let bytes = aside(move || app.parts.read(&name)).await?;
    // Never taken for a page, whatever is in it.
    Ok(([(header::CONTENT_TYPE, "application/octet-stream")], bytes))
}

/// Writes a file.
pub async fn write(
    State(app): State<Arc<App>>,
    Extension(caller): Extension<Caller>,
    Path(name): Path<String>,
    bytes: Bytes,
) -> Result<Json<()>, Refused> {
    demand(&caller, Role::Operator)?;
    let parts = app.clone();
    aside(move || parts.parts.write(&name, &bytes)).await?;
    app.files_changed();
    Ok(Json(()))
}
