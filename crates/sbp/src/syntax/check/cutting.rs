//! Cutting: what cuts, how deep, and whether the spindle turns.

use super::facts::Facts;
use crate::syntax::Dialect;
use crate::syntax::table::Group;
use crate::syntax::tree::{Span, Statement};
use kerf_diag::{Code, Diagnostic};

/// Jogs to a literal Z below 0, in files that use locations.
pub(super) fn jogs_below_surface(facts: &Facts<'_>) -> Vec<Diagnostic> {
    if facts.relative || z_counts_down(facts) || moves_zero(facts) {
        return Vec::new();
    }
    let mut found = Vec::new();
    for (line, jog, [_, _, z]) in facts.literal_moves() {
        if jog && z.is_some_and(|z| z < 0.0) {
            let span = facts.whole(line);
            let message = "this jog goes below Z 0 at rapid speed";
            let hint = "plunge with MZ, or lift first";
            found.push(facts.finding(Code::JogBelowSurface, line, span, message, hint));
        }
    }
    found
}

/// Cutting at literal places below Z 0 in a file that never turns the spindle on.
pub(super) fn spindle_off(facts: &Facts<'_>) -> Vec<Diagnostic> {
    if facts.calls_files || z_counts_down(facts) || spindle_may_turn(facts) {
        return Vec::new();
    }
    let Some(line) = facts.first_cut() else { return Vec::new() };
    let span = facts.whole(line);
    let message = "the file cuts but never turns the spindle on";
    let hint = "C6 or SO,1,1 turns it on, C7 or SO,1,0 off";
    vec![facts.finding(Code::SpindleOff, line, span, message, hint)]
}

/// Returns `true` if some line may turn the spindle on: an output, G-code, or a person at a question.
fn spindle_may_turn(facts: &Facts<'_>) -> bool {
    facts.uses("SO")
        || facts.uses("TR")
        || facts.statements().any(|(_, statement)| {
            matches!(
                statement,
                Statement::Gcode(_)
                    | Statement::Pause { seconds: None }
                    | Statement::MsgBox(_)
                    | Statement::Input(_)
            )
        })
}

/// Files that zero Z or feel for a surface jog where there is nothing yet.
fn moves_zero(facts: &Facts<'_>) -> bool {
    ["ZZ", "Z3", "Z4", "Z5", "Z6", "VA", "ZT"].into_iter().any(|letters| facts.uses(letters))
        || facts.lines().any(|(_, s)| matches!(s, Statement::OnInput { .. }))
}

/// VC may say that Z counts downwards.
fn z_counts_down(facts: &Facts<'_>) -> bool {
    facts.uses("VC")
}

/// VS with five values as the handbooks' sample has them: two move speeds, then jog speeds.
pub(super) fn old_order_of_speeds(facts: &Facts<'_>) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    for (line, statement) in facts.statements() {
        let Statement::Command { spec, args, span } = statement else { continue };
        if spec.letters == "VS"
            && facts.program.dialect != Dialect::Fabmo
            && args.len() == 5
            && !facts.given(*args, 2)
            && facts.given(*args, 3)
        {
            let message = "five values look like the order of older versions";
            let hint = "now: four move speeds (XY, Z, A, B), then four jog speeds";
            found.push(facts.finding(Code::OldOrder, line, *span, message, hint));
        }
    }
    found
}

/// Cut commands with a positive literal plunge.
pub(super) fn plunges_that_lift(facts: &Facts<'_>) -> Vec<Diagnostic> {
    if z_counts_down(facts) {
        return Vec::new();
    }
    let mut found = Vec::new();
    for (line, statement) in facts.statements() {
        let Statement::Command { spec, args, span } = statement else { continue };
        let plunge = spec.params.iter().position(|param| param.name == "Plunge");
        let lifts =
            plunge.and_then(|at| facts.literal(*args, at)).is_some_and(|plunge| plunge > 0.0);
        if lifts && spec.group == Group::Cut {
            found.push(lifting(facts, line, *span));
        }
    }
    found
}

/// Worded as the interpreter words it, so that both are told once.
fn lifting(facts: &Facts<'_>, line: u32, span: Span) -> Diagnostic {
    let hint = "plunges are negative unless VC says that Z counts downwards";
    facts.finding(Code::Lifts, line, span, "this plunge lifts the tool", hint)
}
