//! Stacks of moves.

use kerf_ledger::{Run, run, sbp};

fn times(run: &Run) -> Vec<[f64; 2]> {
    let time = |m: &serde_json::Value, key: &str| m[key].as_f64().unwrap();
    run.is_ok().events("move").map(|m| [time(m, "t0"), time(m, "t1")]).collect()
}

/// Tells whether the machine stands after the first move: then it lasts as long as alone.
fn stands_after_first(program: &str) -> bool {
    let first = times(&run(program))[0];
    let alone = times(&run("MX,5"))[0];
    ((first[1] - first[0]) - (alone[1] - alone[0])).abs() < 1e-9
}

#[test]
fn sbp_motion_stack() {
    let run = run("MX,5 ⏎ SO,3,1 ⏎ CC,4 ⏎ MY,2");
    let switched = run.events("output").find(|e| e["n"] == 3).unwrap()["t"].as_f64().unwrap();
    let first = times(&run)[0];
    assert_eq!(switched, first[1], "{run}");
    assert!(!stands_after_first("MX,5 ⏎ SO,3,1 ⏎ MX,10"));
}

#[test]
fn sbp_motion_stack_end() {
    for ends in ["J2,0,0", "PRINT 1", "PAUSE 0", "MS,2", "JS,6", "&a=%(51)", "ON INPUT(3,1)"] {
        assert!(stands_after_first(&format!("MX,5 ⏎ {ends} ⏎ MX,10")), "{ends}");
    }
    for joins in ["'note", "L:", "VS,2", "&a=1", "IF 1=1 THEN &a=1", "GOTO L ⏎ L:"] {
        assert!(!stands_after_first(&format!("MX,5 ⏎ {joins} ⏎ MX,10")), "{joins}");
    }
    let run = run("&i=0 ⏎ L: ⏎ &i=&i+1 ⏎ MX,&i ⏎ IF &i<5 THEN GOTO L");
    let whole = times(&sbp("MX,5").run())[0];
    let last = times(&run)[4];
    assert!((last[1] - whole[1]).abs() < 1e-9, "{run}");
}

#[test]
fn sbp_motion_stack_nostart() {
    let nothing = run("MX,5 ⏎ MY,5 ⏎ MZ,1/0");
    nothing.status("failed").stands_at([0.0, 0.0]).fails(3, "R003").says("2 moves were read");
    run("MX,5 ⏎ PAUSE 1 ⏎ MZ,1/0").status("failed").stands_at([5.0]).fails(3, "R003");
    // A file that cannot be read does not start at all.
    run("MX,5 ⏎ PAUSE 1 ⏎ QQ,1").status("failed").stands_at([0.0]);
}

#[test]
fn sbp_motion_switchoff_stack() {
    assert!(stands_after_first("MX,5 ⏎ SO,3,0 ⏎ MX,10"));
    assert!(!stands_after_first("MX,5 ⏎ SO,3,1 ⏎ MX,10"));
}

#[test]
fn sbp_motion_stack_full() {
    let count = "&i=0 ⏎ L: ⏎ &i=&i+1 ⏎ M3,&i/1000,0,-.1 ⏎ IF &i<1500 THEN GOTO L";
    let heights = |run: &Run| -> Vec<(u64, f64)> {
        let to = |m: &serde_json::Value| m["to"]["z"].as_f64().unwrap();
        let moves: Vec<f64> = run.is_ok().events("move").map(to).collect();
        (0u64..).zip(moves).filter(|(_, z)| *z != -0.1).collect()
    };
    let limited = sbp(count).at([0.0, 0.0, -0.1]).stack_limit(1000).run();
    // After a thousand moves up to Safe-Z, 1 in; then down, then the other five hundred.
    assert_eq!(heights(&limited), [(1000, 1.0)]);
    assert_eq!(limited.events("move").count(), 1502);
    let kind = |k: usize| limited.events("move").nth(k).unwrap()["kind"].clone();
    assert_eq!((kind(1000), kind(1001)), ("jog".into(), "cut".into()));
    limited.ends_at([1.5, 0.0, -0.1]);
    let free = sbp(count).at([0.0, 0.0, -0.1]).run();
    assert_eq!((heights(&free).len(), free.events("move").count()), (0, 1500));
    // With Safe-Z off it only stands for a moment.
    let off = sbp(&format!("VC,,,,OFF ⏎ {count}")).at([0.0, 0.0, -0.1]).stack_limit(1000).run();
    assert_eq!((heights(&off).len(), off.events("move").count()), (0, 1500));
    assert!(off.seconds() > free.seconds());
}

#[test]
fn sbp_cmd_speed_vector() {
    // Ramp speed 5 leaves no ramps.
    let lasts = |program: &str| {
        let run = run(&format!("VR,5 ⏎ VS,2 ⏎ {program}"));
        run.seconds()
    };
    assert!((lasts("M2,3,4") - 2.5).abs() < 1e-6);
    assert!((lasts("CC,4") - 4.0 * std::f64::consts::PI / 2.0).abs() < 1e-6);
}
