//! The owner of the machine, on its thread.

use super::arrived::StopCount;
use super::board::Board;
use super::last_state::LastState;
use super::link::Link;
use super::order::Order;
use super::planned::Planned;
use super::run_context::{Clock, PageRequests, Pages, Shared, Teller};
use super::typing::{Screen, Typing};
use crate::files::PartFolder;
use crate::handconsole::Happening;
use crate::hub::Hub;
use crate::setting_changes::SettingChanges;
use crate::setup::Workshop;
use crate::to_wire;
use kerf_control::controller::Controller;
use kerf_control::{AtRest, RunContext};
use kerf_journal::{Journal, JournalError, Live, RunOptions, Work};
use kerf_machine::{Configuration, Errand, Keypad, hand};
use kerf_program::{AXES, Axis};
use kerf_sbp::Status;
use kerf_sim::Simulated;
use kerf_trace::Summary;
use kerf_wire::{Change, CurrentRun, Machine, Overrides, State, Tone};
use kerf_workspace::{Workspace, unverified};
use std::cell::RefCell;
use std::io;
use std::rc::Rc;
use std::sync::mpsc::{Receiver, Sender, TryRecvError};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

/// Time between two looks whether other software passed a command in.
const LOOK: Duration = Duration::from_millis(100);

/// Function that builds the files of a run which changes none.
pub type PreviewFiles = Arc<dyn Fn() -> io::Result<Workspace> + Send + Sync>;

/// The owner.
pub struct Owner {
    /// Tells the pages.
    pub hub: Arc<Hub>,
    /// Carries what is wanted meanwhile.
    pub link: Arc<Link>,
    /// The machine and its files.
    pub workshop: Workshop,
    /// The part folder.
    pub parts: PartFolder,
    /// The machine and its files as the last run left them, for previews and forms.
    pub left: Arc<Mutex<LastState>>,
    /// Seconds of machine time in a second.
    pub rate: f64,
    /// Told after each order, with the file that a tool made.
    pub done: Box<dyn Fn(Option<String>) + Send>,
    /// The history of changes of settings.
    pub changes: Arc<SettingChanges>,
    /// Screen on which a file gets that a typed line runs.
    pub screen: Screen,
    /// Told when a part file closes Kerf (EXIT SHOPBOT), where it may.
    pub closing: Option<Sender<()>>,
    /// Questions that were asked so far.
    pub asked: u32,
    /// Runs so far.
    pub run: u32,
    /// Stops that had come when it was looked last for a command that was passed in.
    pub looked: Option<StopCount>,
    /// The reason for which the controller takes no orders, as it was told last.
    pub locked: Option<String>,
    /// What the controller waits for while nothing runs, as it was told last.
    pub waits: Option<&'static str>,
    /// Builds the files of a dry run, which changes none.
    pub previews: PreviewFiles,
}

impl Owner {
    /// Tells what was found wrong with the files of the data folder.
    pub fn tell_found(&self) {
        let told =
            self.workshop.workspace.journal().map(Journal::mistakes_found).unwrap_or_default();
        told.into_iter().for_each(|line| self.hub.say(Tone::Warning, line));
        self.tell_attached(&self.workshop.told);
    }

    /// Shows where the machine stands, and whether that is sure.
    pub fn begin(&mut self) {
        let doubted = unverified(&self.workshop.workspace);
        let letters: Vec<String> = doubted.iter().map(|axis| axis.letter().to_string()).collect();
        let why = (!letters.is_empty()).then(|| {
            let axes = letters.join(" ");
            format!("where the machine stands is not verified: home {axes}, or zero them anew")
        });
        if let Some(why) = &why {
            self.hub.say(Tone::Warning, why.clone());
        }
        self.settle(|machine| {
            let alarm = machine.why.clone().filter(|_| machine.state == State::Alarm);
            Machine { why: alarm.or(why), ..machine.clone() }
        });
    }

