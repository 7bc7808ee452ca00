//! Scripts: clauses divided by semicolons, as `kerf draw --do` takes them.

use super::words::{WordError, Words};
use super::{ENTRIES, Entry, Operation};
use thiserror::Error;

/// Mistake in a clause of a script.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("clause {number} `{clause}`: {why}{}", form_of(*.entry))]
pub struct ClauseError {
    /// Which clause, counted from 1.
    pub number: usize,
    /// Its words.
    pub clause: String,
    /// Description of the mistake.
    pub why: String,
    /// Number of its entry in [`ENTRIES`], when the operation is known.
    pub entry: Option<usize>,
}

fn form_of(entry: Option<usize>) -> String {
    let form = entry.and_then(|n| ENTRIES.get(n)).map(|entry| entry.form);
    form.map(|form| format!("; write `{form}`")).unwrap_or_default()
}

/// The operations of a script, with the number of the clause each comes from.
///
/// ```
/// let ops = kerf_drawing::script("select all; rotate 30 about 0,0;").unwrap();
/// assert_eq!(ops.len(), 2);
/// assert_eq!(ops[1].1.to_string(), "rotate 30 about 0,0");
/// ```
///
/// # Errors
/// The first clause that is no operation.
pub fn script(text: &str) -> Result<Vec<(usize, Operation)>, ClauseError> {
    let clauses = text.split([';', '\n']).map(str::trim).enumerate();
    let full = clauses.filter(|(_, clause)| !clause.is_empty());
    full.map(|(n, clause)| Ok((n + 1, read(n + 1, clause)?))).collect()
}

fn read(number: usize, clause: &str) -> Result<Operation, ClauseError> {
    let mut words = Words::of(clause);
    let name = words.next_word().unwrap_or_default();
    let entry = ENTRIES.iter().position(|entry| entry.name.eq_ignore_ascii_case(name));
    let told = |why| ClauseError { number, clause: clause.to_owned(), why, entry };
    let Some(found) = entry.map(|n| &ENTRIES[n]) else {
        return Err(told(unknown(name)));
    };
    read_words(found, &mut words).map_err(|error| told(error.to_string()))
}

fn read_words(entry: &Entry, words: &mut Words) -> Result<Operation, WordError> {
    let operation = (entry.read)(words)?;
    words.end()?;
    Ok(operation)
}

fn unknown(name: &str) -> String {
    let near = ENTRIES.iter().map(|entry| entry.name).find(|known| alike(known, name));
    match near {
        Some(near) => format!("there is no operation `{name}`; did you mean `{near}`?"),
        None => format!("there is no operation `{name}`; `kerf draw --help` lists them"),
    }
}

