//! Table of who may what, where no request names it: requests of the hand console, and every kind of question. Each
//! cell is tried at an app without a network; what acts, values and routes are told over the network is tried in
//! `tests/who_may_what`.

use crate::handconsole::grant;
use crate::people::Grip;
use crate::testing::{Bench, bench};
use kerf_control::answers::{KINDS, kind_word};
use kerf_drawing::Shape;
use kerf_geom::Point2;
use kerf_handconsole::{ConsoleRequest, JobRequest};
use kerf_machine::{Errand, Held, Keypad};
use kerf_program::QuestionKind;
use kerf_wire::{Act, Asked, Change, Lease, Look, Machine, Problem, Role, State, Who, Why};
use std::fmt::Write;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::mpsc::channel;

/// Callers, and whether each is whoever drives.
const CALLERS: [(&str, Role, bool); 6] = [
    ("observer", Role::Observer, false),
    ("operator", Role::Operator, false),
    ("operator who drives", Role::Operator, true),
    ("setter", Role::Setter, false),
    ("setter who drives", Role::Setter, true),
    ("owner", Role::Owner, false),
];

/// States of the machine, and whether it is armed.
const STATES: [(char, State, bool); 8] = [
    ('D', State::Idle, false),
    ('A', State::Idle, true),
    ('R', State::Running, true),
    ('J', State::Jogging, true),
    ('S', State::Stopped, true),
    ('s', State::Stopped, false),
    ('Q', State::Asking, true),
    ('q', State::Asking, false),
];

/// The request of a row.
enum Asks {
    Console(ConsoleRequest),
    Answer(QuestionKind, &'static str),
}

/// A line of the table.
struct Row {
    name: String,
    asks: Asks,
    /// The machine moves by it, or goes on, or its settings are others.
    moves: bool,
}

/// Returns the name of a request, and whether it takes whoever drives. A request that is none of these does not compile.
const fn of_request(request: &ConsoleRequest) -> (&'static str, bool) {
    match request {
        ConsoleRequest::Stop => ("stop", false),
        ConsoleRequest::Resume => ("resume", true),
        ConsoleRequest::Start => ("start the job", true),
        ConsoleRequest::Answer(_) => ("answer", false),
        ConsoleRequest::Acknowledge => ("take note of an alarm", false),
        ConsoleRequest::TakeControl => ("take control", false),
        ConsoleRequest::Open(_) => ("open a job", false),
        ConsoleRequest::Jog(_) => ("move while a key is held", true),
        ConsoleRequest::Go(_) => ("an errand", true),
        ConsoleRequest::Set(_) => ("change settings", true),
        ConsoleRequest::KeepSettings => ("keep settings", true),
        ConsoleRequest::Job(_) => ("change the job", true),
        ConsoleRequest::AddShape(_) => ("add a shape", false),
        ConsoleRequest::Look(_) => ("show something else", false),
    }
}

fn requests() -> Vec<Row> {
    let held = Held { way: [1, 0, 0, 0, 0, 0], speed: 1.0, accel: 1.0, sets_bottom: false };
    let way = [1.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    let keypad = Keypad { way, times: Some(1.0), speed: 1.0, homed: Default::default() };
    let all = [
        ConsoleRequest::Stop,
        ConsoleRequest::Resume,
        ConsoleRequest::Start,
        ConsoleRequest::Acknowledge,
        ConsoleRequest::TakeControl,
        ConsoleRequest::Open("none".into()),
        ConsoleRequest::Jog(held),
        ConsoleRequest::Go(Errand::Keypad(keypad)),
        ConsoleRequest::Set(Vec::new()),
        ConsoleRequest::KeepSettings,
        ConsoleRequest::Job(JobRequest::Nearest),
        ConsoleRequest::AddShape(Arc::new(Shape::point(Point2::new(1.0, 1.0)))),
        ConsoleRequest::Look(Look::Data),
    ];
    let row = |request: ConsoleRequest| {
        let (name, moves) = of_request(&request);
        Row { name: name.into(), asks: Asks::Console(request), moves }
    };
    all.into_iter().map(row).collect()
}

/// Returns the answers to a kind of question, and whether the machine goes on by each. A kind that is none of these
/// does not compile.
const fn words(kind: QuestionKind) -> &'static [(&'static str, bool)] {
    const JOG: (&str, bool) = ("jog 0,400,0,0,0,0 1", true);
    match kind {
        QuestionKind::Input => &[("0", false), ("Cancel", false), ("jog 0,400,0,0,0,0 1", false)],
        QuestionKind::Msgbox => &[
            ("OK", true),
            ("Yes", true),
            ("Retry", true),
            ("Ignore", true),
            ("No", false),
            ("Abort", false),
            ("Cancel", false),
            JOG,
        ],
        QuestionKind::Pause => &[("OK", true), ("Cancel", false), JOG, ("lift", true)],
        QuestionKind::Spindle => &[("OK", true), ("Cancel", false)],
        QuestionKind::Limit => &[("Continue", true), ("End", false)],
        QuestionKind::Keypad => &[("OK", true), ("pendant", true), JOG],
        QuestionKind::Editor => &[("OK", true)],
        QuestionKind::Speed => &[("OK", true), ("Cancel", false)],
        QuestionKind::Hold => &[("Resume", true), ("Quit", false), ("nudge x 1", true), JOG],
        QuestionKind::Step => &[("Step", true), ("Run", true), ("5", true), ("Quit", false)],
        QuestionKind::Paused => &[("Resume", true), ("Quit", false), ("move y 200", true), JOG],
        QuestionKind::Location => &[("Yes", true), ("Continue", true), ("Cancel", false)],
    }
}

