//! Zeroing: the display changes, the machine does not move.

use kerf_ledger::{Run, at, run, sbp};

const ALL: &str = " ⏎ PRINT %(1);\" \";%(2);\" \";%(3);\" \";%(4);\" \";%(5) \
     ⏎ PRINT %(6);\" \";%(7);\" \";%(8);\" \";%(9);\" \";%(10)";

/// Zeroes at (1,2,3,4,5) on five axes; then the locations, and base minus working.
fn zeroed(command: &str) -> Run {
    let from = [1.0, 2.0, 3.0, 4.0, 5.0];
    sbp(&format!("{command}{ALL}")).axes(5).at(from).run()
}

#[test]
fn sbp_cmd_zx() {
    zeroed("ZX").visits::<3>(&[]).prints(&["0 2 3 4 5", "1 0 0 0 0"]);
    run("ZX,1").fails(1, "S009");
}

#[test]
fn sbp_cmd_zy() {
    zeroed("ZY").visits::<3>(&[]).prints(&["1 0 3 4 5", "0 2 0 0 0"]);
}

#[test]
fn sbp_cmd_zz() {
    zeroed("ZZ").visits::<3>(&[]).prints(&["1 2 0 4 5", "0 0 3 0 0"]);
}

#[test]
fn sbp_cmd_za() {
    zeroed("ZA").visits::<3>(&[]).prints(&["1 2 3 0 5", "0 0 0 4 0"]);
}

#[test]
fn sbp_cmd_zb() {
    zeroed("ZB").visits::<3>(&[]).prints(&["1 2 3 4 0", "0 0 0 0 5"]);
}

#[test]
fn sbp_cmd_z2() {
    zeroed("Z2").visits::<3>(&[]).prints(&["0 0 3 4 5", "1 2 0 0 0"]);
}

#[test]
fn sbp_cmd_z3() {
    zeroed("Z3").visits::<3>(&[]).prints(&["0 0 0 4 5", "1 2 3 0 0"]);
}

#[test]
fn sbp_cmd_z4() {
    zeroed("Z4").visits::<3>(&[]).prints(&["0 0 0 0 5", "1 2 3 4 0"]);
}

#[test]
fn sbp_cmd_z5() {
    zeroed("Z5").visits::<3>(&[]).prints(&["0 0 0 0 0", "1 2 3 4 5"]);
}

#[test]
fn sbp_cmd_zt() {
    // Base minus working: working stays, base becomes 0.
    at([1.0, 2.0, 3.0], "VA,,,,,,9,9,9 ⏎ ZT ⏎ PRINT %(1);\" \";%(6);\" \";%(7);\" \";%(8)")
        .visits::<3>(&[])
        .prints(&["1 -1 -2 -3"]);
    at([1.0, 2.0, 3.0], "ZT ⏎ ST").ends_at([0.0, 0.0, 0.0]);
}

#[test]
fn sbp_cmd_uz() {
    at([1.0, 2.0, 3.0], "VA,,,,,,4,5,6 ⏎ UZ ⏎ PRINT %(1);%(2);%(3);%(6);%(7);%(8)")
        .prints(&["000000"]);
}

#[test]
fn sbp_cmd_z_infile() {
    sbp("M2,10,4 ⏎ FP,p.sbp,,,,,2 ⏎ PRINT %(1);\" \";%(1)+%(6)")
        .file("p.sbp", "MX,1 ⏎ ZX ⏎ MX,1")
        .run()
        .is_ok()
        .prints(&["1 12"]);
}
