//! Files of the part folder.

use super::guard::Caller;
use super::rest::demand;
use super::{Refused, aside, soon};
use crate::app::App;
use crate::digested::hash;
use crate::file_kind;
use crate::files::PartFolder;
use crate::refusal::problem;
use crate::saving::{self, Leave};
use axum::body::Bytes;
use axum::extract::rejection::QueryRejection;
use axum::extract::{Path, Query, State};
use axum::http::{HeaderMap, HeaderValue, header};
use axum::response::{IntoResponse, Response};
use axum::{Extension, Json};
use kerf_wire::{self as wire, FileInfo, FileKind, Problem, Role, Why};
use kerf_workspace::parts;
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
    /// Lists the bin in place of a folder.
    bin: Option<String>,
    /// Lists files of the folder and of those below it whose names hold this, or fit it where it has `*` or `?`.
    find: Option<String>,
}

/// Lists a folder.
pub async fn list(
    State(app): State<Arc<App>>,
    Query(query): Query<Folder>,
) -> Result<Json<Vec<FileInfo>>, Refused> {
    let list = move || {
        if query.bin.is_some() {
            return app.files.saves.bin(&app.files.folder);
        }
        let mut files = match &query.find {
            Some(word) => app.files.folder.found(&query.folder, |name| is_found(word, name))?,
            None => app.files.folder.list(&query.folder)?,
        };
        let parts = app.hub.read(|now| now.folder.mask.clone());
        files
            .iter_mut()
            .filter(|file| !file.folder)
            .for_each(|file| look(&app.files.folder, file, &parts));
        if let Some(mask) = &query.mask {
            files.retain(|file| file.folder || parts::fits(mask, file_name(&file.name)));
        }
        Ok(files)
    };
    Ok(Json(soon(list).await?))
}

/// Returns `true` if a file is looked for by a part of its name, or by a mask.
fn is_found(word: &str, name: &str) -> bool {
    let name = file_name(name);
    match word.contains(['*', '?']) {
        true => parts::fits(word, name),
        false => name.to_lowercase().contains(&word.to_lowercase()),
    }
}

/// Enters whether it is a part file, by the mask of part files, and what its head tells.
fn look(folder: &PartFolder, file: &mut FileInfo, mask: &str) {
    let name = file_name(&file.name);
    let gcode = kerf_sbp::is_gcode_name(name);
    file.part = gcode || parts::fits(mask, name);
    file.opens = file_kind::opens(name, mask);
    if file.part && !gcode {
        let head = folder.head(&file.name).unwrap_or_default();
        file.header = kerf_sbp::Header::read(&head).map(|header| header.text);
    }
}

