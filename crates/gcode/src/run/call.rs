//! Calls of subroutines, and the way back.

use super::calls::{Call, CallKind, LOCALS};
use super::context::Context;
use super::modes::restore_modes;
use super::parameters::set_named;
use super::stop::{Stop, fail};
use crate::syntax::reader::read;
use crate::syntax::tree::{Label, Program};
use kerf_diag::Code;
use kerf_program::{FileRequest, Folder, HostError};

/// Calls within calls; more is a subroutine that calls itself for ever.
const MOST_CALLS: usize = 100;

/// Calls a subroutine of this file, or a file of its name.
pub(super) fn call(
    c: &mut Context<'_>,
    label: &Label,
    kind: CallKind,
    mut values: Vec<f64>,
) -> Result<(), Stop> {
    if c.core.calls.open.len() >= MOST_CALLS {
        let message = format!("more than {MOST_CALLS} calls within each other");
        return Err(fail(Code::NestedTooDeep, message, "does a subroutine call itself for ever?"));
    }
    let (file, line) = find(c, label)?;
    let kind = match kind {
        CallKind::Fanuc { again, .. } => CallKind::Fanuc { again, first: line },
        kind => kind,
    };
    let mut call = Call::new(file, line, kind);
    if kind == CallKind::Sub {
        values.resize(LOCALS, 0.0);
        call.locals = values;
    }
    c.core.calls.open.push(call);
    Ok(())
}

/// The file and the first line (index) of a subroutine.
fn find(c: &mut Context<'_>, label: &Label) -> Result<(u32, u32), Stop> {
    let known = |p: &Program| p.subs.get(label).copied();
    if let Some(line) = known(&c.program()) {
        return Ok((c.at.file, line));
    }
    // The file that was started may hold what a file it called needs.
    let loaded = c.core.calls.programs.iter().enumerate();
    let mut loaded = loaded.filter_map(|(i, p)| Some((i as u32, known(p)?)));
    if let Some(found) = loaded.next() {
        return Ok(found);
    }
    load(c, label)
}

fn load(c: &mut Context<'_>, label: &Label) -> Result<(u32, u32), Stop> {
    let stem = match label {
        Label::Number(n) => format!("{n}"),
        Label::Name(name) => name.to_string(),
    };
    for ending in ["ngc", "nc"] {
        let request = FileRequest { folder: Folder::Parts, name: format!("{stem}.{ending}") };
        let source = match c.host.source(&request) {
            Ok(source) => source,
            Err(HostError::NotFound(_)) => continue,
            Err(error) => return Err(error.into()),
        };
        let program = read(source.name, &source.bytes);
        if let Some(error) = program.diagnostics.iter().find(|d| d.is_error()) {
            return Err(Stop::Failed(Box::new(error.clone())));
        }
        // A file without a subroutine of this name is the subroutine.
        let line = program.subs.get(label).copied().unwrap_or_default();
        return Ok((c.core.calls.load(program), line));
    }
    let message = format!("there is no subroutine {label}");
    let hint = format!("define it with {label} sub, or put it into a file {stem}.ngc");
    Err(fail(Code::NoSubroutine, message, hint))
}

/// Goes back to the caller, or begins the subroutine again when it is called repeatedly.
pub(super) fn leave_call(c: &mut Context<'_>, value: Option<f64>) {
    if let Some(call) = c.core.calls.open.last_mut()
        && let CallKind::Fanuc { again, first } = &mut call.kind
        && *again > 0
    {
        *again -= 1;
        call.next = *first;
        return;
    }
    let Some(call) = c.core.calls.open.pop() else { return };
    if call.kind == CallKind::Sub {
        let (state, calls) = (&mut c.core.state, &mut c.core.calls);
        set_named(state, calls, "_value".into(), value.unwrap_or_default());
        let returned = f64::from(u8::from(value.is_some()));
        set_named(state, calls, "_value_returned".into(), returned);
    }
    if let Some(kept) = call.kept.filter(|_| call.restore) {
        restore_modes(c, &kept);
    }
}
