//! A piece of plan as a machine makes it that executes plans itself, with the way to rest from any moment of it.
//!
//! ```text
//!  speed │ ──────────────────────╮
//!        │     ╲                  ╲  the plan
//!        │      ╲ rest from t      ╲
//!        └──────┴───────────────────┴──► time
//!               t
//! ```

use crate::Move;
use crate::chain::{Clocked, plain_clock};
use crate::plan::{Law, Plan};
use crate::state::State;
use crate::steps::{Step, Stepper};
use crate::stop::Braked;
use kerf_program::{Axes, MoveKind};

/// A speed this close to that of a ramp's end is a stand, as a share of it.
const STAND: f64 = 1.001;
/// A speed below this is none, mm/s.
const STILL_MM_S: f64 = 1e-6;
/// So long before a stand a machine is slower than this, seconds and mm/s: a plan that is left in motion ends faster.
const NEARLY_S: f64 = 1e-5;
const SLOW_MM_S: f64 = 0.2;

/// A piece of plan that is made.
#[derive(Clone, Debug, PartialEq)]
pub struct Leg(Plan);

/// The way to rest: where every axis is, from the moment at which it begins.
#[derive(Clone, Debug, PartialEq)]
pub struct Rest {
    law: RestLaw,
    /// The moment at which the machine stands, seconds of the plan.
    pub end_s: f64,
    /// It stands there; otherwise the plan that is known ends before.
    pub stands: bool,
}

#[derive(Clone, Debug, PartialEq)]
enum RestLaw {
    Ramped(Plan),
    Clocked(Box<Clocked>),
}

impl Leg {
    /// A piece of plan.
    pub fn new(plan: Plan) -> Self {
        Self(plan.by(plain_clock()))
    }

    /// Place of every axis at a time of the plan, seconds.
    pub fn at(&self, t_s: f64) -> Axes {
        self.0.at(t_s).position
    }

    /// Speed at a time of the plan, as a share of what its move asks for; nothing in a jog.
    pub fn pace(&self, t_s: f64) -> Option<f64> {
        let state = self.0.at(t_s);
        let made = self.0.moves().get(state.move_index)?;
        (made.kind != MoveKind::Jog).then(|| state.path_speed_mm_s / made.top_mm_s())
    }

    /// The move under way at a time of the plan, seconds, and place and speed of every axis.
    pub fn under_way(&self, t_s: f64) -> Option<(&Move, State)> {
        let state = self.0.at(t_s);
        Some((self.0.moves().get(state.move_index)?, state))
    }

    /// The steps of the motors from one time of the plan to another, in order of time.
    pub fn steps(&self, stepper: &mut Stepper, [from_s, to_s]: [f64; 2]) -> Vec<Step> {
        stepper.follow(from_s, to_s, |t_s| self.at(t_s))
    }

    /// The times at which it begins and ends, seconds of the plan.
    pub fn span_s(&self) -> [f64; 2] {
        [self.0.span_s(0).0, self.0.duration_s()]
    }

    /// The time at which a move of it begins, seconds of the plan.
    pub fn begins_s(&self, index: usize) -> f64 {
        self.0.span_s(index).0
    }

    /// Returns `true` if the machine stands at its end.
    pub fn rests(&self) -> bool {
        stands(&self.0)
    }

    /// The way to rest from a time of the plan on, as steeply as accelerations allow; nothing for a plan without moves.
    pub fn rest(&self, t_s: f64) -> Option<Rest> {
        let stop = self.0.brake(t_s).or_else(|| self.0.stop(t_s, true))?;
        let end_s = stop.end_s;
        if let Braked::Clocked(slowed) = stop.law {
            let v = crate::splice::speed(&slowed.at(end_s));
            return Some(Rest { law: RestLaw::Clocked(slowed), end_s, stands: v < STILL_MM_S });
        }
        let (made, _) = self.0.clone().cut(&stop);
        Some(Rest { stands: stands(&made), law: RestLaw::Ramped(made), end_s })
    }
}

impl Rest {
    /// Place of every axis at a time of the plan, seconds.
    pub fn at(&self, t_s: f64) -> Axes {
        self.state(t_s).position
    }

    /// Speed of all axes together at a time of the plan, mm/s.
    pub fn speed_mm_s(&self, t_s: f64) -> f64 {
        crate::splice::speed(&self.state(t_s))
    }

    fn state(&self, t_s: f64) -> State {
        match &self.law {
            RestLaw::Ramped(plan) => plan.at(t_s),
            RestLaw::Clocked(law) => law.at(t_s),
        }
    }
}

/// A plan ends at a stand: at rest, or at the speed of a ramp's end.
fn stands(plan: &Plan) -> bool {
    match &plan.law {
        Law::Ramped(_) => {
            let last = plan.moves().len().checked_sub(1).and_then(|last| plan.span(last));
            last.is_none_or(|last| last.v_exit <= STAND * last.made.ramp_mm_s)
        }
        _ => crate::splice::speed(&plan.at(plan.duration_s() - NEARLY_S)) < SLOW_MM_S,
    }
}
