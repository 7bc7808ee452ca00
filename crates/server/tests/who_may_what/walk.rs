//! A walk: anybody asks for anything, in any order. The machine moves only where the table lets it.

use super::rows::{Asks, Row};
use super::workshop::Workshop;
use super::{page, rows};
use serde_json::{Value, json};
use std::collections::BTreeMap;

/// Steps of a walk.
const STEPS: usize = 10_000;

/// After so many steps nothing comes any more of what was asked for before.
const OVER: usize = 300;

/// Lines that are typed in walks; an empty one is a move to anywhere.
const LINES: [&str; 9] = [
    "",
    "",
    "",
    "PAUSE\nMX,.1",
    "MSGBOX(\"On?\",YesNo)\nMX,.1",
    "INPUT how far &x\nMX,&x",
    "SO,1,1\nMX,.2",
    "SK\nMX,.1",
    "VS,3",
];

/// Answers to questions in walks.
const WORDS: [&str; 12] = [
    "jog 0,400,0,0,0,0 1",
    "nudge x 1",
    "Resume",
    "Quit",
    "OK",
    "Yes",
    "No",
    "Cancel",
    "0",
    "Continue",
    "move y 200",
    "pendant",
];

/// Numbers that come out the same each time (xorshift, Marsaglia 2003).
struct Chance(u64);

impl Chance {
    fn below(&mut self, most: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % most as u64) as usize
    }

    fn one<'a, T>(&mut self, of: &'a [T]) -> &'a T {
        &of[self.below(of.len())]
    }
}

/// The page of the book, read.
struct Table(BTreeMap<String, Vec<String>>);

impl Table {
    fn read() -> Self {
        let text = std::fs::read_to_string(page()).unwrap();
        let line = |line: &str| {
            let mut cells = line.strip_prefix("| ")?.strip_suffix(" |")?.split(" | ");
            Some((cells.next()?.to_owned(), cells.map(str::to_owned).collect()))
        };
        Self(text.lines().filter_map(line).collect())
    }

    /// Word of the table for a caller in a state; nothing for a name that has no line.
    fn says(&self, name: &str, column: usize, state: char) -> Option<&str> {
        let cell = self.0.get(name)?.get(column)?;
        if !cell.contains(' ') {
            return Some(cell);
        }
        let words = cell.split(", ").filter_map(|part| part.split_once(' '));
        words.into_iter().find(|(_, states)| states.contains(state)).map(|(word, _)| word)
    }
}

/// State of the machine that can be seen.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Seen {
    at: [f64; 3],
    /// So many are on.
    outputs: usize,
}

/// Most distance, mm, between the tool and where it was seen last: its place is told exactly when what ran is over;
/// while a question is open it is a nap of the machine's thread old.
const NAP_MM: f64 = 12.0;

impl Seen {
    fn of(shown: &Value) -> Self {
        let place = &shown["motion"]["at"]["machine"];
        let outputs = shown["io"]["outputs"]
            .as_array()
            .map_or(0, |all| all.iter().filter(|lamp| lamp["on"] == true).count());
        Self { at: [0, 1, 2].map(|axis| place[axis].as_f64().unwrap()), outputs }
    }

    fn is_near(self, other: Self) -> bool {
        self.at.into_iter().zip(other.at).all(|(a, b)| (a - b).abs() < NAP_MM)
    }
}

/// Request that may move the machine: the step in which it was made, and the question that it answers.
#[derive(Debug)]
struct Licence {
    step: usize,
    question: Option<u64>,
}

struct Walk {
    workshop: Workshop,
    table: Table,
    acts: Vec<Row>,
    chance: Chance,
    licence: Option<Licence>,
    seen: Option<Seen>,
    /// State when nothing might move it any more.
    rest: Option<Seen>,
    /// Last requests, to be told where something is wrong.
    told: Vec<String>,
    moved: usize,
}

impl Walk {
    fn new(seed: u64) -> Self {
        let acts = rows::parts().into_iter().flat_map(|(_, rows)| rows);
        Self {
            workshop: Workshop::open(4.0),
            table: Table::read(),
            acts: acts.filter(|row| matches!(row.asks, Asks::Act(_))).collect(),
            chance: Chance(seed),
            licence: None,
            seen: None,
            rest: None,
            told: Vec::new(),
            moved: 0,
        }
    }

    /// Chooses the next request: its line in the table, and the act.
    fn next(&mut self, shown: &Value, step: usize) -> (String, Value) {
        let asked = &shown["asked"];
        let lease = shown["lease"]["number"].as_u64().unwrap_or_default();
        let lease = if self.chance.below(8) == 0 { lease.saturating_sub(1) } else { lease };
        let (name, mut act) = match self.chance.below(100) {
            0..35 if asked.is_object() => {
                let words = *self.chance.one(&WORDS);
                let act = json!({ "do": "answer", "question": asked["number"], "answer": words });
                (self.line_of_answer(shown, words), act)
            }
            0..35 => {
                let far = format!("M2,{},{}", self.chance.below(30), self.chance.below(20));
                let line = *self.chance.one(&LINES);
                let line = if line.is_empty() { &far } else { line };
                let sets = if line.starts_with("VS") { " with a V command" } else { "" };
                (
                    format!("act `command`{sets}"),
                    json!({ "do": "command", "line": line, "lease": 0 }),
                )
            }
            35..45 => ("act `arm`".into(), json!({ "do": "arm", "lease": 0 })),
            45..50 => {
                ("act `takeLease` with force".into(), json!({ "do": "takeLease", "force": true }))
            }
            _ => {
                let row = self.chance.one(&self.acts);
                let Asks::Act(act) = &row.asks else { unreachable!() };
                (row.name.clone(), act.clone())
            }
        };
        if act.get("lease").is_some() {
            act["lease"] = lease.into();
        }
        if act.get("seq").is_some() {
            act["seq"] = (step + 1).into();
        }
        (name, act)
    }

