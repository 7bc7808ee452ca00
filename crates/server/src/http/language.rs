//! Answers editors, fill-in sheets and the display of values (see [`kerf_language`]).

use super::{Refused, aside, soon};
use crate::app::App;
use crate::awaited::Awaited;
use crate::locks::lock;
use crate::machine::{bits, input_state};
use crate::refusal::problem;
use crate::{configure, to_wire};
use axum::Json;
use axum::extract::{Query, State};
use axum::response::{IntoResponse, Response};
use kerf_machine::lines::Input;
use kerf_program::settings::LINES;
use kerf_wire::{
    Checked, CommandEntry, Completion, Hover, Lamp, NamedValue, PortBit, Problem, SystemValue,
    Values, Why,
};
use serde::{Deserialize, Serialize};
use std::collections::HashMap;
use std::sync::Arc;

/// A text that is being edited.
#[derive(Debug, Deserialize, schemars::JsonSchema)]
pub struct Text {
    /// The file; its extension tells the language.
    name: String,
    text: String,
    /// The text is an excerpt of a larger one and is checked by itself.
    #[serde(default)]
    part: bool,
}

/// A place in a text.
#[derive(Debug, Deserialize, schemars::JsonSchema)]
pub struct Spot {
    text: String,
    /// From 1.
    line: u32,
    /// From 1, in characters.
    column: u32,
}

/// A text in good form.
#[derive(Debug, Serialize, schemars::JsonSchema)]
pub struct Formatted {
    text: String,
}

/// Every command, with the settings that hold now.
pub async fn commands(State(app): State<Arc<App>>) -> Json<Vec<CommandEntry>> {
    let settings = lock(&app.left).session.memory.settings.clone();
    let mut all = kerf_language::commands(&settings);
    let added = app
        .loader
        .preview_workspace()
        .map(|workspace| kerf_workspace::virtual_tools::add_ins(&workspace).0)
        .unwrap_or_default();
    all.extend(added.iter().map(kerf_language::added));
    Json(all)
}

/// Tells what is wrong with a text.
pub async fn check(
    State(app): State<Arc<App>>,
    Json(edited): Json<Text>,
) -> Result<Json<Checked>, Refused> {
    let unit = lock(&app.left).session.memory.settings.linear_unit;
    let awaited = Awaited::default();
    let _asked = awaited.while_asked();
    let Text { name, text, part } = edited;
    if part {
        return Ok(Json(soon(move || Ok(kerf_language::check_lines(&name, &text))).await?));
    }
    let checked = move || {
        let given_up = || awaited.is_given_up();
        Ok(kerf_language::check_until(&name, &text, unit, &given_up))
    };
    Ok(Json(aside(checked).await?))
}

/// Words that could stand at a place.
pub async fn complete(Json(spot): Json<Spot>) -> Result<Json<Vec<Completion>>, Refused> {
    let words = move || Ok(kerf_language::complete(&spot.text, spot.line, spot.column));
    Ok(Json(soon(words).await?))
}

/// Explains the word at a place.
pub async fn hover(Json(spot): Json<Spot>) -> Result<Json<Option<Hover>>, Refused> {
    let word = move || Ok(kerf_language::hover(&spot.text, spot.line, spot.column));
    Ok(Json(soon(word).await?))
}

/// A text in good form; what it does stays. G-code stays as it is.
pub async fn format(Json(edited): Json<Text>) -> Result<Json<Formatted>, Refused> {
    let formatted = move || {
        let foreign = kerf_sbp::is_gcode_name(&edited.name);
        let text = if foreign { edited.text } else { kerf_sbp::format(&edited.text) };
        Ok(Formatted { text })
    };
    Ok(Json(aside(formatted).await?))
}

/// System variables, user variables and settings as the last run left them.
pub async fn values(State(app): State<Arc<App>>) -> Result<Json<Values>, Refused> {
    Ok(Json(aside(move || read_values(&app)).await?))
}

fn read_values(app: &App) -> Result<Values, Problem> {
    let session = lock(&app.left).session.clone();
    let workspace = app.loader.preview_workspace();
    let mut workspace = workspace.map_err(|error| problem(Why::Server, error.to_string()))?;
    let system = kerf_control::system_variables(&session, &mut workspace).into_iter().map(
        |(variable, value)| {
            let (name, unit) = (variable.name.into(), variable.unit.into());
            SystemValue { number: variable.number, name, unit, value: value.display() }
        },
    );
    let memory = &session.memory;
    let variables = memory.variables.list().into_iter();
    let variables = variables
        .map(|(name, value)| NamedValue { name: format!("&{name}"), value: value.display() });
    Ok(Values {
        system: system.collect(),
        variables: variables.collect(),
        settings: kerf_sbp::table::settings_lines(&memory.settings),
        diagnostics: to_wire::named(kerf_control::diagnostics(&session, &mut workspace)),
        folder: app.hub.read(|now| now.folder.clone()),
        part_file: app
            .files
            .folder
            .name_of(workspace.stored.get(kerf_sbp::PART_FILE).unwrap_or_default()),
        parts: workspace.user_path(),
        data: workspace.app_path(),
    })
}

/// The configuration of the machine, as a form; with `?changes` its last changes, the newest first.
pub async fn settings(
    State(app): State<Arc<App>>,
    Query(asked): Query<HashMap<String, String>>,
) -> Result<Response, Refused> {
    if asked.contains_key("changes") {
        let read = move || {
            let changes = app.settings.changes.list();
            changes.map_err(|error| {
                problem(Why::Server, format!("the changes cannot be read: {error}"))
            })
        };
        return Ok(Json(aside(read).await?).into_response());
    }
    let form = configure::form(&lock(&app.left).session.configuration());
    Ok(Json(form).into_response())
}

/// Every bit of the ports of the card.
pub async fn ports(State(app): State<Arc<App>>) -> Json<Vec<PortBit>> {
    Json(bits(&lock(&app.left).session.configuration()))
}

/// Every input of the simulated machine: those of the control box, and the lines of the ports.
pub async fn inputs(State(app): State<Arc<App>>) -> Json<Vec<Lamp>> {
    let session = lock(&app.left).session.clone();
    let lamps = |machine: &kerf_model::Model| -> Vec<Lamp> {
        (1..=LINES as u8)
            .map(|number| to_wire::input(machine, |n| machine.input(n), number))
            .collect()
    };
    let mut lamps = session.look(lamps);
    let now = app.hub.read(|now| now.io.clone());
    for lamp in &mut lamps {
        // A run has the machine while it lasts: what stands here is as it was before.
        lamp.on = input_state(&now, lamp.number).unwrap_or(lamp.on);
        let input = Input::of_number(lamp.number);
        let label = input.and_then(|input| session.machine_is.name_in_use(input));
        lamp.label = label.unwrap_or(&lamp.label).to_owned();
    }
    Json(lamps)
}
