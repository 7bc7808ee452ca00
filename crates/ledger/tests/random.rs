//! Programs thrown together from plausible lines, run whole: they never panic, they end with a
//! status, and the same program does the same again, also when it is saved and restored between.

use kerf_control::{TextOptions, run_text};
use kerf_journal::RunOptions;
use kerf_model::Change;
use kerf_trace::{Event, json};
use proptest::prelude::*;
use proptest::strategy::Union;
use proptest::test_runner::TestRunner;

/// Number of programs that are tried.
const PROGRAMS: u32 = 150;

/// A file that programs call.
const PART: &str = "SR\nM2,1,1\nMZ,-.1\nJZ,.2\nSA\nIF &a > 3 THEN END\n&a=&a+1\n";

/// Values as people write them.
const VALUES: &[&str] = &[
    "1", "-.25", ".5", "2.5", "&a", "&b", "&b/2", "(&a+1)*2", "%(1)", "%(3)+.5", "", "3", "SQR(&b)",
];

/// Values that are seldom what a command wants.
const ODD: &[&str] = &[
    "0", "100", "1e6", "-1", "&none", "text", "\"1\"", "%(25)", "1/&z", "12", "90", "-360", "1e300",
];

/// Lines; each `#` becomes a value.
const LINES: &[&str] = &[
    "MX,#",
    "M2,#,#",
    "M3,#,#,#",
    "MZ,#",
    "JZ,#",
    "J2,#,#",
    "J3,#,#,#",
    "CC,2,T,1,0,90,-.1,2",
    "CC,#,T,1",
    "CC,1,I,-1,0,360,-.1,1,1,1,,1",
    "CG,,%(1)+1,%(2),.5,0,T,1,#",
    "CG,,%(1),%(2)+1,0,.5,T,-1",
    "CR,3,2,I,1,1,-.1,2,1",
    "CR,#,#,O,-1,2",
    "CP,1,#,#,O,1",
    "CA,4,1,T,1",
    "MH",
    "JH",
    "MD,#,30",
    "VS,2,1,,,4,3",
    "MS,3,#",
    "VR,.4,.2",
    "VA,#,#,#",
    "VC,.25",
    "VB,.1,2,.5,.2",
    "VD,,,1",
    "VD,,,0",
    "VL,-9,50,-9,50",
    "SF,1",
    "VO,1,.5,.5",
    "SA",
    "SR",
    "SM",
    "SP",
    "SL",
    "SO,3,#",
    "SO,1,1",
    "SO,1,0",
    "ZX",
    "Z3",
    "ZT",
    "ST",
    "TR,9000",
    "C6",
    "C7",
    "FP,part.sbp",
    "FP,part.sbp,2,1,1,2,2,-.1",
    "FP,part.sbp,#,#,1",
    "FP,part.sbp,1,1,1,3,1,-.1,1,1",
    "GOSUB Sub",
    "GOTO Next",
    "IF &a < 3 THEN GOTO Top",
    "IF # > # THEN GOTO Next",
    "IF &a = # THEN MX,#",
    "IF %(22) = 1 THEN &b = 2",
    "IF %(51) = 1 THEN &b = 3",
    "&a = &a + 1",
    "&a = 0",
    "&b = # + 1",
    "&c = \"t\" & &a",
    "&d := #",
    "$kept = #",
    "PRINT #, #",
    "PRINT \"a\"; &a;",
    "INPUT \"How much?\" &b",
    "PAUSE 1",
    "PAUSE .5",
    "PAUSE",
    "PAUSE UNTIL 1,1",
    "MSGBOX(Go on with &a?,YesNo,Ask)",
    "'a comment",
    "'Toolpath Name = one",
    "ON INPUT(1,1) GOTO Next",
    "ON INPUT(2,0) &b = %(1)",
    "ON INPUT(3,1) GOSUB Sub",
    "ON INPUT(1,1)",
    "&a = RND(1)",
];

