//! Expressions: precedence climbing over the bytes of the line.

use super::line::{Failed, Line, Read, is_name};
use super::moves::number;
use super::{ends, members};
use crate::syntax::expr::{BinaryOp, Expr, ExprNode, Function, UnaryOp};
use crate::syntax::tree::Span;
use kerf_diag::Code;

/// Operators in one expression; a bound for memory and for whoever walks the tree.
const MOST_OPERATORS: u32 = 500;
/// Parentheses, signs and functions within each other.
const MOST_DEPTH: u32 = 64;

/// Binding strength of the two prefix operators.
const SIGN: u8 = 9;
const NOT: u8 = 3;

/// Words that end bare words.
const STOPS: [&str; 8] = ["AND", "OR", "MOD", "NOT", "THEN", "GOTO", "GOSUB", "FOR"];

fn is_stop(word: &str) -> bool {
    STOPS.iter().any(|stop| stop.eq_ignore_ascii_case(word))
}

/// Piece between two operands.
enum Infix {
    Operator(BinaryOp, usize),
    /// A variable right behind a value: the join operator was left out.
    Adjacent,
    None,
}

/// An expression that fills a whole field.
pub(super) fn whole_expression(l: &mut Line<'_, '_>, span: Span) -> Read<Expr> {
    l.within(span, |line| {
        let expr = expression(line)?;
        ends::expect_end(line)?;
        Ok(expr)
    })
}

/// The longest expression at the cursor.
pub(super) fn expression(l: &mut Line<'_, '_>) -> Read<Expr> {
    bounded(l, 0, true)
}

/// An expression that ends where a variable follows without an operator (INPUT).
pub(super) fn prompt_expression(l: &mut Line<'_, '_>) -> Read<Expr> {
    bounded(l, 0, false)
}

/// An expression without comparisons and logic, for places where `=` ends it.
fn bounded(l: &mut Line<'_, '_>, min: u8, join_adjacent: bool) -> Read<Expr> {
    begin_expression(l);
    binary(l, min, join_adjacent)
}

/// Sets the bounds of an expression.
pub(super) fn begin_expression(l: &mut Line<'_, '_>) {
    l.operators_left = MOST_OPERATORS;
    l.depth_left = MOST_DEPTH;
    l.words = false;
}

/// An expression inside another one, which shares its bounds.
pub(super) fn inner_expression(l: &mut Line<'_, '_>) -> Read<Expr> {
    binary(l, 0, true)
}

fn binary(l: &mut Line<'_, '_>, min: u8, adjacent: bool) -> Read<Expr> {
    let mut left = operand(l, adjacent)?;
    loop {
        l.skip_blanks();
        let (op, length) = match infix(l) {
            Infix::Operator(op, length) => (op, length),
            Infix::Adjacent if adjacent => (BinaryOp::Join, 0),
            Infix::Adjacent | Infix::None => return Ok(left),
        };
        if op.precedence() < min {
            return Ok(left);
        }
        let span = operator(l, op, length)?;
        l.at += length;
        l.skip_blanks();
        if l.at_end() || matches!(l.peek(), b',' | b')' | b';') {
            let message = format!("a value is missing after {}", op.symbol());
            return Err(l.fault(Code::BadExpression, span, message, ""));
        }
        let right = binary(l, op.precedence() + 1, adjacent)?;
        let span = Span { start: left.span.start, end: right.span.end };
        let node = join(l, op, left, right);
        left = Expr { node, span };
    }
}

/// Two operands with an operator between them.
pub(super) fn join(l: &mut Line<'_, '_>, op: BinaryOp, left: Expr, right: Expr) -> ExprNode {
    let operands = &mut l.file.program.expressions;
    ExprNode::Binary(op, operands.add(left), operands.add(right))
}

/// A text as an expression.
pub(super) fn text_at(l: &mut Line<'_, '_>, text: &str, span: Span) -> Expr {
    Expr { node: ExprNode::Text(l.file.program.expressions.add_text(text)), span }
}

