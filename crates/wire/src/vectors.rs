//! Vectors: changes of a snapshot and what becomes of it, for whoever takes changes over in another language.

use crate::preview::TypedPath;
use crate::{
    AXES, Asked, Change, Client, ControllerCard, ControllerSetting, CurrentRun, Digitized,
    DrawingState, Folder, HandConsole, HeightMap, Interrupted, Io, Lease, Look, Looked, Machine,
    Message, Motion, NamedValue, Opened, Overrides, Pause, Recorder, Role, ServedMachine, Setup,
    Snapshot, Sound, Speeds, StartUp, ToolTable, Units, Zero,
};
use serde::Serialize;
use serde_json::{Map, Value};

/// A change, and the sections of the snapshot that are others after it.
#[derive(Serialize)]
struct Step {
    change: Change,
    after: Map<String, Value>,
}

/// A snapshot and the changes that follow, each applied to the outcome of the one before.
#[derive(Serialize)]
struct Vectors {
    first: Snapshot,
    steps: Vec<Step>,
}

/// Every sort of change in turn, with the outcome of [`Snapshot::apply`], as JSON.
///
/// # Errors
/// When a snapshot cannot be written as JSON.
pub fn fold_vectors() -> serde_json::Result<String> {
    let first = Snapshot { revision: u32::MAX - 2, ..Snapshot::default() };
    let mut now = first.clone();
    let mut steps = Vec::new();
    for change in changes() {
        let before = sections(&now)?;
        now.apply(change.clone());
        let after = sections(&now)?;
        let after = after.into_iter().filter(|(name, value)| before.get(name) != Some(value));
        steps.push(Step { change, after: after.collect() });
    }
    Ok(serde_json::to_string(&Vectors { first, steps })? + "\n")
}

fn sections(snapshot: &Snapshot) -> serde_json::Result<Map<String, Value>> {
    serde_json::from_value(serde_json::to_value(snapshot)?)
}

/// So many lines of the print window, and messages, that the oldest are dropped.
const MANY: usize = 600;

fn changes() -> Vec<Change> {
    let mut all = of_the_machine();
    all.extend(of_the_job());
    all.extend(of_the_page());
    all
}

fn of_the_machine() -> Vec<Change> {
    let units = Units { mm: 25.4, ..Units::default() };
    let at = Look::Machine;
    vec![
        Change::Machine { machine: Machine { armed: true, ..Machine::default() } },
        Change::Motion { motion: Motion { line: 7, ..Motion::default() } },
        Change::Units { units },
        Change::Setup { setup: Setup { pick_radius: 4.0, ..Setup::default() } },
        Change::Speeds { speeds: Speeds::default() },
        Change::Io { io: Io::default() },
        Change::Zeros { zeros: vec![Zero { name: "G54".into(), at: [1.0; AXES], holds: true }] },
        Change::ControllerSteps { controller_steps: vec![250.0, 80.0] },
        Change::ControllerSettings {
            controller_settings: vec![ControllerSetting { number: 110, ..Default::default() }],
        },
        Change::ControllerCard {
            controller_card: ControllerCard { has: true, ..ControllerCard::default() },
        },
        Change::Tools { tools: ToolTable { in_spindle: 2, ..ToolTable::default() } },
        Change::HeightMap { height_map: Some(HeightMap::of(&[0.0, 1.0], &[0.0, 2.0], &[0.5; 4])) },
        Change::HeightMap { height_map: None },
        Change::Wiring { wiring: Some(crate::Wiring { question: 2, ..crate::Wiring::default() }) },
        Change::Overrides { overrides: Overrides { feed_percent: 80.0, ..Overrides::default() } },
        Change::Settings { settings: 3 },
        Change::HandConsole { hand_console: HandConsole::default() },
        Change::Digitized { digitized: Some(Digitized::default()) },
        Change::Digitized { digitized: None },
        Change::Looked { looked: Some(Looked { number: 1, at }) },
    ]
}

fn of_the_job() -> Vec<Change> {
    let lines = |from: usize| (from..from + MANY).map(|n| n.to_string()).collect();
    let message = |n: usize| Message { text: n.to_string(), ..Message::default() };
    let value = NamedValue { name: "&depth".into(), value: "1".into() };
    vec![
        Change::Opened { opened: Some(Opened::default()) },
        Change::Opened { opened: None },
        Change::Job { job: Some(CurrentRun { run: 1, ..CurrentRun::default() }) },
        Change::Typed { typed: TypedPath { segments: 2, ..TypedPath::default() } },
        Change::Together {
            together: vec![ServedMachine { name: "shop".into(), port: 8710, here: true }],
        },
        Change::Interrupted { interrupted: Some(Interrupted::default()) },
        Change::Asked { asked: Some(Asked::default()) },
        Change::Pause { pause: Some(Pause { text: "so long".into(), until: 5.0 }) },
        Change::Sound { sound: Some(Sound { number: 1, name: "done.wav".into() }) },
        Change::Printed { lines: lines(0) },
        Change::Printed { lines: lines(MANY) },
        Change::ClearPrinted,
        Change::Messages { messages: (0..MANY).map(message).collect() },
        Change::Watched { watched: vec![value] },
        Change::Recorder { recorder: Recorder::default() },
    ]
}

fn of_the_page() -> Vec<Change> {
    let lease = Lease { number: 2, client: 1, device: "shop".into() };
    let client = Client { client: 1, role: Role::default(), device: "shop".into() };
    let start = StartUp { file: "a.sbp".into(), sheet: true, display: 1 };
    vec![
        Change::Start { start: Some(start) },
        Change::Lease { lease: Some(lease) },
        Change::Lease { lease: None },
        Change::Clients { clients: vec![client] },
        Change::Drawing { drawing: Some(DrawingState::default()) },
        Change::Files { files: 9 },
        Change::Folder { folder: Folder { name: "doors".into(), ..Folder::default() } },
    ]
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn every_sort_of_change_is_among_them() {
        let schema = serde_json::to_value(schemars::schema_for!(Change)).unwrap();
        let known: BTreeSet<String> = schema["oneOf"]
            .as_array()
            .unwrap()
            .iter()
            .map(|variant| variant["properties"]["change"]["const"].as_str().unwrap().to_owned())
            .collect();
        let vectors: Value = serde_json::from_str(&fold_vectors().unwrap()).unwrap();
        let shown: BTreeSet<String> = vectors["steps"]
            .as_array()
            .unwrap()
            .iter()
            .map(|step| step["change"]["change"].as_str().unwrap().to_owned())
            .collect();
        assert_eq!(shown, known);
    }
}
