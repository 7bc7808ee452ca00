//! Setting modes.

use kerf_ledger::{at, run, sbp};
use kerf_model::CABLE;

#[test]
fn sbp_cmd_sa() {
    at([3.0, 0.0], "SA ⏎ M2,3,7 ⏎ PRINT %(21)").ends_at([3.0, 7.0]).prints(&["0"]);
}

#[test]
fn sbp_cmd_sr() {
    at([3.0, 7.0], "SR ⏎ M2,3,7 ⏎ M2,3,7 ⏎ PRINT %(21)")
        .visits(&[[6.0, 14.0], [9.0, 21.0]])
        .prints(&["1"]);
}

#[test]
fn sbp_cmd_sr_rounding() {
    let run = run("SR ⏎ &n=0 ⏎ A: ⏎ MX,.1 ⏎ &n=&n+1 ⏎ IF &n<10000 THEN GOTO A ⏎ SA")
        .ends_at([1000.0])
        .location();
    assert!((run[0] - 1000.0).abs() < 1e-6, "{}", run[0]);
}

#[test]
fn sbp_cmd_sm() {
    run("SP ⏎ SM ⏎ PRINT %(22) ⏎ MX,5").ends_at([5.0]).prints(&["0"]).shows(&[]);
    let unplugged = sbp("SM ⏎ PRINT %(22)").input(CABLE, 99.0, true).run();
    unplugged.is_ok().shows(&["not connected: nothing moves; SP shows files in preview"]);
    sbp("SP ⏎ MX,5").input(CABLE, 99.0, true).run().is_ok();
}

#[test]
fn sbp_cmd_sl() {
    run("&a=1 ⏎ SL ⏎ PRINT &a").prints(&["&a"]);
    sbp("MSGBOX (ready?, YesNo, t) ⏎ SL ⏎ PRINT &msganswer")
        .answers(&["Yes"])
        .run()
        .prints(&["&msganswer"]);
}

#[test]
fn sbp_cmd_st() {
    run("VA,,,,,,5,4,1 ⏎ ST").visits::<3>(&[]).ends_at([5.0, 4.0, 1.0]);
}

#[test]
fn sbp_cmd_sv() {
    sbp("PRINT %(71)").after("VS,4 ⏎ SV ⏎ VS,6 ⏎ MX,1").run().prints(&["4"]);
}

#[test]
fn sbp_cmd_sc2() {
    // Stopping at X 5 takes longer than passing it.
    let through = run("MX,5 ⏎ MX,10").ends_at([10.0]).seconds();
    let stopping =
        run("MX,5 ⏎ SC,2 ⏎ MX,10").visits(&[[5.0, 0.0, 0.0], [10.0, 0.0, 0.0]]).seconds();
    assert!(stopping > through + 0.01, "{stopping} {through}");
}

#[test]
fn sbp_cmd_sc_other() {
    run("SC,1").fails(1, "R009").says("only SC,2 is defined");
    run("SC").fails(1, "R009").says("only SC,2 is defined");
}

#[test]
fn sbp_cmd_sp() {
    let run = run("SP ⏎ MX,5 ⏎ PRINT %(22) ⏎ SM");
    run.is_ok().prints(&["1"]).visits(&[[5.0]]).stands_at([0.0]);
    let mode = run.events("mode").next().expect("the mode changes");
    assert_eq!(mode["mode"], "preview", "{run}");
}

#[test]
fn sbp_cmd_sp_start() {
    let from = |program: &str| {
        let run = at([1.0, 1.0], program);
        let y = run.is_ok().events("move").next().unwrap()["to"]["y"].as_f64().unwrap();
        (y, run.end()["cut"].as_f64().unwrap())
    };
    assert_eq!(from("SP ⏎ MX,5"), (1.0, 4.0));
    assert_eq!(from("VP,,,,,,,0 ⏎ SP ⏎ MX,5"), (0.0, 5.0));
}

#[test]
fn sbp_cmd_sp_noeffect() {
    let program =
        "SP ⏎ SO,3,1 ⏎ PAUSE 5 ⏎ ZX ⏎ MX,1 ⏎ JY,2 ⏎ PRINT %(103) ⏎ SM ⏎ PRINT %(1), %(103)";
    let run = at([2.0], program);
    run.is_ok().prints(&["0", "2     0"]).switches(3, &[]);
    assert_eq!((run.seconds(), run.events("wait").count()), (0.0, 0), "{run}");
    at([2.0], "SP ⏎ PAUSE ⏎ SM").asks(&["Continue?"]);
}