/// Counts an operator and tells of doubtful spellings.
fn operator(l: &mut Line<'_, '_>, op: BinaryOp, length: usize) -> Read<Span> {
    let (start, end) = (l.at, l.at + length);
    let span = Span { start: start as u32, end: end as u32 };
    l.operators_left = l.operators_left.saturating_sub(1);
    if l.operators_left == 0 {
        let hint = "work it out in steps, with variables";
        return Err(l.fault(Code::BadExpression, span, "the expression is too long", hint));
    }
    let written = l.slice(start, end);
    if matches!(written, "=>" | "=<" | "==" | "!=") {
        let message = format!("{written} is read as {}", op.symbol());
        l.warn(Code::DoubtfulSpelling, span, message, format!("write {}", op.symbol()));
    } else if length == 0 {
        let message = "an & to join is missing before this variable";
        l.warn(Code::DoubtfulSpelling, span, message, "write \"text\" & &name");
    }
    Ok(span)
}

fn infix(l: &Line<'_, '_>) -> Infix {
    use BinaryOp::*;
    let (op, length) = match (l.peek(), l.byte(l.at + 1)) {
        (b'+', _) => (Add, 1),
        (b'-', _) => (Subtract, 1),
        (b'*', _) => (Multiply, 1),
        (b'/', _) => (Divide, 1),
        (b'\\', _) => (IntegerDivide, 1),
        (b'^', _) => (Power, 1),
        (b'<', b'>') | (b'!', b'=') => (NotEqual, 2),
        (b'<', b'=') | (b'=', b'<') => (LessEqual, 2),
        (b'>', b'=') | (b'=', b'>') => (GreaterEqual, 2),
        (b'=', b'=') => (Equal, 2),
        (b'<', _) => (Less, 1),
        (b'>', _) => (Greater, 1),
        (b'=', _) => (Equal, 1),
        (b'&', next) if is_name(next) => return Infix::Adjacent,
        (b'&', _) => (Join, 1),
        (first, _) if first.is_ascii_alphabetic() => return word_operator(l),
        _ => return Infix::None,
    };
    Infix::Operator(op, length)
}

fn word_operator(l: &Line<'_, '_>) -> Infix {
    let word = l.slice(l.at, l.word_end(l.at));
    let found = [BinaryOp::And, BinaryOp::Or, BinaryOp::Modulo]
        .into_iter()
        .find(|op| op.symbol().eq_ignore_ascii_case(word));
    found.map_or(Infix::None, |op| Infix::Operator(op, word.len()))
}

/// A value with its signs.
fn operand(l: &mut Line<'_, '_>, adjacent: bool) -> Read<Expr> {
    l.skip_blanks();
    let start = l.at;
    let prefix = match l.peek() {
        b'-' => Some((UnaryOp::Minus, SIGN, 1)),
        b'+' => Some((UnaryOp::Plus, SIGN, 1)),
        b'N' | b'n' if l.slice(start, l.word_end(start)).eq_ignore_ascii_case("NOT") => {
            Some((UnaryOp::Not, NOT, 3))
        }
        _ => None,
    };
    let Some((op, binds, length)) = prefix else { return primary(l, adjacent) };
    l.at += length;
    let operand = deeper(l, start, |line| binary(line, binds, adjacent))?;
    let span = Span { start: start as u32, end: operand.span.end };
    let node = match (op, operand.node) {
        (UnaryOp::Minus, ExprNode::Number(n)) => ExprNode::Number(-n),
        (UnaryOp::Plus, ExprNode::Number(n)) => ExprNode::Number(n),
        (_, node) => ExprNode::Unary(op, l.file.program.expressions.add(Expr { node, ..operand })),
    };
    Ok(Expr { node, span })
}

/// Goes one level down, within bounds.
fn deeper<T>(
    l: &mut Line<'_, '_>,
    start: usize,
    read: impl FnOnce(&mut Line<'_, '_>) -> Read<T>,
) -> Read<T> {
    if l.depth_left == 0 {
        let span = Span { start: start as u32, end: start as u32 + 1 };
        let hint = "work it out in steps, with variables";
        return Err(l.fault(Code::BadExpression, span, "nested too deep", hint));
    }
    l.depth_left -= 1;
    let result = read(l);
    l.depth_left += 1;
    result
}

fn primary(l: &mut Line<'_, '_>, adjacent: bool) -> Read<Expr> {
    let start = l.at;
    let node = match l.peek() {
        b'0'..=b'9' | b'.' => literal(l)?,
        b'"' => quoted(l)?,
        b'&' | b'$' if is_name(l.byte(start + 1)) => variable(l, start)?,
        b'%' => {
            l.at += 1;
            if !l.take(b'(') {
                let span = l.span_from(start);
                let hint = "a system variable is written %(n)";
                return Err(l.fault(Code::BadExpression, span, "( expected after %", hint));
            }
            let index = parenthesised(l, start, adjacent)?;
            ExprNode::System(l.file.program.expressions.add(index))
        }
        b'(' => {
            l.at += 1;
            let inner = parenthesised(l, start, adjacent)?;
            return Ok(Expr { node: inner.node, span: l.span_from(start) });
        }
        first if is_name(first) => return word(l, start, adjacent),
        _ => return Err(no_value(l)),
    };
    Ok(Expr { node, span: l.span_from(start) })
}

