//! List of checks that every [`Machine`] has to pass, over a good line and over a bad one.
//!
//! ```ignore
//! for case in kerf_machine::conformance::CASES {
//!     assert_eq!(case.run(&mut MyBench::at_rest()), Ok(Outcome::Held), "{}", case.name);
//! }
//! ```
//!
//! Each case begins with a machine at rest at zero of every axis, all outputs off, that can go 50 mm in X and has a
//! spindle. Over a bad line a machine may have a fault in place of what a case asks for: then the fault stays the one it
//! is, and the machine comes to a stand with its outputs off. What is never allowed is a wrong answer.

mod run;

use crate::{Actuator, Fault, Machine};
use kerf_program::{Axes, Axis, OutputReason};
use run::{END_MM, Run, X_MM};

/// A machine with a way to wait for it.
pub trait Bench {
    /// The machine.
    fn machine(&mut self) -> &mut dyn Machine;

    /// Lets the machine go on for a moment; returns `false` when it has had time enough for everything.
    fn waits(&mut self) -> bool;

    /// Looks at the machine itself, past all that it tells; nothing where there is nothing to see.
    fn seen(&mut self) -> Option<Seen>;

    /// Has something go wrong for which it does nothing more; returns `false` where nothing can.
    fn breaks(&mut self) -> bool;

    /// Moves the switch of an input of the machine, so that it is active or not; returns the input, nothing where it has
    /// none.
    fn moves_switch(&mut self, _active: bool) -> Option<u8> {
        None
    }
}

/// A machine as a bystander sees it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Seen {
    /// Place of its axes, machine frame.
    pub place: Axes,
    /// Its spindle turns.
    pub turns: bool,
}

/// The end of a case in which the machine gave no wrong answer.
#[derive(Clone, Debug, PartialEq)]
pub enum Outcome {
    /// It did what it was asked for.
    Held,
    /// It told why it does nothing more.
    Failed(Fault),
}

/// One thing that has to hold.
#[derive(Debug)]
pub struct Case {
    /// The requirement in words.
    pub name: &'static str,
    check: fn(&mut Run<'_>) -> Result<(), Short>,
}

/// Everything that has to hold.
pub const CASES: &[Case] = &[
    Case { name: "a plan is made whole, and no moment behind its end is reached", check: whole },
    Case { name: "pieces of a plan are made one behind the other", check: pieces },
    Case { name: "what is set comes between the moves before and behind it", check: set_between },
    Case { name: "a stop on the way stands within the plan, outputs off", check: stop },
    Case { name: "a halt at rest switches outputs off", check: halt },
    Case { name: "a machine that stands lets time pass and stays", check: stand },
    Case {
        name: "an input that changes at rest is told, and no change twice",
        check: told_at_rest,
    },
    Case {
        name: "an input that changes on the way is told there, and the move goes on",
        check: told_on_the_way,
    },
    Case { name: "a fault is told once and kept", check: fault },
];

impl Case {
    /// Checks it on a machine at rest.
    ///
    /// # Errors
    /// The wrong answer of the machine, in words.
    pub fn run(&self, bench: &mut dyn Bench) -> Result<Outcome, String> {
        let mut run = Run::new(bench);
        match (self.check)(&mut run).and_then(|()| run.ends()) {
            Ok(()) => Ok(Outcome::Held),
            Err(Short::Wrong(why)) => Err(why),
            Err(Short::Failed(fault)) => run.keeps(&fault).map(|()| Outcome::Failed(*fault)),
        }
    }
}

/// The reason why a case does not come to its end.
enum Short {
    /// The machine gave a wrong answer.
    Wrong(String),
    /// It has a fault.
    Failed(Box<Fault>),
}

fn require(holds: bool, otherwise: impl FnOnce() -> String) -> Result<(), Short> {
    if holds { Ok(()) } else { Err(Short::Wrong(otherwise())) }
}

/// The spindle turns from here on.
const SPINDLE: [Actuator; 2] = [
    Actuator::Spindle { rpm: 1000.0 },
    Actuator::Output { number: 1, on: true, why: OutputReason::Program },
];

fn whole(run: &mut Run<'_>) -> Result<(), Short> {
    run.follows(&[10.0, 4.0, 12.0])?;
    run.settles()?;
    run.comes_to(12.0)
}

fn pieces(run: &mut Run<'_>) -> Result<(), Short> {
    for to_mm in [3.0, 8.0, 2.0] {
        run.follows(&[to_mm])?;
    }
    run.settles()?;
    run.comes_to(2.0)
}

fn set_between(run: &mut Run<'_>) -> Result<(), Short> {
    run.looks = |seen| {
        let x_mm = seen.place[Axis::X];
        let early = seen.turns && x_mm < 5.0 - X_MM;
        let late = !seen.turns && x_mm > 5.0 + X_MM;
        if early || late {
            Err(format!("at x {x_mm} the spindle turns: {}", seen.turns))
        } else {
            Ok(())
        }
    };
    run.follows(&[5.0])?;
    SPINDLE.iter().for_each(|actuator| run.machine().set(actuator));
    run.follows(&[10.0])?;
    run.settles()?;
    run.comes_to(10.0)
}

fn stop(run: &mut Run<'_>) -> Result<(), Short> {
    SPINDLE.iter().for_each(|actuator| run.machine().set(actuator));
    let stands_mm = run.stops_on_the_way()?;
    run.settles()?;
    if let Some(stands_mm) = stands_mm {
        require(stands_mm < END_MM, || "the move was made to its end".into())?;
        run.comes_to(stands_mm)?;
        run.is_off()?;
        // It goes on from there.
        run.stands_at(stands_mm);
        run.follows(&[0.0])?;
        run.settles()?;
        run.comes_to(0.0)?;
    }
    Ok(())
}

fn halt(run: &mut Run<'_>) -> Result<(), Short> {
    SPINDLE.iter().for_each(|actuator| run.machine().set(actuator));
    run.follows(&[3.0])?;
    run.settles()?;
    run.machine().halt();
    run.is_sound()?;
    run.is_off()?;
    run.comes_to(3.0)
}

fn stand(run: &mut Run<'_>) -> Result<(), Short> {
    run.stands(0.3)?;
    run.settles()?;
    run.comes_to(0.0)
}

fn told_at_rest(run: &mut Run<'_>) -> Result<(), Short> {
    for active in [true, false] {
        let Some(input) = run.moves_switch(active) else { return Ok(()) };
        while !run.was_told(input, active) {
            run.stands(0.01)?;
        }
    }
    run.stands(0.3)?;
    run.settles()?;
    run.told_nothing_twice()
}

fn told_on_the_way(run: &mut Run<'_>) -> Result<(), Short> {
    let moved = run.moves_switch_on_the_way()?;
    let told = moved.is_none_or(|input| run.was_told(input, true));
    require(told, || "an input changed on the way, and it is not told at its end".into())?;
    run.settles()?;
    run.comes_to(END_MM)?;
    run.told_nothing_twice()
}

fn fault(run: &mut Run<'_>) -> Result<(), Short> {
    run.is_sound()?;
    if !run.breaks() {
        return Ok(());
    }
    match run.stops_on_the_way() {
        Err(Short::Failed(fault)) => run.keeps(&fault).map_err(Short::Wrong),
        Err(wrong) => Err(wrong),
        Ok(_) => Err(Short::Wrong("nothing is told of what went wrong".into())),
    }
}