/// Lines that often end a program.
const SELDOM: &[&str] = &[
    "M5,#,#,#,#,#",
    "CG,#,#,#,#,#,T,1",
    "VU,#",
    "VD,,#",
    "VN,#",
    "VI,#",
    "VP,#,#",
    "MI,X,#",
    "C9",
    "FS,sub",
    "SW,#",
    "PAUSE #",
    "OPEN \"o.txt\" FOR OUTPUT AS #1",
    "OPEN \"part.sbp\" FOR INPUT AS #2",
    "WRITE #1; &a",
    "CLOSE",
    "INPUT #2, &c",
    "RETURN",
    "END",
    "ENDALL",
    "GOTO Top",
    "G1 X1 Y1 F20",
    "?? what",
    "VS,#,#",
    "VR,#,#",
    "C#,1",
];

fn line() -> impl Strategy<Value = String> {
    let value = prop_oneof![30 => prop::sample::select(VALUES), 1 => prop::sample::select(ODD)];
    let line = prop_oneof![40 => prop::sample::select(LINES), 1 => prop::sample::select(SELDOM)];
    (line, prop::collection::vec(value, 8)).prop_map(|(line, values)| {
        let mut values = values.iter();
        let parts = line.split('#').enumerate();
        // In OPEN, WRITE, INPUT and C# the sign is the language's own.
        let own = ["OPEN", "WRITE", "INPUT #", "C#"].iter().any(|word| line.starts_with(word));
        parts.fold(String::new(), |text, (n, part)| match (n, own) {
            (0, _) => part.to_owned(),
            (_, true) => text + "#" + part,
            (_, false) => text + values.next().unwrap() + part,
        })
    })
}

fn program() -> impl Strategy<Value = String> {
    prop::collection::vec(line(), 1..40).prop_map(|lines| {
        let half = lines.len() / 2;
        let (first, second) = (lines[..half].join("\n"), lines[half..].join("\n"));
        format!("&a=0\n&b=1\nTop:\n{first}\nNext:\n{second}\nEND\nSub:\n&b=&b+1\nMY,&b\nRETURN\n")
    })
}

fn change() -> impl Strategy<Value = Change> {
    (1..13_u8, 0.0..60.0_f64, any::<bool>()).prop_map(|(input, at_s, on)| Change {
        input,
        at_s,
        on,
    })
}

fn trace(program: &str, inputs: &[Change], preview: bool, restore: bool) -> String {
    let mut run = RunOptions { inputs: inputs.to_vec(), restore, ..RunOptions::default() };
    run.program.preview = preview;
    run.program.max_lines = 2000;
    run.program.allow_errors = true;
    run.lines_at_once = if restore { 7 } else { 0 };
    let options = TextOptions {
        run,
        answers: "input=2\nmsgbox=Yes\npause=OK\n".into(),
        ..TextOptions::default()
    };
    let outcome = run_text(&[("a.sbp", program), ("part.sbp", PART)], "a.sbp", options);
    assert!(matches!(outcome.events.last(), Some(Event::End(_))), "{program}");
    let lines: Vec<String> = outcome.events.iter().map(json::to_string).collect();
    lines.join("\n")
}

#[test]
fn whole_programs_end_and_do_the_same_again() {
    let mut runner = TestRunner::new_with_rng(
        ProptestConfig { cases: PROGRAMS, failure_persistence: None, ..ProptestConfig::default() },
        TestRunner::deterministic().rng().clone(),
    );
    let inputs = prop::collection::vec(change(), 0..6);
    let how = Union::new([Just(true), Just(false)]);
    let tried = runner.run(&(program(), inputs, how), |(program, inputs, preview)| {
        let once = trace(&program, &inputs, preview, false);
        prop_assert_eq!(&once, &trace(&program, &inputs, preview, false));
        prop_assert_eq!(&once, &trace(&program, &inputs, preview, true), "restored");
        prop_assert!(!once.contains("NaN") && !once.contains("\"t\":null"), "{}", once);
        Ok(())
    });
    tried.unwrap();
}
