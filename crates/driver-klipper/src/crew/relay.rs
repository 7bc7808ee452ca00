//! Relays the stop of one board to the others; a board that is not heard lets the others' deadlines pass.

use super::Crew;
use super::member::Member;
use crate::board::{Ended, Home};
use crate::setup::own;

/// Time behind the beginning from which each board has to be heard: its reports have begun by then, seconds.
const HEARD_S: f64 = 0.6;
/// Share of the deadline for which a board that moves is not heard before it counts as lost: more than its answers are
/// apart.
const SILENT: f64 = 0.8;

/// A switch of one board that stops motors of another one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Away {
    /// Board of the switch, and the place of its home there.
    from: (usize, usize),
    /// Board of the motors, and the place of their list there.
    to: (usize, usize),
}

/// The switches of homes that stop motors of other boards, in the order of [`Member::holds`].
pub fn away(homes: &[Home], members: &[Member]) -> Vec<Away> {
    let mut found = Vec::new();
    let mut places = vec![(0, 0); members.len()];
    for home in homes {
        let is_from = |it: &Member| own(&it.share.switches, home.switch).is_some();
        let Some(from) = members.iter().position(is_from) else { continue };
        for (to, member) in members.iter().enumerate().filter(|(to, _)| *to != from) {
            if member.share.motors.iter().any(|motor| home.motors.contains(motor)) {
                found.push(Away { from: (from, places[from].0), to: (to, places[to].1) });
                places[to].1 += 1;
            }
        }
        places[from].0 += 1;
    }
    found
}

impl Crew {
    /// Relays what stops one board to the others.
    pub(super) fn relay(&mut self, now_s: f64) {
        if !self.moving || self.members.len() < 2 {
            return;
        }
        for Away { from, to } in &self.away {
            if self.members[from.0].board.has_touched(from.1) {
                // One that is not there has stopped.
                self.members[to.0].board.touch_away(to.1).ok();
            }
        }
        let stops = self.stops();
        let expires = self.is_lost(now_s);
        for member in self.members.iter_mut().filter(|member| member.board.is_moving()) {
            member.board.let_expire(expires);
            if let Some(why) = stops {
                member.board.stop_as(why).ok();
            }
        }
        self.moving = !self.is_at_rest();
    }

    /// The way in which all others stop, because of one that was stopped.
    fn stops(&self) -> Option<Ended> {
        let why = |member: &Member| member.ended.or_else(|| member.board.stops());
        let is_found = |member: &Member| {
            why(member) == Some(Ended::Touched) && member.board.is_sought() == Some(true)
        };
        let broken = self.members.iter().filter(|member| !is_found(member)).filter_map(why);
        let broken = broken.filter(|why| *why != Ended::Rested).max_by_key(|why| weight(*why));
        if let Some(why) = broken {
            let relayed = matches!(why, Ended::Touched | Ended::Guarded);
            return Some(if relayed { why } else { Ended::Asked });
        }
        let mut seek = self.members.iter().filter(|it| it.board.is_sought().is_some()).peekable();
        seek.peek()?;
        seek.all(is_found).then_some(Ended::Touched)
    }

    fn is_lost(&self, now_s: f64) -> bool {
        let silent_s = SILENT * self.deadline_s;
        now_s > self.begins_s + HEARD_S
            && self.boards().any(|board| board.is_moving() && board.unheard_s(now_s) > silent_s)
    }
}

/// Of two ends the one that tells more.
pub const fn weight(why: Ended) -> u8 {
    match why {
        Ended::Rested => 0,
        Ended::Touched => 1,
        Ended::Asked => 2,
        Ended::Guarded => 3,
        Ended::Late => 4,
        Ended::Deadline => 5,
        Ended::Shutdown => 6,
    }
}
