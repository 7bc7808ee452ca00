//! Stops in the middle of a job: what happens then, what may be changed, and the way back.
//!
//! The table of [`State`] says which effects a stop has; here they become small steps. The place where
//! the path was left is kept, so that whatever the operator does meanwhile, cutting goes on at that
//! very place.

use crate::Sequence;
use crate::place::{Along, Stage};
use crate::small::Small;
use kerf_diag::{Code, Diagnostic, Place};
use kerf_machine::Word;
use kerf_machine::lines::{Input, Output};
use kerf_machine::state::{Effect, Event, RELEASE_S, State};
use kerf_program::job::JobShape;
use kerf_program::{Axis, Beam, Halted, Question, QuestionKind, Status, Step};
use std::sync::Arc;

/// Cut outputs.
const CUTS: [Output; 3] = [Output::Cut1, Output::Cut2, Output::Cut3];

/// Tool outputs.
const TOOLS: [Output; 3] = [Output::Tool1, Output::Tool2, Output::Tool3];

impl Sequence {
    /// Motion or a wait was stopped in the middle.
    pub(crate) fn halt(&mut self, event: Event, why: &str, halted: &Halted) {
        if self.is_following() {
            self.keep_place(halted);
        }
        let carried = self.heights_left(halted.stands[Axis::Z]);
        self.position = halted.stands;
        self.stop_for(event, why);
        if carried {
            self.steps.push_front(Small::TellHeights);
        }
    }

    /// The path is being made.
    pub(crate) fn is_following(&self) -> bool {
        self.steps.front() == Some(&Small::Follow) && self.given
    }

    /// Something is wrong with the process while the machine stands.
    pub(crate) fn fault(&mut self, why: &str) {
        self.stop_for(Event::Fault, why);
    }

    /// Carries out what follows on an event, all the way to the question.
    fn stop_for(&mut self, event: Event, why: &str) {
        self.given = false;
        // What an earlier stop switches off goes off, whoever stops the machine again in the same moment.
        let state = self.state;
        self.steps.retain(|step| step.belongs_to_stop(state));
        if self.state == State::Waiting && event == Event::Fault {
            self.why = why.into();
        } else if let Some(first) = self.state.on(event, self.stop_settings()) {
            self.steps.clear();
            self.why = why.into();
            self.state = first.state;
            self.marked = false;
            let mut effects = first.effects;
            if let Some(stands) = self.state.on(Event::Stands, self.stop_settings()) {
                self.state = stands.state;
                effects.extend(stands.effects);
            }
            self.steps = effects.into_iter().flat_map(|effect| self.effect(effect)).collect();
            self.steps.push_back(Small::Enter(self.state));
            if self.state == State::Idle {
                self.stage = Stage::Finish;
                self.steps.push_back(Small::GiveUp);
            }
        }
        self.steps.push_back(Small::Ask);
    }

    /// Returns `true` if the machine halts by itself before a shape that is about to begin.
    pub(crate) fn is_marked(&self, shape: &JobShape) -> bool {
        shape.pause && self.here.pass == 0 && !self.halted_before
    }

    /// A pause mark: the head waits over the shape, whatever cuts is off.
    pub(crate) fn mark(&self) -> Vec<Small> {
        let off = [Effect::CutOff, Effect::RouterOff, Effect::ToolOff];
        let mut steps: Vec<Small> = off.into_iter().flat_map(|it| self.effect(it)).collect();
        steps.extend([Small::Mark, Small::Ask]);
        steps
    }

    /// The steps of an effect; what slows motion down has happened when they are asked for.
    fn effect(&self, effect: Effect) -> Vec<Small> {
        // Whether an output is on is asked when its step is carried out: steps before it may switch it on.
        let off = |outputs: &[Output]| -> Vec<Small> {
            outputs.iter().map(|output| Small::Switch(*output, false)).collect()
        };
        match effect {
            Effect::CutOff => {
                let mut steps = vec![Small::Height(None)];
                steps.extend(off(&CUTS));
                steps.push(Small::Beam(Beam::Off));
                steps
            }
            Effect::RouterOff | Effect::SpindleOff => off(&[Output::Router]),
            Effect::AllOff | Effect::LeaveOutputs => {
                off(Output::ALL).into_iter().chain([Small::Beam(Beam::Off)]).collect()
            }
            Effect::Raise => vec![Small::RaiseTo(self.travel_mm())],
            Effect::ToolOff => off(&TOOLS),
            Effect::ComeBack => self.come_back(),
            Effect::RestoreHeights => vec![Small::RestoreHeights],
            Effect::CutOffAtOnce
            | Effect::SlowDown
            | Effect::Halt
            | Effect::KeepPlace
            | Effect::MotorsOff
            | Effect::Doubt => Vec::new(),
        }
    }

