//! Watches what has to hold at any time of any run.

use crate::simulated::path::Piece;
use kerf_machine::lines::Output;
use kerf_program::{Axes, Axis};
use kerf_trace::{Event, ExecutedMove, Sink};
use std::cell::Cell;
use std::collections::BTreeSet;
use std::f64::consts::{FRAC_1_SQRT_2, SQRT_2};

/// Looks at the plan of a move, beside its ends.
const LOOKS: u32 = 5;

/// Looks at its acceleration.
const RATES: u32 = 16;

/// So much coarser than a speed is an acceleration: on a smoothed path the plan finds it on a grid, within two
/// hundredths.
const RATE_HAIRS: f64 = 10.0;

/// No run of a case tells so much.
const MOST: usize = 20_000;

/// The process is dead.
pub struct Killed;

/// Counts down to the death of a process. Everything that a run does in the world passes it.
#[derive(Debug, Default)]
pub struct Doom(Cell<u64>);

/// Factor by which a stop on a smoothed path may brake harder than allowed.
const BRAKING: f64 = 1.05;

/// Fewer things happen between two looks at the operator.
const SOON: u64 = 50;

impl Doom {
    /// Dies with so many things done; 0 never.
    pub fn after(&self, count: u64) {
        self.0.set(count);
    }

    /// Tells whether it dies soon.
    pub const fn is_near(&self) -> bool {
        matches!(self.0.get(), 1..SOON)
    }

    /// One thing is done.
    pub fn tick(&self) {
        match self.0.get() {
            0 => {}
            1 => {
                self.0.set(0);
                std::panic::resume_unwind(Box::new(Killed));
            }
            left => self.0.set(left - 1),
        }
    }
}

/// Limits that a run has to keep.
#[derive(Clone, Copy, Debug)]
pub struct Allowed {
    /// Bounds of the machine frame, where there are any.
    pub bounds: Option<[Axes; 2]>,
    /// Speed of each axis, where it is known what they can do.
    pub axis_mm_s: Option<Axes>,
    /// Acceleration of each axis, likewise.
    pub axis_mm_s2: Option<Axes>,
    /// Share of a speed asked for that the operator allows: a plan slows down to a lesser one.
    pub feed: f64,
    /// Share by which rounding of the path may exceed it.
    pub hair: f64,
    /// Most distance between the end of a move and the beginning of the next, mm: where a smoothed path is left.
    pub jump_mm: f64,
    /// It is a job: the machine's states say which outputs may be on.
    pub job: bool,
    /// Z follows a sheet: its plan is not where it is.
    pub z_wanders: bool,
}

/// Watches one process.
pub struct Watch<'a> {
    pub doom: &'a Doom,
    pub allowed: Allowed,
    pub seen: Seen,
}

/// Record of one process.
#[derive(Debug, Default)]
pub struct Seen {
    /// Things that happened.
    pub events: Vec<Event>,
    /// The cuts.
    pub pieces: Vec<Piece>,
    /// Sum of all motion.
    pub way: Axes,
    /// End of the last move.
    pub at: Option<Axes>,
    /// Machine time of the last thing.
    pub t: f64,
    /// Outputs that are on.
    on: BTreeSet<u8>,
    intensity: u8,
    /// A stop input ended it.
    stopped: bool,
    /// Commands are only drawn.
    draws: bool,
    /// Letters of axes that moved by themselves.
    alone: BTreeSet<char>,
    /// Number of times that the machine stopped by itself because something is wrong with the cut.
    pub faults: u32,
}

impl Seen {
    /// Checks that the outputs which must be off are.
    #[track_caller]
    fn off(&self, outputs: &[Output], when: &str) {
        for output in outputs {
            let number = output.number();
            assert!(!self.on.contains(&number), "{} is on: {when} at {}", output.name(), self.t);
        }
        assert_eq!(self.intensity, 0, "intensity: {when} at {}", self.t);
    }

    fn entered(&mut self, state: &str) {
        use Output::{Cut1, Cut2, Cut3, Router};
        match state {
            "paused" => self.off(&[Cut1, Cut2, Cut3, Router], "paused"),
            "estop" | "alarm" | "idle" => self.off(Output::ALL, state),
            _ => {}
        }
    }
}

