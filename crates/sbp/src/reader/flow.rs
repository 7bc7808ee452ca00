//! IF, jumps, ON INPUT, PAUSE and END.

use super::file::{is_label, label_name};
use super::line::{Line, Read};
use super::suggest::did_you_mean;
use crate::expr::{Expr, ExprNode};
use crate::tree::{Span, Statement, Target};
use kerf_diag::Code;

impl Line<'_, '_> {
    pub(super) fn if_then(&mut self, start: usize, inner: bool) -> Read<Statement> {
        if inner {
            let span = Span { start: start as u32, end: self.end as u32 };
            let hint = "join the conditions with AND, or jump over the line";
            return Err(self.fault(Code::Syntax, span, "an IF cannot stand here", hint));
        }
        let condition = self.expression();
        let then = match (&condition, self.take_word("THEN")) {
            (_, true) => true,
            (Ok(_), false) => return Err(self.then_expected()),
            // The condition is at fault; go on behind THEN to see the rest of the line.
            (Err(_), false) => self.seek_then(),
        };
        if !then {
            return Err(super::line::Failed);
        }
        self.skip_blanks();
        if self.at_end() {
            let span = self.span_to_end();
            let hint = "write what to do on the same line";
            return Err(self.fault(Code::Syntax, span, "a statement is expected after THEN", hint));
        }
        let then = self.statement(true)?;
        Ok(Statement::If { condition: condition?, then: Box::new(then) })
    }

    fn then_expected(&mut self) -> super::line::Failed {
        self.skip_blanks();
        let end = self.word_end(self.at).max(self.at);
        let word = self.slice(self.at, end);
        let span = Span { start: self.at as u32, end: end as u32 };
        let hint = did_you_mean(word, ["THEN"].into_iter())
            .unwrap_or_else(|| "IF condition THEN statement".into());
        self.fault(Code::ThenExpected, span, "THEN expected", hint)
    }

    fn seek_then(&mut self) -> bool {
        while !self.at_end() {
            let end = self.word_end(self.at);
            if self.slice(self.at, end).eq_ignore_ascii_case("THEN") {
                self.at = end;
                return true;
            }
            let next = self.slice(self.at, self.end).chars().next().map_or(1, char::len_utf8);
            self.at = end.max(self.at + next);
        }
        false
    }

    /// The label of a jump.
    pub(super) fn target(&mut self, start: usize) -> Read<Target> {
        let keyword = self.slice(start, self.at).to_uppercase();
        let mut span = self.span_to_end();
        let mut written = self.rest();
        if let Some(name) = written.strip_suffix(':') {
            let message = format!("a label is written without a colon after {keyword}");
            let hint = format!("write {keyword} {}", name.trim_end());
            self.warn(Code::DoubtfulSpelling, span, message, hint);
            written = name.trim_end();
            span.end = span.start + written.len() as u32;
        }
        self.at = self.end;
        if written.is_empty() {
            let message = format!("{keyword} needs a label");
            let whole = Span { start: start as u32, end: self.end as u32 };
            return Err(self.fault(Code::Syntax, whole, message, "name a label of this file"));
        }
        if written.split_whitespace().any(|w| w.eq_ignore_ascii_case("ELSE")) {
            let hint = "there is no ELSE; use a second IF";
            return Err(self.fault(Code::UnknownStatement, span, "unknown statement ELSE", hint));
        }
        if !is_label(written) {
            let message = format!("'{written}' is not the name of a label");
            let hint = "jumps go to labels: names alone on a line, ending in a colon";
            return Err(self.fault(Code::Syntax, span, message, hint));
        }
        Ok(Target { name: label_name(written), line: None, span })
    }

    pub(super) fn on_input(&mut self, start: usize, inner: bool) -> Read<Statement> {
        let whole = Span { start: start as u32, end: self.end as u32 };
        if inner {
            let hint = "put it on a line of its own and jump over it";
            return Err(self.fault(Code::Syntax, whole, "ON INPUT cannot stand here", hint));
        }
        let found = self.take_word("INPUT") || self.take_word("INP");
        if !found || !self.take(b'(') {
            let hint = "write ON INPUT(switch, state) action";
            return Err(self.fault(Code::Syntax, whole, "INPUT( expected after ON", hint));
        }
        let (switch, state) = self.pair(whole)?;
        if !self.take(b')') {
            let span = self.span_to_end();
            let message = "a ) is missing after the state";
            return Err(self.fault(Code::UnclosedParenthesis, span, message, ""));
        }
        self.skip_blanks();
        let action = match self.at_end() {
            true => None,
            false => Some(Box::new(self.statement(true)?)),
        };
        Ok(Statement::OnInput { switch, state, action })
    }

    /// `switch, state`.
    fn pair(&mut self, whole: Span) -> Read<(Expr, Expr)> {
        let switch = self.expression()?;
        if !self.take(b',') {
            let hint = "give the switch and its state: 1 for on, 0 for off";
            return Err(self.fault(Code::MissingParameter, whole, "the state is missing", hint));
        }
        Ok((switch, self.expression()?))
    }

    pub(super) fn pause(&mut self, start: usize) -> Read<Statement> {
        let whole = Span { start: start as u32, end: self.end as u32 };
        if self.take_word("UNTIL") {
            self.take(b',');
            let (switch, state) = self.pair(whole)?;
            self.trailing_commas();
            self.expect_end()?;
            return Ok(Statement::PauseUntil { switch, state });
        }
        self.take(b',');
        self.skip_blanks();
        if self.at_end() {
            return Ok(Statement::Pause { seconds: None });
        }
        let seconds = self.expression()?;
        if seconds.any(&|node| matches!(node, ExprNode::Text(_))) {
            let hint = "the message of a pause is the comment line above it";
            let message = "PAUSE takes seconds, not text";
            return Err(self.fault(Code::Syntax, seconds.span, message, hint));
        }
        self.trailing_commas();
        self.expect_end()?;
        Ok(Statement::Pause { seconds: Some(seconds) })
    }

    /// END and END ALL.
    pub(super) fn end_statement(&mut self, start: usize) -> Read<Statement> {
        if self.take_word("ALL") {
            return Ok(self.ended(Statement::EndAll));
        }
        if self.take_word("IF") {
            let span = self.span_from(start);
            let hint = "an IF ends with its line";
            return Err(self.fault(Code::UnknownStatement, span, "unknown statement END IF", hint));
        }
        Ok(self.ended(Statement::End))
    }

    /// A statement behind which the rest of the line means nothing.
    pub(super) fn ended(&mut self, statement: Statement) -> Statement {
        self.skip_blanks();
        if !self.at_end() {
            let span = self.span_to_end();
            let hint = "make it a comment with an apostrophe";
            self.warn(Code::TextAfterEnd, span, "the rest of the line is ignored", hint);
            self.at = self.end;
        }
        statement
    }
}
