//! The types as TypeScript.

use crate::preview::{PreviewInfo, Timing};
use crate::{
    Checked, CommandEntry, Completion, ControllerLines, FileAbout, FileInfo, FileVersion, Hint,
    Hover, JobView, Lamp, OperationEntry, PortBit, Request, RunRecord, SettingArea, SettingChange,
    ShapeList, TextDraft, ToDo, ToPage, ToolPaths, Values,
};
use std::collections::BTreeMap;
use ts_rs::{Config, TS, TypeVisitor};

/// Declarations by name.
struct Declared {
    config: Config,
    texts: BTreeMap<String, String>,
}

impl TypeVisitor for Declared {
    fn visit<T: TS + 'static + ?Sized>(&mut self) {
        // Types of the standard library are written where they are used.
        if T::output_path().is_none() {
            return T::visit_dependencies(self);
        }
        let name = T::ident(&self.config);
        if self.texts.contains_key(&name) {
            return;
        }
        let docs = T::docs().unwrap_or_default();
        let text = match Variants::read(&name, &T::decl(&self.config)) {
            Some(variants) => variants.text(&docs),
            None => format!("{docs}export {}\n", T::decl(&self.config)),
        };
        self.texts.insert(name, text);
        T::visit_dependencies(self);
    }
}

/// A type of several shapes, told apart by a tag: each shape has a name of its own.
struct Variants {
    name: String,
    /// Name and declaration of each.
    shapes: Vec<(String, String)>,
}

impl Variants {
    /// Reads `type Name = { "tag": "one", … } | { "tag": "two" } & More;`; nothing where it is another sort of type.
    fn read(name: &str, declaration: &str) -> Option<Self> {
        let (_, union) = declaration.split_once(" = ")?;
        let shapes = apart(union.trim_end().trim_end_matches(';'));
        let named = |shape: &str| {
            let tag = shape.strip_prefix("{ \"")?.split('"').nth(2)?;
            let (first, rest) = tag.split_at_checked(1)?;
            Some((format!("{name}{}{rest}", first.to_uppercase()), shape.to_owned()))
        };
        let shapes: Vec<_> = shapes.into_iter().map(named).collect::<Option<_>>()?;
        (shapes.len() > 1).then(|| Self { name: name.to_owned(), shapes })
    }

    fn text(&self, docs: &str) -> String {
        let one = |(name, shape): &(String, String)| format!("export type {name} = {shape};\n\n");
        let all: String = self.shapes.iter().map(one).collect();
        let names = self.shapes.iter().map(|(name, _)| format!("\n  | {name}"));
        format!("{all}{docs}export type {} ={};\n", self.name, names.collect::<String>())
    }
}

/// The members of a union.
fn apart(union: &str) -> Vec<&str> {
    let (mut depth, mut from, mut members) = (0, 0, Vec::new());
    for (at, sign) in union.char_indices() {
        match sign {
            '{' | '<' | '[' => depth += 1,
            '}' | '>' | ']' => depth -= 1,
            '|' if depth == 0 => {
                members.push(union[from..at].trim());
                from = at + 1;
            }
            _ => {}
        }
    }
    members.push(union[from..].trim());
    members
}

/// The module with every type of this crate.
pub fn typescript() -> String {
    let mut declared = Declared { config: Config::new(), texts: BTreeMap::new() };
    declared.visit::<ToPage>();
    declared.visit::<Request>();
    declared.visit::<PreviewInfo>();
    declared.visit::<Timing>();
    declared.visit::<ShapeList>();
    declared.visit::<ToolPaths>();
    declared.visit::<JobView>();
    declared.visit::<OperationEntry>();
    declared.visit::<Checked>();
    declared.visit::<Completion>();
    declared.visit::<Hover>();
    declared.visit::<Hint>();
    declared.visit::<CommandEntry>();
    declared.visit::<FileInfo>();
    declared.visit::<FileAbout>();
    declared.visit::<FileVersion>();
    declared.visit::<RunRecord>();
    declared.visit::<ControllerLines>();
    declared.visit::<ToDo>();
    declared.visit::<TextDraft>();
    declared.visit::<SettingChange>();
    declared.visit::<Values>();
    declared.visit::<SettingArea>();
    declared.visit::<Lamp>();
    declared.visit::<PortBit>();
    let head = "// Made from crates/wire by `cargo xtask wire`; changes are lost.\n";
    let texts: Vec<String> = declared.texts.into_values().collect();
    format!("{head}\n{QUANTITIES}\n{}", on_lines(&texts.join("\n")))
}

