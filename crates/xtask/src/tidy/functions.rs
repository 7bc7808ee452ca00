//! Functions are short enough to be read at once.

use crate::{Finding, Tree};

/// Most lines of a function, from its first to its closing brace.
const MOST_LINES: usize = 70;

/// Functions that are longer.
pub fn check(tree: &Tree) -> Vec<Finding> {
    let sources = tree.matching("crates/", ".rs").filter(|(path, _)| path.contains("/src/"));
    sources.flat_map(|(path, text)| check_file(path, text)).collect()
}

fn check_file(path: &str, text: &str) -> Vec<Finding> {
    let lines: Vec<&str> = text.lines().collect();
    let long = |(at, line): (usize, &&str)| {
        let indent = function_indent(line)?;
        let end = format!("{}}}", " ".repeat(indent));
        let count = lines[at..].iter().position(|line| line.starts_with(&end))? + 1;
        let why = format!(
            "a function of {count} lines: at most {MOST_LINES}, what it does in steps is told by functions"
        );
        (count > MOST_LINES).then(|| Finding::line(path, at + 1, why))
    };
    lines.iter().enumerate().filter_map(long).collect()
}

/// Returns how far the first line of a function is indented; nothing where a line is none, or the function ends there.
fn function_indent(line: &str) -> Option<usize> {
    let code = line.trim_start();
    let words = ["pub", "const", "unsafe", "async", "extern"];
    let is_first = |word: &&str| !words.iter().any(|it| word.starts_with(it));
    let begins = code.split_whitespace().find(is_first) == Some("fn");
    (begins && !code.ends_with([';', '}'])).then(|| line.len() - code.len())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_function_is_found_wherever_it_stands() {
        let check = |first: &str, lines: usize, expected: usize| {
            let indent: String = first.chars().take_while(|c| *c == ' ').collect();
            let body = format!("{indent}    step();\n").repeat(lines - 2);
            let text = format!("{first}\n{body}{indent}}}\n\nfn short() {{\n}}\n");
            assert_eq!(
                check(&Tree::of(&[("crates/a/src/b.rs", &text)])).len(),
                expected,
                "{first}"
            );
        };
        check("fn a() {", 70, 0);
        check("fn a() {", 71, 1);
        check("    pub(crate) const fn a(&self) -> u8 {", 71, 1);
        check("pub struct A {", 200, 0);
        check("    fn declared(&self);", 200, 0);
    }
}
