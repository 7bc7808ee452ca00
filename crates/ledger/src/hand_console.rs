//! The hand console on SIM: keys are pressed, requests come true at once, and what moves is traced.

use crate::jobs::{JobRun, JobTrace, sim};
use kerf_digitize::Digitizer;
use kerf_drawing::Shape;
use kerf_handconsole::{Console, ConsoleRequest, Key, View};
use kerf_machine::{Configuration, Errand, Held, Value, table};
use kerf_program::job::Job;
use kerf_program::{Axes, AxisSet, rounded};
use kerf_wire::Look;
use std::sync::Arc;

/// A hand console, and the machine it drives.
pub struct HandConsole {
    console: Console,
    /// The machine, with the settings in force.
    pub machine: Configuration,
    at: Axes,
    homed: AxisSet,
    /// Trace of what the machine did last.
    last: Option<JobTrace>,
    /// Moves that a function made, in order: see [`JobTrace::moves`].
    pub moves: Vec<String>,
    /// Axes that were homed, in order.
    pub found: Vec<String>,
    /// The shapes of the job that is open.
    pub shapes: Vec<Arc<Shape>>,
    /// Looks that pages were to have in sight, in order.
    pub looks: Vec<Look>,
}

impl Default for HandConsole {
    /// SIM, homed, at its home.
    fn default() -> Self {
        Self {
            console: Console::default(),
            machine: sim(),
            at: Axes::default(),
            homed: AxisSet::first(3),
            last: None,
            moves: Vec::new(),
            found: Vec::new(),
            shapes: Vec::new(),
            looks: Vec::new(),
        }
    }
}

impl HandConsole {
    /// Stands somewhere.
    pub fn at(x: f64, y: f64, z: f64) -> Self {
        Self { at: Axes::xyz(x, y, z), ..Self::default() }
    }

    /// Changes settings.
    #[must_use]
    pub fn with(mut self, change: impl FnOnce(&mut Configuration)) -> Self {
        change(&mut self.machine);
        self
    }

    /// Nothing was homed.
    #[must_use]
    pub fn unhomed(self) -> Self {
        Self { homed: AxisSet::EMPTY, ..self }
    }

    /// Presses keys: `Func 0 Enter 3000 Enter`. In numbers a point is the key File, a minus the key +/-.
    pub fn press(&mut self, keys: &str) {
        for word in keys.split(' ') {
            for key in keys_of(word) {
                let requests = self.console.press(key, &self.view());
                requests.into_iter().for_each(|request| self.grant(request));
            }
        }
    }

    /// Returns the lines that it shows.
    pub fn shows(&self) -> [String; 2] {
        self.console.screen(&self.view()).lines
    }

    /// The points that are being digitized.
    pub fn digitized(&self) -> Option<Digitizer> {
        self.console.digitized(&self.view())
    }

    /// The trace of what the machine did last.
    pub fn trace(&self) -> &JobTrace {
        self.last.as_ref().expect("nothing moved yet")
    }

    /// Returns the number of times it has beeped.
    pub fn beeps(&self) -> u32 {
        self.console.beeps()
    }

    /// Returns the place of the tool, to a millionth.
    pub fn position(&self) -> [f64; 3] {
        self.place().first3().map(|mm| rounded(mm, 6))
    }

    /// Holds a key for some seconds; gives what the machine did.
    pub fn hold(&mut self, digit: u8, seconds: f64) -> &JobTrace {
        let requests = self.console.press(Key::Digit(digit), &self.view());
        let [ConsoleRequest::Jog(held)] = requests[..] else {
            panic!("key {digit} moves nothing: {requests:?}")
        };
        self.jog(held, seconds)
    }

    /// Runs a job.
    pub fn run(&mut self, job: Job) -> JobTrace {
        self.placed(JobRun::new(job)).run()
    }

    fn view(&self) -> View {
        View {
            position: self.place(),
            machine: Arc::new(self.machine.clone()),
            drawn: self.shapes.clone(),
            ..View::default()
        }
    }

    fn place(&self) -> Axes {
        self.last.as_ref().map_or(self.at, |last| last.session.memory.position)
    }

    fn grant(&mut self, request: ConsoleRequest) {
        match request {
            ConsoleRequest::Set(values) => self.set(&values),
            ConsoleRequest::Go(errand) => self.go(errand),
            ConsoleRequest::AddShape(shape) => {
                self.shapes.push(shape);
                self.console.told(Ok(format!("{} shapes", self.shapes.len())));
            }
            ConsoleRequest::Look(look) => self.looks.push(look),
            other => panic!("there is nobody to grant {other:?}"),
        }
    }

    fn set(&mut self, values: &[(&str, String)]) {
        for (key, value) in values {
            let setting = table::setting(key).expect("a setting");
            setting.set(&mut self.machine, &Value::typed(value)).expect("a value it takes");
        }
    }

    fn go(&mut self, errand: Errand) {
        let trace = self.placed(JobRun::hand(errand)).run();
        let outcome = match trace.refused() {
            why if why.is_empty() => Ok(String::new()),
            why => Err(why),
        };
        self.moves.extend(trace.moves());
        self.found.extend(trace.homed());
        self.last = Some(trace);
        self.console.told(outcome);
    }

    fn jog(&mut self, held: Held, seconds: f64) -> &JobTrace {
        let trace = self.placed(JobRun::hand(Errand::Held(held))).let_go(seconds).run();
        self.last.insert(trace)
    }

    /// On the machine as it is and where it is.
    fn placed(&self, run: JobRun) -> JobRun {
        let run = run.with(|machine| *machine = self.machine.clone());
        let [x, y, z] = self.at.first3();
        let run = if self.homed.is_empty() { run.unhomed() } else { run }.at(x, y, z);
        match &self.last {
            Some(last) => run.after(last),
            None => run,
        }
    }
}

fn keys_of(word: &str) -> Vec<Key> {
    match word {
        "Func" => vec![Key::Func],
        "Enter" => vec![Key::Enter],
        "Start" => vec![Key::Start],
        "Stop" => vec![Key::Stop],
        "File" => vec![Key::File],
        number => number.chars().map(key_of).collect(),
    }
}

fn key_of(character: char) -> Key {
    match character {
        '-' => Key::PlusMinus,
        '.' => Key::File,
        digit => Key::of(digit).unwrap_or_else(|| panic!("no key {digit}")),
    }
}
