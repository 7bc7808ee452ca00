//! System variables: what `%(n)` reads.

use kerf_ledger::{run, sbp};

/// After a program, these system variables read so.
#[track_caller]
fn reads(program: &str, expected: &[(u32, &str)]) {
    let prints: Vec<String> = expected.iter().map(|(n, _)| format!("PRINT %({n})")).collect();
    let program = format!("{program} ⏎ {}", prints.join(" ⏎ "));
    let expected: Vec<&str> = expected.iter().map(|(_, text)| *text).collect();
    run(&program).is_ok().prints(&expected);
}

#[test]
fn sbp_sys_001_005() {
    sbp("PRINT %(1);%(2);%(3);%(4);%(5)")
        .axes(5)
        .at([1.0, 2.0, 3.0, 4.0, 5.0])
        .run()
        .prints(&["12345"]);
}

#[test]
fn sbp_sys_006_010() {
    reads("ZT ⏎ MX,2 ⏎ ZX", &[(1, "0"), (6, "2"), (7, "0"), (8, "0"), (9, "0"), (10, "0")]);
}

#[test]
fn sbp_sys_011_020() {
    let limits = ["0", "96", "0", "48", "-6", "6", "-5", "5", "-360", "360"];
    let expected: Vec<(u32, &str)> = (11..).zip(limits).collect();
    reads("VL,0,96,0,48,-6,6,-5,5,0,-360,360", &expected);
}

#[test]
fn sbp_sys_021() {
    reads("SR", &[(21, "1")]);
    reads("SA", &[(21, "0")]);
}

#[test]
fn sbp_sys_022() {
    reads("SP", &[(22, "1")]);
    reads("SM", &[(22, "0")]);
}

#[test]
fn sbp_sys_023() {
    reads("VC,.375", &[(23, "0.375")]);
}

#[test]
fn sbp_sys_025() {
    reads("MX,0", &[(25, "0")]);
    reads("VD,,,1", &[(25, "1")]);
}

#[test]
fn sbp_sys_027() {
    reads("VD,,4", &[(27, "4")]);
}

#[test]
fn sbp_sys_028() {
    reads("VC,,,,1.5", &[(28, "1.5")]);
    run("VC,,,,OFF ⏎ &z = %(28) ⏎ IF &z = \"\" THEN PRINT \"empty\"").prints(&["empty"]);
}

#[test]
fn sbp_sys_029() {
    reads("VC,,,,,,,2", &[(29, "2")]);
}

#[test]
fn sbp_sys_030() {
    reads("VD,,4", &[(30, "4")]);
}

#[test]
fn sbp_sys_031_035() {
    reads(
        "VU,400,400,800,500,,,,,13.8889",
        &[(31, "400"), (32, "400"), (33, "800"), (34, "500"), (35, "13.8889")],
    );
}

#[test]
fn sbp_sys_036_040() {
    reads("MX,0", &[(36, "X"), (37, "Y"), (38, "Z"), (39, "A"), (40, "B")]);
    // Each channel has its own number, the fifth behind the speed of the connection.
    let swapped = [(36, "Z"), (37, "Y"), (38, "X"), (39, "B"), (40, "A")];
    reads("VI,,,,,Z,Y,X,B,,A", &swapped);
    reads("VI,,,,,Z,Y,X,B,,A ⏎ VI,,,,,,,,A", &[(36, "Z"), (39, "A"), (40, "A")]);
}

#[test]
fn sbp_sys_041_044() {
    reads("MX,0", &[(41, "0.1"), (42, "4"), (43, "1"), (44, "0.5")]);
    reads("VB,.2,6,1.5,.75", &[(41, "0.2"), (42, "6"), (43, "1.5"), (44, "0.75")]);
    // They are lengths.
    reads("VD,,,1", &[(41, "2.54"), (42, "101.6"), (43, "25.4"), (44, "12.7")]);
    reads("VD,,,1 ⏎ VB,3,,,9", &[(41, "3"), (42, "101.6"), (43, "25.4"), (44, "9")]);
}

#[test]
fn sbp_sys_050() {
    sbp("MX,0 ⏎ PAUSE .1 ⏎ PRINT %(50)")
        .input(1, 0.0, true)
        .input(3, 0.0, true)
        .run()
        .prints(&["5"]);
}

#[test]
fn sbp_sys_051_058() {
    sbp("PAUSE .1 ⏎ PRINT %(51);%(52);%(53);%(54);%(55);%(56);%(57);%(58)")
        .input(3, 0.0, true)
        .run()
        .prints(&["00100000"]);
}

#[test]
fn sbp_sys_060() {
    sbp("FP,part.sbp ⏎ MX,0").file("part.sbp", "PRINT %(60)").run().prints(&["part.sbp"]);
}

