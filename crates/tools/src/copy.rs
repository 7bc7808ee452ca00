//! TC, the Copy Machine: a part file that feels an object with a probe and writes a file of what it
//! touched.
//!
//! ```text
//!  3D  ↓ ↓ ↓ ↓ ↓  rows of points, straight down      2D   ↘ ↓ ↙   towards the middle, all round
//!      ╭─────╮    at every step                          → (■) ←  at one height
//! ```

use crate::field::{Field, Kind, UNITS, choice, file, length, place, whole};
use crate::lines::{foot, head, number, part_name};
use crate::{Entries, Mistake, ToolOutput};

const FIELDS: &[Field] = &[
    choice("pattern", "Pattern", &["3D", "2D"])
        .about("3D feels the whole object from above, 2D its outline at one height."),
    choice("probe", "Probe", &["normally open", "normally closed"]),
    Field { key: "input", label: "Probe, input", kind: Kind::Whole(1, 12), default: "1", doc: "" },
    choice("output", "Output", &["sbp", "dxf points", "dxf polyline"])
        .about("A part file that cuts what was felt, or a drawing of it."),
    place("x", "X", "0").about("3D: left edge of the area; 2D: a place inside of the object."),
    place("y", "Y", "0").about("3D: lower edge of the area; 2D: a place inside of the object."),
    length("width", "Width, X", "2", 0.001).about("3D: of the area."),
    length("height", "Height, Y", "2", 0.001).about("3D: of the area."),
    length("step", "Step", "0.25", 0.001).about("3D: from one point to the next."),
    length("radius", "Radius", "2", 0.001)
        .about("2D: so far outside the probe begins; further than any part of the object."),
    whole("points", "Points", "72", 3600).about("2D: all round."),
    length("safe_z", "Safe Z", "0.5", 0.0).about("Above everything."),
    place("lowest", "Lowest Z", "-1")
        .about("3D: no deeper than this; 2D: the height at which the outline is felt."),
    length("depth", "Cutting depth", "0.25", 0.0).about("2D, sbp: how deep the outline is cut."),
    length("speed", "Speed, a second", "0.1", 0.001)
        .about("Of the probe. Slow is exact: a stop from ramp speed or less is at once."),
    UNITS,
    file("copied"),
];

pub const TOOL: crate::Tool = crate::Tool {
    letter: 'C',
    name: "Copy Machine",
    doc: "Makes a part file, copy_machine.sbp, that feels an object with a probe and writes what it touched as \
          a part file or a drawing. The points are those of the probe's middle: a cutter of the same \
          diameter cuts the same object. In 2D, hollows that the middle does not see are bridged.",
    fields: FIELDS,
    make,
};

/// The part file that feels.
const PROGRAM: &str = "copy_machine";

/// Most points of a 3D copy.
const MOST: f64 = 250_000.0;

fn make(entries: &Entries<'_>) -> Result<ToolOutput, Vec<Mistake>> {
    let [safe, lowest] = ["safe_z", "lowest"].map(|key| entries.number(key));
    if lowest >= safe {
        return Err(vec![Mistake::new("lowest", "it has to lie below Safe Z")]);
    }
    let flat = entries.is("pattern", "2D");
    let copy = Copy { entries, flat, drawing: !entries.is("output", "sbp") };
    let points = (copy.steps("width") + 1.0) * (copy.steps("height") + 1.0);
    if !flat && points > MOST {
        let text = format!("{points} points are more than {MOST}: take a longer step");
        return Err(vec![Mistake::new("step", text)]);
    }
    let (output, program) = (copy.output(), part_name(PROGRAM));
    if output.eq_ignore_ascii_case(&program) {
        return Err(vec![Mistake::new("file", format!("{program} is the file that feels"))]);
    }
    let notes = vec![format!("Run {program}: it feels the object and writes {output}.")];
    Ok(ToolOutput::part(PROGRAM, copy.program(&output), notes))
}

struct Copy<'a> {
    entries: &'a Entries<'a>,
    /// 2D.
    flat: bool,
    /// DXF, not a part file.
    drawing: bool,
}

