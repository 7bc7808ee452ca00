//! Requests of scripts: the same acts as pages, over HTTP.

use super::guard::Caller;
use super::{Refused, aside, soon};
use crate::app::App;
use crate::asker::Asker;
use crate::awaited::Awaited;
use crate::help_wanted;
use crate::lanes::Lanes;
use crate::line_log;
use crate::people::script;
use crate::pool::Lane;
use crate::refusal::problem;
use crate::stop::{StopPress, heard};
use axum::body::to_bytes;
use axum::extract::rejection::JsonRejection;
use axum::extract::{FromRequest, Path, Query, Request, State};
use axum::response::{IntoResponse, Response};
use axum::{Extension, Json};
use kerf_wire::{
    Act, ControllerLines, JobView, OperationEntry, Problem, Reply, Role, RunRecord, ShapeList,
    Snapshot, ToDo, ToolPaths, Who, Why,
};
use serde::Deserialize;
use serde_json::Value;
use std::sync::Arc;
use std::time::Duration;

/// Returns the snapshot that every page shows.
pub async fn state(State(app): State<Arc<App>>) -> Json<Arc<Snapshot>> {
    Json(app.hub.now())
}

/// Returns the runs of files, the newest first.
pub async fn history(State(app): State<Arc<App>>) -> Json<Vec<RunRecord>> {
    Json(app.hub.history.runs())
}

/// Returns what is to be done.
pub async fn todo(State(app): State<Arc<App>>) -> Json<Vec<ToDo>> {
    Json(app.hub.history.todo())
}

/// Something else is to be done: pages read it as they read lists of files.
pub async fn put_todo(
    State(app): State<Arc<App>>,
    Extension(caller): Extension<Caller>,
    list: Result<Json<Vec<ToDo>>, JsonRejection>,
) -> Result<Json<()>, Refused> {
    demand(&caller, Role::Operator)?;
    let Json(list) = list.map_err(|error| problem(Why::Malformed, error.body_text()))?;
    app.hub.history.put_todo(list)?;
    app.files.changed();
    Ok(Json(()))
}

/// Does an act: its name is in the path, the rest of it in the body.
pub async fn act(
    State(app): State<Arc<App>>,
    Extension(caller): Extension<Caller>,
    Path(name): Path<String>,
    request: Request,
) -> Response {
    let who = who(&caller);
    if let Some(halt) = StopPress::named(&name) {
        return halted(&app, &who, halt, request).await.into_response();
    }
    let asker = app.hears(&who);
    match Json::from_request(request, &()).await {
        Ok(Json(body)) => done(app, asker, name, body).await.into_response(),
        Err(refused) => refused.into_response(),
    }
}

/// Does an act, in its turn.
async fn done(
    app: Arc<App>,
    asker: Asker,
    name: String,
    body: Value,
) -> Result<Json<Reply>, Refused> {
    let act = read(name, body)?;
    let lane = act.lane().unwrap_or(Lane::Short);
    // Whoever breaks off waits for nothing any more.
    let _asked = asker.awaited.while_asked();
    let work = move || app.act(&asker, act);
    let notes = if lane == Lane::Long { aside(work).await? } else { soon(work).await? };
    Ok(Json(Reply { id: 0, problem: None, notes, clock_ms: None }))
}

/// Stops, whatever the body is; a jog is named in it, where that has come with the head.
async fn halted(app: &Arc<App>, who: &Who, mut halt: StopPress, request: Request) -> Json<Reply> {
    if let StopPress::JogStop { .. } = halt {
        let body = tokio::time::timeout(WITH_THE_HEAD, to_bytes(request.into_body(), SHORT)).await;
        let body = body.ok().and_then(Result::ok).unwrap_or_default();
        halt = halt.with(&String::from_utf8_lossy(&body));
    }
    let stop = halt.press(app, who.client);
    halt.settle(app);
    heard(app, stop).await;
    Json(Reply { id: 0, problem: None, notes: Vec::new(), clock_ms: None })
}

