//! DXF files of the project's own and real ones: what is read of each is written and read again, and is the same; what
//! is broken is told with its line.

use crate::find;
use kerf_drawing::Drawing;
use kerf_formats::{Imported, Weight, dxf, rsg};
use kerf_geom::Polyarc;
use std::path::Path;
use std::{env, fs};

fn name(file: &Path) -> String {
    file.file_name().unwrap().to_string_lossy().into_owned()
}

fn read(bytes: &[u8]) -> Imported {
    dxf::read(bytes, &dxf::Options::default())
}

/// Distance between two drawings; the reason if they cannot be compared.
fn apart(a: &Drawing, b: &Drawing, flat_only: bool) -> Result<f64, String> {
    if a.shapes.len() != b.shapes.len() {
        return Err(format!("{} shapes became {}", a.shapes.len(), b.shapes.len()));
    }
    let mut most = 0.0f64;
    for (n, (old, new)) in a.shapes.iter().zip(&b.shapes).enumerate() {
        let (from, to) = (&old.path.vertices, &new.path.vertices);
        if from.len() != to.len() || old.is_closed() != new.is_closed() {
            return Err(format!("shape {} became another", n + 1));
        }
        for (k, (v, w)) in from.iter().zip(to).enumerate() {
            let bulges = if old.z_mm.is_some() && flat_only { 0.0 } else { v.bulge - w.bulge };
            let heights = old.height_mm(k) - new.height_mm(k);
            most = most.max(v.at.distance(w.at)).max(bulges.abs()).max(heights.abs());
        }
    }
    Ok(most)
}

#[test]
fn what_is_read_is_written_and_read_again() {
    for file in find::all("dxf") {
        let name = name(&file);
        let first = read(&fs::read(&file).unwrap()).drawing;
        let as_dxf = read(dxf::write(&first).as_bytes()).drawing;
        assert_eq!(apart(&first, &as_dxf, true), Ok(0.0), "{name} as DXF");
        let as_rsg = rsg::read(rsg::write(&first).as_bytes()).drawing;
        assert_eq!(apart(&first, &as_rsg, false), Ok(0.0), "{name} as RSG");
    }
}

/// Numbers that look random (SplitMix64), the same on every machine.
struct Dice(u64);

impl Dice {
    fn below(&mut self, limit: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) % limit.max(1) as u64) as usize
    }
}

/// Number of places at which a file is broken: more of a small one. `TRIES` multiplies them.
fn tries(bytes: &[u8]) -> usize {
    let times = env::var("TRIES").map_or(1, |text| text.parse().unwrap());
    times * (1_000_000 / bytes.len().max(1)).clamp(4, 40)
}

fn paths(read: &Imported) -> Vec<&Polyarc> {
    read.drawing.shapes.iter().map(|shape| &shape.path).collect()
}

/// Number of shapes that are alike at the beginning.
fn alike<'a>(a: impl Iterator<Item = &'a Polyarc>, b: impl Iterator<Item = &'a Polyarc>) -> usize {
    a.zip(b).take_while(|(a, b)| a == b).count()
}

fn is_told(read: &Imported) -> bool {
    read.findings.iter().any(|found| found.line > 0 && found.weight == Weight::Warning)
}

fn is_binary(bytes: &[u8]) -> bool {
    bytes.starts_with(b"AutoCAD Binary DXF")
}

/// The end of a file is missing: what was whole before it is read as ever, and that it is missing is told.
#[test]
fn files_that_break_off_are_read_so_far() {
    let mut dice = Dice(1);
    for file in find::all("dxf") {
        let (bytes, name) = (fs::read(&file).unwrap(), name(&file));
        let whole = read(&bytes);
        for _ in 0..tries(&bytes) {
            let end = dice.below(bytes.len());
            let part = read(&bytes[..end]);
            let same = alike(paths(&whole).into_iter(), paths(&part).into_iter());
            let others = part.drawing.shapes.len() - same;
            // What the file ends in: a shape, or the INSERT of many.
            let most = inserted(&bytes[..end]);
            assert!(others <= most, "{name} to {end}: {others} invented");
            let lost = same < whole.drawing.shapes.len() && end > begin(&bytes);
            assert!(!lost || is_told(&part), "{name} to {end}: {:?}", part.findings);
        }
    }
}

