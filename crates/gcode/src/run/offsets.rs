//! The zero points: G10, G28, G30, G43, G49, G52 … G59.3, G92.

use super::context::Context;
use super::core::Core;
use super::go;
use super::modes::doubt_unit;
use super::state::CoordinateSystem;
use super::stop::{Refused, Stop, fail};
use crate::syntax::codes::{ONCE, SYSTEM, TOOL_LENGTH};
use crate::syntax::gathered::{AXIS_WORDS, Gathered};
use kerf_diag::Code;
use kerf_program::{Axes, Axis, MoveKind, Tool};

/// The way the offset of a tool is told.
#[derive(Clone, Copy, Debug)]
enum Measured {
    /// L1: the offset itself.
    Given,
    /// L10: the present place reads the values with this tool.
    Here,
    /// L11: the present place reads them in G59.3 without G92, where a fixture measures tools.
    InLastSystem,
}

/// G54 … G59.3.
pub(super) fn system(c: &mut Context<'_>, g: &Gathered) -> Result<(), Stop> {
    let Some(code) = g.g[SYSTEM] else { return Ok(()) };
    let system = match code {
        591..=593 => (code - 590 + 5) as usize,
        _ => ((code - 540) / 10) as usize,
    };
    if system != c.core.state.modal.system {
        c.core.place.need_uncompensated("another coordinate system")?;
    }
    c.core.state.modal.system = system;
    c.relocate();
    Ok(())
}

/// G43, G43.1, G49.
pub(super) fn tool_length(c: &mut Context<'_>, g: &Gathered) -> Result<(), Stop> {
    let offset = match g.g[TOOL_LENGTH] {
        Some(430) => length_of(c, g),
        Some(431) => {
            let mut offset = c.core.state.tool_offset;
            for (axis, value) in given(g) {
                offset[axis] = value * c.core.state.modal.unit_of(&c.core.settings, axis);
            }
            offset
        }
        Some(_) => Axes::default(),
        None => return Ok(()),
    };
    c.core.state.tool_offset = offset;
    c.relocate();
    Ok(())
}

fn length_of(c: &mut Context<'_>, g: &Gathered) -> Axes {
    let number = g.tool(b'H').unwrap_or(c.core.state.tool);
    if number == 0 {
        return Axes::default();
    }
    if let Some(tool) = c.core.state.tools.get(&number) {
        return beside_zero(c.core, number, tool);
    }
    let message = format!("the length of tool {number} is not known");
    c.warn(Code::Unusual, message, "its offset counts as zero; zero Z with this tool");
    Axes::default()
}

/// The offset of a tool. Where M6 measures tools Z zero is that of the tool in the spindle: only what another one
/// is longer is beside it.
fn beside_zero(core: &Core, number: u32, tool: &Tool) -> Axes {
    let mut offset = tool.offset;
    if core.options.changes_elsewhere && tool.measured {
        let in_spindle = core.state.tools.get(&core.state.tool).and_then(Tool::touch_mm);
        let inside_mm = in_spindle.filter(|_| number != core.state.tool);
        offset[Axis::Z] -= inside_mm.unwrap_or(offset[Axis::Z]);
    }
    offset
}

/// The axis words of a block.
fn given(g: &Gathered) -> Vec<(Axis, f64)> {
    Axis::ALL.into_iter().filter_map(|a| Some((a, g.get(a.letter() as u8)?))).collect()
}

/// Codes that do something once.
pub(super) fn once(c: &mut Context<'_>, g: &Gathered) -> Result<(), Stop> {
    let Some(code) = g.g[ONCE] else { return Ok(()) };
    let moves_zero = matches!(code, 100 | 520 | 920..=923);
    if moves_zero {
        c.core.place.need_uncompensated("an offset")?;
    }
    match code {
        100 => set_offsets(c.core, g)?,
        280 => go_home(c, g, 0)?,
        300 => go_home(c, g, 1)?,
        281 => c.core.state.home[0] = c.core.place.programmed,
        301 => c.core.state.home[1] = c.core.place.programmed,
        520 => {
            for (axis, value) in given(g) {
                c.core.state.shift[axis] = value * c.core.coordinates.scale[axis.index()];
            }
            c.core.state.shift_kept = c.core.state.shift;
        }
        920 => shift_to(c.core, g)?,
        921 => {
            c.core.state.shift = Axes::default();
            c.core.state.shift_kept = Axes::default();
        }
        922 => c.core.state.shift = Axes::default(),
        923 => c.core.state.shift = c.core.state.shift_kept,
        _ => {}
    }
    if moves_zero {
        c.relocate();
    }
    Ok(())
}

/// G92: the present place reads the values given.
fn shift_to(core: &mut Core, g: &Gathered) -> Result<(), Refused> {
    if !g.has_any(AXIS_WORDS) {
        return Err(fail(
            Code::MissingWord,
            "G92 without an axis",
            "G92 X0 makes the present X zero",
        ));
    }
    let place = core.coordinates.place_of(core.place.programmed);
    for (axis, value) in given(g) {
        core.state.shift[axis] += place[axis] - value * core.coordinates.scale[axis.index()];
    }
    core.state.shift_kept = core.state.shift;
    Ok(())
}

