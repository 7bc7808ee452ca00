//! Movements by hand while a program waits: at the keypad that it opened (SK), or after a stop.
//!
//! They are answers to its question, which is asked again afterwards, until it gets another answer.

use crate::runner::Runner;
use crate::{Going, Wish};
use kerf_motion::{Move, planner};
use kerf_program::{AXES, Axes, Feed, Interpreter, Line, MoveKind};
use std::fmt;

/// A movement for as long as somebody holds a key.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jog {
    /// How far it goes when nobody lets go, mm or degrees.
    pub by: Axes,
    /// Share of the jog speed, 0 … 1.
    pub speed: f64,
}

impl Jog {
    /// Reads `jog 0,-100,0,0,0,0 0.5`.
    pub fn read(words: &str) -> Option<Self> {
        let mut words = words.split(' ');
        let (command, by, speed) = (words.next()?, words.next()?, words.next()?);
        let number = |word: &str| word.parse().ok().filter(|n: &f64| n.is_finite());
        let by: Option<Vec<f64>> = by.split(',').map(number).collect();
        let by: [f64; AXES] = by?.try_into().ok()?;
        let speed = number(speed).filter(|speed| (0.0..=1.0).contains(speed))?;
        let whole = command == "jog" && words.next().is_none();
        whole.then_some(Self { by: Axes(by), speed })
    }
}

impl fmt::Display for Jog {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [x, y, z, a, b, c] = self.by.0;
        write!(f, "jog {x},{y},{z},{a},{b},{c} {}", self.speed)
    }
}

impl<I: Interpreter> Runner<'_, I> {
    /// Moves until the way is made or somebody lets go. Nothing of the program moves. A way that would
    /// leave the table limits is not made.
    pub(crate) fn jog(&mut self, jog: Jog) {
        self.mover.set_position(self.world.machine.position());
        let to = self.world.machine.position().plus(jog.by);
        let line = Line { kind: MoveKind::Jog, to, feed: Feed::Axis };
        let Some(mut made) = self.mover.line(self.last_move, &line) else { return };
        made.speed_mm_s *= jog.speed.max(0.01);
        if self.world.machine.first_outside(&[made]).is_none() && !self.world.machine.draws() {
            self.make_while_held(made);
        }
        self.mover.set_position(self.world.machine.position());
    }

    fn make_while_held(&mut self, made: Move) {
        let t0_s = self.world.machine.begin_motion();
        self.world.tell_log();
        let mut planner = planner(self.world.machine.settings());
        planner.push(made);
        while let Some(mut plan) = planner.finish() {
            let mut let_go = false;
            let mut index = 0;
            while index < plan.moves().len() {
                let (from_s, end_s) = (self.world.now(), t0_s + plan.span_s(index).1);
                let wish = self.pass(from_s, end_s, Some(Going { plan: &plan, index, t0_s }));
                match wish.filter(|_| !let_go) {
                    Some((t_s, Wish::Input { number, on })) => self.press(number, on, t_s),
                    Some((t_s, wish)) => {
                        self.heed_later(t_s, wish);
                        let stopped = planner.stop(plan, (t_s - t0_s).max(0.0), true);
                        let Some((ramp_down, _)) = stopped else { return };
                        (plan, let_go) = (ramp_down, true);
                    }
                    None => {
                        self.make_one(&plan, index, t0_s);
                        index += 1;
                    }
                }
            }
            if let_go {
                break;
            }
        }
        self.world.machine.rest();
        self.world.tell_log();
    }

    /// Letting go is done with; everything else is wanted of the program.
    fn heed_later(&mut self, t_s: f64, wish: Wish) {
        if wish != Wish::End {
            self.postpone((t_s, wish));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_is_read() {
        let jog = Jog { by: Axes([0.0, -100.25, 0.0, 0.0, 3.0, 0.0]), speed: 0.5 };
        assert_eq!(Jog::read(&jog.to_string()), Some(jog));
        let wrong = ["", "jog", "jog 1,2,3 1", "jog 1,2,3,4,5,6", "jog 1,2,3,4,5,inf 1"];
        for words in wrong.into_iter().chain(["jog 0,0,0,0,0,0 2", "nudge 0,0,0,0,0,0 1"]) {
            assert_eq!(Jog::read(words), None, "{words}");
        }
    }
}
