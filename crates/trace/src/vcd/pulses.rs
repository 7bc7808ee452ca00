//! From steps to what the step and direction outputs do (Profiler reference, "Microstepping Drive
//! Parameters", figure 7).
//!
//! ```text
//!        ┌───────────────            direction
//!  ──────┘
//!         <─ delay ─>┌──pulse──┐     step
//!  ──────────────────┘         └──
//! ```
//!
//! With a direction delay of 0 direction and step change at once. The time of a step is the one of
//! the plan; after a change of direction it is later by the output delay and the direction delay.

use kerf_machine::Configuration;
use kerf_machine::settings::motors::{Direction, MOTORS, Motor};
use kerf_motion::Step;
use kerf_program::Axis;

/// Output of a motor that has an edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Line {
    /// The direction output.
    Direction,
    /// The step output.
    Step,
}

/// An output of a motor changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Edge {
    /// Time of the edge, nanoseconds.
    pub t_ns: u64,
    /// Whose.
    pub motor: Motor,
    /// Which of its two outputs.
    pub line: Line,
    /// Its level from then on.
    pub high: bool,
}

/// The outputs of the motors.
#[derive(Clone, Debug)]
pub struct Pulses {
    /// Which axis drives each motor.
    axes: [Option<Axis>; MOTORS],
    /// The motor that moves while the others of its axis stand.
    alone: Option<Motor>,
    /// Direction output for a positive move.
    forward: [bool; MOTORS],
    /// Direction outputs now; unknown before the first step.
    now: [Option<bool>; MOTORS],
    /// The step output is low again, and may rise.
    free_ns: [u64; MOTORS],
    output_delay_ns: u64,
    dir_delay_ns: u64,
    pulse_ns: u64,
}

impl Pulses {
    /// The motors of a machine.
    pub fn new(machine: &Configuration) -> Self {
        let axes = Motor::ALL.map(|motor| machine.motors.axis_of(motor));
        let forward = axes.map(|axis| {
            let direction = axis.map(|axis| machine.motors.direction[axis.index()]);
            direction != Some(Direction::Backwards)
        });
        Self {
            axes,
            alone: None,
            forward,
            now: [None; MOTORS],
            free_ns: [0; MOTORS],
            output_delay_ns: machine.simulated.output_delay_ns.into(),
            dir_delay_ns: machine.motors.dir_delay_ns.into(),
            pulse_ns: machine.step_pulse_ns().into(),
        }
    }

    /// From here on only this motor of its axis moves; `None` for all.
    pub const fn move_alone(&mut self, motor: Option<Motor>) {
        self.alone = motor;
    }

    /// The edges that a step of an axis makes: of every motor of the axis that moves, at the same time.
    pub fn edges(&mut self, step: &Step) -> Vec<Edge> {
        let of = |motor: Motor| self.axes[motor.index()].filter(|axis| axis.index() == step.axis);
        let alone = self.alone.filter(|motor| of(*motor).is_some());
        let driven = |motor: &Motor| of(*motor).is_some() && alone.is_none_or(|it| it == *motor);
        let motors: Vec<Motor> = Motor::ALL.into_iter().filter(driven).collect();
        motors.into_iter().flat_map(|motor| self.edges_of(motor, step)).collect()
    }

