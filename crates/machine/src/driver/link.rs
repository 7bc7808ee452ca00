//! The near side: orders are kept until they are done.

use super::{ControllerState, Driver, Order, Reply, Sent, Signal, Ticket};
use std::collections::VecDeque;

/// An order that was not taken within this time is sent again, seconds. A controller on a serial line
/// answers within a few milliseconds; a guess.
const PATIENCE_S: f64 = 0.25;

/// Silence after which a controller counts as lost, seconds. A cable that is plugged in anew, a network that looks for
/// its way or a controller that writes its memory take less; what was sent ahead is made meanwhile and nothing else.
const LOST_S: f64 = 10.0;

/// Interval at which a busy controller is asked for its place, seconds.
const ASK_S: f64 = 0.1;

/// State of the link: tells whether the controller can be trusted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LinkState {
    /// It answers.
    Up,
    /// It refused an order: nothing more is sent.
    Refused(Ticket, &'static str),
    /// It does not answer: it was told to stop, and nothing more is sent.
    Lost,
}

/// News from a controller.
#[derive(Clone, Debug, PartialEq)]
pub enum LinkNews {
    /// An order is done.
    Done(Ticket),
    /// An input changed.
    Input {
        /// Its line.
        line: u8,
        /// Its state.
        on: bool,
    },
    /// The state of the link changed.
    State(LinkState),
}

/// Faults that were survived.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Troubles {
    /// Orders sent again.
    pub again: u32,
    /// Replies that came twice, or for orders that are done.
    pub stale: u32,
    /// Replies that could not be read, or that name no order.
    pub garbled: u32,
}

/// A controller with the orders that are under way.
#[derive(Debug)]
pub struct Link<D> {
    driver: D,
    state: LinkState,
    /// The last ticket given.
    given: Ticket,
    /// Every ticket up to this is done.
    done: Ticket,
    /// Every ticket up to this was taken.
    taken: Ticket,
    /// Orders not done, the oldest first.
    open: VecDeque<Sent>,
    /// Every ticket up to this was sent once.
    sent: Ticket,
    /// Time at which orders were sent last.
    sent_s: f64,
    asked_s: f64,
    /// Time for which questions were not answered; a time in which nobody looked for answers is none.
    silent_s: f64,
    looked_s: f64,
    standing: Option<ControllerState>,
    troubles: Troubles,
}

impl<D: Driver> Link<D> {
    /// A controller that stands, with nothing to do.
    pub const fn new(driver: D) -> Self {
        Self {
            driver,
            state: LinkState::Up,
            given: 0,
            done: 0,
            taken: 0,
            open: VecDeque::new(),
            sent: 0,
            sent_s: f64::NEG_INFINITY,
            asked_s: f64::NEG_INFINITY,
            silent_s: 0.0,
            looked_s: f64::INFINITY,
            standing: None,
            troubles: Troubles { again: 0, stale: 0, garbled: 0 },
        }
    }

    /// Puts an order at the end of the row; nothing while the link is not up.
    pub fn order(&mut self, order: Order) -> Option<Ticket> {
        if self.state != LinkState::Up {
            return None;
        }
        self.given += 1;
        self.open.push_back(Sent { ticket: self.given, order });
        Some(self.given)
    }

    /// Stops the machine; orders that are not done are forgotten.
    pub fn stop(&mut self, now_s: f64) {
        self.driver.signal(Signal::Stop, now_s);
        self.open.clear();
    }

    /// Returns the state of the link.
    pub const fn state(&self) -> LinkState {
        self.state
    }

    /// Returns where the controller was when it told last.
    pub const fn standing(&self) -> Option<ControllerState> {
        self.standing
    }

    /// Returns `true` if every order is done.
    pub fn is_idle(&self) -> bool {
        self.open.is_empty()
    }

    /// Faults so far.
    pub const fn troubles(&self) -> Troubles {
        self.troubles
    }

    /// The controller stands and was told to begin anew: so do the tickets.
    pub fn restart(&mut self, now_s: f64) {
        self.state = LinkState::Up;
        (self.given, self.done, self.taken, self.sent) = (0, 0, 0, 0);
        self.open.clear();
        (self.sent_s, self.asked_s) = (f64::NEG_INFINITY, f64::NEG_INFINITY);
        (self.silent_s, self.looked_s) = (0.0, now_s);
    }

    /// The driver.
    pub const fn driver(&mut self) -> &mut D {
        &mut self.driver
    }

