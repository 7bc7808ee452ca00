//! Statements that speak to the operator and to other programs.

use super::keywords::Keyword;
use super::line::{Line, Read, is_name};
use super::{ends, expression, files};
use crate::syntax::expr::{BinaryOp, Expr, ExprNode};
use crate::syntax::tree::{DialogText, Input, MsgBox, Registry, Shell, Span, Statement, TextPart};
use kerf_diag::Code;

/// INPUT text ; : &default, &variables (readings, A-36).
pub(super) fn input(l: &mut Line<'_, '_>, start: usize) -> Read<Statement> {
    if l.take(b'#') {
        return files::input_file(l, start);
    }
    l.take(b',');
    l.skip_blanks();
    let plain = l.peek() == b'&' && !has_join(l);
    let text = if plain || matches!(l.peek(), b';' | b':' | 0) {
        None
    } else {
        let text = expression::prompt_expression(l)?;
        warn_commas(l, &text);
        Some(text)
    };
    let separated = l.take(b';');
    let with_default = l.take(b':');
    let default = if with_default {
        l.skip_blanks();
        let from = l.at;
        l.at = l.word_end(from + 1).max(from);
        let span = l.span_from(from);
        Some(expression::whole_expression(l, span)?)
    } else {
        None
    };
    if !separated && !with_default {
        l.take(b',');
    }
    let variables = files::variable_list(l, start, 10)?;
    let span = l.span_from(start);
    Ok(Statement::Input(Box::new(Input { text, default, variables, span })))
}

/// Returns `true` if a `;` or `:` says that the variables before it belong to the text.
fn has_join(l: &Line<'_, '_>) -> bool {
    l.until(l.at, b';') < l.end || l.until(l.at, b':') < l.end
}

fn warn_commas(l: &mut Line<'_, '_>, text: &Expr) {
    let texts = &l.file.program.expressions;
    let commas = |node: &ExprNode| matches!(node, ExprNode::Text(t) if texts[*t].contains(','));
    if l.file.program.expressions.any(text, &commas) {
        let hint = "old software cut the text at its first comma";
        let message = "a comma in the message of INPUT";
        l.warn(Code::DoubtfulSpelling, text.span, message, hint);
    }
}

/// MSGBOX(body, style, title); the list ends at the last parenthesis.
pub(super) fn msgbox(l: &mut Line<'_, '_>, start: usize) -> Read<Statement> {
    let span = Span { start: start as u32, end: l.end as u32 };
    if !l.take(b'(') {
        let hint = "write MSGBOX(text, YesNo, title)";
        return Err(l.fault(Code::Syntax, span, "( expected after MSGBOX", hint));
    }
    if l.byte(l.end - 1) == b')' && l.end > l.at {
        l.end -= 1;
    } else {
        let hint = match l.text[l.end..].contains(')') {
            true => "an apostrophe begins a comment; put the text in quotes",
            false => "close it with )",
        };
        l.warn(Code::DoubtfulSpelling, span, "the ) of MSGBOX is missing", hint);
    }
    let [body, style, title] = [next_field(l), next_field(l), next_field(l)];
    let more = next_field(l);
    if more.start < more.end {
        let hint = "text and title cannot hold commas";
        l.warn(Code::DoubtfulSpelling, more, "MSGBOX takes three values", hint);
    }
    l.at = l.end;
    let body = dialog_text(l, body);
    let title = dialog_text(l, title);
    let style = style_text(l, style);
    Ok(Statement::MsgBox(Box::new(MsgBox { body, style, title, span })))
}

/// The field at the cursor; the cursor goes behind its comma.
fn next_field(l: &mut Line<'_, '_>) -> Span {
    let span = l.field();
    l.at += usize::from(l.at < l.end);
    span
}

/// Text with quotes or system variables is an expression, other text holds variables.
fn dialog_text(l: &mut Line<'_, '_>, span: Span) -> DialogText {
    let text = l.slice(span.start as usize, span.end as usize);
    if text.contains('"') || text.contains("%(") {
        let mark = l.mark();
        if let Ok(expr) = expression::whole_expression(l, span) {
            return DialogText::Expr(expr);
        }
        l.forget(mark);
    }
    DialogText::Parts(text_parts(l, text))
}

