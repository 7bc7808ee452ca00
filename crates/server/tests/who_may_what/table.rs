//! The table as a page, and what holds of every line of it.

use super::rows::{Asks, Row};
use super::workshop::{Caller, Doing, Workshop};
use std::fmt::Write;

/// A line: what each caller is told in each state.
pub struct Line {
    row: Row,
    /// By caller and state.
    told: Vec<Vec<(char, String)>>,
}

/// The states in which something is asked for.
fn states(row: &Row) -> Vec<(Doing, char)> {
    let open = |doing| matches!(doing, Doing::Asking | Doing::AskingDisarmed);
    match row.asks {
        Asks::Act(_) | Asks::Value { .. } | Asks::Page(_) | Asks::Route(_) => Doing::ALL.to_vec(),
        // Its question is open.
        Asks::Answer { .. } => Doing::ALL.into_iter().filter(|(doing, _)| open(*doing)).collect(),
    }
}

impl Line {
    pub fn tried(workshop: &mut Workshop, row: &Row) -> Self {
        let mut told = vec![Vec::new(); Caller::ALL.len()];
        // Callers one after the other in each state: most leave it as it is. A change of driver takes longest: whoever
        // makes one comes last, and first in the next state.
        let mut callers: Vec<usize> = (0..Caller::ALL.len()).collect();
        callers.sort_by_key(|at| Caller::ALL[*at].0 == Caller::SetterDriving);
        for (doing, letter) in states(row) {
            for at in &callers {
                told[*at].push((letter, workshop.told(row, Caller::ALL[*at].0, doing)));
            }
            callers.reverse();
        }
        Self { row: row.clone(), told }
    }

    fn text(&self) -> String {
        let cells: Vec<String> = self.told.iter().map(|told| cell(told)).collect();
        format!("| {} | {} |", self.row.name, cells.join(" | "))
    }
}

/// Cell of the table: the one word told in every state, or each word with its states.
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
        words => words
            .iter()
            .map(|(word, in_states)| format!("{word} {in_states}"))
            .collect::<Vec<_>>()
            .join(", "),
    }
}

const HEAD: &str = "# Who may what

Each cell of these tables was tried against a server: what somebody who asks for it is told. `+` may (it can still be
of no use at that moment); the other words are reasons. The page is made by a test (`KERF_WRITE_PAGES=1 cargo test -p
kerf-server --test all who_may_what::`), which fails where a server says something else.

- **role**: the role of the device does not allow it. **lease**: somebody else drives, or nobody. **disarmed**: the machine
  is not armed. **never**: nobody may, in this way. Numbers are those of HTTP: 401 not paired, 403 a page of another site,
  421 not the name of this machine.
- Letters are states, where they differ: **D** disarmed, **A** armed and idle, **R** running, **S** stopped in the middle, **Q** a question is
  open, **s** and **q** the same, and whoever drove has gone.
- Acts were tried over HTTP, where nobody holds a key: there a jog is never begun. What somebody holds on to has a part of its own.
- Of a route and a value only who asks matters, unless a command is passed in by `uCommand`, or a job is started: they were tried in all states.
- Wishes of the hand console and the other kinds of questions have [a page of their own](who-may-what-by-hand.md).

In preview mode a part file and typed lines are only drawn: they take no armed machine, and neither do the questions of
what began so; SM ends it. The tables are of the other modes.

What lets the machine move, go on, or switch something dangerous takes the turn at driving and an armed machine, whatever way it
comes, and does not happen where a stop came since it was asked for. [Serving Kerf](serve.md) tells how one drives, arms and stops.
";

/// The whole page.
pub fn page(parts: &[(&str, Vec<Line>)]) -> String {
    let mut page = HEAD.to_owned();
    for (title, lines) in parts {
        let callers: Vec<_> = Caller::ALL.into_iter().map(|(_, name)| name).collect();
        write!(page, "\n## {title}\n\n| | {} |\n", callers.join(" | ")).unwrap();
        page += &format!("|{}\n", "---|".repeat(callers.len() + 1));
        lines.iter().for_each(|line| page += &(line.text() + "\n"));
    }
    page
}

/// Acts that anybody paired may do, in every state.
const STOPS: [&str; 7] = [
    "page: `jogStop`",
    "act `ping`",
    "act `stop`",
    "act `hold`",
    "act `disarm`",
    "act `jogStop`",
    "act `key` P (Stop)",
];

/// Requests that move the machine, or make it go on.
const MOVES: [&str; 21] = [
    "act `run`",
    "act `takeUp`",
    "act `resume`",
    "act `command`",
    "act `jogStart`",
    "act `jogRenew`",
    "act `nudge`",
    "act `lift`",
    "page: `jogStart`",
    "page: `jogRenew`",
    "page: `nudge`",
    "page: `lift`",
    "POST `/api/job/start`",
    "answer `Yes` to MSGBOX",
    "answer `OK` to PAUSE",
    "answer `OK` to the spindle's question",
    "answer `OK` to the keypad",
    "answer `jog 0,400,0,0,0,0 1` to the keypad",
    "answer `Resume` after a stop",
    "answer `nudge x 1` after a stop",
    "value `uCommand` = MX,0",
];

/// Whatever the page says: this holds.
pub fn check(parts: &[(&str, Vec<Line>)]) {
    let lines = || parts.iter().flat_map(|(_, lines)| lines);
    for line in lines() {
        let name = line.row.name.as_str();
        for ((caller, _), told) in Caller::ALL.into_iter().zip(&line.told) {
            for (state, word) in told {
                let cell = format!("{name}, {caller:?}, {state}: {word}");
                let may = word == "+";
                assert!(caller.is_let_in() || !may || name.contains("/api/pair`"), "{cell}");
                assert!(!(STOPS.contains(&name) && caller.is_let_in()) || may, "{cell}");
                let armed = !['D', 's', 'q'].contains(state);
                assert!(!MOVES.contains(&name) || !may || caller.drives() && armed, "{cell}");
            }
        }
    }
    for name in MOVES.iter().chain(&STOPS) {
        assert!(lines().any(|line| line.row.name == *name), "{name} is no line");
    }
}
