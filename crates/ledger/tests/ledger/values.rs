//! Value commands: settings and what they change.

use kerf_ledger::{at, run, sbp};

#[test]
fn sbp_val_general() {
    run("VC,.5 ⏎ PRINT %(23);\" \";%(28)").prints(&["0.5 1"]);
    run("VC,,,,1.5 ⏎ PRINT %(23);\" \";%(28)").prints(&["0.25 1.5"]);
}

#[test]
fn sbp_val_range() {
    run("VS,0").fails(1, "R009");
    run("VC,,,,,,150").fails(1, "R009");
    // Nothing of a refused line is taken over.
    sbp("PRINT %(71)").after("VS,0,5 ⏎ SV").run().prints(&["2"]);
    sbp("PRINT %(23)").after("VC,.5,,,,,150").run().prints(&["0.25"]);
}

#[test]
fn sbp_val_va_loc() {
    at([2.0], "VA,5.3 ⏎ PRINT %(1);\" \";%(1)+%(6)").visits::<3>(&[]).prints(&["5.3 2"]);
    at([1.0, 2.0, 3.0], "VA,,,.5 ⏎ PRINT %(1);%(2);\" \";%(3)").prints(&["12 0.5"]);
}

#[test]
fn sbp_val_va_base() {
    run("VA,,,.75,,,,,0 ⏎ PRINT %(3);\" \";%(8)").prints(&["0.75 0"]);
    run("VA,2,,,,,0 ⏎ PRINT %(1);\" \";%(6)").prints(&["2 0"]);
}

#[test]
fn sbp_val_va_basekeep() {
    run("VA,,,,,,5,5,5 ⏎ VA,0,0,0 ⏎ ST").ends_at([5.0, 5.0, 5.0]);
}

#[test]
fn sbp_val_vb_params() {
    run("VB,.2,5,2,.25,0,, ⏎ PRINT %(41);\" \";%(42);\" \";%(43);\" \";%(44)")
        .prints(&["0.2 5 2 0.25"]);
}

#[test]
fn sbp_val_vb_on_off() {
    let run = run("MZ,-.5 ⏎ VB,,,,,1 ⏎ MX,20 ⏎ VB,,,,,0 ⏎ MX,40");
    assert_eq!(run.is_ok().tops(-0.4), [[4.5, 5.5], [10.5, 11.5], [16.5, 17.5]], "{run}");
    let next = sbp("MZ,-.5 ⏎ MX,20").after("MZ,-.5 ⏎ VB,,,,,1 ⏎ MX,20 ⏎ JZ,1 ⏎ JX,0").run();
    assert_eq!(next.tops(-0.4).len(), 0, "{next}");
}

#[test]
fn sbp_val_vc_params() {
    run("VC,.3,,,2,-,20,3,0,0,0,Z,8 ⏎ PRINT %(23);\" \";%(28);\" \";%(29)").prints(&["0.3 2 3"]);
}

#[test]
fn sbp_val_vc_diam() {
    let run = run("VC,.5 ⏎ CC,4,O ⏎ PRINT %(23)");
    run.prints(&["0.5"]);
    assert_eq!(run.events("arc").next().unwrap()["centre"]["y"], -2.25, "{run}");
}

#[test]
fn sbp_val_vc_safez() {
    run("PRINT %(28) ⏎ VC,,,,.5 ⏎ MX,1 ⏎ JH").prints(&["1"]).ends_at([0.0, 0.0, 0.5]);
}

#[test]
fn sbp_val_vc_plungedir() {
    run("VC,,,,,+ ⏎ CC,4,T,1,0,360,.25,1,1,1,0,1").ends_at([0.0, 0.0, 0.25]);
    run("VC,,,,,- ⏎ CC,4,T,1,0,360,.25").warns(2, "W012");
}

#[test]
fn sbp_val_vc_overlap() {
    let second_ring = |overlap: u32| {
        let run = run(&format!("VC,,,,,,{overlap} ⏎ CC,4,T,1,0,360,-.1,1,1,1,2"));
        run.is_ok().events("arc").nth(1).unwrap()["to"]["y"].as_f64().unwrap()
    };
    assert!((second_ring(10) + 0.225).abs() < 1e-6);
    assert!((second_ring(50) + 0.125).abs() < 1e-6);
    run("VC,,,,,,100").fails(1, "R009");
}

