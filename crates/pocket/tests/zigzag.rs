//! Zigzags: known answers, and what must hold for every region.

use crate::random::{check_cleared, random_case, seeds};
use kerf_geom::{Offsetter, Point2, Polyarc};
use kerf_pocket::{Cutter, Zigzag, zigzag};

#[test]
fn a_rectangle_is_cleared_by_one_path() {
    let region = [Polyarc::rectangle(Point2::new(0., 0.), Point2::new(100., 60.))];
    let cutter = Cutter::new(5.0, 1.0).unwrap();
    for (angle_deg, finish_mm) in [(0.0, 0.0), (90.0, 0.5), (30.0, 2.5)] {
        let lines = Zigzag { angle_deg, finish_mm, climb: true };
        let paths = zigzag(&region, &cutter, &lines, &Offsetter::default()).unwrap().paths;
        assert_eq!(paths.len(), 1, "{lines:?}");
        check_cleared(&format!("{lines:?}"), &region, &paths, &cutter);
    }
}

#[test]
fn a_finish_out_of_bounds_is_refused() {
    let region = [Polyarc::rectangle(Point2::new(0., 0.), Point2::new(100., 60.))];
    let lines = Zigzag { finish_mm: 3.0, ..Zigzag::default() };
    let told = zigzag(&region, &Cutter::new(5.0, 1.0).unwrap(), &lines, &Offsetter::default())
        .unwrap_err()
        .to_string();
    assert!(told.starts_with("the finish is 3 mm"), "{told}");
}

#[test]
fn random_regions_are_cleared() {
    let offsetter = Offsetter::default();
    for seed in seeds(25) {
        let (region, cutter) = random_case(seed);
        let finish_mm = cutter.radius_mm() * [0.0, 0.3, 1.0][seed as usize % 3];
        let lines = Zigzag { angle_deg: seed as f64 * 17.0, finish_mm, climb: seed % 2 == 0 };
        let paths = zigzag(&region, &cutter, &lines, &offsetter)
            .unwrap_or_else(|e| panic!("{seed}: {e}"))
            .paths;
        check_cleared(&format!("seed {seed}"), &region, &paths, &cutter);
    }
}