/// The style of a message box: a sum of numbers, or a word.
fn style_text(l: &mut Line<'_, '_>, span: Span) -> DialogText {
    let mark = l.mark();
    if span.start < span.end
        && let Ok(expr) = expression::whole_expression(l, span)
        && !l.file.program.expressions.has_words(&expr)
    {
        return DialogText::Expr(expr);
    }
    l.forget(mark);
    DialogText::Parts(text_parts(l, l.slice(span.start as usize, span.end as usize)))
}

/// Unquoted text as it is shown: `&name` is a variable, `[&]` an ampersand (readings, A-19).
fn text_parts(l: &mut Line<'_, '_>, text: &str) -> Vec<TextPart> {
    let mut parts = Vec::new();
    let mut literal = String::new();
    let mut rest = text;
    while let Some(at) = rest.find('&') {
        if rest[..at].ends_with('[') && rest[at + 1..].starts_with(']') {
            literal.push_str(&rest[..at - 1]);
            literal.push('&');
            rest = &rest[at + 2..];
            continue;
        }
        literal.push_str(&rest[..at]);
        let name = &rest[at + 1..];
        let name = &name[..name.bytes().position(|b| !is_name(b)).unwrap_or(name.len())];
        if name.is_empty() {
            literal.push('&');
        } else {
            if !literal.is_empty() {
                parts.push(TextPart::Literal(std::mem::take(&mut literal).into()));
            }
            let id = l.file.name_id(name);
            parts.push(TextPart::Variable(id, format!("&{name}").into()));
        }
        rest = &rest[at + 1 + name.len()..];
    }
    literal.push_str(rest);
    if !literal.is_empty() {
        parts.push(TextPart::Literal(literal.into()));
    }
    parts
}

/// PLAY path.
pub(super) fn play(l: &mut Line<'_, '_>, start: usize) -> Read<Statement> {
    l.take(b',');
    let span = l.span_to_end();
    l.at = l.end;
    if span.start >= span.end {
        let whole = l.span_from(start);
        let hint = "write PLAY name.wav";
        return Err(l.fault(Code::MissingParameter, whole, "a sound is expected", hint));
    }
    Ok(Statement::Play(dialog_text(l, span)))
}

/// SHELL, line, display, ASYNC or SYNC.
pub(super) fn shell(l: &mut Line<'_, '_>, start: usize) -> Read<Statement> {
    let span = Span { start: start as u32, end: l.end as u32 };
    l.take(b',');
    let command = next_field(l);
    if command.start >= command.end {
        let hint = "write SHELL, \"program arguments\"";
        let message = "a command line is expected";
        return Err(l.fault(Code::MissingParameter, span, message, hint));
    }
    let line = shell_text(l, command)?;
    let display = next_field(l);
    let display = match display.start < display.end {
        true => Some(expression::whole_expression(l, display)?),
        false => None,
    };
    let wait = next_field(l);
    let wait = match l.slice(wait.start as usize, wait.end as usize) {
        word if word.eq_ignore_ascii_case("SYNC") => true,
        word if word.is_empty() || word.eq_ignore_ascii_case("ASYNC") => false,
        _ => {
            return Err(l.fault(Code::Syntax, wait, "SYNC or ASYNC expected", ""));
        }
    };
    ends::trailing_commas(l);
    ends::expect_end(l)?;
    Ok(Statement::Shell(Box::new(Shell { line, display, wait, span })))
}

/// The command line; variables inside its quotes are replaced too.
fn shell_text(l: &mut Line<'_, '_>, span: Span) -> Read<DialogText> {
    let text = l.slice(span.start as usize, span.end as usize);
    if !text.contains('"') {
        return Ok(DialogText::Parts(text_parts(l, text)));
    }
    let expr = expression::whole_expression(l, span)?;
    let mut parts = Vec::new();
    if joined_parts(l, &expr, &mut parts) {
        return Ok(DialogText::Parts(parts));
    }
    Ok(DialogText::Expr(expr))
}

