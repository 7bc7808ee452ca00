//! Full-line comments: words to the operator and the marks of CAM programs.

use super::Context;
use crate::syntax::tree::{Node, Program};
use kerf_program::{Command, ToolPathStart};
use std::sync::Arc;

/// A full-line comment: shown to the operator; cutter comments name tool paths.
pub(super) fn comment_line(c: &mut Context<'_>, program: &Program) {
    let text = comment_text(program.line_text(c.at.line));
    if let Some(start) = tool_path_comment(text) {
        c.emit(Command::ToolPath(start));
    }
    if !text.is_empty() {
        c.emit(Command::Message { text: text.into() });
    }
}

/// The full-line comment right above the present line.
pub(super) fn comment_above(c: &Context<'_>) -> Option<String> {
    let program = c.program;
    let above = c.at.line.checked_sub(1)?;
    let node = program.lines.get(above.checked_sub(1)? as usize)?.node;
    let text = comment_text(program.line_text(above));
    (node == Node::Comment && !text.is_empty()).then(|| text.to_string())
}

/// Text of a full-line comment without its mark.
fn comment_text(line: &str) -> &str {
    let line = line.trim();
    let rest = line
        .strip_prefix('\'')
        .or_else(|| line.get(..3).filter(|r| r.eq_ignore_ascii_case("REM")).map(|_| &line[3..]));
    rest.unwrap_or(line).trim()
}

/// `New Path`, `Toolpath Name = …` and `Tool Name = …`, which CAM programs write for the previewer.
fn tool_path_comment(text: &str) -> Option<ToolPathStart> {
    let value = |key: &str| {
        let head = text.get(..key.len())?;
        let rest = text[key.len()..].trim_start().strip_prefix('=')?;
        head.eq_ignore_ascii_case(key).then(|| Arc::from(rest.trim()))
    };
    if text.eq_ignore_ascii_case("New Path") {
        return Some(ToolPathStart::default());
    }
    if let Some(name) = value("Toolpath Name") {
        return Some(ToolPathStart { name: Some(name), tool: None });
    }
    value("Tool Name").map(|tool| ToolPathStart { name: None, tool: Some(tool) })
}
