//! Record of what the world tells a run, kept so that it can be told again.
//!
//! A run is decided by its program, its settings, and what the world tells it on the way: answers,
//! what the operator wants and when, files that are read, values that other programs set. Everything
//! else is computed. So a run that was cut short is made again up to where it was, on the simulated
//! machine and in silence, with the world's part played from the tape.
//!
//! ```text
//!  recording:  world ──► run        and a step on the tape, in the file before what follows from it
//!  playing:    tape  ──► run        as long as there is tape, or moves that were made before
//! ```
//!
//! Each kind of question is counted. Most are on the tape whenever they were asked; those that are
//! asked at every move and hardly ever have an answer only when they had ([`Tape::hear_rarely`]).

mod lag;
mod reached;
mod reentries;

pub use reentries::Reentered;

use super::progress::Progress;
use super::reached::Reached;
use crate::switches::Switches;
use lag::Lag;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, VecDeque};

/// Kind of a question to the world.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Kind {
    /// The operator answers a question.
    Answer,
    /// The operator asks for something of a machine that runs.
    #[serde(alias = "wish")]
    Request,
    /// The operator says when a held machine goes on.
    Resume,
    /// A program file is read.
    Source,
    /// A file of the user is opened.
    Open,
    /// It is closed, what was written is in place.
    Close,
    /// A file is converted.
    Convert,
    /// A program is started.
    Shell,
    /// A log is written.
    Log,
    /// A value that somebody else set.
    Value,
    /// The power went before what the operator wanted was done: the number is that of the request.
    Overtaken,
    /// The run was taken up here: the number is that of the moves made.
    Reentry,
    /// The power went here, where the machine was stopped: the number is that of the times the run was taken up
    /// before.
    Left,
    /// A machine that slows down by itself tells the moment of the plan at which it stands.
    Stood,
}

/// One thing that the world told.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Step {
    kind: Kind,
    /// Which question of its kind this answers, counted from 1.
    call: u64,
    /// The answer.
    told: serde_json::Value,
}

/// Source of the answer to a question.
pub enum AnswerSource<T> {
    /// The world, and nobody writes it down.
    Live,
    /// The tape; mostly that there was nothing.
    Recorded(Option<T>),
    /// The world; it is written down under this number.
    Open(u64),
}

/// Record of what the world tells one run.
#[derive(Debug, Default)]
pub struct Tape {
    played: BTreeMap<Kind, VecDeque<Step>>,
    calls: BTreeMap<Kind, u64>,
    /// Steps that were told, re-entries aside.
    told: u64,
    /// Moves that were made before.
    made_before: u64,
    /// Share of the next one that was made.
    within_before: f64,
    /// The step with which the operator wanted something last.
    last_request: Option<i64>,
    /// The step with which the operator stopped the run, until it goes on.
    request: Option<i64>,
    /// Moves made when it was stopped last, and how much of the next.
    stood: Option<(u64, f64)>,
    /// The same of a run that is taken up, until all is ready.
    back: Option<(i64, (u64, f64))>,
    /// The switches that the operator moved since the run went on last, each with the step.
    pressed: Vec<(u8, i64)>,
    /// Number of times that the run was taken up.
    reentries: u64,
    /// `true` while what follows on a stop was interrupted by a power cut: the run that is taken up decides it.
    open: bool,
    /// Switches as they are now, when the run is taken up; and as they were when this was looked at last.
    switches: [Switches; 2],
    /// Progress of the run.
    reached: Reached,
    /// The part of it that is made for sure, where the run tells of moves before they are made.
    lag: Option<Lag>,
    writing: Option<Progress>,
    /// Only plays back: nothing is written and the world is not asked.
    silent: bool,
    /// The tape does not fit the run.
    unfit: Option<String>,
    /// Files that steps speak of.
    contents: BTreeMap<String, Vec<u8>>,
}

impl Tape {
    /// Writes down what the world tells a run that begins at a place.
    pub(super) fn recording(place: super::Placed, progress: Progress) -> Self {
        let reached = Reached { place, ..Reached::default() };
        Self { reached, writing: Some(progress), ..Self::default() }
    }

