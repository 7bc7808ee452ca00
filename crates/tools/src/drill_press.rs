//! TD, the Drill Press: holes of any diameter, in passes.

use crate::field::{UNITS, choice, file, length, text, whole};
use crate::lines::{foot, head, number};
use crate::{Entries, Field, Mistake, Tool, ToolOutput};

const FIELDS: &[Field] = &[
    length("blank_x", "Blank, X", "24", 0.0),
    length("blank_y", "Blank, Y", "12", 0.0),
    length("thickness", "Blank, thickness", "0.75", 0.0),
    text("holes", "Holes").about(
        "X Y diameter of each, depth behind it where it does not go through: 2 3 .5; 4 3 .25 .3",
    ),
    length("bit", "Bit diameter", "0.25", 0.0001),
    length("safe_z", "Safe Z", "0.5", 0.0).about("Above the blank."),
    whole("passes", "Passes", "2", 100),
    choice("pocket", "Pocket inside out", &["no", "yes"])
        .about("Clears the whole hole, so that no waste comes loose."),
    choice("zero", "Z zero", &["surface", "table"]),
    UNITS,
    file("holes.sbp"),
];

pub const TOOL: Tool = Tool {
    letter: 'D',
    name: "Drill Press",
    doc: "Drills holes of any diameter; those larger than the bit are cut as circles.",
    fields: FIELDS,
    make,
};

/// A hole.
#[derive(Clone, Copy, Debug)]
struct Hole {
    at: [f64; 2],
    diameter: f64,
    depth: f64,
}

fn make(entries: &Entries<'_>) -> Result<ToolOutput, Vec<Mistake>> {
    let holes = holes(entries)?;
    let top = if entries.is("zero", "table") { entries.number("thickness") } else { 0.0 };
    let safe = top + entries.number("safe_z");
    let (passes, bit) = (entries.number("passes"), entries.number("bit"));
    let pocket = entries.is("pocket", "yes");
    let mut lines = head("Holes, made by the Drill Press", entries);
    lines.push(format!("'Bit: {}", number(bit)));
    lines.push(format!("VC,{}", number(bit)));
    lines.push(format!("JZ,{}", number(safe)));
    lines.push("C6".into());
    for Hole { at: [x, y], diameter, depth } in &holes {
        let (x, y) = (number(*x), number(*y));
        lines.push(format!("J2,{x},{y}"));
        let step = depth / passes;
        if diameter - bit < 1e-6 {
            for pass in 1..=passes as u32 {
                lines.push(format!("MZ,{}", number(top - step * f64::from(pass))));
                // Chips come out between the passes.
                lines
                    .push(format!("JZ,{}", number(if pass == passes as u32 { safe } else { top })));
            }
        } else {
            lines.push(format!("MZ,{}", number(top)));
            let inner = if pocket { rings(*diameter, bit) } else { Vec::new() };
            for diameter in inner.iter().chain([diameter]) {
                let (diameter, step) = (number(*diameter), number(-step));
                lines.push(format!("CP,{diameter},{x},{y},I,-1,,,{step},{passes}"));
            }
            lines.push(format!("JZ,{}", number(safe)));
        }
    }
    lines.push("C7".into());
    lines.extend(foot());
    Ok(ToolOutput::part(entries.text("file"), lines, Vec::new()))
}

/// Diameters of the circles that clear a hole before its wall is cut, from the inside out: nothing is
/// left in its middle that could come loose.
fn rings(diameter: f64, bit: f64) -> Vec<f64> {
    // From one to the next a tenth of the bit overlaps; the innermost reaches over the centre.
    let (step, innermost) = (1.8 * bit, 1.9 * bit);
    let count = ((diameter - innermost) / step - 1e-9).ceil().max(0.0);
    let between = (diameter - innermost) / count;
    (0..count as u32).map(|n| innermost + f64::from(n) * between).collect()
}

