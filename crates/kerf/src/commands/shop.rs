//! The machine, while a command moves it by hand.

use super::which::Which;
use crate::args::PlaceArgs;
use crate::controller::{self, Beginning, First};
use crate::data_args::data_folder;
use crate::exit::Exit;
use crate::operator::{Clock, Person, Terminal};
use crate::report::asked;
use crate::stop::Stop;
use crate::{out, served, setup};
use anyhow::{Result, bail};
use kerf_control::answers::Answers;
use kerf_control::controller::Controller;
use kerf_control::{AtRest, OperatorRequest, RunContext, Script, Session};
use kerf_journal::{RunOptions, Work};
use kerf_machine::{Configuration, Errand};
use kerf_program::{AXES, Axis, MoveKind, Status};
use kerf_trace::{Event, Sink};
use kerf_workspace::{Workspace, unverified};
use std::io::{self, IsTerminal};
use std::path::Path;
use std::sync::Arc;

/// The machine, while somebody works on it by hand.
pub struct Shop {
    pub session: Session,
    pub workspace: Workspace,
    pub machine: Arc<Configuration>,
    pub controller: Option<Controller>,
    place: PlaceArgs,
    real: bool,
}

impl Shop {
    /// The machine that is named.
    pub fn open(which: &Which, real: bool) -> Result<Self> {
        Self::open_after(which, First::NONE, real)
    }

    /// The machine after steps of its controller.
    pub fn open_after(which: &Which, first: First, real: bool) -> Result<Self> {
        let place = which.place();
        let mut workspace = setup::workspace(Path::new(""), &place, false)?;
        let (mut session, _) = setup::session(&place, false, &mut workspace)?;
        let machine = match which.machine.configuration() {
            Some(_) => which.machine()?,
            None => session.configuration(),
        };
        let machine = Arc::new(machine);
        session.machine_is = machine.clone();
        let name = which.machine.controller();
        let beginning = Beginning { first, quiet: false, log: None };
        let ready = |name| controller::ready(name, beginning, &mut session, &mut workspace);
        let controller = name.map(ready).transpose()?;
        Ok(Self { session, workspace, machine, controller, place, real })
    }

    /// Fails unless the machine stands, and its place in X and Y is known.
    pub fn stands_for_sure(&self) -> Result<()> {
        if let Some(journal) = self.workspace.journal() {
            drop(journal.own()?);
        }
        let doubted = unverified(&self.workspace);
        if doubted.contains(Axis::X) || doubted.contains(Axis::Y) {
            bail!(
                "where the machine is is not known for sure: home it first (kerf machine home), or give \
                 the place as X,Y"
            );
        }
        Ok(())
    }

    /// Carries out a line, as if it were typed at the machine, unless its controller lacks what that needs.
    pub fn types(&mut self, line: &str) -> Result<Exit> {
        let read = || Work::from(kerf_sbp::read_typed("typed".into(), &format!("{line}\n")));
        let mut options = RunOptions::default();
        options.program.typed = true;
        if let Some(controller) = &self.controller {
            let files = setup::workspace(Path::new(""), &self.place, true)?;
            let (session, answers) = (&self.session, Answers::default());
            let work = read();
            let lacks =
                controller::look_through(controller, &work, session, &options, files, answers);
            if let Some(exit) = lacks {
                controller.detach(&mut self.workspace);
                return Ok(exit);
            }
        }
        self.does_with(read(), options, Vec::new())
    }

    /// Looks at the controller for what its inputs tell.
    pub fn look(&mut self) {
        let Some(controller) = &self.controller else { return };
        for input in controller.attend().0 {
            AtRest(&mut self.session).senses(input);
        }
    }

    /// Lifts the tool straight up to Safe-Z, where a stop has left it lower.
    pub fn lifts(&mut self) -> Result<()> {
        // The stop that ended it is over.
        Stop::listen()?.hear();
        let Some(up_mm) = self.session.lift_mm() else { return Ok(()) };
        let mut place = [None; AXES];
        place[Axis::Z.index()] = Some(up_mm);
        self.errand(Errand::To { place, relative: false, flat: false }, Vec::new())?;
        Ok(())
    }

    /// The controller was moved by what it ran by itself: the machine is believed to stand where it stands now.
    pub fn stands_where_it_stands(&mut self) -> Result<()> {
        let Some(controller) = &self.controller else { return Ok(()) };
        if let (_, Some(place)) = controller.attend() {
            self.session.memory.position = place;
        }
        self.session.keep_place(&mut self.workspace)?;
        controller.ends(true, &mut self.workspace, || false);
        Ok(())
    }