impl Copy<'_> {
    fn shown(&self, key: &str) -> String {
        number(self.entries.number(key))
    }

    /// Steps along a side of the area.
    fn steps(&self, side: &str) -> f64 {
        (self.entries.number(side) / self.entries.number("step") + 1e-9).floor()
    }

    fn output(&self) -> String {
        let name = self.entries.text("file");
        match (name.contains('.'), self.drawing) {
            (true, _) => name.into(),
            (false, true) => format!("{name}.dxf"),
            (false, false) => part_name(name),
        }
    }

    /// The input and the state in which the probe touches.
    fn contact(&self) -> (String, u8) {
        (self.entries.text("input").into(), u8::from(self.entries.is("probe", "normally open")))
    }

    fn program(&self, output: &str) -> Vec<String> {
        let (input, on) = self.contact();
        let (speed, safe) = (self.shown("speed"), self.shown("safe_z"));
        let mut lines = head("Feels an object, made by the Copy Machine", self.entries);
        let state = reading_of(&input);
        lines.extend([
            format!("IF {state} = {on} THEN GOTO TOUCHES"),
            format!("MS,{speed},{speed}"),
            "&count = 0".into(),
            format!("OPEN \"{output}\" FOR OUTPUT AS #1"),
        ]);
        lines.extend(self.begins());
        lines.push(format!("JZ,{safe}"));
        lines.extend(if self.flat { self.round(&input, on) } else { self.rows(&input, on) });
        lines.push(format!("JZ,{safe}"));
        lines.extend(self.ends());
        lines.extend(["CLOSE #1".into(), format!("PRINT &count, \" points in {output}\"")]);
        lines.extend(foot());
        lines.extend(["END".into(), "TOUCHES:".into()]);
        lines.push(
            "MSGBOX(The probe touches already: move it away first.,OKOnly,Copy Machine)".into(),
        );
        lines.push("END".into());
        lines.push("RECORD:".into());
        lines.push("&count = &count + 1".into());
        lines.extend(self.record());
        lines.extend(["RETURN".into(), "ROW_ENDS:".into()]);
        if self.polyline() {
            lines.extend(write(&["0", "SEQEND"]));
        }
        lines.push("RETURN".into());
        lines
    }

    /// From above, row by row, there and back.
    fn rows(&self, input: &str, on: u8) -> Vec<String> {
        let (x, y, step) = (self.shown("x"), self.shown("y"), self.shown("step"));
        let (columns, rows) = (number(self.steps("width")), number(self.steps("height")));
        let (safe, low) = (self.shown("safe_z"), self.shown("lowest"));
        let text = format!(
            "&row = 0\n&back = 0\nROW:\n&y = {y} + &row * {step}\n&column = 0\nCOLUMN:\n&at = &column\n\
             IF &back = 1 THEN &at = {columns} - &column\n&x = {x} + &at * {step}\nJZ,{safe}\nJ2,&x,&y\n\
             &z = {low}\nON INPUT({input},{on}) GOTO HIT\nMZ,{low}\nON INPUT({input},{on})\nGOTO KEEP\n\
             HIT:\n&z = %(3)\nKEEP:\nGOSUB RECORD\n&column = &column + 1\n\
             IF &column <= {columns} THEN GOTO COLUMN\nGOSUB ROW_ENDS\n&back = 1 - &back\n&row = &row + 1\n\
             IF &row <= {rows} THEN GOTO ROW"
        );
        text.lines().map(str::to_owned).collect()
    }

    /// Towards the middle, at one height.
    fn round(&self, input: &str, on: u8) -> Vec<String> {
        let (x, y, radius) = (self.shown("x"), self.shown("y"), self.shown("radius"));
        let (points, low) = (self.shown("points"), self.shown("lowest"));
        let text = format!(
            "&k = 0\nROUND:\n&angle = &k * 6.283185307 / {points}\n&fromx = {x} + {radius} * COS(&angle)\n\
             &fromy = {y} + {radius} * SIN(&angle)\nIF &k > 0 THEN GOTO DOWN\nJ2,&fromx,&fromy\nMZ,{low}\n\
             DOWN:\nM2,&fromx,&fromy\nON INPUT({input},{on}) GOTO HIT\nM2,{x},{y}\nON INPUT({input},{on})\n\
             GOTO MISSED\nHIT:\n&x = %(1)\n&y = %(2)\n&z = {low}\nGOSUB RECORD\nMISSED:\nM2,&fromx,&fromy\n\
             &k = &k + 1\nIF &k < {points} THEN GOTO ROUND\nGOSUB ROW_ENDS"
        );
        text.lines().map(str::to_owned).collect()
    }

    fn polyline(&self) -> bool {
        self.entries.is("output", "dxf polyline")
    }

    /// The beginning of what is written.
    fn begins(&self) -> Vec<String> {
        if self.drawing {
            // What a drawing's unit is: 4 is millimetres, 1 inches.
            let unit = if self.entries.metric() { "4" } else { "1" };
            let head = ["0", "SECTION", "2", "HEADER", "9", "$INSUNITS", "70", unit, "0", "ENDSEC"];
            return [write(&head), write(&["0", "SECTION", "2", "ENTITIES"])].concat();
        }
        let mut lines = write(&["'Copied by the Copy Machine"]);
        let other = u8::from(!self.entries.metric());
        lines.extend(write(&[
            &format!("IF %(25) = {other} THEN GOTO UNIT_ERROR"),
            "SA",
            &format!("JZ,{}", self.shown("safe_z")),
        ]));
        lines
    }

    /// The end of it.
    fn ends(&self) -> Vec<String> {
        if self.drawing {
            return write(&["0", "ENDSEC", "0", "EOF"]);
        }
        let mut lines = Vec::new();
        if self.flat {
            lines.push("IF &count > 0 THEN WRITE #1; \"M2,\"; &firstx; \",\"; &firsty".into());
        }
        lines.extend(write(&[&format!("JZ,{}", self.shown("safe_z"))]));
        lines.extend(write(&["END", "UNIT_ERROR:", "C91"]));
        lines
    }

    /// Writes the point &x, &y, &z.
    fn record(&self) -> Vec<String> {
        // What is next to zero would be written with an exponent, which no drawing and few programs read.
        let rounded = ["x", "y", "z"].map(|it| format!("&{it} = INT(&{it} * 10000 + 0.5) / 10000"));
        [rounded.to_vec(), self.record_rounded()].concat()
    }

    fn record_rounded(&self) -> Vec<String> {
        match (self.drawing, self.polyline()) {
            (true, false) => [write(&["0", "POINT", "8", "COPY"]), coordinates()].concat(),
            (true, true) => {
                // A row, or the outline, begins anew.
                let first = if self.flat { "&count" } else { "&column + 1" };
                let flags = if self.flat { "9" } else { "8" };
                let mut lines =
                    vec![format!("&nth = {first}"), "IF &nth > 1 THEN GOTO VERTEX".into()];
                lines.extend(write(&["0", "POLYLINE", "8", "COPY", "66", "1", "70", flags]));
                lines.push("VERTEX:".into());
                lines.extend(write(&["0", "VERTEX", "8", "COPY", "70", "32"]));
                [lines, coordinates()].concat()
            }
            (false, _) => self.record_move(),
        }
    }

    fn record_move(&self) -> Vec<String> {
        let jog = "WRITE #1; \"J2,\"; &x; \",\"; &y".to_owned();
        let mut lines = vec!["IF &count > 1 THEN GOTO NEXT".into(), jog];
        if self.flat {
            lines.extend(["&firstx = &x".into(), "&firsty = &y".into()]);
            lines.extend(write(&[&format!("MZ,{}", number(-self.entries.number("depth")))]));
        }
        lines.push("NEXT:".into());
        lines.push(if self.flat {
            "WRITE #1; \"M2,\"; &x; \",\"; &y".into()
        } else {
            "WRITE #1; \"M3,\"; &x; \",\"; &y; \",\"; &z".into()
        });
        lines
    }
}

