//! The parts of a program as they are gathered while its file is read.

use super::compact::Compact;
use super::{ends, foreign, link};
use crate::syntax::expr::Expr;
use crate::syntax::gathered::Fault;
use crate::syntax::lines::Lines;
use crate::syntax::moves;
use crate::syntax::text::{after_line_end, is_blank, line_end};
use crate::syntax::tree::{Block, Extra, Node, PlainMove, Program, Span, Word};
use kerf_diag::{Code, Diagnostic, Severity, SourcePlace};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Longer lines are refused; no person and no program writes them.
const MOST_LINE_BYTES: usize = 100_000;

/// Diagnostics that are kept; a file that is no program would give millions.
pub(super) const MOST_DIAGNOSTICS: usize = 10_000;

/// A file while it is read.
#[derive(Debug)]
pub(super) struct File {
    name: Arc<str>,
    lines: Lines,
    pub(super) blocks: Vec<Block>,
    pub(super) words: Vec<Word>,
    pub(super) extras: Vec<Extra>,
    pub(super) exprs: Vec<Expr>,
    names: Vec<Arc<str>>,
    name_ids: BTreeMap<Arc<str>, u32>,
    diagnostics: Vec<Diagnostic>,
    /// Diagnostics that were told but not kept.
    untold: usize,
    /// Lines that look like OpenSBP.
    foreign: usize,
    compact: Compact,
    /// A line that is no blank and no comment was read.
    began: bool,
    /// The line of the `%` that ended the program: what stands behind it is never reached.
    ended: Option<u32>,
}

impl File {
    pub(super) fn new(name: Arc<str>) -> Self {
        Self {
            name,
            lines: Lines::default(),
            blocks: Vec::new(),
            words: Vec::new(),
            extras: Vec::new(),
            exprs: Vec::new(),
            names: Vec::new(),
            name_ids: BTreeMap::new(),
            diagnostics: Vec::new(),
            untold: 0,
            foreign: 0,
            compact: Compact::default(),
            began: false,
            ended: None,
        }
    }

    /// Reads every line of a text.
    pub(super) fn read(&mut self, text: &str) {
        let bytes = text.as_bytes();
        let (mut start, mut plain) = (0, PlainMove::default());
        while start < bytes.len() {
            let (node, next) = match moves::end(bytes, start, &mut plain) {
                Some(end) => {
                    self.began = true;
                    (Node::Move, after_line_end(bytes, end))
                }
                None => {
                    let (end, next) = line_end(bytes, start);
                    (self.line(&text[start..end]), next)
                }
            };
            self.lines.push(node, start as u32);
            start = next;
        }
    }

    fn line(&mut self, text: &str) -> Node {
        let Some(first) = text.bytes().find(|b| !is_blank(*b)) else { return Node::Blank };
        if text.len() > MOST_LINE_BYTES {
            let message = format!("the line is longer than {MOST_LINE_BYTES} characters");
            self.fault(Fault::new(Code::LineTooLong, Span::default(), message));
            return Node::Bad;
        }
        match first {
            b'%' => return self.percent(text),
            b'$' => return Node::Console,
            // Senders ask a controller for its state by these, and stop and start it.
            b'?' | b'!' | b'~' if text.trim().len() == 1 => return Node::Console,
            _ => {}
        }
        let mut compact = std::mem::take(&mut self.compact);
        let node = match compact.take(text) {
            Ok(()) if compact.bytes.is_empty() && compact.comments.is_empty() => Node::Blank,
            Ok(()) => {
                self.began |= !compact.bytes.is_empty();
                self.block(&mut compact, text)
            }
            Err(fault) => {
                self.fault(fault);
                Node::Bad
            }
        };
        self.compact = compact;
        node
    }

    /// The first one begins the program, when nothing stands before it; any other ends it.
    fn percent(&mut self, text: &str) -> Node {
        if std::mem::replace(&mut self.began, true) && self.ended.is_none() {
            self.ended = Some(self.number());
        }
        let rest = text.trim().trim_start_matches('%').trim();
        let named = rest.is_empty()
            || rest.starts_with(['(', ';'])
            || rest.chars().all(|c| c.is_alphanumeric() || c.is_whitespace());
        if !named {
            let span = Span { start: 0, end: text.len() as u32 };
            let message = "text behind % is not read";
            self.note(Fault::new(Code::TextAfterEnd, span, message), Severity::Warning);
        }
        Node::Percent
    }

    /// The line that is being read, from 1.
    pub(super) fn number(&self) -> u32 {
        self.lines.len() + 1
    }

    /// Something wrong with the line that is being read.
    pub(super) fn fault(&mut self, fault: Fault) {
        let severity = fault.code.severity();
        self.note(fault, severity);
    }

    /// The same with another severity.
    pub(super) fn note(&mut self, fault: Fault, severity: Severity) {
        if self.diagnostics.len() >= MOST_DIAGNOSTICS {
            self.untold += 1;
            return;
        }
        // The place in characters is found when the whole text is there.
        let Span { start, end } = fault.span;
        let place = SourcePlace {
            file: self.name.clone(),
            line: self.number(),
            column: start,
            length: end.saturating_sub(start),
        };
        let (hint, severity) = match self.ended.filter(|end| *end < self.number()) {
            Some(end) => {
                let hint = format!("never reached: it stands behind the % of line {end}");
                (hint, Severity::Warning)
            }
            None => (fault.hint, severity),
        };
        let diagnostic = Diagnostic::new(fault.code, place, fault.message);
        self.diagnostics.push(diagnostic.hint(hint).severity(severity));
    }

    /// Counts a line that looks like OpenSBP.
    pub(super) fn is_foreign(&mut self) {
        self.foreign += 1;
    }

    /// The number of a parameter's name.
    pub(super) fn name_id(&mut self, name: &str) -> u32 {
        if let Some(id) = self.name_ids.get(name) {
            return *id;
        }
        let id = self.names.len() as u32;
        let name: Arc<str> = name.into();
        self.names.push(name.clone());
        self.name_ids.insert(name, id);
        id
    }

    /// Everything together; O-words find their partners.
    pub(super) fn finish(mut self, text: Arc<String>) -> Program {
        if self.untold > 0 {
            let message = format!("{} more findings are not listed", self.untold);
            let place = SourcePlace::line(self.name.clone(), self.lines.len());
            self.diagnostics.push(Diagnostic::new(Code::BadBlock, place, message));
        }
        let foreign = self.foreign;
        let mut program = Program {
            name: self.name,
            text,
            lines: self.lines,
            blocks: self.blocks,
            words: self.words,
            extras: self.extras,
            exprs: self.exprs,
            names: self.names,
            subs: BTreeMap::new(),
            diagnostics: Vec::new(),
        };
        let found = match ends::last_line(&program) {
            Some(end) => ends::never_reached(self.diagnostics, end),
            None => self.diagnostics,
        };
        program.diagnostics = characters(&program, found);
        link::link(&mut program);
        foreign::judge(&mut program, foreign);
        program
    }
}

/// Places in bytes become places in characters.
fn characters(program: &Program, mut found: Vec<Diagnostic>) -> Vec<Diagnostic> {
    for diagnostic in &mut found {
        let place = &diagnostic.place;
        let span = Span { start: place.column, end: place.column + place.length };
        diagnostic.place = program.place(place.line, span);
    }
    found
}