fn holes(entries: &Entries<'_>) -> Result<Vec<Hole>, Vec<Mistake>> {
    let (mut holes, mut mistakes) = (Vec::new(), Vec::new());
    let list = entries.text("holes");
    for (n, item) in list.split(';').map(str::trim).filter(|item| !item.is_empty()).enumerate() {
        match hole(item, entries) {
            Ok(hole) => holes.push(hole),
            Err(why) => mistakes.push(Mistake::new("holes", format!("hole {}: {why}", n + 1))),
        }
    }
    if holes.is_empty() && mistakes.is_empty() {
        mistakes.push(Mistake::new("holes", "at least one hole, as 2 3 .5 (X, Y, diameter)"));
    }
    if mistakes.is_empty() { Ok(holes) } else { Err(mistakes) }
}

fn hole(item: &str, entries: &Entries<'_>) -> Result<Hole, String> {
    let numbers: Option<Vec<f64>> = item.split_whitespace().map(|n| n.parse().ok()).collect();
    let numbers = numbers.unwrap_or_default();
    let thickness = entries.number("thickness");
    let (x, y, diameter, depth) = match numbers[..] {
        [x, y, diameter] => (x, y, diameter, thickness),
        [x, y, diameter, depth] => (x, y, diameter, depth),
        _ => return Err(format!("X, Y, diameter, and perhaps depth expected, not '{item}'")),
    };
    let radius = diameter / 2.0;
    let inside = |at: f64, size: f64| at - radius >= -1e-9 && at + radius <= size + 1e-9;
    if diameter < entries.number("bit") - 1e-9 {
        return Err(format!("{diameter} is less than the bit"));
    }
    if !(depth > 0.0 && depth <= thickness + 1e-9) {
        return Err(format!("the depth {depth} is not within the thickness of the blank"));
    }
    if !inside(x, entries.number("blank_x")) || !inside(y, entries.number("blank_y")) {
        return Err("it lies beyond the edge of the blank".into());
    }
    Ok(Hole { at: [x, y], diameter, depth })
}

#[cfg(test)]
mod tests {
    use crate::testing::made;

    #[test]
    fn a_hole_of_the_bit_is_drilled_in_passes() {
        let text = made('D', "holes=2 3 .25,passes=3,thickness=.6,zero=table");
        for line in ["J2,2,3", "MZ,0.4", "MZ,0.2", "MZ,0", "JZ,1.1"] {
            assert!(text.lines().any(|l| l == line), "{line} in\n{text}");
        }
    }

    #[test]
    fn a_larger_hole_is_a_circle_of_its_size() {
        let text = made('D', "holes=2 3 1;6 3 .5 .25");
        assert!(text.contains("CP,1,2,3,I,-1,,,-0.375,2\n"), "{text}");
        assert!(text.contains("CP,0.5,6,3,I,-1,,,-0.125,2\n"), "{text}");
    }

    #[test]
    fn a_pocket_grows_from_the_middle() {
        let circles = |holes: &str| {
            let text = made('D', &format!("holes={holes},pocket=yes"));
            let circles = text.lines().filter_map(|line| line.strip_prefix("CP,"));
            circles
                .map(|line| line.split(',').next().unwrap_or_default().to_owned())
                .collect::<Vec<_>>()
        };
        assert_eq!(circles("2 3 1"), ["0.475", "0.7375", "1"]);
        assert_eq!(circles("2 3 .5"), ["0.475", "0.5"]);
        assert_eq!(circles("2 3 .4"), ["0.4"], "no larger than what the bit clears at once");
    }

    #[test]
    fn mistakes_name_their_field() {
        for (line, part) in [
            ("holes=", "holes: at least one hole"),
            ("holes=2 3 .1", "holes: hole 1: 0.1 is less than the bit"),
            ("holes=2 3 .5;30 3 .5", "hole 2: it lies beyond"),
            ("holes=2 3 .5 2", "depth 2 is not within"),
            ("holes=2 3", "X, Y, diameter"),
            ("holes=2 3 .5,passes=0", "passes: a whole number, 1 to 100, not '0'"),
            ("hole=1", "hole: there is no such field"),
        ] {
            let text = made('D', line);
            assert!(text.contains(part), "{line}: {text}");
        }
    }
}
