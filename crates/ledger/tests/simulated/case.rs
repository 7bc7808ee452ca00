//! One case: what is run on which machine, and what happens to it.

use crate::simulated::dice::Dice;
use crate::simulated::watch::Allowed;
use crate::simulated::{FIRST_WIDER, jobs, programs};
use kerf_control::OperatorRequest;
use kerf_journal::{RunOptions, Started, Work};
use kerf_machine::Configuration;
use kerf_machine::lines::Input;
use kerf_model::Change;
use kerf_program::job::{CutDepth, Job, Plunge};
use kerf_program::{Axes, Dynamics, RampModel, Settings};
use kerf_sim::Sheet;
use std::fmt;
use std::sync::Arc;

/// Sets the dice of what was thought of later apart.
const VARIES: u64 = 0x5eed_0002;

/// The same of what was thought of after that.
const GIVES_UP: u64 = 0x5eed_0003;

/// The same of what came last.
const WIDER: u64 = 0x5eed_0004;

/// Program or job that is run.
#[derive(Clone, Debug)]
pub enum What {
    Part { name: &'static str, text: String },
    Job(Box<Job>, Box<Configuration>),
}

/// A case.
#[derive(Clone, Debug)]
pub struct Case {
    pub seed: u64,
    pub what: What,
    /// Settings of the session.
    pub settings: Settings,
    /// Changes of the inputs, by the share of the time that the run takes when nothing happens.
    pub inputs: Vec<(u8, f64, bool)>,
    pub requests: Vec<(f64, OperatorRequest)>,
    /// The share of all that a run does after which its process dies, one by one.
    pub kills: Vec<f64>,
    /// Somebody moved the machine by hand, and told where it is now.
    pub pushed: Vec<Axes>,
    pub sheet: Option<Sheet>,
    /// Wall clock at its start.
    pub started: Started,
    /// Numbers of the questions after a stop that are answered with Quit, counted from the first; then it is taken up
    /// again.
    pub gives_up: Vec<u32>,
}

impl Case {
    pub fn of(seed: u64) -> Self {
        let mut dice = Dice::new(seed);
        let (what, settings) = match dice.below(5) {
            0 | 1 => (part("a.sbp", programs::sbp(&mut dice)), settings(&mut dice)),
            2 => (part("a.nc", programs::gcode(&mut dice)), settings(&mut dice)),
            _ => {
                let machine = jobs::machine(&mut dice);
                let job = jobs::random(&mut dice);
                (What::Job(Box::new(job), Box::new(machine)), Settings::default())
            }
        };
        let mut case = Self {
            seed,
            what,
            settings,
            inputs: Vec::new(),
            requests: Vec::new(),
            kills: Vec::new(),
            pushed: Vec::new(),
            sheet: None,
            started: Started::default(),
            gives_up: Vec::new(),
        };
        case.happen(&mut dice);
        case.vary(&mut Dice::new(seed ^ VARIES));
        case.widen(&mut Dice::new(seed ^ WIDER));
        let mut dice = Dice::new(seed ^ GIVES_UP);
        case.gives_up = (0..8).filter(|_| dice.in_percent(15)).collect();
        case
    }

    /// Varies what was thought of later: earlier seeds stay what they were.
    fn vary(&mut self, dice: &mut Dice) {
        if let What::Job(_, machine) = &mut self.what {
            machine.height.invert = dice.in_percent(30);
        }
        self.started = wall_clock(dice);
    }

    /// Half of the part files have lines of the second generation.
    fn widen(&mut self, dice: &mut Dice) {
        if let What::Part { name, text } = &mut self.what
            && self.seed >= FIRST_WIDER
            && dice.in_percent(50)
        {
            *text = programs::wider(text, *name == "a.nc", dice);
        }
    }

