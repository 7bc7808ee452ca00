//! Any bytes as a part file: reading, checking and formatting never panic, every line is one node,
//! and formatting is done after one round.
#![no_main]

use kerf_program::settings::LinearUnit;
use kerf_sbp::{check, format, read};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let program = read("fuzz.sbp".into(), bytes);
    if bytes.contains(&0) {
        assert!(program.lines.is_empty() && program.has_errors());
        return;
    }
    let text = program.text.replace("\r\n", "\n").replace('\r', "\n");
    let open_end = usize::from(!text.is_empty() && !text.ends_with('\n'));
    assert_eq!(program.lines.len(), text.matches('\n').count() + open_end);
    check(&program, Some(LinearUnit::Inch));
    check(&program, None);
    let once = format(&program.text);
    assert_eq!(format(&once), once);
});
