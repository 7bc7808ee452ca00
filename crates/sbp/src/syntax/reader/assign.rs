//! Assignments: `&name = …`, `$name = …`, `&name := …`.

use super::line::{Failed, Line, Read, is_name};
use super::{expression, members};
use crate::syntax::Dialect;
use crate::syntax::expr::{BinaryOp, Expr, ExprNode, Function};
use crate::syntax::tree::{Assigned, Span, Statement};
use kerf_diag::{Code, Diagnostic};

pub(super) fn assignment(l: &mut Line<'_, '_>, persistent: bool) -> Read<Statement> {
    let start = l.at;
    let end = l.word_end(start + 1);
    l.at = end;
    if l.file.program.dialect == Dialect::Fabmo && end > start + 1 && members::at_member(l, start) {
        return member_assignment(l, start);
    }
    l.skip_blanks();
    let only_if_undefined = l.peek() == b':' && l.byte(l.at + 1) == b'=';
    l.at += usize::from(only_if_undefined);
    if end > start + 1 && l.at_end() {
        return Ok(mention(l, start));
    }
    if end == start + 1 || l.peek() != b'=' {
        return Err(bad_name(l, start, end));
    }
    l.at += 1;
    let name = l.name(start + 1, end);
    let value = assigned(l)?;
    let span = Span { start: start as u32, end: end as u32 };
    Ok(Statement::Assign { name, persistent, only_if_undefined, value, span })
}

/// A variable alone on its line: files that run on machines have it, and nothing happens there.
fn mention(l: &mut Line<'_, '_>, start: usize) -> Statement {
    let span = l.span_from(start);
    let message = "a variable alone on its line does nothing";
    l.warn(Code::DoubtfulSpelling, span, message, "an assignment is written &name = value");
    Statement::Mention(span)
}

/// Reports that what stands before `=` is no variable's name.
fn bad_name(l: &mut Line<'_, '_>, start: usize, end: usize) -> Failed {
    let equals = l.until(start, b'=');
    let name = Span { start: start as u32, end: end as u32 };
    if equals >= l.end {
        let hint = "an assignment is written &name = value";
        return l.fault(Code::Syntax, name, "= expected behind a variable", hint);
    }
    let bad = (end..equals).find(|at| !is_name(l.byte(*at))).unwrap_or(end);
    let found = l.slice(bad, equals).chars().next().unwrap_or('=');
    let span = Span { start: bad as u32, end: (bad + found.len_utf8()) as u32 };
    let hint = match found {
        '[' | '.' => members::ARRAYS_HINT,
        _ => "letters, digits and underscores are allowed",
    };
    let message = format!("character not allowed in a variable name: '{found}'");
    l.fault(Code::BadVariableName, span, message, hint)
}

/// The value: computed where all of it can be, text otherwise.
pub(super) fn assigned(l: &mut Line<'_, '_>) -> Read<Assigned> {
    let text = l.rest();
    if text.is_empty() {
        return Ok(Assigned::Nothing);
    }
    let span = l.span_to_end();
    if text.starts_with('"') && !text[1..].contains('"') {
        expression::expression(l)?;
    }
    let mark = l.mark();
    match expression::whole_expression(l, span) {
        Ok(expr) if !(l.words && is_text(l, &expr)) => {
            l.at = l.end;
            return Ok(Assigned::Expr(spelled_out(l, expr)));
        }
        Ok(expr) => refuse_words(l, &expr)?,
        Err(failed) if l.foreign || calls(l, mark) => return Err(failed),
        Err(_) => {}
    }
    l.forget(mark);
    l.at = l.end;
    // A number and then a command: a line end was forgotten.
    if looks_computed(text) || (l.second_command && !text.starts_with(char::is_alphabetic)) {
        let hint = "put text in quotes, or mend the expression";
        let message = "this is no expression and is taken as text";
        l.warn(Code::DoubtfulSpelling, span, message, hint);
    }
    Ok(Assigned::Text(text.into()))
}

