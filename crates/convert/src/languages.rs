//! The two languages, as far as following differs.

use crate::follow::Language;
use kerf_gcode::tree::{Node as GNode, Value};
use kerf_program::At;
use kerf_program::settings::LinearUnit;
use std::sync::Arc;

impl Language for kerf_sbp::Interpreter {
    fn next_line(&self) -> Option<At> {
        self.call_stack().last()
    }

    fn comment_beside(&self, at: At) -> Option<Arc<str>> {
        self.program(at.file)?.comment_beside(at.line).map(Arc::from)
    }

    fn tells_comments(&self) -> bool {
        false
    }

    fn unit(&self) -> LinearUnit {
        self.settings().linear_unit
    }

    fn wanted_tool(&self) -> Option<String> {
        self.variables().get("TOOL").map(|tool| tool.display())
    }

    fn machine_place(&self, _: At) -> Option<&'static str> {
        None
    }
}

impl Language for kerf_gcode::Interpreter {
    fn next_line(&self) -> Option<At> {
        self.call_stack().last()
    }

    fn comment_beside(&self, at: At) -> Option<Arc<str>> {
        let program = self.program(at.file)?;
        let GNode::Block(index) = program.line(at.line)?.node() else {
            return None;
        };
        let block = program.blocks.get(index as usize)?;
        let extra = program.extra_of(block)?;
        let code = !program.words_of(block).is_empty() || !extra.settings.is_empty();
        let comment = extra.comments.first().filter(|_| code)?;
        (comment.kind == kerf_gcode::tree::CommentKind::Plain).then(|| comment.text.clone())
    }

    fn tells_comments(&self) -> bool {
        true
    }

    fn unit(&self) -> LinearUnit {
        self.state().modal.unit
    }

    fn wanted_tool(&self) -> Option<String> {
        None
    }

    fn machine_place(&self, at: At) -> Option<&'static str> {
        let program = self.program(at.file)?;
        let GNode::Block(index) = program.line(at.line)?.node() else {
            return None;
        };
        let block = program.blocks.get(index as usize)?;
        program.words_of(block).iter().filter(|w| w.letter == b'G').find_map(|w| match w.value {
            Value::Number(n) => machine_word(n),
            Value::Computed(_) => None,
        })
    }
}

/// The codes whose places belong to the machine: its zero was taken as that of the part.
fn machine_word(code: f64) -> Option<&'static str> {
    match code {
        28.0 => Some("the place of G28, taken as X0 Y0 Z0 of the part: check the heights"),
        30.0 => Some("the place of G30, taken as X0 Y0 Z0 of the part: check the heights"),
        53.0 => Some("G53, with the machine's zero taken as that of the part: check the heights"),
        55.0..59.4 => Some("the coordinate system (G55 to G59.3), taken as that of G54"),
        _ => None,
    }
}
