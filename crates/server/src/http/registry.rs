//! The values that programs and other software keep, under the names of the external control.

use super::guard::Caller;
use super::rest::who;
use super::{Refused, soon};
use crate::app::App;
use crate::asker::Asker;
use crate::gate::Demand;
use crate::locks::lock;
use crate::machine::Order;
use crate::orders::Orders;
use crate::refusal::problem;
use axum::extract::{Path, State};
use axum::{Extension, Json};
use kerf_journal::{Live, check_value};
use kerf_wire::{Act, NamedValue, Problem, Why};
use kerf_workspace::command_passing;
use std::sync::Arc;

/// Longest value, bytes.
const LONGEST: usize = 1 << 16;

/// Every key with its value: what the machine is doing first.
pub async fn list(State(app): State<Arc<App>>) -> Result<Json<Vec<NamedValue>>, Refused> {
    Ok(Json(soon(move || values(&app)).await?))
}

/// The value of a key; a path before the last / is left out.
pub async fn get(State(app): State<Arc<App>>, Path(key): Path<String>) -> Result<String, Refused> {
    let found = soon(move || {
        let key = last_part(&key).to_owned();
        let value = values(&app)?.into_iter().find(|value| value.name == key);
        value.ok_or_else(|| problem(Why::File, format!("{key} has no value")))
    });
    Ok(found.await?.value)
}

/// Sets the value of a key; an empty one removes it. A command is carried out, or refused, at once.
pub async fn set(
    State(app): State<Arc<App>>,
    Extension(caller): Extension<Caller>,
    Path(key): Path<String>,
    value: String,
) -> Result<Json<()>, Refused> {
    let asker = app.hears(&who(&caller));
    let set = move || {
        let key = last_part(&key);
        if value.len() > LONGEST {
            return Err(problem(Why::Malformed, "the value is too long"));
        }
        if key == command_passing::COMMAND {
            let passed = pass_in(&app, &asker, value.trim());
            return passed.inspect_err(|why| log_refused(&app.orders, value.trim(), why));
        }
        app.gate(&asker.who, Demand::Value(key))?;
        let journal =
            app.loader.journal().ok_or_else(|| problem(Why::State, "nothing is kept here"))?;
        let value = Some(value.trim_end()).filter(|value| !value.is_empty());
        check_value(key, value).map_err(|why| problem(Why::Malformed, why))?;
        journal.registry.set_value(key, value).map_err(server)
    };
    Ok(Json(soon(set).await?))
}

/// Enters in the system log that a command was refused, and why.
fn log_refused(orders: &Orders, command: &str, why: &Problem) {
    let told = format!("{command} was passed in and not carried out: {}", why.text);
    // The machine's thread ends with the server.
    drop(orders.send(Order::Refused(told)));
}

/// Carries a command out that came over the network, as if whoever drives had typed it: a script may where its
/// device drives, at a page or by itself.
fn pass_in(app: &Arc<App>, asker: &Asker, command: &str) -> Result<(), Problem> {
    let line = match command_passing::single(command) {
        _ if command.is_empty() => return Ok(()),
        Ok(line) => line,
        Err(why) => return Err(problem(Why::Mistake, why)),
    };
    let asker = app.driving.at_wheel(asker);
    let lease = app.hub.read(|now| now.lease.as_ref().map_or(0, |lease| lease.number));
    app.act(&asker, Act::Command { lease, line }).map(drop)
}

fn values(app: &App) -> Result<Vec<NamedValue>, Problem> {
    let Some(journal) = app.loader.journal() else { return Ok(Vec::new()) };
    let rest = || lock(&app.left).session.look(Live::at_rest);
    let live = journal.registry.running().map_err(server)?.unwrap_or_else(rest);
    let live = live.values().map(|(name, value)| (name.to_owned(), value.to_string()));
    let kept = journal.registry.values().map_err(server)?;
    let mut unset = unset(app).to_vec();
    unset.retain(|(key, _)| !kept.iter().any(|(name, _)| name == key));
    Ok(crate::to_wire::named(live.into_iter().chain(unset).chain(kept)))
}

/// Keys that have a value also where nothing has set them yet.
fn unset(app: &App) -> [(String, String); 3] {
    let whole = |folder: &std::path::Path| {
        folder.canonicalize().unwrap_or_else(|_| folder.to_owned()).display().to_string()
    };
    let folder = lock(&app.left).folder.clone();
    let told = [
        ("SpindleStatus", "0".into()),
        ("uAppPath", whole(&app.options.data)),
        ("uUsrPath", whole(&folder)),
    ];
    told.map(|(key, value)| (key.to_owned(), value))
}

fn server(error: kerf_journal::JournalError) -> Problem {
    problem(Why::Server, error.to_string())
}

fn last_part(key: &str) -> &str {
    key.rsplit('/').next().unwrap_or(key)
}
