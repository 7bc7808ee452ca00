//! A board with step queues that is wired from a page: the wizard on a thread of its own, its questions as state that every
//! page shows, its answers as acts.
//!
//! A stop ends it at once, and so does whoever takes the turn at driving away: motors stand, nothing is written.

use crate::asker::Asker;
use crate::hub::Hub;
use crate::locks::lock;
use crate::machine::{LastState, Link, StopCount};
use crate::part_files::PartFiles;
use crate::refusal::problem;
use crate::saving::Leave;
use kerf_control::controller::queued::wizard::{Ends, Looks, Question, Seen, Watcher, wire};
use kerf_control::controller::queued::{Held, Introduced, Socket, address, at_ports};
use kerf_machine::boards::{self, KnownBoard, named};
use kerf_machine::{Configuration, file};
use kerf_transport::{ListedPort, listed_ports};
use kerf_wire::{
    Act, Change, FoundBoard, FoundPort, Mode, Problem, SoldBoard, State, Why, WiredSwitch, Wiring,
};
use std::path::Path;
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::sync::{Arc, Mutex};
use std::thread::Builder;
use std::time::Duration;

/// Interval at which a stop is looked for while an answer is waited for.
const GLANCE: Duration = Duration::from_millis(50);

/// The way to whoever wires a board.
pub struct Wirings {
    hub: Arc<Hub>,
    link: Arc<Link>,
    left: Arc<Mutex<LastState>>,
    files: Arc<PartFiles>,
    /// The way to the wizard that is open.
    answers: Arc<Mutex<Option<Sender<String>>>>,
}

impl Wirings {
    /// No board is being wired.
    pub fn new(
        hub: Arc<Hub>,
        link: Arc<Link>,
        left: Arc<Mutex<LastState>>,
        files: Arc<PartFiles>,
    ) -> Self {
        Self { hub, link, left, files, answers: Arc::default() }
    }

    /// Does what a page asks for.
    ///
    /// # Errors
    /// As [`Wirings::begin`] and [`Wirings::answer`].
    pub fn hears(&self, asker: &Asker, act: Act) -> Result<(), Problem> {
        match act {
            Act::Wire { port, board, into, .. } => self.begin(asker, &port, board.as_deref(), into),
            Act::WireLook { port, .. } => self.look(port.trim()),
            Act::WireAnswer { question, answer, .. } => self.answer(question, answer),
            _ => Ok(()),
        }
    }

    /// Begins to wire the board at a port, from the pins of one that is sold where it is named.
    ///
    /// # Errors
    /// The machine is busy or real, a board is being wired already, a name is none, or the file is there.
    fn begin(
        &self,
        asker: &Asker,
        port: &str,
        board: Option<&str>,
        into: String,
    ) -> Result<(), Problem> {
        self.may_begin()?;
        self.may_write(&into)?;
        let known = board.map(named).transpose();
        let known = known.map_err(|why| problem(Why::Malformed, why.to_string()))?;
        let port = port.trim();
        let place = address(port).map_err(|why| problem(Why::Malformed, why))?;
        let socket = Socket::of(format!("klipper:{port}"), place);
        let mut answers = lock(&self.answers);
        self.is_free(answers.is_some())?;
        let (answer, answered) = channel();
        let pages = Pages {
            hub: self.hub.clone(),
            link: self.link.clone(),
            since: asker.stops(),
            answered,
            shown: Wiring { question: self.last(), is_open: true, ..Wiring::default() },
        };
        pages.show();
        let (open, files) = (self.answers.clone(), self.files.clone());
        let machine = lock(&self.left).session.configuration();
        let wires = move || {
            let ended = wires((&socket, machine), known.as_ref(), pages, (&files, &into));
            *lock(&open) = None;
            ended.tell();
        };
        Builder::new()
            .name("wiring".into())
            .spawn(wires)
            .map_err(|why| problem(Why::Server, format!("no thread for it: {why}")))?;
        *answers = Some(answer);
        Ok(())
    }

    /// The number of the last question that was asked.
    fn last(&self) -> u32 {
        self.hub.read(|now| now.wiring.as_ref().map_or(0, |wiring| wiring.question))
    }

    /// Looks who is at the ports of this computer, and at one more where it is named. What is found is told to all pages.
    ///
    /// # Errors
    /// The machine is busy or real, or a board is being wired.
    fn look(&self, further: &str) -> Result<(), Problem> {
        self.may_begin()?;
        let answers = lock(&self.answers);
        self.is_free(answers.is_some())?;
        let shown = Wiring { question: self.last(), is_looking: true, ..Wiring::default() };
        let hub = self.hub.clone();
        let mut ports = listed_ports();
        if !further.is_empty() && ports.iter().all(|it| it.path != further) {
            ports.push(ListedPort { path: further.to_owned(), device: None });
        }
        let show = |hub: &Hub, wiring| hub.change(vec![Change::Wiring { wiring: Some(wiring) }]);
        show(&hub, shown.clone());
        let looks = move || {
            let found = at_ports(ports).into_iter().map(found).collect();
            show(&hub, Wiring { is_looking: false, found, ..shown });
        };
        let begun = Builder::new().name("ports".into()).spawn(looks);
        begun.map(drop).map_err(|why| {
            self.hub.change(vec![Change::Wiring { wiring: None }]);
            problem(Why::Server, format!("no thread for it: {why}"))
        })
    }

    /// Nothing of this kind is under way.
    fn is_free(&self, is_open: bool) -> Result<(), Problem> {
        if is_open {
            return Err(problem(Why::State, "a board is being wired: end that first"));
        }
        if self.hub.read(|now| now.wiring.as_ref().is_some_and(|it| it.is_looking)) {
            return Err(problem(Why::State, "ports are being looked at: wait some seconds"));
        }
        Ok(())
    }