/// Longest time for a body that only names a jog, and its greatest length, bytes.
const WITH_THE_HEAD: Duration = Duration::from_millis(200);
const SHORT: usize = 4096;

fn read(name: String, body: Value) -> Result<Act, Problem> {
    let Value::Object(mut fields) = body else {
        return Err(problem(Why::Malformed, "the body is an object"));
    };
    fields.insert("do".into(), name.into());
    let act = serde_json::from_value(Value::Object(fields));
    let act = act.map_err(|error| malformed(&error))?;
    match act {
        Act::JogStart { .. } | Act::JogRenew { .. } => {
            Err(problem(Why::Malformed, "a jog needs somebody who holds a key: use the socket"))
        }
        act => Ok(act),
    }
}

/// Most characters of what is said of a message that makes no sense: it does not come back whole.
const SAID: usize = 200;

/// Tells what is wrong with a message.
pub fn malformed(error: &serde_json::Error) -> Problem {
    let said = error.to_string();
    let cut = said.chars().count() > SAID;
    let short: String = said.chars().take(SAID).collect();
    problem(Why::Malformed, if cut { short + " …" } else { short })
}

/// A script as a driver: one for each device.
pub fn who(caller: &Caller) -> Who {
    let (number, name) = caller.device.clone().unwrap_or_default();
    Who { client: script(number), role: caller.role.unwrap_or_default(), device: name }
}

/// Checks that a caller has a role.
///
/// # Errors
/// It has not.
pub fn demand(caller: &Caller, role: Role) -> Result<(), Problem> {
    if caller.role.is_some_and(|has| has >= role) {
        return Ok(());
    }
    Err(problem(Why::Role, format!("this needs the role {role:?}").to_lowercase()))
}

/// Returns what somebody who helps has to know, as text.
pub async fn problems(State(app): State<Arc<App>>) -> Result<String, Refused> {
    let failed = |error: std::io::Error| problem(Why::Server, error.to_string());
    soon(move || help_wanted::problems(&app).map_err(failed)).await
}

/// The lines that are wanted of the record of a controller.
#[derive(Debug, Deserialize)]
pub struct WantedLines {
    /// The number of the first.
    #[serde(default)]
    since: u64,
    /// Reports, the questions for them and `ok`s as well: any value.
    routine: Option<String>,
}

/// Returns what was sent to the controller and what it answered, from a line on, a portion at a time.
pub async fn lines(
    State(app): State<Arc<App>>,
    Query(wanted): Query<WantedLines>,
) -> Result<Json<ControllerLines>, Refused> {
    let WantedLines { since, routine } = wanted;
    Ok(Json(soon(move || line_log::since(&app, since, routine.is_some())).await?))
}

/// Returns all of that as text.
pub async fn lines_as_text(State(app): State<Arc<App>>) -> Result<String, Refused> {
    soon(move || line_log::text(&app)).await
}

/// The shapes of the drawing.
pub async fn shapes(State(app): State<Arc<App>>) -> Result<Json<ShapeList>, Refused> {
    Ok(Json(aside(move || Ok(app.drawing.shapes())).await?))
}

/// Returns what the drawing becomes when it is machined.
pub async fn tool_paths(State(app): State<Arc<App>>) -> Result<Json<ToolPaths>, Refused> {
    let awaited = Awaited::default();
    let _asked = awaited.while_asked();
    Ok(Json(aside(move || Ok(app.drawing.tool_paths(&awaited))).await?))
}

/// The job that is open.
pub async fn job(State(app): State<Arc<App>>) -> Result<Json<JobView>, Refused> {
    Ok(Json(aside(move || app.jobs.job_view()).await?))
}

/// Starts the job or part file that is open, as the Start key does.
pub async fn start(
    State(app): State<Arc<App>>,
    Extension(caller): Extension<Caller>,
    Json(body): Json<Value>,
) -> Result<Json<Reply>, Refused> {
    let asker = app.hears(&who(&caller));
    done(app, asker, "run".into(), body).await
}

/// The operations of drawings, as forms.
pub async fn operations() -> Json<Vec<OperationEntry>> {
    Json(crate::operations::operations())
}
