//! Assignments: `&name = …`, `$name = …`, `&name := …`.

use super::line::{Failed, Line, Read, is_name};
use crate::syntax::Dialect;
use crate::syntax::expr::{BinaryOp, Expr, ExprNode, Function};
use crate::syntax::tree::{Assigned, Span, Statement};
use kerf_diag::{Code, Diagnostic};

impl Line<'_, '_> {
    pub(super) fn assignment(&mut self, persistent: bool) -> Read<Statement> {
        let start = self.at;
        let end = self.word_end(start + 1);
        self.at = end;
        if self.file.dialect == Dialect::Fabmo && end > start + 1 && self.at_member(start) {
            return self.member_assignment(start);
        }
        self.skip_blanks();
        let only_if_undefined = self.peek() == b':' && self.byte(self.at + 1) == b'=';
        self.at += usize::from(only_if_undefined);
        if end > start + 1 && self.at_end() {
            return Ok(self.mention(start));
        }
        if end == start + 1 || self.peek() != b'=' {
            return Err(self.bad_name(start, end));
        }
        self.at += 1;
        let name = self.name(start + 1, end);
        let value = self.assigned()?;
        let span = Span { start: start as u32, end: end as u32 };
        Ok(Statement::Assign { name, persistent, only_if_undefined, value, span })
    }

    /// A variable alone on its line: files that run on machines have it, and nothing happens there.
    fn mention(&mut self, start: usize) -> Statement {
        let span = self.span_from(start);
        let message = "a variable alone on its line does nothing";
        self.warn(Code::DoubtfulSpelling, span, message, "an assignment is written &name = value");
        Statement::Mention(span)
    }

    /// Reports that what stands before `=` is no variable's name.
    fn bad_name(&mut self, start: usize, end: usize) -> Failed {
        let equals = self.until(start, b'=');
        let name = Span { start: start as u32, end: end as u32 };
        if equals >= self.end {
            let hint = "an assignment is written &name = value";
            return self.fault(Code::Syntax, name, "= expected behind a variable", hint);
        }
        let bad = (end..equals).find(|at| !is_name(self.byte(*at))).unwrap_or(end);
        let found = self.slice(bad, equals).chars().next().unwrap_or('=');
        let span = Span { start: bad as u32, end: (bad + found.len_utf8()) as u32 };
        let hint = match found {
            '[' | '.' => super::fabmo::ARRAYS_HINT,
            _ => "letters, digits and underscores are allowed",
        };
        let message = format!("character not allowed in a variable name: '{found}'");
        self.fault(Code::BadVariableName, span, message, hint)
    }

    /// The value: computed where all of it can be, text otherwise.
    pub(super) fn assigned(&mut self) -> Read<Assigned> {
        let text = self.rest();
        if text.is_empty() {
            return Ok(Assigned::Nothing);
        }
        let span = self.span_to_end();
        if text.starts_with('"') && !text[1..].contains('"') {
            self.expression()?;
        }
        let mark = self.mark();
        match self.whole_expression(span) {
            Ok(expr) if !(self.words && self.is_text(&expr)) => {
                self.at = self.end;
                return Ok(Assigned::Expr(self.spelled_out(expr)));
            }
            Ok(expr) => self.refuse_words(&expr)?,
            Err(failed) if self.foreign || self.calls(mark) => return Err(failed),
            Err(_) => {}
        }
        self.forget(mark);
        self.at = self.end;
        // A number and then a command: a line end was forgotten.
        if looks_computed(text) || (self.second_command && !text.starts_with(char::is_alphabetic)) {
            let hint = "put text in quotes, or mend the expression";
            let message = "this is no expression and is taken as text";
            self.warn(Code::DoubtfulSpelling, span, message, hint);
        }
        Ok(Assigned::Text(text.into()))
    }

    /// Returns `true` if reading failed at an unknown function that was surely meant to be one: its parenthesis follows
    /// at once and holds no words.
    fn calls(&self, mark: usize) -> bool {
        let unknown = |found: &&Diagnostic| found.code == Code::UnknownFunction;
        let Some(found) = self.file.diagnostics[mark..].iter().find(unknown) else { return false };
        let behind = found.place.column as usize - 1 + found.place.length as usize;
        let text: String = self.slice(0, self.end).chars().skip(behind).collect();
        let Some(inside) = text.strip_prefix('(') else { return false };
        let inside = inside.rsplit_once(')').map_or(inside, |(inside, _)| inside);
        inside.split(|c: char| !(c.is_alphanumeric() || "_&$".contains(c))).all(is_computed)
    }

