//! A board of a crew, with its share of the machine.

use crate::board::{Board, Ended, Holds, Home, NotNow, Options};
use crate::queue::{Change, Piece, Refused, Step};
use crate::setup::{Share, own};
use crate::timeline::Timeline;

/// A board of a crew.
pub struct Member {
    /// Its name; empty for the only one.
    pub name: String,
    pub board: Board,
    pub share: Share,
    /// Its clock by that of the first; nothing for the first, and before motion began.
    pub line: Option<Timeline>,
    /// End of the motion that was handed out, own ticks.
    pub ends: u64,
    /// Steps of its motors, as it told last.
    pub counts: Vec<i64>,
    /// Version of the program in it, once it is ready.
    pub version: Option<String>,
    /// The end of its motion, until that of the others is known.
    pub ended: Option<Ended>,
}

impl Member {
    pub fn new(name: String, share: Share, options: Options, now_s: f64) -> Self {
        Self {
            board: Board::new(share.setup.clone(), options, now_s),
            counts: vec![0; share.motors.len()],
            name,
            share,
            line: None,
            ends: 0,
            version: None,
            ended: None,
        }
    }

    /// Its clock at a clock of the first one.
    pub fn clock(&self, first: u64) -> u64 {
        self.line.map_or(first, |line| line.at(first as f64).ceil().max(0.0) as u64)
    }

    /// Clock of the first one at its clock.
    pub fn back(&self, own: u64) -> u64 {
        self.line.map_or(own, |line| line.back(own as f64).round().max(0.0) as u64)
    }

    /// Its motors among those of a list.
    fn motors(&self, of: &[usize]) -> Vec<usize> {
        of.iter().filter_map(|motor| own(&self.share.motors, *motor)).collect()
    }

    /// Its motors that stop by switches of their own.
    pub fn holds(&self, homes: &[Home]) -> Holds {
        let mut holds = Holds::default();
        for home in homes {
            let motors = self.motors(&home.motors);
            match own(&self.share.switches, home.switch) {
                Some(switch) => holds.homes.push(Home { switch, motors, ..*home }),
                None if motors.is_empty() => {}
                None => holds.away.push(motors),
            }
        }
        holds
    }

    pub fn begin(&mut self, holds: &Holds, now_s: f64) -> Result<(), NotNow> {
        self.ended = None;
        self.board.start_at(holds, self.ends, now_s).map(drop)
    }

    /// Takes its part of a piece of the machine's motion.
    pub fn offer(&mut self, piece: &Piece) -> Result<(), Refused> {
        let ends = self.clock(piece.ends);
        let rests = self.clock(piece.rests);
        let own = Piece {
            steps: self.steps(&piece.steps, [self.ends, ends])?,
            changes: self.changes(&piece.changes, [self.ends, ends]),
            ends,
            tail: match piece.tail[..] {
                [] => Vec::new(),
                _ => self.steps(&piece.tail, [ends, rests])?,
            },
            tail_changes: self.changes(&piece.tail_changes, [ends, rests]),
            rests,
        };
        self.board.offer(&own)
    }

    fn steps(&self, all: &[Vec<Step>], span: [u64; 2]) -> Result<Vec<Vec<Step>>, Refused> {
        let [from, to] = span.map(|clock| clock as f64);
        let own = |step: &Step| match self.line {
            Some(line) => Step { clock: line.at(step.clock).clamp(from, to.max(from)), ..*step },
            None => *step,
        };
        let of = |motor: &usize| {
            let steps = all.get(*motor).ok_or(Refused::Motors)?;
            Ok(steps.iter().map(own).collect())
        };
        self.share.motors.iter().map(of).collect()
    }

    fn changes(&self, all: &[Change], [from, to]: [u64; 2]) -> Vec<Change> {
        let own = |change: &Change| {
            let output = own(&self.share.outputs, change.output)?;
            let clock = match self.line {
                Some(_) => self.clock(change.clock).clamp(from, to.max(from)),
                None => change.clock,
            };
            Some(Change { output, clock, ..*change })
        };
        all.iter().filter_map(own).collect()
    }
}