/// Tells whether two words begin alike or have the same letters.
fn alike(a: &str, b: &str) -> bool {
    let b = b.to_ascii_lowercase();
    let sorted = |word: &str| {
        let mut letters: Vec<char> = word.chars().collect();
        letters.sort_unstable();
        letters
    };
    let head = |word: &str| word.chars().take(3).collect::<String>();
    head(a) == head(&b) || sorted(a) == sorted(&b)
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    /// Every form of every operation, written as Kerf writes it.
    const CANONICAL: &str = "select all; select add 1,3,4; select remove group red; select none; \
        select window 0,0 50,40; select crossing 0,0 50,40; move 10,5; copy -1.5,0; \
        rotate 30 about 1,2; scale 25.4 about 0,0; mirror 0,0 0,1; mirror 0,0 1,1 raw; erase; \
        fillet 3; fillet 3 at 10,0; chamfer 2; chamfer 2 at 1,1; offset -2; offset 2 keep; \
        join keep; join 0.5 merge; break 1 50,0; trim 50,0; bulge 1 5,0 -0.25; radius 1 5,0 10; \
        vertex 1 10,0 12,1; stretch 0,0 9,9 by 20,0; stretch at 0,0 9,9 by 0,-2; delete-vertices 1 10,0 20,0; \
        array rect 2x3 spacing 5,8; array round 6 about 0,0; \
        circle 50,50 25; rect 10,10 60,40; point 12.5,7; line 0,0 10,0,0.414214 10,10; \
        line 0,0 10,0 10,10 close; line3d 0,0,0 10,0,-3 10,0,-5; line3d 0,0,0 10,0,-3 9,9,1.5 close; reverse; directions auto; start 4 50,0; pause on; pause off; \
        group blue; copy-to red; set blue on=off traversal=on tool=2 cut=3 speed=3000 height=-2.5 \
        pass=4 offset=3 rough=0.5 double=on tag=2 lead-in=5,90 lead-out=0,0; \
        set red speed=max height=thru pass=off; set red height=3d; set red plunge=straight; \
        set red plunge=ramp,3 plunge=helix,4,2.5; set red cutter=6; set red cutter=auto; \
        engrave all tool=5 overlap=0.1 group=red; engrave tool=3 overlap=0 depth=2.5 group=red cut-outlines; engrave tool=3 overlap=0 depth=thru; pocket all tool=5 overlap=1 climb outward; \
        pocket tool=5 overlap=1 group=blue climb zigzag=45 finish=0.2; pocket tool=5 overlap=1; sequence 3,1,2; \
        sequence groups red,black; sequence groups of 4,1; pick 3,1; pick groups red,black; pick remove 2; pick none; sequence picked; \
        sequence reverse; sequence auto -1000,0; sequence level 2,1; \
        sequence travel from 0,-5 starts speed=200 accel=0 lift=2 tool-change=30 tries=9; \
        sequence travel from 0,0 speed=150 accel=500 lift=1 tool-change=60; \
        array block 2x3 gap 10,20 start tl order row-snake; \
        array job 1x1 gap 0,0 start bl order column; justify left; justify surface; \
        justify bottom -10; rotate90; mirror-drawing; origin 10,5; origin cad; clip; load-clipboard part.rsg; \
        clear-clipboard; paste 0,0; paste absolute 100,0; comment Anna | 18 mm birch";

    #[test]
    fn what_is_written_is_read_again() {
        let read = script(CANONICAL).unwrap();
        let written: Vec<_> = read.iter().map(|(_, op)| op.to_string()).collect();
        let clauses: Vec<_> = CANONICAL.split("; ").map(str::trim).collect();
        assert_eq!(written, clauses);
        for entry in ENTRIES {
            let begins = |clause: &&str| clause.split(' ').next() == Some(entry.name);
            assert!(clauses.iter().any(begins), "{} is not tried", entry.name);
        }
    }

    #[test]
    fn operations_go_through_json() {
        for (_, op) in script(CANONICAL).unwrap() {
            let json = serde_json::to_string(&op).unwrap();
            assert_eq!(serde_json::from_str::<Operation>(&json).unwrap(), op, "{json}");
        }
    }

    #[test]
    fn short_forms_are_read() {
        let short = |text: &str, long: &str| {
            assert_eq!(script(text).unwrap()[0].1.to_string(), long);
        };
        short("ROTATE 30", "rotate 30 about 0,0");
        short("move from 100,100 to 150,120", "move 50,20");
        short("rotate to 90 from 0,0 100,100", "rotate 45 about 0,0");
        short("scale to 75 from 0,0 50,0", "scale 1.5 about 0,0");
        short("join", "join keep");
        short("rect 10,10 size -5,3", "rect 10,10 5,13");
        short("select 5-7,1", "select 5,6,7,1");
        short("array block 2x2", "array block 2x2 gap 0,0 start bl order row");
    }

    fn refused(text: &str, told: &str) {
        assert_eq!(script(text).unwrap_err().to_string(), told);
    }

    #[test]
    fn mistakes_name_the_clause() {
        refused(
            "erase; rotat 3",
            "clause 2 `rotat 3`: there is no operation `rotat`; did you mean `rotate`?",
        );
        refused(
            "fly",
            "clause 1 `fly`: there is no operation `fly`; `kerf draw --help` lists them",
        );
        refused(
            "move",
            "clause 1 `move`: the distance is missing; write `move X,Y | move from X,Y to X,Y`",
        );
        refused(
            "move 1",
            "clause 1 `move 1`: `1` is not a distance as x,y; write `move X,Y | move from X,Y to X,Y`",
        );
        refused("erase 2", "clause 1 `erase 2`: `2` is one word too many; write `erase`");
    }
}