#[test]
fn sbp_sys_061_063() {
    sbp("M3,10,4,.5 ⏎ FP,p.sbp,,,,,1 ⏎ PRINT %(61);%(62);%(63)")
        .file("p.sbp", "PRINT %(61);\" \";%(62);\" \";%(63)")
        .run()
        .prints(&["10 4 0.5", "000"]);
}

#[test]
fn sbp_sys_066_068() {
    const READ: &str = "PRINT %(66);\" \";%(67);\" \";%(68)";
    sbp(&format!("FP,p.sbp,2,3,.5 ⏎ {READ}"))
        .file("p.sbp", &format!("{READ} ⏎ FP,q.sbp,2,2,2"))
        .file("q.sbp", READ)
        .run()
        .prints(&["2 3 0.5", "4 6 1", "1 1 1"]);
}

#[test]
fn sbp_sys_071_075() {
    sbp("VS,3,1,2,50 ⏎ PRINT %(71);\" \";%(72);\" \";%(73);\" \";%(74);\" \";%(75)")
        .axes(5)
        .run()
        .prints(&["3 3 1 2 50"]);
}

#[test]
fn sbp_sys_076_080() {
    sbp("VS,,,,,8,4,5,90 ⏎ PRINT %(76);\" \";%(77);\" \";%(78);\" \";%(79);\" \";%(80)")
        .axes(5)
        .run()
        .prints(&["8 8 4 5 90"]);
}

#[test]
fn sbp_sys_081_085() {
    let expected: Vec<(u32, &str)> = (81..=85).map(|n| (n, "0.4")).collect();
    reads("MX,0", &expected);
}

#[test]
fn sbp_sys_086_090() {
    let expected: Vec<(u32, &str)> = (86..=90).map(|n| (n, "0.4")).collect();
    reads("MX,0", &expected);
    // Fields 5 to 8 of VR; those of moves, before them, are other variables.
    let jogs = [(86, "0.5"), (87, "0.5"), (88, "0.6"), (89, "0.7"), (90, "0.8")];
    reads("VR,.3,.3,.3,.3,.5,.6,.7,.8", &jogs);
    reads("VR,,,,,.5,.6,.7,.8", &[(81, "0.4"), (83, "0.4"), (84, "0.4"), (85, "0.4")]);
}

#[test]
fn sbp_sys_091_098() {
    reads("VN,,,,2", &[(91, "2"), (92, "0")]);
}

#[test]
fn sbp_sys_099() {
    reads("VN,,,1", &[(99, "1")]);
}

#[test]
fn sbp_sys_100() {
    reads("SO,1,1 ⏎ SO,4,-4 ⏎ SO,4,1", &[(100, "9")]);
}

#[test]
fn sbp_sys_101_108() {
    reads("SO,3,1", &[(103, "1"), (101, "0")]);
}

#[test]
fn sbp_sys_109() {
    reads("MX,0", &[(109, "-1")]);
    reads("SO,4,-4", &[(109, "-4")]);
}

#[test]
fn sbp_sys_111_122() {
    reads("VN,,,,,,,,,,,,,,,,,3", &[(113, "3"), (112, "0")]);
}

#[test]
fn sbp_sys_126_129() {
    sbp("PAUSE .1 ⏎ PRINT %(126);%(127)").input(10, 0.0, true).run().prints(&["01"]);
}

#[test]
fn sbp_sys_135() {
    reads("SO,9,1 ⏎ SO,12,1", &[(135, "9")]);
}

#[test]
fn sbp_sys_136_139() {
    reads("SO,11,1", &[(138, "1"), (139, "0")]);
}

#[test]
fn sbp_sys_144_145() {
    sbp("MC,30 ⏎ PRINT %(144)").axes(6).run().prints(&["30"]);
}

#[test]
fn sbp_sys_150() {
    reads("MX,0", &[(150, "1")]);
}

#[test]
fn sbp_sys_151_156() {
    reads("MX,0", &[(151, "1"), (156, "1")]);
    reads("VU,,,,,,,,,,5", &[(151, "5")]);
}

#[test]
fn sbp_sys_unassigned() {
    run("&a = %(24) ⏎ IF &a = \"\" THEN MX,1").ends_at([1.0]).warns(1, "W004");
    run("&a = %(162)").fails(1, "R008");
    run("&a = %(0)").fails(1, "R008");
}

#[test]
fn sbp_sys_048() {
    reads("MX,0", &[(48, concat!("kerf ", env!("CARGO_PKG_VERSION")))]);
}

#[test]
fn sbp_sys_049() {
    reads("MX,0", &[(49, "0")]);
}
