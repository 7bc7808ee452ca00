//! Following a program to its end: what it does, with its comments, questions and tools.

use crate::host::{MachineAtOnce, Seen};
use crate::item::{Item, Passage};
use kerf_diag::{Code, Diagnostic, SourcePlace};
use kerf_program::settings::LinearUnit;
use kerf_program::{
    Answer, At, Button, Command, Hold, Host, Interpreter, Lost, Question, QuestionKind, Sourced,
    Step,
};
use std::collections::BTreeSet;
use std::sync::Arc;

/// More than this, and than a few for each line, is a loop without an end; some hundred megabytes.
const MOST_ITEMS: usize = 2_000_000;

/// Items of a line, as many as a long program without loops may need.
const ITEMS_A_LINE: usize = 8;

/// Interface to a language that following needs besides [`Interpreter`].
pub trait Language: Interpreter {
    /// The line that runs next.
    fn next_line(&self) -> Option<At>;
    /// The comment behind the code of a line.
    fn comment_beside(&self, at: At) -> Option<Arc<str>>;
    /// Returns `true` if such a comment comes as a message too.
    fn tells_comments(&self) -> bool;
    /// The unit of the file now.
    fn unit(&self) -> LinearUnit;
    /// The tool that the change that just began puts in, where the program names it before.
    fn wanted_tool(&self) -> Option<String>;
    /// Returns what a line asks for that only the machine knows, as part of a sentence.
    fn machine_place(&self, at: At) -> Option<&'static str>;
}

/// Follows a program to its end.
pub fn follow<I: Language>(mut interpreter: I, lines: usize, behind: &mut dyn Host) -> Passage {
    let most_items = MOST_ITEMS.max(ITEMS_A_LINE.saturating_mul(lines));
    let mut host = MachineAtOnce::new(behind, interpreter.position().0);
    let mut follower = Follower::default();
    follower.passage.start = interpreter.position();
    let mut out = Vec::new();
    loop {
        let next = interpreter.next_line();
        let step = interpreter.step(&mut host, &mut out);
        if let Some(at) = next.filter(|_| step != Step::Waiting) {
            follower.line(&interpreter, at);
        }
        let at = next.unwrap_or_default();
        for watch in interpreter.watches() {
            host.see_once(format!("waiting for input {} beside motion", watch.input));
        }
        let mut seen = host.take_seen();
        if next.is_none() {
            // Before the first line and behind the last one only the machine notes something.
            seen.clear();
        }
        let mut seen = seen.into_iter();
        for sourced in std::mem::take(&mut out) {
            host.carry_out(&sourced.command);
            if matches!(sourced.command, Command::ToolChange { begin: false }) {
                // What is asked while a tool is changed belongs to the change.
                seen.by_ref().for_each(|seen| follower.seen(seen, at));
            }
            follower.command(&interpreter, sourced);
        }
        // A line that asks does it last, but for a change of tools.
        seen.for_each(|seen| follower.seen(seen, at));
        match step {
            Step::Ran if follower.passage.items.len() > most_items => {
                let at =
                    SourcePlace::line(interpreter.file_name(at.file).unwrap_or_default(), at.line);
                let message = "the program does not come to an end";
                let diagnostic = Diagnostic::new(Code::LineLimit, at, message)
                    .hint("is there a loop that never ends?");
                return follower.finish(&interpreter, None, Some(Box::new(diagnostic)));
            }
            Step::Ran => {}
            // Nothing is ever under way on paper: a question without an answer ends it.
            Step::Waiting => return follower.finish(&interpreter, None, None),
            Step::Done(status, diagnostic) => {
                return follower.finish(&interpreter, Some(status), diagnostic);
            }
        }
    }
}

/// Comments of custom cuts are for their owner.
fn is_custom<I: Language>(interpreter: &I, at: At) -> bool {
    at.file > 0
        && interpreter.file_name(at.file).is_some_and(|n| n.to_ascii_lowercase().ends_with(".sbc"))
}

