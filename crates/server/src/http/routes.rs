//! The routes, and their description for scripts (OpenAPI).

use super::language::{Formatted, Spot};
use super::{
    assets, bodies, files, guard, language, media, people, preview, registry, rest, socket, texts,
};
use crate::app::App;
use axum::Router;
use axum::body::Bytes;
use axum::extract::DefaultBodyLimit;
use axum::http::header::CONTENT_TYPE;
use axum::middleware::from_fn_with_state;
use axum::response::IntoResponse;
use axum::routing::{MethodRouter, any, delete, get, post};
use kerf_wire::preview::{PreviewInfo, Timing};
use kerf_wire::{
    Act, Checked, CommandEntry, Completion, ControllerLines, FileInfo, Hover, JobView, Lamp,
    NamedValue, OperationEntry, PortBit, Reply, RunRecord, SettingArea, ShapeList, Snapshot,
    TextDraft, ToDo, ToolPaths, Values,
};
use schemars::generate::SchemaSettings;
use schemars::{JsonSchema, SchemaGenerator};
use serde_json::{Map, Value, json};
use std::sync::{Arc, LazyLock};

/// Bytes that a draft of the editor has at most.
const MOST_TEXT: usize = 32 << 20;

/// Every route; everything passes the guard.
pub fn router(app: Arc<App>) -> Router {
    let all = served().into_iter();
    all.fold(Router::new(), |router, (path, methods)| router.route(path, methods))
        .fallback(get(assets::asset))
        // Routes that take more say so.
        .layer(DefaultBodyLimit::max(bodies::SHORT))
        .layer(from_fn_with_state(app.clone(), guard::guard))
        .with_state(app)
}

/// The paths of every route; what is none of them is a file of the page.
pub fn paths() -> Vec<&'static str> {
    served().into_iter().map(|(path, _)| path).collect()
}

/// Lists every route and what serves it. This is the one list.
fn served() -> Vec<(&'static str, MethodRouter<Arc<App>>)> {
    let most = DefaultBodyLimit::max;
    let upload = get(files::read).put(files::write).post(files::restore).delete(files::delete);
    let upload = upload.layer(most(bodies::FILE));
    let texts = get(texts::list).put(texts::keep).delete(texts::end);
    vec![
        ("/ws", any(socket::socket)),
        ("/api/state", get(rest::state)),
        ("/api/do/{act}", post(rest::act).layer(most(bodies::ACT))),
        ("/api/files", get(files::list)),
        ("/api/files/{*name}", upload),
        ("/api/texts", texts.layer(most(MOST_TEXT))),
        ("/api/media/{*name}", get(media::sound)),
        ("/api/preview/{key}", get(preview::info)),
        ("/api/preview/{key}/timing", get(preview::timing)),
        ("/api/preview/{key}/{level}/{piece}", get(preview::piece)),
        ("/api/typed/{key}/{from}", get(preview::typed)),
        ("/api/history", get(rest::history)),
        ("/api/todo", get(rest::todo).put(rest::put_todo)),
        ("/api/job", get(rest::job)),
        ("/api/job/start", post(rest::start)),
        ("/api/drawing/shapes", get(rest::shapes)),
        ("/api/drawing/paths", get(rest::tool_paths)),
        ("/api/drawing/operations", get(rest::operations)),
        ("/api/commands", get(language::commands)),
        ("/api/values", get(language::values)),
        ("/api/problems", get(rest::problems)),
        ("/api/lines", get(rest::lines)),
        ("/api/lines/text", get(rest::lines_as_text)),
        ("/api/settings", get(language::settings)),
        ("/api/inputs", get(language::inputs)),
        ("/api/ports", get(language::ports)),
        ("/api/registry", get(registry::list)),
        ("/api/registry/{*key}", get(registry::get).put(registry::set)),
        ("/api/language/check", post(language::check).layer(most(bodies::TEXT))),
        ("/api/language/complete", post(language::complete).layer(most(bodies::TEXT))),
        ("/api/language/hover", post(language::hover).layer(most(bodies::TEXT))),
        ("/api/language/format", post(language::format).layer(most(bodies::TEXT))),
        ("/api/pair", post(people::pair)),
        ("/api/pair/code", post(people::code)),
        ("/api/devices", get(people::list)),
        ("/api/devices/{number}", delete(people::revoke)),
        ("/api/openapi.json", get(described)),
    ]
}

/// The description, made once.
async fn described() -> impl IntoResponse {
    static DESCRIBED: LazyLock<Bytes> = LazyLock::new(|| describe().to_string().into());
    ([(CONTENT_TYPE, "application/json")], DESCRIBED.clone())
}

/// Makes the schema of a type.
type Schema = fn(&mut SchemaGenerator) -> Value;

/// A route as a script sees it.
struct Route {
    path: &'static str,
    method: &'static str,
    doc: &'static str,
    body: Option<Schema>,
    answer: Option<Schema>,
}

