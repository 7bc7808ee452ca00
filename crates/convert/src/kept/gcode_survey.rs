//! A survey of what stands in a program, made before it is written.

use super::Unkept;
use super::gcode_expressions::{each, number_of};
use super::gcode_modes::Changes;
use kerf_gcode::tree::{Extra, Flow, Keyword, Label, Node, Target, Value, Word};
use kerf_gcode::{Expr, Program};
use std::collections::{BTreeMap, BTreeSet};

/// Parameters up to this belong to the subroutine, or to the file.
const LAST_LOCAL: u32 = 30;

/// Findings of the survey.
#[derive(Debug, Default)]
pub(super) struct Survey {
    /// The parameters of each subroutine that are its own.
    pub(super) own: BTreeMap<String, BTreeSet<u32>>,
    /// Parameters that may be read before anything is put into them; they are zero.
    pub(super) unset: BTreeSet<u32>,
    /// Z moves together with X or Y somewhere.
    pub(super) slopes: bool,
}

/// The words and the rest of a line.
struct Line<'a> {
    words: &'a [Word],
    extra: Option<&'a Extra>,
}

/// A line that is no plain move.
fn block_of(program: &Program, line: u32) -> Option<Line<'_>> {
    let Node::Block(index) = program.line(line)?.node() else { return None };
    let block = program.blocks.get(index as usize)?;
    Some(Line { words: program.words_of(block), extra: program.extra_of(block) })
}

/// The O-word of a line.
fn flow_of(program: &Program, line: u32) -> Option<&Flow> {
    block_of(program, line)?.extra?.flow.as_ref()
}

impl Survey {
    /// Looks at a program.
    ///
    /// # Errors
    /// Subroutines that cannot be told apart, or that call themselves.
    pub(super) fn of(program: &Program) -> Result<Self, Unkept> {
        let mut survey = Self { slopes: slopes(program), ..Self::default() };
        survey.subroutines(program)?;
        survey.unset(program);
        Ok(survey)
    }

    fn subroutines(&mut self, program: &Program) -> Result<(), Unkept> {
        for (label, line) in &program.subs {
            let name = name_of(label);
            let alike = |other: &String| {
                let (short, long) =
                    if other.len() < name.len() { (other, &name) } else { (&name, other) };
                long == short || long.starts_with(&format!("{short}_"))
            };
            if self.own.keys().any(alike) {
                return Err(Unkept::new(*line, "subroutines whose names begin alike"));
            }
            let Some(end) = end_of_sub(program, *line) else { continue };
            let mut own = BTreeSet::new();
            for inside in *line..=end {
                expressions(program, inside, &mut |expr| {
                    own.extend(parameter(expr).filter(|n| *n <= LAST_LOCAL));
                });
            }
            self.own.insert(name, own);
            if called_within(program, (*line, end)).contains(&(*line, end)) {
                return Err(Unkept::new(*line, "a subroutine that calls itself"));
            }
        }
        Ok(())
    }

    /// Parameters that are read where nothing was put into them on every way.
    fn unset(&mut self, program: &Program) {
        // What is set at the depth of conditions and loops that each entry stands for.
        let mut set: Vec<BTreeSet<u32>> = vec![BTreeSet::new()];
        for line in 1..=program.line_count() {
            let in_sub = program.is_in_subroutine(line);
            expressions(program, line, &mut |expr| {
                let Some(n) = parameter(expr).filter(|n| !in_sub || *n > LAST_LOCAL) else {
                    return;
                };
                if !set.iter().any(|known| known.contains(&n)) {
                    self.unset.insert(n);
                }
            });
            let Some(block) = block_of(program, line) else { continue };
            match block.extra.and_then(|extra| extra.flow.as_ref()).map(|flow| flow.keyword) {
                Some(
                    Keyword::If | Keyword::While | Keyword::Do | Keyword::Repeat | Keyword::Sub,
                ) => set.push(BTreeSet::new()),
                Some(Keyword::Else | Keyword::Elseif) => {
                    set.pop();
                    set.push(BTreeSet::new());
                }
                Some(
                    Keyword::Endif
                    | Keyword::Endwhile
                    | Keyword::DoWhile
                    | Keyword::Endrepeat
                    | Keyword::Endsub,
                ) => {
                    set.pop();
                }
                _ => {}
            }
            let Some(innermost) = set.last_mut() else { continue };
            for setting in block.extra.iter().flat_map(|extra| &extra.settings) {
                if let Target::Numbered(Expr::Number(n)) = setting.target {
                    innermost.insert(n as u32);
                }
            }
        }
    }
}

