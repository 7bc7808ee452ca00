//! TF, the Fluter: parallel grooves, evenly placed on a blank.

use crate::field::{UNITS, choice, file, length, place, whole};
use crate::lines::{foot, head, number};
use crate::{Entries, Field, Kind, Mistake, Tool, ToolOutput};

const FIELDS: &[Field] = &[
    length("table_x", "Table, X", "96", 0.0),
    length("table_y", "Table, Y", "48", 0.0),
    whole("passes", "Passes", "1", 2),
    length("blank_length", "Blank, length", "36", 0.0).about("Along the flutes."),
    length("blank_width", "Blank, width", "5.5", 0.0),
    place("blank_x", "Blank, left edge", "0"),
    place("blank_y", "Blank, lower edge", "0"),
    choice("direction", "Flutes run along", &["x", "y"]),
    length("width", "Flute width", "0.5", 0.0001),
    choice("bit_type", "Bit", &["ball", "v", "flat"]),
    length("bit", "Bit diameter", "0.5", 0.0001),
    Field {
        key: "v_angle",
        label: "V angle",
        kind: Kind::Number(10.0, 170.0),
        default: "90",
        doc: "Of a V bit, both sides together, degrees.",
    },
    length("depth", "Depth of a flat bit", "0.25", 0.0).about("The others follow from the width."),
    length("spacing", "Spacing", "0.75", 0.0001).about("From the middle of a flute to the next."),
    length("edge", "Edge distance", "0.5", 0.0).about("From the edges of the blank, all round."),
    length("safe_z", "Safe Z", "0.5", 0.0),
    UNITS,
    file("flutes.sbp"),
];

pub const TOOL: Tool = Tool {
    letter: 'F',
    name: "Fluter",
    doc: "Cuts flutes that are evenly placed on a blank; Z zero is its surface.",
    fields: FIELDS,
    make,
};

fn make(entries: &Entries<'_>) -> Result<ToolOutput, Vec<Mistake>> {
    let places = places(entries)?;
    let depth = depth(entries)?;
    let along_y = entries.is("direction", "y");
    let (edge, reach) = (entries.number("edge"), entries.number("blank_length"));
    let (x, y) = (entries.number("blank_x"), entries.number("blank_y"));
    let (begin, across) = if along_y { (y, x) } else { (x, y) };
    let at = |along: f64, aside: f64| {
        let (along, aside) = (number(along), number(aside));
        if along_y { format!("{aside},{along}") } else { format!("{along},{aside}") }
    };
    let passes = entries.number("passes") as u32;
    let mut lines = head("Flutes, made by the Fluter", entries);
    lines.push(format!("'Bit: {} {}", entries.text("bit"), entries.text("bit_type")));
    lines.push(format!("VC,{}", entries.text("bit")));
    lines.push(format!("JZ,{}", entries.text("safe_z")));
    lines.push("C6".into());
    let ends = [begin + edge, begin + reach - edge];
    for aside in &places {
        lines.push(format!("J2,{}", at(ends[0], across + aside)));
        for pass in 1..=passes {
            // A second pass comes back along the first.
            let to = if pass % 2 == 1 { ends[1] } else { ends[0] };
            lines.push(format!("MZ,{}", number(-depth * f64::from(pass) / f64::from(passes))));
            lines.push(format!("M2,{}", at(to, across + aside)));
        }
        lines.push(format!("JZ,{}", entries.text("safe_z")));
    }
    lines.push("C7".into());
    lines.extend(foot());
    let note = format!("{} flutes, {} deep", places.len(), number(depth));
    Ok(ToolOutput::part(entries.text("file"), lines, vec![note]))
}