/// Checks that a file may be sent now, and has come as it was.
fn may_be_sent(app: &App, told: &HeaderValue, bytes: &[u8]) -> Result<(), Problem> {
    if app.hub.state() == wire::State::Running {
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

/// Query about a file, besides its bytes.
#[derive(Debug, Default, Deserialize)]
pub struct Look {
    /// Asks for a description and the hash.
    about: Option<String>,
    /// Asks for a list of the earlier contents that are kept.
    versions: Option<String>,
    /// The bytes of one of those.
    version: Option<u32>,
    /// Asks for a small picture of its tool path.
    thumb: Option<String>,
}

/// A file as it is, what it is, or what it was.
pub async fn read(
    State(app): State<Arc<App>>,
    Path(name): Path<String>,
    Query(look): Query<Look>,
) -> Result<Response, Refused> {
    if look.thumb.is_some() {
        return thumbnail(app, name).await;
    }
    let look = move || {
        if look.about.is_some() {
            return Ok(Json(saving::about(&app.files.folder, &name)?).into_response());
        }
        if look.versions.is_some() {
            return Ok(Json(app.files.saves.versions(&app.files.folder, &name)?).into_response());
        }
        let bytes = match look.version {
            Some(number) => app.files.saves.version(&app.files.folder, &name, number)?,
            None => app.files.folder.read(&name)?,
        };
        let tag = tagged(&hash(&bytes));
        // Never taken for a page, whatever is in it.
        let plain = (header::CONTENT_TYPE, "application/octet-stream".to_owned());
        Ok(([plain, (header::ETAG, tag)], bytes).into_response())
    };
    // Behind a preview of a large file the page would wait for its lines.
    soon(look).await
}

/// The small picture of a file. That of a drawing is made when somebody asks for it first.
async fn thumbnail(app: Arc<App>, name: String) -> Result<Response, Refused> {
    let (shop, of) = (app.clone(), name.clone());
    let kept = soon(move || Ok(shop.loader.thumbnails.kept(&shop.files.folder, &of))).await?;
    let pictures = move || match file_kind::kind_of(&name) {
        FileKind::Drawing => app.loader.thumbnails.of_drawing(&app.files.folder, &name),
        _ => app.loader.thumbnails.of(&app.files.folder, &name),
    };
    let picture = match kept {
        Some(picture) => picture,
        None => aside(move || Ok(pictures())).await?,
    };
    Ok(([(header::CONTENT_TYPE, "image/svg+xml")], picture).into_response())
}

/// A hash as an entity tag.
fn tagged(hash: &str) -> String {
    format!("\"{hash}\"")
}

/// Query that gives leave to write over a file.
#[derive(Debug, Default, Deserialize)]
pub struct Writing {
    /// `1` where any file may be replaced.
    replace: Option<String>,
}

impl Writing {
    /// The leave that a request carries: `?replace=1`, or an If-Match.
    fn leave(&self, headers: &HeaderMap) -> Leave {
        let matched = headers.get(header::IF_MATCH).and_then(|tag| tag.to_str().ok());
        let any = self.replace.as_deref().filter(|replace| *replace == "1").map(|_| "*");
        Leave::of(any.or(matched.map(|tag| tag.trim_matches('"'))))
    }
}

/// Which of its versions a file becomes again.
#[derive(Debug, Deserialize)]
pub struct Restoring {
    /// The number of the version.
    restore: u32,
}

/// Puts an earlier content of a file in its place, which is a save as any other.
pub async fn restore(
    State(app): State<Arc<App>>,
    Extension(caller): Extension<Caller>,
    Path(name): Path<String>,
    restoring: Result<Query<Restoring>, QueryRejection>,
) -> Result<impl IntoResponse, Refused> {
    demand(&caller, Role::Operator)?;
    let Query(Restoring { restore }) =
        restoring.map_err(|error| problem(Why::Malformed, error.body_text()))?;
    let parts = app.clone();
    let hash =
        aside(move || parts.files.saves.restore(&parts.files.folder, &name, restore)).await?;
    app.files.changed();
    Ok(([(header::ETAG, tagged(&hash))], Json(())))
}

/// Query about a file that is deleted.
#[derive(Debug, Deserialize)]
pub struct Deleting {
    /// Takes it out of the bin, for good.
    forget: Option<String>,
    /// The name that it has now: it was copied there, and its history goes with it.
    renamed: Option<String>,
}

/// Moves a file into the bin, or takes it out of there for good. Only while nothing runs: it may be the one that
/// does.
pub async fn delete(
    State(app): State<Arc<App>>,
    Extension(caller): Extension<Caller>,
    Path(name): Path<String>,
    Query(deleting): Query<Deleting>,
    headers: HeaderMap,
) -> Result<Json<()>, Refused> {
    demand(&caller, Role::Operator)?;
    if !matches!(app.hub.state(), wire::State::Idle | wire::State::Alarm) {
        let text = "the machine is busy: files are deleted when nothing runs".to_owned();
        return Err(Problem { why: Why::State, text }.into());
    }
    let leave = Writing::default().leave(&headers);
    let shop = app.clone();
    let delete = move || {
        let Deleting { forget, renamed } = deleting;
        if forget.is_some() {
            return shop.files.saves.forget(&shop.files.folder, &name);
        }
        shop.files.saves.delete(&shop.files.folder, &name, &leave)?;
        if let Some(to) = renamed {
            shop.hub.writes_down(shop.hub.history.renamed(&name, &to));
        }
        Ok(())
    };
    aside(delete).await?;
    app.files.changed();
    Ok(Json(()))
}

/// The checksum of a file that is sent from another computer, as eight hexadecimal digits. Such a file is
/// taken only while the machine stands.
const CHECKSUM: &str = "kerf-crc32";

/// Writes a file; another one that lies there is replaced only with leave.
pub async fn write(
    State(app): State<Arc<App>>,
    Extension(caller): Extension<Caller>,
    Path(name): Path<String>,
    Query(writing): Query<Writing>,
    headers: HeaderMap,
    bytes: Bytes,
) -> Result<impl IntoResponse, Refused> {
    demand(&caller, Role::Operator)?;
    if let Some(told) = headers.get(CHECKSUM) {
        may_be_sent(&app, told, &bytes)?;
    }
    let leave = writing.leave(&headers);
    let hash = aside(move || app.files.save(&name, &bytes, &leave)).await?;
    Ok(([(header::ETAG, tagged(&hash))], Json(())))
}
