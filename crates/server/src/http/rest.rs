//! What scripts ask: the same acts as pages, over HTTP.

use super::guard::Caller;
use super::{Refused, aside};
use crate::app::{App, problem};
use crate::people::script;
use axum::extract::{Path, State};
use axum::{Extension, Json};
use kerf_wire::{
    Act, JobView, OperationEntry, Problem, Reply, Role, ShapeList, Snapshot, ToolPaths, Who, Why,
};
use serde_json::Value;
use std::sync::Arc;

/// What every page shows.
pub async fn state(State(app): State<Arc<App>>) -> Json<Snapshot> {
    Json(app.hub.read(Snapshot::clone))
}

/// Does an act: its name is in the path, the rest of it in the body.
pub async fn act(
    State(app): State<Arc<App>>,
    Extension(caller): Extension<Caller>,
    Path(name): Path<String>,
    Json(body): Json<Value>,
) -> Result<Json<Reply>, Refused> {
    let asker = app.hears(&who(&caller));
    let act = read(name, body)?;
    let notes = aside(move || app.act(&asker, act)).await?;
    Ok(Json(Reply { id: 0, problem: None, notes, clock_ms: None }))
}

fn read(name: String, body: Value) -> Result<Act, Problem> {
    let Value::Object(mut fields) = body else {
        return Err(problem(Why::Malformed, "the body is an object"));
    };
    fields.insert("do".into(), name.into());
    let act = serde_json::from_value(Value::Object(fields));
    let act = act.map_err(|error| problem(Why::Malformed, error.to_string()))?;
    match act {
        Act::JogStart { .. } | Act::JogRenew { .. } => {
            Err(problem(Why::Malformed, "a jog needs somebody who holds a key: use the socket"))
        }
        act => Ok(act),
    }
}

/// A script as a driver: one for each device.
pub fn who(caller: &Caller) -> Who {
    let (number, name) = caller.device.clone().unwrap_or_default();
    Who { client: script(number), role: caller.role.unwrap_or_default(), device: name }
}

/// Whether a caller has a role.
///
/// # Errors
/// It has not.
pub fn demand(caller: &Caller, role: Role) -> Result<(), Problem> {
    if caller.role.is_some_and(|has| has >= role) {
        return Ok(());
    }
    Err(problem(Why::Role, format!("this needs the role {role:?}").to_lowercase()))
}

/// What somebody who helps has to know, as text.
pub async fn problems(State(app): State<Arc<App>>) -> Result<String, Refused> {
    let failed = |error: std::io::Error| problem(Why::Server, error.to_string());
    aside(move || app.problems().map_err(failed)).await
}

/// The shapes of the drawing.
pub async fn shapes(State(app): State<Arc<App>>) -> Result<Json<ShapeList>, Refused> {
    Ok(Json(aside(move || Ok(app.shapes())).await?))
}

/// What the drawing becomes when it is machined.
pub async fn tool_paths(State(app): State<Arc<App>>) -> Result<Json<ToolPaths>, Refused> {
    Ok(Json(aside(move || Ok(app.tool_paths())).await?))
}

/// The job that is open.
pub async fn job(State(app): State<Arc<App>>) -> Result<Json<JobView>, Refused> {
    Ok(Json(aside(move || app.job_view()).await?))
}

/// Starts the job or part file that is open, as the Start key does.
pub async fn start(
    app: State<Arc<App>>,
    caller: Extension<Caller>,
    body: Json<Value>,
) -> Result<Json<Reply>, Refused> {
    act(app, caller, Path("run".into()), body).await
}

/// The operations of drawings, as forms.
pub async fn operations() -> Json<Vec<OperationEntry>> {
    Json(crate::operations::operations())
}
