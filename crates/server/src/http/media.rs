//! Sounds, for pages that play them.

use super::{Refused, soon};
use crate::app::App;
use crate::files::PartFolder;
use crate::refusal::problem;
use axum::extract::{Path, State};
use axum::http::header;
use axum::response::IntoResponse;
use kerf_wire::{Problem, Why};
use kerf_workspace::{sounds::MEDIA, sounds::last_part};
use std::sync::Arc;

/// A sound of the part folder or, by the last part of its name, of the folder of sounds. No other file
/// leaves it.
pub async fn sound(
    State(app): State<Arc<App>>,
    Path(name): Path<String>,
) -> Result<impl IntoResponse, Refused> {
    let found = move || {
        let refused = || problem(Why::File, format!("there is no sound {name}"));
        let kind = kind(&name).ok_or_else(refused)?;
        let part = app.files.folder.read(&name.replace('\\', "/"));
        Ok((kind, part.or_else(|_| of_media(&app, last_part(&name))).map_err(|_| refused())?))
    };
    let (kind, bytes) = soon(found).await?;
    Ok(([(header::CONTENT_TYPE, kind), (header::CACHE_CONTROL, "no-cache")], bytes))
}

fn of_media(app: &App, name: &str) -> Result<Vec<u8>, Problem> {
    let none = |error: std::io::Error| problem(Why::File, error.to_string());
    let media = PartFolder::new(&app.options.data.join(MEDIA)).map_err(none)?;
    let same = media.list("")?.into_iter().find(|file| file.name.eq_ignore_ascii_case(name));
    media.read(same.as_ref().map_or(name, |file| &file.name))
}

/// Returns the media type of a sound, by the extension of its name.
fn kind(name: &str) -> Option<&'static str> {
    let extension = name.rsplit_once('.')?.1.to_ascii_lowercase();
    Some(match extension.as_str() {
        "wav" => "audio/wav",
        "mp3" => "audio/mpeg",
        "ogg" => "audio/ogg",
        "flac" => "audio/flac",
        "m4a" => "audio/mp4",
        _ => return None,
    })
}