    /// The line of an answer: the table has questions of programs, and the one after a stop.
    fn line_of_answer(&self, shown: &Value, words: &str) -> String {
        let kind = shown["asked"]["kind"].as_str().unwrap_or_default();
        let to = match kind {
            "input" => {
                return format!(
                    "answer `{}` to INPUT",
                    if words == "Cancel" { words } else { "0" }
                );
            }
            "hold" => "after a stop",
            "spindle" => "to the spindle's question",
            "keypad" => "to the keypad",
            "msgbox" => "to MSGBOX",
            _ => "to PAUSE",
        };
        format!("answer `{words}` {to}")
    }

    fn step(&mut self, step: usize) {
        let shown = self.workshop.shown();
        let (name, act) = self.next(&shown, step);
        // Whoever drives does most.
        let driver = self.workshop.driver(&shown).filter(|_| self.chance.below(10) < 6);
        let who = driver.unwrap_or_else(|| self.chance.below(6));
        let (column, drives) = self.workshop.column(who, &shown);
        let armed = shown["machine"]["armed"] == true;
        let state = match letter(&shown) {
            // The question after a stop is one.
            'S' if act["do"] == "answer" => 'Q',
            's' if act["do"] == "answer" => 'q',
            state => state,
        };
        let says = self.table.says(&name, column, state).map(str::to_owned);
        let refused = self.workshop.act(who, &act);
        self.told.push(format!("{step}: {act} by {column}, {}: {refused:?}", letter(&shown)));
        let now = self.workshop.shown();
        let same = letter(&now) == letter(&shown) && now["lease"] == shown["lease"];
        if let (Some(says), true) = (&says, same) {
            assert!(says == "+" || refused.is_some(), "the table says {says}: {}", self.trail());
        }
        let free = act["do"] == "answer" && says.as_deref() == Some("+");
        if refused.is_none() && (drives && armed && may_move(&name) || free) {
            let question = now["asked"]["number"].as_u64();
            self.licence = Some(Licence { step, question });
        }
        self.look(&now, step);
    }

    /// Looks whether the machine has moved, and whether it may.
    fn look(&mut self, now: &Value, step: usize) {
        let seen = Seen::of(now);
        self.moved += usize::from(self.seen.replace(seen).is_some_and(|it| it.at != seen.at));
        match (&self.licence, self.rest) {
            (Some(_), _) => self.rest = None,
            (None, None) => self.rest = Some(seen),
            (None, Some(rest)) => {
                let may = seen.is_near(rest) && seen.outputs <= rest.outputs;
                assert!(may, "{rest:?} {seen:?}: {}", self.trail());
                self.rest = Some(Seen { outputs: seen.outputs, ..rest });
            }
        }
        let goes_on = ["running", "jogging", "held"];
        let moves = goes_on.contains(&now["machine"]["state"].as_str().unwrap());
        let over = |licence: &mut Licence| {
            let other = now["asked"]["number"].as_u64() != licence.question;
            !moves && (licence.question.is_none() || other || step > licence.step + OVER)
        };
        if let Some(licence) = self.licence.take_if(over) {
            self.told.push(format!("{step}: over: {licence:?} {}, rests at {seen:?}", letter(now)));
        }
    }

    fn trail(&self) -> String {
        let last = self.told.len().saturating_sub(80);
        format!("{:#?}", &self.told[last..])
    }
}

/// Tells whether something that whoever drives asks for may move the machine.
fn may_move(name: &str) -> bool {
    let acts = [
        "run", "takeUp", "resume", "command", "jogStart", "jogRenew", "lift", "nudge", "key",
        "input", "go", "bit", "step",
    ];
    name.starts_with("answer ") || acts.iter().any(|act| name.starts_with(&format!("act `{act}`")))
}

/// The state as the table has it.
fn letter(shown: &Value) -> char {
    let armed = shown["machine"]["armed"] == true;
    match shown["machine"]["state"].as_str().unwrap_or_default() {
        "asking" if armed => 'Q',
        "asking" => 'q',
        "stopped" if armed => 'S',
        "stopped" => 's',
        "idle" | "alarm" if armed => 'A',
        "idle" | "alarm" => 'D',
        _ if armed => 'R',
        _ => '?',
    }
}

#[test]
fn in_a_long_walk_nothing_moves_that_the_table_does_not_let() {
    let mut walk = Walk::new(0x5eed_0021);
    let mut step = 0;
    // On a busy computer more steps are made while the machine moves one way.
    while step < STEPS || walk.moved < STEPS / 100 {
        assert!(step < 10 * STEPS, "it moved in {} steps only", walk.moved);
        walk.step(step);
        step += 1;
    }
}