    /// Adds inputs and requests that happen to it.
    fn happen(&mut self, dice: &mut Dice) {
        for _ in 0..dice.of(&[0, 0, 1, 2]) {
            let request = match dice.below(8) {
                0 => OperatorRequest::Feed(dice.between(0.3, 1.8) as f32),
                1 => OperatorRequest::Hold,
                2 if dice.in_percent(30) => OperatorRequest::End,
                _ => OperatorRequest::Stop,
            };
            self.requests.push((dice.between(0.0, 1.0), request));
        }
        for _ in 0..dice.of(&[0, 0, 0, 0, 1, 2]) {
            let input = match &self.what {
                What::Part { .. } => dice.of(&[1, 2, 3, 4]),
                What::Job(..) => dice.of(&[
                    Input::EmergencyStop.number(),
                    Input::EndBottomDelay.number(),
                    Input::ZLow.number(),
                    4,
                ]),
            };
            let at = dice.between(0.0, 1.0);
            self.inputs.extend([(input, at, true), (input, at + dice.between(0.0, 0.2), false)]);
        }
        for _ in 0..dice.of(&[0, 1, 1, 2, 3]) {
            self.kills.push(dice.between(0.0, 1.0));
            let by = |dice: &mut Dice| dice.of(&[0.0, 0.0, 3.0, -2.0]);
            self.pushed.push(Axes::xyz(by(dice), by(dice), by(dice)));
        }
        self.lay_sheet(dice);
    }

    /// A torch and height control need something to feel, and an arc that burns.
    fn lay_sheet(&mut self, dice: &mut Dice) {
        let What::Job(_, machine) = &self.what else { return };
        if machine.plasma.use_sequence || machine.height.on {
            let [slope_x, slope_y] = [0, 0].map(|_| dice.between(-0.002, 0.002));
            self.sheet = Some(Sheet { slope_x, slope_y, ..Sheet::flat(-22.0) });
            self.inputs.insert(0, (Input::EndBottomDelay.number(), 0.0, true));
        }
    }

    /// Tells whether the path is the same whenever the process dies: nothing changes it on the way.
    pub fn keeps_its_path(&self) -> bool {
        let early = |(_, at, _): &(u8, f64, bool)| *at == 0.0;
        self.inputs.iter().all(early)
            && !self.requests.iter().any(|(_, w)| *w == OperatorRequest::End)
    }

    /// Tells whether heights of the path are planned ones.
    pub fn keeps_heights(&self) -> bool {
        match &self.what {
            What::Job(_, machine) => !machine.height.on && !machine.plasma.use_sequence,
            What::Part { .. } => true,
        }
    }

    /// Tells whether a sheet is followed, by a sensor that leads the head to it.
    pub fn follows_sheet(&self) -> bool {
        let What::Job(_, machine) = &self.what else { return false };
        machine.height.on && !machine.plasma.use_sequence
    }

    /// Tells whether the tool goes down along the path of a shape by plan: not where the sheet is followed, or felt
    /// where the cut begins.
    pub fn slopes(&self, number: u32) -> bool {
        let What::Job(job, machine) = &self.what else { return true };
        let shape = job.shapes.iter().find(|shape| shape.number == number);
        let followed =
            machine.height.on && shape.is_some_and(|shape| shape.height == CutDepth::Thru);
        !machine.plasma.use_sequence && !followed
    }

    /// Tells whether a way down along the path is begun again when the machine stops on it.
    pub fn ramps(&self, number: u32) -> bool {
        let What::Job(job, _) = &self.what else { return false };
        let shape = job.shapes.iter().find(|shape| shape.number == number);
        shape.is_some_and(|shape| shape.plunge != Plunge::Straight)
    }

    pub fn work(&self) -> Work {
        match &self.what {
            What::Part { name, text } => kerf_part::read((*name).into(), text.as_bytes()).into(),
            What::Job(job, machine) => {
                Work::Job(Arc::new((**job).clone()), Arc::new((**machine).clone()))
            }
        }
    }

    /// Options of the run when it takes so long by itself, seconds.
    pub fn options(&self, takes_s: f64) -> RunOptions {
        let change = |&(input, at, on): &(u8, f64, bool)| Change { input, at_s: at * takes_s, on };
        let mut options = RunOptions {
            inputs: self.inputs.iter().map(change).collect(),
            sheet: self.sheet,
            started: Some(self.started.clone()),
            ..RunOptions::default()
        };
        options.program.max_lines = 4000;
        options
    }

