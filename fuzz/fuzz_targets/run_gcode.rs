//! Any bytes as a G-code file, alone or called by FP, with a probe that closes on the way: never a panic,
//! always an end, and the same again when it is saved and restored.
#![no_main]

use kerf_control::{TextOptions, run_text};
use kerf_journal::RunOptions;
use kerf_trace::{Event, json};
use kerf_model::Change;
use libfuzzer_sys::fuzz_target;

/// Lines that are run at most.
const LINES: u64 = 500;

fn trace(text: &str, how: u8, restore: bool) -> Vec<String> {
    let inputs = vec![Change { input: 1, at_s: 0.5, on: how & 2 != 0 }];
    let mut run = RunOptions { inputs, restore, ..RunOptions::default() };
    run.program.preview = how & 1 == 0;
    run.program.allow_errors = true;
    run.program.max_lines = LINES;
    run.gcode.keep_going = how & 8 != 0;
    run.lines_at_once = if restore { 5 } else { 0 };
    let options = TextOptions { run, ..TextOptions::default() };
    let files = [("a.nc", text), ("b.sbp", "FP,a.nc,2,2,1,2\nG1 X1 F60\n"), ("1.ngc", "G1 X2 F9")];
    let main = if how & 4 == 0 { "a.nc" } else { "b.sbp" };
    let outcome = run_text(&files, main, options);
    assert!(matches!(outcome.events.last(), Some(Event::End(_))));
    outcome.events.iter().map(json::to_string).collect()
}

fuzz_target!(|bytes: &[u8]| {
    let Some((how, bytes)) = bytes.split_first() else { return };
    let text = String::from_utf8_lossy(bytes);
    assert_eq!(trace(&text, *how, false), trace(&text, *how, true));
});