    fn edges_of(&mut self, motor: Motor, step: &Step) -> Vec<Edge> {
        let i = motor.index();
        let mut t_ns = ((step.t_s * 1e9).round().max(0.0) as u64).max(self.free_ns[i]);
        let mut edges = Vec::with_capacity(3);
        let wanted = self.forward[i] == step.forward;
        if self.now[i].replace(wanted) != Some(wanted) {
            edges.push(Edge { t_ns, motor, line: Line::Direction, high: wanted });
            if self.dir_delay_ns > 0 {
                t_ns = t_ns.saturating_add(self.output_delay_ns + self.dir_delay_ns);
            }
        }
        // Nanoseconds are counted for five centuries; what comes later comes at their end.
        let falls_ns = t_ns.saturating_add(self.pulse_ns);
        edges.push(Edge { t_ns, motor, line: Line::Step, high: true });
        edges.push(Edge { t_ns: falls_ns, motor, line: Line::Step, high: false });
        self.free_ns[i] = falls_ns.saturating_add(self.output_delay_ns);
        edges
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, non_snake_case)] // rows and their variants
mod tests {
    use super::*;
    use kerf_machine::profile::profile;
    use kerf_machine::settings::motors::FreeMotor;
    use kerf_motion::Stepper;
    use kerf_program::Axes;

    fn sim(edit: impl FnOnce(&mut Configuration)) -> Configuration {
        let mut machine = profile("sim").unwrap().configuration().unwrap();
        edit(&mut machine);
        machine
    }

    /// Edges of a motion of the axes over a second.
    fn edges(machine: &Configuration, place: impl Fn(f64) -> Axes) -> Vec<Edge> {
        let mut stepper = Stepper::new(machine.program.resolution.steps_per_unit, place(0.0));
        let mut pulses = Pulses::new(machine);
        let steps = stepper.follow(0.0, 1.0, place);
        steps.iter().flat_map(|step| pulses.edges(step)).collect()
    }

    #[test]
    fn a_step_at_the_end_of_time_is_one() {
        let mut pulses = Pulses::new(&sim(|machine| machine.motors.dir_delay_ns = 5000));
        let step = |forward| Step { t_s: 1e12, axis: 0, forward };
        for forward in [true, false] {
            let edges = pulses.edges(&step(forward));
            assert_eq!(edges.len(), 3, "a direction, up, down: {edges:?}");
            assert!(edges.iter().all(|edge| edge.t_ns == u64::MAX));
        }
    }

    fn rising(edges: &[Edge], motor: Motor) -> Vec<u64> {
        let rises = |e: &&Edge| e.motor == motor && e.line == Line::Step && e.high;
        edges.iter().filter(rises).map(|e| e.t_ns).collect()
    }

    /// 1 mm there and back.
    fn there_and_back(t_s: f64) -> Axes {
        Axes::xyz(if t_s < 0.5 { 2.0 * t_s } else { 2.0 - 2.0 * t_s }, 0.0, 0.0)
    }

    fn directions(machine: &Configuration) -> Vec<(bool, usize)> {
        let mut found: Vec<(bool, usize)> = Vec::new();
        for edge in edges(machine, there_and_back) {
            match (edge.line, edge.high, found.last_mut()) {
                (Line::Direction, high, _) => found.push((high, 0)),
                (Line::Step, true, Some((_, count))) => *count += 1,
                _ => {}
            }
        }
        found
    }

    #[test]
    fn pro_axes_stepdir() {
        assert_eq!(directions(&sim(|_| ())), [(true, 250), (false, 250)]);
    }

    #[test]
    fn pro_motors_dir() {
        let machine = sim(|m| m.motors.direction[0] = Direction::Backwards);
        assert_eq!(directions(&machine), [(false, 250), (true, 250)]);
    }

    /// Time from a change of direction to the step behind it.
    fn setup_ns(dir_delay_ns: u32) -> Vec<u64> {
        let all = edges(&sim(|m| m.motors.dir_delay_ns = dir_delay_ns), there_and_back);
        let pairs = all.windows(2).filter(|pair| pair[0].line == Line::Direction);
        pairs.map(|pair| pair[1].t_ns - pair[0].t_ns).collect()
    }

    #[test]
    fn pro_axes_dirdelay() {
        assert_eq!(setup_ns(0), [0, 0]);
        assert_eq!(setup_ns(5000), [6000, 6000]);
    }

