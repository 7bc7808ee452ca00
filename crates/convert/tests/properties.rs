//! Random part files: what is converted moves as before, there and back, arcs as arcs.

use crate::support::{GENERIC, GRBL, LINUXCNC, SBP, converted, plain};
use kerf_program::settings::LinearUnit;
use proptest::prelude::*;

/// A line of a part file; numbers are hundredths.
fn line() -> impl Strategy<Value = String> {
    let place = || (-900..900i32).prop_map(|n| format!("{}", f64::from(n) / 100.0));
    let some = || prop_oneof![3 => place(), 1 => Just(String::new())];
    let size = || (30..900i32).prop_map(|n| format!("{}", f64::from(n) / 100.0));
    let speed = || (130..400i32).prop_map(|n| format!("{}", f64::from(n) / 100.0));
    prop_oneof![
        (some(), some()).prop_map(|(x, y)| format!("M2,{x},{y}")),
        (some(), some(), some()).prop_map(|(x, y, z)| format!("M3,{x},{y},{z}")),
        (some(), some(), some()).prop_map(|(x, y, z)| format!("J3,{x},{y},{z}")),
        place().prop_map(|z| format!("MZ,{z}")),
        (speed(), speed()).prop_map(|(xy, z)| format!("VS,{xy},{z}")),
        (size(), 0..360i32, 1..720i32).prop_map(|(d, b, s)| format!("CC,{d},T,1,{b},{}", b + s)),
        (size(), place(), place(), prop_oneof![Just(0), Just(3), Just(4)]).prop_map(
            // The cutter of the settings is 1/4 inch; T takes any size.
            |(d, x, y, f)| format!("CP,{d},{x},{y},T,-1,0,360,-0.1,2,1,1,{f},0,0")
        ),
        (size(), size(), 1..5i32).prop_map(|(x, y, c)| format!("CR,{x},{y},O,1,{c},-0.1,2")),
        (place(), place(), place()).prop_map(|(i, j, p)| format!("CG,,,,{i},{j},T,1,{p},1,,,3,1")),
        (place(), place()).prop_map(|(x, y)| format!("VA,{x},{y}")),
        (1..13i32, 0..2i32).prop_map(|(n, on)| format!("SO,{n},{on}")),
        Just("PAUSE 0.5".to_string()),
        Just("Z2".to_string()),
        Just("'a comment".to_string()),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, ..ProptestConfig::default() })]

    #[test]
    fn any_part_file_there_and_back(
        lines in prop::collection::vec(line(), 1..25),
        mm in any::<bool>(),
        dialect in 0..3usize,
    ) {
        let text = lines.join("\n");
        let unit = if mm { LinearUnit::Mm } else { LinearUnit::Inch };
        let to = [LINUXCNC, GRBL, GENERIC][dialect];
        let there = converted("any.sbp", text.as_bytes(), &plain(SBP, to, unit), ".".into());
        let wrong = there.diagnostics.iter().find(|d| d.code == kerf_diag::Code::ConversionDiffers);
        prop_assert!(wrong.is_none(), "{:?}\n{}", wrong, text);
        // A file that does not run is not converted.
        let Some(gcode) = there.text else { return Ok(()) };
        let back = converted("any.nc", gcode.as_bytes(), &plain(to, SBP, unit), ".".into());
        prop_assert!(back.text.is_some(), "{:?}\n{}\n{}", back.diagnostics, text, gcode);
    }
}