#[derive(Default)]
struct Follower {
    passage: Passage,
    /// Comments written since the last command, so that an empty loop does not repeat them.
    comments: BTreeSet<At>,
    /// Places of the machine that were told already.
    places: BTreeSet<At>,
}

impl Follower {
    /// A line ran.
    fn line<I: Language>(&mut self, interpreter: &I, at: At) {
        if let Some(place) = interpreter.machine_place(at)
            && self.places.insert(at)
        {
            self.lose(at, place.into());
        }
        if interpreter.tells_comments() || is_custom(interpreter, at) {
            return;
        }
        if let Some(text) = interpreter.comment_beside(at)
            && self.comments.insert(at)
        {
            self.passage.items.push(Item::Beside(text));
        }
    }

    fn command<I: Language>(&mut self, interpreter: &I, sourced: Sourced) {
        let items = &mut self.passage.items;
        match &sourced.command {
            Command::Diagnostic(diagnostic) => {
                return self.passage.diagnostics.push((**diagnostic).clone());
            }
            Command::Message { .. } if is_custom(interpreter, sourced.at) => return,
            Command::Message { text } => {
                if self.comments.insert(sourced.at) {
                    let beside = interpreter.tells_comments()
                        && interpreter.comment_beside(sourced.at).as_ref() == Some(text);
                    items.push(if beside {
                        Item::Beside(text.clone())
                    } else {
                        Item::Command(sourced)
                    });
                }
                return;
            }
            Command::ToolChange { begin: true } => {
                items.extend(interpreter.wanted_tool().map(Item::NextTool));
            }
            Command::Line(_) | Command::Arc(_) => {
                let now = || (interpreter.unit(), interpreter.settings().clone());
                self.passage.at_motion.get_or_insert_with(now);
            }
            _ => {}
        }
        self.comments.clear();
        items.push(Item::Command(sourced));
    }

    fn seen(&mut self, seen: Seen, at: At) {
        match seen {
            Seen::Other(what) => self.lose(at, what),
            Seen::Asked(question, answer) => self.asked(&question, &answer, at),
        }
        self.comments.clear();
    }

    /// A question becomes a place where the operator goes on; an answer that decided something is
    /// fixed from now on.
    fn asked(&mut self, question: &Question, answer: &Answer, at: At) {
        let decided = match answer {
            Answer::Text(text) => Some(format!("an answer of the operator: '{text}' was taken")),
            Answer::Button(button) if question.buttons.len() > 1 => {
                let plain = question.kind == QuestionKind::Pause && *button == Button::OK;
                (!plain).then(|| format!("a choice of the operator: {} was taken", button.word()))
            }
            Answer::Button(_) => None,
        };
        let items = &mut self.passage.items;
        let above = |item: &Item| {
            matches!(item, Item::Command(Sourced { command: Command::Message { text }, .. })
                if **text == *question.text)
                || matches!(item, Item::Beside(text) if **text == *question.text)
        };
        if items.last().is_some_and(above) {
            items.pop();
        }
        let usual = ["Continue?", "program stop (M0)", "optional stop (M1)", "program stop (M60)"];
        let text = if usual.contains(&question.text.as_str()) { "" } else { &question.text };
        items.push(Item::Hold(Hold { at, text: text.into(), until: question.until }));
        if let Some(decided) = decided {
            self.lose(at, decided);
        }
    }

    fn lose(&mut self, at: At, what: String) {
        self.passage.items.push(Item::Lost(Lost { at, what, is_motion: false }));
    }

    fn finish<I: Language>(
        mut self,
        interpreter: &I,
        status: Option<kerf_program::Status>,
        diagnostic: Option<Box<Diagnostic>>,
    ) -> Passage {
        self.passage.status = status;
        self.passage.diagnostics.extend(diagnostic.map(|d| *d));
        self.passage.files =
            (0..).map_while(|file| interpreter.file_name(file)).take(10_000).collect();
        self.passage
    }
}
