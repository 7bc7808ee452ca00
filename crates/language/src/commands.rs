//! The command table as fill-in sheets show it.

use kerf_program::settings::{AxisUnit, LinearUnit};
use kerf_program::{Axis, Settings};
use kerf_sbp::table::{self, Bound, CommandSpec, Default, Group, Kind, ParamSpec, Unit};
use kerf_tools::{AddIn, Field, Tool};
use kerf_wire::{CommandEntry, Parameter, ParameterKind};

/// Bounds of lengths are in inches, as the manuals have them.
const INCH_MM: f64 = 25.4;

/// Every command, by its letters; units and present values are those of the settings.
pub fn commands(settings: &Settings) -> Vec<CommandEntry> {
    let mut entries: Vec<_> = table::commands().map(|spec| entry(spec, settings)).collect();
    entries.sort_by(|a, b| a.letters.cmp(&b.letters));
    entries
}

fn entry(spec: &CommandSpec, settings: &Settings) -> CommandEntry {
    CommandEntry {
        letters: spec.letters.into(),
        name: spec.name.into(),
        group: group(spec.group).into(),
        doc: spec.doc.into(),
        moves: matches!(spec.group, Group::Move | Group::Jog | Group::Cut),
        parameters: match tool_of(spec.letters) {
            Some(tool) => tool.fields.iter().map(|field| tool_field(field, settings)).collect(),
            None => spec.params.iter().map(|param| parameter(param, settings)).collect(),
        },
    }
}

/// The virtual tool of two letters: its sheet is its form.
fn tool_of(letters: &str) -> Option<&'static Tool> {
    letters.strip_prefix('T')?.chars().next().and_then(kerf_tools::tool)
}

/// A program that somebody added as a tool, as the menu shows it.
pub fn added(tool: &AddIn) -> CommandEntry {
    let values = Parameter {
        name: "Values".into(),
        kind: ParameterKind::Text,
        doc: "Handed to the program as they are.".into(),
        ..Parameter::default()
    };
    CommandEntry {
        letters: format!("T{}", tool.letter),
        name: tool.name.clone(),
        group: group(Group::Tools).into(),
        doc: format!("Starts {}", tool.command),
        moves: false,
        parameters: vec![values],
    }
}

fn tool_field(field: &Field, settings: &Settings) -> Parameter {
    let metric = settings.linear_unit == LinearUnit::Mm;
    let (kind, least, most) = match field.kind {
        kerf_tools::Kind::Length(least) => (ParameterKind::Number, Some(least), None),
        kerf_tools::Kind::Number(least, most) => (ParameterKind::Number, Some(least), Some(most)),
        kerf_tools::Kind::Whole(least, most) => {
            (ParameterKind::Whole, Some(f64::from(least)), Some(f64::from(most)))
        }
        kerf_tools::Kind::Choice(words) => {
            let words = words.iter().map(|word| (*word).to_owned()).collect();
            (ParameterKind::Choice { words }, None, None)
        }
        kerf_tools::Kind::Text => (ParameterKind::Text, None, None),
        kerf_tools::Kind::File => (ParameterKind::File, None, None),
    };
    let length = matches!(field.kind, kerf_tools::Kind::Length(_));
    let default = field.shown_default(metric);
    Parameter {
        name: field.label.into(),
        kind,
        unit: if length { settings.linear_unit.symbol().into() } else { String::new() },
        default: Some(default).filter(|default| !default.is_empty()),
        least: least.filter(|least| least.is_finite()),
        most,
        doc: field.doc.into(),
        ..Parameter::default()
    }
}

const fn group(group: Group) -> &'static str {
    match group {
        Group::Move => "move",
        Group::Jog => "jog",
        Group::Cut => "cut",
        Group::File => "file",
        Group::Settings => "settings",
        Group::Values => "values",
        Group::Zero => "zero",
        Group::Record => "record",
        Group::Tools => "tools",
        Group::Utilities => "utilities",
        Group::Help => "help",
    }
}

fn parameter(param: &ParamSpec, settings: &Settings) -> Parameter {
    let unit = param.kind.unit();
    let (least, most) = limits(param.bound);
    let user = |bound: f64| bound * user_scale(unit, settings);
    Parameter {
        name: param.name.into(),
        kind: kind(param.kind),
        unit: unit_words(unit, settings),
        required: matches!(param.default, Default::Required | Default::Demanded),
        default: match param.default {
            Default::Number(number) => Some(kerf_sbp::format_number(number)),
            Default::Word(word) => Some(word.into()),
            Default::Required | Default::Demanded | Default::Keep | Default::Special => None,
        },
        present: param.present(settings),
        bound: bound(param.bound, &user),
        least: least.map(&user),
        most: most.map(&user),
        doc: param.doc.into(),
    }
}

