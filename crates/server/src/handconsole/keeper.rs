//! The thread that owns the console.

use super::Happening;
use super::kept_points::KeptPoints;
use super::view::Facts;
use crate::app::App;
use crate::asker::Asker;
use crate::people::Grip;
use crate::to_wire;
use kerf_handconsole::{Console, ConsoleRequest, Key};
use kerf_wire::{Change, HandConsole, Problem, Snapshot, State, Why};
use std::collections::VecDeque;
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender};
use std::sync::{Arc, Weak};
use std::time::Duration;

/// Interval at which the screen follows the machine: pages and serial link show it within a tenth of a second.
const LOOK: Duration = Duration::from_millis(30);
const _: () = assert!(LOOK.as_millis() < 100);

/// Owns the console.
pub struct Keeper {
    app: Weak<App>,
    happens: Sender<Happening>,
    console: Console,
    /// Requests of a key that wait until the machine has done those before them.
    waiting: VecDeque<(Asker, Grip, ConsoleRequest)>,
    /// The outcome of a request is still to be told.
    doing: bool,
    /// It will be in a moment: keys wait for it.
    settling: bool,
    keys: VecDeque<(Asker, Grip, Key)>,
    facts: Facts,
    /// Points were being digitized at the last look.
    digitizes: bool,
    /// Points that outlive the server; nothing before the first look.
    left: Option<KeptPoints>,
}

impl Keeper {
    pub fn new(app: Weak<App>, happens: Sender<Happening>) -> Self {
        Self {
            app,
            happens,
            console: Console::default(),
            waiting: VecDeque::new(),
            doing: false,
            settling: false,
            keys: VecDeque::new(),
            facts: Facts::default(),
            digitizes: false,
            left: None,
        }
    }

    /// Works until the server is gone.
    pub fn work(mut self, happenings: &Receiver<Happening>) {
        loop {
            let happened = match happenings.recv_timeout(LOOK) {
                Ok(happened) => Some(happened),
                Err(RecvTimeoutError::Timeout) => None,
                Err(RecvTimeoutError::Disconnected) => return,
            };
            let Some(app) = self.app.upgrade() else { return };
            self.take_up(&app);
            match happened {
                Some(Happening::Key { asker, grip, key: Key::Stop }) => {
                    self.press(&app, &asker, grip, Key::Stop);
                }
                Some(Happening::Key { asker, grip, key }) => {
                    self.keys.push_back((asker, grip, key))
                }
                Some(Happening::Outcome(outcome)) => self.told(outcome),
                None => {}
            }
            self.go_on(&app);
            while !self.waits(&app)
                && let Some((asker, grip, key)) = self.keys.pop_front()
            {
                self.press(&app, &asker, grip, key);
            }
            self.show(&app);
        }
    }

    /// Keys wait for a request that is over in a moment; and while a folder is read or another chore is done, because they are
    /// meant for the machine that stands then. Beside a run, a typed line's too, they do not: a key that was kept would start
    /// something when nobody expects it.
    fn waits(&self, app: &App) -> bool {
        let no_run = |now: &Snapshot| now.job.as_ref().is_none_or(|job| job.ended.is_some());
        let is_busy = |now: &Snapshot| now.machine.state == State::Running && no_run(now);
        self.settling || (app.hub.read(is_busy) && app.link.does_chore())
    }

    fn press(&mut self, app: &Arc<App>, asker: &Asker, grip: Grip, key: Key) {
        let view = self.facts.view(app, true);
        let mut requests = self.console.press(key, &view).into_iter();
        let Some(first) = requests.next() else { return };
        self.waiting = requests.map(|request| (asker.clone(), grip, request)).collect();
        // The key before was let go, and the tool slows down: it moves anew as soon as it stands.
        if matches!(first, ConsoleRequest::Jog(_)) && app.hub.state() == State::Jogging {
            self.waiting.push_front((asker.clone(), grip, first));
        } else {
            self.grant(app, asker, grip, first);
        }
    }

    /// Grants what waits, as far as the machine is ready for it.
    fn go_on(&mut self, app: &Arc<App>) {
        while app.hub.state() == State::Idle && !self.doing {
            let Some((asker, grip, request)) = self.waiting.pop_front() else { return };
            self.grant(app, &asker, grip, request);
        }
        if app.hub.state() == State::Alarm {
            self.waiting.clear();
        }
    }

    fn grant(&mut self, app: &Arc<App>, asker: &Asker, grip: Grip, request: ConsoleRequest) {
        let request = match request {
            ConsoleRequest::Open(job) => ConsoleRequest::Open(self.facts.named(&job)),
            request => request,
        };
        let (lasts, settles) = (request.lasts(), request.settles());
        match super::grant(app, asker, grip, request, &self.happens) {
            Ok(()) => (self.doing, self.settling) = (lasts || settles, settles),
            Err(problem) => {
                self.waiting.clear();
                self.refused(app, &problem);
            }
        }
    }

    fn refused(&mut self, app: &App, problem: &Problem) {
        match problem.why {
            // Whoever let the key go at once wanted no move.
            Why::Late => {}
            Why::Lease if app.hub.read(|now| now.lease.is_some()) => {
                self.console.needs_control("Somebody else drives");
            }
            Why::Lease => self.console.needs_control("Nobody drives"),
            Why::Disarmed => self.console.needs_control("Disarmed"),
            _ => self.console.told(Err(problem.text.clone())),
        }
    }

    fn told(&mut self, outcome: Result<String, String>) {
        (self.doing, self.settling) = (false, false);
        if outcome.is_err() {
            self.waiting.clear();
        }
        if self.waiting.is_empty() {
            self.console.told(outcome);
        }
    }

    /// Points that an earlier server left.
    fn take_up(&mut self, app: &App) {
        if self.left.is_some() {
            return;
        }
        let mut left = KeptPoints::default();
        if let Some(points) = left.take_up(app) {
            self.console = Console::with_points(points);
        }
        self.left = Some(left);
    }

    /// Tells pages what the screen shows, where that is something else.
    fn show(&mut self, app: &Arc<App>) {
        let view = self.facts.view(app, false);
        self.console.follow(&view);
        let screen = self.console.screen(&view);
        let beeps = self.console.beeps();
        let points = self.console.digitized(&view);
        if let (Some(left), true) = (&mut self.left, points.is_some() || self.digitizes) {
            left.keep(app, points.as_ref());
        }
        self.digitizes = points.is_some();
        let digitized =
            points.as_ref().map(|points| to_wire::digitized(points, view.machine.job.origin_mm));
        app.hub.changing(|now| {
            let link = now.hand_console.link.clone();
            let hand_console = HandConsole { lines: screen.lines, beeps, link };
            let other = now.hand_console != hand_console;
            let screen = other.then_some(Change::HandConsole { hand_console });
            let others = now.digitized != digitized;
            let points = others.then_some(Change::Digitized { digitized });
            screen.into_iter().chain(points).collect()
        });
    }
}