#[test]
fn sbp_val_vc_safea() {
    sbp("PRINT %(29) ⏎ JH")
        .axes(4)
        .at([0.0, 0.0, 0.0, -0.2])
        .run()
        .prints(&["1"])
        .ends_at([0.0, 0.0, 1.0, 1.0]);
}

#[test]
fn sbp_val_vc_trigger_on() {
    let run = run("VC,,,,,,,,1,.05,.1,Z,8 ⏎ JZ,.5 ⏎ MZ,-.3 ⏎ MZ,.5");
    run.is_ok().switches(8, &[(true, "trigger"), (false, "trigger")]);
    // Z ramps from .4 to 1 in/s at 14 in/s², in .03 in and .042857 s; on at .05, .45 below the
    // start, and off at .1, .4 above the start.
    let ramp_s = 0.6 / 14.0;
    let expected = [ramp_s + 0.42, ramp_s + 0.37];
    let starts = run.events("move").filter(|made| made["kind"] == "cut");
    let starts: Vec<f64> = starts.map(|made| made["t0"].as_f64().unwrap()).collect();
    let switches = run.events("output").filter(|event| event["n"] == 8);
    let switched = switches.map(|event| event["t"].as_f64().unwrap());
    let after: Vec<f64> = switched.zip(&starts).map(|(at, from)| at - from).collect();
    assert_eq!(after.len(), 2, "{run}");
    for (after, expected) in after.iter().zip(expected) {
        assert!((after - expected).abs() < 1e-4, "{after} {expected}\n{run}");
    }
}

#[test]
fn sbp_val_vc_trigger_above() {
    run("VC,,,,,,,,1,.05,.1,Z,8 ⏎ MZ,-.3").switches(8, &[(true, "trigger"), (false, "end")]);
}

#[test]
fn sbp_val_vc_trigger_nooff() {
    run("VC,,,,,,,,1,.05,.1,Z,8 ⏎ JZ,.5 ⏎ MZ,-.3 ⏎ MZ,.05")
        .switches(8, &[(true, "trigger"), (false, "end")]);
}

#[test]
fn sbp_val_vc_trigger_xy() {
    run("VC,,,,,,,,1,.05,.1,Z,8 ⏎ JZ,.5 ⏎ M3,5,0,-.3").switches(8, &[]);
}

#[test]
fn sbp_val_vc_trigger_axis() {
    run("VC,,,,,,,,1,.05,.1,B,8").status("failed");
    run("VC,,,,,,,,1,.05,.1,A,8").is_ok();
}

#[test]
fn sbp_val_vc_trigger_out() {
    for output in [3, 5, 12] {
        run(&format!("VC,,,,,,,,1,.05,.1,Z,{output} ⏎ PRINT %(141);\" \";%(142)"))
            .prints(&["0.05 0.1"]);
    }
    for output in [1, 2, 4] {
        run(&format!("VC,,,,,,,,1,.05,.1,Z,{output}")).fails(1, "R009");
    }
}

#[test]
fn sbp_val_vc_trigger_end() {
    sbp("MZ,-.3").after("VC,,,,,,,,1,.05,.1,Z,8 ⏎ JZ,.5").run().switches(8, &[]);
}

#[test]
fn sbp_val_vd_axes() {
    run("VD,,5 ⏎ PRINT %(27) ⏎ M5,1,2,3,4,5").ends_at([1.0, 2.0, 3.0, 4.0, 5.0]).prints(&["5"]);
    run("MA,1").fails(1, "R011").says("A");
}

#[test]
fn sbp_val_vd_units() {
    let read = "PRINT %(1);\" \";%(23);\" \";%(28);\" \";%(71);\" \";%(12);\" \";%(25) ⏎ \
        PRINT %(41);\" \";%(42);\" \";%(43);\" \";%(44)";
    run(&format!("MX,1 ⏎ VD,,,1 ⏎ {read} ⏎ VD,,,0 ⏎ {read}")).prints(&[
        "25.4 6.35 25.4 50.8 2438.4 1",
        "2.54 101.6 25.4 12.7",
        "1 0.25 1 2 96 0",
        "0.1 4 1 0.5",
    ]);
}

#[test]
fn sbp_val_vd_units_steps() {
    let run = run("VD,,,1 ⏎ PRINT %(31) ⏎ MX,25.4 ⏎ VD,,,0");
    run.prints(&["15.74803"]).ends_at([1.0]).steps(&[400]);
}

