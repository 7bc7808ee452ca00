//! The page of the hand console's functions, made from the table that carries them out.

use crate::Tree;
use anyhow::Result;
use kerf_handconsole::digitizing;
use kerf_handconsole::functions::{FUNCTIONS, Step};
use std::fmt::Write as _;

const FUNCTIONS_PAGE: &str = "\
<!-- Written by `make book` from the functions of crates/handconsole. Do not edit. -->

# Functions of the hand console

`Func`, the number, `Enter`. What a function asks for is typed, with `+/-` for the sign and `File` for the point, and `Enter`
goes on; the present value stands there first, and `Enter` alone keeps it. A value that the machine does not take is
refused with a beep, and asked for again.

Settings that are changed here hold at once, for everybody, and until Kerf ends; function 11 keeps them. What is decided
about the open job holds as long as it is open; function 10 writes origin, finish position and start shape into its file.

";

const DIGITIZING: &str = "
## While digitizing

Function 70 begins [digitizing](digitizing.md), with functions of its own behind `Func`. 20 and 21 ask for Z too in 3D.

";

/// The page.
///
/// # Errors
/// Never; pages share one form.
pub fn functions(_: &Tree) -> Result<String> {
    let mut page = FUNCTIONS_PAGE.to_owned();
    page += "| number | name | asks for | does |\n|---|---|---|---|\n";
    for function in FUNCTIONS {
        let asks: Vec<_> = function.steps.iter().map(prompt).collect();
        let (number, name, does) = (function.number, function.name, function.doc);
        let asks = asks.join("; ");
        let _ = writeln!(page, "| {number} | {name} | {asks} | {does} |");
    }
    page += DIGITIZING;
    page += "| number | name | does |\n|---|---|---|\n";
    for entry in digitizing::FUNCTIONS {
        let _ = writeln!(page, "| {} | {} | {} |", entry.number, entry.name, entry.doc);
    }
    Ok(page)
}

fn prompt(step: &Step) -> &str {
    let (Step::Number { prompt, .. } | Step::Height { prompt, .. }) = step;
    prompt.trim_end_matches(':')
}
