//! Moves and jogs.

use kerf_ledger::{Run, at, run, sbp};

/// A command of one axis on five axes: alone, and relative from 1; kind and speed of its move.
#[track_caller]
fn one_axis(letters: &str, axis: usize, kind: &str, speed: f64) {
    let mut there = [0.0; 5];
    there[axis] = 2.5;
    let absolute = sbp(&format!("{letters},2.5")).axes(5).run();
    absolute.ends_at(there);
    let only = absolute.events("move").next().unwrap();
    assert_eq!(only["kind"], kind, "{absolute}");
    assert_eq!(only["speed"], speed, "{absolute}");
    let mut from = [0.0; 5];
    from[axis] = 1.0;
    there[axis] = 3.5;
    sbp(&format!("SR ⏎ {letters},2.5")).axes(5).at(from).run().ends_at(there);
    sbp(letters).axes(5).run().fails(1, "S010");
}

/// A command of several axes on six: one straight move at a speed along XY.
#[track_caller]
fn several(letters: &str, count: usize, kind: &str) {
    let values = ["1", "2", "3", "4", "5", "6"][..count].join(",");
    let there = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0];
    let expected: [f64; 6] = std::array::from_fn(|i| if i < count { there[i] } else { 0.0 });
    let run = sbp(&format!("{letters},{values}")).axes(6).run();
    run.ends_at(expected).visits(&[expected]);
    assert_eq!(run.events("move").next().unwrap()["kind"], kind, "{run}");
}

#[test]
fn sbp_cmd_mx() {
    one_axis("MX", 0, "cut", 2.0);
}

#[test]
fn sbp_cmd_jx() {
    one_axis("JX", 0, "jog", 6.0);
}

#[test]
fn sbp_cmd_my() {
    one_axis("MY", 1, "cut", 2.0);
}

#[test]
fn sbp_cmd_jy() {
    one_axis("JY", 1, "jog", 6.0);
}

#[test]
fn sbp_cmd_mz() {
    one_axis("MZ", 2, "cut", 1.0);
}

#[test]
fn sbp_cmd_jz() {
    one_axis("JZ", 2, "jog", 3.0);
}

#[test]
fn sbp_cmd_ma() {
    one_axis("MA", 3, "cut", 1.0);
}

#[test]
fn sbp_cmd_ja() {
    one_axis("JA", 3, "jog", 3.0);
}

#[test]
fn sbp_cmd_mb() {
    one_axis("MB", 4, "cut", 30.0);
}

#[test]
fn sbp_cmd_jb() {
    one_axis("JB", 4, "jog", 60.0);
}

#[test]
fn sbp_cmd_rotary_units() {
    sbp("VD,,5,,,2 ⏎ MB,90 ⏎ VD,,,1 ⏎ PRINT %(5)").run().is_ok().prints(&["90"]);
}

#[test]
fn sbp_cmd_m2() {
    several("M2", 2, "cut");
}

#[test]
fn sbp_cmd_j2() {
    several("J2", 2, "jog");
}

#[test]
fn sbp_cmd_m3() {
    several("M3", 3, "cut");
}

#[test]
fn sbp_cmd_j3() {
    several("J3", 3, "jog");
}

#[test]
fn sbp_cmd_m4() {
    several("M4", 4, "cut");
}

#[test]
fn sbp_cmd_j4() {
    several("J4", 4, "jog");
}

#[test]
fn sbp_cmd_m5() {
    several("M5", 5, "cut");
}

#[test]
fn sbp_cmd_j5() {
    several("J5", 5, "jog");
}

#[test]
fn sbp_cmd_multi_blank() {
    let from = [1.0, 2.0, 3.0];
    at(from, "M3,,5").ends_at([1.0, 5.0, 3.0]);
    at(from, "J3,,,1").ends_at([1.0, 2.0, 1.0]);
    at(from, "M2,4").ends_at([4.0, 2.0]);
    at(from, "M2").visits::<3>(&[]).warns(1, "W015");
}