/// Takes a join of texts and variables apart; false when it holds something else.
fn joined_parts(l: &mut Line<'_, '_>, expr: &Expr, parts: &mut Vec<TextPart>) -> bool {
    match &expr.node {
        ExprNode::Text(text) | ExprNode::Word(text) => {
            let text = l.file.program.expressions[*text].clone();
            parts.extend(text_parts(l, &text));
            true
        }
        ExprNode::Variable(name) => {
            let written = l.slice(expr.span.start as usize, expr.span.end as usize);
            parts.push(TextPart::Variable(*name, written.into()));
            true
        }
        ExprNode::Binary(BinaryOp::Join, left, right) => {
            let operands = &l.file.program.expressions;
            let (left, right) = (operands[*left], operands[*right]);
            joined_parts(l, &left, parts) && joined_parts(l, &right, parts)
        }
        _ => false,
    }
}

/// The registry statements: one argument behind a comma or a blank.
pub(super) fn registry(l: &mut Line<'_, '_>, keyword: Keyword, start: usize) -> Read<Statement> {
    use Registry::*;
    let (which, store) = match keyword {
        Keyword::SetUsrVal => (SetUsrVal, true),
        Keyword::SetUsrValClrd => (SetUsrValClrd, true),
        Keyword::SetSpindleStatus => (SetSpindleStatus, true),
        Keyword::GetUsrVal => (GetUsrVal, false),
        Keyword::GetUsrValClrd => (GetUsrValClrd, false),
        Keyword::GetSpindleStatus => (GetSpindleStatus, false),
        Keyword::GetUsrPath => (GetUsrPath, false),
        Keyword::GetAppPath => (GetAppPath, false),
        _ => (GetPartFileName, false),
    };
    l.take(b',');
    let span = Span { start: start as u32, end: l.end as u32 };
    let argument = l.span_to_end();
    if argument.start >= argument.end {
        let hint = if store { "give the value to keep" } else { "name a variable: &name" };
        let message = "an argument is missing";
        return Err(l.fault(Code::MissingParameter, span, message, hint));
    }
    if store {
        let value = dialog_text(l, argument);
        l.at = l.end;
        return Ok(Statement::Store { which, value, span });
    }
    let variable = files::variable_name(l)?;
    ends::trailing_commas(l);
    ends::expect_end(l)?;
    Ok(Statement::Fetch { which, variable, span })
}

#[cfg(test)]
mod tests {
    use super::super::shown::{check, finds};

    #[test]
    fn input_has_a_text_a_default_and_variables() {
        for (text, tree) in [
            ("INPUT \"Depth?\" &d", "input \"Depth?\" _ &D"),
            ("INPUT \"Enter X and Y\" &x, &y", "input \"Enter X and Y\" _ &X &Y"),
            ("INPUT \"Depth?\", &d", "input \"Depth?\" _ &D"),
            ("INPUT &d", "input _ _ &D"),
            ("INPUT &d,&e,", "input _ _ &D &E"),
            (
                "INPUT \"You Entered - \" & &v & \" Ok?\"; &t",
                "input ((\"You Entered - \" & &V) & \" Ok?\") _ &T",
            ),
            ("INPUT \"Value - \": &default, &new", "input \"Value - \" &DEFAULT &NEW"),
            ("INPUT \"Hole \" & &n;: &default, &new", "input (\"Hole \" & &N) &DEFAULT &NEW"),
            ("INPUT \"Hole \" & &n; : &default, &new", "input (\"Hole \" & &N) &DEFAULT &NEW"),
            ("INPUT &msg; &d", "input &MSG _ &D"),
            ("INPUT #1, &a, &b", "input #1 &A &B"),
        ] {
            check(text, tree);
        }
        for (text, finding) in [
            ("INPUT \"x\"", "S010 1:1+9 a variable is expected"),
            ("INPUT \"x\" 5", "S004 1:11+1 a variable is expected, not '5'"),
            ("INPUT \"a, b -> \" &a, &b", "W003 1:7+10 a comma in the message of INPUT"),
            ("INPUT &a &b", "S004 1:10+2"),
            (
                "INPUT \"x\" &a,&b,&c,&d,&e,&f,&g,&h,&i,&j,&k",
                "S009 1:41+2 INPUT takes at most ten variables",
            ),
        ] {
            finds(text, &[finding]);
        }
    }