    /// Time has come to here: answers are read, what is due is sent.
    pub fn poll(&mut self, now_s: f64) -> Vec<LinkNews> {
        let mut told = Vec::new();
        for reply in self.driver.replies(now_s) {
            match reply {
                Ok(reply) => self.hear(reply, now_s, &mut told),
                Err(_) => self.troubles.garbled += 1,
            }
        }
        if self.state == LinkState::Up && !self.open.is_empty() {
            self.press_on(now_s, &mut told);
        } else {
            self.silent_s = 0.0;
        }
        self.looked_s = now_s;
        told
    }

    fn hear(&mut self, reply: Reply, now_s: f64, told: &mut Vec<LinkNews>) {
        self.silent_s = 0.0;
        match reply {
            Reply::Taken(ticket) if ticket <= self.taken => self.troubles.stale += 1,
            Reply::Taken(ticket) if ticket <= self.sent => self.taken = ticket,
            Reply::Done(ticket) if ticket <= self.done => self.troubles.stale += 1,
            Reply::Done(ticket) if ticket <= self.sent => self.is_done(ticket, told),
            Reply::Refused(ticket, why) if ticket > self.done && ticket <= self.sent => {
                self.end(LinkState::Refused(ticket, why), now_s, told);
            }
            Reply::Refused(ticket, _) if ticket <= self.done => self.troubles.stale += 1,
            Reply::Taken(_) | Reply::Done(_) | Reply::Refused(..) => self.troubles.garbled += 1,
            Reply::State(standing) if standing.done <= self.sent => {
                // What is done may have been told by a reply that was lost. An old answer tells
                // less than is known.
                if standing.done >= self.done {
                    self.standing = Some(standing);
                    self.is_done(standing.done, told);
                } else {
                    self.troubles.stale += 1;
                }
            }
            Reply::State(_) => self.troubles.garbled += 1,
            Reply::Input { line, on } => told.push(LinkNews::Input { line, on }),
        }
    }

    /// Orders are done one after the other: with one all before it are.
    fn is_done(&mut self, ticket: Ticket, told: &mut Vec<LinkNews>) {
        while self.open.front().is_some_and(|first| first.ticket <= ticket) {
            told.extend(self.open.pop_front().map(|first| LinkNews::Done(first.ticket)));
        }
        self.done = self.done.max(ticket);
        self.taken = self.taken.max(ticket);
    }

    /// Sends what is due, again where it was not taken in time.
    fn press_on(&mut self, now_s: f64, told: &mut Vec<LinkNews>) {
        self.silent_s += (now_s - self.looked_s).clamp(0.0, ASK_S);
        if self.driver.quiet() {
            self.silent_s = 0.0;
        }
        if self.silent_s > LOST_S {
            return self.end(LinkState::Lost, now_s, told);
        }
        let late = now_s - self.sent_s > PATIENCE_S;
        let from = if late { self.taken } else { self.sent };
        let due = self.open.iter().take(self.driver.window()).filter(|sent| sent.ticket > from);
        for sent in due {
            self.troubles.again += u32::from(sent.ticket <= self.sent);
            self.driver.send(sent, now_s);
            self.sent = self.sent.max(sent.ticket);
            self.sent_s = now_s;
        }
        if now_s - self.asked_s > ASK_S {
            self.asked_s = now_s;
            self.driver.signal(Signal::Ask, now_s);
        }
    }

    fn end(&mut self, state: LinkState, now_s: f64, told: &mut Vec<LinkNews>) {
        self.state = state;
        self.stop(now_s);
        told.push(LinkNews::State(state));
    }
}

#[cfg(test)]
mod tests {
    use super::super::Garbled;
    use super::*;
    use kerf_program::Axes;

    /// A controller that says the same whatever it is told.
    struct Says(Vec<Result<Reply, Garbled>>);

    impl Driver for Says {
        fn send(&mut self, _: &Sent, _: f64) {}

        fn signal(&mut self, _: Signal, _: f64) {}

        fn replies(&mut self, _: f64) -> Vec<Result<Reply, Garbled>> {
            std::mem::take(&mut self.0)
        }
    }

    #[test]
    fn answers_that_name_no_order_count_as_garbled() {
        let standing = |done| {
            let (position, moving, outputs) = (Axes::default(), false, 0);
            Ok(Reply::State(ControllerState { position, moving, outputs, done }))
        };
        let says =
            [standing(0), standing(7), Ok(Reply::Taken(9)), Ok(Reply::Done(9)), Err(Garbled)];
        let mut link = Link::new(Says(says.into()));
        assert_eq!(link.poll(0.0), []);
        assert_eq!(link.troubles(), Troubles { garbled: 4, ..Troubles::default() });
        assert_eq!(link.standing().map(|standing| standing.done), Some(0));
    }
}