    /// Plays the steps and goes on recording behind them.
    pub(super) fn playing(
        steps: Vec<Step>,
        contents: BTreeMap<String, Vec<u8>>,
        reached: &Reached,
        progress: Progress,
        [now, before]: [Switches; 2],
    ) -> Self {
        let last = steps.iter().rev().find(|step| step.kind == Kind::Reentry);
        let last = last.and_then(|step| Reentered::deserialize(&step.told).ok());
        let before = match last {
            // They are as the run left them, or somebody since.
            _ if reached.stopped => Switches::new(),
            Some(last) => last.left,
            None => before,
        };
        let mut tape = Self {
            switches: [now, before],
            made_before: reached.made,
            within_before: reached.within,
            contents,
            silent: true,
            ..Self::recording(super::Placed::default(), progress)
        };
        for step in steps {
            tape.played.entry(step.kind).or_default().push_back(step);
        }
        tape
    }

    /// The world is silent: what happens has happened before.
    pub fn plays(&self) -> bool {
        let left = || self.played.values().any(|steps| !steps.is_empty());
        self.silent && (self.reached.made < self.made_before || left())
    }

    /// Everything has happened that happened before but a part of the next move.
    pub fn is_within(&self) -> bool {
        self.silent && self.within_before > 0.0
    }

    /// Ends the playback: from now on the world answers, and the machine stands at this place.
    pub fn wake(&mut self, place: super::Placed) {
        (self.silent, self.reached.place, self.reached.moving) = (false, place, false);
        self.comes_to_rest();
    }

    /// The run is over: nothing of it is written any more, and what was to be written is. Where something on the
    /// tape was never asked for it is not the tape of this run, and nothing of the run was made.
    pub fn ends(&mut self) {
        self.writing = None;
        if self.plays() {
            self.unfit.get_or_insert_with(|| "more is on record than the run asks for".into());
        }
    }

    /// Tells why the tape does not fit the run.
    pub fn unfit(&self) -> Option<&str> {
        self.unfit.as_deref()
    }

    /// Asks the world, or the tape.
    pub fn hear<T: Serialize + DeserializeOwned>(
        &mut self,
        kind: Kind,
        world: impl FnOnce() -> T,
    ) -> T {
        if let Some(told) = self.hear_again(kind) {
            return told;
        }
        let told = world();
        self.keep(kind, &told);
        told
    }

    /// The same of something that changes the world: the tape is in the file before and after.
    pub fn change<T: Serialize + DeserializeOwned>(
        &mut self,
        kind: Kind,
        world: impl FnOnce() -> T,
    ) -> T {
        self.write();
        self.settle();
        let told = self.hear(kind, world);
        self.write();
        self.settle();
        told
    }

    /// Gives a key a value, where a thread writes it and nobody waits for the disk; tells whether one does.
    pub fn gives(&mut self, key: &str, value: Option<&str>) -> bool {
        self.writing.as_mut().is_some_and(|progress| progress.gives(key, value))
    }

    /// Tells whether the value of a key is not on record yet: nobody else can have changed it then.
    pub fn owes(&self, key: &str) -> bool {
        self.writing.as_ref().is_some_and(|progress| progress.owes(key))
    }

    /// Asks the world for something that it hardly ever has.
    pub fn hear_rarely<T: Serialize + DeserializeOwned>(
        &mut self,
        kind: Kind,
        world: impl FnOnce() -> Option<T>,
    ) -> Option<T> {
        match self.turn(kind) {
            AnswerSource::Live => world(),
            AnswerSource::Recorded(told) => told,
            AnswerSource::Open(call) => {
                let told = world();
                self.heard(kind, call, told.as_ref());
                told
            }
        }
    }

    /// Decides who answers a question that the world hardly ever has an answer to.
    pub fn turn<T: DeserializeOwned>(&mut self, kind: Kind) -> AnswerSource<T> {
        if self.writing.is_none() {
            return AnswerSource::Live;
        }
        let call = self.calls.entry(kind).or_default();
        *call += 1;
        let call = *call;
        let next = self.played.get(&kind).and_then(VecDeque::front);
        if next.is_some_and(|step| step.call == call) {
            return AnswerSource::Recorded(self.pop(kind));
        }
        if self.silent { AnswerSource::Recorded(None) } else { AnswerSource::Open(call) }
    }

