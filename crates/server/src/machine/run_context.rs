//! Participants in a run of the server: a clock, an operator at any page with requests, and whoever is told.
//!
//! They share a [`Board`]; they live on the machine's thread.

use super::board::{Board, TELL};
use super::link::Link;
use crate::files::PartFolder;
use crate::hub::Hub;
use crate::to_wire;
use kerf_control::answers::{self, Operator};
use kerf_control::{Jog, LIFT, OperatorRequest, Requests, WorldClock};
use kerf_journal::Hurry;
use kerf_machine::driver::{Override, Shares};
use kerf_machine::{Driven, Machine as DrivenMachine};
use kerf_program::{Question, QuestionKind};
use kerf_trace::{Doing, Event, ExecutedMove, RunStatus, Sink};
use kerf_wire::{Asked, Change, InForce, Machine, Overrides, State, Tone};
use std::cell::RefCell;
use std::path::Path;
use std::rc::Rc;
use std::sync::Arc;
use std::time::{Duration, Instant};

/// A nap while machine time passes: pages see the machine move, a jog that nobody renews is noticed.
const NAP: Duration = Duration::from_millis(15);

/// Interval at which the machine is looked at while a run waits for a person.
const LOOK: Duration = Duration::from_millis(100);

/// A nap that takes so long is none: the computer slept, or everything on it stood still.
const SLEPT: Duration = Duration::from_secs(5);

/// Lamps follow their bits within a tenth of a second (Profiler reference, "I/O Card").
const _: () = assert!(NAP.as_millis() + TELL.as_millis() < 100);

/// Parts that they share.
#[derive(Clone, Debug)]
pub struct Shared {
    /// Gathers what is told.
    pub board: Rc<RefCell<Board>>,
    /// Tells it to the pages.
    pub hub: Arc<Hub>,
    /// Carries what is wanted.
    pub link: Arc<Link>,
    /// Pages know files by their names below this.
    pub parts: PartFolder,
}

impl Shared {
    fn tell(&self) {
        self.board.borrow_mut().tell();
    }

    /// The computer slept in the middle of a move. Whoever wakes it does not know that: the machine stops.
    fn slept(&self, slept: Duration) {
        self.link.stop();
        let text = format!(
            "the computer slept for {} s while the machine moved: stopped. See to it that it does not sleep while Kerf runs",
            slept.as_secs()
        );
        self.hub.say(Tone::Warning, text);
    }

    /// Looks at the machine while its run waits for somebody.
    fn look(&self, machine: &Driven) {
        let told = machine.try_borrow_mut().ok().map(|mut machine| {
            machine.look();
            self.passes_tool(&mut *machine)
        });
        let (waits, wants_tool) = told.unwrap_or_default();
        self.waits(waits, wants_tool);
    }

    /// Tells the machine that the tool is in for which it waits, where somebody said so. Returns for what it waits, and
    /// whether that is a tool.
    fn passes_tool(&self, machine: &mut dyn DrivenMachine) -> (Option<&'static str>, bool) {
        if self.link.lock().takes_tool() {
            machine.tool_is_in();
        }
        (machine.waits(), machine.waits_for_tool())
    }

    /// Tells pages for what the machine waits at its own controls.
    fn waits(&self, why: Option<&'static str>, wants_tool: bool) {
        self.hub.changing(|now| {
            let other = now.machine.why.as_deref() != why || now.machine.wants_tool != wants_tool;
            let machine = || {
                let why = why.map(String::from);
                // The Z zero of what runs would not follow.
                Machine { why, wants_tool, touches_off: false, ..now.machine.clone() }
            };
            other.then(|| Change::Machine { machine: machine() }).into_iter().collect()
        });
    }

