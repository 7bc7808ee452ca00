//! The thread of the link to boards: nothing is on it but the lines, the boards and their queues.
//!
//! ```text
//!  Queued ── requests ──► │ thread: read, take requests, write, look at the queue │ ── bytes ──► board
//!         ◄── answers, progress ──
//! ```
//!
//! It ends with whoever has made it: motion is stopped first.

use super::board_port::BoardPort;
use super::priority;
use kerf_driver_klipper::board::{Fault, News, Options};
use kerf_driver_klipper::crew::Crew;
use kerf_driver_klipper::mailbox::{Answer, Mailbox, Progress, Request};
use kerf_driver_klipper::setup::Setup;
use kerf_transport::Line;
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, TryRecvError, channel};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};
use std::thread::{Builder, JoinHandle};
use std::time::{Duration, Instant};

/// Opens the line of a board, on the thread that keeps it.
pub type OpensLine = Arc<dyn Fn() -> Result<Box<dyn Line>, String> + Send + Sync>;

/// The lines of all boards; nothing where one is broken.
type Lines = Vec<Option<Box<dyn Line>>>;

/// The longest time for which lines are waited for, so that a request is taken.
const GLANCE: Duration = Duration::from_millis(1);
/// The last words of a host have this time to come to the board.
const PARTING: Duration = Duration::from_millis(500);
/// They need at least so long: an output changes a moment after it was told.
const FAREWELL: Duration = Duration::from_millis(80);
/// Time behind the last step for which motion is waited on for more, seconds.
const LINGER_S: f64 = 1.0;

/// The near end of the thread.
pub struct Threaded {
    requests: Option<Sender<Request>>,
    answers: Receiver<Answer>,
    progress: Arc<Mutex<Progress>>,
    since: Instant,
    thread: Option<JoinHandle<()>>,
}

/// A board that has told who it is: the version of its program, and the counts of its motors.
pub struct Greeted {
    /// The board.
    pub port: Threaded,
    /// Version of the program in it.
    pub version: String,
    /// Steps of its motors.
    pub counts: Vec<i64>,
    /// A sentence where its thread has no real-time priority.
    pub priority: Option<String>,
}

impl Threaded {
    /// Opens the line of each board, by its name, and waits until all are ready.
    ///
    /// # Errors
    /// Nobody answers, or a board that the setup does not fit; in words.
    pub fn open(
        setup: &Setup,
        options: Options,
        boards: Vec<(String, OpensLine)>,
    ) -> Result<Greeted, String> {
        let (requests, taken) = channel();
        let (told, answers) = channel();
        let progress = Arc::new(Mutex::new(Progress::default()));
        let since = Instant::now();
        let options = Options { linger_s: LINGER_S, ..options };
        let (names, opens): (Vec<_>, Vec<_>) = boards.into_iter().unzip();
        let crew = Crew::new(setup, &names, options, 0.0).map_err(|why| why.to_string())?;
        let mut tender = Tender {
            mailbox: Mailbox::new(crew),
            requests: taken,
            answers: told,
            progress: progress.clone(),
            since,
        };
        let priority = Arc::new(OnceLock::new());
        let given = priority.clone();
        let run = move || {
            drop(given.set(priority::raise()));
            tender.run(&opens);
        };
        let thread = Builder::new().name("board".into()).spawn(run).map_err(|it| it.to_string())?;
        let (requests, thread) = (Some(requests), Some(thread));
        let mut greeted = Self { requests, answers, progress, since, thread }.greeted()?;
        let refused = priority.get().and_then(|given| given.as_ref().err());
        greeted.priority = refused.map(|why| priority::words(why));
        Ok(greeted)
    }

    fn greeted(self) -> Result<Greeted, String> {
        loop {
            // A board that is silent is given up by whoever speaks with it.
            match self.answers.recv() {
                Ok(Answer::News(News::Ready { version, counts })) => {
                    return Ok(Greeted { port: self, version, counts, priority: None });
                }
                Ok(Answer::News(News::Fault(fault))) => return Err(fault.to_string()),
                Ok(Answer::Refused(why)) => return Err(why),
                Ok(_) => {}
                Err(_) => return Err(Fault::NoBoard.to_string()),
            }
        }
    }
}

impl BoardPort for Threaded {
    fn request(&mut self, request: Request) {
        if let Some(requests) = &self.requests {
            // A thread that is over has told why.
            let _ = requests.send(request);
        }
    }