fn schema<T: JsonSchema>(generator: &mut SchemaGenerator) -> Value {
    generator.subschema_for::<T>().to_value()
}

const fn looks(path: &'static str, doc: &'static str, answer: Option<Schema>) -> Route {
    Route { path, method: "get", doc, body: None, answer }
}

/// A question of an editor.
const fn asks(path: &'static str, doc: &'static str, body: Schema, answer: Schema) -> Route {
    Route { path, method: "post", doc, body: Some(body), answer: Some(answer) }
}

const fn acts(
    path: &'static str,
    method: &'static str,
    doc: &'static str,
    body: Option<Schema>,
    answer: Option<Schema>,
) -> Route {
    Route { path, method, doc, body, answer }
}

/// Every route that scripts may like.
fn routes() -> Vec<Route> {
    let all = [
        machine(),
        files(),
        planned(),
        runs(),
        drawing(),
        kept(),
        lines(),
        language_of_parts(),
        devices(),
    ];
    all.into_iter().flatten().collect()
}

/// What pages show, and what they do.
fn machine() -> Vec<Route> {
    vec![
        looks("/api/state", "Everything that pages show", Some(schema::<Snapshot>)),
        acts(
            "/api/do/{act}",
            "post",
            "Does something: the name of the act in the path, its other fields in the body",
            Some(schema::<Act>),
            Some(schema::<Reply>),
        ),
    ]
}

/// Files of the part folder, and drafts.
fn files() -> Vec<Route> {
    vec![
        looks(
            "/api/files",
            "What a folder of the part folder holds: ?folder=NAME, and ?mask=*.sb?; with ?find=WORD also the \
             folders below; with ?bin the files that were deleted",
            Some(schema::<Vec<FileInfo>>),
        ),
        looks(
            "/api/files/{name}",
            "A file of the part folder; with ?about what it is, with ?versions what it was before the last \
             saves, with ?version=NUMBER one of those; with ?thumb a small picture of its tool path or of the drawing, SVG",
            None,
        ),
        acts(
            "/api/files/{name}",
            "put",
            "Writes a file into the part folder; another one that is there is replaced only with \
                  If-Match: its hash, or with ?replace=1",
            None,
            None,
        ),
        acts("/api/files/{name}", "post", "Brings a version back: ?restore=NUMBER", None, None),
        acts(
            "/api/files/{name}",
            "delete",
            "Moves the file with the hash that If-Match names into the bin; with ?forget it leaves the bin for good, with ?renamed=NAME its history goes to that file",
            None,
            None,
        ),
        looks(
            "/api/texts",
            "Text of the editor that is not saved, a draft for each file, the newest first; with ?base=HASH the text \
             that edits of a draft are of",
            Some(schema::<Vec<TextDraft>>),
        ),
        acts(
            "/api/texts",
            "put",
            "Keeps a draft in the place of an earlier one of the same file",
            Some(schema::<TextDraft>),
            None,
        ),
        acts("/api/texts", "delete", "Ends the draft of a file: ?name=NAME", None, None),
    ]
}

/// Paths that were planned or typed.
fn planned() -> Vec<Route> {
    vec![
        looks("/api/preview/{key}", "The preview of the open file", Some(schema::<PreviewInfo>)),
        looks(
            "/api/preview/{key}/timing",
            "Inputs and outputs of the open file beside its motion, from a run on the simulated machine: \
             ?inputs=3@2.5=1 moves an input",
            Some(schema::<Timing>),
        ),
        looks("/api/preview/{key}/{level}/{piece}", "A piece of its path, binary", None),
        looks(
            "/api/typed/{key}/{from}",
            "The path of what was typed, from a segment on, binary",
            None,
        ),
    ]
}

/// Runs: those that were, those to come, the open job.
fn runs() -> Vec<Route> {
    vec![
        looks("/api/history", "Runs of files, the newest first", Some(schema::<Vec<RunRecord>>)),
        looks("/api/todo", "Files that are to be run, and how often", Some(schema::<Vec<ToDo>>)),
        acts(
            "/api/todo",
            "put",
            "Puts another list in the place of that one",
            Some(schema::<Vec<ToDo>>),
            None,
        ),
        looks("/api/job", "The paths of the open job, and how it is cut", Some(schema::<JobView>)),
        acts(
            "/api/job/start",
            "post",
            "Starts the open file, as the Start key does: lease and hash, as the act run; a job that is \
                  paused goes on",
            Some(schema::<Value>),
            Some(schema::<Reply>),
        ),
    ]
}

/// The drawing.
fn drawing() -> Vec<Route> {
    vec![
        looks("/api/drawing/shapes", "The shapes of the drawing", Some(schema::<ShapeList>)),
        looks("/api/drawing/paths", "The tool paths of the drawing", Some(schema::<ToolPaths>)),
        looks(
            "/api/drawing/operations",
            "What can be done to a drawing",
            Some(schema::<Vec<OperationEntry>>),
        ),
    ]
}

