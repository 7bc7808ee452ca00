//! The fast road gives what the step gives.

use super::host_with;
use crate::testing::{FakeHost, Ran, drive};
use crate::{Options, Session};
use kerf_program::Command;
use proptest::prelude::*;

/// A value of a plain move; blank in one of four.
fn value() -> impl Strategy<Value = String> {
    prop_oneof![
        1 => Just(String::new()),
        1 => Just("0".to_owned()),
        2 => (-40..40i32).prop_map(|n| format!("{}", f64::from(n) / 8.0)),
    ]
}

/// A plain move or jog of one axis or of the first ones.
fn plain() -> impl Strategy<Value = String> {
    let several = (2..=5usize, proptest::collection::vec(value(), 5), any::<bool>());
    let several = several.prop_map(|(count, values, jog)| {
        format!("{}{count},{}", if jog { 'J' } else { 'M' }, values[..count].join(","))
    });
    let single = (prop_oneof!["M", "M", "J"], prop_oneof!["[XYZXYZA]"], -40..40i32);
    let single = single.prop_map(|(kind, axis, n)| format!("{kind}{axis},{}", f64::from(n) / 8.0));
    prop_oneof![3 => several, 2 => single]
}

/// A line that changes what plain moves mean, or what they leave behind.
fn special() -> impl Strategy<Value = String> {
    prop_oneof![
        3 => prop_oneof!["SA", "SR"],
        2 => prop_oneof!["VD,,,0", "VD,,,1", "VD,,3", "VD,,5"],
        2 => (-9..9i32, 0..360i32).prop_map(|(n, turn)| format!("MD,{},{turn}R", f64::from(n) / 4.0)),
        1 => prop_oneof!["ZX", "Z2", "Z3", "ZZ", "VA,1,2,3", "VA,,,,,,.5", "ZT", "ST"],
        2 => (-9..9i32, -9..9i32).prop_map(|(x, z)| format!("VO,1,{x},,{z}")),
        2 => Just("VO,2".to_owned()),
        2 => prop_oneof!["VB,.1,.5,.2,.1,1", "VB,.1,.5,.2,.1,1", "VB,,,,,0"],
        1 => prop_oneof!["ON INPUT(1,1) GOTO Done", "ON INPUT(1,1)", "PAUSE 1"],
        1 => prop_oneof!["CC,2,T,1,0,90", "CG,,1,1,.5,.5", "MH"],
        1 => prop_oneof!["&x=%(1)", "PRINT %(1),%(2),%(3)", "SO,1,1", "'a comment", "MS,3,2", ""],
        1 => prop_oneof!["MI,B,1,.5", "MI,B,1,0", "MO"],
    ]
}

fn lines(most: usize) -> impl Strategy<Value = String> {
    let line = prop_oneof![3 => plain(), 1 => special()];
    proptest::collection::vec(line, 1..most).prop_map(|lines| lines.join("\n"))
}

/// A call of the other file: proportions, repetitions, offset and plunge.
fn call() -> impl Strategy<Value = String> {
    let factor = || prop_oneof!["1", "2", ".5", "-1", ""];
    let called = (factor(), factor(), factor(), 1..3u32, 0..3u32, prop_oneof!["", "-.25"]);
    called.prop_map(|(x, y, z, times, offset, plunge)| {
        format!("FP,part.sbp,{x},{y},{z},{times},{offset},{plunge}")
    })
}

/// Runs a program to its end, each time so many lines at once; step by step without a number. The input of a handler
/// changes behind a pause or SO off, and axes that move by themselves end far away.
fn run(text: &str, part: &str, max_lines: u64, at_once: Option<u64>) -> Ran {
    let mut session = Session::default();
    session.settings.controller.independent = true;
    let options = Options { max_lines, ..Options::default() };
    let host = FakeHost { strays_to: Some([9.0; 6]), ..host_with(&[("part.sbp", part)]) };
    drive(text, host, session, options, |interpreter, host, out| {
        let step = match at_once {
            Some(lines) => interpreter.run(host, out, lines),
            None => interpreter.step(host, out),
        };
        let last = out.last().map(|last| &last.command);
        let now = matches!(last, Some(Command::Wait { .. } | Command::Output { on: false, .. }));
        let watch = interpreter.watches().next().cloned().filter(|_| now);
        if let Some(watch) = watch {
            interpreter.interrupt(&watch, None, interpreter.position());
        }
        step
    })
}

/// Checks that both roads give the same.
fn same(text: &str, part: &str, max_lines: u64, at_once: u64) -> Result<(), TestCaseError> {
    let slow = run(text, part, max_lines, None);
    let fast = run(text, part, max_lines, Some(at_once));
    prop_assert_eq!(&slow.commands, &fast.commands, "{}\n--- part.sbp\n{}", text, part);
    prop_assert_eq!(slow.status, fast.status);
    prop_assert_eq!(slow.error, fast.error);
    prop_assert_eq!(slow.session, fast.session);
    prop_assert_eq!(slow.counts, fast.counts);
    prop_assert_eq!(slow.host.settles, fast.host.settles, "{}\n--- part.sbp\n{}", text, part);
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 600, max_shrink_iters: 4_000, ..ProptestConfig::default() })]

    #[test]
    fn the_fast_road_gives_what_the_step_gives(
        before in lines(12),
        call in call(),
        after in lines(12),
        part in lines(10),
        at_once in 1..30u64,
        max_lines in prop_oneof![4 => Just(2_000), 1 => 1..30u64],
    ) {
        let text = format!("VD,,5\n{before}\n{call}\n{after}\nDone:\n&end=%(1)\nMD,1,0R");
        same(&text, &part, max_lines, at_once)?;
    }
}

/// Loops that move, handlers that fired, tabs and axes that move by themselves.
#[test]
fn what_is_rare_is_the_same_on_both_roads() {
    for text in [
        "SR\nL:\nMX,1\nGOTO L",
        "SR\nL:\nMX,1\nPRINT %(1)\nGOTO L",
        "ON INPUT(1,1) GOSUB Hit\nMX,5\nPAUSE 3\nMY,1\nMX,2\nEND\nHit:\nMZ,1\nMZ,2\nRETURN",
        "ON INPUT(1,1) MZ,1\nMX,5\nPAUSE 3\nMY,1\nMX,2\nPRINT %(51)",
        "ON INPUT(1,1) MZ,1\nMX,5\nSO,1,0\nMY,1\nMX,2",
        "VB,.1,.5,.2,.1,1\nMZ,-.5\nMX,5\nMY,5\nVB,,,,,0\nMX,0",
        "VD,,5\nMI,B,1,.5\nMX,1\nMB,3",
        "VD,,5\nMI,B,1,.5\nMX,1\nMI,B,1,0\nMX,2\nMY,1",
    ] {
        for at_once in [1, 2, 5, 50] {
            same(text, "", 300, at_once).unwrap_or_else(|error| panic!("{text}: {error}"));
        }
    }
}
