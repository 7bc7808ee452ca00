//! LinuxCNC itself as the judge of time and path, where it is installed: the reference programs as files of its own.

use crate::references::{REFERENCES, Reference, moves};
use crate::shared::shared;
use anyhow::{Context, Result, ensure};
use kerf_motion::Move;
use kerf_motion::controllers::{Controller, LinuxCnc, Release};
use kerf_program::Axes;
use session::{PYTHON, Session, begins};
use std::fmt::Write as _;
use std::fs;
use std::process::Command;

#[path = "../../../tests/linuxcnc/session.rs"]
mod session;

/// Runs a program and tells where it was.
const FOLLOWS: &str = include_str!("../../../tests/linuxcnc/follows.py");

/// G64 P and Q of the programs, mm.
const BLEND_MM: f64 = 0.01;

/// A place belongs to a move that is no more than so many behind that of the place before.
const AHEAD: usize = 400;

type Place = [f64; 3];

/// Seconds that LinuxCNC takes for the reference programs, beside those told for it, as a table; nothing where it is not
/// installed.
pub fn table() -> Result<String> {
    let Some(folder) = shared("anchors/motion") else { return Ok(String::new()) };
    let session = match begins() {
        Ok(session) => session,
        Err(why) => {
            eprintln!("skipped: {why}");
            return Ok(String::new());
        }
    };
    let mut table = format!(
        "\nLinuxCNC itself on this computer, G64 P{BLEND_MM}, without real time: seconds, beside those that `kerf time \
         --controller linuxcnc` tells, and how far it leaves the path of the program.\n\n\
         | program | LinuxCNC | told | difference | off the path, mm |\n| --- | --- | --- | --- | --- |\n"
    );
    for Reference { name, file, .. } in REFERENCES {
        eprintln!("{name} on LinuxCNC …");
        let moves = moves(&folder.join(file).with_extension("xyz"))?;
        let (real_s, off_mm) = judged(&session, &moves)?;
        let told_s: f64 = told(&moves);
        let more = 100.0 * (told_s / real_s - 1.0);
        _ = writeln!(table, "| {name} | {real_s:.3} | {told_s:.3} | {more:+.1} % | {off_mm:.4} |");
    }
    Ok(table)
}

/// The sum of the times that the model of LinuxCNC tells.
fn told(moves: &[Move]) -> f64 {
    let (speed_mm_s, accel_mm_s2) = (Axes::splat(200.0), Axes::splat(500.0));
    let (blend_mm, same_line_mm) = (BLEND_MM, BLEND_MM);
    let linuxcnc =
        LinuxCnc { release: Release::default(), speed_mm_s, accel_mm_s2, blend_mm, same_line_mm };
    linuxcnc.seconds(moves).iter().sum()
}

/// Runs moves; returns the seconds from the first motion to the last, and the greatest distance from their path, mm.
fn judged(session: &Session, moves: &[Move]) -> Result<(f64, f64)> {
    let [first, ..] = moves else { return Ok((0.0, 0.0)) };
    let mut path = vec![first.from.first3()];
    run(session, &path)?;
    path.extend(moves.iter().map(|made| made.to.first3()));
    let seen = run(session, &path[1..])?;
    let (Some(begin), Some(end)) = (seen.first(), seen.last()) else { return Ok((0.0, 0.0)) };
    let places: Vec<Place> = seen.iter().map(|(_, place)| *place).collect();
    Ok((end.0 - begin.0, off_mm(&places, &path)))
}

/// Runs a program through places at 100 mm/s; returns where it was at which second.
fn run(session: &Session, places: &[Place]) -> Result<Vec<(f64, Place)>> {
    let file = session.folder.path().join("program.ngc");
    let mut text = format!("%\nG21 G90 G94 G17 G64 P{BLEND_MM} Q{BLEND_MM}\nF6000\n");
    for [x, y, z] in places {
        _ = writeln!(text, "G53 G1 X{x:.5} Y{y:.5} Z{z:.5}");
    }
    fs::write(&file, text + "%\n")?;
    let followed = Command::new(PYTHON).args(["-c", FOLLOWS]).arg(&file).output()?;
    ensure!(followed.status.success(), "{}", String::from_utf8_lossy(&followed.stderr));
    String::from_utf8(followed.stdout)?.lines().map(sample).collect()
}

fn sample(line: &str) -> Result<(f64, Place)> {
    let numbers: Vec<f64> =
        line.split(' ').map(str::parse).collect::<Result<_, _>>().context("no place")?;
    let [second, x, y, z] = numbers[..] else { anyhow::bail!("no place: {line}") };
    Ok((second, [x, y, z]))
}

/// The greatest distance of places that follow a path from it, mm.
fn off_mm(places: &[Place], path: &[Place]) -> f64 {
    let (mut at, mut greatest_mm) = (0, 0.0_f64);
    for place in places {
        let near = path.windows(2).enumerate().skip(at).take(AHEAD);
        let near = near.map(|(k, ends)| (distance_mm(*place, ends[0], ends[1]), k));
        let Some((mm, k)) = near.min_by(|a, b| a.0.total_cmp(&b.0)) else { continue };
        (at, greatest_mm) = (k, greatest_mm.max(mm));
    }
    greatest_mm
}

/// Distance of a place from a straight line between two others.
fn distance_mm(place: Place, from: Place, to: Place) -> f64 {
    let minus = |a: Place, b: Place| [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
    let dot = |a: Place, b: Place| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let (way, to_place) = (minus(to, from), minus(place, from));
    let length = dot(way, way);
    let share = if length > 0.0 { (dot(to_place, way) / length).clamp(0.0, 1.0) } else { 0.0 };
    let rest = minus(to_place, way.map(|mm| share * mm));
    dot(rest, rest).sqrt()
}
