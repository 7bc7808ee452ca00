//! Everything that can be asked of a server: a line of the table each.

use kerf_wire::{
    Act, ByHand, CardAct, FileParameters, HeightMapChange, JobChoice, Op, ToolChange, ZeroChange,
};
use serde_json::{Value, json};

/// Way in which something is asked for.
#[derive(Clone, Debug)]
pub enum Asks {
    /// An act, with the number of the lease where it carries one.
    Act(Value),
    /// An answer to the question of a program, or of a stop where there is none.
    Answer { program: Option<&'static str>, kind: &'static str, words: &'static str },
    /// A value of the registry is written.
    Value { key: &'static str, value: &'static str },
    /// A route: method and path.
    Route(&'static str),
    /// An act over the socket of a page.
    Page(Value),
}

/// A line of the table.
#[derive(Clone, Debug)]
pub struct Row {
    /// Name of the row in the table.
    pub name: String,
    pub asks: Asks,
}

/// Every act once, so that it does as little as it can.
fn every() -> Vec<Act> {
    let lease = 0;
    vec![
        Act::Ping,
        Act::GiveUp,
        Act::Stop,
        Act::Hold,
        Act::Disarm,
        Act::JogStop { seq: 0 },
        Act::TakeLease { force: false },
        Act::GiveLease { lease },
        Act::Arm { lease },
        Act::Acknowledge,
        Act::Run { lease, hash: "none".into(), step: false },
        Act::TakeUp { lease },
        Act::Resume { lease },
        Act::Command { lease, line: "MX,0".into() },
        Act::JogStart {
            lease,
            seq: 0,
            direction: [1.0, 0.0, 0.0, 0.0, 0.0, 0.0],
            distance: Some(1.0),
            speed_share: 1.0,
            clock_ms: 0.0,
        },
        Act::JogRenew { lease, seq: 0, clock_ms: 0.0 },
        Act::Nudge { lease, axis: 'X', distance: 0.0 },
        Act::Go { lease, way: ByHand::Finish },
        Act::Bit { lease, name: "none".into(), on: true },
        Act::Step { lease, motor: "none".into(), forward: true },
        Act::Zero { lease, name: "none".into(), change: ZeroChange::Holds },
        Act::Tool { lease, number: 0, change: ToolChange::Gone },
        Act::ToolIn { lease },
        Act::TouchOff { lease },
        Act::ForgetPace { lease },
        Act::ControllerSteps { lease, axis: 'X', steps: 0.0 },
        Act::ControllerCard { lease, task: CardAct::List },
        Act::HeightMap { lease, change: HeightMapChange::File { name: "none.map".into() } },
        Act::WireLook { lease, port: "none".into() },
        Act::Wire { lease, port: "none".into(), board: None, into: "none".into() },
        Act::WireAnswer { lease, question: 0, answer: "q".into() },
        Act::Lift { lease, question: 0 },
        Act::Key { lease, seq: 0, key: '9', clock_ms: None },
        Act::Input { lease, number: 10, on: true },
        Act::Override {
            lease,
            feed_percent: Some(100.0),
            rapid_percent: None,
            spindle_percent: None,
        },
        Act::Set { lease, key: "units".into(), value: "ell".into() },
        Act::Unlock { password: "guess".into() },
        Act::Protect { password: None, new: None },
        Act::Open { name: "none.sbp".into(), parameters: FileParameters::default() },
        Act::Parameters { parameters: FileParameters::default() },
        Act::Choose { choice: JobChoice::default() },
        Act::KeepOrigin,
        Act::SaveJob,
        Act::TakeShapeBack,
        Act::Machine { drawing: Some("none.rsg".into()), anew: false },
        Act::Folder { name: "none".into(), mask: None },
        Act::Close,
        Act::Record { line: "MX,1".into() },
        Act::Watch { names: Vec::new() },
        Act::SheetDone,
        Act::ClearPrinted,
        Act::Draw { op: Op::New },
    ]
}

/// Those and no others: an act that is missing here fails.
fn acts() -> Vec<Row> {
    let rows: Vec<Row> = every().iter().map(Row::act).collect();
    let described = kerf_server::describe();
    for variant in described["components"]["schemas"]["Act"]["oneOf"].as_array().unwrap() {
        let name = variant["properties"]["do"]["const"].as_str().unwrap();
        let known = rows.iter().any(|row| row.name == format!("act `{name}`"));
        assert!(known || name == "answer", "{name} is missing in `every`");
    }
    rows
}

impl Row {
    fn act(act: &Act) -> Self {
        let act = serde_json::to_value(act).unwrap();
        Self { name: format!("act `{}`", act["do"].as_str().unwrap()), asks: Asks::Act(act) }
    }
}

fn more_acts() -> Vec<Row> {
    let act = |name: &str, act: Value| Row { name: name.into(), asks: Asks::Act(act) };
    vec![
        act(
            "act `command` with a V command",
            json!({ "do": "command", "lease": 0, "line": "VS,1" }),
        ),
        act("act `key` P (Stop)", json!({ "do": "key", "lease": 0, "seq": 0, "key": "P" })),
        act("act `takeLease` with force", json!({ "do": "takeLease", "force": true })),
    ]
}

/// Acts of whoever holds a key, over the socket of a page.
fn by_hand() -> Vec<Row> {
    const HELD: [&str; 6] = ["jogStart", "jogRenew", "jogStop", "nudge", "lift", "key"];
    let acts = every().into_iter().map(|act| serde_json::to_value(act).unwrap());
    let held = acts.filter(|act| HELD.contains(&act["do"].as_str().unwrap()));
    let name = |act: &Value| format!("page: `{}`", act["do"].as_str().unwrap());
    held.map(|act| Row { name: name(&act), asks: Asks::Page(act) }).collect()
}

fn answers() -> Vec<Row> {
    let row = |what: &str, program, kind, words| Row {
        name: format!("answer `{words}` {what}"),
        asks: Asks::Answer { program, kind, words },
    };
    let input = Some("INPUT how far &x");
    let (yes_no, pause) = (Some("MSGBOX(\"On?\",YesNo)"), Some("PAUSE"));
    let (spindle, keypad) = (Some("SO,1,1"), Some("SK"));
    vec![
        row("to INPUT", input, "input", "0"),
        row("to INPUT", input, "input", "Cancel"),
        row("to MSGBOX", yes_no, "msgbox", "Yes"),
        row("to MSGBOX", yes_no, "msgbox", "No"),
        row("to PAUSE", pause, "pause", "OK"),
        row("to PAUSE", pause, "pause", "Cancel"),
        row("to the spindle's question", spindle, "spindle", "OK"),
        row("to the spindle's question", spindle, "spindle", "Cancel"),
        row("to the keypad", keypad, "keypad", "OK"),
        row("to the keypad", keypad, "keypad", "jog 0,400,0,0,0,0 1"),
        row("after a stop", None, "hold", "Resume"),
        row("after a stop", None, "hold", "jog 0,400,0,0,0,0 1"),
        row("after a stop", None, "hold", "nudge x 1"),
        row("after a stop", None, "hold", "Quit"),
    ]
}

fn values() -> Vec<Row> {
    let row = |key, value| Row {
        name: format!(
            "value `{key}`{}",
            if value == "x" { String::new() } else { format!(" = {value}") }
        ),
        asks: Asks::Value { key, value },
    };
    vec![
        row("uValue", "x"),
        row("uValueClrd", "x"),
        row("$mine", "x"),
        row("Mine", "x"),
        row("uCommand", "MX,0"),
        row("uCommand", "VS,1"),
        row("SpindleStatus", "x"),
        row("PositionLost", "x"),
        row("ConfirmLocation", "x"),
        row("SimulatedSwitches", "x"),
        row("Status", "x"),
        row("OutPutSwitches", "x"),
        row("uPartFile", "x"),
        row("Editor", "x"),
        row("ControllerLeft", "x"),
    ]
}

/// Every route that is no act: method and path.
fn routes() -> Vec<Row> {
    let own = ["/ws", "/api/do/{act}"];
    let paths = kerf_server::paths().into_iter().filter(|path| !own.contains(path));
    let described = kerf_server::describe();
    let methods = |path: &str| {
        let known = described["paths"].get(path.replace('*', "")).cloned();
        let known = known.unwrap_or_else(|| json!({ "get": {} }));
        known.as_object().unwrap().keys().map(|method| method.to_uppercase()).collect::<Vec<_>>()
    };
    let of = |path: &'static str| methods(path).into_iter().map(move |method| (method, path));
    let named = |path: &str| {
        let part = |part: &str| if part.starts_with('{') { "99".into() } else { part.to_owned() };
        path.split('/').map(part).collect::<Vec<_>>().join("/")
    };
    let row = |(method, path): (String, &'static str)| Row {
        name: format!("{method} `{path}`"),
        asks: Asks::Route(format!("{method} {}", named(path)).leak()),
    };
    // Values of the registry have lines of their own.
    let all = paths.flat_map(of).filter(|it| *it != ("PUT".into(), "/api/registry/{*key}"));
    all.map(row).collect()
}

/// The parts of the table, each with its title.
pub fn parts() -> Vec<(&'static str, Vec<Row>)> {
    let acts = acts().into_iter().chain(more_acts()).collect();
    vec![
        ("Acts", acts),
        ("Acts of whoever holds a key, over the socket of a page", by_hand()),
        ("Answers", answers()),
        ("Values of the registry", values()),
        ("Routes", routes()),
    ]
}
