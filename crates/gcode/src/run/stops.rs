//! Holds, tool changes and ends of a program.

use super::context::{Context, Stop};
use super::core::CallKind;
use crate::syntax::codes::{STOP, TOOL};
use crate::syntax::gathered::Gathered;
use crate::syntax::tree::Label;
use kerf_program::{Command, ToolPathStart, Turn};

impl Context<'_> {
    /// M6, M61.
    pub(super) fn tool_change(&mut self, g: &Gathered) -> Result<(), Stop> {
        match g.m[TOOL] {
            Some(6) if self.core.compensator.is_some() => {
                Err(self.not_compensated("a tool change"))
            }
            Some(6) => self.change_tool(),
            Some(_) => {
                self.core.state.tool = g.tool(b'Q').unwrap_or_default();
                Ok(())
            }
            None => Ok(()),
        }
    }

    /// Before the operator reaches into the machine the spindle stands: that is carried out first,
    /// then the block is read again.
    pub(super) fn begin_tool_change(&mut self, g: &Gathered) -> Result<(), Stop> {
        let core = &mut *self.core;
        let changes = g.m[TOOL] == Some(6) && core.compensator.is_none();
        if !changes || std::mem::replace(&mut core.changing, true) {
            return Ok(());
        }
        // Behind a tool change the program goes on from where the tool really is.
        core.position = core.tool_position();
        core.beside = None;
        self.turn_spindle(Turn::Off);
        let tool = g.tool(b'T').unwrap_or(self.core.state.selected);
        if tool != self.core.state.tool {
            self.emit(Command::ToolChange { begin: true });
        }
        Err(Stop::Again)
    }

    fn change_tool(&mut self) -> Result<(), Stop> {
        let tool = self.core.state.selected;
        if tool != self.core.state.tool {
            let text =
                if tool == 0 { "take the tool out".into() } else { format!("put in tool {tool}") };
            self.pause(&text, None)?;
            self.emit(Command::ToolChange { begin: false });
        }
        self.core.changing = false;
        self.core.state.tool = tool;
        if tool > 0 {
            let tool = Some(format!("T{tool}").into());
            self.emit(Command::ToolPath(ToolPathStart { name: None, tool }));
        }
        Ok(())
    }

    /// M0, M1, M2, M30, M60, M98, M99.
    pub(super) fn stop(&mut self, g: &Gathered) -> Result<(), Stop> {
        match g.m[STOP] {
            Some(0) => self.holds_after("program stop (M0)"),
            Some(60) => self.holds_after("program stop (M60)"),
            Some(1) if self.core.options.optional_stop => self.holds_after("optional stop (M1)"),
            Some(2 | 30) => self.end_program(),
            Some(98) => self.call_numbered(g),
            Some(99) => self.leave_numbered(),
            _ => Ok(()),
        }
    }

    /// The block holds the program when all else of it is done: what moves in it is made before anybody is
    /// asked.
    fn holds_after(&mut self, text: &str) -> Result<(), Stop> {
        let text = self.message_above().unwrap_or_else(|| text.into());
        self.core.holding = Some(text);
        Ok(())
    }

    /// Holds behind a block that was carried out.
    pub(super) fn hold(&mut self, text: &str) -> Result<(), Stop> {
        let held = self.hold_at_once(text);
        if !matches!(held, Err(Stop::Waiting)) {
            self.core.holding = None;
        }
        held
    }

    /// The message in this line, for the box that M0 opens.
    fn message_above(&self) -> Option<String> {
        let of_block = self.out.iter().rev().take_while(|s| s.at == self.at);
        let mut said = of_block.filter_map(|s| match &s.command {
            Command::Message { text } if !text.is_empty() => Some(text.to_string()),
            _ => None,
        });
        said.next()
    }

    /// M2, M30: the machine is left as a program should leave it.
    fn end_program(&mut self) -> Result<(), Stop> {
        self.end_compensation()?;
        self.turn_spindle(Turn::Off);
        self.set_coolant(false, false);
        let modal = &mut self.core.state.modal;
        let kept = (modal.unit, modal.unit_said, modal.rpm, modal.return_to_r);
        *modal = super::Modal::default();
        (modal.unit, modal.unit_said, modal.rpm, modal.return_to_r) = kept;
        self.core.cycle = None;
        self.relocate();
        self.core.over = true;
        Ok(())
    }

    /// M98 P… L…
    fn call_numbered(&mut self, g: &Gathered) -> Result<(), Stop> {
        let times = g.get(b'L').map_or(1, |l| l as u64);
        if times == 0 {
            return Ok(());
        }
        let label = Label::Number(g.or_zero(b'P') as u32);
        self.call(&label, CallKind::Fanuc { again: times - 1, first: 0 }, Vec::new())
    }

    /// M99: back, or the whole program again.
    fn leave_numbered(&mut self) -> Result<(), Stop> {
        if self.core.calls.len() > 1 {
            return self.leave_call(None);
        }
        self.go_on_at(0);
        Ok(())
    }
}
