//! F: how fast a cutting move goes.

use super::context::{Context, Stop};
use super::state::{FeedMode, Rates};
use crate::syntax::gathered::Gathered;
use kerf_diag::Code;
use kerf_program::settings::AxisUnit;
use kerf_program::{Axes, Axis, Feed, Settings};

impl Rates {
    /// The rates of an F word; `None` for F0.
    pub(super) fn new(f: f64, unit_mm: f64) -> Option<Self> {
        (f > 0.0).then_some(Self { linear: f * unit_mm, rotary: f })
    }
}

/// The feed of a straight move: F counts along X, Y, Z and other linear axes, or along rotary axes when only
/// they move.
pub(super) fn along(rates: Rates, settings: &Settings, from: Axes, to: Axes) -> Feed {
    let is_linear = |axis: Axis| settings.axis_unit(axis) != AxisUnit::Degrees;
    let linear = Axis::ALL.into_iter().any(|axis| from[axis] != to[axis] && is_linear(axis));
    Feed::Path(if linear { rates.linear } else { rates.rotary } / 60.0)
}

impl Context<'_> {
    /// Takes the F word.
    pub(super) fn take_feed(&mut self, g: &Gathered) -> Result<(), Stop> {
        let modal = &mut self.core.state.modal;
        let Some(f) = g.get(b'F') else {
            // In inverse time every block has its own.
            if modal.feed_mode == FeedMode::Inverse {
                modal.feed = None;
            }
            return Ok(());
        };
        modal.feed = Rates::new(f, modal.unit.mm());
        Ok(())
    }

    /// The feed of a cutting move.
    pub(super) fn feed(&mut self, from: Axes, to: Axes) -> Result<Feed, Stop> {
        let modal = &self.core.state.modal;
        let Some(rates) = modal.feed else { return self.no_feed() };
        match modal.feed_mode {
            FeedMode::PerMinute => Ok(along(rates, &self.core.settings, from, to)),
            FeedMode::Inverse => Ok(Feed::Time(60.0 / rates.rotary)),
            FeedMode::PerTurn if modal.rpm > 0.0 => {
                let Feed::Path(per_turn) = along(rates, &self.core.settings, from, to) else {
                    return Ok(Feed::Axis);
                };
                Ok(Feed::Path(per_turn * modal.rpm))
            }
            FeedMode::PerTurn => {
                let message = "feed per turn, but the spindle has no speed";
                Err(self.fail(Code::FeedMissing, message, "give S before G95 moves"))
            }
        }
    }

    fn no_feed(&mut self) -> Result<Feed, Stop> {
        let inverse = self.core.state.modal.feed_mode == FeedMode::Inverse;
        let (message, hint) = if inverse {
            ("no F in this block", "with G93 every cutting block needs its own F")
        } else {
            ("a cutting move without a feed", "give F in it or before it, as in G1 X10 F600")
        };
        let told = std::mem::replace(&mut self.core.told.feed, true);
        if !self.core.options.speeds_known || inverse {
            // A check tells it once; the rest of the file would only repeat it.
            if told && self.core.options.keep_going {
                return Ok(Feed::Axis);
            }
            return Err(self.fail(Code::FeedMissing, message, hint));
        }
        if !told {
            self.warn(Code::FeedMissing, message, "the speeds of the settings are used");
        }
        Ok(Feed::Axis)
    }
}