/// A variable, or a part of an array or object.
fn variable(l: &mut Line<'_, '_>, start: usize) -> Read<ExprNode> {
    let end = l.word_end(start + 1);
    l.at = end;
    if members::at_member(l, start) {
        let path = members::path(l, start)?;
        return Ok(ExprNode::Member(l.file.program.expressions.add_path(path)));
    }
    let name = l.name(start + 1, end);
    Ok(match l.byte(start) {
        b'$' => ExprNode::Persistent(name),
        _ => ExprNode::Variable(name),
    })
}

fn no_value(l: &mut Line<'_, '_>) -> Failed {
    let span = l.span_to_end();
    let Some(found) = l.slice(l.at, l.end).chars().next() else {
        return l.fault(Code::BadExpression, span, "a value is expected", "");
    };
    let span = Span { start: span.start, end: span.start + found.len_utf8() as u32 };
    let hint = match found {
        '[' => "values stand in ( ); in G-code a condition stands in an O-word: O1 if [#1 EQ 1]",
        '/' => "a comment begins with an apostrophe",
        '*' => "a power is written 2 ^ 3",
        _ => "",
    };
    l.fault(Code::BadExpression, span, format!("a value is expected, not {found}"), hint)
}

/// Reads what stands up to the closing parenthesis; the opening one is behind us.
fn parenthesised(l: &mut Line<'_, '_>, start: usize, adjacent: bool) -> Read<Expr> {
    let inner = deeper(l, start, |line| binary(line, 0, adjacent))?;
    if l.take(b')') {
        return Ok(inner);
    }
    if !l.at_end() && l.peek() != b',' && !at_stop(l) {
        ends::expect_end(l)?;
    }
    let span = l.span_from(start);
    Err(l.fault(Code::UnclosedParenthesis, span, "a ) is missing", ""))
}

fn literal(l: &mut Line<'_, '_>) -> Read<ExprNode> {
    let start = l.at;
    let bytes = &l.text.as_bytes()[..l.end];
    if let Some(n) = number(bytes, &mut l.at)
        && l.peek() != b'.'
        && (!is_name(l.peek()) || at_stop(l))
    {
        return Ok(ExprNode::Number(n));
    }
    l.at = start;
    while is_name(l.peek()) || l.peek() == b'.' {
        l.at += 1;
    }
    let span = l.span_from(start);
    let message = format!("{} is not a number", l.slice(start, l.at));
    Err(l.fault(Code::BadExpression, span, message, ""))
}

/// Text in quotes.
fn quoted(l: &mut Line<'_, '_>) -> Read<ExprNode> {
    let start = l.at;
    let bytes = &l.text.as_bytes()[start + 1..l.end];
    let Some(length) = memchr::memchr(b'"', bytes) else {
        let span = l.span_to_end();
        let hint = "text begins and ends with a double quote on the same line";
        return Err(l.fault(Code::UnclosedQuote, span, "a quote is not closed", hint));
    };
    l.at = start + length + 2;
    let text = l.slice(start + 1, start + 1 + length);
    Ok(ExprNode::Text(l.file.program.expressions.add_text(text)))
}

/// A function, or bare words as text.
fn word(l: &mut Line<'_, '_>, start: usize, adjacent: bool) -> Read<Expr> {
    l.at = l.word_end(start);
    let word = l.slice(start, l.at);
    if is_stop(word) {
        let span = l.span_from(start);
        let message = format!("a value is expected, not {}", word.to_uppercase());
        l.at = start;
        return Err(l.fault(Code::BadExpression, span, message, ""));
    }
    let function = Function::from_name(word);
    l.skip_blanks();
    if l.peek() == b'(' {
        let Some(function) = function.filter(|function| *function != Function::Pi) else {
            return Err(unknown_function(l, start));
        };
        l.at += 1;
        let argument = parenthesised(l, start, adjacent)?;
        let argument = Some(l.file.program.expressions.add(argument));
        let node = ExprNode::Call(function, argument);
        return Ok(Expr { node, span: l.span_from(start) });
    }
    if let Some(constant @ (Function::Rnd | Function::Pi)) = function {
        let node = ExprNode::Call(constant, None);
        return Ok(Expr { node, span: l.span_from(start) });
    }
    while more_words(l) {
        l.at = l.word_end(l.at + 1);
        l.skip_blanks();
    }
    l.words = true;
    let span = l.span_from(start);
    let text = l.slice(start, span.end as usize);
    Ok(Expr { node: ExprNode::Word(l.file.program.expressions.add_text(text)), span })
}