    /// Back to where the job was left: router, tool, plunge, cut, each with its delay.
    pub(crate) fn come_back(&self) -> Vec<Small> {
        if self.stage == Stage::Waiting {
            return self.before_start();
        }
        if matches!(self.stage, Stage::Begin | Stage::Approach) {
            return self.approach(true);
        }
        if self.stage == Stage::Finish {
            return self.finish();
        }
        let back = self.here.shape(&self.job).and_then(|shape| self.here.spot(shape));
        let mut steps = back.map_or(Vec::new(), |spot| self.way_to(spot.at));
        steps.extend(self.router_on());
        if self.here.along == Along::After || self.here.along == Along::Clear {
            return steps;
        }
        steps.extend(self.pass_steps());
        steps
    }

    /// Returns the question to the operator.
    pub(crate) fn question(&self) -> Question {
        // A pause mark is where a job is meant to wait: without an operator it goes on.
        let preparing = self.state == State::Waiting && self.why.is_empty();
        let marked = self.marked || preparing;
        let text = match (&*self.why, marked) {
            (_, true) if preparing => format!("Start with shape {}?", self.here.nth + 1),
            (_, true) => format!("Shape {}", self.at().line),
            ("", false) => "Paused".to_owned(),
            (why, false) => format!("Paused: {why}"),
        };
        let limited = self.state == State::Limited;
        Question {
            kind: if limited { QuestionKind::Limit } else { QuestionKind::Paused },
            text,
            title: "Job".into(),
            buttons: self.state.ways_on().into(),
            default: usize::from(!marked),
            // The shape it begins with, so that whoever shows it need not read the text.
            prefill: if preparing { (self.here.nth + 1).to_string() } else { String::new() },
            icon: 0,
            // The external start is a key as any other.
            until: (preparing && self.machine.job.external_start)
                .then_some((Input::WHome.number(), true)),
        }
    }

    /// The operator said something in an emergency: nothing moves before the stop is released and he has
    /// acknowledged it.
    pub(crate) fn answered_in_emergency(&mut self, words: &str, pressed: bool) {
        match Word::read(words) {
            Some(Word::Abort) => return self.abort(),
            Some(Word::Continue) if !pressed => {
                if let Some(next) = self.state.on(Event::Acknowledge, self.stop_settings()) {
                    self.state = next.state;
                }
                self.why = "emergency stop released".into();
                self.steps.push_back(Small::Enter(self.state));
            }
            Some(Word::Continue | Word::Move(..)) => {
                let text = if pressed { "release the emergency stop" } else { "acknowledge first" };
                self.steps.extend([Small::Say(text.into()), Small::Release]);
            }
            Some(word) => self.obey(word),
            None => {}
        }
        self.steps.push_back(Small::Ask);
    }

    /// The operator said something while a stop input blocks the machine.
    pub(crate) fn answered_when_blocked(&mut self, words: &str, active: bool) {
        match Word::read(words) {
            Some(Word::Abort) => return self.abort(),
            Some(Word::Continue) if active => {
                self.steps
                    .extend([Small::Say("release the stop input".into()), Small::Wait(RELEASE_S)]);
            }
            Some(Word::Continue) => {
                let Some(next) = self.state.on(Event::Released, self.stop_settings()) else {
                    return;
                };
                self.state = next.state;
                self.why = format!("{} released", self.why).into();
                let effects = next.effects.into_iter().flat_map(|effect| self.effect(effect));
                self.steps = effects.collect();
                self.steps.push_back(Small::Enter(self.state));
            }
            Some(Word::Move(..)) => {
                self.steps.push_back(Small::Say("release the stop input".into()))
            }
            Some(word) => self.obey(word),
            None => {}
        }
        self.steps.push_back(Small::Ask);
    }

    /// The operator said whether the job goes on beyond a limit.
    pub(crate) fn answered_at_limit(&mut self, words: &str) {
        match Word::read(words) {
            Some(Word::Continue) => self.go_on_by(Event::Override),
            Some(Word::Abort) => self.abort(),
            _ => self.steps.push_back(Small::Ask),
        }
    }

