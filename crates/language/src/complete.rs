//! Words that could stand at a place.

use crate::word;
use kerf_sbp::{Function, statement_words, system_variables, table};
use kerf_wire::Completion;
use std::collections::BTreeSet;

/// The words that begin as what stands before a column of a line, both counted from 1.
pub fn complete(text: &str, line: u32, column: u32) -> Vec<Completion> {
    let line = word::line(text, line);
    let found = word::at(line, column);
    let begun = found.text.to_uppercase();
    let offered = match begun.chars().next() {
        Some('&' | '$') => variables(text, found.text),
        Some('%') => system(),
        _ if begins(found.before) => [commands(), statements(), labels(text, ":")].concat(),
        _ if jumps(found.before) => labels(text, ""),
        _ => functions(),
    };
    offered.into_iter().filter(|word| word.label.to_uppercase().starts_with(&begun)).collect()
}

fn completion(label: impl Into<String>, kind: &str, detail: &str, doc: &str) -> Completion {
    Completion { label: label.into(), kind: kind.into(), detail: detail.into(), doc: doc.into() }
}

/// Returns `true` if a command or a statement can stand behind this.
fn begins(before: &str) -> bool {
    let before = before.trim_end().to_uppercase();
    before.is_empty() || before.ends_with("THEN")
}

/// Returns `true` if the name of a label stands behind this.
fn jumps(before: &str) -> bool {
    let before = before.trim_end().to_uppercase();
    before.ends_with("GOTO") || before.ends_with("GOSUB")
}

fn commands() -> Vec<Completion> {
    let entry = |spec: &'static table::CommandSpec| {
        let names: Vec<_> = spec.params.iter().map(|param| param.name).collect();
        let doc = format!("{}\n\n{}", names.join(", "), spec.doc);
        completion(spec.letters, "command", spec.name, doc.trim())
    };
    table::commands().map(entry).collect()
}

fn statements() -> Vec<Completion> {
    statement_words().map(|word| completion(word, "keyword", "statement", "")).collect()
}

fn functions() -> Vec<Completion> {
    Function::ALL.iter().map(|f| completion(f.name(), "function", "function", f.doc())).collect()
}

fn system() -> Vec<Completion> {
    system_variables()
        .map(|v| completion(format!("%({})", v.number), "variable", v.name, v.unit))
        .collect()
}

/// Variables that the text names, besides the one that is being written.
fn variables(text: &str, written: &str) -> Vec<Completion> {
    let signs = |c: char| !(c.is_alphanumeric() || matches!(c, '_' | '&' | '$'));
    let names: BTreeSet<&str> = text
        .split(signs)
        .filter(|word| word.starts_with(['&', '$']) && word.len() > 1 && *word != written)
        .collect();
    names.into_iter().map(|name| completion(name, "variable", "variable", "")).collect()
}

fn labels(text: &str, ending: &str) -> Vec<Completion> {
    let program = kerf_sbp::read("".into(), text.as_bytes());
    let there = program.label_names.iter().filter(|label| label.line.is_some());
    let names: BTreeSet<&str> = there.map(|label| &*label.name).collect();
    names
        .into_iter()
        .map(|name| completion(format!("{name}{ending}"), "label", "label", ""))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels_at(text: &str, line: u32, column: u32) -> Vec<String> {
        complete(text, line, column).into_iter().map(|word| word.label).collect()
    }

    #[test]
    fn what_is_offered_depends_on_the_place() {
        assert_eq!(labels_at("MX", 1, 3), ["MX"]);
        assert_eq!(labels_at("IF &a=1 THEN GOS", 1, 17), ["GOSUB"]);
        assert_eq!(labels_at("&size=1\nMX,&s", 2, 6), ["&size"]);
        assert_eq!(labels_at("MX,SQ", 1, 6), ["SQR", "SQRT"]);
        assert_eq!(labels_at("AGAIN:\nGOTO AG", 2, 8), ["AGAIN"]);
        assert!(labels_at("MX,%", 1, 5).iter().any(|word| word == "%(1)"));
        assert!(labels_at("", 1, 1).len() > 100);
    }
}
