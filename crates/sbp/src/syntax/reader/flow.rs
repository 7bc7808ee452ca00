//! IF, jumps, ON INPUT, PAUSE and END.

use super::labels::is_label;
use super::line::{Line, Read};
use super::text::blank;
use super::{ends, expression, fabmo, members, statements};
use crate::syntax::expr::{Expr, ExprNode};
use crate::syntax::tree::{Span, Statement, Target};
use kerf_diag::Code;

pub(super) fn if_then(l: &mut Line<'_, '_>, start: usize, inner: bool) -> Read<Statement> {
    if inner {
        let span = Span { start: start as u32, end: l.end as u32 };
        let hint = "join the conditions with AND, or jump over the line";
        return Err(l.fault(Code::Syntax, span, "an IF cannot stand here", hint));
    }
    let condition = expression::expression(l);
    let then = match (&condition, l.take_word("THEN")) {
        (_, true) => true,
        (Ok(_), false) => return Err(then_expected(l)),
        // The condition is at fault; go on behind THEN to see the rest of the line.
        (Err(_), false) => seek_then(l),
    };
    if !then {
        return Err(super::line::Failed);
    }
    l.skip_blanks();
    if l.at_end() {
        let span = l.span_to_end();
        let hint = "write what to do on the same line";
        return Err(l.fault(Code::Syntax, span, "a statement is expected after THEN", hint));
    }
    let then = statements::statement(l, true)?;
    Ok(Statement::If { condition: condition?, then: Box::new(then) })
}

fn then_expected(l: &mut Line<'_, '_>) -> super::line::Failed {
    l.skip_blanks();
    let end = l.word_end(l.at).max(l.at);
    let word = l.slice(l.at, end);
    let span = Span { start: l.at as u32, end: end as u32 };
    let hint = kerf_diag::did_you_mean(word, ["THEN"].into_iter())
        .unwrap_or_else(|| "IF condition THEN statement".into());
    l.fault(Code::ThenExpected, span, "THEN expected", hint)
}

fn seek_then(l: &mut Line<'_, '_>) -> bool {
    while !l.at_end() {
        let end = l.word_end(l.at);
        if l.slice(l.at, end).eq_ignore_ascii_case("THEN") {
            l.at = end;
            return true;
        }
        let next = l.slice(l.at, l.end).chars().next().map_or(1, char::len_utf8);
        l.at = end.max(l.at + next);
    }
    false
}

/// The label of a jump.
pub(super) fn target(l: &mut Line<'_, '_>, start: usize) -> Read<Target> {
    let keyword = l.slice(start, l.at).to_uppercase();
    let mut span = l.span_to_end();
    let mut written = l.rest();
    if let Some(name) = written.strip_suffix(':') {
        let message = format!("a label is written without a colon after {keyword}");
        let hint = format!("write {keyword} {}", name.trim_end_matches(blank));
        l.warn(Code::DoubtfulSpelling, span, message, hint);
        written = name.trim_end_matches(blank);
        span.end = span.start + written.len() as u32;
    }
    l.at = l.end;
    if written.is_empty() {
        let message = format!("{keyword} needs a label");
        let whole = Span { start: start as u32, end: l.end as u32 };
        return Err(l.fault(Code::Syntax, whole, message, "name a label of this file"));
    }
    if written.split(blank).any(|w| w.eq_ignore_ascii_case("ELSE")) {
        let hint = "there is no ELSE; use a second IF";
        return Err(l.fault(Code::UnknownStatement, span, "unknown statement ELSE", hint));
    }
    if !is_label(written) {
        let message = format!("'{written}' is not the name of a label");
        let hint = "jumps go to labels: names alone on a line, ending in a colon";
        return Err(l.fault(Code::Syntax, span, message, hint));
    }
    Ok(Target { label: l.file.labels.id(written), span })
}

pub(super) fn on_input(l: &mut Line<'_, '_>, start: usize, inner: bool) -> Read<Statement> {
    let whole = Span { start: start as u32, end: l.end as u32 };
    if inner {
        let hint = "put it on a line of its own and jump over it";
        return Err(l.fault(Code::Syntax, whole, "ON INPUT cannot stand here", hint));
    }
    let found = l.take_word("INPUT") || l.take_word("INP");
    if !found || !l.take(b'(') {
        let hint = "write ON INPUT(switch, state) action";
        return Err(l.fault(Code::Syntax, whole, "INPUT( expected after ON", hint));
    }
    let (switch, state) = pair(l, whole)?;
    if !l.take(b')') {
        let span = l.span_to_end();
        let message = "a ) is missing after the state";
        return Err(l.fault(Code::UnclosedParenthesis, span, message, ""));
    }
    l.skip_blanks();
    let action = match l.at_end() {
        true => None,
        false => Some(Box::new(statements::statement(l, true)?)),
    };
    Ok(Statement::OnInput { switch, state, action })
}

