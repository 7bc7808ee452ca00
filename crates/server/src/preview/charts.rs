//! The timing charts that somebody waits for, each made once for everybody who asked for that one.

use crate::locks::lock;
use kerf_wire::Problem;
use kerf_wire::preview::Timing;
use std::collections::VecDeque;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};
use tokio::sync::watch;

/// A chart, or why there is none.
pub type Answer = Result<Arc<Timing>, Problem>;

/// Most charts that are made at a time: each keeps a thread.
const MOST: usize = 3;

/// The charts that are made, the one asked for first in front.
#[derive(Debug, Default)]
pub struct Charts {
    waited_for: Mutex<VecDeque<Arc<Chart>>>,
}

/// Request for a chart.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Asked {
    /// The key of the preview.
    pub key: String,
    /// Changes of the inputs.
    pub inputs: String,
}

/// A chart that somebody waits for.
#[derive(Debug)]
pub struct Chart {
    asked: Asked,
    /// Nobody waits for it any more.
    pub given_up: Arc<AtomicBool>,
    waiting: AtomicUsize,
    made: watch::Sender<Option<Answer>>,
}

/// A request that waits for a chart; without any the chart is given up.
#[derive(Debug)]
pub struct Waiting(Arc<Chart>);

impl Drop for Waiting {
    fn drop(&mut self) {
        if self.0.waiting.fetch_sub(1, Ordering::AcqRel) == 1 {
            self.0.given_up.store(true, Ordering::Relaxed);
        }
    }
}

impl Waiting {
    /// The chart, as soon as it is there.
    pub async fn answer(&self) -> Option<Answer> {
        let mut made = self.0.made.subscribe();
        made.wait_for(Option::is_some).await.ok()?.clone()
    }
}

impl Charts {
    /// Waits for a chart, which is to be made where nobody has asked for it yet. Where too many are waited for the
    /// oldest is given up.
    pub fn ask(&self, asked: Asked) -> (Waiting, Option<Arc<Chart>>) {
        let mut charts = lock(&self.waited_for);
        if let Some(waiting) = charts.iter().find_map(|chart| chart.joined(&asked)) {
            return (waiting, None);
        }
        let chart = Arc::new(Chart::new(asked));
        charts.push_back(chart.clone());
        if charts.len() > MOST {
            give_up(charts.pop_front());
        }
        (Waiting(chart.clone()), Some(chart))
    }

    /// Gives up all that are being made.
    pub fn give_up(&self) {
        give_up(lock(&self.waited_for).drain(..));
    }

    /// Tells everybody who waits for it.
    pub fn made(&self, chart: &Arc<Chart>, answer: Answer) {
        lock(&self.waited_for).retain(|other| !Arc::ptr_eq(other, chart));
        chart.made.send_replace(Some(answer));
    }
}

fn give_up(charts: impl IntoIterator<Item = Arc<Chart>>) {
    for chart in charts {
        chart.given_up.store(true, Ordering::Relaxed);
    }
}

impl Chart {
    fn new(asked: Asked) -> Self {
        let made = watch::Sender::new(None);
        Self { asked, given_up: Arc::default(), waiting: AtomicUsize::new(1), made }
    }

    /// One more waits for this chart, if it is the one that is asked for and will be made.
    fn joined(self: &Arc<Self>, asked: &Asked) -> Option<Waiting> {
        let is_this = self.asked == *asked && !self.given_up.load(Ordering::Relaxed);
        let more = |waiting: usize| (waiting > 0).then_some(waiting + 1);
        let joins = || self.waiting.fetch_update(Ordering::AcqRel, Ordering::Acquire, more).is_ok();
        (is_this && joins()).then(|| Waiting(self.clone()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn asked(inputs: &str) -> Asked {
        Asked { key: "a-1".into(), inputs: inputs.into() }
    }

    fn is_given_up(chart: Option<&Arc<Chart>>) -> Option<bool> {
        chart.map(|chart| chart.given_up.load(Ordering::Relaxed))
    }

    #[test]
    fn who_asks_for_the_same_waits_for_the_same_and_the_last_who_goes_gives_it_up() {
        let charts = Charts::default();
        let (first, chart) = charts.ask(asked(""));
        let (second, again) = charts.ask(asked(""));
        assert!(again.is_none(), "made twice");
        drop(first);
        assert_eq!(is_given_up(chart.as_ref()), Some(false));
        drop(second);
        assert_eq!(is_given_up(chart.as_ref()), Some(true));
        assert!(charts.ask(asked("")).1.is_some(), "nobody makes one that was given up");
    }

    #[test]
    fn a_chart_is_made_whatever_else_is_asked_for_until_too_many_are_waited_for() {
        let charts = Charts::default();
        let (_first, chart) = charts.ask(asked(""));
        let others: Vec<_> = (1..MOST).map(|n| charts.ask(asked(&format!("{n}@1=1")))).collect();
        assert_eq!(is_given_up(chart.as_ref()), Some(false));
        let (_last, last) = charts.ask(asked("3@2=1"));
        assert_eq!(is_given_up(chart.as_ref()), Some(true));
        assert!(others.iter().all(|(_, other)| is_given_up(other.as_ref()) == Some(false)));
        charts.give_up();
        assert_eq!(is_given_up(last.as_ref()), Some(true));
    }
}
