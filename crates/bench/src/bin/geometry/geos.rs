//! GEOS through Python's shapely, where it is installed: a peer in the table and a second opinion.

use crate::families::FAMILIES;
use crate::flattened::flattened;
use crate::shapes::Case;
use anyhow::{Context, Result};
use kerf_geom::{OffsetPath, Polyarc};
use serde_json::{Value, json};
use std::fmt;
use std::io::{BufRead, BufReader, Write};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

const SCRIPT: &str = include_str!("geos.py");

/// Chords of the comparison, far below what is looked for.
const CHORD_MM: f64 = 5e-5;

/// A running Python.
struct Geos {
    child: Child,
    to: Option<ChildStdin>,
    from: BufReader<ChildStdout>,
}

impl Geos {
    /// Nothing where there is no Python with shapely; said once.
    fn start() -> Result<Option<Self>> {
        let there =
            Command::new("python3").args(["-c", "import shapely"]).stderr(Stdio::null()).status();
        if !there.is_ok_and(|status| status.success()) {
            println!("(no GEOS here: `pip install shapely` would add it)");
            return Ok(None);
        }
        let mut child = Command::new("python3")
            .args(["-c", SCRIPT])
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .context("python3")?;
        let to = child.stdin.take();
        let from = BufReader::new(child.stdout.take().context("output of python3")?);
        Ok(Some(Self { child, to, from }))
    }

    fn ask(&mut self, question: &Value) -> Result<Value> {
        let to = self.to.as_mut().context("input of python3")?;
        writeln!(to, "{question}").context("to GEOS")?;
        let mut line = String::new();
        self.from.read_line(&mut line).context("from GEOS")?;
        serde_json::from_str(&line).context("an answer of GEOS")
    }
}

impl Drop for Geos {
    fn drop(&mut self) {
        drop(self.to.take());
        let _ = self.child.wait();
    }
}

fn number(answer: &Value, name: &str) -> f64 {
    answer[name].as_f64().unwrap_or(f64::NAN)
}

/// A row of the table.
pub fn time(case: &Case) -> Result<()> {
    let Some(mut geos) = Geos::start()? else { return Ok(()) };
    let contours: Vec<_> = case.contours.iter().map(|c| flattened(c, 0.001)).collect();
    let step = 2.0 * (2.0 * 0.001 / case.distance.abs()).sqrt();
    let quadrant = (std::f64::consts::FRAC_PI_2 / step).ceil() as usize;
    let question = json!({"do": "time", "contours": contours, "distance": case.distance, "quadrant": quadrant});
    let a = geos.ask(&question)?;
    let (ms, area) = (number(&a, "ms"), number(&a, "area"));
    println!(
        "| {} | GEOS | {ms:.3} | {} | {} | {area:.3} | {:.0e} |",
        case.name,
        a["rings"],
        a["vertices"],
        number(&a, "deviation")
    );
    Ok(())
}

/// Every family against GEOS. Where they differ by something thicker than a thousandth of the offset, places there
/// are held against the definition: their distance to the lines and arcs of the shape tells who is wrong.
pub fn compare(count: u64, word: &str) -> Result<()> {
    let Some(mut geos) = Geos::start()? else { return Ok(()) };
    println!(
        "| family | shapes | Kerf wrong | GEOS wrong | undecided | not proved | worst distance / offset | worst area error / (perimeter × offset) |"
    );
    println!("|---|---|---|---|---|---|---|---|");
    for (name, make) in FAMILIES.iter().filter(|family| family.0.contains(word)) {
        let mut tally = Tally::default();
        for seed in 0..count {
            let (shape, distance) = make(seed);
            let Ok(found) = kerf_geom::offset(&shape, distance) else {
                tally.not_proved += 1;
                continue;
            };
            let answer = geos.ask(&question(&shape, distance, &found))?;
            let size = distance.abs();
            if let Some(told) = tally.add(&answer, size, shape.length() * size) {
                println!("{name} {seed}: {told}");
            }
        }
        println!("| {name} | {count} | {tally} |");
    }
    Ok(())
}

/// A shape, the curves by which it is offset, and what GEOS needs to judge both.
fn question(shape: &Polyarc, distance: f64, found: &[OffsetPath]) -> Value {
    let clockwise = shape.signed_area() < 0.0;
    // Shapes that run clockwise grow to the left.
    let outward = distance * shape.signed_area().signum();
    let ccw = |path: &Polyarc| if clockwise { path.reversed() } else { path.clone() };
    let rings: Vec<_> = found.iter().map(|f| flattened(&ccw(&f.path), CHORD_MM)).collect();
    let vertices: Vec<_> = shape.vertices.iter().map(|v| [v.at.x, v.at.y, v.bulge]).collect();
    json!({"do": "compare", "contours": [flattened(shape, CHORD_MM)], "vertices": vertices,
        "distance": outward, "rings": rings, "allowed": 1e-3 * distance.abs(), "chord": CHORD_MM})
}

/// Counts of the comparison of a family.
#[derive(Default)]
struct Tally {
    ours: u32,
    theirs: u32,
    undecided: u32,
    not_proved: u32,
    worst_distance: f64,
    worst_area: f64,
}

impl Tally {
    /// Counts an answer; what there is to tell of a shape on which the engines differ.
    fn add(&mut self, answer: &Value, size: f64, strip: f64) -> Option<String> {
        let decided = answer["decided"].as_array().map_or(&[][..], Vec::as_slice);
        if decided.is_empty() {
            self.worst_distance = self.worst_distance.max(number(answer, "distance") / size);
            self.worst_area = self.worst_area.max(number(answer, "wrong") / strip);
            return None;
        }
        let right = |who: &str| decided.iter().filter(|place| place["right"] == who).count();
        let (kerf, geos) = (right("Kerf"), right("GEOS"));
        self.ours += u32::from(geos > 0);
        self.theirs += u32::from(geos == 0 && kerf > 0);
        self.undecided += u32::from(geos + kerf == 0);
        let (area, first) = (number(answer, "wrong"), &decided[0]);
        Some(format!(
            "they differ by {area:.4} mm²; of {} places there Kerf is right about {kerf}, GEOS about {geos}; {} is {} mm off the shape, offset {size}",
            decided.len(),
            first["at"],
            first["far"]
        ))
    }
}

impl fmt::Display for Tally {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { ours, theirs, undecided, not_proved, worst_distance, worst_area } = self;
        write!(
            f,
            "{ours} | {theirs} | {undecided} | {not_proved} | {worst_distance:.1e} | {worst_area:.1e}"
        )
    }
}