    /// Takes over overrides that were turned at the machine's own controls, and shows them on pages.
    fn is_turned(&self, shares: Shares) {
        let Shares { feed, rapid, spindle } = shares;
        self.board.borrow_mut().rapid = f64::from(rapid) / 100.0;
        let overrides = Overrides {
            feed_percent: f64::from(feed),
            rapid_percent: Some(rapid),
            spindle_percent: Some(spindle),
        };
        self.hub.change(vec![Change::Overrides { overrides }]);
        self.link.lock().feed = Some(f32::from(feed) / 100.0);
    }

    /// The name below the part folder of the server, of a file as a program names it.
    fn name_from_root(&self, name: &str) -> String {
        let folder = self.hub.read(|now| now.folder.name.clone());
        let plain = name.is_empty() || folder.is_empty() || Path::new(name).is_absolute();
        if plain { self.parts.name_of(name) } else { format!("{folder}/{name}") }
    }

    /// The machine does something else from now on.
    fn state(&self, state: State) {
        self.becomes(state, Vec::new());
    }

    /// The machine does something else from now on; these changes are told with it, in one.
    fn becomes(&self, state: State, mut changes: Vec<Change>) {
        if !matches!(state, State::Running | State::Jogging) {
            self.board.borrow_mut().stand();
        }
        self.tell();
        self.hub.changing(|now| {
            let machine = Machine { state, why: None, ..now.machine.clone() };
            changes.push(Change::Machine { machine });
            changes
        });
    }
}

/// Machine time of the simulated machine against the time of the world.
#[derive(Debug)]
pub struct Clock {
    shared: Shared,
    /// Seconds of machine time in a second; 1 for a real machine.
    rate: f64,
    /// Machine time by the clock of the world.
    world: WorldClock,
}

impl Clock {
    /// A clock that begins with the run.
    pub const fn new(shared: Shared, rate: f64) -> Self {
        Self { shared, rate, world: WorldClock::new(rate) }
    }

    /// Sleeps until something is wanted, at most so long.
    fn nap(shared: &Shared, most: Duration) {
        let link = &shared.link;
        let before = link.clock().now();
        drop(link.wait(link.lock(), most));
        let slept = link.clock().now().saturating_sub(before);
        if slept > SLEPT {
            shared.slept(slept);
        }
    }
}

impl kerf_sim::Clock for Clock {
    fn pass(&mut self, from_s: f64, until_s: f64) -> f64 {
        let shared = &self.shared;
        self.world.pass(from_s, until_s, NAP, |most| Self::nap(shared, most))
    }

    fn in_real_time(&self) -> bool {
        self.rate <= 1.0
    }

    fn begin_anew(&mut self) {
        self.world.begin_anew();
    }
}

/// What pages ask for of a run.
pub struct PageRequests {
    shared: Shared,
    machine: Driven,
    /// Seconds of machine time in a second.
    rate: f64,
}

impl PageRequests {
    /// Requests about a machine whose time passes at a rate.
    pub const fn new(shared: Shared, machine: Driven, rate: f64) -> Self {
        Self { shared, machine, rate }
    }

    /// Returns `true` if somebody at the controls of the machine has had it go on from a hold.
    fn went_on(&self) -> bool {
        self.machine.try_borrow_mut().is_ok_and(|mut machine| machine.went_on())
    }
}

impl Requests for PageRequests {
    fn take(&mut self, from_s: f64, _: f64) -> Option<(f64, OperatorRequest)> {
        let told = self.machine.try_borrow_mut().ok();
        let told = told
            .map(|mut machine| (self.shared.passes_tool(&mut *machine), machine.turned_by_hand()));
        let ((waits, wants_tool), turned) = told.unwrap_or_default();
        self.shared.waits(waits, wants_tool);
        turned.into_iter().for_each(|shares| self.shared.is_turned(shares));
        self.shared.link.lock().request().map(|request| (from_s, request))
    }

