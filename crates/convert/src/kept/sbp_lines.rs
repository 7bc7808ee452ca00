//! A part file as a program for LinuxCNC.
//!
//! Speeds stay variables too: `#<_feed_xy>` and `#<_feed_z>` hold those of VS and MS in units a
//! minute. A move of X, Y and Z together asks a subroutine for its feed, since OpenSBP keeps each of
//! the two speeds to itself.

use super::Unkept;
use super::jumps::{Jump, doing, doing_before, jump, last_jump_back, line_of, statement};
use super::sbp_expressions::Words;
use crate::Conversion;
use kerf_program::settings::LinearUnit;
use kerf_sbp::tree::{Assigned, Node, Program, Statement};
use std::collections::BTreeMap;

/// The feed of a slope: X, Y and Z where it ends.
const SLOPE: &str = "O<slope> sub
  #4 = SQRT[[#1 - #5420] ** 2 + [#2 - #5421] ** 2]
  #5 = ABS[#3 - #5422]
  #6 = [#4 / #<_feed_xy>]
  O10 if [[#5 / #<_feed_z>] GT #6]
    #6 = [#5 / #<_feed_z>]
  O10 endif
  #<_feed_slope> = #<_feed_xy>
  O11 if [#6 GT 0]
    #<_feed_slope> = [SQRT[#4 ** 2 + #5 ** 2] / #6]
  O11 endif
O<slope> endsub
";

/// Writes a part file with its variables.
pub(super) fn to_gcode(program: &Program, how: &Conversion) -> Result<String, Unkept> {
    let unit = how.settings.linear_unit;
    let subs = subroutines(program)?;
    let mut keeper = Keeper {
        program,
        unit,
        subs,
        text: String::new(),
        depth: 0,
        loops: Vec::new(),
        label: 100,
        slopes: false,
    };
    let count = program.lines.len() as u32 + 1;
    let first_sub = keeper.subs.keys().next().copied().unwrap_or(count);
    keeper.region(1, first_sub.min(count))?;
    if !keeper.text.ends_with("\nM2\n") {
        keeper.line("M2");
    }
    let main = std::mem::take(&mut keeper.text);
    for (label, name) in keeper.subs.clone() {
        keeper.subroutine(label, &name)?;
    }
    Ok(keeper.head(how) + &main)
}

/// The lines that GOSUB goes to, and their names.
fn subroutines(program: &Program) -> Result<BTreeMap<u32, String>, Unkept> {
    let mut subs = BTreeMap::new();
    for line in 1..=program.lines.len() as u32 {
        let inner = match statement(program, line) {
            Some(Statement::If { then, .. }) => Some(&**then),
            other => other,
        };
        if let Some(Statement::Gosub(target)) = inner {
            let label = line_of(program, target, line)?;
            let name = program.label_name(target.label).to_lowercase();
            let name: String =
                name.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '_' }).collect();
            subs.insert(label, format!("{name}_{label}"));
        }
    }
    Ok(subs)
}

/// A program while it is written.
pub(super) struct Keeper<'a> {
    pub(super) program: &'a Program,
    unit: LinearUnit,
    /// Subroutines by the line of their label.
    subs: BTreeMap<u32, String>,
    text: String,
    depth: usize,
    /// The loops around, innermost last: number, and the line that runs behind it.
    loops: Vec<(u32, u32)>,
    /// The number of the next O-word.
    label: u32,
    /// Some move needs the feed of a slope.
    pub(super) slopes: bool,
}

