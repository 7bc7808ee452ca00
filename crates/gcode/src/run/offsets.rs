//! The zero points: G10, G28, G30, G43, G49, G52 … G59.3, G92.

use super::context::{Context, Stop};
use super::state::{CoordinateSystem, Tool};
use crate::syntax::codes::{ONCE, SYSTEM, TOOL_LENGTH};
use crate::syntax::gathered::{AXIS_WORDS, Gathered};
use kerf_diag::Code;
use kerf_program::{Axes, Axis, MoveKind};

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

impl Context<'_> {
    /// G54 … G59.3.
    pub(super) fn system(&mut self, g: &Gathered) -> Result<(), Stop> {
        let Some(code) = g.g[SYSTEM] else { return Ok(()) };
        let system = match code {
            591..=593 => (code - 590 + 5) as usize,
            _ => ((code - 540) / 10) as usize,
        };
        if self.core.compensator.is_some() && system != self.core.state.modal.system {
            return Err(self.not_compensated("another coordinate system"));
        }
        self.core.state.modal.system = system;
        self.relocate();
        Ok(())
    }

    /// G43, G43.1, G49.
    pub(super) fn tool_length(&mut self, g: &Gathered) -> Result<(), Stop> {
        let offset = match g.g[TOOL_LENGTH] {
            Some(430) => self.length_of(g),
            Some(431) => {
                let mut offset = self.core.state.tool_offset;
                for (axis, value) in self.given(g) {
                    offset[axis] = value * self.core.unit_of(axis);
                }
                offset
            }
            Some(_) => Axes::default(),
            None => return Ok(()),
        };
        self.core.state.tool_offset = offset;
        self.relocate();
        Ok(())
    }

    fn length_of(&mut self, g: &Gathered) -> Axes {
        let number = g.tool(b'H').unwrap_or(self.core.state.tool);
        if number == 0 {
            return Axes::default();
        }
        if let Some(tool) = self.core.state.tools.get(&number) {
            return tool.offset;
        }
        let message = format!("the length of tool {number} is not known");
        self.warn(Code::Unusual, message, "its offset counts as zero; zero Z with this tool");
        Axes::default()
    }

    /// The axis words of a block.
    fn given(&self, g: &Gathered) -> Vec<(Axis, f64)> {
        Axis::ALL.into_iter().filter_map(|a| Some((a, g.get(a.letter() as u8)?))).collect()
    }

    /// Millimetres or degrees of one unit as the words of a move count it: with the proportions of FP.
    fn scale_of(&self, axis: Axis) -> f64 {
        self.core.scale[axis.index()]
    }

    /// Codes that do something once.
    pub(super) fn once(&mut self, g: &Gathered) -> Result<(), Stop> {
        let Some(code) = g.g[ONCE] else { return Ok(()) };
        let moves_zero = matches!(code, 100 | 520 | 920..=923);
        if moves_zero && self.core.compensator.is_some() {
            return Err(self.not_compensated("an offset"));
        }
        match code {
            100 => self.set_offsets(g)?,
            280 => self.go_home(g, 0)?,
            300 => self.go_home(g, 1)?,
            281 => self.core.state.home[0] = self.core.position,
            301 => self.core.state.home[1] = self.core.position,
            520 => {
                for (axis, value) in self.given(g) {
                    self.core.state.shift[axis] = value * self.scale_of(axis);
                }
                self.core.state.shift_kept = self.core.state.shift;
            }
            920 => self.shift_to(g)?,
            921 => {
                self.core.state.shift = Axes::default();
                self.core.state.shift_kept = Axes::default();
            }
            922 => self.core.state.shift = Axes::default(),
            923 => self.core.state.shift = self.core.state.shift_kept,
            _ => {}
        }
        if moves_zero {
            self.relocate();
        }
        Ok(())
    }

    /// G92: the present place reads the values given.
    fn shift_to(&mut self, g: &Gathered) -> Result<(), Stop> {
        if !g.has_any(AXIS_WORDS) {
            return Err(self.fail(
                Code::MissingWord,
                "G92 without an axis",
                "G92 X0 makes the present X zero",
            ));
        }
        let place = self.core.place_of(self.core.position);
        for (axis, value) in self.given(g) {
            self.core.state.shift[axis] += place[axis] - value * self.scale_of(axis);
        }
        self.core.state.shift_kept = self.core.state.shift;
        Ok(())
    }

    /// G10 L1, L2, L10, L11, L20.
    fn set_offsets(&mut self, g: &Gathered) -> Result<(), Stop> {
        match g.or_zero(b'L') {
            2.0 => self.set_system(g, false),
            20.0 => self.set_system(g, true),
            1.0 => self.set_tool(g, Measured::Given),
            10.0 => self.set_tool(g, Measured::Here),
            11.0 => self.set_tool(g, Measured::InLastSystem),
            other => {
                let message = format!("G10 L{other} is not known");
                Err(self.fail(
                    Code::OutOfRange,
                    message,
                    "L2 and L20 set coordinate systems, L1 and L10 tools",
                ))
            }
        }
    }

    fn set_system(&mut self, g: &Gathered, present: bool) -> Result<(), Stop> {
        let p = g.or_zero(b'P');
        if p.fract() != 0.0 || !(0.0..=9.0).contains(&p) {
            let message = format!("there is no coordinate system {p}");
            return Err(self.fail(
                Code::OutOfRange,
                message,
                "P1 is G54, P6 is G59, P9 is G59.3; P0 the one in force",
            ));
        }
        let index = if p == 0.0 { self.core.state.modal.system } else { p as usize - 1 };
        let mut system = self.core.state.systems[index.min(8)];
        if let Some(rotation) = g.get(b'R').filter(|_| !present) {
            system.rotation_deg = self.core.turn_of(rotation);
        }
        if present {
            self.read_here(g, &mut system);
        } else {
            for (axis, value) in self.given(g) {
                system.offset[axis] = value * self.core.unit_of(axis);
            }
        }
        self.core.state.systems[index.min(8)] = system;
        Ok(())
    }

    /// Moves a system so that the present place reads the values given. In a turned one X and Y of its zero go
    /// together: what is not given reads as before.
    fn read_here(&self, g: &Gathered, system: &mut CoordinateSystem) {
        let state = &self.core.state;
        // Where FP lays the file is no part of the system.
        let [x, y, z] = self.core.options.temporary_zero_mm;
        let place = self.core.position.minus(state.tool_offset).minus(Axes::xyz(x, y, z));
        let mut local = system.unturn(place.minus(system.offset));
        let given = self.given(g);
        for (axis, value) in &given {
            local[*axis] = value * self.scale_of(*axis) + state.shift[*axis];
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
    fn place_of_last_system(&self) -> Axes {
        let system = self.core.state.systems[8];
        let [x, y, z] = self.core.options.temporary_zero_mm;
        system.unturn(self.core.position.minus(system.offset).minus(Axes::xyz(x, y, z)))
    }

    fn set_tool(&mut self, g: &Gathered, how: Measured) -> Result<(), Stop> {
        let p = g.or_zero(b'P');
        if p.fract() != 0.0 || !(1.0..1e6).contains(&p) {
            let message = "G10 L1 and L10 need the number of a tool";
            return Err(self.fail(
                Code::MissingWord,
                message,
                "G10 L1 P3 Z40 R3 tells length and radius of tool 3",
            ));
        }
        let mut tool = self.core.state.tools.get(&(p as u32)).copied().unwrap_or(Tool {
            diameter_mm: self.core.settings.cutter.diameter_mm,
            offset: Axes::default(),
        });
        let place = self.core.place_of(self.core.position);
        let fixture = self.place_of_last_system();
        for (axis, value) in self.given(g) {
            let reading = value * self.scale_of(axis);
            tool.offset[axis] = match how {
                Measured::Given => value * self.core.unit_of(axis),
                Measured::Here => self.core.state.tool_offset[axis] + place[axis] - reading,
                Measured::InLastSystem => fixture[axis] - reading,
            };
        }
        if let Some(radius) = g.get(b'R') {
            tool.diameter_mm = 2.0 * radius * self.core.state.modal.unit.mm();
        }
        self.core.state.tools.insert(p as u32, tool);
        Ok(())
    }

    /// G28, G30: to a place of the machine, over the place given if there is one.
    fn go_home(&mut self, g: &Gathered, which: usize) -> Result<(), Stop> {
        if self.core.compensator.is_some() {
            return Err(self.not_compensated("G28 or G30"));
        }
        self.doubt_unit();
        let home = self.core.state.home[which];
        if !g.has_any(AXIS_WORDS) {
            return self.line(MoveKind::Jog, home);
        }
        let over = self.target(g)?;
        self.line(MoveKind::Jog, over)?;
        let mut to = over;
        for (axis, _) in self.given(g) {
            to[axis] = home[axis];
        }
        self.line(MoveKind::Jog, to)
    }
}
