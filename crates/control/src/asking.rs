//! Questions to the operator: how they are asked, heard and told.

use crate::answers;
use crate::hand_words::KEY;
use crate::world::World;
use kerf_journal::{Kind, Press};
use kerf_machine::settings::pendant::Pendant;
use kerf_model::{Duty, contact, duty};
use kerf_program::{Answer, At, Button, Question, QuestionKind};
use kerf_trace::event::{AskEvent, Event};

/// Words that a job that waits is told besides its buttons: an example of each.
const TELLS_JOBS: &str = "cut 3000, plunge 600, zbottom -0.5, height 0.1, raise no, move x 10; before it starts \
                          next, previous, 3";

/// Reason for which a question has no answer.
#[derive(Debug)]
pub(crate) enum Unanswered {
    /// The operator stopped the machine instead.
    Stopped,
    /// The answer is no button of the box: what is told of it.
    NoButton(String),
}

impl World<'_> {
    /// Asks the operator and tells it.
    ///
    /// # Errors
    /// The operator stops instead, or the script answers with a button that the box does not have.
    pub fn ask_now(&mut self, question: &Question, at: At) -> Result<Answer, Unanswered> {
        self.model.warning_off();
        self.tell_log();
        let given = self.hear_answer(question, at)?;
        let scripted = given.is_some();
        let answer = match given {
            None if self.previews => answers::previewed_answer(question),
            None => answers::unattended_answer(question),
            Some(words) => answers::meaning(question, &words)
                .ok_or_else(|| Unanswered::NoButton(self.fits_nothing(question, &words)))?,
        };
        self.told_question(question, &answer, scripted, at);
        if question.kind == QuestionKind::Limit && answer == Answer::Button(Button::Continue) {
            // Going on beyond the table says nothing of the switches, and one switch nothing of the others.
            match self.limit.take() {
                Some(input) => self.model.override_switch(input),
                None => self.model.override_table(),
            }
        }
        Ok(answer)
    }

    /// Returns the message about an answer that a box does not take.
    fn fits_nothing(&self, question: &Question, words: &str) -> String {
        let buttons: Vec<_> = question.buttons.iter().map(|b| b.word()).collect();
        let buttons = buttons.join(", ");
        let line = self.operator.script_line().map(|line| format!("line {line} of the answers: "));
        let line = line.unwrap_or_default();
        if question.kind == QuestionKind::Paused {
            let told = "tells a job that waits nothing";
            return format!("{line}'{words}' {told} (it takes {buttons}, {TELLS_JOBS})");
        }
        format!("{line}the answer '{words}' is no button of this box ({buttons})")
    }

    /// The operator moves the tool by hand while a question is open.
    pub fn moved_by_hand(&mut self) {
        if !self.silent {
            self.operator.moves();
        }
    }

    /// An input has answered what the operator was asked.
    pub fn answered(&mut self) {
        if !self.silent {
            self.operator.answered();
        }
    }

    /// Hears what the operator says. He may move switches of the simulated machine before, and those of a real one change; the one
    /// that the question waits for answers it, and so do the keys of a pendant.
    fn hear_answer(&mut self, question: &Question, at: At) -> Result<Option<String>, Unanswered> {
        let file = self.file(at);
        loop {
            let operator = &mut self.operator;
            let (given, gives_up) = self.workspace.tape.change(Kind::Answer, || {
                let given = operator.answer_in(question, &file, at.line);
                let gives_up = given.is_none() && operator.gives_up();
                (given, gives_up)
            });
            if gives_up {
                return Err(Unanswered::Stopped);
            }
            let Some(press) = given.as_deref().and_then(Press::read) else { return Ok(given) };
            let Press { number: input, on } = press;
            self.hear_switch(input, on);
            self.tell_log();
            self.heed_switch();
            let ok = Button::OK.word();
            let waits = question.until.is_some_and(|(n, on)| self.model.input(n) == on);
            let said = if waits { Some(ok) } else { self.said_by_key(question, input) };
            if said == Some(ok) {
                self.answered();
            }
            if let Some(said) = said {
                return Ok(Some(said.into()));
            }
        }
    }

    /// A switch is moved while somebody is asked: the contact of one that hands move, or the state that a real machine tells.
    fn hear_switch(&mut self, input: u8, on: bool) {
        if self.driven.borrow().facts().inputs_by_hand {
            return self.tracked().press(input, on);
        }
        let (on, now_s) = (contact(input, on, &self.model.settings().io), self.now());
        self.tracked().learn(input, on, now_s);
        self.tracked().advance(now_s);
    }

    /// An input that the program waits for answered for the operator.
    pub fn answered_by_input(&mut self, answer: Answer, at: At) {
        if let Some(question) = self.question.take() {
            self.told_question(&question, &answer, true, at);
            self.answer = Some(answer);
        }
    }

    fn told_question(&mut self, question: &Question, answer: &Answer, scripted: bool, at: At) {
        let default = answers::words(&question.default_answer());
        let nothing_typed = question.kind.takes_text() && *answer == Answer::Button(Button::OK);
        let event = Event::Ask(AskEvent {
            kind: question.kind,
            text: question.text.clone(),
            title: question.title.clone(),
            buttons: question.buttons.iter().map(|b| b.word()).collect(),
            answer: if nothing_typed { default.clone() } else { answers::words(answer) },
            default,
            scripted,
            t: self.now(),
            file: self.file(at),
            line: at.line,
        });
        self.tell(&event);
    }

    /// The keys that work while this question is open. An input that stops the machine is none of them.
    pub fn keys(&self, question: QuestionKind) -> Option<Pendant> {
        let settings = self.model.settings();
        let works = question == QuestionKind::Keypad && settings.display.has_pendant();
        let free = |input: u8| if duty(input, &settings.io) == Duty::Free { input } else { 0 };
        let Pendant { axes, fast, close } = self.machine_is.pendant;
        let axes = axes.map(|keys| keys.map(free));
        works.then(|| Pendant { axes, fast: free(fast), close: free(close) })
    }

    /// Returns what a key of the pendant says to a question, when it was just pressed.
    pub fn said_by_key(&self, question: &Question, input: u8) -> Option<&'static str> {
        let keys = self.keys(question.kind).filter(|_| self.model.input(input))?;
        let known = keys.inputs().any(|key| key == input);
        known.then(|| if input == keys.close { Button::OK.word() } else { KEY })
    }

    /// Returns the moment at which the next key of the pendant is pressed, seconds of machine time.
    pub fn next_key_s(&mut self, question: QuestionKind) -> Option<f64> {
        let keys = self.keys(question)?;
        let tracked = self.tracked();
        let pressed = keys.inputs().filter_map(|input| tracked.when_pressed(input, true));
        pressed.min_by(f64::total_cmp)
    }

    /// A switch was moved while somebody is asked: what turns stops when it is a stop.
    pub fn heed_switch(&mut self) {
        let stops = self.model.stop_input().is_some() || self.is_pressed();
        if stops && self.model.turns() {
            self.stop_turning();
            self.tell_log();
        }
    }
}
