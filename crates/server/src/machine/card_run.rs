//! A file that the controller runs from a card of its own, as pages see and steer it.

use super::board::TELL;
use super::link::Link;
use crate::hub::Hub;
use crate::to_wire;
use kerf_control::OperatorRequest;
use kerf_control::controller::{CardState, CardWish};
use kerf_machine::driver::Override;
use kerf_program::Frame;
use kerf_wire::{CardTask, Change, ControllerCard, CurrentRun, Machine, Motion, Overrides, State};
use std::sync::Arc;
use std::time::{Duration, Instant};

/// Interval at which the progress of a task is told.
const PROGRESS: Duration = Duration::from_millis(150);

/// Share that is told at most of a file that has not ended.
const MOST_DONE: f64 = 0.99;

/// Said while the line to the controller is lost.
const IS_LOST: &str =
    "the line to the controller is lost and is opened again; the file goes on without it";

/// A file that runs from the card.
pub struct CardRun {
    hub: Arc<Hub>,
    link: Arc<Link>,
    frame: Frame,
    /// Estimated time of all of it, seconds; 0 where its text is not known.
    seconds: f64,
    /// The part of that time that is over, seconds; nothing before the first look at a file that somebody else has begun.
    done_s: Option<f64>,
    begun: Instant,
    told: Option<Instant>,
    /// It was told to hold.
    is_held: bool,
}

impl CardRun {
    /// One that begins here just now, or was begun by somebody else.
    pub fn new(
        (hub, link): (Arc<Hub>, Arc<Link>),
        frame: Frame,
        job: &CurrentRun,
        begins: bool,
    ) -> Self {
        let (seconds, begun) = (job.seconds, Instant::now());
        let done_s = begins.then_some(0.0);
        Self { hub, link, frame, seconds, done_s, begun, told: None, is_held: false }
    }

    /// Tells pages where it is, some thirty times a second.
    pub fn tells(&mut self, state: &CardState) {
        let is_new = self.told.is_none_or(|told| told.elapsed() >= TELL);
        if !is_new && self.is_held == state.is_held {
            return;
        }
        let gap_s = self.told.map_or(0.0, |told| told.elapsed().as_secs_f64());
        let went_s = if self.is_held { 0.0 } else { gap_s };
        (self.told, self.is_held) = (Some(Instant::now()), state.is_held);
        let read = state.job.percent.map_or(0.0, |percent| percent / 100.0);
        let feed = self.hub.read(|now| now.overrides.feed_percent) / 100.0;
        let [progress, remaining] = self.passes(went_s, read, feed);
        let frame = &self.frame;
        self.hub.changing(|now| {
            let at = state.place.map_or(now.motion.at, |place| to_wire::positions(frame, place));
            let motion = Motion {
                at,
                progress,
                line: state.job.line.unwrap_or(0),
                remaining,
                elapsed: self.begun.elapsed().as_secs_f64(),
                ..Motion::default()
            };
            let waits = state.waits.map(str::to_owned);
            let machine = Machine {
                state: if state.is_held { State::Held } else { State::Running },
                why: state.is_lost.then(|| IS_LOST.to_owned()).or(waits),
                wants_tool: state.wants_tool,
                ..now.machine.clone()
            };
            let machine = (machine != now.machine).then_some(Change::Machine { machine });
            machine.into_iter().chain([Change::Motion { motion }]).collect()
        });
    }

    /// Time passes in which it goes on, at such a share of its feed. Returns how much of it is done, and the seconds that are
    /// left. A controller reads a short file at once: the share of its bytes tells only where one stands that was begun before.
    fn passes(&mut self, went_s: f64, read: f64, feed: f64) -> [f64; 2] {
        if self.seconds == 0.0 {
            return [read, 0.0];
        }
        let done_s = self.done_s.get_or_insert(self.seconds * read);
        *done_s = (*done_s + went_s * feed).min(self.seconds);
        [(*done_s / self.seconds).min(MOST_DONE), (self.seconds - *done_s) / feed]
    }

    /// Returns what somebody at a page wishes of it. Kerf that ends leaves it alone.
    pub fn wish(&mut self) -> Option<CardWish> {
        let mut wanted = self.link.lock();
        if wanted.leaves {
            return Some(CardWish::Leave);
        }
        if std::mem::take(&mut wanted.resume) && self.is_held {
            return Some(CardWish::Resume);
        }
        if wanted.takes_tool() {
            return Some(CardWish::ToolIn);
        }
        if let Some(turned) = wanted.turns.pop_front() {
            drop(wanted);
            return Some(self.turns(turned));
        }
        let request = wanted.request()?;
        drop(wanted);
        match request {
            OperatorRequest::Stop | OperatorRequest::End | OperatorRequest::GiveUp => {
                Some(CardWish::Stop)
            }
            OperatorRequest::Hold => (!self.is_held).then_some(CardWish::Hold),
            OperatorRequest::Feed(share) => Some(self.feeds(share)),
            // The switches of a real machine are moved where they are.
            OperatorRequest::Input { .. } => None,
        }
    }

    fn feeds(&self, share: f32) -> CardWish {
        let feed_percent = f64::from(share * 100.0).round();
        self.turned(|overrides| Overrides { feed_percent, ..overrides });
        CardWish::Feed(feed_percent as u8)
    }

    fn turns(&self, turned: Override) -> CardWish {
        self.turned(|overrides| match turned {
            Override::Rapid(percent) => Overrides { rapid_percent: Some(percent), ..overrides },
            Override::Spindle(percent) => Overrides { spindle_percent: Some(percent), ..overrides },
        });
        CardWish::Override(turned)
    }

    fn turned(&self, becomes: impl FnOnce(Overrides) -> Overrides) {
        self.hub.changing(|now| vec![Change::Overrides { overrides: becomes(now.overrides) }]);
    }
}

/// Tells pages how far a task on the card is.
pub struct CardProgress {
    hub: Arc<Hub>,
    told: Option<Instant>,
}

impl CardProgress {
    /// Of a task that begins.
    pub const fn new(hub: Arc<Hub>) -> Self {
        Self { hub, told: None }
    }

    /// So many bytes of so many are there; of all of them 0 where that is not known.
    pub fn goes(&mut self, done: usize, all: usize) {
        if done < all && self.told.is_some_and(|told| told.elapsed() < PROGRESS) {
            return;
        }
        self.told = Some(Instant::now());
        self.hub.changing(|now| {
            let card = now.controller_card.clone();
            let task = card.task.clone().map(|task| {
                let all = if all > 0 { all as u64 } else { task.all };
                CardTask { done: done as u64, all, ..task }
            });
            vec![Change::ControllerCard { controller_card: ControllerCard { task, ..card } }]
        });
    }
}
