//! Homing of the axes of a board, search by search: each motor is stopped by its own switch, in the board.
//!
//! ```text
//!  Look ─► (Leave) ─► Fast ─► Back ─► Slow ─► Go ─► Correct … ─► zero, next axis
//!           one is on   each motor stops at its own switch   motors that stopped elsewhere, alone
//! ```

use kerf_driver_klipper::board::{Ended, Home};
use kerf_machine::Configuration;
use kerf_machine::homing::soft_bounds;
use kerf_machine::settings::homing::HomeEnd;
use kerf_program::Axis;
use std::collections::VecDeque;

/// The order in which axes are homed: the tool first leaves the work.
const ORDER: [Axis; 6] = [Axis::Z, Axis::A, Axis::X, Axis::Y, Axis::B, Axis::C];
/// Greatest way of a search, as a multiple of the axis' length.
const MARGIN: f64 = 1.1;
/// Shortest and longest time between two looks at a switch, seconds. In between it is half the time of a step.
const LOOKS_S: [f64; 2] = [25e-6, 1e-3];

/// An axis that is homed on a board.
#[derive(Clone, Debug, PartialEq)]
pub struct AxisHome {
    /// The axis.
    pub axis: Axis,
    /// As people call it.
    pub name: &'static str,
    /// Its motors that have a switch, each with the place of that among the switches.
    pub motors: Vec<(usize, usize)>,
    /// Motors that are homed alone afterwards, one after the other.
    separate: bool,
    /// The direction of the switch, 1 or −1.
    toward: f64,
    /// Greatest way of a search, mm or degrees.
    most: f64,
    /// Speeds of the search and of finding the edge, and the highest one, mm/s or degrees/s.
    fast: f64,
    slow: f64,
    top: f64,
    /// Way from the edge to home, mm or degrees.
    off: f64,
    per_unit: f64,
}

impl AxisHome {
    /// The axes of a machine whose motors have these switches, in the order in which they are homed.
    pub fn all(machine: &Configuration, motors: &[(Axis, Option<usize>)]) -> Vec<Self> {
        let of_axis = |axis: &Axis| Self::of(machine, *axis, motors);
        ORDER.iter().filter_map(of_axis).collect()
    }

    fn of(machine: &Configuration, axis: Axis, motors: &[(Axis, Option<usize>)]) -> Option<Self> {
        let switch = machine.homing.of(axis);
        let own = motors.iter().enumerate().filter(|(_, (turns, _))| *turns == axis);
        let motors: Vec<_> = own.filter_map(|(n, (_, home))| home.map(|home| (n, home))).collect();
        if !switch.fitted || motors.is_empty() {
            return None;
        }
        let limits = &machine.program.limits;
        let length = match soft_bounds(machine, axis) {
            Some((low, high)) => high - low,
            None => limits.high[axis] - limits.low[axis],
        };
        let toward = if switch.end == HomeEnd::High { 1.0 } else { -1.0 };
        let one_switch = motors.iter().all(|(_, home)| *home == motors[0].1);
        Some(Self {
            axis,
            name: machine.motors.axis_name(axis),
            separate: one_switch
                && motors.len() > 1
                && match axis {
                    Axis::X => machine.homing.separate_x,
                    Axis::Y => machine.homing.separate_y,
                    _ => false,
                },
            motors,
            toward,
            most: MARGIN * length,
            fast: switch.fast,
            slow: switch.slow,
            top: machine.program.axis_dynamics().speed_mm_s[axis],
            off: -toward * switch.off,
            per_unit: machine.program.resolution.steps_per_unit[axis],
        })
    }

    /// Switches of some of its motors, each with those that it stops.
    fn switches(&self, moving: &[usize], opens: bool, speed: f64) -> Vec<Home> {
        let look_s = (0.5 / (speed * self.per_unit).abs()).clamp(LOOKS_S[0], LOOKS_S[1]);
        let mut homes: Vec<Home> = Vec::new();
        for (motor, switch) in self.motors.iter().filter(|(motor, _)| moving.contains(motor)) {
            match homes.iter_mut().find(|home| home.switch == *switch) {
                Some(home) => home.motors.push(*motor),
                None => {
                    homes.push(Home { switch: *switch, motors: vec![*motor], opens, look_s });
                }
            }
        }
        homes
    }
}

/// A thing to be done next.
#[derive(Clone, Debug, PartialEq)]
pub enum Act {
    /// The states of these switches are asked for.
    Look(Vec<usize>),
    /// Motors of an axis move by a way, until their switches stop them.
    Move {
        /// The axis.
        axis: Axis,
        /// Way, mm or degrees.
        by: f64,
        /// Speed, mm/s or degrees/s.
        speed: f64,
        /// The motors that move.
        motors: Vec<usize>,
        /// Switches that stop them.
        homes: Vec<Home>,
    },
    /// An axis stands at home.
    Zero(Axis),
    /// All axes are homed.
    Done,
    /// Nothing moves on, for this reason.
    Fails(String),
}

/// The end of a motion.
#[derive(Clone, Debug, PartialEq)]
pub struct Came {
    /// The reason.
    pub why: Ended,
    /// Counts of the motors.
    pub counts: Vec<i64>,
    /// Switches that stopped motors, each with the counts of all motors when it was first seen so.
    pub edges: Vec<(usize, Vec<i64>)>,
}

/// A search of a round, or what lies around it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Step {
    Look,
    Leave,
    Fast,
    Back,
    Slow,
    /// All motors go home by the way of the first.
    Go,
    /// The motor at this place goes the rest of its own way.
    Correct(usize),
}

