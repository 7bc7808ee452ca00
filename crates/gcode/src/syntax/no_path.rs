//! Codes of a program that have nothing to do with its path: what a drawing leaves out.

use crate::syntax::tree::Program;
use crate::syntax::tree::Value;
use std::collections::BTreeMap;

/// The codes of a program that its path does not need, with their counts, as a person reads them:
/// `ignored: G4 1, M6 2`. Dwells, cycles of drilling, and all M codes but those of subroutines.
pub fn no_path(program: &Program) -> Option<String> {
    let mut counts: BTreeMap<(u8, u32), usize> = BTreeMap::new();
    for word in &program.words {
        let Value::Number(code) = word.value else { continue };
        let is_plain = (0.0..1000.0).contains(&code) && code.fract() == 0.0;
        let code = if is_plain { code as u32 } else { continue };
        if needs_no_path(word.letter, code) {
            *counts.entry((word.letter, code)).or_default() += 1;
        }
    }
    let told: Vec<String> = counts
        .iter()
        .map(|((letter, code), count)| format!("{}{code} {count}", char::from(*letter)))
        .collect();
    (!told.is_empty()).then(|| format!("ignored: {}", told.join(", ")))
}

fn needs_no_path(letter: u8, code: u32) -> bool {
    match letter {
        b'G' => matches!(code, 4 | 73 | 81..=89),
        b'M' => !matches!(code, 98 | 99),
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_are_counted() {
        let told = |text: &str| no_path(&crate::read("a.nc".into(), text.as_bytes()));
        let text = "G4 P1\nG81 X5 Y5 Z-2 R1 F50\nM6 T2\nM3 S12000\nG1 X3\nM3\nM30\n";
        assert_eq!(told(text).as_deref(), Some("ignored: G4 1, G81 1, M3 2, M6 1, M30 1"));
        assert_eq!(told("G0 X1\nG1 X2 F500\n"), None);
    }
}
