//! Canned cycles: G73, G81 … G89 (RS274/NGC 3.5.16), in any plane.
//!
//! A cycle is a list of moves along the drilling axis, made at each place.

use super::context::{Context, Stop};
use super::state::{FeedMode, Plane};
use crate::syntax::codes::g_name;
use crate::syntax::gathered::Gathered;
use kerf_diag::Code;
use kerf_program::{Command, MoveKind, Turn};
use serde::{Deserialize, Serialize};

/// Height above the last bottom at which a peck begins again: LinuxCNC's 0.010 in.
const AGAIN_MM: f64 = 0.254;
/// Repeats of one block; more is a number out of all proportion.
const MOST_REPEATS: f64 = 100_000.0;
/// Pecks of one hole.
const MOST_PECKS: f64 = 10_000.0;

/// Values that hold from block to block while cycles follow each other. Lengths in mm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Cycle {
    /// Place of the drilling axis before the first of them.
    initial: f64,
    /// The word R as written, in the unit of the plane's axis.
    r: Option<f64>,
    /// The word of the drilling axis.
    depth: Option<f64>,
    p: Option<f64>,
    q: Option<f64>,
    /// I, J and K of G87 as written.
    #[serde(default)]
    beside: [Option<f64>; 3],
    /// The axis that it drills along.
    #[serde(default = "usual_axis")]
    axis: usize,
}

const fn usual_axis() -> usize {
    2
}

/// One hole.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub(super) struct Hole {
    code: i32,
    /// Axes of the plane, the drilling one last.
    axes: [usize; 3],
    /// Which way is out of the hole: 1, or −1 where FP mirrors the drilling axis.
    out: f64,
    r: f64,
    bottom: f64,
    clear: f64,
    dwell: f64,
    peck: f64,
    /// Place where G87 goes in, from the hole.
    beside: [f64; 2],
    /// Place that G87 bores to.
    middle: f64,
}

impl Hole {
    /// Returns `true` if a place lies farther out of the hole than another.
    fn is_above(&self, place: f64, other: f64) -> bool {
        (place - other) * self.out > 0.0
    }

    /// A place so far below another.
    const fn below(&self, place: f64, distance: f64) -> f64 {
        place - distance * self.out
    }

    /// The higher of two places.
    fn higher(&self, a: f64, b: f64) -> f64 {
        if self.is_above(b, a) { b } else { a }
    }
}

