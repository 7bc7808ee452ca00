//! Grants the requests of the console, as if whoever pressed its keys had asked for them at a page.

use super::Happening;
use crate::app::App;
use crate::asker::Asker;
use crate::gate::Demand;
use crate::machine::Order;
use crate::people::Grip;
use crate::refusal::problem;
use kerf_handconsole::{ConsoleRequest, JobRequest};
use kerf_machine::Errand;
use kerf_wire::{Act, Change, FileParameters, JobChoice, Look, Looked, Problem, State, Why};
use std::sync::Arc;
use std::sync::mpsc::Sender;

/// Grants a request, if whoever has it may have that done.
///
/// # Errors
/// Why not.
pub fn grant(
    app: &Arc<App>,
    asker: &Asker,
    grip: Grip,
    request: ConsoleRequest,
    tells: &Sender<Happening>,
) -> Result<(), Problem> {
    let who = &asker.who;
    app.gate(who, Demand::Console(&request))?;
    let act = match request {
        ConsoleRequest::Stop => Act::Stop,
        ConsoleRequest::Acknowledge => Act::Acknowledge,
        ConsoleRequest::TakeControl => return take_control(app, asker),
        ConsoleRequest::Open(name) => Act::Open { name, parameters: FileParameters::default() },
        ConsoleRequest::Resume => Act::Resume { lease: app.driving.drives(who)? },
        ConsoleRequest::Start => {
            let (lease, hash) = (app.driving.drives(who)?, app.loader.open.lock().hash.clone());
            Act::Run { lease, hash, step: false }
        }
        ConsoleRequest::Answer(answer) => {
            let question = app.hub.read(|now| now.asked.as_ref().map(|asked| asked.number));
            Act::Answer { question: question.unwrap_or_default(), answer }
        }
        ConsoleRequest::Set(settings) => return app.settings.hold(&settings, tells),
        ConsoleRequest::KeepSettings => return app.orders.order(Order::Keep(tells.clone())),
        ConsoleRequest::Job(request) => return grant_of_job(app, request, tells),
        ConsoleRequest::AddShape(shape) => {
            let added = app.jobs.add_shape(shape)?;
            // The console waits for it as long as the server runs.
            drop(tells.send(Happening::Outcome(Ok(added))));
            return Ok(());
        }
        ConsoleRequest::Look(at) => {
            look_at(app, at);
            return Ok(());
        }
        ConsoleRequest::Jog(held) => {
            return app.hands.jog(asker, grip, errand(app, Errand::Held(held), tells));
        }
        ConsoleRequest::Go(to) => return app.orders.order_of(asker, errand(app, to, tells)),
    };
    app.act(asker, act).map(drop)
}

/// Pages have something else in sight.
fn look_at(app: &App, at: Look) {
    app.hub.changing(|now| {
        let number = now.looked.map_or(1, |looked| looked.number + 1);
        vec![Change::Looked { looked: Some(Looked { number, at }) }]
    });
}

fn errand(app: &App, errand: Errand, tells: &Sender<Happening>) -> Order {
    Order::Hand { errand, machine: Box::new(app.loader.machine_by_hand()), tells: tells.clone() }
}

/// Does something about the open job.
fn grant_of_job(
    app: &Arc<App>,
    request: JobRequest,
    tells: &Sender<Happening>,
) -> Result<(), Problem> {
    match request {
        JobRequest::Origin(at) => app.jobs.place_job("job.origin_mm", at, tells, |choice| {
            JobChoice { origin: Some(at), ..choice }
        }),
        JobRequest::Finish(at) => app.jobs.place_job("job.finish_mm", at, tells, |choice| {
            JobChoice { finish: Some(at), ..choice }
        }),
        JobRequest::Offset(offset) => app.jobs.choose_anew(|choice| JobChoice { offset, ..choice }),
        JobRequest::Start(shape) => app.jobs.begin_with(shape),
        JobRequest::Justify => app.jobs.justify_bottom(),
        JobRequest::Save => app.jobs.save_job(),
        JobRequest::Nearest => {
            let (shape, shapes) = app.jobs.nearest_path()?;
            let found = format!("{shape} of {shapes}");
            // The console waits for it as long as the server runs.
            drop(tells.send(Happening::Outcome(Ok(found))));
            Ok(())
        }
    }
}

/// Drives from now on, with the machine armed. Whoever drove until now loses it only while the machine
/// stands.
fn take_control(app: &Arc<App>, asker: &Asker) -> Result<(), Problem> {
    let mine = app.driving.drives(&asker.who).is_ok();
    if !mine && matches!(app.hub.state(), State::Running | State::Jogging) {
        return Err(problem(Why::State, "the machine moves: Stop it first"));
    }
    app.act(asker, Act::TakeLease { force: true })?;
    let lease = app.hub.read(|now| now.lease.as_ref().map_or(0, |lease| lease.number));
    app.act(asker, Act::Arm { lease }).map(drop)
}