impl Sink for Watch<'_> {
    fn event(&mut self, event: &Event) {
        self.doom.tick();
        let seen = &mut self.seen;
        match event {
            Event::Output { n, on, t, .. } => {
                (*on).then(|| seen.on.insert(*n));
                (!on).then(|| seen.on.remove(n));
                seen.passes(*t);
            }
            Event::Intensity { value, t, .. } => {
                seen.intensity = *value;
                seen.passes(*t);
            }
            Event::State { state, why, .. } if self.allowed.job => {
                let fault =
                    &**state == "paused" && !why.is_empty() && !why.starts_with("pause mark");
                seen.faults += u32::from(fault);
                seen.entered(state);
            }
            Event::Independent { axis, .. } => {
                seen.alone.insert(*axis);
            }
            Event::Start { mode, .. } | Event::Mode { mode, .. } => seen.draws = *mode == "preview",
            Event::Stop { by: "stop", .. } if !self.allowed.job => {
                seen.stopped = true;
            }
            Event::End(end) => {
                assert!(end.t >= 0.0 && end.t.is_finite(), "{}", end.t);
                if self.allowed.job {
                    seen.off(Output::ALL, &format!("the end, {:?}", end.status));
                }
                let spins = seen.on.contains(&1) || seen.on.contains(&2);
                assert!(!(seen.stopped && spins), "a spindle after a stop input");
                assert!(!seen.on.contains(&4) || self.allowed.job, "motion output at the end");
            }
            _ => {}
        }
        if !matches!(event, Event::Height { .. } | Event::Intensity { .. }) {
            seen.events.push(event.clone());
        }
        assert!(seen.events.len() < MOST, "it goes on for ever: {event:?}");
    }

    fn made(&mut self, made: &ExecutedMove<'_>) {
        if self.seen.draws {
            return;
        }
        let it = made.span.made;
        let joins = |at: Axes| {
            let apart = at.minus(it.from);
            let axes = Axis::ALL.into_iter().filter(|axis| {
                // What an axis does beside the plan.
                let wanders = self.allowed.z_wanders && *axis == Axis::Z;
                !(wanders || self.seen.alone.contains(&axis.letter()))
            });
            axes.map(|axis| apart[axis].abs()).fold(0.0, f64::max) < self.allowed.jump_mm
        };
        assert!(self.seen.at.is_none_or(joins), "a jump from {:?} to {:?}", self.seen.at, it.from);
        self.seen.way = self.seen.way.plus(it.to.minus(it.from));
        self.seen.at = Some(it.to);
        self.seen.t = made.t0_s + made.span.t1_s;
        self.accelerations(made);
        for look in 0..=LOOKS {
            let share = f64::from(look) / f64::from(LOOKS);
            let t_s = made.span.t0_s + (made.span.t1_s - made.span.t0_s) * share;
            let state = made.plan.at(t_s);
            self.allowed.place(state.position);
            // At its end the next one may have begun.
            let top_mm_s = self.allowed.feed * made.plan.moves()[state.move_index].speed_mm_s;
            self.allowed.speed(&state.velocity, state.path_speed_mm_s, top_mm_s);
        }
        self.allowed.place(it.to);
        self.seen.pieces.extend(Piece::of(made));
    }
}

impl Watch<'_> {
    /// Checks that no axis gains more speed from one look to the next than it can.
    fn accelerations(&self, made: &ExecutedMove<'_>) {
        let Some(most) = self.allowed.axis_mm_s2 else { return };
        let [from_s, to_s] = [made.span.t0_s, made.span.t1_s];
        let step_s = (to_s - from_s) / f64::from(RATES);
        if step_s < 1e-4 {
            return;
        }
        let it = made.span.made;
        let curved = it.derivative(0.0) != it.derivative(1.0);
        let share = match (it.arc(), curved) {
            // Round a bend the way in and the way along may both be at their highest.
            (Some(_), _) => SQRT_2,
            // On a smoothed curve the way along may have all of it in a direction in between.
            (None, true) => 1.0 + FRAC_1_SQRT_2,
            (None, false) => 1.0,
        };
        // A stop is found on another grid than the plan, and may brake a little harder.
        let stops = !it.is_last_part && self.allowed.jump_mm > 1e-3;
        let share = if stops { share * BRAKING } else { share };
        // Inside the move: at its ends another may say how fast.
        let moment = |look: u32| from_s + (f64::from(look) + 0.5) * step_s;
        let velocity = |look: u32| made.plan.at(moment(look)).velocity;
        for look in 0..RATES - 1 {
            let gained = velocity(look + 1).minus(velocity(look));
            for axis in Axis::ALL {
                let (is, may) = (gained[axis].abs() / step_s, share * most[axis]);
                assert!(
                    is <= may * (1.0 + RATE_HAIRS * self.allowed.hair) + 1e-3,
                    "{axis:?}: {is} mm/s2 where {may} are allowed, {:?}",
                    made.span.made
                );
            }
        }
    }
}

impl Seen {
    fn passes(&mut self, t: f64) {
        self.t = self.t.max(t);
    }
}

impl Allowed {
    fn place(&self, at: Axes) {
        let Some([low, high]) = self.bounds else { return };
        for axis in [Axis::X, Axis::Y, Axis::Z] {
            let inside = at[axis] >= low[axis] - 1e-6 && at[axis] <= high[axis] + 1e-6;
            assert!(inside, "{axis:?} at {} is outside the limits", at[axis]);
        }
    }

    fn speed(&self, velocity: &Axes, along: f64, top: f64) {
        assert!(along <= top * (1.0 + self.hair) + 1e-6, "{along} mm/s where {top} are allowed");
        let Some(most) = self.axis_mm_s else { return };
        for axis in Axis::ALL {
            let (is, may) = (velocity[axis].abs(), most[axis]);
            assert!(
                is <= may * (1.0 + self.hair) + 1e-6,
                "{axis:?}: {is} mm/s where {may} are allowed"
            );
        }
    }
}
