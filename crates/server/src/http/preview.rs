//! Previews, in pieces.

use super::{Refused, aside};
use crate::app::{App, lock, problem};
use crate::preview::Preview;
use axum::Json;
use axum::extract::{Path, State};
use axum::http::header;
use axum::response::IntoResponse;
use kerf_wire::preview::PreviewInfo;
use kerf_wire::{Problem, Why};
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
