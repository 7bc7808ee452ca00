//! The use of inputs as a file declares it.

use super::facts::Facts;
use crate::syntax::Program;
use crate::syntax::tree::Statement;
use kerf_diag::{Code, Diagnostic};
use kerf_program::settings::LinearUnit;

/// Index of the first input mode in VN, and the inputs that have their modes from there on.
const FIRST: usize = 3;
const INPUTS: [u8; 11] = [1, 2, 3, 5, 6, 7, 8, 9, 10, 11, 12];

/// The field of VD that says what moves the tool at the keypad, and the pendant there.
const REMOTE: usize = 8;
const PENDANT: f64 = 1.0;

/// Lines of a file that make a limit or a stop of an input which is a key of the pendant. They are errors of a file on
/// that machine: `keys` are the inputs of its pendant, `present` whether it is in use before the file begins.
pub fn stops_on_keys(program: &Program, keys: &[u8], present: bool) -> Vec<Diagnostic> {
    let facts = Facts::new(program, LinearUnit::default());
    let (mut present, mut found) = (present, Vec::new());
    for (line, statement) in facts.lines() {
        let Statement::Command { spec, args, .. } = statement else { continue };
        if spec.letters == "VD" {
            present = facts.literal(*args, REMOTE).map_or(present, |remote| remote == PENDANT);
        }
        if spec.letters != "VN" || !present {
            continue;
        }
        let mode = |(index, input): (usize, u8)| Some((facts.literal(*args, index)?, input));
        let modes = (FIRST..).zip(INPUTS).filter_map(mode);
        for (_, input) in modes.filter(|(mode, input)| *mode != 0.0 && keys.contains(input)) {
            let message =
                format!("input {input} is a key of the pendant and cannot stop the machine");
            let hint = "give VN 0 for it, or another input to the key (pendant in the settings)";
            let place = program.place(line, facts.whole(line));
            found.push(Diagnostic::new(Code::OutOfRange, place, message).hint(hint));
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stop_on_a_key_is_an_error_where_there_is_a_pendant() {
        let check = |text: &str, present: bool, lines: &[u32]| {
            let program = crate::syntax::read_part("a.sbp".into(), text.as_bytes());
            let found = stops_on_keys(&program, &[5, 6], present);
            let told: Vec<u32> = found.iter().map(|one| one.place.line).collect();
            assert_eq!(told, lines, "{text}");
        };
        check("MX,1\nVN,,,,,,,3\n", true, &[2]);
        check("MX,1\nVN,,,,,,,3\n", false, &[]);
        check("VN,,,,3,3,3,0,2\n", true, &[1]);
        check("VN,,,,3,3,3,0,0\n", true, &[]);
        check("VD,,,,,,,,,1\nVN,,,,,,,1,1\n", false, &[2, 2]);
        check("VD,,,,,,,,,0\nVN,,,,,,,1,1\n", true, &[]);
    }
}
