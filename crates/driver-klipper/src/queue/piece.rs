//! A piece of motion and the way to rest behind it.

use super::{Change, Refused, Release, due};
use crate::compress::{Compressor, Steps};

/// A step of a motor as it is planned, or several at even times.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// Clock of the last of them, with its fraction.
    pub clock: f64,
    /// The motor's count rises.
    pub forward: bool,
    /// Number of steps: one where each is planned.
    pub count: u16,
}

/// A piece of motion: it begins where the one before ends.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Piece {
    /// Steps of each motor, in order of time.
    pub steps: Vec<Vec<Step>>,
    /// Changes of outputs, in order of time.
    pub changes: Vec<Change>,
    /// Its end.
    pub ends: u64,
    /// The steps that bring each motor to rest from there; none where they stand.
    pub tail: Vec<Vec<Step>>,
    /// Changes of outputs on the way to rest.
    pub tail_changes: Vec<Change>,
    /// End of the tail.
    pub rests: u64,
}

/// A piece as it is told to the board.
#[derive(Clone, Debug)]
pub(super) struct Prepared {
    pub starts: u64,
    pub ends: u64,
    pub releases: Vec<Release>,
    /// State of compression behind it.
    pub behind: Vec<Compressor>,
    /// The way to rest, where the motors do not stand at its end.
    pub tail: Option<Box<Prepared>>,
}

impl Prepared {
    pub fn new(piece: &Piece, starts: u64, before: &[Compressor]) -> Result<Self, Refused> {
        if piece.steps.len() != before.len() || ![0, before.len()].contains(&piece.tail.len()) {
            return Err(Refused::Motors);
        }
        let span = [starts, piece.ends];
        let mut prepared = Self::of(&piece.steps, span, before)?;
        prepared.switch(&piece.changes)?;
        if piece.tail.iter().any(|steps| !steps.is_empty()) || !piece.tail_changes.is_empty() {
            let mut tail = Self::of(&piece.tail, [piece.ends, piece.rests], &prepared.behind)?;
            tail.switch(&piece.tail_changes)?;
            prepared.tail = Some(Box::new(tail));
        }
        Ok(prepared)
    }

    /// Outputs change within it.
    fn switch(&mut self, changes: &[Change]) -> Result<(), Refused> {
        let inside = |change: &Change| (self.starts..=self.ends).contains(&change.clock);
        if !changes.iter().all(inside) {
            return Err(Refused::Order);
        }
        self.releases.extend(changes.iter().copied().map(Release::Output));
        self.releases.sort_by_key(due);
        Ok(())
    }

    fn of(motors: &[Vec<Step>], span: [u64; 2], before: &[Compressor]) -> Result<Self, Refused> {
        if span[1] < span[0] {
            return Err(Refused::Order);
        }
        let (mut behind, mut releases) = (before.to_vec(), Vec::new());
        for (motor, (steps, compressor)) in motors.iter().zip(&mut behind).enumerate() {
            let commands = compressed(steps, span, compressor)?;
            releases.extend(commands.into_iter().map(|steps| Release::Steps { motor, steps }));
        }
        releases.sort_by_key(due);
        Ok(Self { starts: span[0], ends: span[1], releases, behind, tail: None })
    }
}

fn compressed(
    steps: &[Step],
    [starts, ends]: [u64; 2],
    compressor: &mut Compressor,
) -> Result<Vec<Steps>, Refused> {
    let (mut commands, mut since) = (Vec::new(), starts as f64);
    for step in steps {
        if !(since..=ends as f64).contains(&step.clock) {
            return Err(Refused::Order);
        }
        since = step.clock;
        compressor.push_even(step.clock, step.forward, step.count, &mut commands)?;
    }
    compressor.finish(&mut commands)?;
    Ok(commands)
}
