//! Grants the wishes of the console, as if whoever pressed its keys had asked for them at a page.

use super::Happening;
use crate::app::App;
use crate::asker::Asker;
use crate::gate::Way;
use crate::locks::lock;
use crate::machine::Order;
use crate::people::Grip;
use crate::refusal::problem;
use kerf_handconsole::{JobWish, Wish};
use kerf_machine::Errand;
use kerf_wire::{Act, Change, FileParameters, JobChoice, Look, Looked, Problem, State, Why};
use std::sync::Arc;
use std::sync::mpsc::Sender;

impl App {
    /// Grants a wish, if whoever has it may have that done.
    ///
    /// # Errors
    /// Why not.
    pub fn grant(
        self: &Arc<Self>,
        asker: &Asker,
        grip: Grip,
        wish: Wish,
        tells: &Sender<Happening>,
    ) -> Result<(), Problem> {
        let who = &asker.who;
        self.gate(who, Way::Wish(&wish))?;
        let act = match wish {
            Wish::Stop => Act::Stop,
            Wish::Acknowledge => Act::Acknowledge,
            Wish::TakeControl => return self.take_control(asker),
            Wish::Open(name) => Act::Open { name, parameters: FileParameters::default() },
            Wish::Resume => Act::Resume { lease: self.drives(who)? },
            Wish::Start => {
                let (lease, hash) = (self.drives(who)?, lock(&self.open).hash.clone());
                Act::Run { lease, hash, step: false }
            }
            Wish::Answer(answer) => {
                let question = self.hub.read(|now| now.asked.as_ref().map(|asked| asked.number));
                Act::Answer { question: question.unwrap_or_default(), answer }
            }
            Wish::Set(settings) => return self.hold(&settings, tells),
            Wish::KeepSettings => return self.order(Order::Keep(tells.clone())),
            Wish::Job(wish) => return self.grant_of_job(wish, tells),
            Wish::AddShape(shape) => {
                let added = self.add_shape(shape)?;
                // The console waits for it as long as the server runs.
                drop(tells.send(Happening::Told(Ok(added))));
                return Ok(());
            }
            Wish::Look(at) => {
                self.look_at(at);
                return Ok(());
            }
            Wish::Jog(held) => {
                return self.jog(asker, grip, self.errand(Errand::Held(held), tells));
            }
            Wish::Go(errand) => return self.order_of(asker, self.errand(errand, tells)),
        };
        self.act(asker, act).map(drop)
    }

    /// Pages have something else in sight.
    fn look_at(&self, at: Look) {
        self.hub.changing(|now| {
            let number = now.looked.map_or(1, |looked| looked.number + 1);
            vec![Change::Looked { looked: Some(Looked { number, at }) }]
        });
    }

    fn errand(&self, errand: Errand, tells: &Sender<Happening>) -> Order {
        Order::Hand { errand, machine: Box::new(self.machine_by_hand()), tells: tells.clone() }
    }

    /// Does something about the open job.
    fn grant_of_job(
        self: &Arc<Self>,
        wish: JobWish,
        tells: &Sender<Happening>,
    ) -> Result<(), Problem> {
        match wish {
            JobWish::Origin(at) => self.place_job("job.origin_mm", at, tells, |choice| JobChoice {
                origin: Some(at),
                ..choice
            }),
            JobWish::Finish(at) => self.place_job("job.finish_mm", at, tells, |choice| JobChoice {
                finish: Some(at),
                ..choice
            }),
            JobWish::Offset(offset) => self.choose_anew(|choice| JobChoice { offset, ..choice }),
            JobWish::Start(shape) => self.begin_with(shape),
            JobWish::Justify => self.justify_bottom(),
            JobWish::Save => self.save_job(),
            JobWish::Nearest => {
                let (shape, shapes) = self.nearest_path()?;
                let found = format!("{shape} of {shapes}");
                // The console waits for it as long as the server runs.
                drop(tells.send(Happening::Told(Ok(found))));
                Ok(())
            }
        }
    }

    /// Drives from now on, with the machine armed. Whoever drove until now loses it only while the machine
    /// stands.
    fn take_control(self: &Arc<Self>, asker: &Asker) -> Result<(), Problem> {
        let mine = self.drives(&asker.who).is_ok();
        if !mine && matches!(self.state(), State::Running | State::Jogging) {
            return Err(problem(Why::State, "the machine moves: Stop it first"));
        }
        self.act(asker, Act::TakeLease { force: true })?;
        let lease = self.hub.read(|now| now.lease.as_ref().map_or(0, |lease| lease.number));
        self.act(asker, Act::Arm { lease }).map(drop)
    }
}