    fn may_begin(&self) -> Result<(), Problem> {
        let (state, mode) = self.hub.read(|now| (now.machine.state, now.machine.mode));
        if mode == Mode::Cut {
            let text =
                "a real machine is driven: start Kerf without one (kerf serve) to wire a board";
            return Err(problem(Why::State, text));
        }
        if state != State::Idle {
            return Err(problem(Why::State, "the machine is busy"));
        }
        Ok(())
    }

    /// The machine's file has a name that is free.
    fn may_write(&self, into: &str) -> Result<(), Problem> {
        if Path::new(into).extension().is_none_or(|ending| ending != "toml") {
            return Err(problem(Why::Malformed, "name the machine's file, as mine.toml"));
        }
        if self.files.folder.present(into)?.is_some() {
            return Err(problem(
                Why::Replaces,
                format!("{into} is there already: name another file"),
            ));
        }
        Ok(())
    }

    /// Answers the question that is open.
    ///
    /// # Errors
    /// It is another one, or none.
    fn answer(&self, question: u32, answer: String) -> Result<(), Problem> {
        let open = |wiring: &Wiring| wiring.step.is_some() && wiring.question == question;
        let is_open = self.hub.read(|now| now.wiring.as_ref().is_some_and(open));
        let late = || problem(Why::Late, "this question is not open any more");
        let answers = lock(&self.answers);
        let answers = answers.as_ref().filter(|_| is_open).ok_or_else(late)?;
        answers.send(answer).map_err(|_| late())
    }
}

/// A port that was looked at, for pages.
fn found((port, told): (ListedPort, Result<Introduced, String>)) -> FoundPort {
    let ListedPort { path: port, device } = port;
    match told {
        Ok(told) => FoundPort { port, device, board: Some(board(&told)), trouble: None },
        Err(why) => FoundPort { port, device, board: None, trouble: Some(why) },
    }
}

/// A board that told who it is, with the boards of its chip that are sold.
fn board(Introduced { dictionary, held }: &Introduced) -> FoundBoard {
    let chip = dictionary.text("MCU").unwrap_or("unknown").to_owned();
    let sold = boards::all().unwrap_or_default().into_iter().filter(|it| it.may_have(&chip));
    let may_be = sold.map(|KnownBoard { name, title, .. }| SoldBoard { name, title }).collect();
    FoundBoard {
        may_be,
        chip,
        firmware: dictionary.version().to_owned(),
        is_configured: matches!(held, Held::Some(_)),
        is_shut_down: *held == Held::ShutDown,
    }
}

/// Wires a board to its end, and writes the machine's file.
fn wires(
    (socket, machine): (&Socket, Configuration),
    known: Option<&KnownBoard>,
    mut pages: Pages,
    (files, into): (&PartFiles, &str),
) -> Ended {
    let wired = wire(socket, machine, known, &mut pages);
    let words = match wired {
        Ok(machine) => {
            let text = file::write(&machine);
            let path = files.folder.root().join(into);
            match files.save(into, text.as_bytes(), &Leave::Nothing) {
                Ok(_) => {
                    let path = path.display();
                    format!("written: {into}. kerf serve --machine {path} drives it")
                }
                Err(why) => format!("not written: {}", why.text),
            }
        }
        Err(Ends::Stopped) => "stopped; nothing is written".to_owned(),
        Err(Ends::Failed(why)) => format!("{why}; nothing is written"),
    };
    Ended { pages, words }
}

/// Result of the wiring, in words.
struct Ended {
    pages: Pages,
    words: String,
}

impl Ended {
    fn tell(mut self) {
        (self.pages.shown.step, self.pages.shown.is_open) = (None, false);
        self.pages.shown.ended = Some(self.words);
        self.pages.show();
    }
}

/// Pages, as those who watch the machine.
struct Pages {
    hub: Arc<Hub>,
    link: Arc<Link>,
    /// Stops that had come when it began.
    since: StopCount,
    answered: Receiver<String>,
    shown: Wiring,
}

impl Pages {
    fn show(&self) {
        self.hub.change(vec![Change::Wiring { wiring: Some(self.shown.clone()) }]);
    }

    /// Waits for an answer, and shows switches as they are meanwhile; without an answer where a stop comes before, or the board
    /// is lost.
    fn waits(&mut self, looks: &mut Looks<'_>) -> Option<String> {
        loop {
            match self.answered.recv_timeout(GLANCE) {
                Ok(answer) => return Some(answer),
                Err(RecvTimeoutError::Timeout) if !self.is_stopped() => {}
                Err(_) => return None,
            }
            let seen = looks()?.into_iter();
            let switches: Vec<_> =
                seen.map(|Seen { about, pin, on }| WiredSwitch { about, pin, on }).collect();
            if switches != self.shown.switches {
                self.shown.switches = switches;
                self.show();
            }
        }
    }
}

impl Watcher for Pages {
    fn ask(&mut self, question: &Question, looks: &mut Looks<'_>) -> Option<String> {
        self.shown.question += 1;
        self.shown.step = Some(question.step.name().to_owned());
        (self.shown.about, self.shown.value) = (question.about.clone(), question.value.clone());
        self.show();
        let answer = self.waits(looks);
        (self.shown.step, self.shown.told) = (None, Vec::new());
        self.shown.switches.clear();
        self.show();
        answer
    }

    fn tell(&mut self, words: &str) {
        self.shown.told.push(words.to_owned());
    }

    fn is_stopped(&self) -> bool {
        self.link.stops() != self.since
    }
}
