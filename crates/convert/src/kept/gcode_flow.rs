//! O-words as labels and jumps.

use super::Unkept;
use super::gcode_expressions::Words;
use super::gcode_lines::Keeper;
use super::gcode_survey::{changes, end_of_sub, name_of};
use kerf_gcode::Expr;
use kerf_gcode::tree::{Flow, Keyword};

impl Keeper<'_> {
    /// Writes an O-word.
    pub(super) fn flow(&mut self, line: u32, flow: &Flow) -> Result<(), Unkept> {
        let Some(label) = &flow.label else {
            return Err(Unkept::new(line, "an O-word whose label is computed"));
        };
        let name = name_of(label);
        self.lower();
        match flow.keyword {
            Keyword::Sub => self.begin_sub(line, name),
            Keyword::Endsub => {
                self.line("RETURN");
                self.sub = None;
                self.ways.end_sub();
                Ok(())
            }
            Keyword::Return if flow.values.is_empty() => {
                self.line("RETURN");
                self.ways.stop();
                Ok(())
            }
            Keyword::Call => self.call(line, &name, flow),
            Keyword::While => {
                let label = self.begin_loop(line, &name, flow)?;
                self.line(&format!("AGAIN_{label}:"));
                self.leave(line, flow, false, &format!("DONE_{label}"))
            }
            Keyword::Do => {
                let label = self.begin_loop(line, &name, flow)?;
                self.line(&format!("AGAIN_{label}:"));
                Ok(())
            }
            Keyword::DoWhile => {
                let label = self.scoped(&name);
                self.leave(line, flow, true, &format!("AGAIN_{label}"))?;
                self.line(&format!("DONE_{label}:"));
                self.ways.end_loop();
                Ok(())
            }
            Keyword::Repeat => self.begin_repeat(line, &name, flow),
            Keyword::Endwhile | Keyword::Endrepeat => {
                let label = self.scoped(&name);
                self.line(&format!("GOTO AGAIN_{label}"));
                self.line(&format!("DONE_{label}:"));
                self.ways.end_loop();
                Ok(())
            }
            Keyword::Break => {
                let label = self.scoped(&name);
                self.line(&format!("GOTO DONE_{label}"));
                self.ways.leave_loop(&label);
                Ok(())
            }
            Keyword::If => {
                let label = self.fresh(line, &name)?;
                self.branches.push((label.clone(), 1));
                self.ways.begin_branch();
                self.leave(line, flow, false, &format!("ELSE_{label}_1"))
            }
            Keyword::Elseif | Keyword::Else => self.other_branch(line, flow),
            Keyword::Endif => {
                self.end_branches();
                Ok(())
            }
            _ => Err(Unkept::new(line, "this O-word")),
        }
    }

    fn begin_repeat(&mut self, line: u32, name: &str, flow: &Flow) -> Result<(), Unkept> {
        let label = self.begin_loop(line, name, flow)?;
        self.count(line, flow, &label)?;
        self.line(&format!("AGAIN_{label}:"));
        self.line(&format!("IF &turns_{label} < 1 THEN GOTO DONE_{label}"));
        self.line(&format!("&turns_{label} = &turns_{label} - 1"));
        Ok(())
    }

    fn end_branches(&mut self) {
        let Some((label, branch)) = self.branches.pop() else { return };
        if branch > 0 {
            self.line(&format!("ELSE_{label}_{branch}:"));
        }
        self.line(&format!("ENDIF_{label}:"));
        self.ways.end_branches(branch == 0);
    }

    /// Writes how often a loop turns: a count is rounded to the nearest whole number, halves to the even one.
    fn count(&mut self, line: u32, flow: &Flow, label: &str) -> Result<(), Unkept> {
        let turns = format!("&turns_{label}");
        let count = self.words(line).value(first(flow))?;
        if matches!(first(flow), Expr::Number(n) if n.fract() == 0.0) {
            self.line(&format!("{turns} = {count}"));
            return Ok(());
        }
        self.line(&format!("&count = {count}"));
        self.line(&format!("{turns} = INT(&count + 0.5)"));
        self.line(&format!(
            "IF {turns} - &count = 0.5 AND {turns} / 2 <> INT({turns} / 2) THEN {turns} = {turns} - 1"
        ));
        Ok(())
    }

    /// A label that stands only once: jumps go to the first of two.
    fn fresh(&mut self, line: u32, name: &str) -> Result<String, Unkept> {
        let label = self.scoped(name);
        if self.labels.insert(label.clone()) {
            return Ok(label);
        }
        Err(Unkept::new(line, "an O-word whose number or name stands twice"))
    }

    fn begin_loop(&mut self, line: u32, name: &str, flow: &Flow) -> Result<String, Unkept> {
        let label = self.fresh(line, name)?;
        let around = changes(self.program, line, flow.end.max(line));
        self.ways.begin_loop(label.clone(), flow.keyword != Keyword::Do, &around);
        Ok(label)
    }

    /// A jump to a label where the condition holds, or where it does not.
    fn leave(&mut self, line: u32, flow: &Flow, holds: bool, label: &str) -> Result<(), Unkept> {
        let condition = self.words(line).condition(first(flow), holds)?;
        self.line(&format!("IF {condition} THEN GOTO {label}"));
        Ok(())
    }

    fn other_branch(&mut self, line: u32, flow: &Flow) -> Result<(), Unkept> {
        let Some((label, branch)) = self.branches.pop() else { return Ok(()) };
        self.line(&format!("GOTO ENDIF_{label}"));
        self.line(&format!("ELSE_{label}_{branch}:"));
        self.ways.next_branch();
        let next = if flow.keyword == Keyword::Else { 0 } else { branch + 1 };
        self.branches.push((label.clone(), next));
        if next > 0 {
            self.leave(line, flow, false, &format!("ELSE_{label}_{next}"))?;
        }
        Ok(())
    }

    fn begin_sub(&mut self, line: u32, name: String) -> Result<(), Unkept> {
        if self.sub.is_some() {
            return Err(Unkept::new(line, "a subroutine within another"));
        }
        self.line(&format!("SUB_{name}:"));
        self.sub = Some(format!("s_{name}"));
        self.ways.begin_sub();
        Ok(())
    }

    /// The values of a call are the first parameters of the subroutine, the rest are zero.
    fn call(&mut self, line: u32, name: &str, flow: &Flow) -> Result<(), Unkept> {
        let Some(own) = self.survey.own.get(name).cloned() else {
            return Err(Unkept::new(line, "a subroutine of another file"));
        };
        for (n, value) in (1..).zip(&flow.values) {
            let value = self.words(line).alone(value)?;
            self.line(&format!("&s_{name}_p{n} = {value}"));
        }
        for n in own.into_iter().filter(|n| *n as usize > flow.values.len()) {
            self.line(&format!("&s_{name}_p{n} = 0"));
        }
        self.line(&format!("GOSUB SUB_{name}"));
        let first = flow.label.as_ref().and_then(|label| self.program.subs.get(label)).copied();
        let end = first.and_then(|first| end_of_sub(self.program, first)).unwrap_or(0);
        self.ways.call(&changes(self.program, first.unwrap_or(1), end));
        Ok(())
    }

    /// Labels of O-words are a subroutine's own.
    fn scoped(&self, name: &str) -> String {
        self.sub.as_ref().map_or_else(|| name.to_string(), |sub| format!("{sub}_{name}"))
    }

    pub(super) fn words(&self, line: u32) -> Words<'_> {
        Words { program: self.program, line, sub: self.sub.as_deref() }
    }
}

/// The condition or count of an O-word; the reader has checked that it is there.
fn first(flow: &Flow) -> &Expr {
    const ZERO: &Expr = &Expr::Number(0.0);
    flow.values.first().unwrap_or(ZERO)
}
