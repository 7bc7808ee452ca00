//! The controller that the server drives, where there is one: looked at while nothing runs, and asked before a run whether
//! it has all that the run needs.

use super::card_run::{CardProgress, CardRun};
use super::order::CardOrder;
use super::owner::Owner;
use super::planned::Planned;
use super::zeros;
use crate::controller_card::seconds_of;
use crate::setup::Workshop;
use crate::to_wire;
use kerf_control::AtRest;
use kerf_control::answers::Answers;
use kerf_control::controller::{AttachReport, CardEnd, Controller, WrittenSetting, working_reads};
use kerf_diag::{Code, Diagnostic, SourcePlace};
use kerf_journal::{RunOptions, Work};
use kerf_machine::driver::{CardJob, CardTask, ToldSetting, Zero, ZeroChange};
use kerf_machine::{Driven, Errand};
use kerf_program::{AXES, Axes};
use kerf_trace::Summary;
use kerf_wire::{
    Change, ControllerCard, ControllerSetting, CurrentRun, Machine, Message, State, Tone,
};
use std::cell::RefCell;
use std::sync::Arc;
use std::sync::atomic::Ordering;

/// A controller that stands farther from where the machine is believed to be was moved by somebody, mm.
const MOVED_MM: f64 = 0.01;

/// The axis of the tool.
const Z: usize = 2;

/// A setting as pages show it.
fn set(told: ToldSetting) -> ControllerSetting {
    let ToldSetting { number, value, name, unit, bounds: (least, most), does, own } = told;
    ControllerSetting { number, value, name, unit, least, most, does: does.to_owned(), own }
}

/// The change by which pages see that the controller has a card, or why it has none; nothing where they see that.
fn is_card(shown: &ControllerCard, has: Result<(), &str>) -> Option<Change> {
    let why = has.err().unwrap_or_default();
    let is_other = shown.has != has.is_ok() || shown.why != why;
    let card = || ControllerCard { has: has.is_ok(), why: why.to_owned(), ..shown.clone() };
    is_other.then(|| Change::ControllerCard { controller_card: card() })
}

/// A zero point as pages show it.
fn shown(zero: Zero) -> kerf_wire::Zero {
    kerf_wire::Zero { name: zero.name, at: zero.at.0, holds: zero.holds }
}

impl Owner {
    /// The machine that makes what is switched while nothing runs.
    pub(super) fn driven(&self) -> Driven {
        let controller = self.workshop.controller.as_ref();
        controller.map_or_else(|| kerf_control::simulated().machine, Controller::driven)
    }

    /// Tells what was found when the controller was attached.
    pub(super) fn tell_attached(&self, told: &AttachReport) {
        told.notes.iter().for_each(|line| self.hub.say(Tone::Note, line.clone()));
        told.warnings.iter().for_each(|line| self.hub.say(Tone::Warning, line.clone()));
    }

    /// Kerf ends: what was changed in the controller is put back.
    pub(super) fn detach(&mut self) {
        let Workshop { controller, workspace, .. } = &mut self.workshop;
        if let Some(controller) = controller {
            controller.detach(workspace);
        }
    }

