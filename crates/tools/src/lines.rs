//! Lines of OpenSBP that several tools write.

use crate::Entries;
use kerf_program::decimal;

/// A number as part files have it: ten thousandths are enough for wood and metal.
pub fn number(value: f64) -> String {
    decimal(value, 4)
}

/// The head of a part file: what made it, the check of units, absolute distances.
pub fn head(title: &str, entries: &Entries<'_>) -> Vec<String> {
    // %(25) is 1 where the machine is set to millimetres.
    let (other, unit) = if entries.metric() { (0, "millimetres") } else { (1, "inches") };
    vec![
        format!("'{title}"),
        format!("'Units: {unit}"),
        format!("IF %(25) = {other} THEN GOTO UNIT_ERROR"),
        "SA".into(),
    ]
}

/// The end of a part file that began with [`head`].
pub fn foot() -> [String; 3] {
    ["END".into(), "UNIT_ERROR:".into(), "C91".into()]
}

/// A name without an extension is that of a part file.
pub fn part_name(name: &str) -> String {
    if name.contains('.') { name.into() } else { format!("{name}.sbp") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        for (value, shown) in [(1.0, "1"), (-0.00001, "0"), (0.125, "0.125"), (1.0 / 3.0, "0.3333")]
        {
            assert_eq!(number(value), shown);
        }
    }
}
