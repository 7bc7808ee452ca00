//! TI, the Indexer: lines that turn the B axis. The manual names the tool only; this is Kerf's reading.

use crate::field::{choice, file};
use crate::lines::number;
use crate::{Entries, Field, Kind, Mistake, Tool, ToolOutput};

const FIELDS: &[Field] = &[
    choice("how", "What it does", &["turn to", "turn by", "spin"]),
    choice("axis", "Axis", &["B", "A", "C"]),
    Field {
        key: "angle",
        label: "Angle",
        kind: Kind::Number(-36_000.0, 36_000.0),
        default: "90",
        doc: "To turn to or by, degrees.",
    },
    Field {
        key: "speed",
        label: "Speed",
        kind: Kind::Number(0.001, 3600.0),
        default: "30",
        doc: "Degrees a second.",
    },
    choice("direction", "Direction of a spin", &["clockwise", "counter-clockwise"]),
    Field {
        key: "seconds",
        label: "A spin ends after",
        kind: Kind::Number(0.0, 86_400.0),
        default: "0",
        doc: "Seconds; 0 goes on until MO, or MI with speed 0.",
    },
    file("indexer.sbp"),
];

pub const TOOL: Tool = Tool {
    letter: 'I',
    name: "Indexer",
    doc: "Turns the indexer to an angle, by an angle, or for as long as is wanted.",
    fields: FIELDS,
    make,
};

fn make(entries: &Entries<'_>) -> Result<ToolOutput, Vec<Mistake>> {
    let axis = entries.text("axis");
    let (angle, speed) = (number(entries.number("angle")), number(entries.number("speed")));
    let speeds = match axis {
        "A" => format!("MS,,,{speed}"),
        "B" => format!("MS,,,,{speed}"),
        _ => format!("MS,,,,,{speed}"),
    };
    let way = if entries.is("direction", "clockwise") { "1" } else { "-1" };
    let mut lines = vec!["'Indexer, made by the tool TI".to_owned()];
    match entries.text("how") {
        "turn to" => lines.extend([speeds, "SA".into(), format!("M{axis},{angle}")]),
        "turn by" => {
            lines.extend([speeds, "SR".into(), format!("M{axis},{angle}"), "SA".into()]);
        }
        _ => {
            lines.push(format!("MI,{axis},{way},{speed}"));
            let seconds = entries.number("seconds");
            if seconds > 0.0 {
                lines.push(format!("PAUSE,{}", number(seconds)));
                lines.push(format!("MI,{axis},{way},0"));
            }
        }
    }
    Ok(ToolOutput::part(entries.text("file"), lines, Vec::new()))
}

#[cfg(test)]
mod tests {
    use crate::testing::made;

    #[test]
    fn the_indexer_turns_to_by_or_on() {
        let lines = |line: &str| made('I', line).lines().skip(1).collect::<Vec<_>>().join(" ");
        assert_eq!(lines(""), "MS,,,,30 SA MB,90");
        assert_eq!(lines("turn by,B,45"), "MS,,,,30 SR MB,45 SA");
        assert_eq!(lines("spin,,,60,counter-clockwise,2"), "MI,B,-1,60 PAUSE,2 MI,B,-1,0");
        assert_eq!(lines("spin,A"), "MI,A,1,30");
    }
}
