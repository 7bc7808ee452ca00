//! The syntax of FabMo's dialect alone: arrays and objects, DIALOG, PAUSE with a text, FAIL, DATA_SEND.
//!
//! Its commands (probes, SU, other orders of VA and VS) are entries of
//! [`table::fabmo`](crate::syntax::table::fabmo).

use super::line::{Line, Read};
use super::text::blank;
use crate::syntax::Dialect;
use crate::syntax::expr::{Expr, ExprNode, Path, PathStep};
use crate::syntax::tree::{Dialog, NameId, Span, Statement};
use kerf_diag::Code;

/// Hint about a file that is not in the dialect it is read in.
pub(super) const HINT: &str = "this is FabMo's dialect: --dialect fabmo";
pub(super) const ARRAYS_HINT: &str =
    "arrays and objects are FabMo's dialect: --dialect fabmo; here use plain variables";

/// Steps of one path.
const MOST_STEPS: usize = 8;

impl Line<'_, '_> {
    fn is_fabmo(&self) -> bool {
        self.file.dialect == Dialect::Fabmo
    }

    /// Returns `true` if a bracket or a dot behind the name of a variable says that it is a part of it.
    pub(super) fn at_member(&self, start: usize) -> bool {
        let dotted = self.peek() == b'.' && self.byte(self.at + 1).is_ascii_alphabetic();
        self.peek() == b'[' || dotted && (self.is_fabmo() || self.byte(start) == b'$')
    }

    /// `&name[n].field`; the cursor stands behind the name.
    pub(super) fn path(&mut self, start: usize) -> Read<Path> {
        if !self.is_fabmo() {
            self.foreign = true;
            let span = Span { start: start as u32, end: self.until(self.at, b' ') as u32 };
            let message = "arrays and objects are not part of the language";
            return Err(self.fault(Code::BadExpression, span, message, ARRAYS_HINT));
        }
        let persistent = self.byte(start) == b'$';
        let name = self.name(start + 1, self.at);
        let mut steps = Vec::new();
        while self.at_member(start) {
            if steps.len() >= MOST_STEPS {
                let span = self.span_from(start);
                return Err(self.fault(Code::BadExpression, span, "nested too deep", ""));
            }
            steps.push(self.step()?);
        }
        Ok(Path { persistent, name, steps })
    }

    fn step(&mut self) -> Read<PathStep> {
        let start = self.at;
        self.at += 1;
        if self.byte(start) == b'.' {
            self.at = self.word_end(self.at);
            return Ok(PathStep::Field(self.slice(start + 1, self.at).to_uppercase().into()));
        }
        if self.take(b']') {
            return Ok(PathStep::BothUnits);
        }
        // What stands between the brackets is an expression of its own.
        let stop = self.closing_bracket(start)?;
        let inner = Span { start: self.at as u32, end: stop as u32 };
        let left = (self.operators_left, self.depth_left);
        self.depth_left = self.depth_left.saturating_sub(1);
        if self.depth_left == 0 {
            let span = Span { start: start as u32, end: stop as u32 };
            return Err(self.fault(Code::BadExpression, span, "nested too deep", ""));
        }
        let index = self.within(inner, |line| {
            let index = line.inner_expression()?;
            line.expect_end()?;
            Ok(index)
        });
        self.operators_left = left.0.min(self.operators_left);
        self.depth_left = left.1;
        self.at = stop + 1;
        Ok(PathStep::Index(index?))
    }

    /// The bracket that belongs to the one at a place.
    fn closing_bracket(&mut self, start: usize) -> Read<usize> {
        let mut open = 0_u32;
        for at in start..self.end {
            match self.byte(at) {
                b'[' => open += 1,
                b']' if open == 1 => return Ok(at),
                b']' => open -= 1,
                _ => {}
            }
        }
        let span = Span { start: start as u32, end: self.end as u32 };
        Err(self.fault(Code::UnclosedParenthesis, span, "a ] is missing", ""))
    }