fn questions() -> Vec<Row> {
    let row = |kind, &(words, moves): &(&'static str, bool)| Row {
        name: format!("{}: `{words}`", kind_word(kind)),
        asks: Asks::Answer(kind, words),
        moves,
    };
    KINDS.iter().flat_map(|kind| words(*kind).iter().map(|said| row(*kind, said))).collect()
}

/// Returns what somebody is told who asks for that.
fn told(
    bench: &Bench,
    row: &Row,
    (_, role, drives): (&str, Role, bool),
    at: (State, bool),
) -> String {
    let (app, (state, armed)) = (&bench.app, at);
    let who = Who { client: if drives { 1 } else { 2 }, role, device: String::new() };
    let open = matches!(state, State::Stopped | State::Asking);
    let kind = match row.asks {
        Asks::Answer(kind, _) => kind_word(kind),
        Asks::Console(_) => "msgbox",
    };
    let asked = open.then(|| Asked { number: 5, kind: kind.into(), ..asked() });
    let lease = Some(Lease { number: 3, client: 1, device: String::new() });
    let machine = Machine { state, armed, ..app.hub.read(|now| now.machine.clone()) };
    app.hub.change(vec![
        Change::Asked { asked },
        Change::Lease { lease },
        Change::Machine { machine },
    ]);
    app.link.lock().close();
    app.link.lock().ask(5);
    let asker = app.hears(&who);
    let done = match &row.asks {
        Asks::Console(request) => {
            let grip = Grip { seq: 1, at: app.clock.now() };
            grant(app, &asker, grip, request.clone(), &channel().0)
        }
        Asks::Answer(_, words) => {
            let answer = Act::Answer { question: 5, answer: (*words).into() };
            app.act(&asker, answer).map(drop)
        }
    };
    while bench.ordered() {}
    word(done)
}

fn asked() -> Asked {
    let (text, title, buttons, file) = Default::default();
    Asked {
        number: 0,
        kind: String::new(),
        text,
        title,
        buttons,
        default: 0,
        prefill: String::new(),
        entry: false,
        icon: 0,
        edits: None,
        file,
        line: 0,
        was: State::Running,
    }
}

/// The reason of a refusal that says who may not; whatever else is wrong, this one may.
fn word(done: Result<(), Problem>) -> String {
    match done.map_err(|problem| problem.why) {
        Err(Why::Role) => "role",
        Err(Why::Lease) => "lease",
        Err(Why::Disarmed) => "disarmed",
        Err(Why::Password) => "password",
        Err(Why::Malformed) => "never",
        _ => "+",
    }
    .into()
}

/// Returns what is told in every state, or each word with the states in which it is.
fn cell(told: &[(char, String)]) -> String {
    let mut words: Vec<(&str, String)> = Vec::new();
    for (state, word) in told {
        match words.iter_mut().find(|(known, _)| known == word) {
            Some((_, states)) => states.push(*state),
            None => words.push((word, state.to_string())),
        }
    }
    match words.as_slice() {
        [(word, _)] => (*word).to_owned(),
        words => words.iter().map(|(w, at)| format!("{w} {at}")).collect::<Vec<_>>().join(", "),
    }
}

const HEAD: &str = "# Who may what: the hand console and questions

What [Who may what](who-may-what.md) is for acts, values and routes, this page is for requests of the hand console and for
every kind of question, with the same words. Whoever presses a key of the hand console is who asks: a page, a script, or the console's own
cable, which is a setter's. Each cell was tried; the page is made by a test (`KERF_WRITE_PAGES=1 cargo test -p kerf-server --lib
who_may_what`), which fails where one is another, and does not compile where a request or a kind of question is missing.

States: **D** disarmed, **A** armed and idle, **R** running, **J** a jog is made, **S** stopped in the middle, **Q** a question is
open, **s** and **q** the same with the machine disarmed. Questions are open in **Q** and **q** only.
";

/// A part of the page, with all that has to hold of it.
fn part(page: &mut String, title: &str, rows: &[Row], states: &[(char, State, bool)]) {
    let bench = bench();
    let callers = CALLERS.map(|(name, ..)| name);
    write!(page, "\n## {title}\n\n| | {} |\n", callers.join(" | ")).unwrap();
    *page += &format!("|{}\n", "---|".repeat(callers.len() + 1));
    for row in rows {
        let told = CALLERS.map(|caller| {
            let tried = states.iter().map(|(letter, state, armed)| {
                let word = told(&bench, row, caller, (*state, *armed));
                let may = word == "+";
                let cell = format!("{}, {}, {letter}: {word}", row.name, caller.0);
                assert!(!may || !row.moves || caller.2 && *armed, "{cell}");
                assert!(may || row.name != "stop", "{cell}");
                (*letter, word)
            });
            cell(&tried.collect::<Vec<_>>())
        });
        *page += &format!("| {} | {} |\n", row.name, told.join(" | "));
    }
}

/// The page, from the crate's folder.
fn place() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../docs/book/who-may-what-by-hand.md")
}

#[test]
fn what_the_book_says_of_requests_and_questions_is_so() {
    let mut page = HEAD.to_owned();
    part(&mut page, "Requests of the hand console", &requests(), &STATES);
    let open: Vec<_> = STATES.into_iter().filter(|(_, state, _)| *state == State::Asking).collect();
    part(&mut page, "Answers to each kind of question", &questions(), &open);
    if std::env::var_os("KERF_WRITE_PAGES").is_some() {
        std::fs::write(place(), &page).unwrap();
    }
    let said = std::fs::read_to_string(place()).unwrap_or_default();
    let differs: Vec<_> = page.lines().filter(|line| !said.lines().any(|it| it == *line)).collect();
    assert!(said == page, "KERF_WRITE_PAGES=1 writes the page; it differs in {differs:#?}");
}