/// What the machine remembers.
fn kept() -> Vec<Route> {
    vec![
        looks("/api/values", "What the machine remembers", Some(schema::<Values>)),
        looks("/api/media/{name}", "A sound of the part folder or the folder of sounds", None),
        looks("/api/problems", "What somebody who helps has to know, as text", None),
        looks(
            "/api/lines",
            "What was sent to the controller and what it answered: ?since=NUMBER, the `next` of the answer before; with ?routine=1 \
             its reports and every ok as well",
            Some(schema::<ControllerLines>),
        ),
        looks("/api/lines/text", "All of that which is kept, as text", None),
        looks(
            "/api/settings",
            "The configuration of the machine, to be changed with the act set; with ?changes its last changes",
            Some(schema::<Vec<SettingArea>>),
        ),
        looks(
            "/api/registry",
            "Values that programs and other software keep, and the status",
            Some(schema::<Vec<NamedValue>>),
        ),
        looks("/api/registry/{key}", "One of them, as text", None),
        acts(
            "/api/registry/{key}",
            "put",
            "Sets one of them to the text of the body; an empty one removes it",
            None,
            None,
        ),
    ]
}

/// Inputs and ports.
fn lines() -> Vec<Route> {
    vec![
        looks("/api/inputs", "Every input of the simulated machine", Some(schema::<Vec<Lamp>>)),
        looks("/api/ports", "Every bit of the card's ports", Some(schema::<Vec<PortBit>>)),
        looks("/api/commands", "The commands of OpenSBP", Some(schema::<Vec<CommandEntry>>)),
    ]
}

/// Questions of an editor.
fn language_of_parts() -> Vec<Route> {
    vec![
        asks(
            "/api/language/check",
            "What is wrong with a text",
            schema::<language::Text>,
            schema::<Checked>,
        ),
        asks(
            "/api/language/complete",
            "Words that could stand at a place",
            schema::<Spot>,
            schema::<Vec<Completion>>,
        ),
        asks(
            "/api/language/hover",
            "What the word at a place means",
            schema::<Spot>,
            schema::<Option<Hover>>,
        ),
        asks(
            "/api/language/format",
            "A text in good form",
            schema::<language::Text>,
            schema::<Formatted>,
        ),
    ]
}

/// Devices.
fn devices() -> Vec<Route> {
    vec![
        acts(
            "/api/pair",
            "post",
            "Pairs the device that asks, by the code that the machine shows",
            Some(schema::<people::Pair>),
            Some(schema::<people::Paired>),
        ),
        acts(
            "/api/pair/code",
            "post",
            "Shows a code for a new device (owner)",
            Some(schema::<people::Wanted>),
            Some(schema::<people::Code>),
        ),
        looks("/api/devices", "Paired devices (owner)", Some(schema::<Vec<people::Listed>>)),
        acts("/api/devices/{number}", "delete", "Revokes a device (owner)", None, None),
    ]
}

/// The description of the HTTP interface: OpenAPI 3.1.
pub fn describe() -> Value {
    let settings = SchemaSettings::draft2020_12()
        .with(|settings| settings.definitions_path = "/components/schemas".into());
    let mut generator = settings.into_generator();
    let mut paths = Map::new();
    for route in routes() {
        let methods = paths.entry(route.path).or_insert_with(|| json!({}));
        methods[route.method] = operation(&route, &mut generator);
    }
    let version = env!("CARGO_PKG_VERSION");
    json!({
        "openapi": "3.1.0",
        "info": { "title": "Kerf", "version": version },
        "paths": paths,
        "components": { "schemas": generator.take_definitions(true) },
    })
}

fn operation(route: &Route, generator: &mut SchemaGenerator) -> Value {
    let content = |schema: Value| json!({ "application/json": { "schema": schema } });
    let names = route.path.split(['{', '}']).skip(1).step_by(2);
    let parameter = |name: &str| json!({ "name": name, "in": "path", "required": true, "schema": { "type": "string" } });
    let mut operation = json!({
        "summary": route.doc,
        "parameters": names.map(parameter).collect::<Vec<_>>(),
        "responses": { "200": { "description": "done" } },
    });
    if let Some(answer) = route.answer {
        operation["responses"]["200"]["content"] = content(answer(generator));
    }
    if let Some(body) = route.body {
        operation["requestBody"] = json!({ "content": content(body(generator)) });
    }
    operation
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn every_route_is_described() {
        let described = describe();
        let described = described["paths"].as_object().unwrap();
        for path in paths() {
            let own = ["/ws", "/api/openapi.json"].contains(&path);
            assert!(own || described.contains_key(&path.replace('*', "")), "{path}");
        }
        assert_eq!(described.len() + 2, paths().len());
    }
}
