//! Digitizing (function 70): the tool is driven to the points of a shape, and Enter records each of them.

mod asking;
mod table;

pub use table::{Entry, FUNCTIONS};

use crate::next::{Next, To};
use crate::{ConsoleRequest, Key, Screen, View, Waits, idle, running};
use asking::Asks;
use kerf_digitize::{Digitizer, Dimension, Kind, Leg, Stand};
use kerf_machine::{Errand, Stretch};
use kerf_program::Axis;
use kerf_wire::State;

/// The points, and what is asked.
#[derive(Clone, Debug, Default)]
pub(crate) struct Digitizing {
    points: Digitizer,
    /// The way on which the tool was sent last: where it comes to decides which point is current.
    way: Vec<Leg>,
    asks: Asks,
    /// A shape of the points is being added to the drawing or the job.
    saving: bool,
}

impl Digitizing {
    /// Begins with points that were left.
    pub fn of(points: Digitizer) -> Self {
        Self { points, ..Self::default() }
    }

    /// The points as they are with the tool where it is.
    pub fn points(&self, view: &View) -> Digitizer {
        let mut points = self.points.clone();
        points.moved(&self.way, &stand(view));
        points
    }

    /// The tool has come to rest: what it has reached on its way is settled.
    pub fn follow(&mut self, view: &View) {
        if !self.way.is_empty() && view.state == State::Idle {
            self.points.moved(&self.way, &stand(view));
            self.way.clear();
        }
    }

    /// Takes the outcome of the last request; returns its name where a shape was being saved, else an empty text.
    pub fn told(&mut self, done: bool) -> &'static str {
        if !std::mem::take(&mut self.saving) {
            return "";
        }
        if done {
            self.points.saved();
        }
        "Shape saved"
    }

    pub fn screen(&self, view: &View) -> Screen {
        match &view.waits {
            Waits::Question(asked) => return running::question(asked),
            Waits::Start(_) | Waits::Paused => return running::screen_of_shape("Paused", view),
            Waits::No if view.state == State::Alarm => return running::screen(view),
            Waits::No => {}
        }
        let points = self.points(view);
        self.asks.screen(&points, view).unwrap_or_else(|| idle_screen(&points))
    }

    pub fn press(mut self, key: Key, view: &View) -> Next<Self> {
        self.follow(view);
        let elsewhere = match &view.waits {
            Waits::Question(asked) => Some(running::press_asked(key, asked)),
            Waits::Start(_) | Waits::Paused => Some(running::press_paused(key)),
            Waits::No if view.state != State::Idle => Some(running::press(key, view.state)),
            Waits::No => None,
        };
        match elsewhere {
            Some(next) => next.within(|_: To<Self>| To::Stay(self)),
            None if self.asks.is_open() => self.answer(key, view),
            None => self.press_at_rest(key, view),
        }
    }

    /// The keys that move through the points and record them.
    fn press_at_rest(mut self, key: Key, view: &View) -> Next<Self> {
        let tool = stand(view);
        if !matches!(key, Key::Digit(_)) {
            self.asks = Asks::Nothing;
        }
        match key {
            Key::Digit(digit) => self.stay().and(idle::jog(digit, view).map(ConsoleRequest::Jog)),
            Key::PlusMinus => self.edit(Digitizer::toggle),
            Key::Enter => self.edit(|points| points.append(tool)),
            Key::File => {
                let way = self.points.way_back(&tool);
                self.go(way)
            }
            Key::Start => {
                let way = self.points.way_on(&tool);
                self.go(way)
            }
            Key::Stop => self.stay(),
            Key::Func => self.ask(Asks::function()),
        }
    }

    fn stay(self) -> Next<Self> {
        Next::stay(self)
    }

    fn ask(self, asks: Asks) -> Next<Self> {
        Self { asks, ..self }.stay()
    }

    /// An edit of the points, or why it cannot be.
    fn edit(
        mut self,
        edit: impl FnOnce(&mut Digitizer) -> Result<(), kerf_digitize::Refusal>,
    ) -> Next<Self> {
        match edit(&mut self.points) {
            Ok(()) => self.stay(),
            Err(why) => self.stay().refused(why.to_string()),
        }
    }

    /// The tool goes a way; a beep says that there is none.
    fn go(self, way: Vec<Leg>) -> Next<Self> {
        if way.is_empty() {
            return self.stay().beep();
        }
        let stretches = way.iter().map(|leg| Stretch { path: leg.path, z_mm: leg.z_mm });
        let errand = Errand::Along(stretches.collect());
        Self { way, ..self }.stay().and([ConsoleRequest::Go(errand)])
    }

    /// The points become a shape of the drawing or the job.
    fn save(self, closed: bool, view: &View) -> Next<Self> {
        match self.points.shape(closed, view.machine.zpos.surface_mm) {
            Ok(shape) => {
                Self { saving: true, ..self }.stay().and([ConsoleRequest::AddShape(shape.into())])
            }
            Err(why) => self.stay().refused(why.to_string()),
        }
    }

    /// The points of the nearest shape take the place of these.
    fn load(self, view: &View) -> Next<Self> {
        let (tool, surface_mm) = (stand(view), view.machine.zpos.surface_mm);
        let shapes = view.drawn.clone();
        self.edit(|points| {
            let all = shapes.iter().map(std::convert::AsRef::as_ref);
            let (place, _) = kerf_digitize::nearest_shape(all, tool.at)?;
            points.load(&shapes[place], surface_mm, &tool)
        })
    }
}

/// Returns the place of the tool, from the job origin.
pub(crate) fn stand(view: &View) -> Stand {
    let [x0, y0] = view.machine.job.origin_mm;
    let at = &view.position;
    Stand::new(at[Axis::X] - x0, at[Axis::Y] - y0, at[Axis::Z])
}

fn idle_screen(points: &Digitizer) -> Screen {
    let count = points.points().len();
    Screen::new(heading(points), format!("Cur={} of {count}", points.current()))
}

/// Dimension, and kind of the next point.
fn heading(points: &Digitizer) -> String {
    let dimension = if points.dimension() == Dimension::Two { "2D" } else { "3D" };
    let kind = if points.next() == Kind::Line { "Point" } else { "Arc" };
    format!("Digitize: {dimension} {kind}")
}