    fn turned(&mut self, _: f64) -> Option<Override> {
        let turned = self.shared.link.lock().turns.pop_front()?;
        let mut overrides = self.shared.hub.read(|now| now.overrides);
        match turned {
            Override::Rapid(percent) => {
                self.shared.board.borrow_mut().rapid = f64::from(percent) / 100.0;
                overrides.rapid_percent = Some(percent);
            }
            Override::Spindle(percent) => overrides.spindle_percent = Some(percent),
        }
        self.shared.hub.change(vec![Change::Overrides { overrides }]);
        Some(turned)
    }

    fn hurry(&self) -> Option<Hurry> {
        let link = self.shared.link.clone();
        Some(Hurry::new(move || link.lock().is_to_stop()))
    }

    fn heard(&mut self) {
        self.shared.link.want(|wanted| wanted.hear_stop());
    }

    /// Stands until somebody resumes, or stops, which ends the run.
    fn resumes(&mut self, held_s: f64) -> Option<f64> {
        let begin = Instant::now();
        self.shared.board.borrow_mut().stands_still();
        self.shared.state(State::Held);
        let mut wanted = self.shared.link.lock();
        loop {
            if wanted.gives_up() {
                return None;
            }
            if std::mem::take(&mut wanted.resume) || self.went_on() {
                break;
            }
            wanted = self.shared.link.wait(wanted, LOOK);
            drop(wanted);
            self.shared.look(&self.machine);
            wanted = self.shared.link.lock();
        }
        wanted.stands();
        drop(wanted);
        self.shared.state(State::Running);
        Some(held_s + begin.elapsed().as_secs_f64() * self.rate)
    }
}

/// The operator: whoever answers at a page.
pub struct Pages {
    shared: Shared,
    machine: Driven,
    asked: u32,
    stopped: bool,
    /// The last answer was a jog.
    jogged: bool,
    /// The last answer was a switch that was moved.
    pressed: bool,
}

impl Pages {
    /// Questions count from a number on, so that no answer goes to another run.
    pub const fn new(shared: Shared, machine: Driven, asked: u32) -> Self {
        Self { shared, machine, asked, stopped: false, jogged: false, pressed: false }
    }

    /// Returns the number of questions that were asked.
    pub const fn asked(&self) -> u32 {
        self.asked
    }

    /// Waits for an answer that means something in the box; nothing when the machine is stopped.
    fn wait(&mut self, question: &Question) -> Option<String> {
        let mut wanted = self.shared.link.lock();
        loop {
            if wanted.gives_up() {
                wanted.close();
                self.stopped = true;
                return None;
            }
            wanted.stands();
            if let Some(press) = wanted.presses.pop_front() {
                self.pressed = true;
                return Some(press.to_string());
            }
            if let Some(words) = wanted.given()
                && answers::meaning(question, &words).is_some()
            {
                if Jog::read(&words).is_none() || question.kind.takes_text() {
                    wanted.close();
                }
                return Some(words);
            }
            wanted = self.shared.link.wait(wanted, LOOK);
            drop(wanted);
            self.shared.look(&self.machine);
            if let Some(press) = answers::changed_input(&self.machine) {
                self.pressed = true;
                return Some(press.to_string());
            }
            wanted = self.shared.link.lock();
        }
    }
}

impl Operator for Pages {
    fn answer(&mut self, question: &Question, line: u32) -> Option<String> {
        self.answer_in(question, "", line)
    }