    /// Looks at the controller while nothing runs: its inputs, a place to which somebody else moved it, an alarm.
    pub(super) fn attend(&mut self) {
        let Workshop { controller, session, .. } = &mut self.workshop;
        let Some(controller) = controller else { return };
        let lost = self.hub.read(|now| now.machine.state == State::Alarm);
        let (inputs, place) = controller.attend();
        let driven_by = controller.driven_by().filter(|_| controller.fault().is_none());
        let is_set_anew = driven_by.is_some() && driven_by != session.driven_by;
        if is_set_anew {
            session.driven_by = driven_by;
        }
        let controller_steps = controller.steps_per_mm();
        let controller_settings: Vec<_> = controller.settings().into_iter().map(set).collect();
        let card = controller.has_card();
        let zeros: Vec<_> = controller.zeros().into_iter().map(shown).collect();
        let (fault, locked, waits) = (controller.fault(), controller.locked(), controller.waits());
        let wants_tool = controller.driven().borrow_mut().waits_for_tool();
        let touches_off = controller.driven().borrow_mut().touches_off();
        let memory = &mut session.memory;
        // What is only drawn is elsewhere than the machine.
        let drawn = &mut memory.before_preview;
        let believed = drawn.as_mut().map_or(&mut memory.position, |before| &mut before.position);
        let far = |place: &Axes| place.minus(*believed).0.iter().any(|mm| mm.abs() > MOVED_MM);
        let moved = place.filter(far);
        let changed = !inputs.is_empty() || moved.is_some();
        if let Some(place) = moved {
            *believed = place;
        }
        inputs.into_iter().for_each(|input| AtRest(&mut *session).senses(input));
        self.hub.changing(|now| {
            let zeros = (now.zeros != zeros).then_some(Change::Zeros { zeros });
            let other = now.controller_steps != controller_steps;
            let steps = other.then_some(Change::ControllerSteps { controller_steps });
            let other = now.controller_settings != controller_settings;
            let settings = other.then_some(Change::ControllerSettings { controller_settings });
            let card = is_card(&now.controller_card, card);
            zeros.into_iter().chain(steps).chain(settings).chain(card).collect()
        });
        match fault {
            Some(why) if !lost => self.rest(State::Alarm, Some(why)),
            _ if locked != self.locked => self.lock(locked),
            _ if changed => self.settle(Machine::clone),
            _ => {}
        }
        self.tell_waits(waits, wants_tool, touches_off);
        if is_set_anew {
            // The open file takes another time from now on.
            self.leave();
            (self.done)(None);
        }
    }

    /// Tells for what the controller waits at its own controls while nothing runs, whether that is a tool, and whether it touches
    /// it off.
    fn tell_waits(&mut self, waits: Option<&'static str>, wants_tool: bool, touches_off: bool) {
        let before = std::mem::replace(&mut self.waits, waits);
        self.hub.changing(|now| {
            let mut machine = Machine { wants_tool, touches_off, ..now.machine.clone() };
            machine.why = machine.why.filter(|told| Some(&**told) != before);
            machine.why = machine.why.or(waits.map(str::to_owned));
            let other = machine != now.machine;
            other.then_some(Change::Machine { machine }).into_iter().collect()
        });
    }

    /// Does something on the card of the controller; a file that is run is followed to its end.
    pub(super) fn does_on_card(&mut self, order: CardOrder) {
        self.catch_up();
        let CardOrder { task, given_up, tells } = order;
        let runs = matches!(task, CardTask::Run(_));
        let (hub, link) = (self.hub.clone(), self.link.clone());
        let mut progress = CardProgress::new(hub);
        let done = self.reach().and_then(|()| {
            let missing = "there is no controller that has a card";
            let controller = self.workshop.controller.as_ref().ok_or(missing)?;
            let mut goes = |done, all| progress.goes(done, all);
            // One that begins a file hears a stop when it runs. A stop gives up the whole task.
            let mut is_stopped = || {
                let stops = !runs && link.lock().is_to_stop();
                given_up.fetch_or(stops, Ordering::Relaxed) || stops
            };
            controller.does_on_card(task, &mut goes, &mut is_stopped)
        });
        let begun = runs && done.is_ok();
        if !begun {
            self.rest(State::Idle, None);
            self.attend();
        }
        // Nobody waits for it where the server is closing.
        drop(tells.send(done));
        if begun {
            self.follows_card(true);
        }
    }

    /// Follows a file that the controller runs from its own card, and that nobody here has begun.
    pub(super) fn follow_card(&mut self) {
        let controller = self.workshop.controller.as_ref();
        if controller.and_then(Controller::card_job).is_none() {
            return self.attaches();
        }
        let mut follows = false;
        self.hub.changing(|now| {
            follows = now.machine.state == State::Idle && self.link.begin(None, None);
            let machine = Machine { state: State::Running, why: None, ..now.machine.clone() };
            follows.then_some(Change::Machine { machine }).into_iter().collect()
        });
        if follows {
            self.follows_card(false);
        }
    }

    /// Attaches a controller that ran a file from its card when Kerf began, as soon as that is over.
    fn attaches(&mut self) {
        let is_beside = self.workshop.controller.as_ref().is_some_and(Controller::is_beside);
        let stands = self.hub.read(|now| now.machine.state == State::Idle);
        if is_beside
            && stands
            && let Err(why) = self.reach()
        {
            self.rest(State::Alarm, Some(why));
        }
    }

