//! A job was started and waits for the second Start: the shape it begins with is chosen.

use crate::entry::Typed;
use crate::next::{Next, To};
use crate::{ConsoleRequest, JobRequest, Key, Screen, Waits};
use kerf_machine::Errand;

/// Answer with which a job that waits goes on, as with any question after a stop.
pub(crate) const GO_ON: &str = "Resume";
/// Answer with which it is given up.
const QUIT: &str = "Quit";

/// The number that is typed.
#[derive(Clone, Debug, Default)]
pub(crate) struct Starting {
    typed: Typed,
}

impl Starting {
    pub fn screen(&self, shape: u32, shapes: u32) -> Screen {
        let shown = match self.typed.is_empty() {
            true => format!("Shape {shape} of {shapes}"),
            false => format!("Shape {}", self.typed),
        };
        Screen::new("Start job", shown)
    }

    pub fn press(self, key: Key, shape: u32, shapes: u32) -> Next<Self> {
        let goes = |word: String| Next::request([ConsoleRequest::Answer(word)]);
        match key {
            Key::Digit(_) | Key::Stop => Next::stay(Self { typed: self.typed.press_whole(key) }),
            Key::Start => goes(GO_ON.into()),
            Key::Func => Next::to(To::Aborting),
            Key::PlusMinus if shape > 1 => goes("previous".into()),
            Key::Enter if !self.typed.is_empty() => match self.typed.whole() {
                Some(number) if (1..=shapes).contains(&number) => goes(number.to_string()),
                _ => Next::default().refused(format!("1-{shapes}")),
            },
            Key::Enter if shape < shapes => goes("next".into()),
            Key::PlusMinus | Key::Enter | Key::File => Next::stay(self),
        }
    }
}

/// Enter gives the job up, and the head returns to the origin; any other key leaves it as it is. The shape that
/// was chosen is the one with which the job begins from now on.
pub(crate) fn press_aborting<M>(key: Key, waits: &Waits) -> Next<M> {
    let start = match waits {
        Waits::Start(shape) => Some(ConsoleRequest::Job(JobRequest::Start(*shape))),
        _ => None,
    };
    match key {
        Key::Enter => {
            let goes = [ConsoleRequest::Answer(QUIT.into())].into_iter().chain(start);
            Next::request(goes.chain([ConsoleRequest::Go(Errand::Origin)]))
        }
        _ => Next::default(),
    }
}
