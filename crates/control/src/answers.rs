//! Answers to a program's questions: a script, a person, or the default.
//!
//! A script has one answer a line. `OK`, `3, 4` answer the questions in order; `12:OK` answers the
//! question of line 12; `pause=OK` answers every question of a kind. A button is named by its word in
//! any case; `"Cancel"` in quotes is text, not the button. Blank lines are empty answers; lines that
//! begin with `#` are notes. A box that comes back for as long as nothing leads on gets the answer of
//! its kind a thousand times; then it is as if nobody were there.

use crate::hand_words::Aside;
use crate::hand_words::Jog;
use crate::hand_words::KEY;
use crate::nudge::Nudge;
use kerf_journal::Press;
use kerf_machine::{Driven, PauseOrder};
use kerf_program::{Answer, Button, GoTo, Question, QuestionKind};
use std::collections::{BTreeMap, VecDeque};

/// A person or a script that answers questions.
pub trait Operator {
    /// Answers, or leaves it to the default. `line` is the line that asks.
    fn answer(&mut self, question: &Question, line: u32) -> Option<String>;

    /// As [`Operator::answer`], for whoever shows which file asks. This is what a run asks.
    fn answer_in(&mut self, question: &Question, _file: &str, line: u32) -> Option<String> {
        self.answer(question, line)
    }

    /// The tool is moved by hand while a question is open, which is asked again afterwards.
    fn moves(&mut self) {}

    /// An input has answered the question that was asked last.
    fn answered(&mut self) {}

    /// The line of a script that answered last, counted from 1; none when a person did.
    fn script_line(&self) -> Option<usize> {
        None
    }

    /// Returns `true` if a question was left unanswered because the operator stopped the machine: then the run
    /// is over, and the default does not count.
    fn gives_up(&self) -> bool {
        false
    }
}

/// Looks at a machine while somebody is asked, and takes an input of a real one that has changed.
pub fn changed_input(machine: &Driven) -> Option<Press> {
    let mut machine = machine.try_borrow_mut().ok()?;
    machine.look();
    let (number, on) = machine.changed_input()?;
    Some(Press { number, on })
}

/// Answers written down beforehand.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Answers {
    in_order: VecDeque<Line>,
    by_line: BTreeMap<u32, VecDeque<Line>>,
    by_kind: BTreeMap<&'static str, Line>,
    /// The line that answered last.
    last: Option<usize>,
    /// The box that came back last, by its text and the line that asks, and how often it did.
    again: (String, u32, u32),
}

/// Times that a script answers a box that comes back, in the same way: beyond them its answer leads nowhere.
const MOST_TIMES: u32 = 1000;

/// A line of a script.
#[derive(Clone, Debug, PartialEq)]
struct Line {
    number: usize,
    answer: String,
}

impl Answers {
    /// Reads a script.
    pub fn read(text: &str) -> Self {
        let mut answers = Self::default();
        for (index, line) in text.lines().enumerate().filter(|(_, l)| !l.starts_with('#')) {
            answers.add(index + 1, line.trim());
        }
        answers
    }

    /// The answer to all questions of a kind.
    fn for_kind(&mut self, question: &Question, asks: u32) -> Option<Line> {
        let line = self.by_kind.get(kind_word(question.kind))?.clone();
        let returns = matches!(question.kind, QuestionKind::Paused | QuestionKind::Keypad)
            || Aside::is_for(question.kind) && Aside::read(&line.answer).is_some();
        if returns {
            let (text, at, times) = &mut self.again;
            let same = *text == question.text && *at == asks;
            (*text, *at, *times) = (question.text.clone(), asks, if same { *times + 1 } else { 1 });
            return (*times <= MOST_TIMES).then_some(line);
        }
        Some(line)
    }

    fn add(&mut self, number: usize, text: &str) {
        let line = |answer: &str| Line { number, answer: answer.to_owned() };
        if let Some((asks, answer)) = numbered(text) {
            self.by_line.entry(asks).or_default().push_back(line(answer));
        } else if let Some((kind, answer)) = of_kind(text) {
            self.by_kind.insert(kind, line(answer));
        } else {
            self.in_order.push_back(line(text));
        }
    }
}