#[test]
fn sbp_cmd_multi_relative() {
    at([1.0, 2.0, 3.0], "SR ⏎ M3,1,,-1 ⏎ M3,1,,-1").visits(&[[2.0, 2.0, 2.0], [3.0, 2.0, 1.0]]);
}

#[test]
fn sbp_cmd_abs_same() {
    at([3.0, 7.0], "M2,3,7").is_ok().is_silent().visits::<3>(&[]);
}

#[test]
fn sbp_cmd_mh_low() {
    let run = at([5.0, 4.0, -0.5], "MH");
    run.visits(&[[5.0, 4.0, 1.0], [0.0, 0.0, 1.0]]);
    assert_eq!(kinds(&run), ["cut", "cut"], "{run}");
    assert_eq!(speeds(&run), [1.0, 2.0], "{run}");
}

#[test]
fn sbp_cmd_mh_high() {
    at([5.0, 4.0, 2.0], "MH").visits(&[[0.0, 0.0, 2.0]]);
}

#[test]
fn sbp_cmd_jh() {
    let run = at([5.0, 4.0, -0.5], "JH");
    run.visits(&[[5.0, 4.0, 1.0], [0.0, 0.0, 1.0]]);
    assert_eq!(kinds(&run), ["jog", "jog"], "{run}");
    at([5.0, 4.0, 2.0], "JH").visits(&[[0.0, 0.0, 2.0]]);
}

#[test]
fn sbp_cmd_home_relative() {
    at([5.0, 4.0, 2.0], "SR ⏎ MH ⏎ PRINT %(21)").ends_at([0.0, 0.0, 2.0]).prints(&["1"]);
}

#[test]
fn sbp_cmd_home_safez_off() {
    let run = at([5.0, 4.0, -0.5], "VC,,,,OFF ⏎ MH");
    run.ends_at([0.0, 0.0, -0.5]);
    assert!(run.events("diag").any(|d| d["severity"] == "warning" && d["line"] == 2), "{run}");
}

#[test]
fn sbp_cmd_home_safea() {
    let run = sbp("JH").axes(4).at([5.0, 4.0, -0.5, -0.5]).run();
    run.ends_at([0.0, 0.0, 1.0, 1.0]);
    // The last move is level: both were lifted before it.
    let last = run.events("move").last().unwrap();
    assert_eq!(last["to"]["x"], 0.0, "{run}");
    let before: Vec<_> = run.events("move").filter(|m| m["to"]["x"] == 5.0).collect();
    assert_eq!(before.last().unwrap()["to"]["z"], 1.0, "{run}");
    assert_eq!(before.last().unwrap()["to"]["a"], 1.0, "{run}");
}

#[test]
fn sbp_cmd_md_abs() {
    run("MD,10,90").ends_at([10.0, 0.0]);
    run("MD,10,45").ends_at([7.0711, 7.0711]);
    run("MD,10,180").ends_at([0.0, -10.0]);
    run("MD,5,202.5").ends_at([-1.9134, -4.6194]);
    at([1.0, 1.0], "SR ⏎ MD,10,90").ends_at([11.0, 1.0]);
}

#[test]
fn sbp_cmd_md_rel_r() {
    run("MX,5 ⏎ MD,4,90R").ends_at([5.0, -4.0]);
    run("MY,5 ⏎ MD,4,45R").ends_at([2.8284, 7.8284]);
}

#[test]
fn sbp_cmd_md_rel_l() {
    run("MX,5 ⏎ MD,4,90L").ends_at([5.0, 4.0]);
    run("MX,5 ⏎ MD,4,30l").ends_at([5.0 + 3.4641, 2.0]);
}

#[test]
fn sbp_cmd_md_rel_first() {
    run("MD,4,90L").ends_at([4.0, 0.0]);
}

#[test]
fn sbp_cmd_md_rel_arc() {
    run("CC,4,T,1,0,90 ⏎ MD,1,90L").ends_at([3.0, -2.0]);
    run("MX,5 ⏎ MZ,-.2 ⏎ MD,1,90R").ends_at([5.0, -1.0]);
}

