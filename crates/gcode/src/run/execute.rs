//! One block, in the order that RS274/NGC lays down (section 3.8, table 8), with LinuxCNC's
//! additions at the places LinuxCNC gives them.

use super::Plane;
use super::context::{Context, Stop};
use super::controllers;
use crate::syntax::codes::{
    ARC_DISTANCE, DISTANCE, IO, MOTION, NOTHING, ONCE, PLANE, RETURN, SPINDLE, TOOL, g_name,
};
use crate::syntax::gathered::{AXIS_WORDS, Gathered, letters};
use kerf_diag::Code;
use kerf_program::{Axis, Turn};

/// Letters that ask for a motion.
const MOVING: u32 = AXIS_WORDS | letters(b"@^");
/// Letters that ask for another turn of an arc.
const CENTRE: u32 = letters(b"IJK");

impl Context<'_> {
    /// Carries out a block.
    pub(super) fn execute(&mut self, g: &Gathered) -> Result<(), Stop> {
        if !stops(g) && !self.starts_spindle(g) {
            return self.carry_out(g);
        }
        // A block that stops the program is repeated as a whole when the host has no answer yet.
        self.settle()?;
        let saved = self.core.clone();
        self.core.taken = 0;
        self.core.at_rest = true;
        let outcome = self.carry_out(g);
        self.core.at_rest = false;
        let asked = std::mem::take(&mut self.core.asked);
        if matches!(outcome, Err(Stop::Waiting)) {
            *self.core = saved;
            self.core.asked = asked;
        }
        outcome
    }

    /// Returns `true` if the block starts the spindle and the operator is asked first.
    fn starts_spindle(&self, g: &Gathered) -> bool {
        matches!(g.m[SPINDLE], Some(3 | 4)) && self.core.would_ask_spindle(Turn::Clockwise)
    }

    fn carry_out(&mut self, g: &Gathered) -> Result<(), Stop> {
        let motion = match self.motion_of(g) {
            None => self.behind_a_cycle(g),
            motion => motion,
        };
        self.need_dialect(g, motion)?;
        self.need_use(g, motion)?;
        self.need_axes(g)?;
        self.feed_mode(g);
        self.unit(g)?;
        self.take_feed(g)?;
        self.take_speed(g);
        if let Some(tool) = g.tool(b'T') {
            self.core.state.selected = tool;
        }
        if self.core.options.path_only {
            self.keep_modes(g)?;
        } else {
            self.machine_codes(g)?;
        }
        self.plane(g)?;
        self.compensation(g)?;
        self.tool_length(g)?;
        self.system(g)?;
        self.path_control(g);
        self.distance(g);
        self.once(g)?;
        if let Some(motion) = motion {
            self.set_motion(g, motion)?;
        }
        self.stop(g)
    }

    /// Carries out what a block does besides its path.
    fn machine_codes(&mut self, g: &Gathered) -> Result<(), Stop> {
        self.inputs_and_outputs(g)?;
        self.tool_change(g)?;
        self.spindle(g)?;
        self.keep_modes(g)?;
        self.coolant(g);
        self.overrides(g);
        if g.g[ONCE] == Some(40) {
            self.dwell(g);
        }
        Ok(())
    }

    /// The motion that this block makes, in tenths; `None` when it makes none.
    fn motion_of(&self, g: &Gathered) -> Option<i32> {
        if let Some(motion) = g.g[MOTION] {
            return Some(motion);
        }
        let modal = self.core.state.modal.motion;
        let arc = matches!(modal, Some(20 | 30)) && g.has_any(CENTRE);
        let wanted = !g.axes_taken() && (g.has_any(MOVING) || arc);
        if wanted { modal } else { None }
    }

    /// The motion of a place alone behind G80: that before the cycle, as on Fanuc and Mach3.
    fn behind_a_cycle(&mut self, g: &Gathered) -> Option<i32> {
        let alone = g.has_any(AXIS_WORDS) && !g.axes_taken() && g.g[MOTION].is_none();
        if !alone || !self.core.options.dialect.is_lenient() {
            return None;
        }
        let motion = self.core.state.modal.before_cycle?;
        if !std::mem::replace(&mut self.core.told.behind_cycle, true) {
            let code = g_name(motion);
            let message =
                format!("a place behind G80 without a motion: {code} of before the cycle");
            let hint = format!(
                "so do Fanuc and Mach3; LinuxCNC and grbl refuse it: write {code} before the place"
            );
            self.warn(Code::Unusual, message, hint);
        }
        Some(motion)
    }

    fn need_use(&mut self, g: &Gathered, motion: Option<i32>) -> Result<(), Stop> {
        let Some(letter) = g.unused(motion) else { return Ok(()) };
        let still = matches!(motion, None | Some(800));
        let axes = g.has_any(MOVING) && still && !g.axes_taken();
        let (message, hint) = if matches!(letter, 'U' | 'V' | 'W') {
            (format!("there is no axis {letter}"), "axes are X Y Z A B C")
        } else if axes && "XYZABC@^".contains(letter) {
            if self.core.told.motion_lost {
                // The mistake before, which was told, may have named it.
                return Ok(());
            }
            let what = format!("{letter} without a motion");
            (what, "no motion is in force here; write G0 or G1 before it")
        } else {
            (
                format!("nothing in this block uses {letter}"),
                "is a code missing, or the letter wrong?",
            )
        };
        let no_axis = matches!(letter, 'U' | 'V' | 'W');
        if self.core.options.dialect.is_lenient() && !axes && !no_axis {
            self.warn(Code::UnusedWord, message, hint);
            return Ok(());
        }
        Err(self.fail(Code::UnusedWord, message, hint))
    }

    /// Refuses an axis that VD has not switched on.
    fn need_axes(&self, g: &Gathered) -> Result<(), Stop> {
        for axis in Axis::ALL {
            let given = g.has(axis.letter() as u8);
            if given && axis.index() >= usize::from(self.core.settings.axis_count) {
                let message = format!("{} axis not active", axis.letter());
                let hint = "switch it on in the machine's configuration";
                return Err(self.fail(Code::AxisNotActive, message, hint));
            }
        }
        Ok(())
    }

    /// Refuses what the controller of the dialect refuses.
    fn need_dialect(&mut self, g: &Gathered, motion: Option<i32>) -> Result<(), Stop> {
        self.need_fan(g);
        let plane = match g.g[PLANE] {
            Some(code) => Plane::of_code(code),
            None => self.core.state.modal.plane,
        };
        match controllers::refuses(self.core.options.dialect, g, motion, plane) {
            Some(refused) => Err(self.fail(refused.code, refused.what, refused.mend)),
            None => Ok(()),
        }
    }

    /// M106 and M107 switch the fan of a printer's board, where a laser or a relay may hang: told once.
    fn need_fan(&mut self, g: &Gathered) {
        let Some(code) = g.m[NOTHING].filter(|m| matches!(m, 106 | 107)) else { return };
        if !std::mem::replace(&mut self.core.told.fan, true) {
            let message = format!("M{code} switches nothing here");
            let hint = "it is the fan of a printer's board; a laser or a relay on it is switched by M3 and M5, or M64 P0 and \
                        M65 P0";
            self.warn(Code::Unusual, message, hint);
        }
    }

    fn distance(&mut self, g: &Gathered) {
        let modal = &mut self.core.state.modal;
        if let Some(code) = g.g[DISTANCE] {
            modal.relative = code == 910;
        }
        if let Some(code) = g.g[ARC_DISTANCE] {
            modal.arc_absolute = code == 901;
        }
        if let Some(code) = g.g[RETURN] {
            modal.return_to_r = code == 990;
        }
    }

    fn plane(&mut self, g: &Gathered) -> Result<(), Stop> {
        let Some(code) = g.g[PLANE] else { return Ok(()) };
        let plane = Plane::of_code(code);
        if self.core.compensator.is_some() && plane != Plane::Xy {
            return Err(self.not_compensated("another plane"));
        }
        self.core.state.modal.plane = plane;
        Ok(())
    }

    /// The file is over.
    pub(super) fn end_of_file(&mut self) -> Result<(), Stop> {
        if self.core.calls.len() > 1 {
            return self.leave_call(None);
        }
        self.core.over = true;
        Ok(())
    }
}

/// Returns `true` if a block waits for the machine, the operator or an input.
fn stops(g: &Gathered) -> bool {
    g.m[TOOL] == Some(6) || g.m[IO] == Some(66) || matches!(g.g[MOTION], Some(382..=385))
}
