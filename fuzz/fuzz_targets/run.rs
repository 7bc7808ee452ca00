//! Any bytes as a whole program, run in preview or on the simulated machine, with switches that
//! close on the way: never a panic, always an end, and the same again when it is saved and restored.
#![no_main]

use kerf_control::{TextOptions, run_text};
use kerf_journal::RunOptions;
use kerf_trace::{Event, json};
use kerf_model::Change;
use libfuzzer_sys::fuzz_target;

/// Lines that are run at most.
const LINES: u64 = 500;

fn trace(text: &str, how: u8, restore: bool) -> Vec<String> {
    let change = |input, at_s| Change { input, at_s, on: true };
    let inputs = if how & 2 == 0 { Vec::new() } else { vec![change(1, 0.5), change(3, 2.0)] };
    let mut run = RunOptions { inputs, restore, ..RunOptions::default() };
    run.program.preview = how & 1 == 0;
    run.program.allow_errors = true;
    run.program.max_lines = LINES;
    run.lines_at_once = if restore { 5 } else { 0 };
    let options =
        TextOptions { run, answers: "pause=OK\nmsgbox=Yes\n2\n".into(), ..TextOptions::default() };
    let files = [("a.sbp", text), ("b.sbp", "SR\nMX,1\nSA\n")];
    let outcome = run_text(&files, "a.sbp", options);
    assert!(matches!(outcome.events.last(), Some(Event::End(_))));
    outcome.events.iter().map(json::to_string).collect()
}

fuzz_target!(|bytes: &[u8]| {
    let Some((how, bytes)) = bytes.split_first() else { return };
    let text = String::from_utf8_lossy(bytes);
    assert_eq!(trace(&text, *how, false), trace(&text, *how, true));
});