impl Operator for Answers {
    /// The answer of the line, else of the kind, else the next in order. Boxes that the machine
    /// shows, not the program, leave the next one alone when it does not fit them; a job asks nothing else,
    /// so that what does not fit its boxes is a mistake. Where the machine is is never answered by a line that
    /// was meant for the program: only by one that says so.
    fn answer(&mut self, question: &Question, line: u32) -> Option<String> {
        let by_line = self.by_line.get_mut(&line).and_then(VecDeque::pop_front);
        let given = by_line.or_else(|| self.for_kind(question, line)).or_else(|| {
            let next = self.in_order.front().filter(|_| question.kind != QuestionKind::Location);
            let fits = next.is_some_and(|line| meaning(question, &line.answer).is_some());
            let asked = matches!(
                question.kind,
                QuestionKind::Input
                    | QuestionKind::Msgbox
                    | QuestionKind::Pause
                    | QuestionKind::Paused
            );
            (asked || fits).then(|| self.in_order.pop_front()).flatten()
        });
        self.last = given.as_ref().map(|line| line.number);
        given.map(|line| line.answer)
    }

    fn script_line(&self) -> Option<usize> {
        self.last
    }
}

/// An operator who gives no answer: every question gets its default.
impl Operator for () {
    fn answer(&mut self, _: &Question, _: u32) -> Option<String> {
        None
    }
}

fn numbered(text: &str) -> Option<(u32, &str)> {
    let (line, answer) = text.split_once(':')?;
    Some((line.parse().ok()?, answer.trim()))
}

fn of_kind(text: &str) -> Option<(&'static str, &str)> {
    let (kind, answer) = text.split_once('=')?;
    Some((kind_word(kind_of(kind)?), answer.trim()))
}

/// The kind that a word of the trace stands for.
pub fn kind_of(word: &str) -> Option<QuestionKind> {
    KINDS.into_iter().find(|kind| kind_word(*kind).eq_ignore_ascii_case(word.trim()))
}

/// Every kind of question.
pub const KINDS: [QuestionKind; 12] = [
    QuestionKind::Input,
    QuestionKind::Msgbox,
    QuestionKind::Pause,
    QuestionKind::Spindle,
    QuestionKind::Limit,
    QuestionKind::Keypad,
    QuestionKind::Editor,
    QuestionKind::Speed,
    QuestionKind::Hold,
    QuestionKind::Step,
    QuestionKind::Paused,
    QuestionKind::Location,
];

/// The word for a kind, as the trace writes it.
pub const fn kind_word(kind: QuestionKind) -> &'static str {
    match kind {
        QuestionKind::Input => "input",
        QuestionKind::Msgbox => "msgbox",
        QuestionKind::Pause => "pause",
        QuestionKind::Spindle => "spindle",
        QuestionKind::Limit => "limit",
        QuestionKind::Keypad => "keypad",
        QuestionKind::Editor => "editor",
        QuestionKind::Speed => "speed",
        QuestionKind::Hold => "hold",
        QuestionKind::Step => "step",
        QuestionKind::Paused => "paused",
        QuestionKind::Location => "location",
    }
}

/// Reads the words of an answer in a box; `None` when the box has no such button.
pub fn meaning(question: &Question, words: &str) -> Option<Answer> {
    let quoted = words.strip_prefix('"').and_then(|w| w.strip_suffix('"'));
    let button = Button::ALL.into_iter().find(|b| b.word().eq_ignore_ascii_case(words.trim()));
    if question.kind.takes_text() {
        return Some(match button {
            Some(Button::Cancel) => Answer::Button(Button::Cancel),
            _ => Answer::Text(quoted.unwrap_or(words).to_owned()),
        });
    }
    let button = button.filter(|b| question.buttons.contains(b)).map(Answer::Button);
    button.or_else(|| command(question, words).then(|| Answer::Text(words.to_owned())))
}

/// Tells whether words are a command to the machine, and no button of the box.
fn command(question: &Question, words: &str) -> bool {
    match question.kind {
        QuestionKind::Hold => Nudge::read(words).is_some() || Jog::read(words).is_some(),
        QuestionKind::Keypad => words == KEY || Jog::read(words).is_some(),
        QuestionKind::Paused => is_word(words),
        kind if Aside::is_for(kind) => Aside::read(words).is_some(),
        QuestionKind::Step => GoTo::read(words, question.prefill.parse().ok()).is_some(),
        _ => false,
    }
}

/// Tells whether words command a job that waits: go on, end, move, another speed or height.
pub fn is_word(words: &str) -> bool {
    PauseOrder::read(words).is_some() || Jog::read(words).is_some()
}