/// Offset at which the first section has begun: before that nobody knows that it is DXF.
fn begin(bytes: &[u8]) -> usize {
    bytes.windows(7).position(|word| word == b"SECTION").map_or(bytes.len(), |at| at + 10)
}

/// Most shapes that the last entity of a text may make: a polyline one, an INSERT those of its block.
fn inserted(bytes: &[u8]) -> usize {
    let tail = &bytes[bytes.len().saturating_sub(2000)..];
    if String::from_utf8_lossy(tail).contains("INSERT") { usize::MAX } else { 1 }
}

/// An entity of a text with what belongs to it, as lines counted from 0.
#[derive(Clone, Debug)]
struct Span {
    from: usize,
    to: usize,
    insert: bool,
}

/// The entities between ENTITIES and its ENDSEC.
fn spans(lines: &[&str]) -> Vec<Span> {
    let at = |n: usize| lines.get(n).map(|line| line.trim()).unwrap_or_default();
    let Some(begin) = (0..lines.len()).find(|n| at(*n) == "ENTITIES") else { return Vec::new() };
    let mut found: Vec<Span> = Vec::new();
    for n in (begin + 1..lines.len()).step_by(2) {
        if at(n) != "0" {
            continue;
        }
        if let Some(last) = found.last_mut() {
            last.to = n;
        }
        match at(n + 1) {
            "ENDSEC" => return found,
            "VERTEX" | "SEQEND" | "ATTRIB" if !found.is_empty() => {}
            kind => found.push(Span { from: n, to: n, insert: kind == "INSERT" }),
        }
    }
    Vec::new()
}

/// A line is lost, doubled or spoilt.
fn spoilt(lines: &[&str], at: usize, how: usize) -> String {
    let mut lines = lines.to_vec();
    match how {
        0 => drop(lines.remove(at)),
        1 => lines.insert(at, lines[at]),
        2 => lines[at] = "twelve",
        3 => lines[at] = "\u{7}#~ \u{fffd}",
        _ => lines[at] = "-7 ",
    }
    lines.join("\n")
}

/// One line of an entity is broken: all shapes but its own and that of the next one are as ever, at most one is
/// another than before, and whatever is lost is told.
#[test]
fn files_with_a_broken_line_lose_what_is_there() {
    let mut dice = Dice(2);
    for file in find::all("dxf") {
        let (bytes, name) = (fs::read(&file).unwrap(), name(&file));
        if is_binary(&bytes) {
            continue;
        }
        let text = String::from_utf8_lossy(&bytes).replace("\r\n", "\n");
        let (lines, plain) = (text.split('\n').collect::<Vec<_>>(), read(text.as_bytes()));
        let spans = spans(&lines);
        for _ in 0..if spans.is_empty() { 0 } else { tries(&bytes) } {
            let n = dice.below(spans.len());
            let span = &spans[n];
            let at = span.from + dice.below(span.to - span.from);
            let how = dice.below(5);
            let place = format!("{name}:{}: `{}` {how}", at + 1, lines[at]);
            let broken = read(spoilt(&lines, at, how).as_bytes());
            broken_line(&place, &plain, &broken, &spans[n..]);
        }
    }
}

fn broken_line(place: &str, plain: &Imported, broken: &Imported, near: &[Span]) {
    let (old, new) = (paths(plain), paths(broken));
    if old == new {
        return;
    }
    let many = near.iter().take(2).any(|span| span.insert);
    let head = alike(old.iter().copied(), new.iter().copied());
    let tail = alike(old[head..].iter().rev().copied(), new[head..].iter().rev().copied());
    let (lost, made) = (old.len() - head - tail, new.len() - head - tail);
    assert!(many || lost <= 2 && made <= 2, "{place}: {lost} became {made}\n{:?}", broken.findings);
    // Another number in place of a number is nothing that anybody could notice.
    let number = place.ends_with('4');
    assert!(number || is_told(broken), "{place}: {lost} became {made}, nothing told");
}
