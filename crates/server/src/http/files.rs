//! Files of the part folder.

use super::guard::Caller;
use super::rest::demand;
use super::{Refused, aside, soon};
use crate::app::App;
use axum::body::Bytes;
use axum::extract::{Path, Query, State};
use axum::http::{HeaderMap, HeaderValue, header};
use axum::response::IntoResponse;
use axum::{Extension, Json};
use kerf_control::parts;
use kerf_wire::{self as wire, FileInfo, Problem, Role, Why};
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
    Ok(Json(soon(list).await?))
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

/// Whether a file may be sent now, and has come as it was.
fn may_be_sent(app: &App, told: &HeaderValue, bytes: &[u8]) -> Result<(), Problem> {
    if app.state() == wire::State::Running {
        let text = "the machine moves: files are sent when it stands".into();
        return Err(Problem { why: Why::State, text });
    }
    let told = told.to_str().ok().and_then(|hex| u32::from_str_radix(hex, 16).ok());
    if told != Some(crc32fast::hash(bytes)) {
        let text = "the file is damaged: send it again".into();
        return Err(Problem { why: Why::Malformed, text });
    }
    Ok(())
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

/// The checksum of a file that is sent from another computer, as eight hexadecimal digits. Such a file is
/// taken only while the machine stands.
const CHECKSUM: &str = "kerf-crc32";

/// Writes a file.
pub async fn write(
    State(app): State<Arc<App>>,
    Extension(caller): Extension<Caller>,
    Path(name): Path<String>,
    headers: HeaderMap,
    bytes: Bytes,
) -> Result<Json<()>, Refused> {
    demand(&caller, Role::Operator)?;
    if let Some(told) = headers.get(CHECKSUM) {
        may_be_sent(&app, told, &bytes)?;
    }
    let parts = app.clone();
    aside(move || parts.parts.write(&name, &bytes)).await?;
    app.files_changed();
    Ok(Json(()))
}