/// Effect of an answer on a machine that waits for it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effect {
    /// A value is filled in, or No is said: the program sees to the rest.
    Value,
    /// The asker, or the whole run, is given up.
    Ends,
    /// The machine goes on.
    GoesOn,
    /// The tool is moved by hand.
    Moves,
}

/// Tells what comes of words as the answer to a question of a kind. Words of which nothing is known go on.
pub fn effect(kind: QuestionKind, words: &str) -> Effect {
    if Jog::read(words).is_some() || Nudge::read(words).is_some() {
        return if kind.takes_text() { Effect::Value } else { Effect::Moves };
    }
    if kind == QuestionKind::Paused {
        return effect_on_job(words);
    }
    match Button::ALL.into_iter().find(|button| button.word().eq_ignore_ascii_case(words.trim())) {
        Some(Button::Cancel | Button::Quit | Button::End | Button::Abort) => Effect::Ends,
        Some(Button::No) => Effect::Value,
        _ if kind.takes_text() => Effect::Value,
        _ if words == KEY => Effect::Moves,
        _ => Effect::GoesOn,
    }
}

/// The same for a job that waits.
fn effect_on_job(words: &str) -> Effect {
    match PauseOrder::read(words) {
        Some(PauseOrder::Abort) => Effect::Ends,
        Some(PauseOrder::Move(..)) => Effect::Moves,
        Some(
            PauseOrder::CutSpeed(_)
            | PauseOrder::PlungeSpeed(_)
            | PauseOrder::AdjustBottom(_)
            | PauseOrder::AdjustHeight(_)
            | PauseOrder::Raise(_),
        ) => Effect::Value,
        Some(
            PauseOrder::Continue | PauseOrder::Shape(_) | PauseOrder::Next | PauseOrder::Previous,
        )
        | None => Effect::GoesOn,
    }
}

/// Returns the answer that counts when nobody is there: a file is not stepped through then.
pub fn unattended_answer(question: &Question) -> Answer {
    match question.kind {
        QuestionKind::Step => Answer::Button(Button::Run),
        _ => question.default_answer(),
    }
}

/// The answer of a preview that nobody answers: a value that is asked for is not typed but left to the program.
pub fn previewed_answer(question: &Question) -> Answer {
    match question.kind {
        QuestionKind::Input => Answer::Button(Button::OK),
        _ => unattended_answer(question),
    }
}

