//! F: how fast a cutting move goes.

use super::context::Context;
use super::state::{FeedMode, Modal, Rates};
use super::stop::{Stop, fail};
use crate::syntax::gathered::Gathered;
use kerf_diag::Code;
use kerf_program::settings::AxisUnit;
use kerf_program::{Axes, Axis, Feed, Settings};

/// The feed of a straight move: F counts along X, Y, Z and other linear axes, or along rotary axes when only
/// they move.
pub(super) fn along(rates: Rates, settings: &Settings, from: Axes, to: Axes) -> Feed {
    let is_linear = |axis: Axis| settings.axis_unit(axis) != AxisUnit::Degrees;
    let linear = Axis::ALL.into_iter().any(|axis| from[axis] != to[axis] && is_linear(axis));
    Feed::Path(if linear { rates.linear } else { rates.rotary } / 60.0)
}

/// The feed of one of so many equal parts of a move.
pub(super) fn part(feed: Feed, parts: u32) -> Feed {
    match feed {
        Feed::Time(seconds) => Feed::Time(seconds / f64::from(parts)),
        feed => feed,
    }
}

/// Takes the F word.
pub(super) fn take_feed(modal: &mut Modal, g: &Gathered) {
    match g.get(b'F') {
        Some(f) => modal.feed = Rates::new(f, modal.unit.mm()),
        // In inverse time every block has its own.
        None if modal.feed_mode == FeedMode::Inverse => modal.feed = None,
        None => {}
    }
}

/// The feed of a cutting move from the present place.
pub(super) fn feed(c: &mut Context<'_>, to: Axes) -> Result<Feed, Stop> {
    let modal = &c.core.state.modal;
    let from = c.core.place.programmed;
    let Some(rates) = modal.feed else { return no_feed(c) };
    match modal.feed_mode {
        FeedMode::PerMinute => Ok(along(rates, &c.core.settings, from, to)),
        FeedMode::Inverse => Ok(Feed::Time(60.0 / rates.rotary)),
        FeedMode::PerTurn if modal.rpm > 0.0 => {
            let Feed::Path(per_turn) = along(rates, &c.core.settings, from, to) else {
                return Ok(Feed::Axis);
            };
            Ok(Feed::Path(per_turn * modal.rpm))
        }
        FeedMode::PerTurn => {
            let message = "feed per turn, but the spindle has no speed";
            Err(fail(Code::FeedMissing, message, "give S before G95 moves"))
        }
    }
}

fn no_feed(c: &mut Context<'_>) -> Result<Feed, Stop> {
    let inverse = c.core.state.modal.feed_mode == FeedMode::Inverse;
    let (message, hint) = if inverse {
        ("no F in this block", "with G93 every cutting block needs its own F")
    } else {
        ("a cutting move without a feed", "give F in it or before it, as in G1 X10 F600")
    };
    let told = std::mem::replace(&mut c.core.told.feed, true);
    if !c.core.options.speeds_known || inverse {
        // A check tells it once; the rest of the file would only repeat it.
        if told && c.core.options.keep_going {
            return Ok(Feed::Axis);
        }
        return Err(fail(Code::FeedMissing, message, hint));
    }
    if !told {
        c.warn(Code::FeedMissing, message, "the speeds of the settings are used");
    }
    Ok(Feed::Axis)
}
