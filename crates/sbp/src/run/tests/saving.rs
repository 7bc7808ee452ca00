//! Saving and restoring between any two steps, waiting without effect, reading ahead.

use super::rig::Rig;
use crate::{Interpreter, Step};
use kerf_program::Sourced;
use proptest::prelude::*;

const FILES: [(&str, &str); 4] = [
    ("b.sbp", "MX,7 ⏎ &a=&a+1 ⏎ MY,&a ⏎ GOSUB S ⏎ END ⏎ S: ⏎ PRINT \"in b\" ⏎ RETURN"),
    ("c.sbp", "SR ⏎ FP,b.sbp,2 ⏎ MZ,.1 ⏎ SA"),
    ("d.txt", "1, two ⏎ \"3,4\" ⏎ 5"),
    ("custom9.sbc", "MZ,2 ⏎ ON INPUT(4,1) &hit=&a"),
];

/// Lines that programs are thrown together from.
const LINES: [&str; 31] = [
    "MX,1",
    "MX,&a",
    "M2,&b,&a/3",
    "JZ,.3",
    "&a=&a+1",
    "&b=RND(1)",
    "&c=\"text \" & &a",
    "PRINT &a, &c",
    "IF &a<4 THEN GOTO L",
    "IF &a>6 THEN END",
    "GOSUB S",
    "FP,b.sbp,,,,2",
    "FP,b.sbp,2,,,2,2,-.25",
    "FP,c.sbp,,,,,1",
    "C9",
    "Z3",
    "PAUSE 1",
    "PAUSE RND(1)",
    "PRINT &b, RND(1)",
    "IF &c > &a THEN PAUSE",
    "PAUSE",
    "'a comment",
    "OPEN \"d.txt\" FOR INPUT AS #1",
    "INPUT #1, &d",
    "OPEN \"o.txt\" FOR APPEND AS #2",
    "WRITE #2, &a, &b",
    "CLOSE",
    "SetUsrVal, &a",
    "ON INPUT(3,1) &hit=&a",
    "ON INPUT(3,1) GOSUB S",
    "ON INPUT(3,1) GOTO E",
];

fn program() -> impl Strategy<Value = String> {
    prop::collection::vec(prop::sample::select(&LINES[..]), 1..25).prop_map(|lines| {
        let body = lines.join(" ⏎ ");
        format!(
            "&a=0 ⏎ &b=0 ⏎ &hit=0 ⏎ L: ⏎ {body} ⏎ END ⏎ S: ⏎ &a=&a+2 ⏎ MY,&a ⏎ RETURN ⏎ E: ⏎ MX,0"
        )
    })
}

/// Programs that always reach the moves: what cannot fail.
fn moving_program() -> impl Strategy<Value = String> {
    let calm: Vec<_> = LINES[..10].iter().chain(&LINES[11..14]).copied().collect();
    prop::collection::vec(prop::sample::select(calm), 1..15).prop_map(|lines| {
        let body = lines.join(" ⏎ ");
        format!(
            "&a=0 ⏎ &b=0 ⏎ &hit=0 ⏎ ON INPUT(3,1) &hit=&a ⏎ MX,.5 ⏎ L: ⏎ {body} ⏎ END ⏎ E: ⏎ MX,0"
        )
    })
}

fn saved(interpreter: &Interpreter) -> String {
    serde_json::to_string(interpreter).unwrap()
}

fn restored(text: &str) -> Interpreter {
    serde_json::from_str(text).unwrap()
}

/// Everything that can be seen of a run.
fn outcome(rig: &Rig) -> (Vec<Sourced>, String) {
    (rig.out.clone(), saved(&rig.interpreter))
}

/// The centre of the last CG belongs to the state: the next one may leave it out.
#[test]
fn restoring_keeps_the_centre_of_an_arc() {
    let text = "CG,,2,-2,0,-2 ⏎ M2,0,0 ⏎ CG,,2,-2";
    let (mut plain, mut rig) = (Rig::new(text, &FILES), Rig::new(text, &FILES));
    plain.finish();
    while rig.done.is_none() {
        rig.step();
        rig.interpreter = restored(&saved(&rig.interpreter));
        rig.come_to_rest();
    }
    assert_eq!((rig.out, rig.done), (plain.out, plain.done));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn restoring_after_every_step_changes_nothing(text in program()) {
        let mut plain = Rig::new(&text, &FILES);
        plain.finish();
        let mut rig = Rig::new(&text, &FILES);
        while rig.done.is_none() {
            rig.step();
            rig.interpreter = restored(&saved(&rig.interpreter));
            rig.come_to_rest();
        }
        prop_assert_eq!(rig.out, plain.out);
        prop_assert_eq!(rig.done, plain.done);
        prop_assert_eq!(rig.interpreter.into_session(), plain.interpreter.into_session());
    }

    #[test]
    fn a_clone_runs_as_the_original_does(text in program(), steps in 0usize..40) {
        let mut rig = Rig::new(&text, &FILES);
        for _ in 0..steps {
            rig.step();
            rig.come_to_rest();
        }
        let copy = rig.interpreter.clone();
        let before = saved(&copy);
        // The original runs on; the copy must not notice.
        rig.finish();
        prop_assert_eq!(saved(&copy), before);
    }

    #[test]
    fn a_step_that_waits_has_no_effect(text in program()) {
        let mut plain = Rig::new(&text, &FILES);
        plain.finish();
        let mut rig = Rig::new(&text, &FILES);
        rig.host.hesitant = true;
        while rig.done.is_none() {
            let before = saved(&rig.interpreter);
            match rig.step() {
                Step::Waiting => prop_assert_eq!(saved(&rig.interpreter), before),
                _ => rig.host.hesitated = false,
            }
            rig.come_to_rest();
        }
        prop_assert_eq!(rig.out, plain.out);
    }

    #[test]
    fn an_interrupt_finds_the_state_behind_its_move(text in moving_program(), nth in 1u64..8) {
        // Read ahead as far as possible, then interrupted …
        let mut ahead = Rig::new(&text, &FILES);
        ahead.read_ahead();
        // An error, or the bound of lines, ends the run before any of the stack moves.
        prop_assume!(ahead.done.is_none());
        let motion = nth.min(ahead.interpreter.motions());
        ahead.fires(3, 1, motion, [0.25, 0.5, 0.75]).finish();
        // … or interrupted before anything behind the move was read.
        let mut strict = Rig::new(&text, &FILES);
        while strict.interpreter.motions() < motion {
            strict.step();
        }
        strict.fires(3, 1, motion, [0.25, 0.5, 0.75]).finish();
        prop_assert_eq!(outcome(&ahead), outcome(&strict));
    }
}