impl Keeper<'_> {
    fn head(&self, how: &Conversion) -> String {
        let unit = if self.unit == LinearUnit::Mm { "G21" } else { "G20" };
        let mut head: String = how.title.lines().map(|line| format!("({line})\n")).collect();
        let speeds = &how.settings.speeds.cut;
        let minute = |mm_s: f64| kerf_program::decimal(mm_s * 60.0 / self.unit.mm(), 6);
        head += &format!("{unit} G17 G40 G49 G80 G90 G94\n");
        head +=
            &format!("#<_feed_xy> = {}\n#<_feed_z> = {}\n", minute(speeds.xy), minute(speeds.z));
        if self.slopes {
            head += SLOPE;
        }
        head + &self.text
    }

    pub(super) fn line(&mut self, text: &str) {
        self.text.push_str(&"  ".repeat(self.depth));
        self.text.push_str(text);
        self.text.push('\n');
    }

    fn comment(&mut self, text: &str) {
        let inner: String = text
            .chars()
            .map(|c| match c {
                '(' => '[',
                ')' => ']',
                c => c,
            })
            .collect();
        self.line(&format!("({inner})"));
    }

    pub(super) const fn words(&self, line: u32) -> Words<'_> {
        Words { program: self.program, line }
    }

    fn next_label(&mut self) -> u32 {
        self.label += 1;
        self.label
    }

    fn subroutine(&mut self, label: u32, name: &str) -> Result<(), Unkept> {
        let count = self.program.lines.len() as u32;
        let returns = |line: &u32| statement(self.program, *line) == Some(&Statement::Return);
        let Some(end) = (label + 1..=count).find(returns) else {
            return Err(Unkept::new(label, "a subroutine without RETURN"));
        };
        self.line(&format!("O<{name}> sub"));
        self.depth += 1;
        self.region(label + 1, end)?;
        self.depth -= 1;
        self.line(&format!("O<{name}> endsub"));
        Ok(())
    }

    /// The lines from one up to another.
    fn region(&mut self, from: u32, end: u32) -> Result<(), Unkept> {
        let mut line = from;
        while line < end {
            if self.subs.contains_key(&line) {
                return Err(Unkept::new(line, "a subroutine that is run into"));
            }
            line = self.one(line, end)?;
        }
        Ok(())
    }

    /// One line, or the loop or condition that begins there; gives the line behind it.
    fn one(&mut self, line: u32, end: u32) -> Result<u32, Unkept> {
        let Some(node) = self.program.lines.get(line as usize - 1).map(|l| l.node) else {
            return Ok(end);
        };
        if let Node::Label(_) = node {
            return match last_jump_back(self.program, line, end)? {
                Some(last) => self.repeat(line, last),
                None => Ok(line + 1),
            };
        }
        if let Some(jump) = jump(self.program, line)? {
            return self.jump(line, &jump, end);
        }
        if statement(self.program, line) == Some(&Statement::End) {
            // Nothing runs into what stands behind END; subroutines come by themselves.
            self.line("M2");
            return Ok(end);
        }
        let before = self.text.len();
        self.plain(line, node)?;
        if let Some(comment) = self.program.comment_beside(line) {
            let kept = self.text.split_off(before);
            match kept.strip_suffix('\n') {
                Some(code) => {
                    self.text.push_str(code);
                    let inner = comment.replace('(', "[").replace(')', "]");
                    self.text.push_str(&format!(" ({inner})\n"));
                }
                None => self.comment(comment),
            }
        }
        Ok(line + 1)
    }

    /// A loop from its label to the jump back.
    fn repeat(&mut self, label: u32, last: u32) -> Result<u32, Unkept> {
        let Some(jump) = jump(self.program, last)? else { return Ok(label + 1) };
        let number = self.next_label();
        let opening = if jump.condition.is_some() { "do" } else { "while [1]" };
        self.line(&format!("O{number} {opening}"));
        self.depth += 1;
        self.loops.push((number, doing(self.program, last + 1)));
        self.region(label + 1, last)?;
        self.loops.pop();
        self.depth -= 1;
        let closing = match &jump.condition {
            Some(condition) => format!("while {}", self.words(last).condition(condition)?),
            None => "endwhile".into(),
        };
        self.line(&format!("O{number} {closing}"));
        Ok(last + 1)
    }

    fn jump(&mut self, line: u32, jump: &Jump, end: u32) -> Result<u32, Unkept> {
        let unit = if self.unit == LinearUnit::Mm { 1.0 } else { 0.0 };
        let words = self.words(line);
        match jump.condition.as_ref().map(|c| (c, words.of_unit(c, unit))) {
            // The converted file says its unit itself.
            Some((_, Some(false))) => Ok(line + 1),
            Some((_, Some(true))) => Err(Unkept::new(line, "a file for the other unit")),
            Some((condition, None)) => {
                let (holds, fails) = (words.condition(condition)?, words.contrary(condition)?);
                self.conditional(line, jump.to, end, &holds, &fails)
            }
            None if (line + 1..=end).contains(&jump.to) => Ok(jump.to),
            None => {
                let way_out = self.way_out(line, jump.to)?;
                self.line(&way_out);
                Ok(line + 1)
            }
        }
    }

    /// A jump that only sometimes is made.
    fn conditional(
        &mut self,
        line: u32,
        to: u32,
        end: u32,
        holds: &str,
        fails: &str,
    ) -> Result<u32, Unkept> {
        let number = self.next_label();
        if !(line + 1..=end).contains(&to) {
            let way_out = self.way_out(line, to)?;
            self.line(&format!("O{number} if {holds}"));
            self.line(&format!("  {way_out}"));
            self.line(&format!("O{number} endif"));
            return Ok(line + 1);
        }
        if let Some((other, behind)) = self.otherwise(line, to, end)? {
            self.line(&format!("O{number} if {holds}"));
            self.inner(to, behind)?;
            self.line(&format!("O{number} else"));
            self.inner(line + 1, other)?;
            self.line(&format!("O{number} endif"));
            return Ok(behind);
        }
        self.line(&format!("O{number} if {fails}"));
        self.inner(line + 1, to)?;
        self.line(&format!("O{number} endif"));
        Ok(to)
    }

    fn inner(&mut self, from: u32, end: u32) -> Result<(), Unkept> {
        self.depth += 1;
        self.region(from, end)?;
        self.depth -= 1;
        Ok(())
    }

    /// The jump that ends what is done otherwise, and the line behind both ways.
    fn otherwise(&self, line: u32, to: u32, end: u32) -> Result<Option<(u32, u32)>, Unkept> {
        let Some(last) = doing_before(self.program, to, line + 1) else { return Ok(None) };
        let jump = jump(self.program, last)?.filter(|jump| jump.condition.is_none());
        Ok(jump.filter(|jump| (to + 1..=end).contains(&jump.to)).map(|jump| (last, jump.to)))
    }

    /// Out of the innermost loop, or out of the program.
    fn way_out(&self, line: u32, to: u32) -> Result<String, Unkept> {
        let target = doing(self.program, to);
        if let Some((number, behind)) = self.loops.last()
            && target == *behind
        {
            return Ok(format!("O{number} break"));
        }
        let over = target > self.program.lines.len() as u32;
        if over || statement(self.program, target) == Some(&Statement::End) {
            return Ok("M2".into());
        }
        Err(Unkept::new(line, "a jump that is no loop and no condition"))
    }

    fn plain(&mut self, line: u32, node: Node) -> Result<(), Unkept> {
        match node {
            Node::Blank | Node::Label(_) => Ok(()),
            Node::Comment => {
                let text = self.program.line_text(line).trim();
                let text = text.trim_start_matches('\'').trim().to_string();
                if !text.is_empty() {
                    self.comment(&text);
                }
                Ok(())
            }
            Node::Move { command, given, first } => {
                self.literal_move(line, (command, given, first))
            }
            Node::Statement(index) => match self.program.statements.get(index as usize) {
                Some(statement) => self.statement(line, statement),
                None => Ok(()),
            },
            Node::Bad => Err(Unkept::new(line, "a line that cannot be read")),
        }
    }

    fn statement(&mut self, line: u32, statement: &Statement) -> Result<(), Unkept> {
        let words = self.words(line);
        match statement {
            Statement::Command { spec, args, .. } => {
                let args = &self.program.args[*args];
                self.command(line, spec.letters, args)
            }
            Statement::Assign {
                name,
                persistent: false,
                only_if_undefined: false,
                value: Assigned::Expr(expr),
                ..
            } => {
                let text = format!("{} = {}", words.variable(*name), words.value(expr)?);
                self.line(&text);
                Ok(())
            }
            Statement::Assign { .. } => Err(Unkept::new(line, "this assignment")),
            Statement::If { condition, then } => {
                let condition = words.condition(condition)?;
                let number = self.next_label();
                self.line(&format!("O{number} if {condition}"));
                self.depth += 1;
                self.statement(line, then)?;
                self.depth -= 1;
                self.line(&format!("O{number} endif"));
                Ok(())
            }
            Statement::Gosub(target) => {
                let label = line_of(self.program, target, line)?;
                let name = self.subs.get(&label).cloned().unwrap_or_default();
                self.line(&format!("O<{name}> call"));
                Ok(())
            }
            Statement::End => {
                self.line("M2");
                Ok(())
            }
            Statement::Pause { seconds: Some(seconds) } => {
                let text = format!("G4 P{}", words.value(seconds)?);
                self.line(&text);
                Ok(())
            }
            Statement::Pause { seconds: None } => {
                self.line("M0");
                Ok(())
            }
            Statement::Return => Err(Unkept::new(line, "RETURN in the middle")),
            Statement::Output(output) if !output.write && output.file.is_none() => {
                self.print(line, output)
            }
            _ => Err(Unkept::new(line, "this statement")),
        }
    }

    fn print(&mut self, line: u32, output: &kerf_sbp::tree::Output) -> Result<(), Unkept> {
        let words = self.words(line);
        let mut text = String::new();
        for item in &output.items {
            match item.node {
                kerf_sbp::ExprNode::Text(id) => {
                    text += &self.program.expressions[id].replace(['(', ')', '#', '%'], " ");
                }
                kerf_sbp::ExprNode::Variable(name) => text += &words.variable(name),
                _ => return Err(Unkept::new(line, "a formula in PRINT")),
            }
        }
        self.line(&format!("(PRINT,{text})"));
        Ok(())
    }
}
