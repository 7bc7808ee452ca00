//! OPEN, CLOSE and reading from files.

use super::line::{Line, Read};
use super::{ends, expression, output};
use crate::syntax::expr::{Expr, ExprNode};
use crate::syntax::tree::{FileMode, NameId, Span, Statement};
use kerf_diag::Code;

/// INPUT asks for, or reads, at most this many values.
const MOST_VARIABLES: usize = 10;

/// OPEN path FOR mode AS #n.
pub(super) fn open(l: &mut Line<'_, '_>, start: usize) -> Read<Statement> {
    l.take(b',');
    let path = open_path(l, start)?;
    let mode = file_mode(l, start)?;
    if !l.take_word("AS") {
        return Err(open_form(l, start, "AS #n expected"));
    }
    l.take(b'#');
    let number = output::single_value(l)?;
    check_file_number(l, &number)?;
    ends::expect_end(l)?;
    Ok(Statement::Open { path, mode, number })
}

fn open_form(l: &mut Line<'_, '_>, start: usize, message: &str) -> super::line::Failed {
    let span = Span { start: start as u32, end: l.end as u32 };
    let hint = "write OPEN \"name\" FOR OUTPUT AS #1";
    l.fault(Code::Syntax, span, message, hint)
}

/// A computed path, or one written without quotes up to FOR.
fn open_path(l: &mut Line<'_, '_>, start: usize) -> Read<Expr> {
    l.skip_blanks();
    if matches!(l.peek(), b'"' | b'&' | b'$') {
        return expression::expression(l);
    }
    let from = l.at;
    let rest = l.slice(from, l.end).to_ascii_uppercase();
    let Some(length) = rest.rfind(" FOR ") else {
        return Err(open_form(l, start, "FOR expected"));
    };
    l.at = from + length;
    let span = l.span_from(from);
    let text = l.slice(from, span.end as usize);
    Ok(expression::text_at(l, text, span))
}

fn file_mode(l: &mut Line<'_, '_>, start: usize) -> Read<FileMode> {
    if !l.take_word("FOR") {
        return Err(open_form(l, start, "FOR expected"));
    }
    let modes =
        [("INPUT", FileMode::Input), ("OUTPUT", FileMode::Output), ("APPEND", FileMode::Append)];
    for (word, mode) in modes {
        if l.take_word(word) {
            return Ok(mode);
        }
    }
    Err(open_form(l, start, "INPUT, OUTPUT or APPEND expected"))
}

fn check_file_number(l: &mut Line<'_, '_>, number: &Expr) -> Read<()> {
    match number.node {
        ExprNode::Number(n) if n.fract() != 0.0 || !(1.0..=9.0).contains(&n) => {
            let message = "file numbers are 1 to 9";
            Err(l.fault(Code::FileNumber, number.span, message, "use a number from 1 to 9"))
        }
        _ => Ok(()),
    }
}

/// CLOSE, CLOSE #n.
pub(super) fn close(l: &mut Line<'_, '_>) -> Read<Statement> {
    l.take(b',');
    l.take(b'#');
    l.skip_blanks();
    if l.at_end() {
        return Ok(Statement::Close(None));
    }
    let number = output::single_value(l)?;
    check_file_number(l, &number)?;
    ends::trailing_commas(l);
    ends::expect_end(l)?;
    Ok(Statement::Close(Some(number)))
}

/// INPUT #n, &a, &b; the cursor stands behind `#`.
pub(super) fn input_file(l: &mut Line<'_, '_>, start: usize) -> Read<Statement> {
    let file = output::single_value(l)?;
    check_file_number(l, &file)?;
    if !l.take(b',') {
        l.take(b';');
    }
    let variables = variable_list(l, start, usize::MAX)?;
    Ok(Statement::InputFile { file, variables, span: l.span_from(start) })
}

/// `&a, &b …` up to the end of the code; at least one.
pub(super) fn variable_list(l: &mut Line<'_, '_>, start: usize, most: usize) -> Read<Vec<NameId>> {
    let mut names = Vec::new();
    loop {
        while l.take(b',') {}
        l.skip_blanks();
        if l.at_end() {
            break;
        }
        let from = l.at;
        let name = variable_name(l)?;
        if names.len() == most.min(MOST_VARIABLES) && most != usize::MAX {
            let span = l.span_from(from);
            let message = "INPUT takes at most ten variables";
            let hint = "use a second INPUT";
            return Err(l.fault(Code::TooManyParameters, span, message, hint));
        }
        names.push(name);
        l.skip_blanks();
        if !l.at_end() && l.peek() != b',' {
            ends::expect_end(l)?;
        }
    }
    if names.is_empty() {
        let span = l.span_from(start);
        let message = "a variable is expected";
        let hint = "name the variable that takes the value, as in INPUT \"Depth?\" &d";
        return Err(l.fault(Code::MissingParameter, span, message, hint));
    }
    Ok(names)
}

/// `&name`.
pub(super) fn variable_name(l: &mut Line<'_, '_>) -> Read<NameId> {
    l.skip_blanks();
    let start = l.at;
    let end = l.word_end(start + 1);
    if l.peek() != b'&' || end == start + 1 {
        let span = l.span_to_end();
        let found: String = l.slice(start, l.end).chars().take(20).collect();
        let message = format!("a variable is expected, not '{found}'");
        return Err(l.fault(Code::Syntax, span, message, "variables begin with &"));
    }
    l.at = end;
    Ok(l.name(start + 1, end))
}

#[cfg(test)]
mod tests {
    use super::super::shown::{check, finds};

    #[test]
    fn files_are_opened_by_number() {
        for (text, tree) in [
            ("OPEN \"myfile.sbp\" FOR OUTPUT as #1", "open \"myfile.sbp\" Output 1"),
            ("OPEN &f for input AS #2", "open &F Input 2"),
            ("OPEN &p & \"\\out.txt\" FOR APPEND AS #&n", "open (&P & \"\\out.txt\") Append &N"),
            ("OPEN my file.txt FOR OUTPUT AS 3", "open \"my file.txt\" Output 3"),
            ("CLOSE", "close _"),
            ("CLOSE #1", "close 1"),
            ("close 2", "close 2"),
            ("INPUT #1, &a, &b", "input #1 &A &B"),
        ] {
            check(text, tree);
        }
        for (text, finding) in [
            ("OPEN \"a\" FOR OUTPUT AS #10", "F007 1:25+2 file numbers are 1 to 9"),
            ("OPEN \"a\" FOR OUTPUT AS #0", "F007 1:25+1"),
            ("OPEN \"a\" FOR OUTPUT", "S004 1:1+19 AS #n expected"),
            ("OPEN \"a\" FOR READING AS #1", "S004 1:1+26 INPUT, OUTPUT or APPEND expected"),
            ("OPEN \"a\" AS #1", "S004 1:1+14 FOR expected"),
            ("OPEN a AS #1", "S004 1:1+12 FOR expected"),
            ("CLOSE #x", "S004 1:8+1 a number is expected here"),
            ("INPUT #1", "S010 1:1+8 a variable is expected"),
        ] {
            finds(text, &[finding]);
        }
    }
}
