//! G38.2 … G38.5: a move that ends when the probe makes or loses contact.
//!
//! The move is given like any other while its input is watched. Whoever runs the program tells when
//! the input changed ([`Interpreter::interrupt`](super::interpreter::Interpreter::interrupt)); otherwise the move
//! ran to its end.

use super::context::Context;
use super::core::Core;
use super::stop::{Stop, fail};
use super::under_way::Probe;
use super::{feed, go};
use crate::syntax::codes::g_name;
use crate::syntax::gathered::Gathered;
use kerf_diag::Code;
use kerf_program::{Axes, Command, Line, MoveKind, Watch};

/// The machine stopped because the probe changed.
pub(super) fn contact(core: &mut Core, position: Axes) {
    if let Some(probe) = &mut core.under_way.probing {
        probe.contact = Some(position);
        core.place.programmed = position;
    }
}

/// Begins a probe move.
pub(super) fn begin_probe(c: &mut Context<'_>, g: &Gathered, code: i32) -> Result<(), Stop> {
    c.core.place.need_uncompensated("a probe move")?;
    let to = go::target(c.core, g)?;
    if to == c.core.place.programmed {
        return Err(fail(
            Code::Probing,
            "a probe move that goes nowhere",
            "name a place away from here",
        ));
    }
    let feed = feed::feed(c, to)?;
    // G38.2 and G38.3 look for contact, G38.4 and G38.5 for its loss.
    let on = code <= 383;
    let input = c.core.options.probe_input;
    c.settle()?;
    if !c.core.options.preview && c.host.input(input) == on {
        let (message, hint) = if on {
            ("the probe is in contact already", "move it away first")
        } else {
            ("the probe is not in contact", "G38.4 and G38.5 move away from a contact")
        };
        return Err(fail(Code::Probing, message, hint));
    }
    c.core.place.arrive(to);
    c.emit(Command::Line(Line { kind: MoveKind::Cut, to, feed }));
    let watch = Watch::change(input, on, false);
    c.core.under_way.probing = Some(Probe { watch, code, line: c.at.line, contact: None });
    Ok(())
}

/// The probe move is over.
pub(super) fn end_probe(c: &mut Context<'_>) -> Result<(), Stop> {
    c.settle()?;
    let Some(probe) = c.core.under_way.probing.take() else { return Ok(()) };
    c.at.line = probe.line;
    c.span = c.program().code_of(probe.line);
    let met = probe.contact.is_some();
    c.core.state.probed = c.core.place.programmed;
    c.core.state.probe_hit = met || c.core.options.preview;
    if c.core.state.probe_hit || matches!(probe.code, 383 | 385) {
        return Ok(());
    }
    let message = format!("{} ended without the probe changing", g_name(probe.code));
    Err(fail(Code::Probing, message, "G38.3 and G38.5 go on without an error; #5070 tells"))
}