    /// Follows a file that the controller runs from its own card to its end: one that begins here, or was begun before.
    fn follows_card(&mut self, begins: bool) {
        let Some(controller) = self.workshop.controller.clone() else { return };
        let Some(CardJob { name, .. }) = controller.card_job() else {
            return self.rest(State::Idle, None);
        };
        let seconds = self.hub.read(|now| seconds_of(now, &name)).unwrap_or_default();
        let job = CurrentRun { file: name, from_card: true, seconds, ..CurrentRun::default() };
        let job = self.tell_begun(job, &Planned::default());
        let frame = self.workshop.session.memory.frame;
        let ends = (self.hub.clone(), self.link.clone());
        let run = RefCell::new(CardRun::new(ends, frame, &job, begins));
        self.link.arrived().runs(true);
        let ended = controller
            .follows_card(&mut |state| run.borrow_mut().tells(state), &mut || {
                run.borrow_mut().wish()
            });
        self.link.arrived().runs(false);
        if matches!(ended, Ok(CardEnd::Left)) {
            return;
        }
        self.link.lock().hear_stop();
        self.card_ended(&controller, job, ended);
    }

    /// A file that ran from the card is over: tells how, and stands where that has left the machine.
    fn card_ended(
        &mut self,
        controller: &Controller,
        job: CurrentRun,
        ended: Result<CardEnd, String>,
    ) {
        let name = job.file.clone();
        let (word, why, is_lost) = match ended {
            Ok(CardEnd::Ended | CardEnd::Left) => ("ok", None, false),
            Ok(CardEnd::Stopped) => ("stopped", None, false),
            Ok(CardEnd::Failed(why)) => {
                ("failed", Some(format!("{name} from the card has ended: {why}")), false)
            }
            Err(why) => ("failed", Some(why), true),
        };
        self.hub.ended(CurrentRun { ended: Some(word.into()), ..job });
        if let Some(why) = &why {
            self.hub.say(Tone::Error, why.clone());
        }
        if is_lost {
            return self.rest(State::Alarm, why);
        }
        self.rest(State::Idle, None);
        if word == "stopped" {
            self.hub
                .say(Tone::Note, format!("{name} ran from the controller's card, and was stopped"));
        }
        self.attaches();
        self.attend();
        controller.stood_by_card(&mut self.workshop.workspace);
        let Workshop { session, workspace, kept, .. } = &mut self.workshop;
        if *kept && let Err(error) = session.keep_place(workspace) {
            self.hub.say(Tone::Error, format!("where it stands cannot be kept: {error}"));
        }
        if word == "stopped" {
            self.lifts_from_card();
        }
        (self.done)(None);
    }

    /// Lifts the tool to safe Z behind a stop, as behind that of a run: of a machine that is armed, and whose place is known.
    fn lifts_from_card(&mut self) {
        let knows = self.workshop.controller.as_ref().is_some_and(|it| it.doubts_place().is_none());
        let armed = self.hub.read(|now| now.machine.armed && now.machine.state == State::Idle);
        let Some(up_mm) = self.workshop.session.lift_mm().filter(|_| knows && armed) else {
            return;
        };
        let mut place = [None; AXES];
        place[Z] = Some(up_mm);
        let lift = Errand::To { place, relative: false, flat: false };
        let machine = Arc::new(self.workshop.session.configuration());
        let driven = self.held(Work::Hand(lift, machine));
        self.come_to_rest(driven);
    }

    /// Ends a file that the controller runs from its own card, and that nobody here has begun.
    pub(super) fn stop_card(&mut self) {
        let Some(controller) = &self.workshop.controller else { return };
        let Some(job) = controller.card_job() else { return };
        match controller.stops_card() {
            Ok(()) => {
                let text = format!("{} ran from the controller's card, and was stopped", job.name);
                self.hub.say(Tone::Note, text);
            }
            Err(why) => self.hub.say(Tone::Error, why),
        }
        self.attend();
    }

    /// The tool is in for which the controller waits.
    pub(super) fn tool_is_in(&mut self) {
        self.driven().borrow_mut().tool_is_in();
        self.rest(State::Idle, None);
    }

