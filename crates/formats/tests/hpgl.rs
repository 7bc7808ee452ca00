//! Plotter files that are broken: read as far as sense goes, never a panic.

use kerf_formats::hpgl;
use proptest::prelude::*;

const PLOT: &str = "IN;IP0,0,4000,4000;SC0,100,0,100;SP1;PU10,10;PD20,10,20,20;AA30,20,90;PU;CI5;\
    EA90,90;PM0;PD1,2,3,4;PM1;CI2;PM2;FP;LBtext\u{3};PE<=abAB:c;SP2;PR;PD5,5,-5,-5;AT1,1,2,0;RO90;PU";

proptest! {
    #[test]
    fn a_plotter_file_with_other_bytes_is_read(
        changes in prop::collection::vec((0usize..200, any::<u8>()), 0..30),
        length in 0usize..220,
    ) {
        let mut bytes = PLOT.as_bytes().to_vec();
        for (at, byte) in changes {
            if let Some(old) = bytes.get_mut(at) {
                *old = byte;
            }
        }
        bytes.truncate(length);
        let read = hpgl::read(&bytes);
        for shape in &read.drawing.shapes {
            prop_assert!(shape.path.vertices.iter().all(|v| v.at.x.is_finite() && v.at.y.is_finite()));
        }
    }
}

#[test]
fn numbers_beyond_measure_are_read() {
    let read = hpgl::read(b"IN;SC0,1e-300,0,1;PU0,0;PD1e300,1;CI1e300;AA1e300,1,360;SC1,2;PU99999999999999999999,1;PD1,1;PU");
    assert!(read.drawing.shapes.len() < 20);
}