    /// `&name[n].field = value`; the cursor stands behind the name.
    pub(super) fn member_assignment(&mut self, start: usize) -> Read<Statement> {
        self.begin_expression();
        let path = self.path(start)?;
        let span = self.span_from(start);
        self.skip_blanks();
        let only_if_undefined = self.peek() == b':' && self.byte(self.at + 1) == b'=';
        self.at += usize::from(only_if_undefined);
        if !self.take(b'=') {
            let hint = "an assignment is written &name = value";
            return Err(self.fault(Code::Syntax, span, "= expected behind a variable", hint));
        }
        let value = self.assigned()?;
        let path = self.file.expressions.add_path(path);
        Ok(Statement::AssignMember { path, only_if_undefined, value, span })
    }

    /// The statements of the dialect; the cursor stands behind the word.
    pub(super) fn fabmo(&mut self, word: &str, start: usize) -> Option<Read<Statement>> {
        if !self.is_fabmo() {
            return None;
        }
        let is = |name: &str| word.eq_ignore_ascii_case(name);
        if is("DIALOG") {
            self.take(b',');
            return Some(self.dialog(start));
        }
        if is("FAIL") {
            return Some(self.fail_statement());
        }
        let request = is("DATA_REQUEST");
        (request || is("DATA_SEND")).then(|| self.data(request))
    }

    fn fail_statement(&mut self) -> Read<Statement> {
        self.take(b',');
        self.skip_blanks();
        let text = if self.at_end() { None } else { Some(self.expression()?) };
        self.expect_end()?;
        Ok(Statement::Fail(text))
    }

    fn data(&mut self, request: bool) -> Read<Statement> {
        self.take(b',');
        let mut items = Vec::new();
        self.skip_blanks();
        while !self.at_end() {
            let field = self.field();
            self.at += 1;
            if field.start < field.end {
                items.push(self.whole_expression(field)?);
            }
        }
        Ok(Statement::Data { request, items })
    }

    /// `DIALOG "text", &variable, TITLE="…", OKTEXT="…"`; the cursor stands before the text.
    pub(super) fn dialog(&mut self, start: usize) -> Read<Statement> {
        let text = self.prompt_expression()?;
        let span = self.span_from(start);
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
        self.take(b',');
        self.skip_blanks();
        while !self.at_end() {
            let field = self.field();
            self.at += 1;
            if field.start < field.end {
                self.dialog_field(field, &mut dialog)?;
            }
        }
        dialog.span = Span { start: start as u32, end: self.end as u32 };
        Ok(Statement::Dialog(Box::new(dialog)))
    }

    /// `&variable` or `NAME = value`.
    fn dialog_field(&mut self, field: Span, dialog: &mut Dialog) -> Read<()> {
        let written = self.slice(field.start as usize, field.end as usize);
        let Some((name, value)) = written.split_once('=') else {
            dialog.variable = Some(self.answer_variable(written, field)?);
            return Ok(());
        };
        let value_span = Span { start: field.end - value.len() as u32, end: field.end };
        let name = name.trim_matches(blank).to_uppercase();
        if name == "INPUT" {
            let variable = value.trim_matches(|c| c == '"' || blank(c));
            dialog.variable = Some(self.answer_variable(variable, value_span)?);
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
                return Err(self.fault(Code::Syntax, field, message, hint));
            }
        };
        *place = Some(self.whole_expression(value_span)?);
        Ok(())
    }

    fn answer_variable(&mut self, written: &str, span: Span) -> Read<NameId> {
        let name = written
            .strip_prefix('&')
            .filter(|name| !name.is_empty() && name.bytes().all(super::line::is_name));
        let Some(name) = name else {
            let message = format!("a variable or NAME=value is expected, not '{written}'");
            return Err(self.fault(Code::Syntax, span, message, ""));
        };
        Ok(self.file.name_id(name))
    }

    /// Returns `true` if the value of PAUSE makes it a dialog of the dialect.
    pub(super) fn is_dialog_text(&self, value: &Expr) -> bool {
        self.is_fabmo()
            && self.file.expressions.any(value, &|node| matches!(node, ExprNode::Text(_)))
    }
}

/// A hint that ends with what to do instead.
pub(super) fn or_else(instead: &str) -> String {
    format!("{HINT}; here {instead}")
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