/// The whole number of a parameter that is asked for.
fn parameter(expr: &Expr) -> Option<u32> {
    number_of(expr).filter(|n| n.fract() == 0.0 && (1.0..5000.0).contains(n)).map(|n| n as u32)
}

/// Calls a function with every expression of a line; what is assigned to is not among them.
fn expressions(program: &Program, line: u32, found: &mut dyn FnMut(&Expr)) {
    let Some(block) = block_of(program, line) else { return };
    for word in block.words {
        if let Value::Computed(index) = word.value
            && let Some(expr) = program.exprs.get(index as usize)
        {
            each(expr, found);
        }
    }
    if let Some(extra) = block.extra {
        extra.settings.iter().for_each(|setting| each(&setting.value, found));
        extra.flow.iter().flat_map(|flow| &flow.values).for_each(|value| each(value, found));
    }
}

pub(super) fn end_of_sub(program: &Program, line: u32) -> Option<u32> {
    flow_of(program, line).filter(|flow| flow.keyword == Keyword::Sub).map(|flow| flow.target)
}

/// The lines of the subroutine that an O-word calls.
fn called(program: &Program, flow: &Flow) -> Option<(u32, u32)> {
    let first =
        *program.subs.get(flow.label.as_ref().filter(|_| flow.keyword == Keyword::Call)?)?;
    Some((first, end_of_sub(program, first)?))
}

/// The subroutines that the lines of a stretch call, and those call.
fn called_within(program: &Program, (from, to): (u32, u32)) -> BTreeSet<(u32, u32)> {
    let mut found = BTreeSet::new();
    let mut left = vec![(from, to)];
    while let Some((from, to)) = left.pop() {
        let calls = (from..=to).filter_map(|line| called(program, flow_of(program, line)?));
        left.extend(calls.filter(|sub| found.insert(*sub)));
    }
    found
}

/// Collects the modes that the lines of a stretch set, with the subroutines they call.
pub(super) fn changes(program: &Program, from: u32, to: u32) -> Changes {
    let mut all = Changes::default();
    let within = called_within(program, (from, to));
    for line in within.into_iter().chain([(from, to)]).flat_map(|(from, to)| from..=to) {
        if let Some(plain) = program.move_of(line) {
            all.motions.extend((plain.motion < 4).then_some(Some(plain.motion)));
        }
        let Some(block) = block_of(program, line) else { continue };
        for word in block.words {
            match (word.letter, word.value) {
                (b'G', Value::Number(80.0)) => all.motions.push(None),
                (b'G', Value::Number(n)) if n.fract() == 0.0 && (0.0..4.0).contains(&n) => {
                    all.motions.push(Some(n as u8));
                }
                (b'T', Value::Number(n)) => all.tools.push(format!("{n}")),
                _ => {}
            }
        }
    }
    all
}

/// Returns `true` if a line anywhere cuts along Z together with X or Y.
fn slopes(program: &Program) -> bool {
    (1..=program.line_count()).any(|line| {
        let plain = program.move_of(line);
        let letters: Vec<u8> = match (&plain, block_of(program, line)) {
            (Some(plain), _) if plain.motion == 0 => return false,
            (Some(plain), _) => plain.words().map(|(letter, _)| letter).collect(),
            (None, Some(block)) if jogs(block.words) => return false,
            (None, Some(block)) => block.words.iter().map(|word| word.letter).collect(),
            (None, None) => return false,
        };
        letters.contains(&b'Z') && letters.iter().any(|letter| b"XYIJ".contains(letter))
    })
}

/// Returns `true` if a block names G0.
fn jogs(words: &[Word]) -> bool {
    words.iter().any(|word| word.letter == b'G' && word.value == Value::Number(0.0))
}

/// The name of a label, as a part file can have it.
pub(super) fn name_of(label: &Label) -> String {
    match label {
        Label::Number(n) => n.to_string(),
        Label::Name(name) => {
            name.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '_' }).collect()
        }
    }
}
