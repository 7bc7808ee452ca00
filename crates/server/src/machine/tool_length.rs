//! A length of the tool in the spindle that is corrected: Z zero goes with it, where a change of tools has set Z zero by that
//! length.

use kerf_control::Session;
use kerf_program::{Axis, rounded};
use kerf_workspace::Workspace;

/// Z zero is where the last change of tools left it, if it lies within this, mm.
const SAME_MM: f64 = 0.026;

/// Lengths that differ by less are the same, mm.
const LEAST_MM: f64 = 1e-4;

/// The value that holds where a change of tools left Z zero, in the table base.
const TOOL_ZERO: &str = "$TOOL_ZERO";

/// Z zero and the length of the tool in the spindle.
#[derive(Clone, Debug, PartialEq)]
pub enum ZeroOfTool {
    /// It goes up by so many mm with the length, by this program.
    Goes(f64, String),
    /// It was set since with this very tool: it is right whatever its length.
    Stays,
}

/// Returns what becomes of Z zero when the tool of a number gets another length, mm; nothing where it depends on none.
pub fn zero_of_tool(
    session: &Session,
    workspace: &mut Workspace,
    number: u32,
    length_mm: f64,
) -> Option<ZeroOfTool> {
    let tool = session.gcode.tools.get(&number).filter(|_| number == session.gcode.tool)?;
    let by_mm = length_mm - tool.touch_mm()?;
    if by_mm.abs() < LEAST_MM {
        return None;
    }
    let kerf_sbp::Session { settings, frame, position, .. } = &session.memory;
    let unit_mm = settings.linear_unit.mm();
    let reads_mm = frame.working(*position)[Axis::Z];
    let zero_mm = frame.base(*position)[Axis::Z] - reads_mm;
    let left_mm: Option<f64> = workspace.value(TOOL_ZERO)?.parse().ok();
    if left_mm.is_none_or(|left| (left * unit_mm - zero_mm).abs() > SAME_MM) {
        return Some(ZeroOfTool::Stays);
    }
    let unit = |mm: f64| rounded(mm / unit_mm, 9);
    let (reads, by) = (unit(reads_mm - by_mm), unit(by_mm));
    // The next change of tools takes this one to be as long as it is now.
    let text = format!("VA,,,{reads}\n$tool_touch = $tool_touch + {by}\n$tool_zero = %(8)");
    Some(ZeroOfTool::Goes(by_mm, text))
}