    /// Works until nobody gives orders any more, or Kerf ends.
    pub fn work(mut self, orders: &Receiver<Order>) {
        self.link.wakes_this_thread();
        loop {
            if self.link.lock().leaves {
                self.move_switches();
                self.tell_others(&Live::default());
                self.rest_journal();
                self.detach();
                let Workshop { session, workspace, .. } = &mut self.workshop;
                return workspace.close_system_log(&session.memory.settings, "NORMAL");
            }
            let order = match self.next(orders, LOOK) {
                Ok(order) => {
                    self.look_for_passed_in();
                    order
                }
                Err(TryRecvError::Empty) => match self.passed_in() {
                    Some(line) => {
                        Order::Command { line, opened: false, file: None, draws_only: false }
                    }
                    None => {
                        self.catch_up();
                        self.rest_journal();
                        continue;
                    }
                },
                Err(TryRecvError::Disconnected) => break,
            };
            let moved = self.move_switches();
            match order {
                Order::Switches if !moved => continue,
                Order::File { work, name, hash, planned, parameters, opened, draws_only } => {
                    let mut options = RunOptions { opened, ..self.options() };
                    (options.program.file, options.program.draws_only) = (parameters, draws_only);
                    let hash = Some(hash);
                    let job = CurrentRun { file: name, hash, draws_only, ..CurrentRun::default() };
                    self.run(*work, options, job, planned);
                }
                Order::TakeUp { hash, planned } => self.take_up(hash, planned),
                Order::Command { line, opened, file, draws_only } => {
                    self.command(&line, opened, file, draws_only);
                }
                Order::StartUp { lines, since } => self.start_up(&lines, since),
                Order::Jog { direction, distance, speed } => self.jog(direction, distance, speed),
                Order::Hand { errand, machine, tells } => self.hand(errand, *machine, &tells),
                Order::CutMove { at, machine } => self.cut_move(at, *machine),
                Order::Switch(number, on) => self.switch(number, on),
                Order::Zero { name, change } => self.change_zero(&name, change),
                Order::Tool { number, change } => self.change_tool(number, &change),
                Order::Setting { number, value } => self.change_setting(number, &value),
                Order::Question(line) => self.ask_controller(&line),
                Order::ForgetPace => self.forget_pace(),
                Order::ToolIn => self.tool_is_in(),
                Order::TouchOff => self.touch_off(),
                Order::Card(order) => self.does_on_card(order),
                Order::HeightMap(text) => self.take_height_map(text.as_deref()),
                Order::Nudge(axis, distance) => self.nudge(axis, distance),
                Order::Folder { path, mask } => self.enter(&path, mask.as_deref()),
                Order::Record(line) => self.record(&line),
                Order::Watched | Order::Switches => {}
                Order::Configure { setting, wanted, change, tells } => {
                    self.configure(setting, *wanted, change.as_ref(), &tells);
                }
                Order::Hold { wanted, tells } => self.hold(*wanted, &tells),
                Order::Keep(tells) => self.keep(&tells),
                Order::Refused(told) => self.log_refused(&told),
            }
            self.order_is_done();
        }
    }

    /// Tells what an order has left in the workspace.
    fn order_is_done(&mut self) {
        self.tell_workspace();
        let made = self.workshop.workspace.take_made();
        (self.done)(made.map(|path| self.parts.name_of(&path)));
    }

    /// Waits for the next order, so long at most. What is stopped meanwhile is off at once: a stop wakes this thread,
    /// as an order does.
    pub(super) fn next(
        &mut self,
        orders: &Receiver<Order>,
        most: Duration,
    ) -> Result<Order, TryRecvError> {
        let begun = Instant::now();
        loop {
            let order = orders.try_recv();
            // After the order: what was stopped before it is off before it begins.
            self.stop_at_rest();
            self.attend();
            if matches!(order, Err(TryRecvError::Empty)) {
                self.follow_card();
            }
            let left = most.saturating_sub(begun.elapsed());
            if !matches!(order, Err(TryRecvError::Empty))
                || left.is_zero()
                || self.link.lock().leaves
            {
                return order;
            }
            thread::park_timeout(left);
        }
    }

    fn options(&self) -> RunOptions {
        let controller = self.controller_name().map(str::to_owned);
        RunOptions { started: (self.workshop.started)(), controller, ..RunOptions::default() }
    }

    /// Runs something that pages see as a job.
    fn run(&mut self, work: Work, options: RunOptions, job: CurrentRun, planned: Planned) {
        let job = self.tell_begun(job, &planned);
        let line = job.command.as_deref();
        let typing = line.map(|line| Typing::of(line, self.run, self.screen.clone()));
        let driven = self.drive(work, options, planned, typing);
        self.tell_ended(job, driven);
    }

