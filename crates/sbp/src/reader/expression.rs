//! Expressions: precedence climbing over the bytes of the line.

use super::line::{Failed, Line, Read, is_name};
use super::moves::number;
use crate::expr::{BinaryOp, Expr, ExprNode, Function, UnaryOp};
use crate::tree::{NameId, Span};
use kerf_diag::Code;

/// Operators in one expression; a bound for memory and for whoever walks the tree.
const MOST_OPERATORS: u32 = 500;
/// Parentheses, signs and functions within each other.
const MOST_DEPTH: u32 = 64;

/// How tightly the two prefix operators bind.
const SIGN: u8 = 9;
const NOT: u8 = 3;

/// What stands between two operands.
enum Infix {
    Operator(BinaryOp, usize),
    /// A variable right behind a value: the join operator was left out.
    Adjacent,
    None,
}

impl Line<'_, '_> {
    /// An expression that fills a whole field.
    pub(super) fn whole_expression(&mut self, span: Span) -> Read<Expr> {
        self.within(span, |line| {
            let expr = line.expression()?;
            line.expect_end()?;
            Ok(expr)
        })
    }

    /// The longest expression at the cursor.
    pub(super) fn expression(&mut self) -> Read<Expr> {
        self.bounded(0, true)
    }

    /// An expression that ends where a variable follows without an operator (INPUT).
    pub(super) fn prompt_expression(&mut self) -> Read<Expr> {
        self.bounded(0, false)
    }

    /// An expression without comparisons and logic, for places where `=` ends it.
    fn bounded(&mut self, min: u8, join_adjacent: bool) -> Read<Expr> {
        self.operators_left = MOST_OPERATORS;
        self.depth_left = MOST_DEPTH;
        self.binary(min, join_adjacent)
    }

    fn binary(&mut self, min: u8, adjacent: bool) -> Read<Expr> {
        let mut left = self.operand(adjacent)?;
        loop {
            self.skip_blanks();
            let (op, length) = match self.infix() {
                Infix::Operator(op, length) => (op, length),
                Infix::Adjacent if adjacent => (BinaryOp::Join, 0),
                Infix::Adjacent | Infix::None => return Ok(left),
            };
            if op.precedence() < min {
                return Ok(left);
            }
            let span = self.operator(op, length)?;
            self.at += length;
            self.skip_blanks();
            if self.at_end() || matches!(self.peek(), b',' | b')' | b';') {
                let message = format!("a value is missing after {}", op.symbol());
                return Err(self.fault(Code::BadExpression, span, message, ""));
            }
            let right = self.binary(op.precedence() + 1, adjacent)?;
            let span = Span { start: left.span.start, end: right.span.end };
            let node = ExprNode::Binary(op, Box::new(left), Box::new(right));
            left = Expr { node, span };
        }
    }

    /// Counts an operator and tells of doubtful spellings.
    fn operator(&mut self, op: BinaryOp, length: usize) -> Read<Span> {
        let (start, end) = (self.at, self.at + length);
        let span = Span { start: start as u32, end: end as u32 };
        self.operators_left = self.operators_left.saturating_sub(1);
        if self.operators_left == 0 {
            let hint = "work it out in steps, with variables";
            return Err(self.fault(Code::BadExpression, span, "the expression is too long", hint));
        }
        let written = self.slice(start, end);
        if matches!(written, "=>" | "=<" | "==") {
            let message = format!("{written} is read as {}", op.symbol());
            self.warn(Code::DoubtfulSpelling, span, message, format!("write {}", op.symbol()));
        } else if length == 0 {
            let message = "an & to join is missing before this variable";
            self.warn(Code::DoubtfulSpelling, span, message, "write \"text\" & &name");
        }
        Ok(span)
    }

    fn infix(&self) -> Infix {
        use BinaryOp::*;
        let (op, length) = match (self.peek(), self.byte(self.at + 1)) {
            (b'+', _) => (Add, 1),
            (b'-', _) => (Subtract, 1),
            (b'*', _) => (Multiply, 1),
            (b'/', _) => (Divide, 1),
            (b'\\', _) => (IntegerDivide, 1),
            (b'^', _) => (Power, 1),
            (b'<', b'>') => (NotEqual, 2),
            (b'<', b'=') | (b'=', b'<') => (LessEqual, 2),
            (b'>', b'=') | (b'=', b'>') => (GreaterEqual, 2),
            (b'=', b'=') => (Equal, 2),
            (b'<', _) => (Less, 1),
            (b'>', _) => (Greater, 1),
            (b'=', _) => (Equal, 1),
            (b'&', next) if is_name(next) => return Infix::Adjacent,
            (b'&', _) => (Join, 1),
            (first, _) if first.is_ascii_alphabetic() => return self.word_operator(),
            _ => return Infix::None,
        };
        Infix::Operator(op, length)
    }

