//! Rings: known answers, and what must hold for every region.

use crate::random::{check_cleared, random_case, seeds};
use kerf_geom::{Offsetter, Point2, Polyarc, Transform2, Vec2};
use kerf_pocket::{CutDirection, Cutter, rings};

fn p(x: f64, y: f64) -> Point2 {
    Point2::new(x, y)
}

#[test]
fn a_rectangle_is_cleared_by_one_path() {
    let region = [Polyarc::rectangle(p(0., 0.), p(100., 60.))];
    let cutter = Cutter::new(5.0, 0.1).unwrap();
    let paths =
        rings(&region, &cutter, CutDirection::default(), &Offsetter::default()).unwrap().paths;
    assert_eq!(paths.len(), 1);
    check_cleared("rectangle", &region, &paths, &cutter);
}

#[test]
fn random_regions_are_cleared() {
    let offsetter = Offsetter::default();
    for seed in seeds(25) {
        let (region, cutter) = random_case(seed);
        let way = CutDirection { climb: seed % 2 == 0, outward: seed % 3 == 0 };
        let paths = rings(&region, &cutter, way, &offsetter)
            .unwrap_or_else(|e| panic!("{seed}: {e}"))
            .paths;
        check_cleared(&format!("seed {seed}"), &region, &paths, &cutter);
    }
}

/// The paths of a region do not depend on where its contours begin and where it lies.
#[test]
fn a_region_is_cleared_wherever_it_lies() {
    let island = Polyarc::circle(p(18., 14.), 4.0).reversed();
    let wall = Polyarc::rounded_rectangle(p(0., 0.), p(40., 24.), 5.0);
    let clear = |region: &[Polyarc], scale: f64| {
        let cutter = Cutter::new(3.0 * scale, 0.3 * scale).unwrap();
        let paths =
            rings(region, &cutter, CutDirection::default(), &Offsetter::default()).unwrap().paths;
        check_cleared("moved", region, &paths, &cutter);
        (paths.len(), paths.iter().map(Polyarc::length).sum::<f64>() / scale)
    };
    let (count, long) = clear(&[wall.clone(), island.clone()], 1.0);
    let same = |map: &dyn Fn(&Polyarc) -> Polyarc, scale: f64| {
        // Which of two equal ways the tour takes may depend on the last digit.
        let (n, length) = clear(&[map(&wall), map(&island)], scale);
        assert!(
            n == count && (length - long).abs() < 0.1 * long,
            "{n} {length}, not {count} {long}"
        );
    };
    let mirror = Transform2::mirrored(p(1., 2.), Vec2::new(3., 1.));
    same(&|path| path.similar(&mirror).reversed(), 1.0);
    same(&|path| path.similar(&Transform2::moved(Vec2::new(1234.5, -987.25))), 1.0);
    same(&|path| path.similar(&Transform2::turned(p(5., 5.), 0.7)), 1.0);
    same(&|path| path.similar(&Transform2::scaled(p(5., 5.), 25.4, 25.4)), 25.4);
    same(&|path| path.started_at(&path.place_after(path.length() * 0.37).unwrap()), 1.0);
}