/// Returns `true` if the text goes on with another bare word.
fn more_words(l: &Line<'_, '_>) -> bool {
    if l.peek() == b'.' {
        return true;
    }
    let word = l.slice(l.at, l.word_end(l.at));
    !word.is_empty() && !is_stop(word)
}

/// Returns `true` if the next word ends expressions.
fn at_stop(l: &Line<'_, '_>) -> bool {
    is_stop(l.slice(l.at, l.word_end(l.at)))
}

fn unknown_function(l: &mut Line<'_, '_>, start: usize) -> Failed {
    let end = l.word_end(start);
    let word = l.slice(start, end);
    let span = Span { start: start as u32, end: end as u32 };
    let message = format!("unknown function {}", word.to_uppercase());
    let names = Function::ALL.iter().map(|f| f.name());
    let hint = kerf_diag::did_you_mean(word, names)
        .unwrap_or_else(|| "see kerf explain S008 for the list".into());
    l.fault(Code::UnknownFunction, span, message, hint)
}

#[cfg(test)]
mod tests {
    use super::super::shown::{check, finds};

    #[test]
    fn precedence_is_that_of_basic() {
        for (text, tree) in [
            ("2+3*4^2/8-1", "((2 + ((3 * (4 ^ 2)) / 8)) - 1)"),
            ("-2^2", "(-(2 ^ 2))"),
            ("2^-3", "(2 ^ -3)"),
            ("10-3-2", "((10 - 3) - 2)"),
            ("8/4/2", "((8 / 4) / 2)"),
            ("7\\2", "(7 \\ 2)"),
            ("2*7\\2 MOD 3+1", "((((2 * 7) \\ 2) MOD 3) + 1)"),
            ("-&a*2", "((-&A) * 2)"),
            ("(2+3)*4", "((2 + 3) * 4)"),
            ("NOT 1=2 AND 3>2 OR 0", "(((NOT (1 = 2)) AND (3 > 2)) OR 0)"),
            ("1+1=2", "((1 + 1) = 2)"),
            ("\"x\" & 1+1 = &b", "((\"x\" & (1 + 1)) = &B)"),
            ("1<2", "(1 < 2)"),
            ("1<=2", "(1 <= 2)"),
            ("1>=2", "(1 >= 2)"),
            ("1<>2", "(1 <> 2)"),
            ("- -3", "3"),
            ("+&a", "(+&A)"),
        ] {
            check(&format!("&x = {text}"), &format!("&X = {tree}"));
        }
    }

    #[test]
    fn values_have_many_spellings() {
        for (text, tree) in [
            ("MX,.5+5.", "MX (0.5 + 5)"),
            ("MX,1.5e-1*&a", "MX (0.15 * &A)"),
            ("MX,&5AX_gauge", "MX &5AX_GAUGE"),
            ("MX,$Zup", "MX $ZUP"),
            ("MX,%(2)+1", "MX (%2 + 1)"),
            ("MX,%( 50 + &p )", "MX %(50 + &P)"),
            ("MX,sqr(4)*Atn(1)", "MX (SQR[4] * ATN[1])"),
            ("MX,RND*2", "MX (RND[] * 2)"),
            ("MX,RND(1)", "MX RND[1]"),
            ("MX,2*pi", "MX (2 * PI[])"),
            ("MX,ACOS(0)+ceil(&a)", "MX (ACOS[0] + CEIL[&A])"),
            ("MX,\"abc\"", "MX \"abc\""),
            ("MX,abc", "MX 'abc'"),
            ("MX,12+11/16", "MX (12 + (11 / 16))"),
            ("M2, 2*3, (1+2)/4", "M2 (2 * 3) ((1 + 2) / 4)"),
            ("MZ,-2-7/32", "MZ (-2 - (7 / 32))"),
            ("MZ,-(2+7/32)", "MZ (-(2 + (7 / 32)))"),
            (
                "MX,1e300*1",
                "MX (1000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000 * 1)",
            ),
        ] {
            check(text, tree);
        }
    }

