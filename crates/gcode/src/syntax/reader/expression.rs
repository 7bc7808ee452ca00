//! Values: numbers, parameters, functions and expressions in brackets.

use super::compact::Compact;
use super::file::File;
use crate::syntax::expr::{Expr, Function, Operator};
use crate::syntax::gathered::Fault;
use crate::syntax::moves;
use crate::syntax::tree::{Span, Value};
use kerf_diag::Code;

/// Expressions nested deeper, or longer chains, are refused.
const MOST_DEPTH: u32 = 30;
/// Operators of one chain.
const MOST_CHAIN: u32 = 60;

/// Reads one line.
pub(super) struct Reader<'a> {
    pub(super) compact: &'a Compact,
    pub(super) file: &'a mut File,
    pub(super) at: usize,
    /// Index of the first word of this line.
    pub(super) first_word: usize,
}

impl<'a> Reader<'a> {
    pub(super) fn new(compact: &'a Compact, file: &'a mut File) -> Self {
        let first_word = file.words.len();
        Self { compact, file, at: 0, first_word }
    }

    pub(super) fn is_at_end(&self) -> bool {
        self.at >= self.compact.bytes.len()
    }

    /// The byte here, 0 at the end.
    pub(super) fn peek(&self) -> u8 {
        self.compact.byte(self.at)
    }

    pub(super) fn peek_at(&self, ahead: usize) -> u8 {
        self.compact.byte(self.at + ahead)
    }

    /// Goes behind a word if it stands here.
    pub(super) fn eat(&mut self, word: &str) -> bool {
        let here = self.compact.bytes.get(self.at..).unwrap_or_default();
        let found = here.starts_with(word.as_bytes());
        self.at += if found { word.len() } else { 0 };
        found
    }

    pub(super) fn fault_from(&self, start: usize, code: Code, message: impl Into<String>) -> Fault {
        let end = if self.at > start { self.at } else { start + 1 };
        Fault::new(code, self.compact.span(start, end), message)
    }

    /// The value of a word; `None` when there is none.
    pub(super) fn value(&mut self) -> Result<Option<Value>, Fault> {
        let start = self.at;
        let negative = self.peek() == b'-';
        let signed = negative || self.peek() == b'+';
        self.at += usize::from(signed);
        if let Some(n) = moves::number(&self.compact.bytes, &mut self.at) {
            return Ok(Some(Value::Number(if negative { -n } else { n })));
        }
        self.at = start;
        Ok(self.primary(0)?.map(|expr| {
            self.file.exprs.push(expr);
            Value::Computed(self.file.exprs.len() as u32 - 1)
        }))
    }

    /// A number, parameter, function or bracket, with a sign before it.
    pub(super) fn primary(&mut self, depth: u32) -> Result<Option<Expr>, Fault> {
        let start = self.at;
        if depth > MOST_DEPTH {
            return Err(self.fault_from(start, Code::BadFormula, "nested too deep"));
        }
        let negative = self.peek() == b'-';
        if negative || self.peek() == b'+' {
            self.at += 1;
            let inner = self.expect_primary(depth + 1)?;
            return Ok(Some(if negative {
                Expr::Call(Function::Negate, inner.into())
            } else {
                inner
            }));
        }
        if let Some(n) = moves::number(&self.compact.bytes, &mut self.at) {
            return Ok(Some(Expr::Number(n)));
        }
        match self.peek() {
            b'#' => {
                self.at += 1;
                if let Some(id) = self.parameter_name()? {
                    return Ok(Some(Expr::Named(id)));
                }
                Ok(Some(Expr::Numbered(self.expect_primary(depth + 1)?.into())))
            }
            b'[' => self.bracket(depth + 1).map(Some),
            _ => self.function(depth),
        }
    }

    pub(super) fn expect_primary(&mut self, depth: u32) -> Result<Expr, Fault> {
        let start = self.at;
        match self.primary(depth)? {
            Some(expr) => Ok(expr),
            None => {
                let fault = self.fault_from(start, Code::BadFormula, "a value is missing");
                Err(fault.hint("a value is a number, #5, #<name>, a function or [an expression]"))
            }
        }
    }

