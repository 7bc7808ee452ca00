//! The lines of `files.txt`: what a file needs, and what has to come of it.

use kerf_model::Change;
use kerf_sbp::{Dialect, Value};

/// The list.
const FILES: &str = include_str!("files.txt");

/// Way in which one file is run.
#[derive(Clone, Debug)]
pub struct Row {
    /// Name in the corpus.
    pub file: &'static str,
    /// `ok`, `ended`, `failed CODE LINE`, `limit CODE`.
    pub expected: String,
    /// Answers to questions, one a line.
    pub answers: String,
    /// Changes of inputs.
    pub inputs: Vec<Change>,
    /// Variables set before.
    pub set: Vec<(String, Value)>,
    /// Programs run before it on the same machine, one a line: settings, variables.
    pub before: Vec<String>,
    /// Axes of the machine.
    pub axes: u8,
    /// Bound on lines.
    pub max_lines: u64,
    /// On the machine, not as a preview.
    pub moves: bool,
    /// The dialect it is written in.
    pub dialect: Dialect,
    /// A text that the operator has to see.
    pub shows: &'static str,
}

/// All lines.
pub fn rows() -> Vec<Row> {
    let lines = FILES.lines().filter(|line| !line.is_empty() && !line.starts_with('#'));
    lines.map(Row::read).collect()
}

impl Row {
    fn read(line: &'static str) -> Self {
        let mut columns = line.split('|').map(str::trim);
        let mut row = Self {
            file: columns.next().unwrap_or_default(),
            expected: columns.next().expect("how it ends").to_owned(),
            answers: String::new(),
            inputs: Vec::new(),
            set: Vec::new(),
            before: Vec::new(),
            axes: 3,
            max_lines: 200_000,
            moves: false,
            dialect: Dialect::Sb3,
            shows: "",
        };
        for option in columns.filter(|option| !option.is_empty()) {
            let (key, value) = option.split_once(' ').unwrap_or((option, ""));
            row.option(key, value.trim());
        }
        row
    }

    fn option(&mut self, key: &str, value: &'static str) {
        match key {
            "answers" => {
                self.answers = value.split('⏎').map(|a| format!("{}\n", a.trim())).collect()
            }
            "input" => self.inputs.extend(value.split_whitespace().map(change)),
            "set" => self.set.extend(value.split_whitespace().map(variable)),
            "before" => self.before.extend(value.split('⏎').map(|line| line.trim().to_owned())),
            "axes" => self.axes = value.parse().unwrap(),
            "lines" => self.max_lines = value.parse().unwrap(),
            "moves" => self.moves = true,
            "dialect" => self.dialect = dialect(value),
            "shows" => self.shows = value,
            // Why the file ends as it does, for readers.
            "note" => {}
            _ => panic!("{}: what is {key}?", self.file),
        }
    }
}

fn dialect(word: &str) -> Dialect {
    match word {
        "fabmo" => Dialect::Fabmo,
        _ => panic!("what is the dialect {word}?"),
    }
}

/// `N@T=0|1`, as the command line has it.
fn change(text: &str) -> Change {
    let (input, rest) = text.split_once('@').expect("N@T=S");
    let (at_s, on) = rest.split_once('=').expect("N@T=S");
    Change { input: input.parse().unwrap(), at_s: at_s.parse().unwrap(), on: on == "1" }
}

fn variable(text: &str) -> (String, Value) {
    let (name, value) = text.split_once('=').expect("NAME=VALUE");
    let value = value.parse().map_or_else(|_| Value::text(value), Value::Number);
    (name.to_owned(), value)
}
