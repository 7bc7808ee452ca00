//! Behind a change of tools a part file comes down to the height that the G-code goes on at.

use crate::support::{GENERIC, SBP, converted, plain};
use kerf_program::settings::LinearUnit;

#[test]
fn a_program_that_ends_behind_a_change_of_tools_is_converted() {
    let end = "G21 G90 F600\n#1=3\nG0 X#1 Y2 Z5\nG1 Z-1\nT2 M6\n";
    for last in ["G92 Z2\nM2\n", "#2=#5422\nM2\n", "T3 M6\nG92 Z2\nT4 M6\n#2=#5422\nM2\n"] {
        for keep_variables in [false, true] {
            let mut how = plain(GENERIC, SBP, LinearUnit::Mm);
            how.keep_variables = keep_variables;
            let text = format!("{end}{last}");
            let made = converted("part.nc", text.as_bytes(), &how, ".".into());
            let part = made.text.unwrap_or_default();
            let kept = part.contains("&p1 = 3");
            assert!(part.contains("C9\n"), "{text}{:?}", made.diagnostics);
            assert_eq!(kept, keep_variables, "{text}{:?}", made.diagnostics);
        }
    }
}
