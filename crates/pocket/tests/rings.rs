//! Rings: known answers, and what must hold for every region.
#![allow(clippy::unwrap_used)]

mod check;
#[path = "../../geom/tests/families/mod.rs"]
mod families;
mod random;

use kerf_geom::{Point2, Polyarc};
use kerf_pocket::{Cutter, Way, rings};
use random::{check_cleared, random_case, seeds};

fn p(x: f64, y: f64) -> Point2 {
    Point2::new(x, y)
}

#[test]
fn a_rectangle_is_cleared_by_one_path() {
    let region = [Polyarc::rectangle(p(0., 0.), p(100., 60.))];
    let cutter = Cutter::new(5.0, 0.1).unwrap();
    let paths = rings(&region, &cutter, Way::default()).unwrap().paths;
    assert_eq!(paths.len(), 1);
    check_cleared("rectangle", &region, &paths, &cutter);
}

#[test]
fn random_regions_are_cleared() {
    for seed in seeds() {
        let (region, cutter) = random_case(seed);
        let way = Way { climb: seed % 2 == 0, outward: seed % 3 == 0 };
        let paths = rings(&region, &cutter, way).unwrap_or_else(|e| panic!("{seed}: {e}")).paths;
        check_cleared(&format!("seed {seed}"), &region, &paths, &cutter);
    }
}