#[test]
fn sbp_val_vd_aunits() {
    run("VD,,4,,2 ⏎ MA,90 ⏎ VD,,,1 ⏎ PRINT %(4)").prints(&["90"]);
}

#[test]
fn sbp_val_vl_params() {
    run("VL,0,96,0,48,-6,6,-6,6,1,-360,360 ⏎ PRINT %(11);\" \";%(12);\" \";%(15);\" \";%(20) ⏎ MX,97")
        .prints(&["0 96 -6 360"])
        .stands_at([0.0]);
}

#[test]
fn sbp_val_vl_base() {
    let limited = "VA,0,,,,,10 ⏎ VL,0,12,,,,,,,1 ⏎";
    run(&format!("{limited} MX,1.5")).ends_at([1.5]);
    run(&format!("{limited} MX,3")).stands_at([0.0]).status("limit");
}

#[test]
fn sbp_val_vl_err() {
    run("VL,10,5").status("failed");
    sbp("PRINT %(11);\" \";%(12)").after("VL,10,5 ⏎ SV").run().prints(&["0 96"]);
}

#[test]
fn sbp_val_vl_check() {
    run("SF,1 ⏎ VL,,,,,,,,,0 ⏎ MX,97").ends_at([97.0]);
    sbp("MX,97").after("VL,,,,,,,,,1").run().ends_at([97.0]);
}

#[test]
fn sbp_val_vn_inmode() {
    run("VN,,,,1 ⏎ PRINT %(91) ⏎ VN,,,,,2 ⏎ PRINT %(92)").prints(&["1", "2"]);
    run("VN,,,,5").fails(1, "R009");
}

#[test]
fn sbp_val_vn_torch() {
    run("VN,,,1 ⏎ PRINT %(99)").prints(&["1"]);
}

#[test]
fn sbp_val_vn_outmode0() {
    run("SO,3,1 ⏎ MX,1").switches(3, &[(true, "program"), (false, "end")]);
}

#[test]
fn sbp_val_vn_outmode1() {
    run("VN,,,,,,,,,,,,,,,,,1 ⏎ SO,3,1 ⏎ MX,1").switches(3, &[(true, "program")]);
}

#[test]
fn sbp_val_vn_outmode4() {
    // Nothing but its mode switches it on, before anything moves, and nothing switches it off.
    let on = &[(true, "mode")];
    let run = sbp("MX,10").after("VN,,,,,,,,,,,,,,,,,4").run();
    run.is_ok().switches(3, on);
    assert_eq!(run.events("output").next().unwrap()["t"], 0.0, "{run}");
    let stopped = || sbp("MX,10").after("VN,,,,,,,,,,,,,,,,,4").stopped_at(1.0);
    stopped().run().status("stopped").switches(3, on);
    stopped().answers(&["hold=Resume"]).run().ends_at([10.0]).switches(3, on);
    // Output 4 is none of its business.
    sbp("MX,10").after("VN,,,,,,,,,,,,,,,,,4").run().switches(2, &[]);
}

#[test]
fn sbp_val_vo_params() {
    run("VO,1,2,1,0 ⏎ M2,5,0").visits(&[[7.0, 1.0]]);
    run("VO,1,2,1,0 ⏎ MX,5 ⏎ PRINT %(2)").ends_at([7.0, 0.0]);
    run("VO,1,2,1,0 ⏎ VO,2 ⏎ M2,5,0").ends_at([5.0, 0.0]);
    run("VO,1,2,1,0 ⏎ VO,0 ⏎ M2,5,0").ends_at([5.0, 0.0]);
}

#[test]
fn sbp_val_vo_display() {
    run("VO,1,2,1,0 ⏎ M2,5,0 ⏎ PRINT %(1);%(2)").prints(&["71"]);
}

#[test]
fn sbp_val_vo_reuse() {
    run("VO,1,2,1 ⏎ VO,2 ⏎ VO,1 ⏎ MX,5").ends_at([7.0]);
}

#[test]
fn sbp_val_vo_adds() {
    sbp("FP,p.sbp,2").file("p.sbp", "VO,1,1 ⏎ MX,2").run().ends_at([5.0]);
}

#[test]
fn sbp_val_vo_end() {
    sbp("MX,5").after("VO,1,2 ⏎ MX,1").run().ends_at([5.0]);
}

#[test]
fn sbp_val_vr_rampspeed() {
    run("VR,1 ⏎ PRINT %(81);\" \";%(82);\" \";%(83)").prints(&["1 1 0.4"]);
}