fn kind(kind: Kind) -> ParameterKind {
    let words = |words: &[&str]| words.iter().map(|word| (*word).to_owned()).collect();
    match kind {
        Kind::Number(_) => ParameterKind::Number,
        Kind::NumberOrOff(_) => ParameterKind::NumberOrOff,
        Kind::Whole => ParameterKind::Whole,
        Kind::OneOf(numbers) => {
            ParameterKind::Choice { words: numbers.iter().map(i32::to_string).collect() }
        }
        Kind::Word(list) => ParameterKind::Choice { words: words(list) },
        Kind::Text => ParameterKind::Text,
        Kind::File => ParameterKind::File,
        Kind::AxisLetter => ParameterKind::Axis,
        Kind::Obsolete => ParameterKind::Obsolete,
    }
}

/// Returns the unit that a person reads behind the number.
fn unit_words(unit: Unit, settings: &Settings) -> String {
    let linear = settings.linear_unit.symbol();
    match unit {
        Unit::None => String::new(),
        Unit::Length => linear.into(),
        Unit::Speed => format!("{linear}/s"),
        Unit::Axis(axis) => axis_unit(axis, settings).into(),
        Unit::AxisSpeed(axis) => format!("{}/s", axis_unit(axis, settings)),
        Unit::StepsPer(_) => "steps".into(),
        Unit::Degrees => "deg".into(),
        Unit::Seconds => "s".into(),
        Unit::Percent => "%".into(),
        Unit::Twips => "1/1440 in".into(),
    }
}

fn axis_unit(axis: Axis, settings: &Settings) -> &'static str {
    match settings.axis_unit(axis) {
        AxisUnit::Degrees => "deg",
        AxisUnit::Linear(unit) => unit.symbol(),
    }
}

/// User units in a unit of the bounds.
fn user_scale(unit: Unit, settings: &Settings) -> f64 {
    match unit {
        Unit::Length | Unit::Speed => INCH_MM / unit.scale(settings),
        _ => 1.0,
    }
}

/// Least and greatest value, where they are included.
const fn limits(bound: Bound) -> (Option<f64>, Option<f64>) {
    match bound {
        Bound::Any | Bound::NotZero | Bound::Positive => (None, None),
        Bound::NotNegative => (Some(0.0), None),
        Bound::AtLeast(least) | Bound::Below(least, _) => (Some(least), None),
        Bound::Range(least, most) => (Some(least), Some(most)),
    }
}

/// A bound in words.
fn bound(bound: Bound, user: &dyn Fn(f64) -> f64) -> String {
    let number = |n: f64| kerf_sbp::format_number(user(n));
    match bound {
        Bound::Any => String::new(),
        Bound::Positive => "above 0".into(),
        Bound::NotNegative => "0 or more".into(),
        Bound::Range(least, most) => format!("{} to {}", number(least), number(most)),
        Bound::AtLeast(least) => format!("at least {}", number(least)),
        Bound::Below(least, most) => format!("{} to less than {}", number(least), number(most)),
        Bound::NotZero => "not 0".into(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(letters: &str, settings: &Settings) -> Option<CommandEntry> {
        commands(settings).into_iter().find(|entry| entry.letters == letters)
    }

    #[test]
    fn every_command_of_the_table_has_its_entry() {
        let settings = Settings::default();
        assert_eq!(commands(&settings).len(), table::commands().count());
        let cc = of("CC", &settings);
        let parameters = cc.map(|entry| entry.parameters).unwrap_or_default();
        assert_eq!(parameters.len(), 12);
        assert_eq!(parameters.iter().filter(|p| p.required).count(), 1);
    }

    #[test]
    fn the_sheet_of_a_tool_is_its_form() {
        let mut settings = Settings::default();
        settings.use_linear_unit(LinearUnit::Mm);
        let td = of("TD", &settings).map(|entry| entry.parameters).unwrap_or_default();
        let bit = td.iter().find(|p| p.name == "Bit diameter");
        assert!(bit.is_some_and(|p| p.unit == "mm" && p.default.as_deref() == Some("6.35")));
        let zero = td.iter().find(|p| p.name == "Z zero").map(|p| p.kind.clone());
        let words = vec!["surface".to_owned(), "table".to_owned()];
        assert_eq!(zero, Some(ParameterKind::Choice { words }));
    }

    #[test]
    fn settings_that_hold_are_shown_in_the_unit_set() {
        let mut settings = Settings::default();
        let first = |settings: &Settings| of("MS", settings)?.parameters.first().cloned();
        let inches = first(&settings);
        assert!(inches.as_ref().is_some_and(|p| p.unit == "in/s" && p.present.is_some()));
        settings.use_linear_unit(LinearUnit::Mm);
        let millimetres = first(&settings);
        assert!(millimetres.as_ref().is_some_and(|p| p.unit == "mm/s"));
        let units = |letters| {
            let all = of(letters, &settings).map(|entry| entry.parameters).unwrap_or_default();
            all.into_iter().map(|p| p.unit).collect::<Vec<_>>()
        };
        assert_eq!(
            units("MS"),
            ["mm/s", "mm/s", "mm/s", "deg/s"],
            "a rotary axis turns in degrees"
        );
        assert_eq!(units("VR")[..4], ["mm/s", "mm/s", "mm/s", "deg/s"]);
        assert_ne!(inches.and_then(|p| p.present), millimetres.and_then(|p| p.present));
    }
}