    fn widths_ns(step_delay_ns: u32) -> Vec<u64> {
        let all = edges(&sim(|m| m.motors.step_delay_ns = step_delay_ns), there_and_back);
        let pulses = all.windows(2).filter(|pair| pair[0].line == Line::Step && pair[0].high);
        pulses.map(|pair| pair[1].t_ns - pair[0].t_ns).collect()
    }

    #[test]
    fn pro_axes_stepdelay() {
        assert!(widths_ns(3000).iter().all(|width| *width == 4000));
    }

    #[test]
    fn pro_axes_pc_delay() {
        assert!(widths_ns(0).iter().all(|width| *width == 1000));
        assert_eq!(sim(|_| ()).simulated.output_delay_ns, 1000);
    }

    #[test]
    fn pro_axes_steprate() {
        // 200 mm/s at 250 steps/mm.
        let times = rising(&edges(&sim(|_| ()), |t_s| Axes::xyz(200.0 * t_s, 0.0, 0.0)), Motor::X);
        assert_eq!(times.len(), 50_000);
        assert!(times.windows(2).all(|pair| (pair[1] - pair[0]).abs_diff(20_000) <= 2));
    }

    #[test]
    fn pro_axes_two_motors() {
        let machine = sim(|m| m.motors.x2 = Some(FreeMotor::Q));
        let all = edges(&machine, there_and_back);
        assert_eq!(rising(&all, Motor::X), rising(&all, Motor::Q));
        assert_eq!(rising(&all, Motor::Q).len(), 500);
    }

    #[test]
    fn pro_motors_x2y2() {
        let machine =
            sim(|m| (m.motors.x2, m.motors.y2) = (Some(FreeMotor::Q), Some(FreeMotor::R)));
        let all = edges(&machine, |t_s| Axes::xyz(t_s, (6.0 * t_s).sin(), 0.0));
        assert_eq!(rising(&all, Motor::X), rising(&all, Motor::Q));
        assert_eq!(rising(&all, Motor::Y), rising(&all, Motor::R));
    }

    #[test]
    fn pro_axes_steps_xyz() {
        let machine = sim(|_| ());
        let per_unit = machine.program.resolution.steps_per_unit;
        let made = |to_mm: f64| {
            let mut stepper = Stepper::new(per_unit, Axes::default());
            stepper.follow(0.0, 1.0, |t_s| Axes::xyz(to_mm * t_s, 0.0, 0.0));
            stepper.made()[0]
        };
        assert_eq!(made(10.003), 2501);
        let mut stepper = Stepper::new(per_unit, Axes::default());
        for i in 0..1000 {
            stepper.follow(0.0, 1.0, |t_s| Axes::xyz(0.003 * (f64::from(i) + t_s), 0.0, 0.0));
        }
        assert_eq!(stepper.made()[0], 750);
    }

    #[test]
    fn pro_axes_steps_w() {
        let machine = sim(|_| ());
        let turn = |t_s: f64| Axes([0.0, 0.0, 0.0, 0.0, 0.0, 90.0 * t_s]);
        assert_eq!(rising(&edges(&machine, turn), Motor::W).len(), 9000);
    }

    #[test]
    fn pro_axes_axes__no_w_without_a_motor() {
        let machine = sim(|m| m.motors.w = None);
        let turn = |t_s: f64| Axes([0.0, 0.0, 0.0, 0.0, 0.0, 90.0 * t_s]);
        assert!(edges(&machine, turn).is_empty());
    }

    #[test]
    fn pro_motors_assign__steps() {
        let machine = sim(|m| (m.motors.w, m.motors.y2) = (Some(FreeMotor::R), Some(FreeMotor::W)));
        let all = edges(&machine, |t_s| Axes([0.0, t_s, 0.0, 0.0, 0.0, 10.0 * t_s]));
        assert_eq!(rising(&all, Motor::Y), rising(&all, Motor::W));
        assert_eq!((rising(&all, Motor::W).len(), rising(&all, Motor::R).len()), (250, 1000));
    }
}