/// `switch, state`.
fn pair(l: &mut Line<'_, '_>, whole: Span) -> Read<(Expr, Expr)> {
    let switch = expression::expression(l)?;
    if !l.take(b',') {
        let hint = "give the switch and its state: 1 for on, 0 for off";
        return Err(l.fault(Code::MissingParameter, whole, "the state is missing", hint));
    }
    Ok((switch, expression::expression(l)?))
}

pub(super) fn pause(l: &mut Line<'_, '_>, start: usize) -> Read<Statement> {
    let whole = Span { start: start as u32, end: l.end as u32 };
    if l.take_word("UNTIL") {
        l.take(b',');
        let (switch, state) = pair(l, whole)?;
        ends::trailing_commas(l);
        ends::expect_end(l)?;
        return Ok(Statement::PauseUntil { switch, state });
    }
    l.take(b',');
    l.skip_blanks();
    if l.at_end() {
        return Ok(Statement::Pause { seconds: None });
    }
    let from = l.at;
    let seconds = expression::expression(l)?;
    if fabmo::is_dialog_text(l, &seconds) {
        l.at = from;
        return fabmo::dialog(l, start);
    }
    if l.file.program.expressions.any(&seconds, &|node| matches!(node, ExprNode::Text(_))) {
        let hint = members::or_else("the comment line above is the message");
        let message = "PAUSE takes seconds, not text";
        return Err(l.fault(Code::Syntax, seconds.span, message, hint));
    }
    ends::trailing_commas(l);
    l.skip_blanks();
    if !l.at_end() && !ends::is_statement(l) {
        let pause = Statement::Pause { seconds: Some(seconds) };
        return Ok(ended(l, pause));
    }
    ends::expect_end(l)?;
    Ok(Statement::Pause { seconds: Some(seconds) })
}

/// END and END ALL.
pub(super) fn end_statement(l: &mut Line<'_, '_>, start: usize) -> Read<Statement> {
    if l.take_word("ALL") {
        return Ok(ended(l, Statement::EndAll));
    }
    if l.take_word("IF") {
        let span = l.span_from(start);
        let hint = "an IF ends with its line";
        return Err(l.fault(Code::UnknownStatement, span, "unknown statement END IF", hint));
    }
    Ok(ended(l, Statement::End))
}

/// A statement behind which the rest of the line means nothing.
pub(super) fn ended(l: &mut Line<'_, '_>, statement: Statement) -> Statement {
    l.skip_blanks();
    if !l.at_end() {
        let span = l.span_to_end();
        let hint = "make it a comment with an apostrophe";
        l.warn(Code::TextAfterEnd, span, "the rest of the line is ignored", hint);
        l.at = l.end;
    }
    statement
}

#[cfg(test)]
mod tests {
    use super::super::shown::{check, finds};

    #[test]
    fn conditions_and_actions() {
        for (text, tree) in [
            ("IF &c > 2 THEN MX,1", "if (&C > 2) then MX 1"),
            ("IF(&a=1)THEN MX,1", "if (&A = 1) then MX 1"),
            ("IF &a=1THEN MX,1", "if (&A = 1) then MX 1"),
            ("if &zup = \"\" then &zup = 0", "if (&ZUP = \"\") then &ZUP = 0"),
            ("IF %(51)=1 THEN PAUSE 3", "if (%51 = 1) then pause 3"),
            ("IF 1 = 1 THEN GOSUB S", "if (1 = 1) then gosub S 0"),
            ("IF NOT (&a=2) THEN RETURN", "if (NOT (&A = 2)) then return"),
            ("IF &a THEN PRINT \"x\"", "if &A then print , \"x\""),
            ("IF &a=1 THEN C#,90", "if (&A = 1) then custom 90"),
        ] {
            check(text, tree);
        }
    }

