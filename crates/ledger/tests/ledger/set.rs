//! Setting modes.

use kerf_ledger::{at, run, sbp};

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
    run("SP ⏎ SM ⏎ PRINT %(22) ⏎ MX,5").ends_at([5.0]).prints(&["0"]);
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
