//! Warnings of a conversion, each told once: a long program loses the same thing in hundreds of lines.

use kerf_diag::{Code, Diagnostic};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Key by which two warnings are one: the file, the code, and the words.
type Key = (Arc<str>, Code, String);

/// The diagnostics in their order; of warnings that say the same the first, with how many more there are. Errors
/// stay as they are, and the text marks each place by a comment.
pub fn told_once(diagnostics: Vec<Diagnostic>) -> Vec<Diagnostic> {
    let mut first: BTreeMap<Key, usize> = BTreeMap::new();
    let (mut told, mut more): (Vec<Diagnostic>, Vec<(usize, u32)>) = (Vec::new(), Vec::new());
    for diagnostic in diagnostics {
        let known =
            if diagnostic.is_error() { None } else { first.get(&key(&diagnostic)).copied() };
        if let Some(at) = known {
            more[at] = (more[at].0 + 1, diagnostic.place.line);
            continue;
        }
        if !diagnostic.is_error() {
            first.insert(key(&diagnostic), told.len());
        }
        told.push(diagnostic);
        more.push((0, 0));
    }
    for (diagnostic, (again, last)) in told.iter_mut().zip(more) {
        if again > 0 {
            let message =
                format!("{} ({again} more like it, the last in line {last})", diagnostic.message);
            diagnostic.message = message;
        }
    }
    told
}

/// Speeds differ from line to line, and what is lost of them is the same.
fn key(diagnostic: &Diagnostic) -> Key {
    let message = &diagnostic.message;
    let words = match message.split_once(" mm/s: ") {
        Some((_, words)) => words,
        None => message,
    };
    (diagnostic.place.file.clone(), diagnostic.code, words.to_owned())
}
