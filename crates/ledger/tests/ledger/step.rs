//! Going through a file line by line (FG).

use kerf_ledger::{Case, Run, at, sbp};

const PART: &str = "MX,1 ⏎ &a=2 ⏎ MX,&a ⏎ MX,3";

/// Steps through a part file with these answers.
fn step(part: &str, answers: &[&str]) -> Run {
    through(part).answers(answers).run()
}

fn through(part: &str) -> Case {
    sbp("FG,part.sbp").file("part.sbp", part)
}

#[test]
fn sbp_file_fg_step() {
    let quit = step(PART, &["Step", "Step", "Quit"]);
    quit.asks(&["MX,1", "&a=2", "MX,&a"]).status("stopped").visits(&[[1.0]]);
    let ask = quit.events("ask").nth(1).expect("the second line");
    assert_eq!((&ask["file"], &ask["line"]), (&"part.sbp".into(), &2.into()), "{quit}");
    assert_eq!(ask["buttons"], serde_json::json!(["Step", "Run", "Quit"]), "{quit}");
    step(PART, &["Step", "Run"]).asks(&["MX,1", "&a=2"]).ends_at([3.0]);
    step("MX,1 ⏎ ⏎ MX,2", &["Step", "Step"]).asks(&["MX,1", "MX,2"]).ends_at([2.0]);
}

#[test]
fn sbp_file_fg_step__nobody_answers() {
    through(PART).run().asks(&["MX,1"]).ends_at([3.0]).is_silent();
}

#[test]
fn sbp_file_fg_step__a_line_that_waits_is_asked_for_once() {
    let part = "MX,1 ⏎ PAUSE ⏎ MX,2";
    step(part, &["Step", "Step", "OK", "Step"])
        .asks(&["MX,1", "PAUSE", "Continue?", "MX,2"])
        .ends_at([2.0]);
}

#[test]
fn sbp_file_fg_step__files_that_it_calls_too() {
    let case = through("FP,in.sbp ⏎ MX,2").file("in.sbp", "MX,1 ⏎ MY,1");
    let stepped = case.clone().answers(&["Step", "Step", "Step", "Step"]).run();
    stepped.asks(&["FP,in.sbp", "MX,1", "MY,1", "MX,2"]).ends_at([2.0, 1.0]);
    case.answers(&["Step", "Run"]).run().asks(&["FP,in.sbp", "MX,1"]).ends_at([2.0, 1.0]);
}

#[test]
fn sbp_file_fg_step__each_line_is_made_before_the_next_is_shown() {
    let stepped = step("MX,1 ⏎ MX,2", &["Step", "Step"]);
    let asked: Vec<f64> = stepped.events("ask").filter_map(|ask| ask["t"].as_f64()).collect();
    let made: Vec<f64> = stepped.events("move").filter_map(|made| made["t1"].as_f64()).collect();
    assert!(asked[1] >= made[0] && made[0] > 0.0, "{stepped}");
}

#[test]
fn sbp_file_fg_goto() {
    let part = "&a=1 ⏎ VS,5 ⏎ MX,1 ⏎ MY,&a";
    let jumped = sbp("&a=4 ⏎ FG,part.sbp").file("part.sbp", part).answers(&["4", "Run"]).run();
    jumped.asks(&["&a=1", "MY,&a"]).visits(&[[0.0, 4.0]]);
    let set = through(part).answers(&["4 settings", "Step"]).run();
    set.asks(&["&a=1", "MY,&a"]).visits(&[[0.0, 1.0]]);
    assert_eq!(set.events("move").next().expect("a move")["speed"], 5.0, "{set}");
    step(part, &["3", "Step", "1", "Run"]).visits(&[[1.0, 0.0], [1.0, 1.0]]);
}

#[test]
fn sbp_file_fg_goto__settings_may_be_conditional_but_nothing_else_runs() {
    let part =
        "IF &z=\"\" THEN &z=3 ⏎ SO,3,1 ⏎ ZX ⏎ VA,9 ⏎ IF 1=1 THEN GOTO X ⏎ PRINT 1 ⏎ X: ⏎ MX,&z";
    let set = step(part, &["8 settings", "Step"]);
    set.visits(&[[3.0]]).prints(&[]).switches(3, &[]);
}

#[test]
fn sbp_file_fg_goto__a_line_that_is_not_there() {
    step(PART, &["9", "Run"]).asks(&["MX,1", "MX,1"]).ends_at([3.0]).warns(1, "R009");
}

#[test]
fn sbp_file_fg_params() {
    let opened = |answers: &[&str]| {
        let call = "FG,part.sbp,2,2,,,2";
        let case = sbp(&format!("M2,10,4 ⏎ {call}")).file("part.sbp", "M2,1,1 ⏎ M2,2,2");
        case.answers(answers).run()
    };
    opened(&["Quit"]).asks(&["M2,1,1"]).status("stopped").stands_at([10.0, 4.0]);
    opened(&["Step", "Quit"]).asks(&["M2,1,1", "M2,2,2"]).stands_at([12.0, 6.0]);
    let plunged = sbp("FG,part.sbp,,,,2,,-.25").file("part.sbp", "MX,1 ⏎ MX,0").run();
    plunged.ends_at([0.0]).visits(&[
        [0.0, 0.0, -0.25],
        [1.0, 0.0, -0.25],
        [0.0, 0.0, -0.25],
        [0.0, 0.0, -0.5],
        [1.0, 0.0, -0.5],
        [0.0, 0.0, -0.5],
        [0.0, 0.0, 0.0],
    ]);
}

#[test]
fn sbp_file_fg_modes() {
    let drawn = |answers: &[&str]| {
        let program = "SP ⏎ FG,part.sbp ⏎ SM ⏎ PRINT %(1)";
        sbp(program).at([7.0]).file("part.sbp", PART).answers(answers).run()
    };
    let run = drawn(&["Step", "Step", "Step", "Run"]);
    run.asks(&["MX,1", "&a=2", "MX,&a", "MX,3"]).visits(&[[1.0], [2.0], [3.0]]);
    run.prints(&["7"]);
    at([7.0], "SM ⏎ MX,1").ends_at([1.0]);
}
