//! News of several boards as those of one machine.

use super::Crew;
use super::relay::weight;
use crate::board::{Ended, Fault, News};
use crate::setup::own;
use crate::tmc::Trouble;

impl Crew {
    /// Takes the news of the boards.
    pub(super) fn gather(&mut self) {
        for n in 0..self.members.len() {
            while let Some(news) = self.members[n].board.news() {
                self.tell(n, news);
            }
        }
        self.end_together();
    }

    fn tell(&mut self, n: usize, news: News) {
        let member = &mut self.members[n];
        let share = &member.share;
        let whole = |list: &[usize], own: usize| list.get(own).copied().unwrap_or_default();
        let news = match news {
            News::Ready { version, counts } => {
                (member.version, member.counts) = (Some(version), counts);
                return self.ready();
            }
            News::Ended { why, counts } => {
                (member.ended, member.counts) = (Some(why), counts);
                return;
            }
            News::Touched { switch, clock, .. } => {
                let (switch, clock) = (whole(&share.switches, switch), member.back(clock));
                News::Touched { switch, clock, counts: self.counts_at(clock) }
            }
            News::Switch { switch, on } => {
                News::Switch { switch: whole(&share.switches, switch), on }
            }
            News::Buttons(states) => News::Buttons(self.buttons(n, states)),
            News::Voltage { voltage, mut all } => {
                all.iter_mut().for_each(|it| it.clock = member.back(it.clock));
                News::Voltage { voltage: whole(&share.voltages, voltage), all }
            }
            News::Register { driver, register, value } => {
                News::Register { driver: whole(&share.drivers, driver), register, value }
            }
            News::Driver(trouble) => {
                News::Driver(Trouble { name: self.named(n, trouble.name), ..trouble })
            }
            News::Shutdown(reason) => News::Shutdown(self.named(n, reason)),
            News::Fault(fault) if self.members.len() > 1 => {
                let board = self.members[n].name.clone();
                News::Fault(Fault::OnBoard { board, fault: Box::new(fault) })
            }
            News::Fault(fault) => News::Fault(fault),
        };
        self.news.push_back(news);
    }

    fn named(&self, n: usize, words: String) -> String {
        match self.members.len() {
            1 => words,
            _ => format!("board {}: {words}", self.members[n].name),
        }
    }

    /// All boards are ready: tells that once.
    fn ready(&mut self) {
        let versions: Option<Vec<_>> = self.members.iter().map(|it| it.version.clone()).collect();
        if let Some(mut versions) = versions {
            versions.dedup();
            let counts = self.counts();
            self.news.push_back(News::Ready { version: versions.join(" + "), counts });
        }
    }

    /// Tells the end of motion once it is over on all boards.
    fn end_together(&mut self) {
        if self.members.iter().all(|member| member.ended.is_none()) || !self.is_at_rest() {
            return;
        }
        let homing = self.members.iter().any(|member| member.board.is_sought().is_some());
        let told = |member: &mut super::Member| {
            let seeks = member.board.is_sought().is_some();
            // A search that came to its end without its switch tells more than one that was ended for it.
            let vain = |why| u8::from(homing && seeks && why == Ended::Rested);
            let why = member.ended.take()?;
            Some((weight(why).max(2 * vain(why)), why))
        };
        let ends = self.members.iter_mut().filter_map(told);
        if let Some((_, why)) = ends.max_by_key(|(weight, _)| *weight) {
            let counts = self.counts();
            self.news.push_back(News::Ended { why, counts });
        }
    }

    /// Steps of all motors, as their boards told last.
    fn counts(&self) -> Vec<i64> {
        self.of_motors(|member, motor| member.counts.get(motor).copied())
    }

    /// Counts of all motors at a clock of the first board, if they made all that they were told.
    fn counts_at(&self, clock: u64) -> Vec<i64> {
        self.of_motors(|member, motor| member.board.count_at(motor, member.clock(clock)))
    }

    fn of_motors(&self, count: impl Fn(&super::Member, usize) -> Option<i64>) -> Vec<i64> {
        let motors = self.members.iter().map(|member| member.share.motors.len()).sum();
        let of = |whole: usize| {
            let count = |it: &super::Member| count(it, own(&it.share.motors, whole)?);
            self.members.iter().find_map(count).unwrap_or_default()
        };
        (0..motors).map(of).collect()
    }

    /// States of all inputs, a bit each, with those of a board as it tells them.
    fn buttons(&mut self, n: usize, states: u8) -> u8 {
        let bit = |n: usize| 1_u8.checked_shl(n as u32).unwrap_or_default();
        for (own, whole) in self.members[n].share.buttons.iter().enumerate() {
            let is_on = states & bit(own) != 0;
            self.pressed =
                if is_on { self.pressed | bit(*whole) } else { self.pressed & !bit(*whole) };
        }
        self.pressed
    }
}
