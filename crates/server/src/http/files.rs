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
        if let Some(mask) = &query.mask {
            files.retain(|file| file.folder || parts::fits(mask, file_name(&file.name)));
        }
        Ok(files)
    };
    Ok(Json(aside(list).await?))
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
