//! TM, the Height Map: a part file that probes a surface at the places of a grid and writes what it found.
//!
//! ```text
//!   ┌─►─►─►─┐     every place twice, fast and slow; rows there and back
//!   └─◄─◄─◄─┤     heights.map: X, Y, Z of each, millimetres of the working location
//! ```

use crate::field::{Field, Kind, UNITS, file, length, place};
use crate::lines::{foot, head, number};
use crate::{Entries, Mistake, Tool, ToolOutput};

/// A field for a number of places along a side.
const fn count(key: &'static str, label: &'static str) -> Field {
    Field { key, label, kind: Kind::Whole(2, 200), default: "5", doc: "" }
}

const FIELDS: &[Field] = &[
    place("x", "X", "0").about("The left edge of the grid."),
    place("y", "Y", "0").about("Its lower edge."),
    length("width", "Width, X", "4", 0.001),
    length("height", "Height, Y", "4", 0.001),
    count("columns", "Columns"),
    count("rows", "Rows"),
    length("travel", "Travel Z", "0.1", 0.0001).about("Above everything between two places."),
    place("lowest", "Lowest Z", "-0.1").about("Probed no deeper than this."),
    length("plate", "Plate, thickness", "0", 0.0).about("Between the tool and the surface."),
    length("clear", "Clearance", "0.02", 0.0001).about("From the first touch up to the second."),
    length("fast", "First touch, a second", "0.1", 0.0001),
    length("slow", "Second touch, a second", "0.05", 0.05),
    Field { key: "input", label: "Probe, input", kind: Kind::Whole(1, 12), default: "1", doc: "" },
    UNITS,
    file("probe_heights"),
];

pub const TOOL: Tool = Tool {
    letter: 'M',
    name: "Height map",
    doc: "Makes a part file that probes a surface at the places of a grid and writes heights.map. \
          `kerf map use heights.map` has programs follow it. Take a map that is in force off before.",
    fields: FIELDS,
    make,
};

fn make(entries: &Entries<'_>) -> Result<ToolOutput, Vec<Mistake>> {
    let [travel, lowest, clear] = ["travel", "lowest", "clear"].map(|key| entries.number(key));
    if lowest >= travel {
        return Err(vec![Mistake::new("lowest", "it has to lie below Travel Z")]);
    }
    if entries.number("slow") > entries.number("fast") {
        return Err(vec![Mistake::new("slow", "the second touch is faster than the first")]);
    }
    let step =
        |side: &str, count: &str| number(entries.number(side) / (entries.number(count) - 1.0));
    let shown = |key: &str| number(entries.number(key));
    let (dx, dy) = (step("width", "columns"), step("height", "rows"));
    let last = |count: &str| number(entries.number(count) - 1.0);
    let (columns, rows) = (last("columns"), last("rows"));
    let [x, y, low, plate, fast, slow] = ["x", "y", "lowest", "plate", "fast", "slow"].map(shown);
    let (input, travel, clear) = (entries.text("input"), number(travel), number(clear));
    let count = number(entries.number("columns") * entries.number("rows"));
    let mm = if entries.metric() { "1" } else { "25.4" };
    let reading = 50 + input.parse::<u32>().unwrap_or_default();
    let mut lines = head("Probes a surface, made by the Height map", entries);
    let text = format!(
        "IF %({reading}) = 1 THEN GOTO TOUCHES\nOPEN \"heights.map\" FOR OUTPUT AS #1\n\
         PRINT \"Heights of {count} places\"\n\
         WRITE #1; \"kerf heights, mm\"\n&row = 0\n&back = 0\nROW:\n&y = {y} + &row * {dy}\n&column = 0\n\
         COLUMN:\n&at = &column\nIF &back = 1 THEN &at = {columns} - &column\n&x = {x} + &at * {dx}\n\
         JZ,{travel}\nJ2,&x,&y\n&z = {low}\nIF %(22) = 1 THEN GOTO DRAWN\nMS,,{fast}\n\
         ON INPUT({input},1) GOTO FIRST\nMZ,{low}\nON INPUT({input},1)\nGOTO MISSED\nFIRST:\n\
         &z = %(3) + {clear}\nMZ,&z\nMS,,{slow}\n&z = &z - 2 * {clear}\nON INPUT({input},1) GOTO SECOND\nMZ,&z\n\
         ON INPUT({input},1)\nGOTO MISSED\nSECOND:\n&z = %(3) - {plate}\nDRAWN:\n\
         &xmm = INT(&x * {mm} * 10000 + 0.5) / 10000\n&ymm = INT(&y * {mm} * 10000 + 0.5) / 10000\n\
         &zmm = INT(&z * {mm} * 10000 + 0.5) / 10000\nWRITE #1; &xmm; \",\"; &ymm; \",\"; &zmm\n\
         PRINT \"Height: \"; &xmm; \",\"; &ymm; \",\"; &zmm\n\
         &column = &column + 1\nIF &column <= {columns} THEN GOTO COLUMN\n&back = 1 - &back\n&row = &row + 1\n\
         IF &row <= {rows} THEN GOTO ROW\nJZ,{travel}\nCLOSE #1\nPRINT \"heights.map is written\""
    );
    lines.extend(text.lines().map(str::to_owned));
    lines.extend(foot());
    let missed = format!(
        "MISSED:\nCLOSE #1\nJZ,{travel}\n\
         MSGBOX(The surface was not touched down to the lowest Z: heights.map is not complete.,Exclamation,Height map)\n\
         ENDALL\nTOUCHES:\n\
         MSGBOX(The probe touches already: move it away first.,Exclamation,Height map)\nENDALL"
    );
    lines.extend(missed.lines().map(str::to_owned));
    Ok(ToolOutput::part(entries.text("file"), lines, vec!["Run it: it writes heights.map.".into()]))
}

#[cfg(test)]
mod tests {
    use crate::testing::made;

    #[test]
    fn the_grid_is_spread_over_the_sides() {
        let text = made('M', "x=1,y=2,width=6,height=3,columns=4,rows=3,units=mm,plate=.5");
        for line in [
            "PRINT \"Heights of 12 places\"",
            "&y = 2 + &row * 1.5",
            "&x = 1 + &at * 2",
            "&z = %(3) - 0.5",
        ] {
            assert!(text.lines().any(|l| l == line), "{line} in\n{text}");
        }
        assert_eq!(made('M', "lowest=1"), "lowest: it has to lie below Travel Z");
        assert_eq!(made('M', "slow=1"), "slow: the second touch is faster than the first");
    }
}
