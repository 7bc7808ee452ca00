//! TT, the Typesetter: text in an installed font, carved with a V bit.

use crate::carve::{Spot, middle, ordered, thinned};
use crate::field::{Field, Kind, UNITS, file, length, place, text};
use crate::lines::{foot, head, number};
use crate::{Entries, Mistake, ToolOutput};
use ttf_parser::{Face, OutlineBuilder};

const FIELDS: &[Field] = &[
    text("text", "Text").about("| begins another line. In a typed command a comma ends it."),
    Field { default: "Roboto", ..text("font", "Font") }
        .about("The name of an installed font, or of a file in the data folder's folder fonts."),
    length("size", "Height of capitals", "1", 0.001),
    Field {
        key: "angle",
        label: "Angle of the V bit",
        kind: Kind::Number(10.0, 170.0),
        default: "90",
        doc: "From side to side, degrees.",
    },
    place("x", "X", "0").about("Where the first line begins."),
    place("y", "Y", "0").about("The line on which the letters of the first line stand."),
    length("safe_z", "Safe Z", "0.25", 0.0001).about("Above the surface, which is Z 0."),
    length("deepest", "Deepest", "0", 0.0)
        .about("Letters that would be carved deeper are refused; 0 is no bound."),
    UNITS,
    file("typeset.sbp"),
];

pub const TOOL: crate::Tool = crate::Tool {
    letter: 'T',
    name: "Typesetter",
    doc: "Carves text in a font of this computer with a V bit: its depth follows the width of the strokes, \
          and it rises into their corners.",
    fields: FIELDS,
    make,
};

/// Pieces of a curve of an outline.
const PIECES: u32 = 16;

/// From line to line, heights of capitals.
const LEADING: f64 = 1.6;

fn make(entries: &Entries<'_>) -> Result<ToolOutput, Vec<Mistake>> {
    let wrong = |key: &str, text: String| vec![Mistake::new(key, text)];
    let name = entries.text("font");
    let bytes = entries.font(name).map_err(|why| wrong("font", why))?;
    let unreadable =
        |_| wrong("font", format!("{name} cannot be read as a TrueType or OpenType font"));
    let face = Face::parse(&bytes, 0).map_err(unreadable)?;
    if entries.text("text").trim().is_empty() {
        return Err(wrong("text", "something to carve".into()));
    }
    let paths = set(entries, &face).map_err(|(key, why)| wrong(key, why))?;
    let steep = 1.0 / (entries.number("angle") / 2.0).to_radians().tan();
    let deepest = paths.iter().flatten().map(|spot| spot[2] * steep).fold(0.0, f64::max);
    let bound = entries.number("deepest");
    if bound > 0.0 && deepest > bound {
        let text = format!(
            "the widest stroke needs {}: take smaller letters, a lighter font or a wider bit",
            number(deepest)
        );
        return Err(wrong("deepest", text));
    }
    let notes = vec![format!("The deepest place is {} below the surface.", number(deepest))];
    Ok(ToolOutput::part(entries.text("file"), part(entries, &paths, steep), notes))
}

/// The paths of the whole text.
fn set(entries: &Entries<'_>, face: &Face<'_>) -> Result<Vec<Vec<Spot>>, (&'static str, String)> {
    let size = entries.number("size");
    let capitals = face.capital_height().filter(|height| *height > 0);
    let capitals = capitals.map_or(0.7 * f64::from(face.units_per_em()), f64::from);
    let scale = size / capitals;
    let mut paths = Vec::new();
    for (row, line) in entries.text("text").split('|').enumerate() {
        let mut x = entries.number("x");
        let y = entries.number("y") - row as f64 * LEADING * size;
        for letter in line.trim().chars() {
            let unknown = || ("text", format!("{} has no letter '{letter}'", entries.text("font")));
            let glyph = face.glyph_index(letter).ok_or_else(unknown)?;
            let mut outline = Outline { scale, at: [x, y], ..Outline::default() };
            face.outline_glyph(glyph, &mut outline);
            let Some(of_letter) = middle(&outline.contours, size / 100.0) else {
                let text = format!(
                    "the outlines of '{letter}' in {} cross each other: it cannot be carved, take another font",
                    entries.text("font")
                );
                return Err(("font", text));
            };
            paths.extend(ordered(of_letter));
            x += f64::from(face.glyph_hor_advance(glyph).unwrap_or_default()) * scale;
        }
    }
    let off = entries.inches(0.0004);
    Ok(paths.into_iter().map(|path| thinned(&path, off)).collect())
}

/// The part file.
fn part(entries: &Entries<'_>, paths: &[Vec<Spot>], steep: f64) -> Vec<String> {
    let mut lines = head("Text, made by the Typesetter", entries);
    let safe = number(entries.number("safe_z"));
    lines.push(format!("'Text: {}", entries.text("text")));
    lines.push(format!("'Bit: V, {} degrees", entries.text("angle")));
    lines.push(format!("JZ,{safe}"));
    lines.push("C6".into());
    let mut ended: Option<Spot> = None;
    for path in paths {
        let goes_on = ended.zip(path.first()).is_some_and(|(a, b)| {
            a.iter().zip(b).all(|(a, b)| (a - b).abs() < entries.inches(0.0001))
        });
        for (n, [x, y, r]) in path.iter().enumerate() {
            let (x, y) = (number(*x), number(*y));
            if n == 0 && goes_on {
                continue;
            }
            if n == 0 {
                lines.extend([format!("JZ,{safe}"), format!("J2,{x},{y}")]);
            }
            lines.push(format!("M3,{x},{y},{}", number(-r * steep)));
        }
        ended = path.last().copied();
    }
    lines.push(format!("JZ,{safe}"));
    lines.push("C7".into());
    lines.extend(foot());
    lines
}

/// The outline of a letter, its curves in pieces.
#[derive(Default)]
struct Outline {
    contours: Vec<Vec<[f64; 2]>>,
    scale: f64,
    at: [f64; 2],
    /// Place of the pen, in units of the font.
    here: [f64; 2],
}

impl Outline {
    fn add(&mut self, to: [f64; 2]) {
        self.here = to;
        let placed = [0, 1].map(|i| self.at[i] + to[i] * self.scale);
        if let Some(contour) = self.contours.last_mut() {
            contour.push(placed);
        }
    }

    fn curve(&mut self, at: impl Fn(f64) -> [f64; 2]) {
        for piece in 1..=PIECES {
            self.add(at(f64::from(piece) / f64::from(PIECES)));
        }
    }
}

impl OutlineBuilder for Outline {
    fn move_to(&mut self, x: f32, y: f32) {
        self.contours.push(Vec::new());
        self.add([x, y].map(f64::from));
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.add([x, y].map(f64::from));
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        let (a, b, c) = (self.here, [x1, y1].map(f64::from), [x, y].map(f64::from));
        self.curve(|t| {
            let u = 1.0 - t;
            [0, 1].map(|i| u * u * a[i] + 2.0 * u * t * b[i] + t * t * c[i])
        });
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        let (a, b) = (self.here, [x1, y1].map(f64::from));
        let (c, d) = ([x2, y2].map(f64::from), [x, y].map(f64::from));
        self.curve(|t| {
            let u = 1.0 - t;
            let share = [u * u * u, 3.0 * u * u * t, 3.0 * u * t * t, t * t * t];
            [0, 1].map(|i| share[0] * a[i] + share[1] * b[i] + share[2] * c[i] + share[3] * d[i])
        });
    }

    fn close(&mut self) {}
}
