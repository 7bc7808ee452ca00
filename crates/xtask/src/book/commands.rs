//! The reference of commands, made from the command table.

use crate::Tree;
use anyhow::Result;
use kerf_sbp::table::{self, Bound, CommandSpec, Default, Group, Kind, ParamSpec, Unit};
use std::fmt::Write as _;

const INTRODUCTION: &str = "\
<!-- Written by `make book` from the command table of crates/sbp. Do not edit. -->

# Commands

Each command with its parameters in the order of the part file. A parameter without a default that is left
blank keeps what was, or the axis stays where it is. Lengths, locations and speeds are in the unit set, inches
or millimetres; speeds are a second.
";

const GROUPS: &[(Group, &str)] = &[
    (Group::Move, "Moves"),
    (Group::Jog, "Jogs"),
    (Group::Cut, "Cuts"),
    (Group::File, "Files"),
    (Group::Settings, "Settings"),
    (Group::Values, "Values"),
    (Group::Zero, "Zero"),
    (Group::Record, "Record"),
    (Group::Tools, "Tools"),
    (Group::Utilities, "Utilities"),
    (Group::Help, "Help"),
];

/// The page of all commands.
///
/// # Errors
/// Never; pages share one form.
pub fn commands(_: &Tree) -> Result<String> {
    let mut page = INTRODUCTION.to_owned();
    for (group, title) in GROUPS {
        let mut specs: Vec<_> = table::commands().filter(|spec| spec.group == *group).collect();
        specs.sort_by_key(|spec| spec.letters);
        let entries: Vec<String> = specs.into_iter().map(entry).collect();
        if !entries.is_empty() {
            let _ = write!(page, "\n## {title}\n{}", entries.concat());
        }
    }
    Ok(page)
}

fn entry(spec: &CommandSpec) -> String {
    let mut text = format!("\n### {}: {}\n\n{}\n", spec.letters, spec.name, spec.doc);
    if !spec.params.is_empty() {
        text.push_str("\n| # | parameter | value | default | |\n|--:|---|---|---|---|\n");
    }
    for (number, param) in spec.params.iter().enumerate() {
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} | {} |",
            number + 1,
            param.name,
            value(param),
            default(param),
            cell(param.doc),
        );
    }
    text
}

/// Describes what may be written, with its bounds.
fn value(param: &ParamSpec) -> String {
    let kind = match param.kind {
        Kind::Number(unit) => unit_word(unit).to_owned(),
        Kind::NumberOrOff(unit) => format!("{} or OFF", unit_word(unit)),
        Kind::Whole => "whole number".to_owned(),
        Kind::OneOf(numbers) => join(numbers.iter().map(i32::to_string)),
        Kind::Word(words) => join(words.iter().map(|word| (*word).to_owned())),
        Kind::Text => "text".to_owned(),
        Kind::File => "file or folder".to_owned(),
        Kind::AxisLetter => "axis letter".to_owned(),
        Kind::Obsolete => "ignored".to_owned(),
    };
    cell(&format!("{kind}{}", bound(param.bound)))
}

fn join(words: impl Iterator<Item = String>) -> String {
    words.collect::<Vec<_>>().join(", ")
}

fn bound(bound: Bound) -> String {
    match bound {
        Bound::Any => String::new(),
        Bound::Positive => ", above 0".to_owned(),
        Bound::NotNegative => ", 0 or more".to_owned(),
        Bound::Range(from, to) => format!(", {from} to {to}"),
        Bound::AtLeast(least) => format!(", at least {least}"),
        Bound::Below(from, to) => format!(", {from} to less than {to}"),
        Bound::NotZero => ", not 0".to_owned(),
    }
}

const fn unit_word(unit: Unit) -> &'static str {
    match unit {
        Unit::None => "number",
        Unit::Length => "length",
        Unit::Speed | Unit::AxisSpeed(_) => "speed",
        Unit::Axis(_) => "location",
        Unit::StepsPer(_) => "steps a unit",
        Unit::Degrees => "degrees",
        Unit::Seconds => "seconds",
        Unit::Percent => "percent",
        Unit::Twips => "1/1440 inch",
    }
}

fn default(param: &ParamSpec) -> String {
    match param.default {
        Default::Required | Default::Demanded => "*required*".to_owned(),
        Default::Keep => {
            param.factory().map_or_else(String::new, |value| format!("kept; {value} at first"))
        }
        Default::Number(number) => number.to_string(),
        Default::Word(word) => word.to_owned(),
        Default::Special => "see there".to_owned(),
    }
}

/// Text that stays within a cell of a table.
fn cell(text: &str) -> String {
    text.replace('|', "\\|")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_command_is_on_the_page() -> Result<()> {
        let page = commands(&Tree::default())?;
        for spec in table::commands() {
            let heading = format!("\n### {}: {}\n", spec.letters, spec.name);
            assert!(page.contains(&heading), "{heading}");
        }
        Ok(())
    }

    #[test]
    fn a_parameter_tells_its_bounds_and_default() {
        const PARAMS: &[ParamSpec] = &[
            ParamSpec::number("Overlap", Kind::Number(Unit::Percent), 10.0)
                .within(Bound::Range(0.0, 99.0))
                .about("Of the cutter."),
            ParamSpec::word("Side", &["O", "I", "T"], "T"),
        ];
        assert_eq!(value(&PARAMS[0]), "percent, 0 to 99");
        assert_eq!(default(&PARAMS[0]), "10");
        assert_eq!(value(&PARAMS[1]), "O, I, T");
        assert_eq!(default(&PARAMS[1]), "T");
    }
}
