//! GEOS through Python's shapely, where it is installed: a peer in the table and a second opinion.

use crate::families::FAMILIES;
use crate::flattened;
use crate::shapes::Case;
use anyhow::{Context, Result};
use kerf_geom::Polyarc;
use serde_json::{Value, json};
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

/// Every family against GEOS: a difference thicker than a thousandth of the offset is a wrong offset.
pub fn compare(count: u64, word: &str) -> Result<()> {
    let Some(mut geos) = Geos::start()? else { return Ok(()) };
    println!(
        "| family | shapes | wrong | not proved | worst distance / offset | worst area error / (perimeter × offset) |"
    );
    println!("|---|---|---|---|---|---|");
    for (name, make) in FAMILIES.iter().filter(|family| family.0.contains(word)) {
        let (mut wrong, mut failed) = (0, 0);
        let (mut worst_distance, mut worst_area) = (0.0f64, 0.0f64);
        for seed in 0..count {
            let (shape, distance) = make(seed);
            let Ok(found) = kerf_geom::offset(&shape, distance) else {
                failed += 1;
                continue;
            };
            // Shapes that run clockwise grow to the left.
            let outward = distance * shape.signed_area().signum();
            let ccw = |path: &Polyarc| {
                if shape.signed_area() < 0.0 { path.reversed() } else { path.clone() }
            };
            let rings: Vec<_> = found.iter().map(|f| flattened(&ccw(&f.path), CHORD_MM)).collect();
            let allowed = 1e-3 * distance.abs();
            let question = json!({"do": "compare", "contours": [flattened(&shape, CHORD_MM)],
                "distance": outward, "rings": rings, "allowed": allowed});
            let answer = geos.ask(&question)?;
            if answer["thick"].as_bool() != Some(false) {
                wrong += 1;
                println!("{name} {seed}: differs from GEOS: {answer}");
            }
            let perimeter = shape.length() * distance.abs();
            worst_area = worst_area.max(number(&answer, "wrong") / perimeter);
            worst_distance = worst_distance.max(number(&answer, "distance") / distance.abs());
        }
        println!(
            "| {name} | {count} | {wrong} | {failed} | {worst_distance:.1e} | {worst_area:.1e} |"
        );
    }
    Ok(())
}