    /// Keeps what the world answered to such a question.
    pub fn heard<T: Serialize>(&mut self, kind: Kind, call: u64, told: Option<&T>) {
        if let Some(told) = told {
            self.add(kind, call, told);
            if kind == Kind::Stood {
                self.comes_to_rest();
            }
            let last = self.writing.as_ref().and_then(Progress::last_step);
            self.last_request = last.filter(|_| kind == Kind::Request);
        }
    }

    /// Takes back the last request, which had no effect: it will be heard once more.
    pub fn unhear_request(&mut self) {
        let Some(progress) = self.writing.as_mut().filter(|_| !self.silent) else { return };
        let last = progress.last_step();
        if self.last_request.is_none() || self.last_request != last {
            return;
        }
        progress.take_back();
        self.told -= 1;
        self.last_request = None;
        self.request = self.request.filter(|_| self.request != last);
    }

    /// Counts a question less: the operator is asked for his request again at once, after one of which nothing came. That
    /// is one question, as it will be when the run is taken up.
    pub fn asks_again(&mut self) {
        if self.writing.is_some() && !self.silent {
            self.calls.entry(Kind::Request).and_modify(|calls| *calls = calls.saturating_sub(1));
        }
    }

    /// Tells whether nothing came of what was told last: the power went.
    pub fn is_last_told(&self) -> bool {
        self.silent && !self.plays() && !self.is_within()
    }

    /// Takes back the last answer, which had no effect: the operator is asked again.
    pub fn take_back_answer(&mut self) {
        let Some(progress) = &mut self.writing else { return };
        progress.take_back();
        self.told -= 1;
        self.calls.entry(Kind::Answer).and_modify(|calls| *calls -= 1);
    }

    /// The step that was added last stops the run.
    pub fn stops(&mut self) {
        let last = self.writing.as_ref().and_then(Progress::last_step);
        self.request = self.request.or(last);
    }

    /// The step that was added last moves the switch of an input.
    pub fn presses(&mut self, input: u8) {
        let last = self.writing.as_ref().and_then(Progress::last_step);
        self.pressed.extend(last.map(|last| (input, last)));
    }

    /// An input stops the run; where its switch was moved for that, with the step in which it was moved last.
    pub fn stops_at_input(&mut self, input: u8) {
        let last = self.writing.as_ref().and_then(Progress::last_step);
        let Some(last) = last.filter(|_| !self.silent) else { return };
        let pressed = self.pressed.iter().rfind(|(number, _)| *number == input);
        let stop = pressed.map_or(last + 1, |(_, step)| *step);
        self.request = self.request.or(Some(stop));
    }

    /// The run goes on after a stop.
    pub fn goes_on(&mut self) {
        (self.request, self.stood) = (None, None);
        self.pressed.clear();
    }

    /// Notes that the machine is back in place and the run that was taken up goes on.
    pub fn goes_back(&mut self) {
        self.back = None;
        self.goes_on();
    }

    /// Returns `true` if the record says that the power went before the last recorded request was carried out.
    pub fn was_overtaken(&mut self) -> bool {
        let call = self.last_call(Kind::Request);
        let next = self.played.get(&Kind::Overtaken).and_then(VecDeque::front);
        next.is_some_and(|step| step.call == call) && self.pop::<()>(Kind::Overtaken).is_some()
    }

    /// Records that the power went before the last recorded request was carried out.
    pub fn overtakes(&mut self) {
        self.add(Kind::Overtaken, self.last_call(Kind::Request), &());
    }

    /// The number of the question of a kind that was asked last; 0 before the first.
    fn last_call(&self, kind: Kind) -> u64 {
        self.calls.get(&kind).copied().unwrap_or_default()
    }

