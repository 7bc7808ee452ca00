//! G38.2 … G38.5: a move that ends when the probe makes or loses contact.
//!
//! The move is given like any other while its input is watched. Whoever runs the program tells when
//! the input changed ([`Interpreter::interrupt`](super::Interpreter::interrupt)); otherwise the move
//! ran to its end.

use super::Core;
use super::context::{Context, Stop};
use super::step::whole_line;
use crate::syntax::codes::g_name;
use crate::syntax::gathered::Gathered;
use kerf_diag::Code;
use kerf_program::{Axes, Command, Line, MoveKind, Watch};
use serde::{Deserialize, Serialize};

/// A probe move that is under way.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Probe {
    pub(super) watch: Watch,
    /// Its code, in tenths.
    code: i32,
    /// Its line, from 1.
    #[serde(default)]
    line: u32,
    /// Place of the machine when the probe changed.
    contact: Option<Axes>,
}

/// The machine stopped because the probe changed.
pub(super) fn contact(core: &mut Core, position: Axes) {
    if let Some(probe) = &mut core.probing {
        probe.contact = Some(position);
        core.position = position;
    }
}

impl Context<'_> {
    pub(super) fn begin_probe(&mut self, g: &Gathered, code: i32) -> Result<(), Stop> {
        if self.core.compensator.is_some() {
            return Err(self.not_compensated("a probe move"));
        }
        let to = self.target(g)?;
        if to == self.core.position {
            return Err(self.fail(
                Code::Probing,
                "a probe move that goes nowhere",
                "name a place away from here",
            ));
        }
        let feed = self.feed(self.core.position, to)?;
        // G38.2 and G38.3 look for contact, G38.4 and G38.5 for its loss.
        let on = code <= 383;
        let input = self.core.options.probe_input;
        self.settle()?;
        if !self.core.options.preview && self.host.input(input) == on {
            let (message, hint) = if on {
                ("the probe is in contact already", "move it away first")
            } else {
                ("the probe is not in contact", "G38.4 and G38.5 move away from a contact")
            };
            return Err(self.fail(Code::Probing, message, hint));
        }
        self.core.position = to;
        self.core.beside = None;
        self.emit(Command::Line(Line { kind: MoveKind::Cut, to, feed }));
        let watch = Watch::change(input, on, false);
        self.core.probing = Some(Probe { watch, code, line: self.at.line, contact: None });
        Ok(())
    }

    /// The probe move is over.
    pub(super) fn end_probe(&mut self) -> Result<(), Stop> {
        self.settle()?;
        let Some(probe) = self.core.probing.take() else { return Ok(()) };
        self.at.line = probe.line;
        self.span = whole_line(&self.program(), probe.line);
        let met = probe.contact.is_some();
        self.core.state.probed = self.core.position;
        self.core.state.probe_hit = met || self.core.options.preview;
        if self.core.state.probe_hit || matches!(probe.code, 383 | 385) {
            return Ok(());
        }
        let message = format!("{} ended without the probe changing", g_name(probe.code));
        Err(self.fail(
            Code::Probing,
            message,
            "G38.3 and G38.5 go on without an error; #5070 tells",
        ))
    }
}
