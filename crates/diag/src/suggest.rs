//! "Did you mean": the nearest known name.

/// A hint with the nearest of some names, if one is near enough.
pub fn did_you_mean<'a>(word: &str, names: impl Iterator<Item = &'a str>) -> Option<String> {
    let word = word.to_uppercase();
    let allowed = match word.chars().count() {
        0 | 1 => return None,
        2..=4 => 1,
        _ => 2,
    };
    names
        .map(|name| (distance(&word, &name.to_uppercase()), name))
        .filter(|(far, _)| *far > 0 && *far <= allowed)
        .min_by_key(|(far, _)| *far)
        .map(|(_, name)| format!("did you mean {name}?"))
}

/// Letters to change, leave out, put in or swap (optimal string alignment, Damerau 1964).
fn distance(a: &str, b: &str) -> usize {
    let (a, b): (Vec<char>, Vec<char>) = (a.chars().take(40).collect(), b.chars().collect());
    let mut rows = vec![vec![0; b.len() + 1]; a.len() + 1];
    for i in 0..=a.len() {
        for j in 0..=b.len() {
            if i == 0 || j == 0 {
                rows[i][j] = i + j;
                continue;
            }
            let same = a[i - 1] == b[j - 1];
            let mut best = (rows[i - 1][j] + 1)
                .min(rows[i][j - 1] + 1)
                .min(rows[i - 1][j - 1] + usize::from(!same));
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                best = best.min(rows[i - 2][j - 2] + 1);
            }
            rows[i][j] = best;
        }
    }
    rows[a.len()][b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn near_names_are_found_and_far_ones_are_not() {
        let names = ["GOTO", "GOSUB", "PRINT", "PAUSE", "THEN"];
        for (word, hint) in [
            ("GOT", Some("did you mean GOTO?")),
            ("pirnt", Some("did you mean PRINT?")),
            ("THE", Some("did you mean THEN?")),
            ("PUASE", Some("did you mean PAUSE?")),
            ("GOTO", None),
            ("XYZZY", None),
            ("G", None),
        ] {
            assert_eq!(did_you_mean(word, names.into_iter()).as_deref(), hint, "{word}");
        }
    }
}