/// The words of an answer, as the trace shows them.
pub fn words(answer: &Answer) -> String {
    match answer {
        Answer::Button(button) => button.word().to_owned(),
        Answer::Text(text) => text.clone(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn question(kind: QuestionKind, buttons: &[Button]) -> Question {
        Question {
            kind,
            text: String::new(),
            title: String::new(),
            buttons: buttons.to_vec(),
            default: 1,
            prefill: "7".into(),
            icon: 0,
            until: None,
        }
    }

    #[test]
    fn line_before_kind_before_order() {
        let mut answers = Answers::read("# note\nfirst\n12: twelve\npause = OK\nsecond\n");
        let input = question(QuestionKind::Input, &[]);
        let pause = question(QuestionKind::Pause, &[Button::OK, Button::Cancel]);
        assert_eq!(answers.answer(&pause, 12).as_deref(), Some("twelve"));
        assert_eq!(answers.answer(&pause, 12).as_deref(), Some("OK"));
        assert_eq!(answers.answer(&input, 12).as_deref(), Some("first"));
        assert_eq!(answers.answer(&input, 1).as_deref(), Some("second"));
        assert_eq!(answers.answer(&input, 1), None);
    }

    #[test]
    fn what_does_not_lead_on_is_not_said_for_ever() {
        let mut answers = Answers::read("paused=resume\nmsgbox=OK");
        let paused = question(QuestionKind::Paused, &[Button::Resume, Button::Quit]);
        let pressed = Question { text: "Paused: stop input 4".into(), ..paused.clone() };
        let msgbox = question(QuestionKind::Msgbox, &[Button::OK]);
        let mut times = |question: &Question| {
            (0..5000).take_while(|_| answers.answer(question, 3).is_some()).count()
        };
        assert_eq!([times(&paused), times(&pressed), times(&msgbox)], [1000, 1000, 5000]);
        assert_eq!(times(&paused), 1000, "it is another one after another");
    }

    #[test]
    fn a_box_of_the_machine_takes_no_answer_that_does_not_fit() {
        let mut answers = Answers::read("3.5\nContinue");
        let limit = question(QuestionKind::Limit, &[Button::Continue, Button::End]);
        assert_eq!(answers.answer(&limit, 1), None);
        assert_eq!(answers.answer(&question(QuestionKind::Input, &[]), 2).as_deref(), Some("3.5"));
        assert_eq!(answers.answer(&limit, 3).as_deref(), Some("Continue"));
    }

    #[test]
    fn where_the_machine_is_takes_no_answer_of_the_program() {
        let location = question(QuestionKind::Location, &[Button::Yes, Button::No, Button::Cancel]);
        let mut answers = Answers::read("No\nYes");
        assert_eq!(answers.answer(&location, 0), None);
        assert_eq!(answers.answer(&question(QuestionKind::Msgbox, &[]), 2).as_deref(), Some("No"));
        let mut answers = Answers::read("No\nlocation=Yes");
        assert_eq!(answers.answer(&location, 0).as_deref(), Some("Yes"));
        assert_eq!(Answers::read("0:Yes").answer(&location, 0).as_deref(), Some("Yes"));
    }

    #[test]
    fn a_job_takes_the_next_answer_whatever_it_says() {
        let mut answers = Answers::read("# note\n\ncut 0\nresume");
        let paused = question(QuestionKind::Paused, &[Button::Continue, Button::Abort]);
        let taken = |answers: &mut Answers| (answers.answer(&paused, 1), answers.script_line());
        for (line, words) in [(2, ""), (3, "cut 0"), (4, "resume")] {
            assert_eq!(taken(&mut answers), (Some(words.into()), Some(line)));
        }
        assert_eq!(taken(&mut answers), (None, None));
    }

    #[test]
    fn what_comes_of_an_answer() {
        use Effect::{Ends, GoesOn, Moves, Value};
        use QuestionKind as K;
        let check = |kind, words: &str, expected| {
            assert_eq!(effect(kind, words), expected, "{kind:?} {words}")
        };
        for kind in KINDS.into_iter().filter(|kind| *kind != K::Input) {
            check(kind, "jog 0,400,0,0,0,0 1", Moves);
            check(kind, "nudge x 1", Moves);
            check(kind, "Quit", Ends);
            check(kind, "cancel ", Ends);
            check(kind, "ok", GoesOn);
            check(kind, "Resume", GoesOn);
            check(kind, "perhaps", GoesOn);
        }
        for words in ["3", "jog 0,400,0,0,0,0 1", "OK", "No", ""] {
            check(K::Input, words, Value);
        }
        check(K::Input, "Cancel", Ends);
        check(K::Msgbox, "No", Value);
        check(K::Msgbox, "Yes", GoesOn);
        check(K::Limit, "End", Ends);
        check(K::Limit, "Continue", GoesOn);
        check(K::Keypad, KEY, Moves);
        for words in ["Step", "Run", "12", "12 settings"] {
            check(K::Step, words, GoesOn);
        }
        for words in ["continue", "next", "previous", "+", "-", "3"] {
            check(K::Paused, words, GoesOn);
        }
        for words in ["cut 3000", "plunge 600", "zbottom -0.5", "height 0.1", "raise yes"] {
            check(K::Paused, words, Value);
        }
        check(K::Paused, "move y 200", Moves);
        check(K::Paused, "abort", Ends);
    }

    #[test]
    fn words_that_only_look_like_a_line_or_a_kind_are_answers() {
        let mut answers = Answers::read("a:b\nx=1\n\n3, 4");
        let input = question(QuestionKind::Input, &[]);
        let given: Vec<_> = std::iter::from_fn(|| answers.answer(&input, 1)).collect();
        assert_eq!(given, ["a:b", "x=1", "", "3, 4"]);
    }

    #[test]
    fn buttons_by_their_word_and_only_those_of_the_box() {
        let yes_no = question(QuestionKind::Msgbox, &[Button::Yes, Button::No]);
        assert_eq!(meaning(&yes_no, "yes"), Some(Answer::Button(Button::Yes)));
        assert_eq!(meaning(&yes_no, "Cancel"), None);
        assert_eq!(meaning(&yes_no, "maybe"), None);
        assert_eq!(yes_no.default_answer(), Answer::Button(Button::No));
        let input = question(QuestionKind::Input, &[]);
        assert_eq!(meaning(&input, "cancel"), Some(Answer::Button(Button::Cancel)));
        assert_eq!(meaning(&input, "\"cancel\""), Some(Answer::Text("cancel".into())));
        assert_eq!(meaning(&input, "OK"), Some(Answer::Text("OK".into())));
        assert_eq!(input.default_answer(), Answer::Text("7".into()));
    }
}