    /// Has the controller touch off the tool for which it waits; Z zero follows the length.
    pub(super) fn touch_off(&mut self) {
        self.catch_up();
        let link = self.link.clone();
        let controller = &self.workshop.controller;
        let missing = || Err("there is no controller that waits for a tool".to_owned());
        let touched = controller
            .as_ref()
            .map_or_else(missing, |controller| controller.touches_off(|| link.lock().is_to_stop()));
        match touched {
            Err(why) => {
                self.hub.say(Tone::Error, why);
                self.rest(State::Idle, None);
            }
            Ok(touched) => {
                self.attend();
                self.moves_zero(touched.higher_mm);
                self.hub.say(Tone::Note, touched.sentence());
            }
        }
        self.attend();
    }

    /// The working zero of Z is higher by so much, mm.
    fn moves_zero(&mut self, higher_mm: f64) {
        if higher_mm == 0.0 {
            return self.rest(State::Idle, None);
        }
        let reads_mm = self.hub.read(|now| now.motion.at.working[Z]) - higher_mm;
        let units = to_wire::units(&self.workshop.session.memory.settings).axes;
        let mut reads = [None; AXES];
        reads[Z] = Some(reads_mm);
        self.command(&zeros::values(reads, &units), false, None, false);
    }

    /// The controller takes no orders from now on, for a reason, or takes them again: it is disarmed and tells why.
    fn lock(&mut self, why: Option<String>) {
        let before = std::mem::replace(&mut self.locked, why.clone());
        self.settle(|machine| {
            let others = machine.why.clone().filter(|told| Some(told) != before.as_ref());
            Machine {
                armed: machine.armed && why.is_none(),
                why: why.or(others),
                ..machine.clone()
            }
        });
    }

    /// Attaches the controller once more where it was lost, had an alarm, or has told nothing of itself yet.
    fn reach(&mut self) -> Result<(), String> {
        let Workshop { controller, session, workspace, .. } = &mut self.workshop;
        if let Some(controller) =
            controller.as_mut().filter(|it| it.is_beside() || it.fault().is_some())
        {
            let told = controller.attach_again(session, workspace)?;
            self.tell_attached(&told);
        }
        Ok(())
    }

    /// Returns the name of the controller; nothing where the machine is simulated.
    pub(super) fn controller_name(&self) -> Option<&str> {
        self.workshop.controller.as_ref().map(Controller::name)
    }

    /// Tells why no run is taken up on the controller, in words.
    pub(super) fn bars_taking_up(&mut self) -> Option<String> {
        if let Err(why) = self.reach() {
            return Some(why);
        }
        let controller = self.workshop.controller.as_ref()?;
        let unknown = || {
            let why = controller.doubts_place()?;
            Some(format!(
                "{why}. Find home where the controller has homing, or set its location and begin at a line"
            ))
        };
        controller.locked().or_else(unknown)
    }

    /// Returns the summary of a run that is not begun: the controller is gone, or lacks what the run needs.
    pub(super) fn refuses(&mut self, work: &Work, options: &RunOptions) -> Option<Summary> {
        let unit = self.workshop.session.memory.settings.linear_unit;
        if options.program.draws_only && !self.workshop.session.is_in_preview() {
            let why = "preview was left meanwhile, and the machine is not armed";
            let error = Diagnostic::new(Code::NotEnabled, SourcePlace::line(work.name(), 0), why);
            return Some(Summary::not_begun(unit, Some(Box::new(error))));
        }
        if let Err(why) = self.reach() {
            let hint = "look at its cable, its power and its port";
            let place = SourcePlace::line(work.name(), 0);
            let error = Diagnostic::new(Code::NotConnected, place, why).hint(hint);
            return Some(Summary::not_begun(unit, Some(Box::new(error))));
        }
        let job = self.workshop.controller.as_ref().and_then(Controller::card_job);
        if let Some(job) = job {
            let why = format!("the controller runs {} from its own card", job.name);
            let hint = "wait for its end, or press STOP";
            let error = Diagnostic::new(Code::Controller, SourcePlace::line(work.name(), 0), why);
            return Some(Summary::not_begun(unit, Some(Box::new(error.hint(hint)))));
        }
        let homes = matches!(work, Work::Hand(Errand::FindHome(_), _));
        let Workshop { controller, session, .. } = &self.workshop;
        if let Some(locked) = controller.as_ref()?.locked().filter(|_| !homes) {
            let error =
                Diagnostic::new(Code::Controller, SourcePlace::line(work.name(), 0), locked);
            return Some(Summary::not_begun(unit, Some(Box::new(error))));
        }
        let mut workspace = match (self.previews)() {
            Ok(workspace) => workspace,
            Err(why) => {
                let why = format!("what the controller lacks cannot be looked for: {why}");
                let error =
                    Diagnostic::new(Code::NotConnected, SourcePlace::line(work.name(), 0), why);
                return Some(Summary::not_begun(unit, Some(Box::new(error))));
            }
        };
        let mut answers = Answers::default();
        let found =
            controller.as_ref()?.lacks(work, session, options, &mut workspace, &mut answers);
        for it in &found {
            self.hub.tell(Message { text: to_wire::at_line(it), ..to_wire::message(it) });
        }
        let error = found.into_iter().find(Diagnostic::is_error)?;
        Some(Summary::not_begun(unit, Some(Box::new(error))))
    }