#[test]
fn sbp_val_vs() {
    let all = "PRINT %(71);\" \";%(72);\" \";%(73);\" \";%(74);\" \";%(75) ⏎ \
        PRINT %(76);\" \";%(77);\" \";%(78);\" \";%(79);\" \";%(80)";
    sbp(&format!("VS,3,1,2,50,8,4,4,100 ⏎ {all}"))
        .axes(5)
        .run()
        .prints(&["3 3 1 2 50", "8 8 4 4 100"]);
}

#[test]
fn sbp_val_vs_oldorder() {
    sbp("VS, 1.25, .45, , 2.75, .80 ⏎ PRINT %(71);\" \";%(73);\" \";%(75);\" \";%(76)")
        .axes(5)
        .run()
        .prints(&["1.25 0.45 2.75 0.8"])
        .warns(1, "W011");
}

#[test]
fn sbp_val_vr_rate() {
    // Twice the distance for the same gain of speed: half the acceleration.
    let plain = run("MX,5").is_ok().seconds();
    let slow = run("VR,,,,,,,,,.4 ⏎ MX,5").is_ok().seconds();
    let lost_s = |acceleration: f64| (2.0 - 0.4) * (2.0 - 0.4) / (2.0 * acceleration);
    assert!((slow - plain - 2.0 * (lost_s(7.0) - lost_s(14.0)) / 2.0).abs() < 1e-6);
    // The tenth value does the same for jogs, and only for them.
    let jog = |values: &str| run(&format!("{values} ⏎ JX,20")).is_ok().seconds();
    assert_eq!(jog("VR,,,,,,,,,.4"), jog("VR"));
    assert!(jog("VR,,,,,,,,,,.4") > jog("VR") + 0.1);
}

#[test]
fn sbp_val_vr_small() {
    let at_ramp_speed = |program: &str| {
        let run = run(program);
        let arc = run.is_ok().events("arc").next().unwrap();
        let seconds = arc["t1"].as_f64().unwrap() - arc["t0"].as_f64().unwrap();
        (std::f64::consts::PI * 0.4 / seconds - 0.4).abs() < 1e-3
    };
    assert!(at_ramp_speed("VR,,,,,,,,,,,,,,,,,.5 ⏎ CC,.4"));
    assert!(!at_ramp_speed("VR,,,,,,,,,,,,,,,,,.25 ⏎ CC,.4"));
}

#[test]
fn sbp_val_vu_divider() {
    let plain = run("VS,.2 ⏎ MX,1").is_ok().seconds();
    let divided = run("VU,,,,,,,,,,,,,,,4 ⏎ VS,.2 ⏎ MX,1").is_ok().seconds();
    assert!((divided / plain - 4.0).abs() < 0.01, "{plain} {divided}");
    run("VU,,,,,,,,,,,,,,,101").fails(1, "R009");
}

/// Places along Y 0 at which material stands at least so high after the cuts of a run, sampled every thousandth of an
/// inch; the material's surface is at Z 0.
fn standing(run: &kerf_ledger::Run, cutter: f64, height: f64) -> f64 {
    let ends = run.is_ok().events("move").map(|m| &m["to"]);
    let ends: Vec<[f64; 2]> =
        ends.map(|to| [to["x"].as_f64().unwrap(), to["z"].as_f64().unwrap()]).collect();
    let lowest = |x: f64| {
        let under = |pair: &[[f64; 2]]| {
            let [[x0, z0], [x1, z1]] = [pair[0], pair[1]];
            let (low, high) = (x - 0.5 * cutter, x + 0.5 * cutter);
            let share = |at: f64| ((at - x0) / (x1 - x0)).clamp(0.0, 1.0);
            let reached = x1 > x0 && x1 > low && x0 < high;
            let z = |at: f64| z0 + (z1 - z0) * share(at);
            if reached { z(low).min(z(high)) } else { 0.0 }
        };
        ends.windows(2).map(under).fold(0.0, f64::min)
    };
    let count = (0..10_000).filter(|i| lowest(f64::from(*i) * 1e-3) >= height - 1e-9).count();
    count as f64 * 1e-3
}