    fn look(&mut self, wait: Duration) -> (Progress, Vec<Answer>) {
        let first = match wait.is_zero() {
            true => self.answers.try_recv().ok(),
            false => match self.answers.recv_timeout(wait) {
                Err(RecvTimeoutError::Disconnected) => {
                    std::thread::sleep(wait);
                    None
                }
                answer => answer.ok(),
            },
        };
        let answers = first.into_iter().chain(self.answers.try_iter()).collect();
        let progress = *self.progress.lock().unwrap_or_else(PoisonError::into_inner);
        // The clock of machine time goes on whatever the thread does.
        (Progress { at_s: self.since.elapsed().as_secs_f64(), ..progress }, answers)
    }
}

impl Drop for Threaded {
    fn drop(&mut self) {
        self.requests = None;
        if let Some(thread) = self.thread.take() {
            // One that panicked is over as well, and the board stops by itself.
            let _ = thread.join();
        }
    }
}

/// The far end, on the thread.
struct Tender {
    mailbox: Mailbox,
    requests: Receiver<Request>,
    answers: Sender<Answer>,
    progress: Arc<Mutex<Progress>>,
    since: Instant,
}

impl Tender {
    fn run(&mut self, opens: &[OpensLine]) {
        let opened: Result<Lines, String> = opens.iter().map(|opens| opens().map(Some)).collect();
        let ended = opened.and_then(|mut lines| {
            let ended = self.turns(&mut lines);
            // Boards whose lines are left stop at once.
            let parted = self.part(&mut lines);
            ended.and(parted)
        });
        if let Err(why) = ended {
            let _ = self.answers.send(Answer::Refused(why));
        }
    }

    fn turns(&mut self, lines: &mut Lines) -> Result<(), String> {
        while self.turn(lines)? {}
        Ok(())
    }

    fn now_s(&self) -> f64 {
        self.since.elapsed().as_secs_f64()
    }

    /// One look at everything; tells whether somebody still wants it.
    fn turn(&mut self, lines: &mut Lines) -> Result<bool, String> {
        let wanted = loop {
            match self.requests.try_recv() {
                Ok(request) => self.mailbox.take(request, self.now_s()),
                Err(TryRecvError::Empty) => break true,
                Err(TryRecvError::Disconnected) => break false,
            }
        };
        self.carry(lines)?;
        Ok(wanted)
    }

    /// Moves bytes both ways. All lines are written to before one is waited for.
    fn carry(&mut self, lines: &mut Lines) -> Result<(), String> {
        let mut broken = Ok(());
        for (board, line) in lines.iter_mut().enumerate() {
            if let Err(why) = self.write(board, line) {
                (*line, broken) = (None, Err(why));
            }
        }
        let glance_s = GLANCE.as_secs_f64() / lines.len() as f64;
        for (board, line) in lines.iter_mut().enumerate() {
            if let Err(why) = self.read(board, line, glance_s) {
                (*line, broken) = (None, Err(why));
            }
        }
        let progress = self.mailbox.progress(self.now_s());
        *self.progress.lock().unwrap_or_else(PoisonError::into_inner) = progress;
        for answer in self.mailbox.answers() {
            let _ = self.answers.send(answer);
        }
        broken
    }

    fn write(&mut self, board: usize, line: &mut Option<Box<dyn Line>>) -> Result<(), String> {
        let now_s = self.now_s();
        let out = self.mailbox.crew().transmit(board, now_s).bytes;
        match line {
            Some(line) if !out.is_empty() => line.write(&out).map_err(|why| why.to_string()),
            _ => Ok(()),
        }
    }

    fn read(
        &mut self,
        board: usize,
        line: &mut Option<Box<dyn Line>>,
        glance_s: f64,
    ) -> Result<(), String> {
        let Some(line) = line else { return Ok(()) };
        let due_s = (self.mailbox.crew().due_s() - self.now_s()).clamp(0.0, glance_s);
        let mut bytes = [0; 1024];
        let read = line.read(&mut bytes, Duration::from_secs_f64(due_s));
        let count = read.map_err(|why| why.to_string())?;
        let now_s = self.now_s();
        self.mailbox.crew().receive(board, &bytes[..count], now_s);
        Ok(())
    }

    /// Nobody wants it any more, or a line is broken: what moves is stopped.
    fn part(&mut self, lines: &mut Lines) -> Result<(), String> {
        let until = Instant::now() + PARTING;
        self.mailbox.take(Request::Stop, self.now_s());
        let least = Instant::now() + FAREWELL;
        while (self.mailbox.crew().is_stopping() || Instant::now() < least)
            && Instant::now() < until
            && lines.iter().any(Option::is_some)
        {
            self.carry(lines)?;
        }
        Ok(())
    }
}
