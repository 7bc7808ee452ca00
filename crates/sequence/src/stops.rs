//! Stops in the middle of a job: what happens then, what may be changed, and the way back.
//!
//! The table of [`State`] says which effects a stop has; here they become steps. The place where
//! the path was left is kept, so that whatever the operator does meanwhile, cutting goes on at that
//! very place.

use crate::forbidden::Forbids;
use crate::path::keep_place;
use crate::place::Stage;
use crate::sequence::Sequence;
use crate::step::Step;
use kerf_diag::{Code, Diagnostic, SourcePlace};
use kerf_machine::PauseOrder;
use kerf_machine::lines::Output;
use kerf_machine::state::{Effect, Event, RELEASE_S, State};
use kerf_program::{Axis, Beam, Command, Halted, Sourced, Status, Step as Stepped};
use std::sync::Arc;

impl Sequence {
    /// Motion or a wait was stopped in the middle.
    pub(crate) fn halt(&mut self, event: Event, why: &str, halted: &Halted) {
        if self.queue.is_following() {
            keep_place(&mut self.progress, &self.setup.job, halted);
        }
        let carried = self.heights_left(halted.stands[Axis::Z]);
        self.head.position = halted.stands;
        self.stop_for(event, why);
        if carried {
            self.queue.steps.push_front(Step::TellHeights);
        }
    }

    /// Something is wrong with the process while the machine stands.
    pub(crate) fn fault(&mut self, why: &str) {
        self.stop_for(Event::Fault, why);
    }

    /// Carries out what follows on an event, all the way to the question.
    fn stop_for(&mut self, event: Event, why: &str) {
        // What an earlier stop switches off goes off, whoever stops the machine again in the same moment.
        self.queue.keep_stop(self.halt.state);
        if self.halt.state == State::Waiting && event == Event::Fault {
            self.halt.why = why.into();
        } else if let Some(first) = self.halt.state.on(event, self.values.stop_settings()) {
            self.queue.steps.clear();
            self.halt.why = why.into();
            self.halt.state = first.state;
            self.halt.marked = false;
            let mut effects = first.effects;
            if let Some(stands) = self.halt.state.on(Event::Stands, self.values.stop_settings()) {
                self.halt.state = stands.state;
                effects.extend(stands.effects);
            }
            self.queue.steps =
                effects.into_iter().flat_map(|effect| self.schedule().effect(effect)).collect();
            self.queue.steps.push_back(Step::Enter(self.halt.state));
            if self.halt.state == State::Idle {
                self.progress.stage = Stage::Finish;
                self.queue.steps.push_back(Step::GiveUp);
            }
        }
        self.queue.steps.push_back(Step::Ask);
    }

    /// The operator said something in an emergency: nothing moves before the stop is released and he has
    /// acknowledged it.
    pub(crate) fn answered_in_emergency(&mut self, words: &str, pressed: bool) {
        match PauseOrder::read(words) {
            Some(PauseOrder::Abort) => return self.abort(),
            Some(PauseOrder::Continue) if !pressed => {
                if let Some(next) =
                    self.halt.state.on(Event::Acknowledge, self.values.stop_settings())
                {
                    self.halt.state = next.state;
                }
                self.halt.why = "emergency stop released".into();
                self.queue.steps.push_back(Step::Enter(self.halt.state));
            }
            Some(PauseOrder::Continue | PauseOrder::Move(..)) => {
                let text = if pressed { "release the emergency stop" } else { "acknowledge first" };
                self.queue.steps.extend([Step::Say(text.into()), Step::Release]);
            }
            Some(word) => self.obey(word),
            None => {}
        }
        self.queue.steps.push_back(Step::Ask);
    }

    /// The operator said something while a stop input blocks the machine.
    pub(crate) fn answered_when_blocked(&mut self, words: &str, active: bool) {
        match PauseOrder::read(words) {
            Some(PauseOrder::Abort) => return self.abort(),
            Some(PauseOrder::Continue) if active => {
                self.queue
                    .steps
                    .extend([Step::Say("release the stop input".into()), Step::Wait(RELEASE_S)]);
            }
            Some(PauseOrder::Continue) => {
                let Some(next) = self.halt.state.on(Event::Released, self.values.stop_settings())
                else {
                    return;
                };
                self.halt.state = next.state;
                self.halt.why = format!("{} released", self.halt.why).into();
                let effects =
                    next.effects.into_iter().flat_map(|effect| self.schedule().effect(effect));
                self.queue.steps = effects.collect();
                self.queue.steps.push_back(Step::Enter(self.halt.state));
            }
            Some(PauseOrder::Move(..)) => {
                self.queue.steps.push_back(Step::Say("release the stop input".into()))
            }
            Some(word) => self.obey(word),
            None => {}
        }
        self.queue.steps.push_back(Step::Ask);
    }

    /// The operator said whether the job goes on beyond a limit.
    pub(crate) fn answered_at_limit(&mut self, words: &str) {
        match PauseOrder::read(words) {
            Some(PauseOrder::Continue) => self.go_on_by(Event::Override),
            Some(PauseOrder::Abort) => self.abort(),
            _ => self.queue.steps.push_back(Step::Ask),
        }
    }

