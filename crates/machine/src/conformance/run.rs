//! A machine that is watched while it follows plans, and what is wrong as soon as it is.

use super::{Bench, Seen, Short, require};
use crate::{Fault, Going, Machine, News};
use kerf_motion::{Mover, Plan, plan_stack};
use kerf_program::{At, Axes, Axis, Feed, Line, MoveKind, Settings};

/// The end of a move that is stopped on its way, mm.
pub(super) const END_MM: f64 = 40.0;

/// A place is where it should be within this, mm: some steps of a motor.
pub(super) const X_MM: f64 = 0.02;

/// A moment is no later than another within this, seconds: the rounding of a sum.
const EXACT_S: f64 = 1e-9;

/// A machine that is asked for something and watched meanwhile.
pub(super) struct Run<'a> {
    bench: &'a mut dyn Bench,
    /// Machine time that has passed, seconds.
    now_s: f64,
    x_mm: f64,
    /// A look at the machine itself, between any two of its answers.
    pub looks: fn(&Seen) -> Result<(), String>,
    /// The first thing that was seen and should not be. A line that was garbled on its way may lead a machine anywhere;
    /// then it has to tell so in the end.
    odd: Option<String>,
    /// Inputs that were told, each with whether it was active, one behind the other.
    told: Vec<(u8, bool)>,
}

impl<'a> Run<'a> {
    pub fn new(bench: &'a mut dyn Bench) -> Self {
        bench.machine().begin();
        Self { bench, now_s: 10.0, x_mm: 0.0, looks: |_| Ok(()), odd: None, told: Vec::new() }
    }

    pub fn machine(&mut self) -> &mut dyn Machine {
        self.bench.machine()
    }

    pub fn breaks(&mut self) -> bool {
        self.bench.breaks()
    }

    /// The next plan begins here, mm.
    pub const fn stands_at(&mut self, x_mm: f64) {
        self.x_mm = x_mm;
    }

    /// It has no fault.
    pub fn is_sound(&mut self) -> Result<(), Short> {
        self.machine().fault().cloned().map_or(Ok(()), |fault| Err(Short::Failed(Box::new(fault))))
    }

    /// Checks that the machine did nothing it should not.
    pub fn ends(&mut self) -> Result<(), Short> {
        self.odd.take().map_or(Ok(()), |odd| Err(Short::Wrong(odd)))
    }

    /// Waits a moment, and looks at the machine and at what it tells.
    fn waits(&mut self, what: &str) -> Result<(), Short> {
        self.is_sound()?;
        let goes_on = self.bench.waits();
        let odd = self.bench.seen().and_then(|seen| (self.looks)(&seen).err());
        self.odd = self.odd.take().or(odd);
        if self.machine().waits().is_some() {
            // A byte that was garbled into a hold: nobody is at its controls to have it go on.
            self.machine().give_up();
            self.is_sound()?;
        }
        require(goes_on, || format!("it does not come to an end: {what}"))
    }

    /// A plan from where the machine stands along X.
    fn plan(&self, to_mm: &[f64]) -> Plan {
        let settings = Settings::default();
        let mut mover = Mover::new(Axes::xyz(self.x_mm, 0.0, 0.0), &settings);
        let line = |x_mm: &f64| {
            let to = Axes::xyz(*x_mm, 0.0, 0.0);
            mover.line(At::default(), &Line { kind: MoveKind::Cut, to, feed: Feed::Axis })
        };
        plan_stack(to_mm.iter().filter_map(line).collect(), &settings.ramps)
    }

    /// Follows a plan to these places of X, one behind the other, mm.
    pub fn follows(&mut self, to_mm: &[f64]) -> Result<(), Short> {
        let plan = self.plan(to_mm);
        self.machine().begin_plan();
        let t0_s = self.now_s;
        for index in 0..plan.moves().len() {
            let end_s = t0_s + plan.span_s(index).1;
            self.advances(&going(&plan, index, t0_s), end_s)?;
        }
        self.x_mm = to_mm.last().copied().unwrap_or(self.x_mm);
        // The plan ends at a stand: nobody goes on before the machine is there.
        let x_mm = self.bench.seen().map_or(self.x_mm, |seen| seen.place[Axis::X]);
        if (x_mm - self.x_mm).abs() > X_MM {
            self.odd.get_or_insert(format!("a plan to x {} is made at x {x_mm}", self.x_mm));
        }
        Ok(())
    }

    /// Follows one move towards a moment; none behind its end is told.
    fn advances(&mut self, going: &Going<'_>, until_s: f64) -> Result<(), Short> {
        let begin_s = going.t0_s + going.plan.span_s(going.index).0;
        let end_s = going.t0_s + going.plan.span_s(going.index).1;
        while self.now_s < until_s {
            let News { reached_s, input } =
                self.bench.machine().advance(going, self.now_s, until_s);
            self.told.extend(input);
            let within = (begin_s - EXACT_S..=end_s + EXACT_S).contains(&reached_s);
            require(within || reached_s == f64::INFINITY, || {
                format!("a move from {begin_s} s to {end_s} s has reached {reached_s} s")
            })?;
            self.now_s = reached_s.min(until_s);
            self.waits("a move")?;
        }
        Ok(())
    }

