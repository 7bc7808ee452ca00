//! From the plans of a run to a plot of its motion.
//!
//! The plan is asked a thousand times a second, as a drive that follows it would, and at the ends of
//! every move. Jerk is what the acceleration changes by between two questions: where a model lets
//! acceleration step, it is the step over a millisecond.

use kerf_motion::{Move, State};
use kerf_preview::Unit;
use kerf_preview::plot::{Doing, Moment, Plot, Rates};
use kerf_program::settings::AxisUnit;
use kerf_program::{AXES, Axes, Axis, Settings};
use kerf_trace::{Event, ExecutedMove, Sink};

/// Time between two questions, seconds.
const STEP_S: f64 = 0.001;
/// Time inside a move at which its ends are asked, seconds.
const INSIDE_S: f64 = 1e-7;
/// Slower is standing, mm/s.
const STANDS_MM_S: f64 = 1e-6;

/// Fills a plot from a run.
#[derive(Debug)]
pub struct Curves {
    /// The plot.
    pub plot: Plot,
    /// From when to when, seconds.
    window: [f64; 2],
    /// Axes whose numbers are degrees, whatever the unit of length.
    degrees: [bool; AXES],
    begun: bool,
    /// End of the last move: seconds, and mm along the path.
    at: [f64; 2],
    /// Acceleration at the last question on the grid of time, and when that was.
    last: (f64, Push),
    /// Latest rate of change of the acceleration.
    jerk: Push,
}

/// Acceleration or jerk, along the path and of every axis.
#[derive(Clone, Copy, Debug, Default)]
struct Push {
    path: f64,
    axes: Axes,
}

impl Curves {
    /// Nothing yet; shows a stretch of time of a machine with these settings.
    pub fn new(title: String, axes: &[Axis], window: [f64; 2], settings: &Settings) -> Self {
        let mut plot = Plot::new(title, axes);
        plot.note = format!("ramps {}", settings.model().word());
        let degrees = Axis::ALL.map(|axis| settings.axis_unit(axis) == AxisUnit::Degrees);
        for axis in axes.iter().filter(|axis| degrees[axis.index()]) {
            plot.note += &format!(" · {} in degrees", axis.letter());
        }
        let (last, jerk) = Default::default();
        Self { plot, window, degrees, begun: false, at: [0.0; 2], last, jerk }
    }

    fn shows(&self, t_s: f64) -> bool {
        (self.window[0]..=self.window[1]).contains(&t_s)
    }

    fn push(&mut self, moment: &Moment) {
        if self.shows(moment.t_s) {
            self.begin([moment.t_s, moment.at_mm]);
            self.plot.push(moment);
        }
    }

    fn begin(&mut self, at: [f64; 2]) {
        if !self.begun {
            self.begun = true;
            self.plot.begin(if self.window[0] > 0.0 { at } else { [0.0; 2] });
        }
    }

    /// The machine stands until a time.
    fn stand(&mut self, until_s: f64) {
        let from = self.at;
        if until_s - from[0] <= STEP_S {
            return;
        }
        let to = [until_s, from[1]];
        let rests = Push::default();
        for t_s in [from[0] + INSIDE_S, from[0] + STEP_S, until_s - INSIDE_S] {
            self.feel(t_s, rests);
            self.push(&moment([t_s, from[1]], 0.0, &State::default(), &rests, &self.jerk));
        }
        self.last.0 = until_s;
        self.stretch(from, to, Doing::Stand);
        self.at = to;
    }

    /// Plots what is done in a stretch, as far as it is in the window.
    fn stretch(&mut self, from: [f64; 2], to: [f64; 2], doing: Doing) {
        if from[0] < self.window[1] && to[0] > self.window[0] {
            self.begin(from);
            self.plot.doing(from, to, doing);
        }
    }

    fn follow(&mut self, made: &ExecutedMove<'_>) {
        let span = made.span;
        let [from_s, to_s] = [span.t0_s, span.t1_s].map(|t| made.t0_s + t);
        let from = self.at;
        let seen_s = from_s.max(self.window[0]);
        if seen_s < to_s && self.shows(seen_s) {
            self.plot.line([seen_s, from[1]], span.made.at.line);
        }
        self.ask(made, from_s + INSIDE_S, false);
        let first = (seen_s / STEP_S).floor() + 1.0;
        let last = (to_s - INSIDE_S).min(self.window[1]);
        let steps = (0u64..).map(|k| (first + k as f64) * STEP_S).take_while(|t| *t < last);
        steps.for_each(|t_s| self.ask(made, t_s, true));
        self.ask(made, to_s - INSIDE_S, false);
        let to = [to_s, from[1] + span.made.length_mm];
        self.stretch(from, to, span.made.kind.into());
        self.at = to;
    }

