//! Statements, tidy.

use super::{push_fields, trim_end};
use crate::syntax::Program;
use crate::syntax::reader::blank;
use crate::syntax::tree::{Span, Statement};

/// The code of a statement within its line.
#[derive(Clone, Copy)]
pub(super) struct Code<'a> {
    pub(super) program: &'a Program,
    pub(super) line: &'a str,
    /// First byte of the statement.
    pub(super) start: usize,
    /// One past the last byte of code.
    pub(super) end: usize,
}

impl<'a> Code<'a> {
    pub(super) fn push(self, statement: &Statement, out: &mut String) {
        match statement {
            Statement::Command { args, .. } => {
                out.push_str(&self.word().to_uppercase());
                push_fields(self.program.args[*args].iter().map(|arg| self.slice(arg.span)), out);
            }
            Statement::Assign { .. } | Statement::AssignMember { .. } => self.push_assignment(out),
            Statement::If { condition, then } => {
                out.push_str("IF ");
                out.push_str(self.slice(condition.span));
                out.push_str(" THEN ");
                self.from(condition.span.end as usize).behind("THEN").push(then, out);
            }
            Statement::OnInput { switch, state, action } => {
                let word = self.behind("ON").word().to_uppercase();
                let (switch, state_text) = (self.slice(switch.span), self.slice(state.span));
                out.push_str(&format!("ON {word}({switch},{state_text})"));
                if let Some(action) = action {
                    out.push(' ');
                    self.from(state.span.end as usize).behind(")").push(action, out);
                }
            }
            Statement::Goto(target) | Statement::Gosub(target) => {
                self.push_words(&[self.word(), self.slice(target.span)], out);
            }
            Statement::PauseUntil { switch, state } => {
                let (switch, state) = (self.slice(switch.span), self.slice(state.span));
                out.push_str(&format!("PAUSE UNTIL {switch},{state}"));
            }
            Statement::Pause { seconds: Some(seconds) } => {
                self.push_words(&["PAUSE", self.slice(seconds.span)], out);
                self.push_behind_seconds(seconds.span.end as usize, out);
            }
            Statement::ExitShopbot | Statement::WarningOff => self.push_two_words(out),
            Statement::End | Statement::EndAll | Statement::Return | Statement::Pause { .. } => {
                self.push_end(statement, out);
            }
            Statement::Custom { number, .. } => self.push_custom(self.slice(number.span), out),
            Statement::Gcode(text) => out.push_str(text),
            Statement::Mention(span) => out.push_str(self.slice(*span)),
            _ => self.push_keyword(out),
        }
    }

    /// Appends what is ignored behind the seconds of PAUSE; behind a comma as it is written, for it may be read
    /// otherwise without.
    fn push_behind_seconds(self, end: usize, out: &mut String) {
        let rest = self.from(end).text();
        if !rest.starts_with(',') {
            push_rest(rest, out);
        } else if rest.chars().any(|c| c != ',' && !blank(c)) {
            out.push_str(self.line.get(end..self.end).unwrap_or(""));
        }
    }

    fn slice(self, span: Span) -> &'a str {
        self.line.get(span.start as usize..span.end as usize).unwrap_or("")
    }

    fn text(self) -> &'a str {
        self.line.get(self.start..self.end).unwrap_or("")
    }

    /// The code from a place on, blanks skipped.
    fn from(self, start: usize) -> Self {
        let skipped = self.line.get(start..self.end).unwrap_or("");
        Self { start: self.end - skipped.trim_start_matches(blank).len(), ..self }
    }

    /// The code behind a word or sign that it begins with.
    fn behind(self, word: &str) -> Self {
        self.from((self.start + word.len()).min(self.end))
    }

    /// Its first word.
    fn word(self) -> &'a str {
        let text = self.text();
        let end = text.bytes().position(|b| !b.is_ascii_alphanumeric()).unwrap_or(text.len());
        &text[..end]
    }

    /// A capital word and what stands behind it.
    fn push_words(self, words: &[&str; 2], out: &mut String) {
        out.push_str(&words[0].to_uppercase());
        out.push(' ');
        out.push_str(words[1]);
    }

    fn push_assignment(self, out: &mut String) {
        let mut text = self.text();
        if !text.starts_with(['&', '$']) {
            out.push_str("VV,");
            text = text.trim_start_matches(|c: char| c != '&' && c != '$');
        }
        let equals = text.find('=').unwrap_or(text.len());
        let (name, op) = match text[..equals].strip_suffix(':') {
            Some(name) => (name, ":="),
            None => (&text[..equals], "="),
        };
        let value = text.get(equals + 1..).unwrap_or("").trim_matches(blank);
        out.push_str(trim_end(name));
        out.push(' ');
        out.push_str(op);
        if !value.is_empty() {
            out.push(' ');
            out.push_str(value);
        }
    }

    /// EXIT SHOPBOT and WARNING OFF, and what is ignored behind them.
    fn push_two_words(self, out: &mut String) {
        let second = self.behind(self.word());
        self.push_words(&[self.word(), &second.word().to_uppercase()], out);
        push_rest(second.behind(second.word()).text(), out);
    }

    /// END, ENDALL, END ALL, RETURN and a bare PAUSE, and what is ignored behind them.
    fn push_end(self, statement: &Statement, out: &mut String) {
        let word = self.word().to_uppercase();
        let rest = self.behind(&word);
        if *statement == Statement::EndAll && word == "END" {
            out.push_str("END ALL");
            return push_rest(rest.behind(rest.word()).text(), out);
        }
        out.push_str(&word);
        if !matches!(statement, Statement::Pause { .. }) {
            push_rest(rest.text(), out);
        }
    }

    /// `C#,n`, `CN,n` or `Cn`, as it was spelled.
    fn push_custom(self, number: &str, out: &mut String) {
        let head = if self.text().as_bytes().get(1) == Some(&b'#') { "C#" } else { self.word() };
        out.push_str(&head.to_uppercase());
        if !head[1..].starts_with(|c: char| c.is_ascii_digit()) {
            out.push(',');
            out.push_str(number);
        }
    }

    /// Any other statement: its word in the usual spelling, the rest as written.
    fn push_keyword(self, out: &mut String) {
        let word = self.word();
        let rest = self.behind(word).text();
        out.push_str(&usual_spelling(word));
        let close = rest.is_empty()
            || rest.starts_with([',', ';'])
            || (rest.starts_with('(') && word.eq_ignore_ascii_case("MSGBOX"));
        if !close {
            out.push(' ');
        }
        out.push_str(rest);
    }
}

fn push_rest(rest: &str, out: &mut String) {
    if !rest.is_empty() {
        out.push(' ');
        out.push_str(rest);
    }
}

/// Statements are written in capitals, but for the long names of the registry.
fn usual_spelling(word: &str) -> String {
    const MIXED: [&str; 9] = [
        "SetUsrVal",
        "SetUsrValClrd",
        "SetSpindleStatus",
        "GetUsrVal",
        "GetUsrValClrd",
        "GetSpindleStatus",
        "GetUsrPath",
        "GetAppPath",
        "GetPartFileName",
    ];
    let usual = MIXED.iter().find(|usual| usual.eq_ignore_ascii_case(word));
    usual.map_or_else(|| word.to_uppercase(), ToString::to_string)
}
