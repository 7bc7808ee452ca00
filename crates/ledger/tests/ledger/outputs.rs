//! Outputs and spindles.

use kerf_ledger::{run, sbp};

#[test]
fn sbp_out_so() {
    run("SO,3,1 ⏎ PRINT %(103) ⏎ SO,3,0 ⏎ PRINT %(103)")
        .switches(3, &[(true, "program"), (false, "program")])
        .prints(&["1", "0"]);
    run("SO,3,1 ⏎ SO,3 ⏎ PRINT %(103)").prints(&["0"]);
}

#[test]
fn sbp_out_so_range() {
    run("SO,12,1 ⏎ PRINT %(139)").prints(&["1"]);
    run("SO,13,1").fails(1, "R009");
}

#[test]
fn sbp_out_so4_m4() {
    run("SO,4,-4 ⏎ MX,5").switches(4, &[]);
    run("SO,4,-4 ⏎ SO,4,1 ⏎ PRINT %(104)").prints(&["1"]);
}

#[test]
fn sbp_out_so4_manual() {
    let run = run("SO,4,1");
    assert!(run.events("diag").any(|d| d["severity"] == "warning"), "{run}");
}

#[test]
fn sbp_out_so4_mode() {
    let run = run("SW,0 ⏎ MX,5");
    let motion = run.events("move").next().unwrap().clone();
    let switched: Vec<_> = run.events("output").filter(|e| e["n"] == 4).collect();
    assert_eq!(switched.len(), 2, "{run}");
    assert_eq!((&switched[0]["on"], &switched[0]["t"]), (&true.into(), &motion["t0"]), "{run}");
    assert_eq!((&switched[1]["on"], &switched[1]["t"]), (&false.into(), &motion["t1"]), "{run}");
}

#[test]
fn sbp_out_warn_set() {
    let start =
        |program: &str| run(program).is_ok().events("move").next().unwrap()["t0"].as_f64().unwrap();
    assert!((start("SW,.5 ⏎ MX,1") - 0.5).abs() < 1e-6);
    assert!(start("SW,0 ⏎ MX,1").abs() < 1e-6);
    run("SW,-1").fails(1, "R009");
}

#[test]
fn sbp_out_warn_file() {
    let starts = |program: &str| -> Vec<f64> {
        let run = run(program);
        run.is_ok().events("move").map(|m| m["t0"].as_f64().unwrap()).collect()
    };
    let once = starts("SW,2 ⏎ MX,1 ⏎ MX,2");
    assert!((once[0] - 2.0).abs() < 1e-6, "{once:?}");
    let plain = starts("SW,0 ⏎ MX,1 ⏎ MX,2");
    assert!((once[1] - once[0] - (plain[1] - plain[0])).abs() < 1e-6, "{once:?} {plain:?}");
    // After the operator was asked it comes again.
    let again = starts("SW,2 ⏎ MX,1 ⏎ PAUSE ⏎ MX,2");
    let plain = starts("SW,0 ⏎ MX,1 ⏎ PAUSE ⏎ MX,2");
    assert!((again[1] - plain[1] - 4.0).abs() < 1e-6, "{again:?} {plain:?}");
}

#[test]
fn sbp_ext_tr() {
    let run = sbp("TR,12000,1").run();
    let spindle = run.events("spindle").next().expect("a spindle event");
    assert_eq!(spindle["rpm"], 12000.0, "{run}");
}