/// Returns `true` if reading failed at an unknown function that was surely meant to be one: its parenthesis follows
/// at once and holds no words.
fn calls(l: &Line<'_, '_>, mark: usize) -> bool {
    let unknown = |found: &&Diagnostic| found.code == Code::UnknownFunction;
    let Some(found) = l.file.program.diagnostics[mark..].iter().find(unknown) else { return false };
    let behind = found.place.column as usize - 1 + found.place.length as usize;
    let text: String = l.slice(0, l.end).chars().skip(behind).collect();
    let Some(inside) = text.strip_prefix('(') else { return false };
    let inside = inside.rsplit_once(')').map_or(inside, |(inside, _)| inside);
    inside.split(|c: char| !(c.is_alphanumeric() || "_&$".contains(c))).all(is_computed)
}

/// Refuses a bare word within arithmetic that cannot be text: it is multiplied, or calculated with a value.
fn refuse_words(l: &mut Line<'_, '_>, expr: &Expr) -> Read<()> {
    let Some(word) = word_in_arithmetic(l, expr) else { return Ok(()) };
    let text = l.slice(word.start as usize, word.end as usize);
    let message = format!("the word {text} stands in a calculation");
    let hint = format!("write &{text} for the variable, or put text in quotes");
    Err(l.fault(Code::BadExpression, word, message, hint))
}

/// The place of such a word.
fn word_in_arithmetic(l: &Line<'_, '_>, expr: &Expr) -> Option<Span> {
    let ExprNode::Binary(op, a, b) = expr.node else { return None };
    let operands = &l.file.program.expressions;
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
    word_in_arithmetic(l, a).or_else(|| word_in_arithmetic(l, b))
}

/// True for bare words that are no part of a join or a comparison with something else.
fn is_text(l: &Line<'_, '_>, expr: &Expr) -> bool {
    let operands = &l.file.program.expressions;
    let is_word = |expr: &Expr| matches!(expr.node, ExprNode::Word(_));
    match expr.node {
        ExprNode::Word(_) => true,
        ExprNode::Binary(op, a, b) if op.precedence() <= BinaryOp::Join.precedence() => {
            let (a, b) = (&operands[a], &operands[b]);
            let (text_a, text_b) = (is_text(l, a), is_text(l, b));
            text_a && (text_b || !is_word(a)) || (text_b && !is_word(b))
        }
        _ => operands.has_words(expr),
    }
}

/// `&a = "&b"` is an old way to say: the value of b as text.
fn spelled_out(l: &mut Line<'_, '_>, expr: Expr) -> Expr {
    let ExprNode::Text(text) = &expr.node else { return expr };
    let text = l.file.program.expressions[*text].clone();
    let Some(name) = text.strip_prefix('&') else { return expr };
    if name.is_empty() || !name.bytes().all(is_name) {
        return expr;
    }
    let span = Span { start: expr.span.start + 1, end: expr.span.end - 1 };
    let id = l.file.name_id(name);
    let variable = Expr { node: ExprNode::Variable(id), span };
    let nothing = expression::text_at(l, "", span);
    let node = expression::join(l, BinaryOp::Join, variable, nothing);
    Expr { node, span: expr.span }
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

/// `&name[n].field = value`; the cursor stands behind the name.
fn member_assignment(l: &mut Line<'_, '_>, start: usize) -> Read<Statement> {
    expression::begin_expression(l);
    let path = members::path(l, start)?;
    let span = l.span_from(start);
    l.skip_blanks();
    let only_if_undefined = l.peek() == b':' && l.byte(l.at + 1) == b'=';
    l.at += usize::from(only_if_undefined);
    if !l.take(b'=') {
        let hint = "an assignment is written &name = value";
        return Err(l.fault(Code::Syntax, span, "= expected behind a variable", hint));
    }
    let value = assigned(l)?;
    let path = l.file.program.expressions.add_path(path);
    Ok(Statement::AssignMember { path, only_if_undefined, value, span })
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
