//! Previews, in pieces.

use super::{Refused, aside};
use crate::app::{App, lock, problem};
use crate::preview::Preview;
use axum::Json;
use axum::extract::{Path, Query, State};
use axum::http::header;
use axum::response::IntoResponse;
use kerf_sim::Change;
use kerf_wire::preview::{PreviewInfo, Timing};
use kerf_wire::{Problem, Why};
use serde::Deserialize;
use std::sync::Arc;

fn find(app: &App, key: &str) -> Result<Arc<Preview>, Problem> {
    let open = lock(&app.open);
    let preview = open.preview.clone().filter(|_| open.key == key);
    preview.ok_or_else(|| problem(Why::File, "there is no such preview, or not any more"))
}

/// What is known of a preview.
pub async fn info(
    State(app): State<Arc<App>>,
    Path(key): Path<String>,
) -> Result<Json<PreviewInfo>, Refused> {
    Ok(Json(find(&app, &key)?.info.clone()))
}

/// A piece of its path.
pub async fn piece(
    State(app): State<Arc<App>>,
    Path((key, level, piece)): Path<(String, usize, usize)>,
) -> Result<impl IntoResponse, Refused> {
    let preview = find(&app, &key)?;
    let bytes = aside(move || {
        let bytes = preview.paths.get(level).and_then(|path| path.piece(piece));
        bytes.ok_or_else(|| problem(Why::File, "there is no such piece"))
    });
    let headers = [
        (header::CONTENT_TYPE, "application/octet-stream"),
        // The key changes with the preview.
        (header::CACHE_CONTROL, "private, max-age=3600, immutable"),
    ];
    Ok((headers, bytes.await?))
}

/// What a timing chart is asked with.
#[derive(Deserialize)]
pub struct Asked {
    /// Changes of the simulated machine's inputs, `3@2.5=1,arc@4=1`.
    #[serde(default)]
    inputs: String,
}

/// The timing chart of the open file; a long one takes a while the first time.
pub async fn timing(
    State(app): State<Arc<App>>,
    Path(key): Path<String>,
    Query(Asked { inputs }): Query<Asked>,
) -> Result<Json<Arc<Timing>>, Refused> {
    let preview = find(&app, &key)?;
    let changes = inputs.split([',', ' ']).filter(|text| !text.is_empty()).map(str::parse);
    let changes: Result<Vec<Change>, String> = changes.collect();
    let changes = changes.map_err(|why| problem(Why::Mistake, why))?;
    Ok(Json(aside(move || app.timing(&key, &preview, changes)).await?))
}
