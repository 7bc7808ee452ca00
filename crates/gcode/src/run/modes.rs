//! Codes that set a mode: unit, feed mode, spindle, coolant, overrides, path control, kept modes.

use super::context::{Context, Stop};
use super::state::FeedMode;
use crate::syntax::codes::{COOLANT, FEED_MODE, MIST, OVERRIDE, PATH, SPINDLE, STATE, UNITS};
use crate::syntax::gathered::Gathered;
use kerf_diag::Code;
use kerf_program::settings::LinearUnit;
use kerf_program::{Command, PathControl, QuestionKind, SPINDLE_STATUS, Turn};

/// The spindle that M3 … M5 speak of.
pub(super) const SPINDLE_NUMBER: u8 = 1;

impl Context<'_> {
    pub(super) fn feed_mode(&mut self, g: &Gathered) {
        let Some(code) = g.g[FEED_MODE] else { return };
        let mode = match code {
            930 => FeedMode::Inverse,
            950 => FeedMode::PerTurn,
            _ => FeedMode::PerMinute,
        };
        let modal = &mut self.core.state.modal;
        // A feed of one mode means nothing in another.
        if modal.feed_mode != mode {
            modal.feed = None;
        }
        modal.feed_mode = mode;
    }

    /// G20 and G21, before F: a feed in the same block is in the new unit.
    pub(super) fn unit(&mut self, g: &Gathered) -> Result<(), Stop> {
        let Some(code) = g.g[UNITS] else { return Ok(()) };
        let unit = if matches!(code, 200 | 700) { LinearUnit::Inch } else { LinearUnit::Mm };
        let modal = &mut self.core.state.modal;
        modal.unit_said = true;
        if modal.unit != unit {
            if self.core.compensator.is_some() {
                return Err(self.not_compensated("another unit"));
            }
            self.core.state.modal.unit = unit;
            self.core.refresh();
        }
        Ok(())
    }

    /// S: told when it changes.
    pub(super) fn take_speed(&mut self, g: &Gathered) {
        let Some(rpm) = g.get(b'S') else { return };
        // S beside G4 is a time on some controllers; it is a speed here.
        if rpm != self.core.state.modal.rpm {
            self.core.state.modal.rpm = rpm;
            self.emit(Command::Spindle { number: SPINDLE_NUMBER, rpm });
        }
    }

    pub(super) fn spindle(&mut self, g: &Gathered) -> Result<(), Stop> {
        let turn = match g.m[SPINDLE] {
            Some(3) => Turn::Clockwise,
            Some(4) if self.core.options.laser => Turn::Dynamic,
            Some(4) => Turn::Counterclockwise,
            Some(5) => Turn::Off,
            Some(_) => {
                let hint = "the spindle here cannot stop at an angle";
                return Err(self.fail(Code::NotSupported, "M19 cannot be carried out", hint));
            }
            None => return Ok(()),
        };
        self.ask_spindle(turn)?;
        self.turn_spindle(turn);
        Ok(())
    }

    /// The spindle starts only when the operator says so, unless it counts as active.
    fn ask_spindle(&mut self, turn: Turn) -> Result<(), Stop> {
        if !self.core.would_ask_spindle(turn) {
            return Ok(());
        }
        if self.host.stored(SPINDLE_STATUS).is_some_and(|v| v.trim() == "1") {
            return Ok(());
        }
        self.hold_for(QuestionKind::Spindle, "The spindle is about to start.", None)?;
        self.host.store(SPINDLE_STATUS, Some("1"));
        Ok(())
    }

    /// Turns the spindle and the output that follows it.
    pub(super) fn turn_spindle(&mut self, turn: Turn) {
        let before = std::mem::replace(&mut self.core.state.modal.turn, turn);
        if before != turn {
            self.emit(Command::SpindleTurn { number: SPINDLE_NUMBER, turn });
        }
        let (on, number) = (turn != Turn::Off, self.core.options.spindle_output);
        if number > 0 && on != (before != Turn::Off) {
            self.emit(Command::Output { number, on });
        }
    }

    pub(super) fn coolant(&mut self, g: &Gathered) {
        let modal = &self.core.state.modal;
        let mut wanted = (modal.mist, modal.flood);
        if g.m[COOLANT] == Some(9) {
            wanted = (false, false);
        }
        if g.m[MIST].is_some() {
            wanted.0 = true;
        }
        if g.m[COOLANT] == Some(8) {
            wanted.1 = true;
        }
        self.set_coolant(wanted.0, wanted.1);
    }

    pub(super) fn set_coolant(&mut self, mist: bool, flood: bool) {
        let modal = &mut self.core.state.modal;
        if (modal.mist, modal.flood) != (mist, flood) {
            (modal.mist, modal.flood) = (mist, flood);
            self.emit(Command::Coolant { mist, flood });
        }
    }

    pub(super) fn overrides(&mut self, g: &Gathered) {
        let Some(code) = g.m[OVERRIDE] else { return };
        let on = g.get(b'P').is_none_or(|p| p != 0.0);
        let modal = &mut self.core.state.modal;
        let before = modal.overrides;
        match code {
            48 => modal.overrides = [true; 2],
            49 => modal.overrides = [false; 2],
            50 => modal.overrides[0] = on,
            51 => modal.overrides[1] = on,
            // Adaptive feed and feed stop come from the machine, not from the program.
            _ => {}
        }
        let [feed, spindle] = modal.overrides;
        if modal.overrides != before {
            self.emit(Command::Overrides { feed, spindle });
        }
    }

    /// G4: P in seconds; X and S as some controllers write it.
    pub(super) fn dwell(&mut self, g: &Gathered) {
        let seconds = g.get(b'P').or(g.get(b'X')).or(g.get(b'S')).unwrap_or_default();
        if seconds > 0.0 {
            self.emit(Command::Wait { seconds });
        }
    }

    pub(super) fn path_control(&mut self, g: &Gathered) {
        let unit = self.core.state.modal.unit.mm();
        let path = match g.g[PATH] {
            Some(610) => PathControl::ExactPath,
            Some(611) => PathControl::ExactStop,
            Some(_) => PathControl::Blend {
                tolerance_mm: g.get(b'P').map(|p| p * unit),
                merge_mm: g.get(b'Q').or(g.get(b'P')).map(|q| q * unit),
            },
            None => return,
        };
        if self.core.state.modal.path != path {
            self.core.state.modal.path = path;
            self.emit(Command::PathControl(path));
        }
    }

    /// M70 … M73.
    pub(super) fn keep_modes(&mut self, g: &Gathered) -> Result<(), Stop> {
        let Some(code) = g.m[STATE] else { return Ok(()) };
        let modal = Box::new(self.core.state.modal.clone());
        match code {
            70 => *self.kept() = Some(modal),
            71 => *self.kept() = None,
            72 => match self.kept().clone() {
                Some(kept) => self.restore_modes(&kept),
                None => {
                    return Err(self.fail(Code::BadFlow, "M72 without M70", "M70 keeps the modes"));
                }
            },
            _ => {
                let Some(call) = self.core.calls.last_mut().filter(|_| true) else { return Ok(()) };
                call.kept = Some(modal);
                call.restore = true;
            }
        }
        Ok(())
    }

    fn kept(&mut self) -> &mut Option<Box<super::Modal>> {
        let core = &mut *self.core;
        match core.calls.last_mut() {
            Some(call) => &mut call.kept,
            None => &mut core.kept,
        }
    }

    /// Brings modes back: what the machine should know is told.
    pub(super) fn restore_modes(&mut self, kept: &super::Modal) {
        let modal = &mut self.core.state.modal;
        let (rpm, motion) = (kept.rpm, modal.motion);
        let (turn, mist, flood) = (kept.turn, kept.mist, kept.flood);
        let now = modal.clone();
        *modal = kept.clone();
        (modal.turn, modal.mist, modal.flood) = (now.turn, now.mist, now.flood);
        (modal.motion, modal.compensation, modal.rpm) = (motion, now.compensation, now.rpm);
        let (path, overrides) = (modal.path, modal.overrides);
        if path != now.path {
            self.emit(Command::PathControl(path));
        }
        if overrides != now.overrides {
            self.emit(Command::Overrides { feed: overrides[0], spindle: overrides[1] });
        }
        if rpm != now.rpm {
            self.core.state.modal.rpm = rpm;
            self.emit(Command::Spindle { number: SPINDLE_NUMBER, rpm });
        }
        self.turn_spindle(turn);
        self.set_coolant(mist, flood);
        self.relocate();
    }

    /// Warns that a unit holds though the file never said it: told once, at the first motion.
    pub(super) fn doubt_unit(&mut self) {
        if self.core.state.modal.unit_said || std::mem::replace(&mut self.core.told.units, true) {
            return;
        }
        let options = &self.core.options;
        if options.dialect.is_of_grbl() || options.keep_modes || options.unit_known {
            return;
        }
        let (name, code, other) = match self.core.state.modal.unit {
            LinearUnit::Inch => ("inches", "G20", "G21 if its numbers are millimetres"),
            LinearUnit::Mm => ("millimetres", "G21", "G20 if its numbers are inches"),
        };
        let message = format!("the file does not say its unit; it is read in {name}");
        self.warn(
            Code::UnitsNeverSaid,
            message,
            format!("write {code} at its beginning if that is right, {other}"),
        );
    }
}