/// Returns the places of the middles of the flutes, from the lower edge of the blank: as many as have room,
/// with equal margins.
fn places(entries: &Entries<'_>) -> Result<Vec<f64>, Vec<Mistake>> {
    let (width, blank) = (entries.number("width"), entries.number("blank_width"));
    let (edge, spacing) = (entries.number("edge"), entries.number("spacing"));
    let refused = |field: &str, text: &str| Err(vec![Mistake::new(field, text)]);
    let room = blank - 2.0 * edge - width;
    if room < -1e-9 {
        return refused("width", "no flute has room between the edge distances");
    }
    if entries.number("blank_length") <= 2.0 * edge {
        return refused("edge", "nothing is left of the length of the blank");
    }
    if spacing < width - 1e-9 {
        return refused("spacing", "flutes would run into each other: at least their width");
    }
    let along_y = entries.is("direction", "y");
    let size = [entries.number("blank_length"), blank];
    let size = if along_y { [size[1], size[0]] } else { size };
    for (axis, size) in ["x", "y"].into_iter().zip(size) {
        let begin = entries.number(&format!("blank_{axis}"));
        if begin < -1e-9 || begin + size > entries.number(&format!("table_{axis}")) + 1e-9 {
            return refused(&format!("blank_{axis}"), "the blank does not lie on the table");
        }
    }
    let gaps = (room / spacing + 1e-9).floor();
    let first = (blank - gaps * spacing) / 2.0;
    Ok((0..=gaps as u32).map(|n| first + f64::from(n) * spacing).collect())
}

/// Returns the depth of the bit for a flute of the width.
fn depth(entries: &Entries<'_>) -> Result<f64, Vec<Mistake>> {
    let (width, bit) = (entries.number("width"), entries.number("bit"));
    if width > bit + 1e-9 {
        return Err(vec![Mistake::new("width", "a flute is no wider than its bit")]);
    }
    Ok(match entries.text("bit_type") {
        "ball" => {
            let radius = bit / 2.0;
            radius - (radius * radius - width * width / 4.0).max(0.0).sqrt()
        }
        "v" => width / 2.0 / (entries.number("v_angle").to_radians() / 2.0).tan(),
        _ => entries.number("depth"),
    })
}

#[cfg(test)]
mod tests {
    use crate::testing::made;

    /// The grooves: where the tool goes down, and how deep.
    fn grooves(line: &str) -> (Vec<String>, String) {
        let text = made('F', line);
        let starts = text.lines().filter_map(|l| l.strip_prefix("J2,")).map(str::to_owned);
        let deep = text.lines().find_map(|l| l.strip_prefix("MZ,")).unwrap_or(&text);
        (starts.collect(), deep.to_owned())
    }

    #[test]
    fn flutes_are_evenly_placed_with_equal_margins() {
        let (starts, deep) = grooves("blank_width=4,spacing=1,width=.5,edge=.25");
        assert_eq!(starts, ["0.25,0.5", "0.25,1.5", "0.25,2.5", "0.25,3.5"]);
        assert_eq!(deep, "-0.25", "half a ball of half an inch");
        let (starts, _) = grooves("direction=y,blank_length=20,blank_width=4,spacing=1,edge=.25");
        assert_eq!(starts[1], "1.5,0.25");
    }

    #[test]
    fn depths_follow_from_the_bit() {
        let deep = |line: &str| grooves(line).1;
        assert_eq!(deep("bit_type=v,v_angle=90,width=.5"), "-0.25");
        assert_eq!(deep("bit_type=v,v_angle=60,width=.5"), "-0.433");
        assert_eq!(deep("bit_type=flat,depth=.3"), "-0.3");
        assert_eq!(deep("bit=1,width=.6"), "-0.1");
        assert_eq!(deep("passes=2,bit_type=flat,depth=.3"), "-0.15");
    }

    #[test]
    fn what_cannot_be_is_told() {
        for (line, part) in [
            ("width=6,bit=6", "width: no flute has room"),
            ("width=.7", "width: a flute is no wider"),
            ("spacing=.2", "spacing: flutes would run"),
            ("blank_x=80", "blank_x: the blank does not lie"),
            ("edge=18,blank_width=50", "edge: nothing is left"),
        ] {
            let text = made('F', line);
            assert!(text.contains(part), "{line}: {text}");
        }
    }
}