    /// Refuses a bare word within arithmetic that cannot be text: it is multiplied, or calculated with a value.
    fn refuse_words(&mut self, expr: &Expr) -> Read<()> {
        let Some(word) = self.word_in_arithmetic(expr) else { return Ok(()) };
        let text = self.slice(word.start as usize, word.end as usize);
        let message = format!("the word {text} stands in a calculation");
        let hint = format!("write &{text} for the variable, or put text in quotes");
        Err(self.fault(Code::BadExpression, word, message, hint))
    }

    /// The place of such a word.
    fn word_in_arithmetic(&self, expr: &Expr) -> Option<Span> {
        let ExprNode::Binary(op, a, b) = expr.node else { return None };
        let operands = &self.file.expressions;
        let (a, b) = (&operands[a], &operands[b]);
        let named = |expr: &Expr| match expr.node {
            ExprNode::Word(text) => !operands[text].contains([' ', '.']),
            _ => false,
        };
        let calculated = |expr: &Expr| match op {
            BinaryOp::Multiply | BinaryOp::Power => !operands.has_words(expr),
            _ => op.precedence() > BinaryOp::Join.precedence() && operands.has_values(expr),
        };
        for (word, other) in [(a, b), (b, a)] {
            if named(word) && calculated(other) {
                return Some(word.span);
            }
        }
        self.word_in_arithmetic(a).or_else(|| self.word_in_arithmetic(b))
    }

    /// True for bare words that are no part of a join or a comparison with something else.
    fn is_text(&self, expr: &Expr) -> bool {
        let operands = &self.file.expressions;
        let is_word = |expr: &Expr| matches!(expr.node, ExprNode::Word(_));
        match expr.node {
            ExprNode::Word(_) => true,
            ExprNode::Binary(op, a, b) if op.precedence() <= BinaryOp::Join.precedence() => {
                let (a, b) = (&operands[a], &operands[b]);
                let (text_a, text_b) = (self.is_text(a), self.is_text(b));
                text_a && (text_b || !is_word(a)) || (text_b && !is_word(b))
            }
            _ => operands.has_words(expr),
        }
    }

    /// `&a = "&b"` is an old way to say: the value of b as text.
    fn spelled_out(&mut self, expr: Expr) -> Expr {
        let ExprNode::Text(text) = &expr.node else { return expr };
        let text = self.file.expressions[*text].clone();
        let Some(name) = text.strip_prefix('&') else { return expr };
        if name.is_empty() || !name.bytes().all(is_name) {
            return expr;
        }
        let span = Span { start: expr.span.start + 1, end: expr.span.end - 1 };
        let id = self.file.name_id(name);
        let variable = Expr { node: ExprNode::Variable(id), span };
        let nothing = self.text_at("", span);
        let node = self.join(BinaryOp::Join, variable, nothing);
        Expr { node, span: expr.span }
    }
}

/// Returns `true` if a part of an argument is a number, a variable or a function.
fn is_computed(part: &str) -> bool {
    let number = !part.bytes().any(|b| b.is_ascii_alphabetic());
    number || part.starts_with(['&', '$']) || Function::from_name(part).is_some()
}

/// True for text that was probably meant to be computed.
fn looks_computed(text: &str) -> bool {
    text.starts_with(['&', '$', '%', '(', '-', '+'])
        || text.contains('"')
        || !text.bytes().any(|b| b.is_ascii_alphabetic())
}

#[cfg(test)]
mod tests {
    use super::super::shown::{check, finds};

    #[test]
    fn values_are_computed_or_text() {
        for (text, tree) in [
            ("&a=5", "&A = 5"),
            ("&Zdepth = -0.52 'deep", "&ZDEPTH = -0.52"),
            ("&a=", "&A = nothing"),
            ("&my_x= 'none", "&MY_X = nothing"),
            ("$a = &b", "$A = &B"),
            ("&v := .5", "&V := 0.5"),
            ("$v:=1", "$V := 1"),
            ("&MyString = test string ", "&MYSTRING = 'test string'"),
            ("&MyString = \"test string\"", "&MYSTRING = \"test string\""),
            ("&a = 3+4", "&A = (3 + 4)"),
            ("&a = 3/8 ply", "&A = '3/8 ply'"),
            ("&a = Table Surface", "&A = 'Table Surface'"),
            ("&ResetZ = no 'comment", "&RESETZ = 'no'"),
            ("&p = C:\\SbParts\\Custom\\ATC\\", "&P = 'C:\\SbParts\\Custom\\ATC\\'"),
            ("&a = Tom & Jerry", "&A = 'Tom & Jerry'"),
            ("&f = T & &n & \"_.sbp\"", "&F = (('T' & &N) & \"_.sbp\")"),
            ("&a = X-Y table", "&A = 'X-Y table'"),
            ("&c = (&b = yes)", "&C = (&B = 'yes')"),
            ("&numrows=(&numrows-.5)\\1", "&NUMROWS = ((&NUMROWS - 0.5) \\ 1)"),
            ("&answer=\"&answer\"", "&ANSWER = (&ANSWER & \"\")"),
            ("&a = 1/4\" bit", "&A = '1/4\" bit'"),
        ] {
            check(text, tree);
        }
    }

