//! Comments that ask for something: MSG, PRINT, DEBUG, ABORT.

use super::context::Context;
use super::parameters::Parameters;
use super::stop::{Stop, fail};
use crate::syntax::tree::{CommentKind, Extra, Span};
use kerf_diag::Code;
use kerf_program::{Command, ToolPathStart};
use std::fmt::Write as _;
use std::sync::Arc;

/// Words that CAM programs write before the name of a tool path.
const NAMED: [&str; 5] = ["toolpath name", "toolpath", "tool path", "operation", "cut name"];

/// Carries out what the comments of a line ask for.
pub(super) fn comments(c: &mut Context<'_>, extra: Option<&Extra>) -> Result<(), Stop> {
    for comment in extra.iter().flat_map(|extra| &extra.comments) {
        match comment.kind {
            CommentKind::Plain => plain_comment(c, &comment.text),
            CommentKind::Msg => c.emit(Command::Message { text: comment.text.trim().into() }),
            CommentKind::Print => {
                let text = filled(&c.core.parameters(), &comment.text).into();
                c.emit(Command::Print { text, newline: true });
            }
            CommentKind::Debug => {
                let text = filled(&c.core.parameters(), &comment.text).trim().into();
                c.emit(Command::Message { text });
            }
            CommentKind::Abort => {
                let text = filled(&c.core.parameters(), &comment.text);
                return Err(fail(Code::Aborted, text.trim(), "the program ends itself here"));
            }
            CommentKind::Log => {}
        }
    }
    Ok(())
}

fn plain_comment(c: &mut Context<'_>, text: &Arc<str>) {
    if !c.core.options.comments || text.is_empty() {
        return;
    }
    if let Some(name) = tool_path_name(text) {
        c.emit(Command::ToolPath(ToolPathStart { name: Some(name.into()), tool: None }));
    }
    c.emit(Command::Message { text: text.clone() });
}

/// A text with its parameters replaced: `#5`, `#<name>`; `%d` and `%f2` choose how.
fn filled(parameters: &Parameters<'_>, text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut places = 6;
    let mut rest = text;
    while let Some(at) = rest.find(['#', '%']) {
        out.push_str(&rest[..at]);
        rest = &rest[at..];
        if let Some((chosen, after)) = format_of(rest) {
            (places, rest) = (chosen, after);
        } else if let Some((value, after)) = shown(parameters, rest) {
            match value {
                Some(v) => drop(write!(out, "{v:.places$}")),
                None => out.push_str("######"),
            }
            rest = after;
        } else {
            out.push_str(&rest[..1]);
            rest = &rest[1..];
        }
    }
    out.push_str(rest);
    out
}

/// The value of the parameter that a text begins with, and what follows.
fn shown<'t>(parameters: &Parameters<'_>, text: &'t str) -> Option<(Option<f64>, &'t str)> {
    let text = text.strip_prefix('#')?;
    if let Some(named) = text.strip_prefix('<') {
        let (name, after) = named.split_once('>')?;
        let name: String = name.chars().filter(|c| !c.is_whitespace()).collect();
        return Some((parameters.named(&name.to_lowercase()), after));
    }
    let digits = text.bytes().take_while(u8::is_ascii_digit).count();
    let number = text.get(..digits)?.parse().ok()?;
    let value = parameters.numbered(number, Span::default());
    Some((value.ok(), &text[digits..]))
}

/// `%d`, `%f`, `%lf`, `%.3f`: how many places, and what follows.
fn format_of(text: &str) -> Option<(usize, &str)> {
    let rest = text.strip_prefix('%')?;
    if let Some(after) = rest.strip_prefix('d') {
        return Some((0, after));
    }
    if let Some(after) = rest.strip_prefix("lf") {
        return Some((6, after));
    }
    if let Some(after) = rest.strip_prefix('f') {
        return Some((4, after));
    }
    let rest = rest.strip_prefix('.')?;
    let digit = rest.chars().next()?.to_digit(10)?;
    Some((digit as usize, rest[1..].strip_prefix('f')?))
}

/// The name of a tool path in a comment of a CAM program.
fn tool_path_name(text: &str) -> Option<&str> {
    let (head, name) = text.split_once([':', '='])?;
    let head = head.trim().to_ascii_lowercase();
    let name = name.trim();
    (NAMED.contains(&head.as_str()) && !name.is_empty()).then_some(name)
}