#[test]
fn sbp_cmd_md_clock() {
    run("MD,10,3:00").ends_at([10.0, 0.0]);
    run("MD,10,1:30").ends_at([7.0711, 7.0711]);
    run("MD,10,12:00").ends_at([0.0, 10.0]);
    run("MD,10,7:30").ends_at([-7.0711, -7.0711]);
}

#[test]
fn sbp_cmd_md_compass() {
    let points = [
        "N", "NNE", "NE", "ENE", "E", "ESE", "SE", "SSE", "S", "SSW", "SW", "WSW", "W", "WNW",
        "NW", "NNW",
    ];
    for (n, point) in points.iter().enumerate() {
        let (sin, cos) = (22.5 * n as f64).to_radians().sin_cos();
        run(&format!("MD,10,{point}")).ends_at([10.0 * sin, 10.0 * cos]);
    }
    run("MD,5,NNX").status("failed");
}

#[test]
fn sbp_cmd_md_z_abs() {
    run("MD,10,90,-.5").visits(&[[10.0, 0.0, -0.5]]);
    run("MZ,-1 ⏎ SR ⏎ MD,10,90,-.5").ends_at([10.0, 0.0, -0.5]);
}

#[test]
fn sbp_cmd_md_z_ud() {
    at([0.0, 0.0, -0.5], "MD,10,90,.25U ⏎ MD,10,90,.25D")
        .visits(&[[10.0, 0.0, -0.25], [20.0, 0.0, -0.5]]);
}

#[test]
fn sbp_cmd_md_err() {
    run("MD,10").fails(1, "S010");
    run("MD,,90").fails(1, "S010");
    run("MD,-2,90").ends_at([-2.0, 0.0]);
}

#[test]
fn sbp_cmd_ms() {
    sbp("MS,3,1,2,50 ⏎ PRINT %(71);\" \";%(72);\" \";%(73);\" \";%(74);\" \";%(75)")
        .axes(5)
        .run()
        .prints(&["3 3 1 2 50"]);
    run("MS,,.5 ⏎ PRINT %(71);\" \";%(73)").prints(&["2 0.5"]);
    run("MS,0").fails(1, "R009");
    run("MS,-1").fails(1, "R009");
}

#[test]
fn sbp_cmd_js() {
    run("JS,8,4 ⏎ PRINT %(76);\" \";%(77);\" \";%(78)").prints(&["8 8 4"]);
}

#[test]
fn sbp_cmd_speed_units() {
    sbp("MS,50.8 ⏎ PRINT %(71) ⏎ VD,,,0 ⏎ PRINT %(71)").millimetres().run().prints(&["50.8", "2"]);
}

#[test]
fn sbp_cmd_speed_stack() {
    // With MS in between the tool stops at X 5; with VS it goes through.
    let stopping = run("MX,5 ⏎ MS,1 ⏎ MX,10").ends_at([10.0]).seconds();
    let through = run("MX,5 ⏎ VS,1 ⏎ MX,10").ends_at([10.0]).seconds();
    assert!(stopping > through + 0.01, "{stopping} {through}");
}

#[test]
fn sbp_cmd_c_axis() {
    several("M6", 6, "cut");
    several("J6", 6, "jog");
    sbp("MC,90 ⏎ JC,45 ⏎ PRINT %(144)").axes(6).run().prints(&["45"]);
    sbp("MC,90 ⏎ ZC ⏎ PRINT %(144) ⏎ M6,1 ⏎ Z6 ⏎ PRINT %(1)").axes(6).run().prints(&["0", "0"]);
    run("MC,90").fails(1, "R011");
}

fn kinds(run: &Run) -> Vec<&str> {
    run.events("move").map(|m| m["kind"].as_str().unwrap()).collect()
}

fn speeds(run: &Run) -> Vec<f64> {
    run.events("move").map(|m| m["speed"].as_f64().unwrap()).collect()
}
