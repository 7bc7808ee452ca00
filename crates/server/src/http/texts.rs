//! Text of the editor that is not saved.

use super::guard::Caller;
use super::rest::demand;
use super::{Refused, soon};
use crate::app::App;
use crate::refusal::problem;
use axum::extract::rejection::{JsonRejection, QueryRejection};
use axum::extract::{Query, State};
use axum::response::{IntoResponse, Response};
use axum::{Extension, Json};
use kerf_wire::{Role, TextDraft, Why};
use serde::Deserialize;
use std::sync::Arc;

/// Query of a request that ends a draft.
#[derive(Debug, Deserialize)]
pub struct DraftQuery {
    /// Its name below the part folder; empty for a new one.
    name: String,
    /// The page whose draft it is.
    #[serde(default)]
    page: String,
    /// The text that it was when whoever ends it saw it.
    revision: Option<String>,
}

/// Query of a request for the drafts, or for the text that some were typed into.
#[derive(Debug, Deserialize)]
pub struct DraftListQuery {
    /// The hash of a text that was typed into: asks for it, as it was then.
    base: Option<String>,
}

/// Every draft, the newest first; or the text that some of them were typed into.
pub async fn list(
    State(app): State<Arc<App>>,
    Query(DraftListQuery { base }): Query<DraftListQuery>,
) -> Result<Response, Refused> {
    let look = move || match base {
        Some(hash) => app.texts.base(&hash).map(IntoResponse::into_response),
        None => Ok(Json(app.texts.list(&app.files.folder)?).into_response()),
    };
    soon(look).await
}

/// Keeps a draft; tells whether another page types into the same file.
pub async fn keep(
    State(app): State<Arc<App>>,
    Extension(caller): Extension<Caller>,
    draft: Result<Json<TextDraft>, JsonRejection>,
) -> Result<Json<bool>, Refused> {
    demand(&caller, Role::Operator)?;
    let Json(draft) = draft.map_err(|error| problem(Why::Malformed, error.body_text()))?;
    Ok(Json(soon(move || app.texts.keep(&draft, &app.files.folder)).await?))
}

/// Ends a draft.
pub async fn end(
    State(app): State<Arc<App>>,
    Extension(caller): Extension<Caller>,
    of: Result<Query<DraftQuery>, QueryRejection>,
) -> Result<Json<()>, Refused> {
    demand(&caller, Role::Operator)?;
    let Query(DraftQuery { name, page, revision }) =
        of.map_err(|error| problem(Why::Malformed, error.body_text()))?;
    Ok(Json(soon(move || app.texts.end(&name, &page, revision.as_deref())).await?))
}
