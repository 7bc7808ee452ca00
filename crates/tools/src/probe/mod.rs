//! TP, the Probe: a program that finds a surface, a corner, a centre or an angle by touching it, and sets zero there.
//!
//! ```text
//!  fields ──► Finding: what is touched in which order ──► Lines: G-code, touches and guarded ways as subroutines
//! ```
//!
//! The program is G-code because that has it all: moves that end at a contact (G38.2), the place of the contact
//! (#5061), zero points that turn (G10 L2 R). Wherever it is run, it does the same.

mod finding;
mod lines;

use crate::field::{Field, UNITS, choice, file, length};
use crate::{Entries, FileFolder, Mistake, OutputFile, Tool, ToolOutput};

/// Things that are found, as the form names them.
const KINDS: &[&str] =
    &["plate", "outside-corner", "inside-corner", "edge", "bore", "boss", "slot", "angle"];

const FIELDS: &[Field] = &[
    choice("kind", "Finds", KINDS).about("The tool stands above a plate, a boss or an outside corner, else beside it."),
    choice("axes", "Sets zero of", &["all", "XY", "X", "Y", "Z", "none"])
        .about("Of the axes that are found; none only tells the place."),
    choice("corner", "Corner", &["front-left", "front-right", "back-left", "back-right"]),
    choice("direction", "Direction", &["X+", "X-", "Y+", "Y-"])
        .about("The way of the tool towards the edge; of a slot, its axis."),
    length("plate", "Plate, thickness", "0", 0.0).about("Between the tool and the surface that becomes Z zero."),
    length("diameter", "Probe, diameter", "0.125", 0.0).about("Of its tip, or of the tool that touches."),
    length("size", "Size", "1", 0.001).about("Boss: its diameter, about. Angle: from one touch to the other."),
    length("inset", "Inset", "0.5", 0.001).about("Outside corner: so far from both edges the tool stands. Boss: so far beside it the probe goes down."),
    length("depth", "Depth", "0.25", 0.001)
        .about("Sides are touched so far below the top of a corner, or below the place where the tool begins over a boss."),
    length("travel", "Travel", "1", 0.001).about("Farthest way of a touch. Without contact nothing is set."),
    length("clear", "Clearance", "0.1", 0.001).about("The tool backs off so far from what it touched."),
    length("fast", "First touch, a second", "0.1", 0.0001),
    length("slow", "Second touch, a second", "0.02", 0.0001),
    UNITS,
    file("probe.nc"),
];

pub const TOOL: Tool = Tool {
    letter: 'P',
    name: "Probe",
    doc: "Makes a program that touches a plate, a corner, an edge, a bore, a boss, a slot or a side with the probe on \
          input 1, each twice, and sets zero there. Of a side it finds the angle, and turns G-code by it.",
    fields: FIELDS,
    make,
};

fn make(entries: &Entries<'_>) -> Result<ToolOutput, Vec<Mistake>> {
    let mistakes = mistakes(entries);
    if !mistakes.is_empty() {
        return Err(mistakes);
    }
    let name = entries.text("file");
    let name = if name.contains('.') { name.to_owned() } else { format!("{name}.nc") };
    let text = lines::program(entries).join("\n") + "\n";
    let file = OutputFile { place: FileFolder::Parts, name, text };
    Ok(ToolOutput { files: vec![file], notes: Vec::new() })
}

fn mistakes(entries: &Entries<'_>) -> Vec<Mistake> {
    let mut found = Vec::new();
    if entries.number("slow") > entries.number("fast") {
        found.push(Mistake::new("slow", "the second touch is faster than the first"));
    }
    let (clear, travel) = (entries.number("clear"), entries.number("travel"));
    if clear >= travel {
        found.push(Mistake::new("clear", "it has to be shorter than the travel"));
    }
    let finds = finding::axes(entries.text("kind"), entries.text("direction"));
    if finding::chosen(finds, entries.text("axes")).is_none() {
        let text = format!(
            "{} finds {}",
            entries.text("kind"),
            if finds.is_empty() { "an angle" } else { finds }
        );
        found.push(Mistake::new("axes", text));
    }
    found
}

#[cfg(test)]
mod tests {
    use crate::testing::made;

    #[test]
    fn a_plate_is_touched_twice_and_its_thickness_counts() {
        let text = made('P', "kind=plate,plate=.5,units=in");
        for line in ["G20 G90 G94", "o<touch> call [0] [0] [-1]", "#<z>=[#5063 - 0.5]"] {
            assert!(text.lines().any(|l| l == line), "{line} in\n{text}");
        }
        assert!(text.contains("G10 L20 P0 Z[#<_z> - #<z>]"), "{text}");
    }

    #[test]
    fn what_is_not_found_is_not_set() {
        assert_eq!(made('P', "kind=bore,axes=Z"), "axes: bore finds XY");
        assert_eq!(made('P', "kind=angle,axes=X"), "axes: angle finds an angle");
        assert!(!made('P', "kind=bore,axes=none").contains("G10"));
        assert!(
            made('P', "kind=outside-corner,axes=XY")
                .contains("G10 L20 P0 X[#<_x> - #<x>] Y[#<_y> - #<y>]\n")
        );
    }

    #[test]
    fn speeds_and_ways_that_contradict_are_told() {
        assert!(made('P', "slow=1").contains("slow: the second touch is faster"));
        assert!(made('P', "clear=1").contains("clear: it has to be shorter"));
    }
}
