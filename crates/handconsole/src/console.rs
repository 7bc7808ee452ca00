//! The console: which mode it is in, and what a key does there.

use crate::digitizing::Digitizing;
use crate::file::Choosing;
use crate::functions::{Selecting, Stepping};
use crate::next::{Next, Note, To};
use crate::start::Starting;
use crate::{ConsoleRequest, Key, Screen, View, Waits, idle, running, start};
use kerf_digitize::Digitizer;
use kerf_wire::State;

/// Present use of the console.
#[derive(Clone, Debug)]
enum Mode {
    /// Nothing: what the machine does decides what is shown, and what keys mean.
    Rest(Starting),
    /// A job is chosen.
    File(Choosing),
    /// A function is chosen.
    Selecting(Selecting),
    /// A function asks for its numbers and places.
    Stepping(Stepping),
    /// Points of a shape are recorded.
    Digitizing(Box<Digitizing>),
    /// A job is to be aborted, if Enter says so.
    Aborting,
    /// The machine does what the function of this name wants.
    Doing(&'static str),
}

impl Default for Mode {
    fn default() -> Self {
        Self::Rest(Starting::default())
    }
}

/// The hand console.
#[derive(Clone, Debug, Default)]
pub struct Console {
    mode: Mode,
    note: Option<Note>,
    beeps: u32,
    /// Points that were being digitized when Kerf ended.
    left: Option<Digitizer>,
}

impl Console {
    /// A console with points that were being digitized when Kerf ended: function 70 goes on with them.
    pub fn with_points(points: Digitizer) -> Self {
        Self { left: Some(points), ..Self::default() }
    }

    /// Takes a key and returns its requests. A key that means nothing now changes nothing.
    pub fn press(&mut self, key: Key, view: &View) -> Vec<ConsoleRequest> {
        if key == Key::Stop && view.is_moving() {
            return vec![ConsoleRequest::Stop];
        }
        if let Some(note) = self.note.take()
            && key == Key::Enter
        {
            if note.control {
                return vec![ConsoleRequest::TakeControl];
            }
            // Points that are being digitized are not put away by a key that says "I have read it".
            if !matches!(self.mode, Mode::Digitizing(_)) {
                self.mode = Mode::default();
            }
            return Vec::new();
        }
        let mut next = std::mem::take(&mut self.mode).press(key, view);
        if let To::Function(function) = next.to {
            next = Stepping::begin(function, view).map(Mode::Stepping);
        }
        self.mode = Mode::after(next.to, view);
        if let Mode::Digitizing(digitizing) = &mut self.mode
            && let Some(points) = self.left.take()
        {
            **digitizing = Digitizing::of(points);
        }
        self.note = next.note;
        self.beeps += u32::from(next.beeps);
        next.requests
    }

    /// Takes the outcome of a request: its finding, where that is more than that it is done; or why it is refused.
    /// Both are shown until the next key. Enter returns from there to what the machine shows.
    pub fn told(&mut self, outcome: Result<String, String>) {
        let name = match &mut self.mode {
            Mode::Doing(name) => name,
            Mode::Digitizing(digitizing) => digitizing.told(outcome.is_ok()),
            _ => "",
        };
        self.stand();
        match outcome {
            Err(why) => self.show(Screen::of_text(&why), false),
            Ok(found) if found.is_empty() => {}
            Ok(found) => {
                let screen = Screen::new(name, found);
                self.note = Some(Note { screen, control: false });
            }
        }
    }

    /// A request is refused because somebody else drives, or the machine is disarmed: Enter takes control.
    pub fn needs_control(&mut self, why: &str) {
        self.stand();
        self.show(Screen::new(why, "Enter takes control"), true);
    }

    /// The machine does nothing any more for a function.
    fn stand(&mut self) {
        if matches!(self.mode, Mode::Doing(_)) {
            self.mode = Mode::default();
        }
    }

    fn show(&mut self, screen: Screen, control: bool) {
        self.note = Some(Note { screen, control });
        self.beeps += 1;
    }

    /// Returns the screen that it shows.
    pub fn screen(&self, view: &View) -> Screen {
        match (&self.note, &self.mode) {
            (Some(note), _) => note.screen.clone(),
            (None, mode) => mode.screen(view),
        }
    }

    /// The machine is where a view says, also while no key is pressed.
    pub fn follow(&mut self, view: &View) {
        if let Mode::Digitizing(digitizing) = &mut self.mode {
            digitizing.follow(view);
        }
    }

    /// The points that are being digitized; nothing while none are.
    pub fn digitized(&self, view: &View) -> Option<Digitizer> {
        match &self.mode {
            Mode::Digitizing(digitizing) => Some(digitizing.points(view)),
            _ => None,
        }
    }

    /// Returns the number of beeps so far.
    pub const fn beeps(&self) -> u32 {
        self.beeps
    }
}

impl Mode {
    /// The mode that a key leads to.
    fn after(to: To<Self>, view: &View) -> Self {
        match to {
            To::Rest | To::Function(_) => Self::default(),
            To::Stay(mode) => mode,
            To::File => Self::File(Choosing::new(&view.files)),
            To::Selecting => Self::Selecting(Selecting::default()),
            To::Digitizing => Self::Digitizing(Box::default()),
            To::Aborting => Self::Aborting,
            To::Doing(name) => Self::Doing(name),
        }
    }

    fn press(self, key: Key, view: &View) -> Next<Self> {
        match self {
            Self::Rest(starting) => match &view.waits {
                Waits::Start(shape) => starting.press(key, *shape, view.shapes()).map(Self::Rest),
                Waits::Paused => running::press_paused(key),
                Waits::Question(asked) => running::press_asked(key, asked),
                Waits::No => match (view.state, key) {
                    (State::Idle, _) => idle::press(key, view),
                    // The key before was let go, and the tool slows down.
                    (State::Jogging, Key::Digit(digit)) => {
                        Next::request(idle::jog(digit, view).map(ConsoleRequest::Jog))
                    }
                    (state, _) => running::press(key, state),
                },
            },
            Self::File(choosing) => choosing.press(key).map(Self::File),
            Self::Selecting(selecting) => selecting.press(key).map(Self::Selecting),
            Self::Stepping(stepping) => stepping.press(key, view).map(Self::Stepping),
            Self::Digitizing(digitizing) => {
                let next = digitizing.press(key, view);
                next.map(|digitizing| Self::Digitizing(Box::new(digitizing)))
            }
            Self::Aborting => start::press_aborting(key, &view.waits),
            Self::Doing(_) => Next::stay(self),
        }
    }

    fn screen(&self, view: &View) -> Screen {
        match self {
            Self::Rest(starting) => match &view.waits {
                Waits::Start(shape) => starting.screen(*shape, view.shapes()),
                Waits::Paused => running::screen_of_shape("Paused", view),
                Waits::Question(asked) => running::question(asked),
                Waits::No if view.state == State::Idle => idle::screen(view),
                Waits::No => running::screen(view),
            },
            Self::File(choosing) => choosing.screen(),
            Self::Selecting(selecting) => selecting.screen(),
            Self::Stepping(stepping) => stepping.screen(view),
            Self::Digitizing(digitizing) => digitizing.screen(view),
            Self::Aborting => Screen::new("Abort? Enter=yes", ""),
            Self::Doing(name) => Screen::new(name, ""),
        }
    }
}
