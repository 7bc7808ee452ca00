//! The syntax of FabMo's dialect alone: DIALOG, PAUSE with a text, FAIL, DATA_SEND.
//!
//! Its commands (probes, SU, other orders of VA and VS) are entries of
//! [`table::fabmo`](crate::syntax::table::fabmo).

use super::line::{Line, Read};
use super::text::blank;
use super::{ends, expression, members};
use crate::syntax::expr::{Expr, ExprNode};
use crate::syntax::tree::{Dialog, NameId, Span, Statement};
use kerf_diag::Code;

/// The statements of the dialect; the cursor stands behind the word.
pub(super) fn fabmo(l: &mut Line<'_, '_>, word: &str, start: usize) -> Option<Read<Statement>> {
    if !members::is_fabmo(l) {
        return None;
    }
    let is = |name: &str| word.eq_ignore_ascii_case(name);
    if is("DIALOG") {
        l.take(b',');
        return Some(dialog(l, start));
    }
    if is("FAIL") {
        return Some(fail_statement(l));
    }
    let request = is("DATA_REQUEST");
    (request || is("DATA_SEND")).then(|| data(l, request))
}

fn fail_statement(l: &mut Line<'_, '_>) -> Read<Statement> {
    l.take(b',');
    l.skip_blanks();
    let text = if l.at_end() { None } else { Some(expression::expression(l)?) };
    ends::expect_end(l)?;
    Ok(Statement::Fail(text))
}

fn data(l: &mut Line<'_, '_>, request: bool) -> Read<Statement> {
    l.take(b',');
    let mut items = Vec::new();
    l.skip_blanks();
    while !l.at_end() {
        let field = l.field();
        l.at += 1;
        if field.start < field.end {
            items.push(expression::whole_expression(l, field)?);
        }
    }
    Ok(Statement::Data { request, items })
}

/// `DIALOG "text", &variable, TITLE="…", OKTEXT="…"`; the cursor stands before the text.
pub(super) fn dialog(l: &mut Line<'_, '_>, start: usize) -> Read<Statement> {
    let text = expression::prompt_expression(l)?;
    let span = l.span_from(start);
    let mut dialog = Dialog {
        text,
        variable: None,
        title: None,
        detail: None,
        ok: None,
        cancel: None,
        seconds: None,
        span,
    };
    l.take(b',');
    l.skip_blanks();
    while !l.at_end() {
        let field = l.field();
        l.at += 1;
        if field.start < field.end {
            dialog_field(l, field, &mut dialog)?;
        }
    }
    dialog.span = Span { start: start as u32, end: l.end as u32 };
    Ok(Statement::Dialog(Box::new(dialog)))
}

/// `&variable` or `NAME = value`.
fn dialog_field(l: &mut Line<'_, '_>, field: Span, dialog: &mut Dialog) -> Read<()> {
    let written = l.slice(field.start as usize, field.end as usize);
    let Some((name, value)) = written.split_once('=') else {
        dialog.variable = Some(answer_variable(l, written, field)?);
        return Ok(());
    };
    let value_span = Span { start: field.end - value.len() as u32, end: field.end };
    let name = name.trim_matches(blank).to_uppercase();
    if name == "INPUT" {
        let variable = value.trim_matches(|c| c == '"' || blank(c));
        dialog.variable = Some(answer_variable(l, variable, value_span)?);
        return Ok(());
    }
    let place = match name.as_str() {
        "TITLE" => &mut dialog.title,
        "DETAIL" => &mut dialog.detail,
        "OKTEXT" => &mut dialog.ok,
        "CANCELTEXT" => &mut dialog.cancel,
        "TIMER" => &mut dialog.seconds,
        _ => {
            let message = format!("{name} of a dialog is not carried out here");
            let hint = "TITLE, DETAIL, OKTEXT, CANCELTEXT, INPUT and TIMER are";
            return Err(l.fault(Code::Syntax, field, message, hint));
        }
    };
    *place = Some(expression::whole_expression(l, value_span)?);
    Ok(())
}

fn answer_variable(l: &mut Line<'_, '_>, written: &str, span: Span) -> Read<NameId> {
    let name = written
        .strip_prefix('&')
        .filter(|name| !name.is_empty() && name.bytes().all(super::line::is_name));
    let Some(name) = name else {
        let message = format!("a variable or NAME=value is expected, not '{written}'");
        return Err(l.fault(Code::Syntax, span, message, ""));
    };
    Ok(l.file.name_id(name))
}

/// Returns `true` if the value of PAUSE makes it a dialog of the dialect.
pub(super) fn is_dialog_text(l: &Line<'_, '_>, value: &Expr) -> bool {
    members::is_fabmo(l)
        && l.file.program.expressions.any(value, &|node| matches!(node, ExprNode::Text(_)))
}

#[cfg(test)]
mod tests {
    use super::super::shown::{check_as, finds};
    use crate::syntax::Dialect::Fabmo;

    #[test]
    fn arrays_and_objects() {
        for (text, tree) in [
            ("&a[1] = 2", "&A[1] = 2"),
            ("$ATC.ToolIn = &tool", "$ATC.TOOLIN = &TOOL"),
            ("$t[&i+1][].x := 5", "$T[(&I + 1)][].X := 5"),
            ("&x = -1*($t[$ATC.In][&u].H + 2)", "&X = (-1 * ($T[$ATC.IN][&U].H + 2))"),
            ("JZ, $safeUU[%(25)].z + 1", "JZ ($SAFEUU[%25].Z + 1)"),
        ] {
            check_as(Fabmo, text, tree);
        }
        finds("&x = $t[1].x", &["--dialect fabmo"]);
        finds("&t[1] = 2", &["--dialect fabmo"]);
    }

    #[test]
    fn dialogs() {
        for (text, tree) in [
            ("PAUSE \"Click OK\"", "dialog \"Click OK\""),
            ("PAUSE 2", "pause 2"),
            ("PAUSE \"Tool?\", &tool", "dialog \"Tool?\" &TOOL"),
            ("PAUSE \"Tool?\" &tool", "dialog \"Tool?\" &TOOL"),
            (
                "DIALOG \"a\" + &b, OKTEXT=\"Yes, go\", CANCELTEXT = \"Quit\"",
                "dialog (\"a\" + &B) ok \"Yes, go\" cancel \"Quit\"",
            ),
            ("FAIL \"stuck\"", "fail \"stuck\""),
            ("FAIL", "fail _"),
            ("DATA_SEND, \"point\", %(1)", "data send \"point\" %1"),
        ] {
            check_as(Fabmo, text, tree);
        }
        finds("DIALOG \"x\"", &["--dialect fabmo"]);
        finds("PAUSE \"x\"", &["--dialect fabmo"]);
        finds("PZ,-1,2,3", &["--dialect fabmo"]);
    }
}
