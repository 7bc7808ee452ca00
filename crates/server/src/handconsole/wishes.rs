//! What the console wishes, done as if whoever pressed its keys had asked for it at a page.

use super::Happening;
use crate::app::{App, lock, problem};
use crate::machine::Order;
use kerf_handconsole::Wish;
use kerf_machine::{Configuration, Errand};
use kerf_wire::{Act, FileParameters, Problem, State, Who, Why};
use std::sync::Arc;
use std::sync::mpsc::Sender;

impl App {
    /// Grants a wish, if whoever has it may have that done.
    ///
    /// # Errors
    /// Why not.
    pub fn grant(
        self: &Arc<Self>,
        who: &Who,
        seq: u32,
        wish: Wish,
        tells: &Sender<Happening>,
    ) -> Result<(), Problem> {
        let act = match wish {
            Wish::Stop => Act::Stop,
            Wish::Acknowledge => Act::Acknowledge,
            Wish::TakeControl => return self.take_control(who),
            Wish::Open(name) => Act::Open { name, parameters: FileParameters::default() },
            Wish::Resume => Act::Resume { lease: self.drives(who)? },
            Wish::Start => {
                let (lease, hash) = (self.drives(who)?, lock(&self.open).hash.clone());
                Act::Run { lease, hash, step: false }
            }
            Wish::Answer(answer) => {
                self.drives(who)?;
                let question = self.hub.read(|now| now.asked.as_ref().map(|asked| asked.number));
                Act::Answer { question: question.unwrap_or_default(), answer }
            }
            Wish::Set { key, value } => {
                Act::Set { lease: self.drives(who)?, key: key.into(), value }
            }
            Wish::Jog(held) => {
                self.drives(who)?;
                return self.jog(who, seq, self.errand(Errand::Held(held), tells));
            }
            Wish::Go(errand) => {
                self.drives(who)?;
                return self.order(self.errand(errand, tells), State::Running);
            }
        };
        self.act(who, act).map(drop)
    }

    fn errand(&self, errand: Errand, tells: &Sender<Happening>) -> Order {
        Order::Hand { errand, machine: Box::new(self.with_job()), tells: tells.clone() }
    }

    /// The machine, with origin and finish position where those of the open job lie.
    fn with_job(&self) -> Configuration {
        let mut machine = lock(&self.left).session.configuration();
        let open = lock(&self.open).clone();
        if let Ok(kerf_control::Work::Job(job, _)) = self.job_of(&open) {
            machine.job.change_origin_at_start = false;
            let placed =
                kerf_machine::Sequence::new(job, Arc::new(machine.clone()), Default::default());
            let (origin, finish) = (placed.job().origin, placed.job().finish);
            (machine.job.origin_mm, machine.job.finish_mm) =
                ([origin.x, origin.y], [finish.x, finish.y]);
        }
        machine
    }

    /// Drives from now on, with the machine armed. Whoever drove until now loses it only while the machine
    /// stands.
    fn take_control(self: &Arc<Self>, who: &Who) -> Result<(), Problem> {
        let mine = self.drives(who).is_ok();
        if !mine && matches!(self.state(), State::Running | State::Jogging) {
            return Err(problem(Why::State, "the machine moves: Stop it first"));
        }
        self.act(who, Act::TakeLease { force: true })?;
        let lease = self.hub.read(|now| now.lease.as_ref().map_or(0, |lease| lease.number));
        self.act(who, Act::Arm { lease }).map(drop)
    }
}
