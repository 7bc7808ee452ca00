//! The meaning of the word at a place.

use crate::word::{self, Word};
use kerf_sbp::table::CommandSpec;
use kerf_sbp::{Function, system_variables, table};
use kerf_wire::Hover;

/// Explains the word at a line and column, both counted from 1.
pub fn hover(text: &str, line: u32, column: u32) -> Option<Hover> {
    let line = word::line(text, line);
    let found = word::at(line, column);
    let text = meaning(&found, line)?;
    Some(Hover { text, from: found.from, to: found.to })
}

fn meaning(word: &Word<'_>, line: &str) -> Option<String> {
    if word.text.is_empty() {
        return None;
    }
    if word.text.starts_with('%') {
        return system(line, word);
    }
    let begins = word.before.trim().is_empty() || ends_with_then(word.before);
    let command = table::find(word.text).filter(|_| begins).map(command);
    command.or_else(|| Function::from_name(word.text).map(function))
}

fn ends_with_then(before: &str) -> bool {
    before.trim_end().to_uppercase().ends_with("THEN")
}

fn command(spec: &CommandSpec) -> String {
    let names = spec.params.iter().map(|param| format!(", {}", param.name));
    format!(
        "{}: {}\n{}{}\n{}",
        spec.letters,
        spec.name,
        spec.letters,
        names.collect::<String>(),
        spec.doc
    )
}

fn function(function: Function) -> String {
    format!("{}: {}", function.name(), function.doc())
}

/// The variable whose number stands in the brackets.
fn system(line: &str, word: &Word<'_>) -> Option<String> {
    let behind = line.get(word.before.len() + word.text.len()..)?;
    let number: String =
        behind.trim_start_matches(['(', ' ']).chars().take_while(char::is_ascii_digit).collect();
    let number: u8 = number.parse().ok()?;
    let variable = system_variables().find(|variable| variable.number == number)?;
    Some(format!("%({number}): {} {}", variable.name, variable.unit).trim_end().to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn commands_functions_and_system_variables_are_explained() {
        let starts = |text: &str, column: u32, with: &str| {
            let told = hover(text, 1, column).map(|hover| hover.text).unwrap_or_default();
            assert!(told.starts_with(with), "{text}: {told}");
        };
        starts("MX,1", 1, "MX: ");
        starts("IF &a THEN JH", 13, "JH: ");
        starts("MX,SQR(2)", 5, "SQR: ");
        starts("MX,%(1)", 4, "%(1): ");
        starts("M2,MX", 4, "");
        assert!(hover("M2,MX", 1, 4).is_none());
        assert!(hover("' words", 1, 30).is_none());
    }
}