/// G10 L1, L2, L10, L11, L20.
fn set_offsets(core: &mut Core, g: &Gathered) -> Result<(), Refused> {
    match g.or_zero(b'L') {
        2.0 => set_system(core, g, false),
        20.0 => set_system(core, g, true),
        1.0 => set_tool(core, g, Measured::Given),
        10.0 => set_tool(core, g, Measured::Here),
        11.0 => set_tool(core, g, Measured::InLastSystem),
        other => {
            let message = format!("G10 L{other} is not known");
            Err(fail(
                Code::OutOfRange,
                message,
                "L2 and L20 set coordinate systems, L1 and L10 tools",
            ))
        }
    }
}

fn set_system(core: &mut Core, g: &Gathered, present: bool) -> Result<(), Refused> {
    let p = g.or_zero(b'P');
    if p.fract() != 0.0 || !(0.0..=9.0).contains(&p) {
        let message = format!("there is no coordinate system {p}");
        return Err(fail(
            Code::OutOfRange,
            message,
            "P1 is G54, P6 is G59, P9 is G59.3; P0 the one in force",
        ));
    }
    let index = if p == 0.0 { core.state.modal.system } else { p as usize - 1 };
    let mut system = core.state.systems[index.min(8)];
    if let Some(rotation) = g.get(b'R').filter(|_| !present) {
        system.rotation_deg = core.scheme().turn_of(rotation);
    }
    if present {
        read_here(core, g, &mut system);
    } else {
        for (axis, value) in given(g) {
            system.offset[axis] = value * core.state.modal.unit_of(&core.settings, axis);
        }
    }
    core.state.systems[index.min(8)] = system;
    Ok(())
}

/// Moves a system so that the present place reads the values given. In a turned one X and Y of its zero go
/// together: what is not given reads as before.
fn read_here(core: &Core, g: &Gathered, system: &mut CoordinateSystem) {
    let state = &core.state;
    // Where FP lays the file is no part of the system.
    let [x, y, z] = core.options.temporary_zero_mm;
    let place = core.place.programmed.minus(state.tool_offset).minus(Axes::xyz(x, y, z));
    let mut local = system.unturn(place.minus(system.offset));
    let given = given(g);
    for (axis, value) in &given {
        local[*axis] = value * core.coordinates.scale[axis.index()] + state.shift[*axis];
    }
    let wanted = place.minus(system.turn(local));
    let turned = system.rotation_deg != 0.0 && given.iter().any(|(axis, _)| axis.index() < 2);
    for axis in Axis::ALL {
        if given.iter().any(|(a, _)| *a == axis) || turned && axis.index() < 2 {
            system.offset[axis] = wanted[axis];
        }
    }
}

/// The present place as G59.3 reads it, without tool and G92: a tool is measured there with G10 L11.
fn place_of_last_system(core: &Core) -> Axes {
    let system = core.state.systems[8];
    let [x, y, z] = core.options.temporary_zero_mm;
    system.unturn(core.place.programmed.minus(system.offset).minus(Axes::xyz(x, y, z)))
}

fn set_tool(core: &mut Core, g: &Gathered, how: Measured) -> Result<(), Refused> {
    let p = g.or_zero(b'P');
    if p.fract() != 0.0 || !(1.0..1e6).contains(&p) {
        let message = "G10 L1 and L10 need the number of a tool";
        return Err(fail(
            Code::MissingWord,
            message,
            "G10 L1 P3 Z40 R3 tells length and radius of tool 3",
        ));
    }
    let mut tool = core.state.tools.get(&(p as u32)).cloned().unwrap_or_else(|| Tool {
        diameter_mm: core.settings.cutter.diameter_mm,
        ..Tool::default()
    });
    let place = core.coordinates.place_of(core.place.programmed);
    let fixture = place_of_last_system(core);
    for (axis, value) in given(g) {
        let reading = value * core.coordinates.scale[axis.index()];
        tool.offset[axis] = match how {
            Measured::Given => value * core.state.modal.unit_of(&core.settings, axis),
            Measured::Here => core.state.tool_offset[axis] + place[axis] - reading,
            Measured::InLastSystem => fixture[axis] - reading,
        };
    }
    // A length that a program gives is one for G43.
    tool.measured &= !g.has(b'Z');
    if let Some(radius) = g.get(b'R') {
        tool.diameter_mm = 2.0 * radius * core.state.modal.unit.mm();
    }
    core.state.tools.insert(p as u32, tool);
    Ok(())
}

/// G28, G30: to a place of the machine, over the place given if there is one.
fn go_home(c: &mut Context<'_>, g: &Gathered, which: usize) -> Result<(), Stop> {
    c.core.place.need_uncompensated("G28 or G30")?;
    doubt_unit(c);
    let home = c.core.state.home[which];
    if !g.has_any(AXIS_WORDS) {
        return go::line(c, MoveKind::Jog, home);
    }
    let over = go::target(c.core, g)?;
    go::line(c, MoveKind::Jog, over)?;
    let mut to = over;
    for (axis, _) in given(g) {
        to[axis] = home[axis];
    }
    go::line(c, MoveKind::Jog, to)
}