    pub fn allowed(&self) -> Allowed {
        let feeds = self.requests.iter().map(|(_, request)| match request {
            OperatorRequest::Feed(share) => f64::from(*share),
            _ => 1.0,
        });
        let feed = feeds.fold(1.0, f64::max);
        // A smoothed path is measured in chords.
        let smooth = self.settings.ramp_model == Some(RampModel::Optimal);
        let (hair, jump_mm) = if smooth { (2e-3, 0.02) } else { (1e-6, 1e-6) };
        match &self.what {
            What::Part { .. } => {
                let limits = self.settings.limits;
                Allowed {
                    bounds: limits.check.then_some([limits.low, limits.high]),
                    axis_mm_s: self.settings.dynamics.map(|dynamics| dynamics.speed_mm_s),
                    axis_mm_s2: self.settings.dynamics.map(|it| it.accel_mm_s2),
                    feed,
                    hair,
                    jump_mm,
                    job: false,
                    z_wanders: false,
                }
            }
            What::Job(_, machine) => {
                let length = machine.axes.length;
                let low = Axes::xyz(0.0, 0.0, -length.0[2]);
                let high = Axes::xyz(length.0[0], length.0[1], 0.0);
                Allowed {
                    bounds: machine.axes.limit_movement.then_some([low, high]),
                    axis_mm_s: Some(machine.program.axis_dynamics().speed_mm_s),
                    axis_mm_s2: Some(machine.program.axis_dynamics().accel_mm_s2),
                    feed,
                    hair,
                    jump_mm,
                    job: true,
                    z_wanders: !self.keeps_heights(),
                }
            }
        }
    }
}

/// Any time of any day.
fn wall_clock(dice: &mut Dice) -> Started {
    let [hour, minute, second] = [24, 60, 60].map(|below| dice.below(below));
    let [year, month, day] = [1970 + dice.below(130), 1 + dice.below(12), 1 + dice.below(28)];
    Started {
        time: format!("{hour:02}:{minute:02}:{second:02}"),
        date: format!("{year}-{month:02}-{day:02}"),
    }
}

fn part(name: &'static str, text: String) -> What {
    What::Part { name, text }
}

/// A machine for part files, inches.
fn settings(dice: &mut Dice) -> Settings {
    let mut settings = Settings::default();
    let inch = |v: f64| v * 25.4;
    settings.limits.check = dice.in_percent(60);
    settings.limits.low = Axes([inch(-1.0), inch(-1.0), inch(-2.0), inch(-9.0), -360.0, -360.0]);
    settings.limits.high = Axes([inch(11.0), inch(11.0), inch(2.0), inch(9.0), 360.0, 360.0]);
    settings.warning_s = dice.of(&[0.0, 1.0]);
    settings.ask_spindle = false;
    // Inputs 3 and 4: nothing, a limit, a stop.
    settings.io.inputs[2] = dice.of(&[0, 1]);
    settings.io.inputs[3] = dice.of(&[0, 3]);
    let model = dice.of(&[RampModel::Shopbot, RampModel::Profiler, RampModel::Optimal]);
    settings.ramp_model = Some(model);
    if model != RampModel::Shopbot {
        settings.dynamics = Some(Dynamics::usual(&settings.speeds));
    }
    settings
}

impl fmt::Display for Case {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "seed {}", self.seed)?;
        match &self.what {
            What::Part { name, text } => writeln!(f, "{name}:\n{text}")?,
            What::Job(job, machine) => {
                let text = kerf_machine::file::write(machine);
                let set = text.lines().filter(|line| !line.starts_with('#'));
                let usual = kerf_machine::file::write(&kerf_ledger::jobs::sim());
                let own: Vec<&str> = set.filter(|line| !usual.contains(line)).collect();
                writeln!(f, "{job:#?}\n{}", own.join("\n"))?;
            }
        }
        writeln!(f, "{:?} limits {}", self.settings.ramp_model, self.settings.limits.check)?;
        let (inputs, requests) = (&self.inputs, &self.requests);
        writeln!(f, "inputs {inputs:?}\nrequests {requests:?}\nkills {:?}", self.kills)?;
        writeln!(f, "gives up {:?}\npushed {:?}", self.gives_up, self.pushed)?;
        writeln!(f, "sheet {:?}", self.sheet)
    }
}
