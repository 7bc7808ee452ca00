//! A pendant at the keypad: keys that are wired to inputs (command reference, VD "Keypad remote").
//!
//! A key moves the tool from when it is pressed until it is let go. Whatever else ends a motion, nothing
//! moves before a key is pressed anew: one that is held already was meant for something else.

use crate::Session;
use crate::by_hand::Jog;
use crate::runner::Runner;
use crate::world::World;
use kerf_machine::hand::FAR;
use kerf_machine::settings::pendant::Pendant;
use kerf_part::Program;
use kerf_program::{AXES, Answer, At, Axes, Axis, Button, Interpreter, Question, QuestionKind};
use kerf_sim::{Duty, Watched, duty};

/// Word of a key that moves the tool.
pub(crate) const KEY: &str = "pendant";

impl Session {
    /// Adds errors to a part file that sets what cannot be on this machine: it is not begun.
    pub(crate) fn refuse_keys(&self, program: &mut Program) {
        let keys: Vec<u8> = self.machine_is.pendant.inputs().collect();
        let present = self.memory.settings.display.has_pendant();
        program.diagnostics.extend(kerf_sbp::stops_on_keys(&program.sbp, &keys, present));
    }
}

impl World<'_> {
    /// The keys that work while this question is open. An input that stops the machine is none of them.
    fn keys(&self, question: QuestionKind) -> Option<Pendant> {
        let settings = self.machine.settings();
        let works = question == QuestionKind::Keypad && settings.display.has_pendant();
        let free = |input: u8| if duty(input, &settings.io) == Duty::Free { input } else { 0 };
        let Pendant { axes, fast, close } = self.machine_is.pendant;
        let axes = axes.map(|keys| keys.map(free));
        works.then(|| Pendant { axes, fast: free(fast), close: free(close) })
    }

    /// Returns what a key of the pendant says to a question, when it was just pressed.
    pub fn said_by_key(&self, question: &Question, input: u8) -> Option<&'static str> {
        let keys = self.keys(question.kind).filter(|_| self.machine.input(input))?;
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
}

impl<I: Interpreter> Runner<'_, I> {
    /// Moves for as long as keys are held, another way as soon as others are. Tells whether a key closes
    /// the keypad.
    pub(crate) fn follow_pendant(&mut self) -> bool {
        let Some(keys) = self.world.keys(QuestionKind::Keypad) else { return false };
        let closes = loop {
            let machine = &self.world.machine;
            let pressed = |input: u8| machine.input(input);
            let way = keys.way(pressed);
            if pressed(keys.close) || way == [0.0; AXES] {
                break pressed(keys.close);
            }
            let change = |input: u8| Watched {
                input,
                on: !pressed(input),
                ramped: true,
                level_from_s: None,
            };
            let changes: Vec<Watched> = keys.inputs().map(change).collect();
            let speed = if pressed(keys.fast) { 1.0 } else { self.slow_share(way) };
            let jog = Jog { by: Axes(way.map(|way| way * FAR)), speed };
            if !self.jog_until(jog, &changes) {
                break false;
            }
        };
        self.interpreter.moved(self.world.machine.position());
        closes
    }

    /// The share of the jog speed at which cuts are made.
    fn slow_share(&self, way: [f64; AXES]) -> f64 {
        let speeds = &self.world.machine.settings().speeds;
        let share = |axis| speeds.cut.of(axis) / speeds.jog.of(axis);
        let moves = Axis::ALL.into_iter().filter(|axis| way[axis.index()] != 0.0);
        moves.map(share).fold(1.0, f64::min)
    }

    /// Keys are pressed while a program asks: they move the tool, or close the keypad.
    pub(crate) fn use_pendant(&mut self, at: At) {
        if self.follow_pendant() {
            self.world.answered_by_input(Answer::Button(Button::OK), at);
        }
    }
}