    fn word_operator(&self) -> Infix {
        let word = self.slice(self.at, self.word_end(self.at));
        let found = [BinaryOp::And, BinaryOp::Or, BinaryOp::Modulo]
            .into_iter()
            .find(|op| op.symbol().eq_ignore_ascii_case(word));
        found.map_or(Infix::None, |op| Infix::Operator(op, word.len()))
    }

    /// A value with its signs.
    fn operand(&mut self, adjacent: bool) -> Read<Expr> {
        self.skip_blanks();
        let start = self.at;
        let prefix = match self.peek() {
            b'-' => Some((UnaryOp::Minus, SIGN, 1)),
            b'+' => Some((UnaryOp::Plus, SIGN, 1)),
            b'N' | b'n' if self.slice(start, self.word_end(start)).eq_ignore_ascii_case("NOT") => {
                Some((UnaryOp::Not, NOT, 3))
            }
            _ => None,
        };
        let Some((op, binds, length)) = prefix else { return self.primary(adjacent) };
        self.at += length;
        let operand = self.deeper(start, |line| line.binary(binds, adjacent))?;
        let span = Span { start: start as u32, end: operand.span.end };
        if let (UnaryOp::Minus, ExprNode::Number(n)) = (op, &operand.node) {
            return Ok(Expr { node: ExprNode::Number(-n), span });
        }
        Ok(Expr { node: ExprNode::Unary(op, Box::new(operand)), span })
    }

    /// Goes one level down, within bounds.
    fn deeper<T>(&mut self, start: usize, read: impl FnOnce(&mut Self) -> Read<T>) -> Read<T> {
        if self.depth_left == 0 {
            let span = Span { start: start as u32, end: start as u32 + 1 };
            let hint = "work it out in steps, with variables";
            return Err(self.fault(Code::BadExpression, span, "nested too deep", hint));
        }
        self.depth_left -= 1;
        let result = read(self);
        self.depth_left += 1;
        result
    }

    fn primary(&mut self, adjacent: bool) -> Read<Expr> {
        let start = self.at;
        let node = match self.peek() {
            b'0'..=b'9' | b'.' => self.literal()?,
            b'"' => self.quoted()?,
            b'&' if is_name(self.byte(start + 1)) => {
                ExprNode::Variable(self.variable(start)?)
            }
            b'$' if is_name(self.byte(start + 1)) => {
                ExprNode::Persistent(self.variable(start)?)
            }
            b'%' => {
                self.at += 1;
                if !self.take(b'(') {
                    let span = self.span_from(start);
                    let hint = "a system variable is written %(n)";
                    return Err(self.fault(Code::BadExpression, span, "( expected after %", hint));
                }
                ExprNode::System(Box::new(self.parenthesised(start, adjacent)?))
            }
            b'(' => {
                self.at += 1;
                let inner = self.parenthesised(start, adjacent)?;
                return Ok(Expr { node: inner.node, span: self.span_from(start) });
            }
            first if is_name(first) => return self.word(start, adjacent),
            _ => return Err(self.no_value()),
        };
        Ok(Expr { node, span: self.span_from(start) })
    }

    /// The name behind `&` or `$`.
    fn variable(&mut self, start: usize) -> Read<NameId> {
        let end = self.word_end(start + 1);
        self.at = end;
        let member = self.peek() == b'.' && self.byte(end + 1).is_ascii_alphabetic();
        if self.peek() == b'[' || (member && self.byte(start) == b'$') {
            self.foreign = true;
            let stop = self.until(end, b' ');
            let span = Span { start: start as u32, end: stop as u32 };
            let hint = "FabMo's dialect; use plain variables";
            let message = "arrays and objects are not part of the language";
            return Err(self.fault(Code::BadExpression, span, message, hint));
        }
        Ok(self.name(start + 1, end))
    }

    fn no_value(&mut self) -> Failed {
        let span = self.span_to_end();
        let Some(found) = self.slice(self.at, self.end).chars().next() else {
            return self.fault(Code::BadExpression, span, "a value is expected", "");
        };
        let span = Span { start: span.start, end: span.start + found.len_utf8() as u32 };
        self.fault(Code::BadExpression, span, format!("a value is expected, not {found}"), "")
    }

