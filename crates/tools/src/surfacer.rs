//! TU, the Tabletop Surfacer: planes the table with a pocket of CR.

use crate::field::{UNITS, file, length, place, whole};
use crate::lines::{foot, head, number};
use crate::{Entries, Field, Kind, Mistake, Tool, ToolOutput};

const FIELDS: &[Field] = &[
    length("x", "Area, X", "96", 0.001),
    length("y", "Area, Y", "48", 0.001),
    place("left", "Left edge", "0"),
    place("lower", "Lower edge", "0"),
    length("bit", "Bit diameter", "1.5", 0.001),
    length("depth", "Depth", "0.03", 0.0001).about("Below Z zero, which is the table as it is."),
    whole("passes", "Passes", "1", 20),
    Field {
        key: "overlap",
        label: "Overlap",
        kind: Kind::Number(1.0, 90.0),
        default: "20",
        doc: "Of neighbouring paths, percent of the bit.",
    },
    length("safe_z", "Safe Z", "1", 0.0),
    UNITS,
    file("surface.sbp"),
];

pub const TOOL: Tool = Tool {
    letter: 'U',
    name: "Tabletop Surfacer",
    doc: "Planes the table. Level the Z axis first, or each path leaves a ridge.",
    fields: FIELDS,
    make,
};

fn make(entries: &Entries<'_>) -> Result<ToolOutput, Vec<Mistake>> {
    let (x, y, bit) = (entries.number("x"), entries.number("y"), entries.number("bit"));
    if bit > x.min(y) {
        return Err(vec![Mistake::new("bit", "the bit is larger than the area")]);
    }
    let (radius, passes) = (bit / 2.0, entries.number("passes"));
    let step = number(-entries.number("depth") / passes);
    let mut lines = head("Plane table, made by the Tabletop Surfacer", entries);
    lines.push(format!("'Bit: {}", number(bit)));
    lines.push(format!("VC,{},,,,,{}", number(bit), entries.text("overlap")));
    lines.push("'Level the Z axis first: a spindle that leans leaves a ridge at each path.".into());
    lines.push("PAUSE".into());
    lines.push(format!("JZ,{}", entries.text("safe_z")));
    lines.push("C6".into());
    // The cutter's edge, not its middle, ends at the edges of the area.
    let (left, lower) = (entries.number("left") + radius, entries.number("lower") + radius);
    lines.push(format!("J2,{},{}", number(left), number(lower)));
    lines.push("MZ,0".into());
    let (x, y) = (number(x - bit), number(y - bit));
    lines.push(format!("CR,{x},{y},T,1,4,{step},{passes},2"));
    lines.push(format!("JZ,{}", entries.text("safe_z")));
    lines.push("C7".into());
    lines.extend(foot());
    let note = "Level the Z axis before this file is run.".to_owned();
    Ok(ToolOutput::part(entries.text("file"), lines, vec![note]))
}

#[cfg(test)]
mod tests {
    use crate::testing::made;

    #[test]
    fn the_table_is_planed_to_the_edges_of_the_area() {
        let text = made('U', "x=10,y=6,bit=2,depth=.1,overlap=25,passes=2,left=1");
        for line in ["VC,2,,,,,25", "J2,2,1", "CR,8,4,T,1,4,-0.05,2,2"] {
            assert!(text.lines().any(|l| l == line), "{line} in\n{text}");
        }
        assert!(text.contains("Level the Z axis first"));
        assert!(made('U', "x=1").contains("bit: the bit is larger than the area"));
    }
}