#[test]
fn sbp_val_vb_centre() {
    // The middle of a .25 cutter passes 1 in at the height of the tab: .75 in of it are left.
    let run = run("JZ,.2 ⏎ JX,-1 ⏎ MZ,-.5 ⏎ VB,.1,4,1,.5,1,1 ⏎ MX,11");
    assert_eq!(run.tops(-0.4).len(), 1, "{run}");
    let left = standing(&run, 0.25, -0.4);
    assert!((left - 0.75).abs() < 0.003, "{left} {run}");
    assert!((standing(&run, 0.5, -0.4) - 0.5).abs() < 0.003);
}

/// VR with one value, by its place.
fn vr(place: usize, value: &str) -> String {
    format!("VR{}{value}", ",".repeat(place))
}

/// Time over a path in one go that speeds up from .4 in/s and slows down to it at 14 in/s², seconds; inches.
fn unbroken_s(length: f64, speed: f64) -> f64 {
    (length - (speed * speed - 0.16) / 14.0) / speed + 2.0 * (speed - 0.4) / 14.0
}

/// Time that is lost where a machine slows down to a speed and speeds up again, seconds.
fn dip_s(speed: f64, slow: f64) -> f64 {
    2.0 * (speed - slow) / 14.0 - (speed * speed - slow * slow) / 14.0 / speed
}

#[test]
fn sbp_val_vr_3d() {
    // While XY runs at 4 in/s Z runs at 2 and then at 1.3: .7 is more than its ramp speed of .4, so
    // that XY slows down until the change is just that; twice the threshold allows .8, half of it .2.
    let steep = "VS,4,9 ⏎ M3,8,0,-4 ⏎ M3,16,0,-6.6";
    let with = |percent: &str, expected: f64| {
        run(&format!("{} ⏎ {steep}", vr(11, percent))).is_ok().lasts(expected);
    };
    let plain = unbroken_s(16.0, 4.0);
    with("200", plain);
    with("100", plain + dip_s(4.0, 4.0 * 0.4 / 0.7));
    with("50", plain + dip_s(4.0, 4.0 * 0.2 / 0.7));
    run(steep).lasts(plain + dip_s(4.0, 4.0 * 0.4 / 0.7));
}

#[test]
fn sbp_val_vr_mindist() {
    // Two turns of 18° each, .1 in apart, at 5.5 in/s: alone each is too slight to slow down for, but
    // together they are 36°, which is taken at (43 - 36) / 19 of the way from .4 to 65 %.
    let ((up, along), (high, far)) = (18f64.to_radians().sin_cos(), 36f64.to_radians().sin_cos());
    let (x, y) = (6.0 + 0.1 * along, 0.1 * up);
    let (to_x, to_y) = (x + 6.0 * far, y + 6.0 * high);
    let turns = format!("VS,5.5 ⏎ M2,6,0 ⏎ M2,{x:.9},{y:.9} ⏎ M2,{to_x:.9},{to_y:.9}");
    let with = |distance: &str| run(&format!("{} ⏎ {turns}", vr(12, distance)));
    with(".05").is_ok().lasts(unbroken_s(12.1, 5.5));
    let slow = 0.4 + 7.0 / 19.0 * (0.65 * 5.5 - 0.4);
    // As much is lost on the two long moves as in one dip; the short one between begins and ends slow.
    let short_s = 2.0 * ((slow * slow + 1.4f64).sqrt() - slow) / 14.0;
    let expected = unbroken_s(12.0, 5.5) + dip_s(5.5, slow) + short_s;
    with(".15").is_ok().lasts(expected);
    run(&turns).lasts(expected);
}

#[test]
fn sbp_val_vr_corner() {
    // At 5.5 in/s a corner counts from 24° on: there it is taken at the slow corner speed, and from
    // there down to ramp speed at 43°.
    let (up, along) = 24.1f64.to_radians().sin_cos();
    let corner = format!("VS,5.5 ⏎ M2,9,0 ⏎ M2,{:.9},{:.9}", 9.0 + 9.0 * along, 9.0 * up);
    let plain = unbroken_s(18.0, 5.5);
    let with = |percent: &str, share: f64| {
        let slow = 5.5 * share - 0.1 / 19.0 * (5.5 * share - 0.4);
        run(&format!("{percent} ⏎ {corner}")).is_ok().lasts(plain + dip_s(5.5, slow));
    };
    with("MX,0", 0.65);
    with(&vr(13, "30"), 0.3);
    with(&vr(13, "90"), 0.9);
    run(&corner.replace("VS,5.5", "VS,5")).is_ok().lasts(unbroken_s(18.0, 5.0));
}