    /// What stands up to the closing parenthesis; the opening one is behind us.
    fn parenthesised(&mut self, start: usize, adjacent: bool) -> Read<Expr> {
        let inner = self.deeper(start, |line| line.binary(0, adjacent))?;
        if self.take(b')') {
            return Ok(inner);
        }
        if !self.at_end() && self.peek() != b',' {
            self.expect_end()?;
        }
        let span = Span { start: start as u32, end: self.at as u32 };
        Err(self.fault(Code::UnclosedParenthesis, span, "a ) is missing", ""))
    }

    fn literal(&mut self) -> Read<ExprNode> {
        let start = self.at;
        let bytes = &self.text.as_bytes()[..self.end];
        if let Some(n) = number(bytes, &mut self.at)
            && !is_name(self.peek())
            && self.peek() != b'.'
        {
            return Ok(ExprNode::Number(n));
        }
        self.at = start;
        while is_name(self.peek()) || self.peek() == b'.' {
            self.at += 1;
        }
        let span = self.span_from(start);
        let message = format!("{} is not a number", self.slice(start, self.at));
        Err(self.fault(Code::BadExpression, span, message, ""))
    }

    /// Text in quotes.
    fn quoted(&mut self) -> Read<ExprNode> {
        let start = self.at;
        let bytes = &self.text.as_bytes()[start + 1..self.end];
        let Some(length) = memchr::memchr(b'"', bytes) else {
            let span = self.span_to_end();
            let hint = "text begins and ends with a double quote on the same line";
            return Err(self.fault(Code::UnclosedQuote, span, "a quote is not closed", hint));
        };
        self.at = start + length + 2;
        Ok(ExprNode::Text(self.slice(start + 1, start + 1 + length).into()))
    }

    /// A function, or bare words as text.
    fn word(&mut self, start: usize, adjacent: bool) -> Read<Expr> {
        self.at = self.word_end(start);
        let word = self.slice(start, self.at);
        let function = Function::from_name(word);
        self.skip_blanks();
        if self.peek() == b'(' {
            let Some(function) = function else { return Err(self.unknown_function(start)) };
            self.at += 1;
            let argument = Some(Box::new(self.parenthesised(start, adjacent)?));
            let node = ExprNode::Call(function, argument);
            return Ok(Expr { node, span: self.span_from(start) });
        }
        if function == Some(Function::Rnd) {
            let node = ExprNode::Call(Function::Rnd, None);
            return Ok(Expr { node, span: self.span_from(start) });
        }
        while self.more_words() {
            self.at = self.word_end(self.at + 1);
            self.skip_blanks();
        }
        let span = self.span_from(start);
        let text = self.slice(start, span.end as usize);
        Ok(Expr { node: ExprNode::Word(text.into()), span })
    }

    /// Whether the text goes on with another bare word.
    fn more_words(&self) -> bool {
        const STOPS: [&str; 8] = ["AND", "OR", "MOD", "NOT", "THEN", "GOTO", "GOSUB", "FOR"];
        if self.peek() == b'.' {
            return true;
        }
        let word = self.slice(self.at, self.word_end(self.at));
        !word.is_empty() && !STOPS.iter().any(|stop| stop.eq_ignore_ascii_case(word))
    }

    fn unknown_function(&mut self, start: usize) -> Failed {
        let end = self.word_end(start);
        let word = self.slice(start, end);
        let span = Span { start: start as u32, end: end as u32 };
        let message = format!("unknown function {}", word.to_uppercase());
        let names = Function::ALL.iter().map(|f| f.name());
        let hint = super::suggest::did_you_mean(word, names)
            .unwrap_or_else(|| "see kerf explain S008 for the list".into());
        self.fault(Code::UnknownFunction, span, message, hint)
    }
}

impl Expr {
    /// True when a bare word stands somewhere in it.
    pub(super) fn has_words(&self) -> bool {
        self.any(&|node| matches!(node, ExprNode::Word(_)))
    }

    /// True when something holds for one of its nodes.
    pub(super) fn any(&self, holds: &impl Fn(&ExprNode) -> bool) -> bool {
        holds(&self.node)
            || match &self.node {
                ExprNode::System(a) | ExprNode::Unary(_, a) | ExprNode::Call(_, Some(a)) => {
                    a.any(holds)
                }
                ExprNode::Binary(_, a, b) => a.any(holds) || b.any(holds),
                _ => false,
            }
    }
}