    #[test]
    fn text_that_looks_computed_warns() {
        check("&a = 3*", "&A = '3*'");
        for (text, finding) in [
            ("&a = 3*", "W003 1:6+2 this is no expression and is taken as text"),
            ("&a = 1,5", "W003 1:6+3"),
            ("&a = 5 MX,1", "W003 1:6+6"),
            ("&a = (&b+1", "W003 1:6+5"),
            ("&a = &b frogs", "W003 1:6+8"),
        ] {
            finds(text, &[finding]);
        }
        finds("&a = Material Surface", &[]);
        finds("&a = \"open", &["S005 1:6+5 a quote is not closed"]);
    }

    #[test]
    fn an_unknown_function_is_no_text() {
        for (text, finding) in [
            ("&a=ARCCOS(&x)", "S008 1:4+6 unknown function ARCCOS [did you mean ACOS?]"),
            ("&a=2*RUOND(&x)", "S008 1:6+5 unknown function RUOND [did you mean ROUND?]"),
            ("&a=MAX(1,2)", "S008 1:4+3 unknown function MAX"),
            ("$a=FROB(SIN(&x))", "S008 1:4+4 unknown function FROB"),
            ("&a=PI(2)", "S008 1:4+2 unknown function PI"),
        ] {
            finds(text, &[finding]);
        }
        for (text, tree) in [
            ("&a = Panel(left)", "&A = 'Panel(left)'"),
            ("&a = Bit (1/4)", "&A = 'Bit (1/4)'"),
            ("&a = ACOS(.5)*2", "&A = (ACOS[0.5] * 2)"),
            ("&a = SIN(90*PI/180)", "&A = SIN[((90 * PI[]) / 180)]"),
        ] {
            check(text, tree);
        }
    }

    #[test]
    fn a_bare_word_in_a_calculation_is_no_text() {
        for (text, finding) in [
            (
                "&a=5*x",
                "S007 1:6+1 the word x stands in a calculation [write &x for the variable, or",
            ),
            ("&a=depth*2", "S007 1:4+5 the word depth"),
            ("&a=&b-depth", "S007 1:7+5 the word depth"),
            ("&a=(&b+1)/n", "S007 1:11+1 the word n"),
            ("&a=1+SIN(1)+q", "S007 1:13+1 the word q"),
        ] {
            finds(text, &[finding]);
        }
        for (text, tree) in [
            ("&a = Tom * Jerry", "&A = 'Tom * Jerry'"),
            ("&a = 2-ply", "&A = '2-ply'"),
            ("&a = w/o tabs", "&A = 'w/o tabs'"),
            ("&a = A & &n", "&A = ('A' & &N)"),
        ] {
            check(text, tree);
        }
    }

    #[test]
    fn names_are_letters_digits_and_underscores() {
        for (text, finding) in [
            ("&a\\b=1", "S011 1:3+1 character not allowed in a variable name: '\\'"),
            ("&a*b=1", "S011 1:3+1"),
            ("&a:b=1", "S011 1:3+1"),
            ("&a b = 1", "S011 1:3+1"),
            ("&=1", "S011 1:2+1"),
            (
                "&tool[3] = 1",
                "S011 1:6+1 character not allowed in a variable name: '[' [arrays and objects",
            ),
            ("&a 5", "S004 1:1+2 = expected behind a variable"),
            ("&ZSAFE_TEMP", "W003 1:1+11 a variable alone on its line does nothing [an assignment"),
            ("$a  'kept", "W003 1:1+2 a variable alone"),
        ] {
            finds(text, &[finding]);
        }
        check("&Z_depth=1⏎&5AX=2⏎&z_DEPTH=3", "&Z_DEPTH = 3");
    }
}