    /// Asks the plan; jerk only on the grid of time.
    fn ask(&mut self, made: &ExecutedMove<'_>, t_s: f64, on_grid: bool) {
        if !self.shows(t_s) {
            return;
        }
        let (span, state) = (made.span, made.plan.at(t_s - made.t0_s));
        let accel = accel(&state);
        if on_grid {
            self.remember(made, t_s - STEP_S);
            self.feel(t_s, accel);
        }
        let share = if state.move_index == span.index { state.share } else { 1.0 };
        let at = [t_s, self.at[1] + share * span.made.length_mm];
        let mut moment = moment(at, span.made.speed_mm_s, &state, &accel, &self.jerk);
        self.keep_degrees(&mut moment, span.made);
        self.push(&moment);
    }

    /// Degrees are drawn as they are where lengths are drawn in inches.
    fn keep_degrees(&self, moment: &mut Moment, made: &Move) {
        let mm = self.plot.unit.mm;
        for (rates, _) in moment.axes.iter_mut().zip(self.degrees).filter(|(_, degrees)| *degrees) {
            *rates = rates.map(|v| v * mm);
        }
        let turns = |k: usize| made.from.0[k] == made.to.0[k] || self.degrees[k];
        if (0..AXES).all(turns) {
            moment.path = moment.path.map(|v| v * mm);
            moment.programmed *= mm;
        }
    }

    /// Asks the acceleration before a window that begins inside a plan.
    fn remember(&mut self, made: &ExecutedMove<'_>, t_s: f64) {
        if t_s - self.last.0 > 0.5 * STEP_S && t_s > made.t0_s {
            self.last = (t_s, accel(&made.plan.at(t_s - made.t0_s)));
        }
    }

    /// The acceleration at a later time.
    fn feel(&mut self, t_s: f64, accel: Push) {
        let rate = |new: f64, old: f64| (new - old) / STEP_S;
        let last = self.last.1;
        self.jerk =
            Push { path: rate(accel.path, last.path), axes: accel.axes.zip(last.axes, rate) };
        self.last = (t_s, accel);
    }

    fn tool_path(&mut self, name: Option<&str>, tool: Option<&str>, t_s: f64) {
        let words = [name, tool].into_iter().flatten().filter(|w| !w.is_empty());
        let name = words.collect::<Vec<_>>().join(" · ");
        if !name.is_empty() && t_s <= self.window[1] {
            self.plot.toolpath([t_s, self.at[1]], name);
        }
    }
}

impl Sink for Curves {
    fn event(&mut self, event: &Event) {
        match event {
            Event::Start { units, .. } | Event::Units { units, .. } => {
                self.plot.unit = if *units == "mm" { Unit::MM } else { Unit::INCH };
            }
            Event::ToolPath { name, tool, t } => {
                self.tool_path(name.as_deref(), tool.as_deref(), *t);
            }
            Event::End(end) => self.stand(end.t),
            _ => {}
        }
    }

    fn looks_at_motion(&self) -> bool {
        false
    }

    fn made(&mut self, made: &ExecutedMove<'_>) {
        self.stand(made.t0_s + made.span.t0_s);
        self.follow(made);
    }
}

/// Acceleration along the path, in the measure of its speed, and of every axis.
fn accel(state: &State) -> Push {
    let dot = |a: &Axes, b: &Axes| a.0.iter().zip(&b.0).map(|(a, b)| a * b).sum::<f64>();
    let square = dot(&state.velocity, &state.velocity);
    let path = if square > STANDS_MM_S * STANDS_MM_S {
        dot(&state.acceleration, &state.velocity) / square * state.path_speed_mm_s
    } else {
        0.0
    };
    Push { path, axes: state.acceleration }
}

fn moment(at: [f64; 2], programmed: f64, state: &State, accel: &Push, jerk: &Push) -> Moment {
    let [x, y, z] = accel.axes.first3();
    let axis = |k: usize| -> Rates { [state.velocity.0[k], accel.axes.0[k], jerk.axes.0[k]] };
    Moment {
        t_s: at[0],
        at_mm: at[1],
        path: [state.path_speed_mm_s, accel.path, jerk.path],
        total_accel: x.hypot(y).hypot(z),
        programmed,
        axes: std::array::from_fn::<_, AXES, _>(axis),
    }
}
