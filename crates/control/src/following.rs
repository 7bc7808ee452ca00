//! A plan as it is followed: the machine learns it, time passes on the way, and what the machine tells is learnt.

use crate::drive::Heard;
use crate::station::Station;
use crate::turn::{Turn, link_lost};
use kerf_machine::{Ahead, Going};
use kerf_motion::Plan;
use kerf_program::Interpreter;
use kerf_sim::{Lift, Watched};

/// A way to let time pass that heeds the operator: also what he asked for before, or only what he asks for now.
pub(crate) type Ask<S> = fn(&mut S, f64, f64, Option<Going<'_>>) -> Option<(f64, Heard)>;

impl<I: Interpreter> Station<'_, I> {
    /// A plan, or another piece of it, is about to be followed.
    pub(crate) fn follows(&mut self, plan: &Plan, t0_s: f64) {
        let ahead = Ahead { plan, t0_s, from_s: self.world.now() };
        if !self.world.machine.draws() {
            self.drive.follows(&ahead);
            self.begins_anew();
        }
    }

    /// What is left of a plan at a moment is made by another.
    pub(crate) fn replans(&mut self, plan: &Plan, t0_s: f64, at_s: f64) {
        let ahead = Ahead { plan, t0_s, from_s: self.world.now() };
        if !self.world.machine.draws() {
            self.drive.replans(&ahead);
            self.begins_anew();
            self.world.tracked().learn_until(at_s);
        }
    }

    /// A machine that repeats tells what it told of the move under way by the plan that is followed now.
    fn begins_anew(&mut self) {
        if self.drive.repeats() {
            self.world.machine.forget();
        }
    }

    /// Lets time pass up to a moment, unless an input that stops the machine or the operator comes before. The moment of
    /// the input may be over.
    pub(crate) fn meet(
        &mut self,
        end_s: f64,
        watched: &[Watched],
        going: Option<Going<'_>>,
        ask: Ask<Self>,
    ) -> Option<(f64, Turn)> {
        let now_s = self.world.now();
        // What was told on the way to a moment that the operator interrupted still stops the machine.
        let mut looked_s = self.world.machine.told_s();
        loop {
            let machine = &self.world.machine;
            let halt = match going {
                Some(_) => machine.halted(looked_s, watched),
                None => machine.halted_at_rest(looked_s, watched),
            };
            let level_s = next_level_s(watched, looked_s, end_s);
            let until_s = halt.map_or(level_s.unwrap_or(end_s), |halt| halt.t_s);
            match ask(self, now_s, until_s.max(now_s), going) {
                Some((t_s, Heard::Input { number, on })) => {
                    self.world.tracked().learn(number, on, t_s);
                    looked_s = looked_s.max(t_s);
                }
                Some((t_s, Heard::Operator(request))) => {
                    return Some((t_s, Turn::Operator(request)));
                }
                None if self.drive.fault().is_some() => {
                    return Some((now_s, Turn::Input(link_lost(now_s))));
                }
                None => match (halt, level_s) {
                    (Some(halt), _) => return Some((halt.t_s, Turn::Input(halt))),
                    (None, Some(level_s)) => looked_s = level_s,
                    (None, None) => return None,
                },
            }
        }
    }

    /// A move of a plan is made: everything that happened on the way is known. Returns how far height control carried Z.
    pub(crate) fn move_made(&mut self, going: Going<'_>) -> Lift {
        let Going { plan, index, t0_s, .. } = going;
        let Some(span) = plan.span(index) else { return Lift::default() };
        let carried = if self.world.machine.draws() {
            self.world.machine.not_carried()
        } else {
            self.world.tracked().learn_until(t0_s + span.t1_s);
            self.world.driven.borrow_mut().made(&going)
        };
        self.world.machine.make(t0_s, plan, &span, &carried);
        carried.lift
    }
}

/// Returns the next moment, up to another, from which on a state that is watched stops the machine.
fn next_level_s(watched: &[Watched], from_s: f64, end_s: f64) -> Option<f64> {
    let levels = watched.iter().filter_map(|watch| watch.level_from_s);
    levels.filter(|s| *s > from_s && *s <= end_s).min_by(f64::total_cmp)
}