impl Context<'_> {
    pub(super) fn cycle(&mut self, g: &Gathered, code: i32) -> Result<(), Stop> {
        if self.core.compensator.is_some() {
            return Err(self.not_compensated("a canned cycle"));
        }
        if self.core.state.modal.feed_mode == FeedMode::Inverse {
            let message = format!("{} while G93 holds", g_name(code));
            return Err(self.fail(
                Code::ModalConflict,
                message,
                "write G94 and F before the cycle",
            ));
        }
        let axes = self.core.state.modal.plane.axes();
        let letters = axes.map(|a| b"XYZ"[a]);
        let here = self.core.place_of(self.core.position).0[axes[2]];
        let mut cycle = self.core.cycle.filter(|cycle| cycle.axis == axes[2]).unwrap_or(Cycle {
            initial: here,
            r: None,
            depth: None,
            p: None,
            q: None,
            beside: [None; 3],
            axis: axes[2],
        });
        cycle.r = g.get(b'R').or(cycle.r);
        cycle.depth = g.get(letters[2]).or(cycle.depth);
        cycle.p = g.get(b'P').or(cycle.p);
        cycle.q = g.get(b'Q').or(cycle.q);
        for (word, letter) in cycle.beside.iter_mut().zip(*b"IJK") {
            *word = g.get(letter).or(*word);
        }
        let hole = self.hole(code, &cycle)?;
        self.core.cycle = Some(cycle);
        let times = g.get(b'L').unwrap_or(1.0);
        if times.fract() != 0.0 || !(0.0..=MOST_REPEATS).contains(&times) {
            let message = format!("L of a cycle is how often it is made, not {times}");
            return Err(self.fail(Code::OutOfRange, message, "L is a whole number from 1"));
        }
        if code == 880 && times > 1.0 {
            let message = "G88 is repeated by L";
            let hint = "it asks at each hole: write each hole on a line of its own";
            return Err(self.fail(Code::OutOfRange, message, hint));
        }
        self.repeat_hole(g, &hole, times as u32, cycle.initial)
    }

    /// The heights of a hole.
    fn hole(&self, code: i32, cycle: &Cycle) -> Result<Hole, Stop> {
        let modal = &self.core.state.modal;
        let axes = modal.plane.axes();
        let scale = self.core.scale[axes[2]];
        let letter = ['X', 'Y', 'Z'][axes[2]];
        let (Some(r), Some(depth)) = (cycle.r, cycle.depth) else {
            let what = if cycle.r.is_none() { 'R' } else { letter };
            let message = format!("{} without {what}", g_name(code));
            let hint =
                format!("a cycle needs {letter} for the bottom and R for the height it begins at");
            return Err(self.fail(Code::MissingWord, message, hint));
        };
        let (r, bottom) = if modal.relative {
            // R counts from where the first of the cycles began, as LinuxCNC has it.
            (cycle.initial + r * scale, cycle.initial + (r + depth) * scale)
        } else {
            (r * scale, depth * scale)
        };
        if (r - bottom) * scale < 0.0 {
            let message = format!("R lies below {letter}");
            return Err(self.fail(Code::OutOfRange, message, "a cycle drills down from R"));
        }
        let peck = cycle.q.unwrap_or_default() * self.core.state.modal.unit.mm();
        let one_peck = cycle.q == Some(0.0) && self.core.options.dialect.is_lenient();
        if matches!(code, 730 | 830) && peck <= 0.0 && !one_peck {
            let name = g_name(code);
            let message = match cycle.q {
                None => format!("{name} without Q"),
                Some(q) => format!("{name} with a Q of {q}"),
            };
            let hint = "Q is the depth of one peck, above 0; Q0 is one peck with --dialect generic";
            return Err(self.fail(Code::MissingWord, message, hint));
        }
        if peck > 0.0 && (r - bottom).abs() / peck > MOST_PECKS {
            return Err(self.fail(
                Code::OutOfRange,
                "Q is far too small for this depth",
                "Q is the depth of one peck",
            ));
        }
        if cycle.p.is_some_and(|p| p < 0.0) {
            return Err(self.fail(
                Code::OutOfRange,
                "P may not be negative",
                "it is a time in seconds",
            ));
        }
        let (beside, middle) = self.beside(code, cycle, bottom)?;
        let mut hole = Hole {
            code,
            axes,
            out: scale.signum(),
            r,
            bottom,
            clear: r,
            dwell: cycle.p.unwrap_or_default(),
            peck,
            beside,
            middle,
        };
        if !modal.return_to_r {
            hole.clear = hole.higher(cycle.initial, r);
        }
        Ok(hole)
    }

    /// Returns the place where G87 goes in, from the hole, and the height that it bores to. The tool's
    /// nose stands where the spindle stops, so the way beside the hole is not turned by FP.
    fn beside(&self, code: i32, cycle: &Cycle, bottom: f64) -> Result<([f64; 2], f64), Stop> {
        if code != 870 {
            return Ok(([0.0; 2], bottom));
        }
        let [Some(i), Some(j), Some(k)] = cycle.beside else {
            let message = "G87 without I, J or K";
            let hint = "two of them lead beside the hole, where the tool goes in; the one along the \
                        drilling axis is the height that it bores to";
            return Err(self.fail(Code::MissingWord, message, hint));
        };
        let modal = &self.core.state.modal;
        let [u, v, w] = modal.plane.axes();
        let (words, unit) = ([i, j, k], modal.unit.mm());
        let height = words[w] * self.core.scale[w];
        let middle = if modal.relative { bottom + height } else { height };
        Ok(([words[u] * unit, words[v] * unit], middle))
    }

    fn repeat_hole(
        &mut self,
        g: &Gathered,
        hole: &Hole,
        times: u32,
        initial: f64,
    ) -> Result<(), Stop> {
        let mut places = g.clone();
        places.clear(b"XYZ"[hole.axes[2]]);
        // It rises before it travels: R may be higher than that of the hole before.
        let here = self.core.place_of(self.core.position).0[hole.axes[2]];
        if hole.is_above(hole.r, here) || hole.is_above(hole.r, initial) {
            self.along(hole, MoveKind::Jog, hole.r)?;
        }
        for _ in 0..times {
            let to = self.target(&places)?;
            self.line(MoveKind::Jog, to)?;
            self.along(hole, MoveKind::Jog, hole.r)?;
            self.drill(hole)?;
        }
        Ok(())
    }

    /// A move of the drilling axis to a place, mm.
    fn along(&mut self, hole: &Hole, kind: MoveKind, place: f64) -> Result<(), Stop> {
        self.go(kind, &[(hole.axes[2], place)])
    }

    fn go(&mut self, kind: MoveKind, places: &[(usize, f64)]) -> Result<(), Stop> {
        let to = self.core.moved(self.core.position, places.iter().copied());
        match kind {
            MoveKind::Jog => self.line(kind, to),
            MoveKind::Cut => {
                let feed = self.feed(self.core.position, to)?;
                self.line_at(kind, to, feed)
            }
        }
    }

    fn wait(&mut self, seconds: f64) {
        if seconds > 0.0 {
            self.emit(Command::Wait { seconds });
        }
    }

    /// The moves of one hole, from R on.
    fn drill(&mut self, hole: &Hole) -> Result<(), Stop> {
        match hole.code {
            730 | 830 => self.peck(hole)?,
            870 => return self.bore_from_behind(hole),
            _ => self.along(hole, MoveKind::Cut, hole.bottom)?,
        }
        if matches!(hole.code, 820 | 840 | 860 | 880 | 890) {
            self.wait(hole.dwell);
        }
        match hole.code {
            840 => self.tap(hole),
            890 => self.along(hole, MoveKind::Cut, hole.clear),
            850 => {
                self.along(hole, MoveKind::Cut, hole.r)?;
                self.along(hole, MoveKind::Jog, hole.clear)
            }
            860 => self.retract_stopped(hole),
            880 => self.ask_to_retract(hole),
            _ => self.along(hole, MoveKind::Jog, hole.clear),
        }
    }

    /// G73 breaks the chip, G83 brings it out.
    fn peck(&mut self, hole: &Hole) -> Result<(), Stop> {
        if hole.peck <= 0.0 {
            return self.along(hole, MoveKind::Cut, hole.bottom);
        }
        let mut depth = hole.below(hole.r, hole.peck);
        while hole.is_above(depth, hole.bottom) {
            self.along(hole, MoveKind::Cut, depth)?;
            if hole.code == 830 {
                self.along(hole, MoveKind::Jog, hole.r)?;
            }
            let again = hole.below(depth, -AGAIN_MM);
            let again = if hole.is_above(again, hole.r) { hole.r } else { again };
            self.along(hole, MoveKind::Jog, again)?;
            depth = hole.below(depth, hole.peck);
        }
        self.along(hole, MoveKind::Cut, hole.bottom)
    }

    fn spindle_turn(&self, hole: &Hole) -> Result<Turn, Stop> {
        let turn = self.core.state.modal.turn;
        if turn != Turn::Off || self.core.options.dialect.is_lenient() {
            return Ok(turn);
        }
        let message = format!("{} while the spindle stands", g_name(hole.code));
        Err(self.fail(Code::MissingWord, message, "M3 or M4 before the cycle turns it on"))
    }

    fn tap(&mut self, hole: &Hole) -> Result<(), Stop> {
        let turn = self.spindle_turn(hole)?;
        let back = match turn {
            Turn::Clockwise => Turn::Counterclockwise,
            Turn::Counterclockwise => Turn::Clockwise,
            other => other,
        };
        self.turn_spindle(back);
        self.along(hole, MoveKind::Cut, hole.clear)?;
        self.turn_spindle(turn);
        Ok(())
    }

    /// G88: the spindle stands, and the operator retracts; what is left of the way comes with the answer.
    fn ask_to_retract(&mut self, hole: &Hole) -> Result<(), Stop> {
        let turn = self.spindle_turn(hole)?;
        self.core.retracting = Some((*hole, turn));
        self.turn_spindle(Turn::Off);
        self.core.holding = Some("G88: retract by hand, then go on".into());
        Ok(())
    }

    /// Behind the answer: what is left of the way out, and the spindle turns again.
    pub(super) fn retract_by_hand(&mut self) -> Result<(), Stop> {
        let Some((hole, turn)) = self.core.retracting.take() else { return Ok(()) };
        self.along(&hole, MoveKind::Jog, hole.clear)?;
        self.turn_spindle(turn);
        Ok(())
    }

    /// G86: out with the spindle at rest.
    fn retract_stopped(&mut self, hole: &Hole) -> Result<(), Stop> {
        let turn = self.spindle_turn(hole)?;
        self.turn_spindle(Turn::Off);
        self.along(hole, MoveKind::Jog, hole.clear)?;
        self.turn_spindle(turn);
        Ok(())
    }

    /// G87: in beside the hole, up from below.
    fn bore_from_behind(&mut self, hole: &Hole) -> Result<(), Stop> {
        let turn = self.spindle_turn(hole)?;
        let [u, v, _] = hole.axes;
        let place = self.core.place_of(self.core.position);
        let at = [(u, place.0[u]), (v, place.0[v])];
        let beside = [(u, place.0[u] + hole.beside[0]), (v, place.0[v] + hole.beside[1])];
        self.go(MoveKind::Jog, &beside)?;
        self.turn_spindle(Turn::Off);
        self.along(hole, MoveKind::Jog, hole.bottom)?;
        self.go(MoveKind::Jog, &at)?;
        self.turn_spindle(turn);
        self.along(hole, MoveKind::Cut, hole.higher(hole.middle, hole.bottom))?;
        self.along(hole, MoveKind::Cut, hole.bottom)?;
        self.turn_spindle(Turn::Off);
        self.go(MoveKind::Jog, &beside)?;
        self.along(hole, MoveKind::Jog, hole.clear)?;
        self.go(MoveKind::Jog, &at)?;
        self.turn_spindle(turn);
        Ok(())
    }
}

impl Plane {
    /// The axis that cycles drill along.
    pub const fn drilling_axis(self) -> usize {
        self.axes()[2]
    }
}