    /// Goes on with the run that was cut short, whatever file is open.
    fn take_up(&mut self, hash: Option<String>, planned: Planned) {
        let cut = match self.cut_short() {
            Ok(Some(cut)) => cut,
            Ok(None) => return self.rest(State::Idle, None),
            Err(error) => return self.rest(State::Idle, Some(error.to_string())),
        };
        if let Some(why) = self.bars_taking_up() {
            return self.rest(State::Idle, Some(why));
        }
        let file = self.parts.name_of(cut.file());
        let job = self.tell_begun(CurrentRun { file, hash, ..CurrentRun::default() }, &planned);
        let driven = self.in_context(planned, None, |workshop, context| {
            workshop.session.resume(&cut, &mut workshop.workspace, context)
        });
        self.tell_ended(job, driven);
    }

    /// Tells that something begins that pages see as a job.
    pub(super) fn tell_begun(&mut self, job: CurrentRun, planned: &Planned) -> CurrentRun {
        self.run += 1;
        let seconds = if job.from_card { job.seconds } else { planned.seconds() };
        let job = CurrentRun { run: self.run, seconds, ..job };
        if job.command.is_none() && !job.from_card {
            self.hub.begins(&job);
            self.hub.cleared(false);
            self.hub.moves_on();
        }
        let more = self.driven().borrow().facts().overrides_more.then_some(100);
        let overrides =
            Overrides { rapid_percent: more, spindle_percent: more, ..Overrides::default() };
        self.hub
            .change(vec![Change::Job { job: Some(job.clone()) }, Change::Overrides { overrides }]);
        job
    }

    fn tell_ended(&mut self, job: CurrentRun, driven: Result<Summary, JournalError>) {
        let (ended, error) = match &driven {
            Ok(summary) => (summary.status.word(), summary.error.as_deref()),
            Err(_) => ("failed", None),
        };
        let (ended, error) = (Some(ended.into()), error.map(kerf_language::finding));
        let summary = driven.as_ref().ok().map(to_wire::summary);
        self.note_settings(&job);
        // Whoever hears of the end reads what the run left: variables, settings, places.
        self.tell_workspace();
        self.hub.ended(CurrentRun { ended, error, summary, ..job });
        self.come_to_rest(driven);
    }

    /// Runs something to its end, told to pages.
    fn drive(
        &mut self,
        work: impl Into<Work>,
        options: RunOptions,
        planned: Planned,
        typing: Option<Typing>,
    ) -> Result<Summary, JournalError> {
        let work = work.into();
        if let Some(refused) = self.refuses(&work, &options) {
            return Ok(refused);
        }
        self.in_context(planned, typing, |workshop, context| {
            let Workshop { session, workspace, kept, .. } = workshop;
            match kept {
                true => session.run_on_record(work, options, None, workspace, context),
                false => Ok(session.run(work, options, workspace, context)),
            }
        })
    }