    #[test]
    fn message_boxes_take_unquoted_text() {
        for (text, tree) in [
            (
                "MSGBOX ( Do you want it?, YesNo, Start?)",
                "msgbox <Do you want it?> <YesNo> <Start?>",
            ),
            ("MSGBOX(Is thickness &t mm?, 4, CHECK)", "msgbox <Is thickness {&t=T} mm?> 4 <CHECK>"),
            ("MSGBOX(&m,4+16+256,Info)", "msgbox <{&m=M}> ((4 + 16) + 256) <Info>"),
            ("MSGBOX(\"X is \" & %(1),0,Info)", "msgbox (\"X is \" & %1) 0 <Info>"),
            (
                "MSGBOX(Update Z? (Yes: No-Keep ,YesNoCancel,\"\")",
                "msgbox <Update Z? (Yes: No-Keep> <YesNoCancel> \"\"",
            ),
            ("MSGBOX(set [&]x = &x,0,t)", "msgbox <set &x = {&x=X}> 0 <t>"),
            ("MSGBOX(Tom & Jerry)", "msgbox <Tom & Jerry> <> <>"),
            ("MSGBOX (Cutting T10, 0, Punch It!", "msgbox <Cutting T10> 0 <Punch It!>"),
        ] {
            check(text, tree);
        }
        finds("MSGBOX (Cutting, 0, Punch It!", &["W003 1:1+29 the ) of MSGBOX is missing"]);
        finds(
            "MSGBOX(Don't move, 0, Stop)",
            &["[an apostrophe begins a comment; put the text in quotes]"],
        );
        finds("MSGBOX(a, b, YesNo, t)", &["W003 1:21+1 MSGBOX takes three values"]);
        finds("MSGBOX a, b", &["S004 1:1+11 ( expected after MSGBOX"]);
    }

    #[test]
    fn programs_and_sounds() {
        for (text, tree) in [
            ("SHELL, \"echo hi > out.txt\"", "shell <echo hi > out.txt> _ false"),
            (
                "Shell \"MyVars.exe [&]my_x = &my_x\"",
                "shell <MyVars.exe &my_x = {&my_x=MY_X}> _ false",
            ),
            ("SHELL, \"echo \" & &n,1,SYNC", "shell <echo {&n=N}> 1 true"),
            ("SHELL, \"echo \" & %(1), , async", "shell (\"echo \" & %1) _ false"),
            ("PLAY C:\\WINDOWS\\Media\\tada.wav", "play <C:\\WINDOWS\\Media\\tada.wav>"),
            ("PLAY \"my sound.wav\"", "play \"my sound.wav\""),
        ] {
            check(text, tree);
        }
        finds("SHELL", &["S010 1:1+5 a command line is expected"]);
        finds("SHELL, \"x\",1,LATER", &["S004 1:14+5 SYNC or ASYNC expected"]);
        finds("PLAY", &["S010 1:1+4 a sound is expected"]);
    }

    #[test]
    fn registry_values() {
        for (text, tree) in [
            ("SetUsrVal, hello", "SetUsrVal <hello>"),
            ("setusrval, &a", "SetUsrVal <{&a=A}>"),
            ("SetUsrValClrd, used", "SetUsrValClrd <used>"),
            ("SetSpindleStatus 1", "SetSpindleStatus <1>"),
            ("GetUsrVal, &v", "GetUsrVal &V"),
            ("GetUsrVal &v", "GetUsrVal &V"),
            ("GetUsrValClrd, &v", "GetUsrValClrd &V"),
            ("GetSpindleStatus, &s", "GetSpindleStatus &S"),
            ("GetUsrPath, &p", "GetUsrPath &P"),
            ("GetAppPath, &p", "GetAppPath &P"),
            ("GetPartFileName, &f", "GetPartFileName &F"),
        ] {
            check(text, tree);
        }
        finds("SetUsrVal", &["S010 1:1+9 an argument is missing"]);
        finds("GetUsrVal, v", &["S004 1:12+1 a variable is expected, not 'v'"]);
    }
}
