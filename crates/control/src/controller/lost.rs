//! Reopening of a line that broke during a run: a pulled cable, a network that is down.

use super::Connection;
use super::socket::Opens;
use kerf_transport::Line;
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::thread::{sleep, spawn};
use std::time::Duration;

/// Time limit for a broken line to come back, seconds.
const GONE_S: f64 = 10.0;

/// Interval between two attempts to open it, seconds.
const OPEN_S: f64 = 0.25;

/// The loss of a line.
#[derive(Debug)]
pub(super) struct Lost {
    since_s: f64,
    tried_s: f64,
    why: String,
    /// The attempt under way on another thread: a network may take seconds to refuse.
    opening: Option<Opening>,
}

/// A line that another thread opens.
type Opening = Receiver<Result<Box<dyn Line + Send>, String>>;

/// Opens a line on a thread of its own. One that nobody waits for any more is closed when it is open.
fn beside(opens: Opens) -> Opening {
    let (tells, opening) = channel();
    spawn(move || tells.send(opens().map(|(_, line)| line)));
    opening
}

impl Connection {
    /// Sets the function that reopens the line after it breaks.
    pub fn opens_again(&mut self, opens: Opens) {
        self.opens = Some(opens);
    }

    /// The cable is out from now on, for whoever tries what becomes of that.
    pub fn is_unplugged(&mut self) {
        self.line_is_lost("the cable was pulled".into());
    }

    /// The line is gone: for good, where nobody can open it.
    pub(super) fn line_is_lost(&mut self, why: String) {
        let now_s = self.now_s();
        self.stopwatch.skip_stretch();
        self.log.link(&format!("the line is lost: {why}"));
        self.lost = Some(Lost { since_s: now_s, tried_s: now_s, why, opening: None });
        // Whoever holds a port keeps it from coming back under its name.
        self.closes_line();
        if self.opens.is_none() {
            self.is_lost_for_good();
        }
    }

    /// Opens a lost line; returns `true` if it is there again.
    pub(super) fn is_back(&mut self, wait: Duration) -> bool {
        let now_s = self.now_s();
        let (Some(lost), Some(opens)) = (&mut self.lost, &self.opens) else { return false };
        if now_s - lost.since_s > GONE_S {
            self.is_lost_for_good();
            return false;
        }
        let Some(opening) = &lost.opening else {
            sleep(wait);
            let waits = now_s - lost.tried_s < OPEN_S;
            lost.opening = (!waits).then(|| beside(opens.clone()));
            return false;
        };
        let line = match opening.recv_timeout(wait) {
            Ok(Ok(line)) => line,
            Err(RecvTimeoutError::Timeout) => return false,
            Ok(Err(_)) | Err(RecvTimeoutError::Disconnected) => {
                (lost.opening, lost.tried_s) = (None, now_s);
                return false;
            }
        };
        (self.line, self.lost) = (line, None);
        self.log.link("the line is open again");
        let now_s = self.now_s();
        self.link.driver().line_is_back(now_s);
        true
    }

    fn is_lost_for_good(&mut self) {
        let why = self.lost.take().map_or_else(String::new, |lost| lost.why);
        self.log.link(&format!("the line is given up: {why}"));
        self.dead = true;
        self.fail(why, "look at its cable and its power", None, true);
    }
}