    fn function(&mut self, depth: u32) -> Result<Option<Expr>, Fault> {
        let start = self.at;
        if self.eat("ATAN[") {
            self.at -= 1;
            let y = self.bracket(depth + 1)?;
            if !self.eat("/[") {
                let fault = self.fault_from(start, Code::BadFormula, "ATAN needs two values");
                return Err(fault.hint("write ATAN[y]/[x]"));
            }
            self.at -= 1;
            return Ok(Some(Expr::Atan(y.into(), self.bracket(depth + 1)?.into())));
        }
        if self.eat("EXISTS[#") {
            let name = self.parameter_name()?;
            let (Some(id), true) = (name, self.eat("]")) else {
                let fault =
                    self.fault_from(start, Code::BadFormula, "EXISTS asks for a named parameter");
                return Err(fault.hint("write EXISTS[#<name>]"));
            };
            return Ok(Some(Expr::Exists(id)));
        }
        for (name, function) in Function::NAMED {
            if self.compact.byte(self.at + name.len()) == b'[' && self.eat(name) {
                let inner = self.bracket(depth + 1)?;
                return Ok(Some(Expr::Call(function, inner.into())));
            }
        }
        Ok(None)
    }

    /// `[ … ]`
    pub(super) fn bracket(&mut self, depth: u32) -> Result<Expr, Fault> {
        let start = self.at;
        self.at += 1;
        let expr = self.operators(0, depth)?;
        if self.peek() != b']' {
            let end = self.at;
            let fault = self.fault_from(end, Code::BadFormula, "an operator or ] is missing here");
            let open = self.compact.span(start, start + 1).start + 1;
            return Err(fault.hint(format!("the bracket was opened in column {open}")));
        }
        self.at += 1;
        Ok(expr)
    }

    fn operators(&mut self, above: u8, depth: u32) -> Result<Expr, Fault> {
        let start = self.at;
        let mut left = self.expect_primary(depth)?;
        let mut chain = 0;
        while let Some((word, operator)) = self.operator(above) {
            chain += 1;
            if chain > MOST_CHAIN || depth > MOST_DEPTH {
                return Err(self.fault_from(start, Code::BadFormula, "the expression is too long"));
            }
            self.at += word.len();
            let right = self.operators(operator.strength(), depth + 1)?;
            left = Expr::Binary(operator, left.into(), right.into());
        }
        Ok(left)
    }

    fn operator(&self, above: u8) -> Option<(&'static str, Operator)> {
        let here = self.compact.bytes.get(self.at..).unwrap_or_default();
        let found = Operator::WRITTEN.into_iter().find(|(w, _)| here.starts_with(w.as_bytes()))?;
        (found.1.strength() > above).then_some(found)
    }

    /// `<name>` behind a `#`, as its number.
    pub(super) fn parameter_name(&mut self) -> Result<Option<u32>, Fault> {
        if self.peek() != b'<' {
            return Ok(None);
        }
        let name = self.bracketed_name()?;
        Ok(Some(self.file.name_id(&name)))
    }

    /// `<name>` in small letters.
    pub(super) fn bracketed_name(&mut self) -> Result<String, Fault> {
        let start = self.at;
        let rest = self.compact.bytes.get(start + 1..).unwrap_or_default();
        let Some(length) = rest.iter().position(|b| *b == b'>') else {
            let fault = self.fault_from(start, Code::BadFormula, "the name is not closed");
            return Err(fault.hint("a name stands between < and >"));
        };
        self.at = start + length + 2;
        Ok(String::from_utf8_lossy(&rest[..length]).to_lowercase())
    }

    /// Returns the stretch from `start` to the present place, for messages.
    pub(super) fn span_from(&self, start: usize) -> Span {
        self.compact.span(start, self.at)
    }
}
