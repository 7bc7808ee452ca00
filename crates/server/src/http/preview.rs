//! Previews, in pieces.

use super::{Refused, aside, soon};
use crate::app::App;
use crate::pool::RequestScope;
use crate::preview::{Asked, Chart, Preview};
use crate::refusal::problem;
use axum::Json;
use axum::extract::{Path, Query, State};
use axum::http::{StatusCode, header};
use axum::response::{IntoResponse, Response};
use kerf_model::Change;
use kerf_wire::Why;
use kerf_wire::preview::{PreviewInfo, Timing};
use serde::Deserialize;
use std::sync::Arc;

/// Behind the key of a preview: the path where it lies on work that an axis turns.
const ROTARY: &str = "~rotary";

/// Reason for which a preview is not shown.
pub enum Missing {
    /// A newer one took its place: no content. Pages are told the key of the newer one by the socket.
    Outdated,
    /// It never was there, or something is wrong with what was asked.
    Refused(Refused),
}

impl<T: Into<Refused>> From<T> for Missing {
    fn from(why: T) -> Self {
        Self::Refused(why.into())
    }
}

impl IntoResponse for Missing {
    fn into_response(self) -> Response {
        match self {
            Self::Outdated => StatusCode::NO_CONTENT.into_response(),
            Self::Refused(refused) => refused.into_response(),
        }
    }
}

fn find(app: &App, key: &str) -> Result<Arc<Preview>, Missing> {
    let key = key.trim_end_matches(ROTARY);
    let open = app.loader.open.lock();
    let preview = open.preview.clone().filter(|_| open.key == key);
    preview.ok_or_else(|| {
        if app.loader.was_shown(key) {
            return Missing::Outdated;
        }
        problem(Why::File, "there is no such preview").into()
    })
}

/// Returns the facts about a preview.
pub async fn info(
    State(app): State<Arc<App>>,
    Path(key): Path<String>,
) -> Result<Json<PreviewInfo>, Missing> {
    let preview = find(&app, &key)?;
    let rolled = preview.rolled.as_ref().filter(|_| key.ends_with(ROTARY));
    Ok(Json(rolled.map_or(&preview.info, |rolled| &rolled.info).clone()))
}

/// A piece of its path.
pub async fn piece(
    State(app): State<Arc<App>>,
    Path((key, level, piece)): Path<(String, usize, usize)>,
) -> Result<impl IntoResponse, Missing> {
    let preview = find(&app, &key)?;
    let bytes = soon(move || {
        let rolled = preview.rolled.as_ref().filter(|_| key.ends_with(ROTARY));
        let paths = rolled.map_or(&preview.paths, |rolled| &rolled.paths);
        let bytes = paths.get(level).and_then(|path| path.piece(piece));
        bytes.ok_or_else(|| problem(Why::File, "there is no such piece"))
    });
    let headers = [
        (header::CONTENT_TYPE, "application/octet-stream"),
        // The key changes with the preview.
        (header::CACHE_CONTROL, "private, max-age=3600, immutable"),
    ];
    Ok((headers, bytes.await?))
}

/// The segments of typed moves from one on; no content where there are no more, or the picture begins anew.
pub async fn typed(
    State(app): State<Arc<App>>,
    Path((key, from)): Path<(u32, usize)>,
) -> impl IntoResponse {
    let Some(bytes) = app.hub.typed().piece(key, from) else {
        return StatusCode::NO_CONTENT.into_response();
    };
    ([(header::CONTENT_TYPE, "application/octet-stream")], bytes).into_response()
}

/// Query for a timing chart.
#[derive(Deserialize)]
pub struct Wanted {
    /// Changes of the simulated machine's inputs, `3@2.5=1,arc@4=1`.
    #[serde(default)]
    inputs: String,
}

/// The timing chart of the open file; a long one takes a while the first time. Whoever goes meanwhile does
/// not have it made to its end.
pub async fn timing(
    State(app): State<Arc<App>>,
    Path(key): Path<String>,
    Query(Wanted { inputs }): Query<Wanted>,
) -> Result<Json<Arc<Timing>>, Missing> {
    let preview = find(&app, &key)?;
    let changes = inputs.split([',', ' ']).filter(|text| !text.is_empty()).map(str::parse);
    let changes: Result<Vec<Change>, String> = changes.collect();
    let changes = changes.map_err(|why| problem(Why::Mistake, why))?;
    if let Some(known) = app.loader.known_timing(&preview).filter(|_| changes.is_empty()) {
        return Ok(Json(known));
    }
    let shown = key.clone();
    let (waiting, chart) = app.loader.charts.ask(Asked { key: key.clone(), inputs });
    if let Some(chart) = chart {
        tokio::spawn(RequestScope::present()?.serve(chart_of(
            app.clone(),
            chart,
            key,
            preview,
            changes,
        )));
    }
    let lost = || problem(Why::Server, "this failed in the server");
    let answer = waiting.answer().await.ok_or_else(lost)?;
    if answer.is_err() {
        find(&app, &shown)?;
    }
    Ok(Json(answer?))
}

/// Makes a chart, and tells whoever waits for it.
async fn chart_of(
    app: Arc<App>,
    chart: Arc<Chart>,
    key: String,
    preview: Arc<Preview>,
    changes: Vec<Change>,
) {
    let (making, made) = (app.clone(), chart.clone());
    let answer = aside(move || making.loader.timing(&key, &preview, changes, &made.given_up));
    let answer = answer.await.map_err(|Refused(why)| why);
    app.loader.charts.made(&chart, answer);
}
