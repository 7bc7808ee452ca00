//! Torch height and heater (VH).

use kerf_ledger::{Run, run, sbp};

/// Times at which Z begins to move by itself and stops, and its speed.
fn rides(run: &Run) -> Vec<(f64, f64)> {
    let number = |e: &serde_json::Value, key: &str| e[key].as_f64().unwrap();
    let z = run.events("independent").filter(|e| e["axis"] == "Z");
    z.map(|e| (number(e, "t"), number(e, "speed"))).collect()
}

/// Numbers that a run prints, a line each.
fn printed(run: &Run) -> Vec<f64> {
    let text = |e: &serde_json::Value| e["text"].as_str().unwrap().parse().unwrap();
    run.is_ok().events("print").map(text).collect()
}

const ON: &str = "VS,4 ⏎ VN,,,1 ⏎ VH,1 ⏎";

#[test]
fn sbp_val_vh_torch() {
    let program = format!("{ON} MX,8 ⏎ PRINT %(3) ⏎ PAUSE 1 ⏎ PRINT %(3)");
    let torch = sbp(&program).input(1, 1.0, false).run();
    let plain = run("VS,4 ⏎ MX,8").seconds();
    // Down for the first second, then up until X stops; the way in X takes as long as without.
    assert_eq!(rides(&torch), [(0.0, -1.0), (1.0, 1.0), (round(plain), 0.0)], "{torch}");
    assert_eq!(torch.events("move").next().unwrap()["t1"], round(plain), "{torch}");
    let z = printed(&torch);
    assert!((z[0] - (plain - 2.0)).abs() < 1e-6 && z[0] == z[1], "{z:?}");
    torch.steps(&[3200, 0, (400.0 * (plain - 2.0)).round() as i64]);
    // Z alone does not ride, nor does anything without VH or VN.
    assert_eq!(rides(&run(&format!("{ON} MZ,1"))), []);
    assert_eq!(rides(&run("VS,4 ⏎ VN,,,1 ⏎ MX,8")), []);
}

#[test]
#[allow(non_snake_case)]
fn sbp_val_vh_torch__other_moves_begin_where_it_left_z() {
    // Z rises 1 in/s for the time of the move; the next moves go on from there.
    let moved = |then: &str| printed(&run(&format!("{ON} MX,8 ⏎ {then} ⏎ PRINT %(3)")))[0];
    let up = run("VS,4 ⏎ MX,8").seconds();
    assert!((moved("VH,0") - up).abs() < 1e-6);
    assert_eq!((moved("MZ,1"), moved("VH,0 ⏎ MZ,1"), moved("JZ,2")), (1.0, 1.0, 2.0));
    let steps = run(&format!("{ON} MX,8 ⏎ VH,0 ⏎ MZ,1 ⏎ MX,0"));
    steps.steps(&[0, 0, 400]);
    // Over two moves of one stack it rides on.
    let two = run(&format!("{ON} MX,4 ⏎ MX,8 ⏎ PRINT %(3)"));
    assert!((printed(&two)[0] - up).abs() < 1e-6 && rides(&two).len() == 2, "{two}");
    // After a stop the tool is lifted from where it really is.
    let low = sbp(&format!("{ON} MX,80")).input(1, 99.0, false).stopped_at(5.0).run();
    low.steps(&[low.end()["steps"][0].as_i64().unwrap(), 0, 400]);
}

#[test]
fn zero_is_where_the_torch_has_brought_z() {
    let zeroed = run(&format!("{ON} MX,8 ⏎ ZZ ⏎ PRINT %(3) ⏎ MX,0 ⏎ MZ,0 ⏎ PRINT %(3)"));
    assert_eq!(printed(&zeroed), [0.0, 0.0]);
    let called = run(&format!("{ON} MX,8 ⏎ VA,,,5 ⏎ PRINT %(3)"));
    assert_eq!(printed(&called), [5.0]);
}

#[test]
fn sbp_val_vh_rate() {
    let speed = |vh: &str| rides(&run(&format!("VS,4 ⏎ VN,,,1 ⏎ {vh} ⏎ MX,8")))[0].1;
    assert_eq!((speed("VH,1"), speed("VH,1,.1"), speed("VH,1,.5")), (1.0, 0.4, 2.0));
    assert_eq!(rides(&run("VS,4 ⏎ VN,,,1 ⏎ VH,1,0 ⏎ MX,8")), []);
}

#[test]
fn sbp_val_vh_heater() {
    let heater = |run: &Run| run.is_ok().end()["heater"].as_f64().unwrap();
    let warm = run("VN,,,3 ⏎ VH,1,,,,,5,200 ⏎ PAUSE 200");
    assert!((heater(&warm) - 200.0).abs() < 5.0, "{}", heater(&warm));
    // While it heats, half the time is at low PWM; heat goes on and off to hold it.
    let percents: Vec<_> = warm.events("pwm").map(|e| e["percent"].as_f64().unwrap()).collect();
    assert!(percents.len() > 10 && percents.chunks(2).all(|c| c[0] == 50.0), "{percents:?}");
    let share = |low: u8| {
        let run = run(&format!("VN,,,3 ⏎ VH,1,,,,,{low},200 ⏎ PAUSE 1"));
        run.events("pwm").next().unwrap()["percent"].as_f64().unwrap()
    };
    assert_eq!((share(1), share(3), share(8)), (90.0, 70.0, 20.0));
    let off = run("VN,,,3 ⏎ VH,1,,,,,5,200 ⏎ PAUSE 20 ⏎ VH,1,,,,,,0 ⏎ PAUSE 600");
    let last = off.events("pwm").last().unwrap();
    assert_eq!((&last["percent"], &last["t"]), (&0.into(), &20.into()), "{off}");
    assert!(heater(&off) < 21.0, "{}", heater(&off));
}

/// As the trace tells it.
fn round(seconds: f64) -> f64 {
    (seconds * 1e9).round() / 1e9
}
