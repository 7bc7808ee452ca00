//! File commands: FP, FS and what nesting means.

use kerf_ledger::{Run, run, sbp};

/// Runs a program beside a part file.
fn with(part: &str, program: &str) -> Run {
    sbp(program).file("part.sbp", part).run()
}

#[test]
fn sbp_file_fp_name() {
    with("MX,1", "FP, PART.SBP").ends_at([1.0]);
    with("MX,1", "FP, part").ends_at([1.0]);
    with("MX,1", "&f=part.sbp ⏎ FP,&f").ends_at([1.0]);
    sbp("FP, sub\\part.sbp").file("sub/part.sbp", "MX,1").run().ends_at([1.0]);
    run("FP,missing.sbp").fails(1, "F001").says("missing.sbp");
}

#[test]
fn sbp_file_fp_proportion() {
    with("M3,1,2,-.5", "FP,part.sbp,2,3,.5").ends_at([2.0, 6.0, -0.25]);
}

#[test]
fn sbp_file_fp_offset1() {
    with("M3,1,0,-.2 ⏎ PRINT %(61)", "M3,10,4,.5 ⏎ FP,part.sbp,,,,,1 ⏎ PRINT %(61)")
        .ends_at([11.0, 4.0, 0.3])
        .prints(&["10", "0"]);
}

#[test]
fn sbp_file_fp_allparts() {
    let call = "FP,part.sbp,,,,,2";
    with(
        "M2,1,0 ⏎ M2,0,0",
        &format!("M2,10,4 ⏎ {call} ⏎ M2,20,4 ⏎ {call} ⏎ M2,30,4 ⏎ {call} ⏎ M2,40,4 ⏎ {call}"),
    )
    .visits(&[
        [10.0, 4.0],
        [11.0, 4.0],
        [10.0, 4.0],
        [20.0, 4.0],
        [21.0, 4.0],
        [20.0, 4.0],
        [30.0, 4.0],
        [31.0, 4.0],
        [30.0, 4.0],
        [40.0, 4.0],
        [41.0, 4.0],
        [40.0, 4.0],
    ]);
}

#[test]
fn sbp_file_fp_from0() {
    with("M2,1,0 ⏎ M2,0,0", "M3,5,5,.5 ⏎ FP,part.sbp,,,,2,2,-.25,,1").visits(&[
        [5.0, 5.0, 0.5],
        [5.0, 5.0, 0.0],
        [5.0, 5.0, -0.25],
        [6.0, 5.0, -0.25],
        [5.0, 5.0, -0.25],
        [5.0, 5.0, -0.5],
        [6.0, 5.0, -0.5],
        [5.0, 5.0, -0.5],
        [5.0, 5.0, 0.5],
    ]);
}

#[test]
fn sbp_file_fp_tab() {
    let run = with("MZ,-.5 ⏎ MX,20 ⏎ JZ,1 ⏎ JX,0", "FP,part.sbp,,,,2,,,1");
    let tops = run.is_ok().tops(-0.4);
    assert_eq!(tops, [[4.5, 5.5], [10.5, 11.5], [16.5, 17.5]], "{run}");
}

#[test]
fn sbp_file_fp_tab_subfiles() {
    let run = sbp("FP,master.sbp,,,,,,,1 ⏎ MZ,-.5 ⏎ MX,0")
        .file("master.sbp", "FP,sub.sbp ⏎ MX,0")
        .file("sub.sbp", "MZ,-.5 ⏎ MX,10 ⏎ JZ,1")
        .run();
    assert_eq!(run.is_ok().tops(-0.4), [[4.5, 5.5]], "{run}");
}

#[test]
fn sbp_file_nest_depth() {
    let chain = |last: &str| {
        let mut case = sbp("FP,f2.sbp").file("f8.sbp", last);
        for n in 2..8 {
            case = case.file(&format!("f{n}.sbp"), &format!("FP,f{}.sbp", n + 1));
        }
        case.file("f9.sbp", "MX,9").run()
    };
    chain("MX,8").ends_at([8.0]);
    chain("FP,f9.sbp").fails(1, "R007").stands_at([0.0]);
}

#[test]
fn sbp_file_fs_set() {
    sbp("FS,doors ⏎ FP,a.sbp").file("doors/a.sbp", "MX,1").run().ends_at([1.0]);
    run("FS,nowhere").fails(1, "F001");
}

#[test]
fn sbp_file_fs_blank() {
    sbp("FS,doors ⏎ FS ⏎ FP,a.sbp")
        .file("doors/b.sbp", "")
        .file("a.sbp", "MX,1")
        .run()
        .ends_at([1.0]);
}

#[test]
fn sbp_file_fs_relative() {
    sbp("FS,doors ⏎ FS,.. ⏎ FP,a.sbp")
        .file("doors/b.sbp", "")
        .file("a.sbp", "MX,1")
        .run()
        .ends_at([1.0]);
}

#[test]
fn sbp_file_fs_infile() {
    sbp("FS,doors ⏎ FP,a.sbp ⏎ FS,.. ⏎ FP,a.sbp")
        .file("doors/a.sbp", "MX,1")
        .file("a.sbp", "MY,2")
        .run()
        .visits(&[[1.0, 0.0], [1.0, 2.0]]);
}

#[test]
fn sbp_file_temp_settings() {
    let file = "VS,4 ⏎ VU,,,,,.2 ⏎ SF,1 ⏎ MX,1";
    sbp("PRINT %(71)").after(file).run().prints(&["2"]);
    sbp("PRINT %(71)").after(&format!("{file} ⏎ MX,&undefined")).run().prints(&["2"]);
}

#[test]
fn sbp_file_temp_nested() {
    let run = with("VS,4", "FP,part.sbp ⏎ MX,1");
    assert_eq!(run.events("move").next().unwrap()["speed"], 4.0, "{run}");
    sbp("PRINT %(71)").file("part.sbp", "VS,4").after("FP,part.sbp").run().prints(&["2"]);
}

#[test]
fn sbp_file_temp_others() {
    sbp("PRINT %(23);\" \";%(21)").after("VC,.5 ⏎ SR").run().prints(&["0.5 1"]);
}

#[test]
fn sbp_file_error_line() {
    let run = sbp("MX,1 ⏎ MX,2 ⏎ MX,3 ⏎ MX,4 ⏎ FP,b.sbp").file("b.sbp", "MY,1 ⏎ MX,&none").run();
    let error = run.events("diag").find(|d| d["severity"] == "error").unwrap();
    assert_eq!(error["file"], "b.sbp", "{run}");
    assert_eq!(error["line"], 2, "{run}");
    assert_eq!(error["callers"][0]["line"], 5, "{run}");
}

#[test]
fn sbp_file_fp_offset_home() {
    with("MX,5 ⏎ JH", "M3,10,4,.5 ⏎ FP,part.sbp,,,,,2").ends_at([10.0, 4.0, 1.0]);
    with("MX,5 ⏎ JH", "M3,10,4,.5 ⏎ FP,part.sbp").ends_at([0.0, 0.0, 1.0]);
}

#[test]
fn sbp_file_fp_offset_sysvar() {
    with("MX,1 ⏎ PRINT %(1);\" \";(%(1)-%(61))/%(66)", "M2,10,4 ⏎ FP,part.sbp,2,,,,2")
        .prints(&["12 1"]);
}