    #[test]
    fn mistakes_in_conditions() {
        for (text, findings) in [
            ("IF &a = 1 MX,1", &["S012 1:11+2 THEN expected [IF condition THEN statement]"][..]),
            ("IF %(25) = 1 THE GOTO MM", &["S012 1:14+3 THEN expected [did you mean THEN?]"]),
            ("IF &a = 1", &["S012 1:10+0 THEN expected"]),
            ("IF &a = 1 THEN", &["S004 1:15+0 a statement is expected after THEN"]),
            ("IF THEN GOTO X", &["S007 1:4+4 a value is expected, not THEN"]),
            (
                "IF &a = THEN GOTO",
                &["S007 1:9+4 a value is expected, not THEN", "S004 1:14+4 GOTO needs a label"],
            ),
            ("IF &a=1 THEN IF &b=1 THEN END", &["S004 1:14+16 an IF cannot stand here"]),
            (
                "IF &a ** 2 THEN QQ,1",
                &["S007 1:8+1 a value is expected, not *", "S002 1:17+2 unknown command QQ"],
            ),
            (
                "IF (&a=1 THEN QQ,1",
                &["S006 1:4+5 a ) is missing", "S002 1:15+2 unknown command QQ"],
            ),
        ] {
            finds(text, findings);
        }
    }

    #[test]
    fn jumps_find_their_labels() {
        check("SECOND PLUNGE: 'x⏎GOTO second  plunge", "goto SECOND PLUNGE 1");
        check("1PRS4:⏎⏎IF 1 THEN GOTO 1prs4", "if 1 then goto 1PRS4 1");
        check("GOSUB nowhere", "gosub NOWHERE 0");
        check("Out:⏎GOTO Out:", "goto OUT 1");
        finds(
            "Out:⏎GOTO Out:",
            &["W003 2:6+4 a label is written without a colon after GOTO [write GOTO Out]"],
        );
        check("A:⏎&n=1⏎A:⏎GOTO A", "goto A 1");
        finds(
            "A:⏎&n=1⏎  a: ⏎GOTO A",
            &["W001 3:3+2 label A repeated at line 3 [jumps go to line 1]"],
        );
        check("  Done :", "label DONE");
        check("END:", "label END");
        finds("GOTO", &["S004 1:1+4 GOTO needs a label"]);
        finds("IF &a THEN GOTO X ELSE GOTO Y", &["S003 1:17+13 unknown statement ELSE"]);
        finds("GOTO A,B", &["S004 1:6+3 'A,B' is not the name of a label"]);
        finds("  :", &["S004 1:3+1 a label needs a name"]);
    }

    #[test]
    fn on_input_has_two_names() {
        check("ON INPUT(3,1) GOTO Hit", "on 3 1 goto HIT 0");
        check("on inp(&t , 0)goto Hit", "on &T 0 goto HIT 0");
        check("ON INPUT (&a+1,2) MZ, %(3)-&b", "on (&A + 1) 2 MZ (%3 - &B)");
        check("ON INPUT(3,1)", "on 3 1 _");
        check("ON INPUT(3,0) RETURN", "on 3 0 return");
        for (text, finding) in [
            ("ON 3 GOTO A", "S004 1:1+11 INPUT( expected after ON"),
            ("ON INPUT(3) GOTO A", "S010 1:1+18 the state is missing"),
            ("ON INPUT(3,1 GOTO A", "S006 1:14+6 a ) is missing after the state"),
            ("ON INPUT(3,1) QQ", "S002 1:15+2 unknown command QQ"),
            ("IF 1 THEN ON INPUT(3,1)", "S004 1:11+13 ON INPUT cannot stand here"),
        ] {
            finds(text, &[finding]);
        }
    }

    #[test]
    fn pauses() {
        for (text, tree) in [
            ("PAUSE", "pause _"),
            ("PAUSE 3", "pause 3"),
            ("pause .25 'short", "pause 0.25"),
            ("PAUSE,2", "pause 2"),
            ("PAUSE &v", "pause &V"),
            ("PAUSE UNTIL 5, 1", "until 5 1"),
            ("PAUSE UNTIL &in,&state", "until &IN &STATE"),
        ] {
            check(text, tree);
        }
        finds(
            "PAUSE \"Change bit\"",
            &[
                "S004 1:7+12 PAUSE takes seconds, not text [this is FabMo's dialect: --dialect fabmo; here the comment line above is the message]",
            ],
        );
        finds("PAUSE UNTIL 5", &["S010 1:1+13 the state is missing"]);
        finds("PAUSE 1 MX,1", &["S013 1:9+4 a second command"]);
        finds("PAUSE .25   ??needed", &["W013 1:13+8"]);
        finds("PAUSE 1 2", &["W013 1:9+1 the rest of the line is ignored"]);
    }

    #[test]
    fn text_behind_an_end_is_ignored() {
        check("END of job", "end");
        finds("END of job", &["W013 1:5+6 the rest of the line is ignored"]);
        finds("RETURN now", &["W013 1:8+3"]);
        finds("END 'of job", &[]);
    }
}