    #[test]
    fn an_ampersand_joins_or_begins_a_variable() {
        for (text, tree) in [
            ("&a & &b", "(&A & &B)"),
            ("\"x\" & &b", "(\"x\" & &B)"),
            ("\"x\"&&b", "(\"x\" & &B)"),
            ("&a&\"x\"", "(&A & \"x\")"),
            ("\"X=\" & %(1)", "(\"X=\" & %1)"),
            ("\"Hole \" & &n & \" of 4\"", "((\"Hole \" & &N) & \" of 4\")"),
        ] {
            check(&format!("&s = {text}"), &format!("&S = {tree}"));
        }
        check("&s = \"x\" &b", "&S = (\"x\" & &B)");
        finds("&s = \"x\" &b", &["W003 1:10+0 an & to join is missing"]);
    }

    #[test]
    fn bare_words_are_text() {
        check("IF &m = Material Surface THEN RETURN", "if (&M = 'Material Surface') then return");
        check(
            "IF &f = part.sbp AND &b = no THEN END",
            "if ((&F = 'part.sbp') AND (&B = 'no')) then end",
        );
    }

    #[test]
    fn doubtful_spellings_warn() {
        for (op, meant) in [("=>", ">="), ("=<", "<="), ("==", "="), ("!=", "<>")] {
            let line = format!("IF &a {op} 1 THEN END");
            check(&line, &format!("if (&A {meant} 1) then end"));
            finds(&line, &[&format!("W003 1:7+2 {op} is read as {meant} [write {meant}]")]);
        }
    }

    #[test]
    fn mistakes_are_pointed_at() {
        for (text, finding) in [
            ("MX,3*", "S007 1:5+1 a value is missing after *"),
            ("MX,1 // up", "S007 1:7+1 a value is expected, not / [a comment begins"),
            ("MX,2**3", "S007 1:6+1 a value is expected, not * [a power is written 2 ^ 3]"),
            ("IF [#1 EQ 1] GOTO X", "S007 1:4+1 a value is expected, not [ [values stand in ( )"),
            ("MX,(1+2", "S006 1:4+4 a ) is missing"),
            ("MX,%(1", "S006 1:4+3 a ) is missing"),
            ("MX,%1", "S007 1:4+1 ( expected after %"),
            ("MX,1)", "S004 1:5+1 ')' does not belong here"),
            ("MX,1 2", "S004 1:6+1 '2' does not belong here [values are separated by commas]"),
            ("MX,*2", "S007 1:4+1 a value is expected, not *"),
            ("MX,(", "S007 1:5+0 a value is expected"),
            ("MX,\"abc", "S005 1:4+4 a quote is not closed"),
            ("MX,1.2.3", "S007 1:4+5 1.2.3 is not a number"),
            ("MX,12ab", "S007 1:4+4 12ab is not a number"),
            ("MX,1e999", "S007 1:4+5 1e999 is not a number"),
            ("MX,SQTR(4)", "S008 1:4+4 unknown function SQTR [did you mean SQR?]"),
            ("MX,FROB(4)", "S008 1:4+4 unknown function FROB"),
            ("MX,$tools[3].x", "S007 1:4+11 arrays and objects"),
            ("&z = $tools[3].x", "S007 1:6+11 arrays and objects"),
            ("&é = (1", "W003 1:6+2 this is no expression"),
        ] {
            finds(text, &[finding]);
        }
    }

    #[test]
    fn every_argument_tells_its_mistake() {
        finds("M3,1*,2,(3", &["S007 1:5+1", "S006 1:9+2"]);
    }

    #[test]
    fn size_and_depth_are_bounded() {
        let deep = format!("MX,{}1{}", "(".repeat(100_000), ")".repeat(100_000));
        finds(&deep, &["S007 1:68+1 nested too deep"]);
        let signs = format!("MX,{}1", "-".repeat(100_000));
        finds(&signs, &["nested too deep"]);
        let long = format!("MX,1{}", "+1".repeat(400_000));
        finds(&long, &["the expression is too long"]);
        check(&format!("MX,{}&a{}", "(".repeat(60), ")".repeat(60)), "MX &A");
    }
}
