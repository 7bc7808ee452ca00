//! Nothing that moves, waits or ends goes by the clock on the wall, which people and time servers put: it is read for
//! people, in the places listed here.

use crate::{Finding, Tree};

/// Words that read it.
const READS: [&str; 3] = ["SystemTime::now", "Zoned::now", "Timestamp::now"];

/// Places that show it to people, or compare it with the times of files; nothing moves or ends by them.
const SHOWN_BY: [&str; 5] = [
    "crates/control/src/controller/line_log.rs",
    "crates/files/src/leftovers.rs",
    "crates/kerf/src/clock.rs",
    "crates/kerf/src/date.rs",
    "crates/server/src/last_runs.rs",
];

/// Other places that read it.
pub fn check(tree: &Tree) -> Vec<Finding> {
    let sources = tree.matching("crates/", ".rs").filter(|(path, _)| path.contains("/src/"));
    let sources = sources.filter(|(path, _)| !SHOWN_BY.contains(path) && !is_of_rules(path));
    sources.flat_map(|(path, text)| check_file(path, text)).collect()
}

fn check_file(path: &str, text: &str) -> Vec<Finding> {
    let reads = |line: &&str| READS.iter().any(|word| line.contains(word));
    let lines = text.lines().enumerate().filter(|(_, line)| reads(line));
    lines.map(|(at, _)| Finding::line(path, at + 1, WHY)).collect()
}

const WHY: &str = "the clock on the wall may leap: what ends in time goes by the server's `Clock` or by `Instant`; a time \
                   for people has its place in this rule";

/// The rules name what they look for.
fn is_of_rules(path: &str) -> bool {
    path.starts_with("crates/xtask/") || path.starts_with("crates/bench/")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_clock_on_the_wall_is_read_where_people_are_shown_it() {
        let deadline = "fn late() -> bool {\n    SystemTime::now() > self.until\n}\n";
        let check = |path: &str| check(&Tree::of(&[(path, deadline)])).len();
        assert_eq!(check("crates/server/src/turn.rs"), 1);
        assert_eq!(check("crates/server/src/last_runs.rs"), 0);
        assert_eq!(check("crates/server/tests/turn.rs"), 0);
    }
}
