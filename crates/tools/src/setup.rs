//! TS, Setup: records how the machine is equipped, for the custom cuts that find its zeros.

use crate::field::{Field, Kind, choice, length, text};
use crate::lines::number;
use crate::{Entries, FileFolder, Mistake, OutputFile, Tool, ToolOutput};

/// A field for an input.
const fn input(key: &'static str, label: &'static str, default: &'static str) -> Field {
    Field { key, label, kind: Kind::Whole(1, 12), default, doc: "" }
}

const FIELDS: &[Field] = &[
    text("machine", "Machine").about("What the machine is called."),
    text("serial", "Serial number"),
    choice("units", "Units", &["as set", "in", "mm"]),
    choice("plate", "Z zero plate", &["yes", "no"]),
    input("plate_input", "Plate, input", "1"),
    length("plate_thickness", "Plate, thickness", "0.125", 0.0),
    choice("switches", "Proximity switches of X and Y", &["yes", "no"]),
    input("x_input", "X switch, input", "2"),
    input("y_input", "Y switch, input", "3"),
    length("x_offset", "X switch to zero", "0.5", 0.0),
    length("y_offset", "Y switch to zero", "0.5", 0.0),
    length("reach", "How far X and Y look", "100", 0.001),
    length("speed", "How fast X and Y look, a second", "1", 0.001),
];

pub const TOOL: Tool = Tool {
    letter: 'S',
    name: "Setup",
    doc: "Records tools for zeroing: plate, proximity switches, their inputs and offsets.",
    fields: FIELDS,
    make,
};

fn make(entries: &Entries<'_>) -> Result<ToolOutput, Vec<Mistake>> {
    let used = [("plate", "plate_input"), ("switches", "x_input"), ("switches", "y_input")];
    let inputs: Vec<&str> =
        used.iter().filter(|(fitted, _)| entries.is(fitted, "yes")).map(|(_, key)| *key).collect();
    for (n, key) in inputs.iter().enumerate() {
        if let Some(other) = inputs[..n].iter().find(|o| entries.text(o) == entries.text(key)) {
            let text = format!("input {} is that of {other}", entries.text(key));
            return Err(vec![Mistake::new(key, text)]);
        }
    }
    let text = variables(entries).join("\n") + "\n";
    let file = OutputFile { place: FileFolder::Custom, name: "my_variables.sbc".into(), text };
    let mut notes = Vec::new();
    if entries.is("plate", "yes") {
        notes.push("C2 zeroes Z with the plate.".into());
    }
    if entries.is("switches", "yes") {
        notes.push("C3 zeroes X and Y with their switches.".into());
    }
    Ok(ToolOutput { files: vec![file], notes })
}

/// Lines of my_variables; those of what is not fitted say so.
fn variables(entries: &Entries<'_>) -> Vec<String> {
    let unit = if entries.metric() { 25.4 } else { 1.0 };
    // Lengths are in the unit of the form, and turned into the one that is set.
    let factor = |length: f64| format!("{} * &my_unit", number(length / unit));
    let has = |key: &str| u8::from(entries.is(key, "yes"));
    let mut lines = vec!["'my_variables: written by the tool TS".to_owned()];
    for (label, key) in [("Machine", "machine"), ("Serial number", "serial")] {
        if !entries.text(key).is_empty() {
            lines.push(format!("'{label}: {}", entries.text(key)));
        }
    }
    let set = |name: &str, value: String| format!("&my_{name} := {value}");
    lines.extend([
        "&my_unit = 1".to_owned(),
        "IF %(25) = 1 THEN &my_unit = 25.4".to_owned(),
        set("has_plate", has("plate").to_string()),
        set("plate_input", entries.text("plate_input").into()),
        set("plate", factor(entries.number("plate_thickness"))),
        set("probe_reach", "2 * &my_unit".into()),
        set("probe_speed", "0.2 * &my_unit".into()),
        set("probe_lift", "0.5 * &my_unit".into()),
        set("has_switches", has("switches").to_string()),
        set("home_input_x", entries.text("x_input").into()),
        set("home_input_y", entries.text("y_input").into()),
        set("home_reach", factor(entries.number("reach"))),
        set("home_speed", factor(entries.number("speed"))),
        set("home_back_x", factor(entries.number("x_offset"))),
        set("home_back_y", factor(entries.number("y_offset"))),
        set("home_back", factor(entries.number("x_offset"))),
        set("warm_up", "60".into()),
        set("spin_up", "0".into()),
        set("tool_change_time", "0".into()),
    ]);
    lines
}

#[cfg(test)]
mod tests {
    use crate::testing::made;

    #[test]
    fn variables_of_the_machine_are_written_in_either_unit() {
        let text = made('S', "machine=Big one,plate_input=5,units=mm,plate_thickness=12.7");
        for line in ["'Machine: Big one", "&my_plate_input := 5", "&my_plate := 0.5 * &my_unit"] {
            assert!(text.lines().any(|l| l == line), "{line} in\n{text}");
        }
    }

    #[test]
    fn two_switches_need_two_inputs() {
        assert_eq!(made('S', "x_input=3"), "y_input: input 3 is that of x_input");
        assert!(made('S', "x_input=3,switches=no").contains("has_switches := 0"));
    }
}