    /// The operator said something.
    pub(crate) fn answered(&mut self, words: &str) {
        if self.state == State::Waiting {
            return self.prepared(Word::read(words));
        }
        match Word::read(words) {
            Some(Word::Continue) => {
                self.halted_before |= std::mem::take(&mut self.marked);
                self.go_on();
            }
            Some(Word::Abort) => self.abort(),
            Some(word) => {
                self.obey(word);
                self.steps.push_back(Small::Ask);
            }
            None => self.steps.push_back(Small::Ask),
        }
    }

    fn go_on(&mut self) {
        self.go_on_by(Event::Continue);
    }

    fn go_on_by(&mut self, event: Event) {
        let Some(next) = self.state.on(event, self.stop_settings()) else { return };
        self.state = next.state;
        self.why = Arc::default();
        self.steps = [Small::Enter(self.state), Small::Switch(Output::JobRunning, true)].into();
        self.steps.extend(self.jig_on());
        self.refresh_depths();
        let effects = next.effects.into_iter().flat_map(|effect| self.effect(effect));
        self.steps.extend(effects.collect::<Vec<_>>());
    }

    pub(crate) fn abort(&mut self) {
        self.stage = Stage::Finish;
        self.steps = self.effect(Effect::CutOff).into();
        self.steps.extend(self.effect(Effect::AllOff));
        self.steps.extend(self.effect(Effect::RestoreHeights));
        let after = self.state.on(Event::Abort, self.stop_settings());
        let after = after.map_or(State::Idle, |next| next.state);
        self.steps.extend([Small::Enter(after), Small::GiveUp]);
    }

    /// The machine stopped at the operator's word, for good.
    pub(crate) fn give_up(&mut self) -> Step {
        if self.state != State::Alarm {
            return self.end(Status::Stopped);
        }
        let place = Place::line(self.job.name.clone(), self.at().line);
        let why = Some(Box::new(Diagnostic::new(Code::InputStop, place, self.why.to_string())));
        self.over = Some((Status::Limit, why.clone()));
        Step::Done(Status::Limit, why)
    }

    pub(crate) fn obey(&mut self, word: Word) {
        match word {
            Word::CutSpeed(mm_s) => {
                self.use_cut_speed(mm_s);
                self.steps.push_back(Small::TellInForce);
            }
            Word::PlungeSpeed(mm_s) => {
                self.plunge_mm_s = mm_s;
                self.steps.push_back(Small::TellInForce);
            }
            Word::AdjustBottom(by) => match self.no_bottom(self.heights.bottom_mm + by) {
                Some(why) => self.steps.push_back(Small::Say(why.into())),
                None => {
                    self.heights.bottom_mm += by;
                    self.steps.push_back(Small::TellHeights);
                }
            },
            Word::AdjustHeight(by_mm) => {
                if !Arc::make_mut(&mut self.machine).height.adjust(by_mm) {
                    let text = "the set points are held between 0 and 255".into();
                    self.steps.push_back(Small::Say(text));
                }
            }
            Word::Raise(raise) => {
                self.raise = raise;
                self.steps.push_back(Small::TellInForce);
            }
            Word::Move(axis, by) => {
                let to = self.within_reach(axis, self.position[axis] + by);
                self.steps.push_back(Small::Hand(axis, to));
            }
            Word::Shape(_) | Word::Next | Word::Previous => {
                let text = "the shape to begin with is chosen before the job starts";
                self.steps.push_back(Small::Say(text.into()));
            }
            Word::Continue | Word::Abort => {}
        }
    }

    /// Tells why ZBottom cannot be at a height, if it cannot.
    fn no_bottom(&self, z_mm: f64) -> Option<String> {
        let surface_mm = self.heights.surface_mm;
        let end = self.reach(Axis::Z).map(|[low, _]| low).filter(|low| z_mm < *low);
        let why = match end {
            Some(end) => format!("Z ends at {end:.3} mm"),
            None if z_mm > surface_mm => format!("above ZSurface at {surface_mm:.3} mm"),
            None => return None,
        };
        let stays = self.heights.bottom_mm;
        Some(format!("ZBottom would be at {z_mm:.3} mm, {why}: it stays at {stays:.3} mm"))
    }

    /// A place that an axis may go to, nearest to one that is asked for. Z goes to ZBottom at the
    /// lowest.
    fn within_reach(&self, axis: Axis, to: f64) -> f64 {
        let to = if axis == Axis::Z { to.max(self.heights.bottom_mm) } else { to };
        self.reach(axis).map_or(to, |[low, high]| to.clamp(low, high))
    }
}