    fn answer_in(&mut self, question: &Question, file: &str, line: u32) -> Option<String> {
        // A question that is asked again after a jog, or after a switch was moved, is the same.
        let pressed = std::mem::take(&mut self.pressed);
        let again = std::mem::take(&mut self.jogged) || pressed;
        self.asked += u32::from(!again);
        let mut wanted = self.shared.link.lock();
        wanted.ask(self.asked);
        if !again && stands(question) {
            // What stopped the machine came before this stop, which wants no more than that.
            wanted.hear_stop();
        }
        if !pressed {
            wanted.jog = None;
        }
        drop(wanted);
        let state = if stands(question) { State::Stopped } else { State::Asking };
        let file = self.shared.parts.name_of(file);
        let edits = question.kind == QuestionKind::Editor;
        let edits = edits.then(|| self.shared.name_from_root(&question.text));
        let asked = asked(self.asked, question, file, line);
        let asked = Some(Asked { edits, ..asked });
        self.shared.becomes(state, vec![Change::Asked { asked }]);
        let answer = self.wait(question);
        let takes_text = question.kind.takes_text();
        let moves = |words: &str| !takes_text && (words == LIFT || Jog::read(words).is_some());
        self.jogged = answer.as_deref().is_some_and(moves);
        if !self.jogged && !self.pressed {
            self.answered();
        }
        answer
    }

    fn answered(&mut self) {
        self.pressed = false;
        self.shared.becomes(State::Running, vec![Change::Asked { asked: None }]);
    }

    fn moves(&mut self) {
        self.shared.state(State::Jogging);
    }

    fn gives_up(&self) -> bool {
        self.stopped
    }
}

/// Returns `true` if something stopped the machine in the middle: whoever does not answer ends the run. A job
/// that waits before its start, or at a pause mark, was meant to.
fn stands(question: &Question) -> bool {
    match question.kind {
        QuestionKind::Hold => true,
        QuestionKind::Paused => question.default != 0,
        _ => false,
    }
}

fn asked(number: u32, question: &Question, file: String, line: u32) -> Asked {
    Asked {
        number,
        kind: answers::kind_word(question.kind).into(),
        text: question.text.clone(),
        title: question.title.clone(),
        buttons: question.buttons.iter().map(|b| b.word().to_owned()).collect(),
        default: question.default as u32,
        prefill: question.prefill.clone(),
        entry: question.kind == QuestionKind::Input,
        icon: question.icon.into(),
        edits: None,
        file,
        line,
        was: State::Running,
    }
}

/// Puts events on the board.
#[derive(Debug)]
pub struct Teller {
    shared: Shared,
}

impl Teller {
    /// Tells pages.
    pub const fn new(shared: Shared) -> Self {
        Self { shared }
    }
}

impl Sink for Teller {
    fn event(&mut self, event: &Event) {
        let mut board = self.shared.board.borrow_mut();
        match event {
            Event::Message { .. } | Event::Wait { .. } | Event::State { .. } => {}
            _ => board.goes_on(),
        }
        match event {
            Event::Input { n, on, .. } => board.reads(*n, *on),
            Event::Print { text, .. } => board.print(text),
            Event::Message { text, .. } => board.comment(text),
            Event::Wait { seconds, t } => board.pause(*t, *seconds),
            Event::Sound { path, .. } => board.sound(self.shared.name_from_root(path)),
            Event::Diag(found) => board.finds(found),
            Event::Spindle { rpm, on, n: 1, .. } => board.spindle(if *on { *rpm } else { 0.0 }),
            Event::Homed { axis, steps, .. } => {
                board.say(Tone::Note, format!("{axis} homed; its last home was {steps} steps off"));
            }
            Event::Start { dialect: "job", .. } => board.begins_job(),
            Event::Heights { top, surface, bottom, .. } => board.heights([*top, *surface, *bottom]),
            Event::InForce { cut_mm_s, plunge_mm_s, raise, .. } => {
                let (cut_mm_s, plunge_mm_s, raise) = (*cut_mm_s, *plunge_mm_s, *raise);
                board.in_force(InForce { cut_mm_s, plunge_mm_s, raise });
            }
            Event::Clear { .. } => {
                drop(board);
                self.shared.hub.cleared(true);
                self.shared.hub.draws_typed_anew();
                return;
            }
            Event::Mode { .. } => {
                drop(board);
                self.shared.hub.draws_typed_anew();
                return;
            }
            Event::Override { percent, .. } => {
                board.feed = percent / 100.0;
                drop(board);
                let overrides = self.shared.hub.read(|now| now.overrides);
                let overrides = Overrides { feed_percent: *percent, ..overrides };
                self.shared.hub.change(vec![Change::Overrides { overrides }]);
                return;
            }
            _ => {}
        }
        board.tell_sometimes();
    }

