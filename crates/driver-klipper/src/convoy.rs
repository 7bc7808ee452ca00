//! Several boards that move one machine: they begin together, and what stops one stops all.
//!
//! Boards do not know each other. So the host relays: a board that stops for whatever reason stops the others at
//! once, and while one of them is not heard, the deadlines of the others are not pushed along: they stop by
//! themselves.

use crate::board::{Board, Home, NotNow};
use crate::timeline::Timeline;

/// Time between the wish to move and the plan's beginning, seconds.
const FIRST_S: f64 = 0.4;
/// Time behind that from which each board has to be heard: its reports have begun by then, seconds.
const HEARD_S: f64 = 0.25;
/// Time after which a board that is not heard while it moves counts as lost, seconds: more than its reports are apart.
const SILENT_S: f64 = 0.08;

/// Motion of several boards, which are lent to each call in the same order.
#[derive(Clone, Debug, Default)]
pub struct Convoy {
    timelines: Vec<Timeline>,
    begins_s: f64,
    /// Motion has begun and is not known to be over.
    moving: bool,
}

impl Convoy {
    /// Motion begins on all boards at once, with the switches of each. They are clocks to each other by the
    /// [`clock`](Self::clock) of each.
    ///
    /// # Errors
    ///
    /// One of the boards cannot be moved now; then none is.
    pub fn start(
        &mut self,
        boards: &mut [&mut Board],
        homes: &[Vec<Home>],
        now_s: f64,
    ) -> Result<(), NotNow> {
        self.begins_s = now_s + FIRST_S;
        let line = |board: &&mut Board| Some(Timeline::new(board.line()?, self.begins_s));
        let timelines: Option<Vec<_>> = boards.iter().map(line).collect();
        self.timelines = timelines.ok_or(NotNow::Busy)?;
        if !boards.iter().all(|board| board.is_at_rest()) {
            return Err(NotNow::Busy);
        }
        for (n, (board, line)) in boards.iter_mut().zip(&self.timelines).enumerate() {
            let homes = homes.get(n).map_or(&[][..], Vec::as_slice);
            board.start_at(homes, line.at(0.0) as u64, now_s)?;
        }
        self.moving = true;
        Ok(())
    }

    /// Clock of a board at a time of the plan, seconds.
    pub fn clock(&self, board: usize, t_s: f64) -> Option<f64> {
        self.timelines.get(board).map(|line| line.at(t_s))
    }

    /// Bends the boards' lines together again, from a time of the plan up to which nothing was handed out: at each
    /// piece.
    pub fn bend(&mut self, boards: &[&mut Board], from_s: f64) {
        for (line, board) in self.timelines.iter_mut().zip(boards) {
            if let Some(clock) = board.line() {
                line.bend(from_s, clock);
            }
        }
    }

    /// Relays what stops one board to the others. To be called whenever a board was heard, or should have been.
    ///
    /// # Errors
    ///
    /// A stop cannot be told.
    pub fn relay(&mut self, boards: &mut [&mut Board], now_s: f64) -> Result<(), NotNow> {
        if !self.moving {
            return Ok(());
        }
        let stops = boards.iter().any(|board| board.is_stopping());
        let watched = now_s > self.begins_s + HEARD_S;
        let lost = watched
            && boards.iter().any(|board| board.is_moving() && board.unheard_s(now_s) > SILENT_S);
        for board in boards.iter_mut().filter(|board| board.is_moving()) {
            board.let_expire(lost);
            if stops {
                board.stop()?;
            }
        }
        self.moving = boards.iter().any(|board| !board.is_at_rest());
        Ok(())
    }
}
