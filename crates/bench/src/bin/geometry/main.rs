//! Offsets measured beside those of other programs, in one run on one machine: speed, vertices, area.
//! `make bench-geometry` builds and runs it; `--geos N` compares N shapes of every hard family with GEOS, where
//! Python has shapely; `--prove N` counts the offsets of N shapes of each that fail their check. `--only WORD`
//! takes the cases or families whose name contains a word, `--by NAME` one of
//! the programs, `--from SEED` other shapes.
#![allow(clippy::print_stdout)]

#[path = "../../../../geom/tests/families/mod.rs"]
mod families;
mod geos;
mod peers;
mod prove;
mod shapes;
#[allow(dead_code)]
#[path = "../../usage.rs"]
mod usage;

use anyhow::Result;
use kerf_geom::{Indexed, Offsetter, Polyarc};

/// Result of an offset: rings, vertices, area.
#[derive(Clone, Copy, Debug, Default)]
pub struct Outcome {
    rings: usize,
    vertices: usize,
    area: f64,
}

impl Outcome {
    fn add(&mut self, vertices: usize, area: f64) {
        self.rings += 1;
        self.vertices += vertices;
        self.area += area;
    }
}

fn main() -> Result<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let value = |name: &str| arguments.get(arguments.iter().position(|a| a == name)? + 1);
    let number = |name: &str| value(name)?.parse::<u64>().ok();
    let word = value("--only").map_or("", |word| word);
    let by = value("--by").map_or("", |by| by);
    if let Some(count) = number("--geos") {
        return geos::compare(count, word);
    }
    if let Some(count) = number("--prove") {
        prove::families(count, word, number("--from").unwrap_or_default());
        return Ok(());
    }
    println!(
        "| case | by | milliseconds (least of runs) | rings | vertices | area mm² | deviation mm |"
    );
    println!("|---|---|---|---|---|---|---|");
    let offsetter = Offsetter::default();
    for case in shapes::cases().iter().filter(|case| case.name.contains(word)) {
        for (name, offset) in peers::ALL.iter().filter(|peer| peer.0.contains(by)) {
            let (time, outcome) = timed(|| offset(&offsetter, &case.contours, case.distance, None));
            let Outcome { rings, vertices, area } = outcome;
            let off = case.contours.iter().map(|contour| {
                let (alone, mut kept) = (std::slice::from_ref(contour), Vec::new());
                offset(&offsetter, alone, case.distance, Some(&mut kept));
                deviation(alone, case.distance, &kept)
            });
            let off = off.fold(0.0, f64::max);
            println!(
                "| {} | {name} | {time:.3} | {rings} | {vertices} | {area:.3} | {off:.0e} |",
                case.name
            );
        }
        if "GEOS".contains(by) {
            geos::time(case)?;
        }
    }
    Ok(())
}

/// Shares of a segment at which it is looked how far it is off.
const SHARES: [f64; 4] = [0.0, 0.25, 0.5, 0.75];

/// Returns the greatest deviation of places of offset rings from their distance to the contours.
fn deviation(contours: &[Polyarc], distance: f64, rings: &[Polyarc]) -> f64 {
    let indexed = Indexed::new(contours);
    let off = |place| indexed.nearest(place).map_or(f64::NAN, |(_, foot)| foot.distance);
    let segments = rings.iter().flat_map(Polyarc::segments);
    let places = segments.flat_map(|segment| SHARES.map(|share| segment.at(share)));
    places.map(|place| (off(place) - distance.abs()).abs()).fold(0.0, f64::max)
}

/// Processor time so far, seconds: what passes on an idle machine.
fn processor_s() -> f64 {
    usage::own().map_or(0.0, |own| own.cpu_s)
}

/// The least time of several runs in milliseconds. Short runs are repeated within one measurement.
fn timed(run: impl Fn() -> Outcome) -> (f64, Outcome) {
    let mut outcome = run();
    let mut repeats = 1;
    let mut least = f64::INFINITY;
    for _ in 0..7 {
        loop {
            let begun = processor_s();
            for _ in 0..repeats {
                outcome = run();
            }
            let took = processor_s() - begun;
            if took > 0.02 {
                least = least.min(took / f64::from(repeats) * 1e3);
                break;
            }
            repeats *= 4;
        }
    }
    (least, outcome)
}

/// Places along a polyarc, chords nowhere farther from an arc than `tolerance`.
pub fn flattened(path: &Polyarc, tolerance: f64) -> Vec<[f64; 2]> {
    let mut places = Vec::new();
    for segment in path.segments() {
        let arc = segment.arc().map_or((0.0, 0.0), |a| (a.radius(), a.sweep_rad.abs()));
        // A chord over an angle u lies r(1 − cos(u/2)) off its arc.
        let step = 2.0 * (1.0 - (tolerance / arc.0.max(tolerance)).min(1.0)).acos();
        let chords = if arc.1 > 0.0 { (arc.1 / step).ceil().max(1.0) as usize } else { 1 };
        places
            .extend((0..chords).map(|k| segment.at(k as f64 / chords as f64)).map(|p| [p.x, p.y]));
    }
    places
}
