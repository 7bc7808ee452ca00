//! Which O-word belongs to which: every loop and branch finds its other end.

use crate::syntax::tree::{Flow, Keyword, Label, Node, Program, Span};
use kerf_diag::{Code, Diagnostic};

/// An O-word that waits for its end.
struct Open {
    line: u32,
    extra: usize,
    keyword: Keyword,
    label: Option<Label>,
    /// For `if`: the branch (by extra) that the next one is the target of.
    last: usize,
    /// For `if`: all branches behind the first.
    branches: Vec<usize>,
    /// `break` and `continue` in a loop.
    leaving: Vec<usize>,
}

/// Links every O-word of a program and lists its subroutines.
pub(super) fn link(program: &mut Program) {
    let mut linker = Linker { program, open: Vec::new(), found: Vec::new() };
    linker.run();
    let found = linker.found;
    if !found.is_empty() {
        program.diagnostics.extend(found);
        program.diagnostics.sort_by_key(|d| d.place.line);
    }
}

struct Linker<'a> {
    program: &'a mut Program,
    open: Vec<Open>,
    found: Vec<Diagnostic>,
}

impl Linker<'_> {
    fn run(&mut self) {
        if self.program.extras.is_empty() {
            return;
        }
        let mut marks = 0..;
        while let Some((index, node)) = marks.next().and_then(|at| self.program.lines.marked(at)) {
            let Node::Block(block) = node else { continue };
            let extra = self.program.blocks.get(block as usize).and_then(|b| b.extra);
            let Some(extra) = extra.map(|e| e as usize) else { continue };
            let Some(flow) = self.program.extras.get(extra).and_then(|e| e.flow.as_ref()) else {
                continue;
            };
            let (keyword, label, span) = (flow.keyword, flow.label.clone(), flow.span);
            self.take(index + 1, extra, keyword, label, span);
        }
        for open in std::mem::take(&mut self.open) {
            self.unclosed(&open);
        }
    }

    fn take(
        &mut self,
        line: u32,
        extra: usize,
        keyword: Keyword,
        label: Option<Label>,
        span: Span,
    ) {
        match keyword {
            Keyword::Sub | Keyword::Program => {
                if let Some(name) = &label {
                    self.define(name, line, span);
                }
                if keyword == Keyword::Sub {
                    self.begin(line, extra, keyword, label);
                }
            }
            Keyword::While if self.closes_do(label.as_ref()) => {
                self.flow(extra, |f| f.keyword = Keyword::DoWhile);
                self.end(line, extra, &[Keyword::Do], label.as_ref(), span);
            }
            Keyword::While | Keyword::Do | Keyword::If | Keyword::Repeat => {
                self.begin(line, extra, keyword, label);
            }
            Keyword::Elseif | Keyword::Else => {
                self.branch(line, extra, keyword, label.as_ref(), span)
            }
            Keyword::Endsub => self.end(line, extra, &[Keyword::Sub], label.as_ref(), span),
            Keyword::Endwhile => self.end(line, extra, &[Keyword::While], label.as_ref(), span),
            Keyword::Endrepeat => self.end(line, extra, &[Keyword::Repeat], label.as_ref(), span),
            Keyword::Endif => self.end(line, extra, &[Keyword::If], label.as_ref(), span),
            Keyword::Break | Keyword::Continue => self.leave(line, extra, label.as_ref(), span),
            Keyword::Call | Keyword::Return | Keyword::DoWhile => {}
        }
    }

    fn define(&mut self, name: &Label, line: u32, span: Span) {
        let first = *self.program.subs.entry(name.clone()).or_insert(line);
        if first != line {
            let message = format!("{name} is already defined in line {first}");
            self.tell(line, span, Code::BadFlow, &message, "each subroutine has a name of its own");
        }
    }

    fn closes_do(&self, label: Option<&Label>) -> bool {
        self.open.last().is_some_and(|o| o.keyword == Keyword::Do && o.label.as_ref() == label)
    }

    fn begin(&mut self, line: u32, extra: usize, keyword: Keyword, label: Option<Label>) {
        let (branches, leaving) = (Vec::new(), Vec::new());
        self.open.push(Open { line, extra, keyword, label, last: extra, branches, leaving });
    }

    fn find(&self, keywords: &[Keyword], label: Option<&Label>) -> Option<usize> {
        self.open.iter().rposition(|o| keywords.contains(&o.keyword) && o.label.as_ref() == label)
    }

    fn branch(
        &mut self,
        line: u32,
        extra: usize,
        keyword: Keyword,
        label: Option<&Label>,
        span: Span,
    ) {
        let Some(at) = self.find(&[Keyword::If], label) else {
            let what = if keyword == Keyword::Else { "else" } else { "elseif" };
            self.tell(line, span, Code::BadFlow, &format!("{what} without its if"), SAME_NUMBER);
            return;
        };
        self.close_above(at);
        if let Some(open) = self.open.get_mut(at) {
            let before = std::mem::replace(&mut open.last, extra);
            open.branches.push(extra);
            self.flow(before, |f| f.target = line);
        }
    }

    fn end(
        &mut self,
        line: u32,
        extra: usize,
        begins: &[Keyword],
        label: Option<&Label>,
        span: Span,
    ) {
        let Some(at) = self.find(begins, label) else {
            let message = "this ends nothing that was begun";
            self.tell(line, span, Code::BadFlow, message, SAME_NUMBER);
            return;
        };
        self.close_above(at);
        let Some(open) = self.open.pop() else { return };
        self.flow(open.last, |f| f.target = line);
        self.flow(open.extra, |f| f.end = line);
        self.flow(extra, |f| f.target = open.line);
        for branch in open.branches {
            self.flow(branch, |f| f.end = line);
        }
        for leaving in open.leaving {
            self.flow(leaving, |f| (f.target, f.end) = (open.line, line));
        }
    }

    fn leave(&mut self, line: u32, extra: usize, label: Option<&Label>, span: Span) {
        match self.find(&[Keyword::While, Keyword::Do, Keyword::Repeat], label) {
            Some(at) => self.open[at].leaving.push(extra),
            None => {
                let message = "break and continue stand within their loop";
                self.tell(line, span, Code::BadFlow, message, SAME_NUMBER);
            }
        }
    }

    /// Closes what was begun within and not ended, and reports it.
    fn close_above(&mut self, at: usize) {
        for open in self.open.split_off(at + 1) {
            self.unclosed(&open);
        }
    }

    fn unclosed(&mut self, open: &Open) {
        let Some(flow) = self.program.extras.get(open.extra).and_then(|e| e.flow.as_ref()) else {
            return;
        };
        let (what, end) = match open.keyword {
            Keyword::Sub => ("sub", "endsub"),
            Keyword::While => ("while", "endwhile"),
            Keyword::Do => ("do", "while"),
            Keyword::Repeat => ("repeat", "endrepeat"),
            _ => ("if", "endif"),
        };
        let span = flow.span;
        let name = open.label.as_ref().map_or("O".into(), Label::to_string);
        let message = format!("{name} {what} is never ended");
        self.tell(
            open.line,
            span,
            Code::BadFlow,
            &message,
            &format!("put {name} {end} at its end"),
        );
    }

    fn flow(&mut self, extra: usize, change: impl FnOnce(&mut Flow)) {
        if let Some(flow) = self.program.extras.get_mut(extra).and_then(|e| e.flow.as_mut()) {
            change(flow);
        }
    }

    fn tell(&mut self, line: u32, span: Span, code: Code, message: &str, hint: &str) {
        let place = self.program.place(line, span);
        self.found.push(Diagnostic::new(code, place, message).hint(hint));
    }
}

const SAME_NUMBER: &str = "both carry the same O number or name";