    /// A file: its name and its bytes, which are kept once however often it is read.
    pub fn hear_file<E: Serialize + DeserializeOwned>(
        &mut self,
        kind: Kind,
        world: impl FnOnce() -> Result<(String, Vec<u8>), E>,
    ) -> Result<(String, Vec<u8>), E> {
        if let Some(told) = self.hear_again::<Result<(String, String), E>>(kind) {
            return told.map(|(name, hash)| {
                let bytes = self.contents.get(&hash).cloned();
                if bytes.is_none() {
                    self.unfit.get_or_insert(format!("the text of {name} was not kept"));
                }
                (name, bytes.unwrap_or_default())
            });
        }
        let read = world();
        if let Some(progress) = &mut self.writing {
            let told = read.as_ref().map(|(name, bytes)| (name, progress.add_content(bytes)));
            let told = serde_json::to_value(told);
            self.keep(kind, &told.unwrap_or_default());
        }
        read
    }

    fn hear_again<T: DeserializeOwned>(&mut self, kind: Kind) -> Option<T> {
        self.writing.as_ref()?;
        *self.calls.entry(kind).or_default() += 1;
        let next = self.played.get(&kind).and_then(VecDeque::front)?;
        if next.call != self.calls[&kind] {
            self.unfit.get_or_insert(format!("another {kind:?} was expected"));
            return None;
        }
        self.pop(kind)
    }

    fn pop<T: DeserializeOwned>(&mut self, kind: Kind) -> Option<T> {
        let step = self.played.get_mut(&kind)?.pop_front()?;
        self.count(kind);
        match serde_json::from_value(step.told) {
            Ok(told) => Some(told),
            Err(error) => {
                self.unfit.get_or_insert(error.to_string());
                None
            }
        }
    }

    fn keep(&mut self, kind: Kind, told: &impl Serialize) {
        self.add(kind, self.last_call(kind), told);
    }

    fn add(&mut self, kind: Kind, call: u64, told: &impl Serialize) {
        if self.writing.is_some() {
            self.count(kind);
        }
        let Some(progress) = &mut self.writing else { return };
        let step = serde_json::to_value(told).map(|told| Step { kind, call, told });
        match step.and_then(|step| serde_json::to_vec(&step)) {
            Ok(step) => progress.add_step(step),
            Err(error) => drop(self.unfit.get_or_insert(error.to_string())),
        }
    }

    fn count(&mut self, kind: Kind) {
        self.told += u64::from(!matches!(kind, Kind::Reentry | Kind::Left));
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::{Hurry, Journal, Placed};
    use std::sync::atomic::{AtomicBool, Ordering};
    use std::time::Duration;

    /// Steps of another run on the tape: nothing of this one would be made, and it must not be said to have
    /// ended.
    #[test]
    fn a_run_that_does_not_ask_for_what_is_on_record_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let (journal, _) = Journal::open(folder.path()).unwrap();
        let step = Step { kind: Kind::Log, call: 1, told: serde_json::Value::Null };
        for (steps, fits) in [(Vec::new(), true), (vec![step], false)] {
            let progress = Progress::new(journal.registry.clone(), Some(2));
            let reached = Reached::default();
            let mut tape =
                Tape::playing(steps, BTreeMap::new(), &reached, progress, Default::default());
            tape.ends();
            assert_eq!(tape.unfit().is_none(), fits);
        }
    }

    /// A thread that writes later would bring a run back that is over.
    #[test]
    fn what_is_over_is_on_record_however_long_the_disk_takes() {
        let folder = tempfile::tempdir().unwrap();
        let (journal, _) = Journal::open(folder.path()).unwrap();
        let mut progress = Progress::new(journal.registry.clone(), Some(1));
        progress.writes_behind(Some(Hurry::new(|| true)));
        let mut tape = Tape::recording(Placed::default(), progress);
        let (holds, held) = std::sync::mpsc::channel();
        let written = AtomicBool::new(false);
        std::thread::scope(|scope| {
            scope.spawn(|| {
                let _disk = journal.store.opened();
                holds.send(()).unwrap();
                std::thread::sleep(Duration::from_millis(30));
                written.store(true, Ordering::Release);
            });
            held.recv().unwrap();
            tape.moves(true, Placed::default());
            tape.ends();
            assert!(written.load(Ordering::Acquire), "nobody waited for the disk");
        });
    }
}