    /// Changes a zero point that the controller keeps, and has the working zero follow.
    pub(super) fn change_zero(&mut self, name: &str, change: ZeroChange) {
        self.catch_up();
        match self.zero_changed(name, change) {
            Err(why) => {
                self.rest(State::Idle, None);
                self.hub.say(Tone::Error, why);
            }
            Ok(None) => self.rest(State::Idle, None),
            Ok(Some(line)) => self.command(&line, false, None, false),
        }
        self.attend();
    }

    /// Forgets the factor that runs on the controller have shown.
    pub(super) fn forget_pace(&mut self) {
        let Workshop { controller, workspace, .. } = &mut self.workshop;
        controller.iter().for_each(|controller| controller.forgets_pace(workspace));
        self.rest(State::Idle, None);
        self.attend();
    }

    /// Writes a setting into the controller. By other steps of a millimetre its own count of where it stands is another.
    pub(super) fn change_setting(&mut self, number: u16, value: &str) {
        self.catch_up();
        let (tone, text) = match self.setting_written(number, value) {
            Err(why) => (Tone::Error, why),
            Ok(written) => {
                let counts_anew = written.letter_of_steps().is_some();
                (if counts_anew { Tone::Warning } else { Tone::Note }, written.sentence())
            }
        };
        // Whoever waits until the machine stands hears of it then.
        self.hub.say(tone, text);
        self.rest(State::Idle, None);
        self.attend();
    }

    /// Asks the controller a question in its own language; pages see the answer among its lines.
    pub(super) fn ask_controller(&mut self, question: &str) {
        self.catch_up();
        let asked = self.reach().and_then(|()| {
            let link = self.link.clone();
            let missing = "there is no controller that is asked in lines of text";
            let controller = self.workshop.controller.as_ref().ok_or(missing)?;
            controller.asks(question, || link.lock().is_to_stop())
        });
        if let Err(why) = asked {
            self.hub.say(Tone::Error, why);
        }
        self.rest(State::Idle, None);
        self.attend();
    }

    /// Writes it.
    fn setting_written(&mut self, number: u16, value: &str) -> Result<WrittenSetting, String> {
        self.reach()?;
        let link = self.link.clone();
        let missing = "there is no controller that keeps settings by number";
        let Workshop { controller, workspace, .. } = &mut self.workshop;
        let controller = controller.as_ref().ok_or(missing)?;
        controller.keeps_setting(number, value, workspace, || link.lock().is_to_stop())
    }

    /// Changes it; returns the command by which the working zero follows, where it does.
    fn zero_changed(&mut self, name: &str, change: ZeroChange) -> Result<Option<String>, String> {
        self.reach()?;
        let link = self.link.clone();
        let missing = "there is no controller that keeps zero points";
        let controller = self.workshop.controller.as_ref().ok_or(missing)?;
        controller.keeps_zero(name, change, || link.lock().is_to_stop())?;
        let told = controller.zeros();
        let holds = told.iter().any(|zero| zero.name == name && zero.holds);
        let memory = &self.workshop.session.memory;
        let reads = working_reads(memory.position, &told, change).filter(|_| holds);
        Ok(reads.map(|reads| zeros::values(reads, &to_wire::units(&memory.settings).axes)))
    }
}
