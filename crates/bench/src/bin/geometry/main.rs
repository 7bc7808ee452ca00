//! Offsets measured beside those of other programs, in one run on one machine: speed, vertices, area.
//! `make bench-geometry` builds and runs it; `--geos N` compares N shapes of every hard family with GEOS, where
//! Python has shapely; `--prove N` counts the offsets of N shapes of each that fail their check. `--only WORD`
//! takes the cases or families whose name contains a word, `--by NAME` one of
//! the programs, `--from SEED` other shapes.
#![allow(clippy::print_stdout)]

#[path = "../../../../geom/tests/families/mod.rs"]
mod families;
mod flattened;
mod geos;
mod outcome;
mod peers;
mod prove;
mod shapes;
mod timed;
#[allow(dead_code)]
#[path = "../../usage.rs"]
mod usage;

use anyhow::Result;
use kerf_geom::{Indexed, Offsetter, Polyarc};
use outcome::Outcome;
use timed::timed;

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