/// The types of numbers with a unit, which the page defines: it takes no length for a speed or a plain number.
const QUANTITIES: &str = "import type {
  AxisGoal, AxisPlace, AxisSpeeds, AxisValue, Degrees, Mm, MmPerMin, MmPerS, Seconds, UnitSize, UnixSeconds,
} from \"../units/quantity\";
";

/// Each comment on a line of its own instead of three or more.
fn on_lines(text: &str) -> String {
    let (mut out, mut comment) = (String::new(), None::<Vec<&str>>);
    for line in text.lines().map(str::trim_end) {
        match (&mut comment, line.trim_start()) {
            (None, "/**") => comment = Some(Vec::new()),
            (None, _) => out += &format!("{line}\n"),
            (Some(words), "*/") => {
                out += &format!("/** {} */\n", words.join(" "));
                comment = None;
            }
            (Some(words), said) => words.push(said.trim_start_matches('*').trim()),
        }
    }
    out
}

#[cfg(test)]
#[allow(non_snake_case)] // rows and their variants
mod tests {
    use super::*;

    #[test]
    fn every_type_that_is_used_is_declared_once() {
        let text = typescript();
        for name in
            ["Snapshot", "Change", "Request", "Act", "Reply", "Why", "Motion", "Op", "Finding"]
        {
            assert_eq!(text.matches(&format!("export type {name} =")).count(), 1, "{name}");
        }
        assert!(!text.contains("bigint"));
    }

    #[test]
    fn numbers_whose_names_tell_a_unit_have_its_type() {
        let text = typescript();
        let units =
            [("MmS", "MmPerS"), ("MmMin", "MmPerMin"), ("Mm", "Mm"), ("seconds", "Seconds")];
        for line in text.lines() {
            let (name, kind) = line.split_once(": ").unwrap_or_default();
            let unit = units.iter().find(|(end, _)| name.trim_end_matches('?').ends_with(end));
            let Some((_, quantity)) = unit.filter(|_| !kind.starts_with("boolean")) else {
                continue;
            };
            assert!(kind.contains(quantity) || kind.contains("AxisSpeeds"), "{line}");
        }
        let plain: Vec<&str> =
            text.lines().filter(|line| line.contains("[number, number, ")).collect();
        let named = |line: &&str| {
            ["direction", "proportion", "outputs"].iter().any(|name| line.starts_with(name))
        };
        assert_eq!(
            plain.iter().filter(|line| !named(line)).collect::<Vec<_>>(),
            Vec::<&&str>::new()
        );
    }

    #[test]
    fn pro_speeds_units__names_of_speeds_end_in_their_unit() {
        let (text, mut speeds) = (typescript(), Vec::new());
        let (mut told, mut of_speeds) = ("", false);
        for line in text.lines() {
            if line.starts_with("export type") {
                of_speeds = line.starts_with("export type Speeds ");
            }
            let (name, kind) = line.split_once(": ").unwrap_or_default();
            let a_speed = told.to_lowercase().contains("speed") || of_speeds;
            let a_number = ["number", "[number", "MmPer", "AxisSpeeds"];
            if a_speed && a_number.iter().any(|begin| kind.starts_with(begin)) {
                speeds.push(name.trim_end_matches('?'));
            }
            told = if line.starts_with("/**") { line } else { "" };
        }
        let units = ["MmS", "MmMin", "rpm", "Percent", "Share"];
        let bare = speeds.iter().filter(|name| !units.iter().any(|unit| name.ends_with(unit)));
        assert_eq!(bare.collect::<Vec<_>>(), Vec::<&&str>::new());
        for known in ["speedMmS", "cutMmS", "plungeMmS", "speedMmMin", "feedPercent", "rpm"] {
            assert!(speeds.contains(&known), "{known} is not among {speeds:?}");
        }
    }
}