    /// Goes to [`END_MM`], is stopped in the middle, and returns where it says that it stands, mm; nothing where it stops
    /// by the ramp that is planned for it.
    pub fn stops_on_the_way(&mut self) -> Result<Option<f64>, Short> {
        let plan = self.plan(&[END_MM]);
        self.machine().begin_plan();
        let (t0_s, middle_s) = (self.now_s, self.now_s + 0.5 * plan.duration_s());
        let going = going(&plan, 0, t0_s);
        self.advances(&going, middle_s)?;
        let stands_s = self.machine().stop(&going);
        self.is_sound()?;
        let Some(stands_s) = stands_s else { return Ok(None) };
        let end_s = t0_s + plan.duration_s();
        require((t0_s..=end_s).contains(&stands_s), || {
            format!("it stands at {stands_s} s of a plan from {t0_s} s to {end_s} s")
        })?;
        self.now_s = stands_s;
        Ok(Some(going.at(stands_s).position[Axis::X]))
    }

    pub fn moves_switch(&mut self, active: bool) -> Option<u8> {
        self.bench.moves_switch(active)
    }

    /// Goes to [`END_MM`]; in the middle a switch is moved. Returns its input.
    pub fn moves_switch_on_the_way(&mut self) -> Result<Option<u8>, Short> {
        let plan = self.plan(&[END_MM]);
        self.machine().begin_plan();
        let t0_s = self.now_s;
        let going = going(&plan, 0, t0_s);
        self.advances(&going, t0_s + 0.5 * plan.duration_s())?;
        let moved = self.moves_switch(true);
        self.advances(&going, t0_s + plan.duration_s())?;
        self.x_mm = END_MM;
        Ok(moved)
    }

    /// The last that was told of an input is that it is active, or not.
    pub fn was_told(&self, input: u8, active: bool) -> bool {
        let last = self.told.iter().rev().find(|(number, _)| *number == input);
        last.is_some_and(|(_, told)| *told == active)
    }

    /// Checks that no input was told the same state twice in succession.
    pub fn told_nothing_twice(&self) -> Result<(), Short> {
        let twice = self.told.iter().enumerate().find(|(i, told)| {
            let before = self.told.iter().take(*i).rev().find(|(number, _)| *number == told.0);
            before == Some(told)
        });
        require(twice.is_none(), || format!("{twice:?} is told twice"))
    }

    /// Everything that the machine has is made, and then it has no more to make.
    pub fn settles(&mut self) -> Result<(), Short> {
        while self.machine().settle() {
            self.waits("what it has")?;
        }
        self.is_sound()
    }

    /// The machine is at a place of X, mm, and says so, or tells what went wrong.
    pub fn comes_to(&mut self, x_mm: f64) -> Result<(), Short> {
        while !self.is_at(x_mm) {
            let seen = self.bench.seen();
            self.passes(&format!("it is to stand at x {x_mm}, and stands at {seen:?}"))?;
        }
        self.is_sound()
    }

    fn is_at(&mut self, x_mm: f64) -> bool {
        let told = self.machine().place();
        let places = [told, self.bench.seen().map(|seen| seen.place)];
        places.into_iter().flatten().all(|place| (place[Axis::X] - x_mm).abs() < X_MM)
    }

    /// The spindle does not turn.
    pub fn is_off(&mut self) -> Result<(), Short> {
        while self.bench.seen().is_some_and(|seen| seen.turns) {
            self.passes("the spindle is to stop")?;
        }
        Ok(())
    }

    /// A moment passes while nothing moves.
    fn passes(&mut self, what: &str) -> Result<(), Short> {
        let (from_s, until_s) = (self.now_s, self.now_s + 0.01);
        let News { reached_s, input } = self.machine().stand(from_s, until_s);
        self.told.extend(input);
        require((from_s..=until_s).contains(&reached_s), || {
            format!("it stands from {from_s} s to {until_s} s and has reached {reached_s} s")
        })?;
        self.now_s = reached_s;
        self.waits(what)
    }

    /// So much time passes, seconds, while nothing moves.
    pub fn stands(&mut self, seconds: f64) -> Result<(), Short> {
        let until_s = self.now_s + seconds;
        while self.now_s < until_s - EXACT_S {
            self.passes("time is to pass")?;
        }
        Ok(())
    }

    /// The machine keeps its fault whatever it is asked for, has nothing left to make, and stands with its outputs off.
    pub fn keeps(&mut self, fault: &Fault) -> Result<(), String> {
        if fault.message.is_empty() {
            return Err("a fault is told without a word".into());
        }
        let machine = self.bench.machine();
        machine.look();
        machine.give_up();
        machine.halt();
        if machine.settle() {
            return Err("with a fault it has something left to make".into());
        }
        let told = machine.fault().cloned();
        if told.as_ref() != Some(fault) {
            return Err(format!("{fault:?} has become {told:?}"));
        }
        self.rests()
    }

    /// The machine is seen at one place two times, its spindle off.
    fn rests(&mut self) -> Result<(), String> {
        loop {
            let before = self.bench.seen();
            let goes_on = self.bench.waits();
            let seen = self.bench.seen();
            if seen == before && seen.is_none_or(|seen| !seen.turns) {
                return Ok(());
            }
            if !goes_on {
                return Err(format!("with a fault it does not come to rest: {seen:?}"));
            }
        }
    }
}

fn going(plan: &Plan, index: usize, t0_s: f64) -> Going<'_> {
    Going { plan, index, t0_s, until: plan.moves().len(), part: 1.0, watches: &[] }
}
