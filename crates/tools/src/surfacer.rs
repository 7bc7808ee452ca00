//! TU, the Tabletop Surfacer: planes the table or a board, ring by ring with a pocket of CR, or row by row.
//!
//! ```text
//!   rings: the cutter's edge ends       rows: the cutter's middle ends
//!   at the edges of the area            at the edges of the area
//!   ┌───────────┐                       ─┬──────────┬─►
//!   │┌─────────┐│                      ◄─┼──────────┼─┐
//!   │└─────────┘│                       ─┼──────────┼─►
//!   └───────────┘                       ─┴──────────┴─
//! ```

use crate::field::{UNITS, choice, file, length, place, whole};
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
    choice("pattern", "Pattern", &["rings", "rows along X", "rows along Y"]).about(
        "Rows clear the corners: the cutter reaches over the edges at their ends by its radius.",
    ),
    length("feed", "Speed, a second", "0", 0.0).about("0 is the move speed that is set."),
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
    let mut lines = head("Plane table, made by the Tabletop Surfacer", entries);
    lines.push(format!("'Bit: {}", number(bit)));
    lines.push(format!("VC,{},,,,,{}", number(bit), entries.text("overlap")));
    lines.push("'Level the Z axis first: a spindle that leans leaves a ridge at each path.".into());
    lines.push("PAUSE".into());
    if entries.number("feed") > 0.0 {
        let speed = entries.text("feed");
        lines.push(format!("MS,{speed},{speed}"));
    }
    lines.push(format!("JZ,{}", entries.text("safe_z")));
    lines.push("C6".into());
    lines.extend(if entries.is("pattern", "rings") { rings(entries) } else { rows(entries) });
    lines.push(format!("JZ,{}", entries.text("safe_z")));
    lines.push("C7".into());
    lines.extend(foot());
    let note = "Level the Z axis before this file is run.".to_owned();
    Ok(ToolOutput::part(entries.text("file"), lines, vec![note]))
}

/// Lines of a pocket over the area.
fn rings(entries: &Entries<'_>) -> Vec<String> {
    let (x, y, bit) = (entries.number("x"), entries.number("y"), entries.number("bit"));
    let (radius, passes) = (bit / 2.0, entries.number("passes"));
    let step = number(-entries.number("depth") / passes);
    // The cutter's edge, not its middle, ends at the edges of the area.
    let (left, lower) = (entries.number("left") + radius, entries.number("lower") + radius);
    let (x, y) = (number(x - bit), number(y - bit));
    vec![
        format!("J2,{},{}", number(left), number(lower)),
        "MZ,0".into(),
        format!("CR,{x},{y},T,1,4,{step},{passes},2"),
    ]
}

/// Lines that go to and fro over the area, each pass from the corner of the first.
fn rows(entries: &Entries<'_>) -> Vec<String> {
    let along_x = entries.is("pattern", "rows along X");
    let place = |along: f64, across: f64| {
        let [x, y] = if along_x { [along, across] } else { [across, along] };
        format!("{},{}", number(x), number(y))
    };
    let side =
        |key: &str, low: &str| (entries.number(low), entries.number(low) + entries.number(key));
    let (x, y) = (side("x", "left"), side("y", "lower"));
    let ((begin, end), (low, high)) = if along_x { (x, y) } else { (y, x) };
    let widest = entries.number("bit") * (1.0 - entries.number("overlap") / 100.0);
    let count = ((high - low) / widest).ceil().max(1.0) as usize;
    let pitch = (high - low) / count as f64;
    let passes = entries.number("passes");
    let mut lines = Vec::new();
    for pass in 1..=passes as usize {
        lines.push(format!("J2,{}", place(begin, low + pitch / 2.0)));
        lines.push(format!("MZ,{}", number(-entries.number("depth") * pass as f64 / passes)));
        for row in 0..count {
            let across = low + pitch * (row as f64 + 0.5);
            let (from, to) = if row % 2 == 0 { (begin, end) } else { (end, begin) };
            lines.extend([from, to].map(|along| format!("M2,{}", place(along, across))));
        }
        lines.push(format!("JZ,{}", entries.text("safe_z")));
    }
    lines
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

    /// Places of X, Y and Z that the moves of a file go to; what is not said stays.
    fn places(text: &str) -> Vec<[f64; 3]> {
        let mut at = [0.0, 0.0, 9.0];
        let mut all = Vec::new();
        for line in text.lines() {
            let words: Vec<&str> = line.split(',').collect();
            let number = |word: &str| word.parse::<f64>().expect("a number");
            match words[..] {
                ["J2" | "M2", x, y] => (at[0], at[1]) = (number(x), number(y)),
                ["JZ" | "MZ", z] => at[2] = number(z),
                _ => continue,
            }
            all.push(at);
        }
        all
    }

    /// Distance of a place from the way between two others.
    fn far([x, y]: [f64; 2], from: [f64; 3], to: [f64; 3]) -> f64 {
        let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
        let square = dx * dx + dy * dy;
        let along = ((x - from[0]) * dx + (y - from[1]) * dy) / square.max(1e-12);
        let share = along.clamp(0.0, 1.0);
        (x - from[0] - dx * share).hypot(y - from[1] - dy * share)
    }

    #[test]
    fn rows_cover_the_whole_area_at_each_depth_and_leave_it_by_the_radius_at_most() {
        for (pattern, bit, overlap, width, height, passes) in [
            ("rows along X", 2.0, 25.0, 10.0, 6.0, 1),
            ("rows along Y", 1.5, 1.0, 7.3, 4.1, 2),
            ("rows along X", 3.0, 90.0, 3.0, 3.0, 1),
            ("rows along Y", 0.7, 40.0, 5.0, 11.0, 3),
        ] {
            let text = made(
                'U',
                &format!(
                    "pattern={pattern},bit={bit},overlap={overlap},x={width},y={height},left=1,lower=-2,\
                     depth=.3,passes={passes}"
                ),
            );
            let places = places(&text);
            for pass in 1..=passes {
                let z = -0.3 * f64::from(pass) / f64::from(passes);
                let ways: Vec<_> = places
                    .windows(2)
                    .filter(|way| way.iter().all(|at| (at[2] - z).abs() < 1e-4))
                    .collect();
                for (n, m) in (0..=60).flat_map(|n| (0..=60).map(move |m| (n, m))) {
                    let at =
                        [1.0 + width * f64::from(n) / 60.0, -2.0 + height * f64::from(m) / 60.0];
                    let near = ways.iter().map(|way| far(at, way[0], way[1])).fold(9.0, f64::min);
                    assert!(near <= bit / 2.0 + 1e-4, "{pattern} {bit}: {at:?} is left at {z}");
                }
            }
            let outside = |at: &[f64; 3]| {
                let beyond = |v: f64, low: f64, size: f64| (low - v).max(v - low - size);
                beyond(at[0], 1.0, width).max(beyond(at[1], -2.0, height))
            };
            assert!(places.iter().all(|at| at[2] > 0.0 || outside(at) < 1e-4), "{text}");
        }
        assert!(made('U', "pattern=rows along X,feed=3").lines().any(|line| line == "MS,3,3"));
    }
}