/// Homing under way.
#[derive(Clone, Debug)]
pub struct Homing {
    axes: VecDeque<AxisHome>,
    /// Motors of the rounds to come of the axis in front, the one under way first.
    rounds: VecDeque<Vec<usize>>,
    step: Step,
    /// Counts at home of the motors of the round.
    targets: Vec<i64>,
}

impl Homing {
    /// Homes these axes, one after the other.
    pub fn new(axes: Vec<AxisHome>) -> Self {
        let (axes, rounds) = (VecDeque::from(axes), VecDeque::new());
        Self { axes, rounds, step: Step::Look, targets: Vec::new() }
    }

    /// Begins with the next axis, or the next round of one.
    pub fn begin(&mut self) -> Act {
        let Some(home) = self.axes.front() else { return Act::Done };
        if self.rounds.is_empty() {
            let all: Vec<usize> = home.motors.iter().map(|(motor, _)| *motor).collect();
            let alone = all.iter().filter(|_| home.separate).map(|motor| vec![*motor]);
            self.rounds = [all.clone()].into_iter().chain(alone).collect();
        }
        self.step = Step::Look;
        let moving = self.rounds.front().cloned().unwrap_or_default();
        Act::Look(home.switches(&moving, false, home.fast).iter().map(|it| it.switch).collect())
    }

    /// The switches were looked at: goes on with one that is on, or with none.
    pub fn looked(&mut self, is_on: bool) -> Act {
        self.search(if is_on { Step::Leave } else { Step::Fast })
    }

    /// A motion has ended.
    pub fn ended(&mut self, came: &Came) -> Act {
        let Some(home) = self.axes.front() else { return Act::Done };
        let seeks = matches!(self.step, Step::Leave | Step::Fast | Step::Back | Step::Slow);
        let fits = came.why == if seeks { Ended::Touched } else { Ended::Rested };
        if !fits {
            return Act::Fails(self.missing(home, came));
        }
        match self.step {
            Step::Look | Step::Leave => self.search(Step::Fast),
            Step::Fast => self.search(Step::Back),
            Step::Back if home.slow > 0.0 => self.search(Step::Slow),
            Step::Back | Step::Slow => self.goes_home(came),
            Step::Go => self.corrects(0, came),
            Step::Correct(n) => self.corrects(n + 1, came),
        }
    }

    /// The axis in front has another zero now: goes on with what follows.
    pub fn zeroed(&mut self) -> Act {
        self.rounds.pop_front();
        if self.rounds.is_empty() {
            self.axes.pop_front();
        }
        self.begin()
    }

    fn search(&mut self, step: Step) -> Act {
        self.step = step;
        let Some(home) = self.axes.front() else { return Act::Done };
        let (speed, opens) = match step {
            Step::Slow => (home.slow * home.toward, false),
            Step::Fast => (home.fast * home.toward, false),
            _ => (-home.fast * home.toward, true),
        };
        let motors = self.rounds.front().cloned().unwrap_or_default();
        let homes = home.switches(&motors, opens, speed);
        let by = speed.signum() * home.most;
        Act::Move { axis: home.axis, by, speed: speed.abs(), motors, homes }
    }

    /// The edges are known: home lies off them, for each motor off its own.
    fn goes_home(&mut self, came: &Came) -> Act {
        let (Some(home), Some(motors)) = (self.axes.front(), self.rounds.front().cloned()) else {
            return Act::Done;
        };
        let edge = |motor: &usize| {
            let (_, switch) = home.motors.iter().find(|(other, _)| other == motor)?;
            let (_, counts) = came.edges.iter().find(|(other, _)| other == switch)?;
            counts.get(*motor).copied()
        };
        let Some(edges) = motors.iter().map(edge).collect::<Option<Vec<i64>>>() else {
            return Act::Fails(self.missing(home, came));
        };
        let off = (home.off * home.per_unit).round() as i64;
        self.targets = edges.into_iter().map(|edge| edge + off).collect();
        self.step = Step::Go;
        self.go(0, motors, came)
    }

    /// The motors from a place in the round on go the rest of their ways, one after the other.
    fn corrects(&mut self, from: usize, came: &Came) -> Act {
        let Some(home) = self.axes.front() else { return Act::Done };
        let motors = self.rounds.front().cloned().unwrap_or_default();
        let is_off = |n: &usize| came.counts.get(motors[*n]) != self.targets.get(*n);
        match (from..motors.len()).find(is_off) {
            Some(n) => {
                self.step = Step::Correct(n);
                self.go(n, vec![motors[n]], came)
            }
            None if (0..motors.len()).any(|n| is_off(&n)) => {
                Act::Fails(format!("{} stands beside its home: it was late", home.name))
            }
            None => Act::Zero(home.axis),
        }
    }

    /// Motors go by the way that brings the one at a place in the round home.
    fn go(&self, n: usize, motors: Vec<usize>, came: &Came) -> Act {
        let Some(home) = self.axes.front() else { return Act::Done };
        let count = motors.first().and_then(|motor| came.counts.get(*motor));
        let way = self.targets.get(n).zip(count).map_or(0, |(target, count)| target - count);
        let by = way as f64 / home.per_unit;
        Act::Move { axis: home.axis, by, speed: home.top, motors, homes: Vec::new() }
    }

    fn missing(&self, home: &AxisHome, came: &Came) -> String {
        let stays_on = matches!(self.step, Step::Leave | Step::Back);
        let alone = self.rounds.front().filter(|round| round.len() < home.motors.len());
        let motor = alone.and_then(|round| round.first());
        let motor = motor.map_or(String::new(), |motor| format!(" with motor {} alone", motor + 1));
        let rest = match came.why {
            Ended::Rested if stays_on => ": its switch stays on",
            Ended::Rested => "",
            _ => ": it was stopped",
        };
        format!("{} home not found{motor}{rest}", home.name)
    }
}