    /// The operator said something.
    pub(crate) fn answered(&mut self, words: &str) {
        if self.halt.state == State::Waiting {
            return self.prepared(PauseOrder::read(words));
        }
        match PauseOrder::read(words) {
            Some(PauseOrder::Continue) => {
                self.halt.leave_mark();
                self.go_on_by(Event::Continue);
            }
            Some(PauseOrder::Abort) => self.abort(),
            Some(word) => {
                self.obey(word);
                self.queue.steps.push_back(Step::Ask);
            }
            None => self.queue.steps.push_back(Step::Ask),
        }
    }

    fn go_on_by(&mut self, event: Event) {
        let Some(next) = self.halt.state.on(event, self.values.stop_settings()) else { return };
        self.halt.state = next.state;
        self.halt.why = Arc::default();
        self.queue.steps =
            [Step::Enter(self.halt.state), Step::Switch(Output::JobRunning, true)].into();
        self.queue.steps.extend(self.schedule().jig_on());
        self.progress.refresh_depths(&self.setup.job, &self.values.heights);
        let effects = next.effects.into_iter().flat_map(|effect| self.schedule().effect(effect));
        self.queue.steps.extend(effects.collect::<Vec<_>>());
    }

    pub(crate) fn abort(&mut self) {
        self.progress.stage = Stage::Finish;
        self.queue.steps = self.schedule().effect(Effect::CutOff).into();
        self.queue.steps.extend(self.schedule().effect(Effect::AllOff));
        self.queue.steps.extend(self.schedule().effect(Effect::RestoreHeights));
        let after = self.halt.state.on(Event::Abort, self.values.stop_settings());
        let after = after.map_or(State::Idle, |next| next.state);
        self.queue.steps.extend([Step::Enter(after), Step::GiveUp]);
    }

    /// The machine stopped at the operator's word, for good.
    pub(crate) fn give_up(&mut self) -> Stepped {
        if self.halt.state != State::Alarm {
            return self.end(Status::Stopped);
        }
        let place =
            SourcePlace::line(self.setup.job.name.clone(), self.progress.at(&self.setup.job).line);
        let why =
            Some(Box::new(Diagnostic::new(Code::InputStop, place, self.halt.why.to_string())));
        self.over = Some((Status::Limit, why.clone()));
        Stepped::Done(Status::Limit, why)
    }

    pub(crate) fn obey(&mut self, word: PauseOrder) {
        match word {
            PauseOrder::CutSpeed(mm_s) => {
                self.values.use_cut_speed(mm_s);
                self.queue.steps.push_back(Step::TellInForce);
            }
            PauseOrder::PlungeSpeed(mm_s) => {
                self.values.plunge_mm_s = mm_s;
                self.queue.steps.push_back(Step::TellInForce);
            }
            PauseOrder::AdjustBottom(by) => {
                match self.no_bottom(self.values.heights.bottom_mm + by) {
                    Some(why) => self.queue.steps.push_back(Step::Say(why.into())),
                    None => {
                        self.values.heights.bottom_mm += by;
                        self.queue.steps.push_back(Step::TellHeights);
                    }
                }
            }
            PauseOrder::AdjustHeight(by_mm) => {
                if !Arc::make_mut(&mut self.setup.machine).height.adjust(by_mm) {
                    let text = "the set points are held between 0 and 255".into();
                    self.queue.steps.push_back(Step::Say(text));
                }
            }
            PauseOrder::Raise(raise) => {
                self.values.raise = raise;
                self.queue.steps.push_back(Step::TellInForce);
            }
            PauseOrder::Move(axis, by) => {
                let to = self.within_reach(axis, self.head.position[axis] + by);
                self.queue.steps.push_back(Step::Hand(axis, to));
            }
            PauseOrder::Shape(_) | PauseOrder::Next | PauseOrder::Previous => {
                let text = "the shape to begin with is chosen before the job starts";
                self.queue.steps.push_back(Step::Say(text.into()));
            }
            PauseOrder::Continue | PauseOrder::Abort => {}
        }
    }

    /// Tells why ZBottom cannot be at a height, if it cannot.
    fn no_bottom(&self, z_mm: f64) -> Option<String> {
        let surface_mm = self.values.heights.surface_mm;
        let end = self.setup.reach(Axis::Z).map(|[low, _]| low).filter(|low| z_mm < *low);
        let why = match end {
            Some(end) => format!("Z ends at {end:.3} mm"),
            None if z_mm > surface_mm => format!("above ZSurface at {surface_mm:.3} mm"),
            None => return None,
        };
        let stays = self.values.heights.bottom_mm;
        Some(format!("ZBottom would be at {z_mm:.3} mm, {why}: it stays at {stays:.3} mm"))
    }

    /// A place that an axis may go to, nearest to one that is asked for. Z goes to ZBottom at the
    /// lowest.
    fn within_reach(&self, axis: Axis, to: f64) -> f64 {
        let to = if axis == Axis::Z { to.max(self.values.heights.bottom_mm) } else { to };
        self.setup.reach(axis).map_or(to, |[low, high]| to.clamp(low, high))
    }