    /// The controller is left as it was found.
    pub fn leave(&mut self) {
        if let Some(controller) = &self.controller {
            controller.detach(&mut self.workspace);
        }
    }

    /// Does something and prints each step of it.
    pub fn does(&mut self, work: Work, requests: Vec<(f64, OperatorRequest)>) -> Result<Exit> {
        self.does_with(work, RunOptions::default(), requests)
    }

    fn does_with(
        &mut self,
        work: Work,
        options: RunOptions,
        requests: Vec<(f64, OperatorRequest)>,
    ) -> Result<Exit> {
        let clock = if self.real { Clock::Real } else { Clock::Fast };
        let mut terminal = Terminal::new(clock, Script::new(requests, Vec::new()))?;
        let mut operator = Person::new(Answers::default(), io::stdin().is_terminal(), &terminal);
        let controller = self.controller.clone();
        let machine =
            controller.as_ref().map_or_else(|| terminal.simulated(), |it| it.driven().into());
        let stop = Stop::listen()?;
        let mut steps = Steps { machine: self.machine.clone(), edge: None };
        let context = RunContext {
            sink: &mut steps,
            operator: &mut operator,
            requests: &mut terminal,
            machine,
        };
        let (settings, workspace) =
            (Some(self.session.memory.settings.clone()), &mut self.workspace);
        let name = controller.as_ref().map(|it| it.name().to_owned());
        let options = RunOptions { controller: name, ..options };
        controller.iter().for_each(|controller| controller.begins(workspace));
        let summary = self.session.run_on_record(work, options, settings, workspace, context)?;
        if let Some(controller) = &controller {
            controller.ends(summary.status == Status::Ok, workspace, || stop.is_wanted());
            controller.detach(workspace);
        }
        if let Some(error) = summary.error {
            let mend = if error.hint.is_empty() { "" } else { "; " };
            eprintln!("kerf: {}{mend}{}", error.message, error.hint);
        }
        Ok(summary.status.into())
    }

    pub fn errand(
        &mut self,
        errand: Errand,
        requests: Vec<(f64, OperatorRequest)>,
    ) -> Result<Exit> {
        self.does(Work::Hand(errand, self.machine.clone()), requests)
    }
}

/// Refuses to change what a running server would not know of.
pub fn not_beside_a_server(which: &Which, mend: &str) -> Result<()> {
    let folder = data_folder(&which.folder())?;
    match served::address(&folder)? {
        None => Ok(()),
        Some(address) => {
            bail!("a kerf serve has this machine: {mend} at {address}, or end it first")
        }
    }
}

/// Prints motions, homed axes, messages and questions.
struct Steps {
    machine: Arc<Configuration>,
    /// The switch that changed during the motion at hand.
    edge: Option<f64>,
}

impl Sink for Steps {
    fn event(&mut self, event: &Event) {
        match event {
            Event::Input { t, .. } => self.edge = Some(*t),
            Event::Move(made) => {
                let ways = Axis::ALL.map(|axis| made.to.of(axis) - made.from.of(axis));
                let length = ways[..3].iter().map(|way| way * way).sum::<f64>().sqrt();
                for axis in Axis::ALL {
                    let (from, to) = (made.from.of(axis), made.to.of(axis));
                    if (from - to).abs() > 1e-9 {
                        let name = self.machine.motors.axis_name(axis);
                        let kind = if made.kind == MoveKind::Cut { ", cut" } else { "" };
                        let (t0, t1) = (made.t0, made.t1);
                        let span = format!("{t0:8.3} to {t1:8.3} s");
                        let way = format!("{name:<2} {from:9.3} to {to:9.3}");
                        // The speed is that along the path; an axis has its part of it.
                        let part = if length > 0.0 { (to - from).abs() / length } else { 1.0 };
                        let speed = made.speed * part;
                        out::print(&format!("{span}  {way}, up to {speed:.3}/s{kind}\n"));
                    }
                }
                if let Some(t) = self.edge.take() {
                    out::print(&format!("{t:8.3} s  a switch changed\n"));
                }
            }
            Event::Homed { axis, steps, .. } => out::print(&format!("{axis} {steps} steps\n")),
            Event::Message { text, .. } => out::print(&format!("{text}\n")),
            Event::Ask(ask) => out::print(&format!("{}\n", asked(ask))),
            _ => {}
        }
    }
}