    /// Something runs, told to pages; whoever sits at them answers its questions.
    fn in_context(
        &mut self,
        planned: Planned,
        typing: Option<Typing>,
        runs: impl FnOnce(&mut Workshop, RunContext<'_>) -> Result<Summary, JournalError>,
    ) -> Result<Summary, JournalError> {
        let machine = self.workshop.session.configuration();
        let mut board =
            Board::new(self.hub.clone(), self.run, planned, machine, self.parts.clone(), self.rate);
        board.typed(typing);
        let board = Rc::new(RefCell::new(board));
        let shared = Shared {
            board: board.clone(),
            hub: self.hub.clone(),
            link: self.link.clone(),
            parts: self.parts.clone(),
        };
        let simulated = || Simulated::opened(Clock::new(shared.clone(), self.rate));
        let controller = self.workshop.controller.clone();
        let opened = controller.as_ref().map_or_else(simulated, |it| it.driven().into());
        let machine = opened.machine.clone();
        let mut requests = PageRequests::new(shared.clone(), machine.clone(), self.rate);
        let mut pages = Pages::new(shared.clone(), machine, self.asked);
        let mut teller = Teller::new(shared);
        let context = RunContext {
            sink: &mut teller,
            operator: &mut pages,
            requests: &mut requests,
            machine: opened,
        };
        self.link.arrived().runs(true);
        if let Some(controller) = &controller {
            controller.begins(&mut self.workshop.workspace);
        }
        let summary = runs(&mut self.workshop, context);
        if let Some(controller) = &controller {
            let well = summary.as_ref().is_ok_and(|summary| summary.status == Status::Ok);
            let link = self.link.clone();
            controller.ends(well, &mut self.workshop.workspace, || link.lock().is_to_stop());
        }
        self.link.arrived().runs(false);
        self.asked = pages.asked();
        self.link.lock().close();
        board.borrow_mut().ends();
        if let Some(planned) = self.link.plan_of(self.run) {
            board.borrow_mut().plans(planned);
            board.borrow_mut().ends();
        }
        summary
    }

    /// A run is over: what the machine is afterwards.
    pub(super) fn come_to_rest(&mut self, driven: Result<Summary, JournalError>) {
        let summary = match driven {
            Ok(summary) => summary,
            Err(error) => {
                let why = format!("what a run leaves cannot be kept: {error}");
                return self.rest(State::Alarm, Some(why));
            }
        };
        let why = summary.error.as_deref().map(to_wire::sentence);
        match summary.status {
            Status::Limit => self.rest(State::Alarm, why.or(Some("stopped by a limit".into()))),
            Status::Stopped if why.is_some() => self.rest(State::Alarm, why),
            _ => self.rest(State::Idle, None),
        }
        if summary.closes {
            self.close();
        }
    }

    /// A part file closes Kerf; without leave only its run has ended.
    fn close(&mut self) {
        let Some(closing) = &self.closing else { return };
        let Workshop { session, workspace, .. } = &mut self.workshop;
        workspace.close_system_log(&session.memory.settings, "NORMAL");
        // Nobody waits where the server is part of another program.
        _ = closing.send(());
    }

    /// The machine stands. An alarm disarms it.
    pub(super) fn rest(&mut self, state: State, why: Option<String>) {
        let (alarm, link) = (state == State::Alarm, self.link.clone());
        self.settle(|machine| {
            if alarm {
                link.forestall();
            }
            let armed = machine.armed && !alarm;
            Machine { state, armed, why, ..machine.clone() }
        });
    }

    /// Tells how the machine stands, and what it is from now on.
    pub(super) fn settle(&mut self, becomes: impl FnOnce(&Machine) -> Machine) {
        self.tell_workspace();
        self.tell_others(&self.workshop.session.look(Live::at_rest));
        let (settings, frame, position) = {
            let memory = &self.workshop.session.memory;
            (&memory.settings, &memory.frame, memory.position)
        };
        let offers = to_wire::offers(self.driven().borrow().facts());
        let pace = self.workshop.controller.as_ref().and_then(to_wire::pace);
        self.hub.changing(|now| {
            let mode = to_wire::mode(&self.workshop.session);
            let name = to_wire::machine_name(&self.workshop.session);
            let machine = Machine { mode, name, offers, pace, ..becomes(&now.machine) };
            let at = to_wire::positions(frame, position);
            let motion = kerf_wire::Motion { at, speed_mm_s: 0.0, cutting: false, ..now.motion };
            let speeds = kerf_wire::Speeds { rpm: now.speeds.rpm, ..to_wire::speeds(settings) };
            let session = &self.workshop.session;
            let io = session.look(|machine| {
                to_wire::io(machine, machine.clock_s(), &session.machine_is, &now.io)
            });
            vec![
                Change::Io { io },
                Change::Motion { motion },
                Change::Units { units: to_wire::units(settings) },
                Change::Speeds { speeds },
                Change::Machine { machine },
            ]
        });
    }

    pub(super) fn command(
        &mut self,
        line: &str,
        opened: bool,
        file: Option<(String, Planned)>,
        draws_only: bool,
    ) {
        let program = kerf_sbp::read_typed("command".into(), &format!("{line}\n"));
        let mut options = RunOptions { opened, ..self.options() };
        (options.program.typed, options.program.draws_only) = (true, draws_only);
        let (hash, planned) = file.unzip();
        let job =
            CurrentRun { command: Some(line.into()), hash, draws_only, ..CurrentRun::default() };
        self.run(program.into(), options, job, planned.unwrap_or_default());
    }

    /// Moves for as long as somebody holds a key, as far as the axes go.
    fn jog(&mut self, way: [f64; AXES], times: Option<f64>, speed: f64) {
        let session = &self.workshop.session;
        let keypad = Keypad { way, times, speed, homed: session.homed };
        let machine = Arc::new(session.configuration());
        let driven = self.held(Work::Hand(Errand::Keypad(keypad), machine));
        self.come_to_rest(driven);
    }

    /// Moves for as long as somebody holds a key.
    pub(super) fn held(&mut self, work: Work) -> Result<Summary, JournalError> {
        self.drive(work, self.options(), Planned::default(), None)
    }

    /// Does an errand, and tells how it ended. Whoever waits for that knows it before anybody sees that the
    /// machine stands: the next key finds both so.
    fn hand(&mut self, errand: Errand, machine: Configuration, tells: &Sender<Happening>) {
        let (held, name) = (matches!(errand, Errand::Held(_)), errand.name());
        let work = Work::Hand(errand, Arc::new(machine));
        // Nobody waits for it where the server is closing.
        let tell = |driven: &_| drop(tells.send(Happening::Outcome(to_wire::outcome(driven))));
        if held {
            let driven = self.held(work);
            tell(&driven);
            return self.come_to_rest(driven);
        }
        let job = CurrentRun { command: Some(name.into()), ..CurrentRun::default() };
        let job = self.tell_begun(job, &Planned::default());
        let driven = self.drive(work, self.options(), Planned::default(), None);
        tell(&driven);
        self.tell_ended(job, driven);
    }

    /// CutMoveTo with cutting: a job of one line.
    fn cut_move(&mut self, at: [f64; 2], machine: Configuration) {
        self.catch_up();
        let cut = hand::cut_move(&machine, self.workshop.session.memory.position, at);
        let job = CurrentRun { command: Some("cut move to".into()), ..CurrentRun::default() };
        let work = Work::Job(Arc::new(cut), Arc::new(machine));
        self.run(work, self.options(), job, Planned::default());
    }

    /// Switches an output of a machine that stands.
    fn switch(&mut self, number: u8, on: bool) {
        self.catch_up();
        let driven = self.driven();
        AtRest(&mut self.workshop.session).switch(number, on, &driven);
        self.rest(State::Idle, None);
    }

    /// Moves the tool a little, and the working zero as far as it came.
    fn nudge(&mut self, axis: Axis, distance: f64) {
        self.catch_up();
        let session = &self.workshop.session;
        let (before, machine) = (session.memory.position, Arc::new(session.configuration()));
        let driven = match session.nudge(axis, distance) {
            Ok(errand) => self.held(Work::Hand(errand, machine)),
            Err(outside) => {
                self.rest(State::Idle, None);
                return self.hub.say(Tone::Error, outside.to_string());
            }
        };
        let Workshop { session, workspace, kept, .. } = &mut self.workshop;
        session.nudged(before);
        let unkept = if *kept { session.keep_place(workspace).err() } else { None };
        self.come_to_rest(driven);
        if let Some(error) = unkept {
            let why = format!("the nudge holds until Kerf ends, it cannot be kept: {error}");
            self.hub.say(Tone::Error, why);
        }
    }

    /// Tells other programs how the machine stands.
    fn tell_others(&self, rest: &Live) {
        let Workshop { workspace, kept, .. } = &self.workshop;
        // Where the disk refuses, that was told when the run ended; pages know better all the same.
        drop(workspace.journal().filter(|_| *kept).map(|journal| journal.registry.tell_rest(rest)));
    }

    /// Puts what other threads and programs have changed into the one file of the journal, while nothing runs.
    fn rest_journal(&self) {
        // Where the disk refuses, whoever changed something was told; it is in the write-ahead file.
        drop(self.workshop.workspace.journal().map(Journal::rest));
    }

    /// Leaves a copy of the session for previews.
    pub(super) fn leave(&self) {
        let Workshop { session, workspace, controller, .. } = &self.workshop;
        let left = LastState {
            session: session.clone(),
            folder: workspace.part_folder().to_owned(),
            mask: workspace.mask().to_owned(),
            journal: workspace.journal().cloned(),
            limits: controller.as_ref().and_then(Controller::card_limits),
        };
        *self.left.lock().unwrap_or_else(PoisonError::into_inner) = left;
    }
}