    /// The operator says something before the job begins.
    pub(crate) fn prepared(&mut self, word: Option<PauseOrder>) {
        let last = self.setup.job.shapes.len().saturating_sub(1);
        let nth = match word {
            Some(PauseOrder::Continue) => {
                // Nothing came for a long time: it is waited for again.
                if !self.halt.why.is_empty() {
                    self.halt.why = Arc::default();
                    self.queue.steps = self.schedule().before_start().into();
                }
                return;
            }
            Some(PauseOrder::Abort) => return self.abort(),
            Some(PauseOrder::Shape(number)) if number > last + 1 => {
                let text = format!("the job has {} shapes", self.setup.job.shapes.len());
                self.queue.steps.extend([Step::Say(text.into()), Step::Ask]);
                return;
            }
            Some(PauseOrder::Shape(number)) => number - 1,
            Some(PauseOrder::Next) => (self.progress.here.nth + 1).min(last),
            Some(PauseOrder::Previous) => self.progress.here.nth.saturating_sub(1),
            Some(word) => {
                self.obey(word);
                self.queue.steps.push_back(Step::Ask);
                return;
            }
            None => self.progress.here.nth,
        };
        self.progress.here.nth = nth;
        if let Some(shape) = self.progress.here.shape(&self.setup.job) {
            // Over it the head comes down to the height of travel: from there it is seen where it would cut.
            let down = Step::Rapid(self.values.travel_mm(&self.setup.machine));
            self.queue.steps.extend([self.schedule().up(), Step::Travel(shape.start()), down]);
        }
        self.queue.steps.push_back(Step::Ask);
    }

    /// The operator wanted what is forbidden: he is told, and asked again in a moment.
    pub(crate) fn refuse(&mut self, forbids: Forbids) {
        // Whoever does not answer any more does not start it.
        self.halt.leave_mark();
        if self.halt.why.is_empty() {
            self.halt.why = forbids.text().into();
        }
        let again = [Step::Say(forbids.text().into()), Step::Wait(RELEASE_S), Step::Ask];
        self.queue.push_front(again);
    }

    /// Returns the outputs that go on when the job is taken up from there, in order.
    pub(crate) fn comes_on_again(&self, halted: &Halted) -> Vec<u8> {
        let mut ahead = self.clone();
        ahead.take_up(halted);
        if ahead.progress.stage == Stage::Approach {
            ahead.queue.steps.extend(ahead.schedule().pass_steps());
        }
        let switched = ahead.queue.steps.iter().filter_map(|step| match step {
            Step::Switch(output, true) => Some(output.number()),
            _ => None,
        });
        let mut on = Vec::new();
        for number in switched {
            if !on.contains(&number) {
                on.push(number);
            }
        }
        on
    }

    /// Goes on from where the path was left; the machine stands elsewhere.
    pub(crate) fn take_up(&mut self, halted: &Halted) {
        if self.queue.is_following() {
            keep_place(
                &mut self.progress,
                &self.setup.job,
                &Halted { stands: halted.began, ..*halted },
            );
        }
        self.heights_left(halted.began[Axis::Z]);
        let jig = [Output::Jig1, Output::Jig2].into_iter().find(|output| self.head.is_on(*output));
        let runs = self.head.is_on(Output::JobRunning);
        (self.sheet.controlled, self.queue.given) = (false, false);
        self.head.all_off();
        self.head.position = halted.stands;
        let mut steps = vec![
            Step::RaiseTo(self.values.travel_mm(&self.setup.machine)),
            Step::Enter(self.halt.state),
        ];
        steps.extend(runs.then_some(Step::Switch(Output::JobRunning, true)));
        steps.extend(jig.map(|output| Step::Switch(output, true)));
        if self.halt.state == State::Running && self.progress.stage != Stage::Waiting {
            steps.extend(self.schedule().come_back());
            self.queue.steps = steps.into();
        } else {
            // Moves beside the path: what is left of them is made from here.
            self.queue.push_front(steps);
        }
    }

    /// The machine was halted at a height: ZSurface and ZTop have followed on the path and between paths,
    /// not on the way down to the sheet, which is sensed anew; `true` where they have.
    fn heights_left(&mut self, z_mm: f64) -> bool {
        let moves = self.queue.is_following() || self.queue.is_travelling();
        let follows = self.sheet.controlled && moves;
        if follows {
            self.sheet.left_at(&mut self.values.heights, z_mm);
            self.head.position[Axis::Z] = z_mm;
        }
        self.sheet.begun_mm = z_mm;
        follows
    }

    /// Everything that is on goes off.
    pub(crate) fn all_off(&mut self, out: &mut Vec<Sourced>) {
        for output in Output::ALL.iter().filter(|output| self.head.is_on(**output)) {
            self.give(Command::Output { number: output.number(), on: false }, out);
        }
        self.head.all_off();
        self.give(Command::Beam(Beam::Off), out);
    }
}
