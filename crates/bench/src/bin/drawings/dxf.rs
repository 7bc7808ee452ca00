//! A DXF file of 9.4 MB: polylines with arcs, circles, arcs and lines on five layers.

use crate::plates::Dice;
use crate::row::Row;
use crate::timed::timed;
use anyhow::{Context, Result};
use std::fmt::Write as _;
use std::process::Command;

/// Shapes of the file.
const SHAPES: usize = 15_900;

/// Milliseconds that are asked for.
const GOAL_MS: f64 = 100.0;

pub fn measure() -> Result<Vec<Row>> {
    let text = file();
    let (read, ms) = timed(5, || {
        kerf_formats::dxf::read(text.as_bytes(), &kerf_formats::dxf::Options::default())
    });
    let what = format!("DXF of {:.1} MB", text.len() as f64 / 1e6);
    let shapes = |count: usize| format!("{count} shapes");
    let mut rows = vec![
        Row::new(&what, "Kerf", shapes(read.drawing.shapes.len()), ms)
            .asked("≤ 100 ms", ms <= GOAL_MS),
    ];
    let (read, ms) = timed(3, || ::dxf::Drawing::load(&mut text.as_bytes()));
    rows.push(Row::new(&what, "crate dxf", shapes(read?.entities().count()), ms));
    rows.extend(ezdxf(&text, &what)?);
    Ok(rows)
}

/// The same by ezdxf; nothing where Python does not have it.
fn ezdxf(text: &str, what: &str) -> Result<Option<Row>> {
    let file = tempfile::Builder::new().suffix(".dxf").tempfile()?;
    std::fs::write(file.path(), text).context("cannot write the drawing")?;
    let script = "import sys,time,ezdxf\nb=time.process_time()\nd=ezdxf.readfile(sys.argv[1])\n\
                  n=len(d.modelspace())\nprint(n, (time.process_time()-b)*1e3)";
    let Ok(run) = Command::new("python3").args(["-c", script]).arg(file.path()).output() else {
        return Ok(None);
    };
    let told = String::from_utf8_lossy(&run.stdout).into_owned();
    if let [shapes, ms] = told.split_whitespace().collect::<Vec<_>>()[..] {
        let ms: f64 = ms.parse()?;
        return Ok(Some(Row::new(what, "ezdxf", format!("{shapes} shapes"), ms)));
    }
    Ok(None)
}

/// Release 2000, which has light polylines.
const HEAD: &str = "  0\nSECTION\n  2\nHEADER\n  9\n$ACADVER\n  1\nAC1015\n  0\nENDSEC\n  0\nSECTION\n  2\nENTITIES\n";

fn file() -> String {
    let mut dice = Dice::new(9);
    let mut text = String::from(HEAD);
    for n in 0..SHAPES {
        let (x, y) = (dice.between(0.0, 3000.0), dice.between(0.0, 2000.0));
        let layer = n % 5;
        match n % 4 {
            0 | 1 => polyline(&mut text, &mut dice, layer, x, y),
            2 => {
                let radius = dice.between(1.0, 40.0);
                let _ = write!(
                    text,
                    "  0\nCIRCLE\n100\nAcDbEntity\n  8\nLAYER{layer}\n100\nAcDbCircle\n 10\n{x:.6}\n 20\n{y:.6}\n 40\n{radius:.6}\n"
                );
            }
            _ => {
                let (u, v) = (x + dice.between(-50.0, 50.0), y + dice.between(1.0, 50.0));
                let _ = write!(
                    text,
                    "  0\nLINE\n100\nAcDbEntity\n  8\nLAYER{layer}\n100\nAcDbLine\n 10\n{x:.6}\n 20\n{y:.6}\n \
                     11\n{u:.6}\n 21\n{v:.6}\n"
                );
            }
        }
    }
    text + "  0\nENDSEC\n  0\nEOF\n"
}

fn polyline(text: &mut String, dice: &mut Dice, layer: usize, x: f64, y: f64) {
    let count = 28;
    let _ = write!(
        text,
        "  0\nLWPOLYLINE\n100\nAcDbEntity\n  8\nLAYER{layer}\n100\nAcDbPolyline\n 90\n{count}\n 70\n1\n"
    );
    for n in 0..count {
        let angle = n as f64 / count as f64 * std::f64::consts::TAU;
        let radius = dice.between(8.0, 12.0);
        let (u, v) = (x + radius * angle.cos(), y + radius * angle.sin());
        let _ = write!(text, " 10\n{u:.6}\n 20\n{v:.6}\n");
        if n % 3 == 0 {
            let _ = write!(text, " 42\n{:.6}\n", dice.between(-0.4, 0.4));
        }
    }
}