/// The variable that reads an input.
fn reading_of(input: &str) -> String {
    format!("%({})", 50 + input.parse::<u32>().unwrap_or_default())
}

/// Lines that write lines.
fn write(lines: &[&str]) -> Vec<String> {
    lines.iter().map(|line| format!("WRITE #1; \"{line}\"")).collect()
}

/// The place of a point in a drawing.
fn coordinates() -> Vec<String> {
    let group = |(code, name): (&str, &str)| {
        [format!("WRITE #1; \"{code}\""), format!("WRITE #1; &{name}")]
    };
    [("10", "x"), ("20", "y"), ("30", "z")].into_iter().flat_map(group).collect()
}

#[cfg(test)]
mod tests {
    use crate::testing::made;

    #[test]
    fn a_probe_that_opens_is_waited_for_to_open() {
        let text = made('C', "probe=normally closed,input=3");
        assert!(text.contains("IF %(53) = 0 THEN GOTO TOUCHES"), "{text}");
        assert!(text.contains("ON INPUT(3,0) GOTO HIT"), "{text}");
    }

    #[test]
    fn points_are_rounded_before_they_are_written() {
        for pattern in ["pattern=2D", "pattern=3D", "output=dxf points"] {
            let text = made('C', pattern);
            for axis in ["x", "y", "z"] {
                let rounded = format!("&{axis} = INT(&{axis} * 10000 + 0.5) / 10000");
                let (at, writes) = (text.find(&rounded), text.rfind(&format!("; &{axis}")));
                assert!(at.is_some(), "{pattern}: {text}");
                assert!(writes.is_none_or(|writes| at < Some(writes)), "{pattern}: {text}");
            }
        }
    }

    #[test]
    fn mistakes_name_their_field() {
        for (line, part) in [
            ("lowest=1", "lowest: it has to lie below Safe Z"),
            ("width=100,height=100,step=.01", "step: 100020001 points are more than 250000"),
            ("file=copy_machine", "file: copy_machine.sbp is the file that feels"),
            ("pattern=4D", "pattern: one of 3D, 2D, not '4D'"),
        ] {
            let text = made('C', line);
            assert!(text.contains(part), "{line}: {text}");
        }
    }
}
