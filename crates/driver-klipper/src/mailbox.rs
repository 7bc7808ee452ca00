//! Boards as the owner of a plan deals with them: requests go in, answers and a look at their progress come out.
//!
//! The mailbox is what the thread of the link owns; the owner of the plan may be on another one.

use crate::board::{Board, Home, News, Start, Watched};
use crate::crew::Crew;
use crate::queue::{Change, Piece, Refused};

/// An output that changes at a clock, from 0 (off) to 1, counted as in the setup: those that go on and off, then those
/// with a share of time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Set {
    /// Its place among the outputs.
    pub output: usize,
    /// Its share of the time, or of its state.
    pub share: f64,
    /// Clock.
    pub clock: u64,
}

/// A request to a board.
#[derive(Clone, Debug, PartialEq)]
pub enum Request {
    /// Motion begins, from rest. Switches of these stop their motors, each its own.
    Start(Vec<Home>),
    /// From now on these switches stop all motors, and no others.
    Watch(Vec<Watched>),
    /// A piece of motion behind those that it has, with the outputs that change in it and on its way to rest, each in
    /// order of time.
    Offer(Piece, [Vec<Set>; 2]),
    /// An output changes now, counted as in the setup: those that go on and off, then those with a share of time.
    Output {
        /// Its place among the outputs.
        output: usize,
        /// From 0 (off) to 1.
        share: f64,
    },
    /// All motors stop at once, without a ramp.
    Stop,
    /// Motion that is over is ended and counted, and not waited on for more.
    LetRest,
    /// The state of a switch is asked for.
    Switch(usize),
    /// A voltage is measured every so many seconds from soon on, or no more.
    Measure {
        /// Its place among the voltages.
        voltage: usize,
        /// Time between two measurements, seconds.
        every_s: Option<f64>,
    },
    /// The condition of the motor drivers is looked at.
    CheckDrivers,
    /// A shutdown is cleared.
    Recover,
}

/// An answer of a board.
#[derive(Clone, Debug, PartialEq)]
pub enum Answer {
    /// Motion begins there.
    Started(Start),
    /// A request was not taken: the reason in words.
    Refused(String),
    /// News of the board.
    News(News),
}

/// Progress of a board.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Progress {
    /// Moment at which it was looked at, seconds on the clock of the link.
    pub at_s: f64,
    /// Clock of the board then, and the farthest that it may be off, ticks; nothing before it is known.
    pub clock: Option<(u64, u64)>,
    /// Motion goes on, or is about to.
    pub moves: bool,
    /// Motion could begin.
    pub rests: bool,
    /// Longest stall of the host, and the lead that follows from it, seconds.
    pub lead_s: [f64; 2],
    /// Shortest time by which a step was sent before it was due, seconds.
    pub latest_s: Option<f64>,
    /// Smoothed round trip of the line and its deviation, seconds.
    pub trip_s: Option<[f64; 2]>,
}

/// Boards with the requests of their owner.
pub struct Mailbox {
    crew: Crew,
    answers: Vec<Answer>,
}

impl Mailbox {
    /// A mailbox for boards.
    pub const fn new(crew: Crew) -> Self {
        Self { crew, answers: Vec::new() }
    }

    /// The boards, for whoever moves their bytes.
    pub const fn crew(&mut self) -> &mut Crew {
        &mut self.crew
    }

    /// Takes a request.
    pub fn take(&mut self, request: Request, now_s: f64) {
        let board = &mut self.crew;
        let taken = match request {
            Request::Start(homes) => board.start(&homes, now_s).map(|start| {
                self.answers.push(Answer::Started(start));
            }),
            Request::Offer(mut piece, sets) => {
                let change = |set: &Set| {
                    let value = board.output_value(set.output, set.share)?;
                    Some(Change { output: set.output, clock: set.clock, value })
                };
                let [changes, tail_changes] =
                    sets.map(|sets| sets.iter().filter_map(change).collect());
                (piece.changes, piece.tail_changes) = (changes, tail_changes);
                match board.offer(&piece) {
                    // Motion has ended meanwhile: its end is told with the reason.
                    Ok(()) | Err(Refused::Stopping) => {}
                    Err(why) => self.answers.push(Answer::Refused(why.to_string())),
                }
                Ok(())
            }
            Request::Watch(watched) => board.watch(&watched, now_s),
            Request::Output { output, share } => board.set_output(output, share, now_s),
            Request::Stop => board.stop(),
            Request::LetRest => {
                board.let_rest();
                Ok(())
            }
            Request::Switch(switch) => board.ask_switch(switch),
            Request::Measure { voltage, every_s } => board.measure(voltage, every_s, now_s),
            // A board that is not ready tells so by itself.
            Request::CheckDrivers => {
                board.check_drivers().ok();
                Ok(())
            }
            Request::Recover => board.recover(),
        };
        if let Err(why) = taken {
            self.answers.push(Answer::Refused(why.to_string()));
        }
    }

    /// Returns what was answered and heard since it was asked last, in order.
    pub fn answers(&mut self) -> Vec<Answer> {
        while let Some(news) = self.crew.news() {
            self.answers.push(Answer::News(news));
        }
        std::mem::take(&mut self.answers)
    }

    /// Returns how far the board is.
    pub fn progress(&self, now_s: f64) -> Progress {
        let crew = &self.crew;
        let trips_s = crew.boards().filter_map(Board::trip_s);
        Progress {
            at_s: now_s,
            clock: crew.clock(now_s),
            moves: crew.is_moving(),
            rests: crew.is_at_rest(),
            lead_s: crew.lead_s(),
            latest_s: crew.boards().filter_map(Board::latest_s).min_by(f64::total_cmp),
            trip_s: trips_s.max_by(|a, b| a[0].total_cmp(&b[0])),
        }
    }
}