    fn looks_at_motion(&self) -> bool {
        false
    }

    fn made(&mut self, made: &ExecutedMove<'_>) {
        self.shared.board.borrow_mut().made(made);
    }

    fn made_before(&mut self, made: &ExecutedMove<'_>) {
        self.shared.board.borrow_mut().made_before(made);
    }

    fn under_way(&mut self, doing: &Doing<'_>, _: f64, now_s: f64) {
        let mut board = self.shared.board.borrow_mut();
        if let Some(planned) = self.shared.link.plan_of(board.run()) {
            board.plans(planned);
        }
        board.see(doing, now_s);
        board.tell_sometimes();
    }

    fn displays(&mut self, comments: bool) {
        self.shared.board.borrow_mut().displays(comments);
    }

    fn run_status(&mut self, standing: &RunStatus) {
        let mut board = self.shared.board.borrow_mut();
        board.stands(&standing.files);
        board.watches(to_wire::named(standing.watched.clone()));
    }

    fn watches(&self) -> Vec<String> {
        self.shared.link.watched()
    }

    fn looks_at_status(&self) -> bool {
        true
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::testing::{self, Bench};
    use kerf_wire::{Act, ByHand};

    /// Waits for something of a machine that runs.
    #[track_caller]
    fn until(bench: &Bench, what: &str, holds: impl Fn(&kerf_wire::Snapshot) -> bool) {
        let begun = Instant::now();
        while !bench.app.hub.read(&holds) {
            assert!(begun.elapsed() < Duration::from_secs(20), "{what}");
            std::thread::sleep(Duration::from_millis(2));
        }
    }

    #[test]
    fn a_computer_that_sleeps_in_the_middle_of_a_move_stops_the_machine() {
        let (bench, _machine) = testing::moving();
        let act = Act::Command { lease: bench.lease(), line: "MS,1,1\nMX,50".into() };
        bench.does(&bench.driver, act);
        until(&bench, "some way", |now| now.motion.at.machine[0] > 1.0);
        bench.app.clock.forward(Duration::from_secs(3600));
        until(&bench, "a question", |now| now.machine.state == State::Stopped);
        let told = bench.app.hub.read(|now| now.messages.clone());
        assert!(
            told.iter().any(|it| it.text.starts_with("the computer slept for 3600 s")),
            "{told:?}"
        );
        let stopped = bench.app.hub.read(|now| now.motion.at.machine[0]);
        assert!(stopped < 40.0 * 25.4, "an hour of the move was not made: {stopped}");
        bench.app.link.leave();
    }

    /// STOP, and Hold while the machine slows down for it.
    #[test]
    fn a_machine_that_slows_down_is_not_said_to_stand() {
        let (bench, _machine) = testing::moving();
        let mut place = [None; 6];
        place[0] = Some(1000.0);
        let way = ByHand::Place { place, relative: true, flat: false };
        bench.does(&bench.driver, Act::Go { lease: bench.lease(), way });
        until(&bench, "some speed", |now| now.motion.speed_mm_s > 100.0);
        bench.app.link.stop();
        std::thread::sleep(Duration::from_millis(30));
        bench.does(&bench.driver, Act::Hold);
        until(&bench, "a question", |now| now.machine.state == State::Stopped);
        let place = || bench.app.hub.read(|now| now.motion.at.machine[0]);
        let said = place();
        bench.app.link.stop();
        until(&bench, "the end", |now| now.machine.state == State::Idle);
        assert!((place() - said).abs() < 0.1, "it stood at {}, not at {said}", place());
        bench.app.link.leave();
    }
}
