//! Overrides of a controller: what was ordered, and what somebody at its own controls has turned them to.

use kerf_machine::driver::{Override, Shares};

/// Shares that hold as far as they were ordered or told, with news of those that were turned at the controller.
#[derive(Debug)]
pub(super) struct Turned {
    /// The share of the speed of cuts, as it was asked for.
    feed: f32,
    shares: Shares,
    /// Shares that somebody at the controller has turned to, and nobody has taken yet.
    by_hand: Option<Shares>,
    /// The feed that comes next was turned at the controller: it holds there already.
    feed_holds: bool,
}

impl Default for Turned {
    fn default() -> Self {
        Self { feed: 1.0, shares: Shares::default(), by_hand: None, feed_holds: false }
    }
}

/// A share in percent, as controllers take it.
fn percent(share: f32) -> u8 {
    (share * 100.0).round().clamp(1.0, 250.0) as u8
}

impl Turned {
    /// Returns the share of the speed of cuts.
    pub const fn feed(&self) -> f32 {
        self.feed
    }

    /// Returns the same in percent, as a controller is told it.
    pub const fn feed_percent(&self) -> u8 {
        self.shares.feed
    }

    /// Returns `true` if motion takes another time than at the speeds asked for.
    pub fn changes_time(&self) -> bool {
        self.feed != 1.0 || self.shares.rapid != 100
    }

    /// The operator turns the feed. Returns `true` if the controller is to be told: what somebody turned there holds already.
    pub fn turn_feed(&mut self, share: f32) -> bool {
        let holds = std::mem::take(&mut self.feed_holds) && self.shares.feed == percent(share);
        if !holds {
            (self.feed, self.shares.feed) = (share, percent(share));
        }
        !holds
    }

    /// The operator turns something else.
    pub const fn turn(&mut self, turned: Override) {
        match turned {
            Override::Rapid(percent) => self.shares.rapid = percent,
            Override::Spindle(percent) => self.shares.spindle = percent,
        }
    }

    /// Learns which shares hold in the controller; others than those that were ordered are news.
    pub fn hear(&mut self, holds: Shares) {
        if holds != self.shares {
            self.feed = f32::from(holds.feed) / 100.0;
            self.shares = holds;
            self.by_hand = Some(holds);
        }
    }

    /// Returns such news, once.
    pub const fn take_news(&mut self) -> Option<Shares> {
        let news = self.by_hand.take();
        self.feed_holds |= news.is_some();
        news
    }

    /// Returns the overrides besides the feed, where a controller that was reset has to be told.
    pub fn to_restore(&self) -> Vec<Override> {
        let Shares { rapid, spindle, .. } = self.shares;
        let both = [Override::Rapid(rapid), Override::Spindle(spindle)];
        if (rapid, spindle) == (100, 100) { Vec::new() } else { both.into() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_ordered_is_no_news_and_what_was_turned_by_hand_is_once() {
        let mut turned = Turned::default();
        assert!(turned.turn_feed(0.5));
        turned.hear(Shares { feed: 50, ..Shares::default() });
        assert_eq!(turned.take_news(), None);
        let by_hand = Shares { feed: 80, rapid: 25, spindle: 100 };
        turned.hear(by_hand);
        turned.hear(by_hand);
        assert_eq!((turned.take_news(), turned.take_news()), (Some(by_hand), None));
        assert!(turned.changes_time());
    }

    #[test]
    fn a_feed_that_was_turned_at_the_controller_is_not_ordered_once_more() {
        let mut turned = Turned::default();
        turned.hear(Shares { feed: 80, ..Shares::default() });
        assert!(turned.take_news().is_some());
        assert!(!turned.turn_feed(0.8), "it holds");
        assert!(turned.turn_feed(0.8), "the operator asks for it by himself");
        assert!(turned.turn_feed(0.9));
    }

    #[test]
    fn a_reset_controller_is_told_what_held() {
        let mut turned = Turned::default();
        assert!(turned.to_restore().is_empty());
        turned.turn(Override::Spindle(70));
        assert_eq!(turned.to_restore(), [Override::Rapid(100), Override::Spindle(70)]);
    }
}
