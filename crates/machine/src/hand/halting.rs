//! Stops of a move by hand, and how it goes on.

use super::Hand;
use super::bounds::Leg;
use crate::pause_order::PauseOrder;
use crate::state::{Effect, Event, RELEASE_S, State};
use kerf_diag::{Code, Diagnostic, SourcePlace};
use kerf_program::{
    Answer, Axis, Command, Halted, Host, Question, QuestionKind, Sourced, Status, Step,
};
use std::task::Poll;

impl Hand {
    /// Halts after a stop: the table says whether the tool rises; the rest of the way is kept.
    pub(super) fn halt(&mut self, event: Event, halted: &Halted) {
        self.position = halted.stands;
        self.given = false;
        if self.rest.is_some() {
            // On its way up it was stopped again: it stays where it stands.
            self.legs.clear();
        }
        let Some(mut stands) = self.state.on(event, self.stop_settings()) else { return };
        if let Some(next) = stands.state.on(Event::Stands, self.stop_settings()) {
            stands = next;
        }
        self.state = stands.state;
        if self.rest.is_none() {
            let mut rest = std::mem::take(&mut self.legs);
            rest.push_front(halted.stands.into());
            self.rest = Some(rest);
        }
        let (top, mut up) = (self.machine.zpos.top_mm, halted.stands);
        if stands.effects.contains(&Effect::Raise) && up[Axis::Z] < top {
            up[Axis::Z] = top;
            self.legs.push_back(up.into());
        }
    }

    pub(super) fn ask(&mut self, host: &mut dyn Host, out: &mut Vec<Sourced>) -> Step {
        let words = match host.ask(&self.question()) {
            Poll::Pending => return Step::Waiting,
            Poll::Ready(Answer::Text(words)) => words,
            Poll::Ready(Answer::Button(button)) => button.word().to_owned(),
        };
        match PauseOrder::read(&words) {
            Some(PauseOrder::Continue) => {
                let Some(state) = self.goes_on_in(host, out) else { return Step::Ran };
                self.state = state;
                self.legs = self.rest.take().unwrap_or_default();
                let mut over = self.position;
                if let Some(Leg { to, .. }) = self.legs.front() {
                    (over[Axis::X], over[Axis::Y]) = (to[Axis::X], to[Axis::Y]);
                    self.legs.push_front(over.into());
                }
                let (name, why) = (self.state.name().into(), "".into());
                self.give(Command::State { name, why }, out);
            }
            Some(PauseOrder::Abort) if self.state == State::Limited => {
                let why = self.stopped_for(Code::InputStop);
                return self.end(Status::Limit, Some(why));
            }
            Some(PauseOrder::Abort) => return self.end(Status::Stopped, None),
            _ => {}
        }
        Step::Ran
    }

    /// The state in which it goes on; nothing while a stop input is active.
    fn goes_on_in(&self, host: &mut dyn Host, out: &mut Vec<Sourced>) -> Option<State> {
        let settings = self.stop_settings();
        if self.settings.io.stop_is_active(host) {
            let text = "release the stop input".into();
            self.give(Command::Message { text }, out);
            self.give(Command::Wait { seconds: RELEASE_S }, out);
            return None;
        }
        match self.state {
            State::Limited => Some(self.state.on(Event::Override, settings)?.state),
            State::Blocked => {
                let released = self.state.on(Event::Released, settings)?;
                Some(released.state.on(Event::Continue, settings)?.state)
            }
            state => Some(state.on(Event::Continue, settings)?.state),
        }
    }

    pub(super) fn stopped_for(&self, code: Code) -> Box<Diagnostic> {
        let place = SourcePlace::line(self.errand.name().into(), 0);
        Box::new(Diagnostic::new(code, place, self.why.to_string()))
    }

    fn question(&self) -> Question {
        let limited = self.state == State::Limited;
        Question {
            kind: if limited { QuestionKind::Limit } else { QuestionKind::Paused },
            text: if self.why.is_empty() { "Paused".into() } else { self.why.to_string() },
            title: "Move".into(),
            buttons: self.state.ways_on().into(),
            default: 1,
            prefill: String::new(),
            icon: 0,
            until: None,
        }
    }
}
