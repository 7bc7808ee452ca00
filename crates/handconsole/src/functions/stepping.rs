//! A function asks for its numbers and heights, one after the other.

use super::spec::{Function, Step, shown};
use crate::entry::Typed;
use crate::next::{Next, To};
use crate::{ConsoleRequest, Key, Screen, View, idle};
use kerf_machine::Held;
use kerf_program::Axis;

/// A function, and what it was told so far.
#[derive(Clone, Debug)]
pub(crate) struct Stepping {
    function: &'static Function,
    answers: Vec<f64>,
    typed: Typed,
}

impl Stepping {
    /// A function begins.
    pub fn begin(function: &'static Function, view: &View) -> Next<Self> {
        Self { function, answers: Vec::new(), typed: Typed::default() }.go_on(view)
    }

    fn step(&self) -> Option<&'static Step> {
        self.function.steps.get(self.answers.len())
    }

    /// Goes on to the next question; finishes when everything is known.
    fn go_on(self, view: &View) -> Next<Self> {
        match self.step() {
            None => self.finish(view),
            Some(Step::Number { .. }) => Next::stay(self),
            Some(Step::Height { there, .. }) => {
                let ways = there(view).into_iter().map(ConsoleRequest::Go);
                Next::stay(self).and(ways)
            }
        }
    }

    fn finish(self, view: &View) -> Next<Self> {
        let Self { function, mut answers, .. } = self;
        match (function.does)(&answers, view) {
            Ok(done) if done.requests.iter().any(ConsoleRequest::lasts) => {
                Next::to(To::Doing(function.name)).and(done.requests)
            }
            Ok(done) => Next::request(done.requests).said(function.name, &done.says),
            Err(why) => {
                // The last number is asked for again.
                answers.pop();
                let again = Self { function, answers, typed: Typed::default() };
                let asks = again.step().is_some();
                let next = if asks { Next::stay(again) } else { Next::default() };
                next.refused(why)
            }
        }
    }

    fn answered(mut self, value: f64, view: &View) -> Next<Self> {
        self.answers.push(value);
        self.typed = Typed::default();
        self.go_on(view)
    }

    pub fn screen(&self, view: &View) -> Screen {
        match self.step() {
            Some(Step::Number { prompt, now }) => {
                let value = match self.typed.is_empty() {
                    true => now(view).map(shown).unwrap_or_default(),
                    false => self.typed.to_string(),
                };
                Screen::new(prompt, value)
            }
            Some(Step::Height { prompt, .. }) => {
                Screen::new(prompt, format!("z {}", shown(view.position[Axis::Z])))
            }
            None => Screen::new(self.function.name, ""),
        }
    }

    pub fn press(self, key: Key, view: &View) -> Next<Self> {
        match (self.step(), key) {
            (_, Key::Func) | (None, _) => Next::default(),
            (Some(Step::Number { now, .. }), Key::Enter) => {
                let kept = if self.typed.is_empty() { now(view) } else { self.typed.value() };
                match kept {
                    Some(value) => self.answered(value, view),
                    None => Next::stay(self).beep(),
                }
            }
            (Some(Step::Number { .. }), _) => {
                let typed = self.typed.clone().press(key);
                Next::stay(Self { typed, ..self })
            }
            (Some(Step::Height { .. }), Key::Enter) => self.answered(view.position[Axis::Z], view),
            (Some(Step::Height { .. }), Key::Digit(digit)) => {
                let jog = idle::jog(digit, view).map(|held| Held { sets_bottom: true, ..held });
                Next::stay(self).and(jog.map(ConsoleRequest::Jog))
            }
            (Some(Step::Height { .. }), _) => Next::stay(self),
        }
    }
}
