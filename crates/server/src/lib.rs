//! Kerf's server: the machine, its files and drawings behind HTTP and one WebSocket.
//!
//! ```text
//!  page ── /ws, /api ──► guard ──► App::act ──┬─ orders ──► machine's thread (one owner, kerf-control)
//!    ▲    └─ /stop: a way of its own for STOP ├─ Link: stop, hold, answers, renewals of a jog
//!    └────────── Hub: snapshot, changes ◄─────┴─ drawing, files, previews
//! ```
//!
//! - The server owns all state; a page is a view. [`hub`] holds what pages show and tells them what
//!   changes; the messages are those of [`kerf_wire`].
//! - One thread owns the machine ([`machine`]). It runs one thing after the other; what pages want of
//!   a run that goes on reaches it through a [`Link`](machine::Link), which it looks at several times
//!   between two pictures.
//! - Who may do what, and when, is one list in [`gate`]. Who is let in at all is decided in `http::guard`.
//! - What is served has parts ([`app`]): the way to the machine, settings, files, drawings, jobs, runs, hands. Each knows
//!   only what it is lent; the order in which their locks may be held is told in [`locks`].
//! - Previews are runs on copies ([`preview`]); files lie in the part folder and nowhere else
//!   ([`files`]).

mod act_checks;
mod acts;
mod app;
mod asker;
mod awaited;
mod by_hand;
mod called_files;
mod clock;
mod configure;
mod controller_card;
mod counted;
mod descriptors;
mod desk;
mod digested;
mod digitized;
mod draft;
mod driving;
mod driving_turn;
mod file_kind;
mod files;
mod gate;
mod handconsole;
mod hands;
mod height_map;
mod help_wanted;
mod history;
mod http;
mod hub;
mod interrupted;
mod job;
mod job_by_hand;
mod job_findings;
mod lanes;
mod last_runs;
mod line_log;
mod loader;
mod locks;
mod machine;
mod memory;
mod names;
mod open;
mod operations;
mod orders;
mod part_files;
mod paths;
mod people;
mod pool;
mod preview;
mod priority;
mod problems;
mod protect;
mod reading;
mod refusal;
mod runs;
mod saving;
mod setting_changes;
mod setup;
mod stop;
#[cfg(test)]
mod testing;
mod texts;
mod thumbnails;
mod to_wire;
mod tools;
mod unsaved_shapes;
mod webhook;
#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod who_may_what;
mod wirings;
mod work;

pub use http::{describe, paths};
pub use kerf_wire::{Role, ServedMachine, StartUp};
pub use people::TOKEN_FILE;
pub use setup::{Builders, Options, Workshop};
pub use webhook::Webhook;

use app::{App, Parts};
use files::PartFolder;
use hub::Hub;
use kerf_control::controller::Controller;
use kerf_wire::{Change, Problem, Request, Snapshot, Who, Why};
use machine::{LastState, Link, Order, Owner, Screen};
use pool::{KERF, Lane};
use priority::Yields;
use problems::ProblemLog;
use refusal::problem;
use setting_changes::SettingChanges;
use std::io;
use std::net::{IpAddr, Ipv4Addr, Ipv6Addr, SocketAddr};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::sync::{Arc, Mutex, OnceLock, PoisonError, Weak};
use std::thread::{self, JoinHandle};
use std::time::Duration;
use stop::{Door, StopWay};
use tokio::net::TcpListener;
use tokio::runtime::{Builder, Runtime};

/// Time between two looks whether the server is to end.
const LOOK: Duration = Duration::from_millis(100);

/// A server that runs, until it is dropped.
pub struct Server {
    /// Address at which it listens.
    pub address: SocketAddr,
    app: Arc<App>,
    /// Told when a part file closed Kerf.
    closed: Mutex<Receiver<()>>,
    /// The thread that drives the machine.
    machine: Mutex<Option<JoinHandle<()>>>,
    /// Hears STOP, whatever else is asked.
    _stop_way: StopWay,
    /// Carries the connections.
    runtime: Option<Runtime>,
}

impl Server {
    /// Starts a server.
    ///
    /// # Errors
    /// The address cannot be listened on, or is reached from other machines without leave; the part
    /// folder is not there; the machine's settings cannot be read.
    pub fn start(options: Options, builders: Builders) -> io::Result<Self> {
        if !options.listen.ip().is_loopback() && !options.lan {
            let text = "other machines could reach this address: that takes --lan";
            return Err(io::Error::new(io::ErrorKind::PermissionDenied, text));
        }
        descriptors::raise();
        let runtime = Builder::new_multi_thread()
            .enable_all()
            .thread_name("front")
            .on_thread_start(|| Yields::Front.hold())
            .build()?;
        let listener = runtime.block_on(TcpListener::bind(options.listen))?;
        let address = listener.local_addr()?;
        let door = Door::beside(address)?;
        let (closing, closed) = channel();
        let closing = options.closes_with_program.then_some(closing);
        let url = format!("http://{}", from_here(address));
        let (app, machine) = machine_and_app(options, builders, (url, door.port), closing)?;
        app.drawing.keep_drafts();
        app.loader.added.tell();
        texts::tell_unread(&app.texts, &app.hub);
        handconsole::begin(&app);
        if let Some(name) = app.options.open.clone() {
            drop(app.loader.open_file(&name));
        }
        app.start_up();
        if let Some(webhook) = app.options.webhook.clone() {
            runtime.spawn(webhook.follow(Arc::downgrade(&app.hub)));
        }
        runtime.spawn(driving::watch(Arc::downgrade(&app.driving)));
        let stop_way = StopWay::begin(&app, door, runtime.handle().clone())?;
        runtime.spawn(app.memory.clone().watch(Arc::downgrade(&app.hub)));
        runtime.spawn(http::serve(listener, http::router(app.clone())));
        let (closed, machine) = (Mutex::new(closed), Mutex::new(Some(machine)));
        Ok(Self { address, app, closed, machine, _stop_way: stop_way, runtime: Some(runtime) })
    }

    /// The address by which whoever sits at this computer gets in. Where others may connect it holds a token.
    pub fn way_in(&self) -> String {
        let Some(here) = &self.app.here else { return format!("http://{}", self.address) };
        format!("http://{}/?{}={}", from_here(self.address), http::IN_ADDRESS, here.token())
    }

    /// A code by which a device is paired that asks for it.
    pub fn show_code(&self, role: Role) -> Option<String> {
        self.app.devices.show_code(role).ok()
    }

    /// Does what a page on this computer asks for: a request as it would come over the socket. Gives what was noticed.
    ///
    /// # Errors
    /// It makes no sense, or is not done.
    pub fn ask(&self, role: Role, request: &str) -> Result<Vec<String>, Problem> {
        let read = serde_json::from_str::<Request>(request);
        let request = read.map_err(|error| problem(Why::Malformed, error.to_string()))?;
        let asker = self.app.hears(&Who { client: 0, role, device: String::new() });
        self.app.act(&asker, request.act)
    }

    /// Tells pages which machines are served together.
    pub fn tell_together(&self, together: Vec<ServedMachine>) {
        self.app.hub.change(vec![Change::Together { together }]);
    }

    /// Stops the machine, as the button does.
    pub fn stop_machine(&self) {
        self.app.link.stop();
    }

    /// Returns `true` while the machine moves.
    pub fn moves(&self) -> bool {
        self.app.hub.state() == kerf_wire::State::Running
    }

    /// Tells pages that files of the part folder have changed.
    pub fn files_changed(&self) {
        self.app.files.changed();
    }

    /// Waits until the shutdown of the server: a part file closes it, or it is to end. Then what runs is stopped first,
    /// as the button does, and nobody is asked.
    pub fn wait(&self, is_to_end: impl Fn() -> bool) {
        let closed = self.closed.lock().unwrap_or_else(PoisonError::into_inner);
        while !is_to_end() {
            match closed.recv_timeout(LOOK) {
                Ok(()) => return,
                Err(RecvTimeoutError::Timeout) => {}
                // No part file closes this one.
                Err(RecvTimeoutError::Disconnected) => thread::sleep(LOOK),
            }
        }
        self.app.link.leave();
        let machine = self.machine.lock().unwrap_or_else(PoisonError::into_inner).take();
        // A machine whose thread has failed moves no more.
        machine.map(JoinHandle::join);
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        self.stop_machine();
        // Where the disk refuses, pages were told when it did so first.
        drop(self.app.drawing.write_draft());
        if let Some(runtime) = self.runtime.take() {
            runtime.shutdown_background();
        }
    }
}

/// The address by which this computer reaches what listens at an address.
fn from_here(mut address: SocketAddr) -> SocketAddr {
    match address.ip() {
        IpAddr::V4(ip) if ip.is_unspecified() => address.set_ip(Ipv4Addr::LOCALHOST.into()),
        IpAddr::V6(ip) if ip.is_unspecified() => address.set_ip(Ipv6Addr::LOCALHOST.into()),
        _ => {}
    }
    address
}

/// What requests share, once it is made.
type AppSlot = Arc<OnceLock<Weak<App>>>;

/// Returns what follows a run: the machine waits for nobody who looks at files or drawings.
fn after_runs(app: AppSlot) -> Box<dyn Fn(Option<String>) + Send> {
    Box::new(move |made| {
        let Some(app) = app.get().and_then(Weak::upgrade) else { return };
        let (later, own) = (app.clone(), made.clone());
        let given = app.pool.give(Lane::Short, KERF, move || later.after_run(own));
        if given.is_err() {
            app.after_run(made);
        }
    })
}

/// Returns what shows the file that a program calls.
fn screen(app: AppSlot) -> Screen {
    Screen(Arc::new(move |called| {
        let Some(app) = app.get().and_then(Weak::upgrade) else { return };
        let (later, file) = (app.clone(), called);
        // Where too much is being done the picture stays what it was: the machine goes on.
        drop(app.pool.give(Lane::Short, KERF, move || later.loader.show_called(file)));
    }))
}

/// Starts the machine's thread, and makes what requests share.
fn machine_and_app(
    options: Options,
    builders: Builders,
    (url, stop_port): (String, u16),
    closing: Option<Sender<()>>,
) -> io::Result<(Arc<App>, JoinHandle<()>)> {
    let mut snapshot = Snapshot { kerf: env!("CARGO_PKG_VERSION").into(), ..Snapshot::default() };
    (snapshot.drawing_only, snapshot.stop_port) = (options.drawing_only, stop_port);
    snapshot.start.clone_from(&options.start);
    let hub = Arc::new(Hub::new(snapshot));
    let (link, left) = (Arc::<Link>::default(), Arc::<Mutex<LastState>>::default());
    let (orders, waiting) = channel();
    let app = AppSlot::default();
    let (done, screen) = (after_runs(app.clone()), screen(app.clone()));
    let parts = PartFolder::new(&options.parts)?;
    let (ready, started) = channel();
    let (owned, build) = ((hub.clone(), link.clone(), left.clone()), builders.workshop.clone());
    let previews = builders.preview.clone();
    let (rate, data) = (options.rate, options.data.clone());
    let changes = Arc::new(SettingChanges::new(&data));
    let noted = changes.clone();
    let run = move |waiting: Receiver<Order>| {
        let workshop = match build() {
            Ok(mut workshop) => {
                workshop.workspace.reached_at(&url);
                workshop.workspace.asks_for_spindle_anew();
                owned.0.keep(ProblemLog::begin(&data, workshop.started));
                workshop
            }
            Err(error) => return drop(ready.send(Err(error))),
        };
        let (hub, link, left) = owned;
        let mut owner = Owner {
            hub,
            link,
            workshop,
            parts,
            left,
            rate,
            done,
            changes: noted,
            screen,
            closing,
            asked: 0,
            run: 0,
            looked: None,
            locked: None,
            waits: None,
            previews,
        };
        owner.tell_found();
        owner.begin();
        let log = owner.workshop.controller.as_ref().and_then(Controller::log).cloned();
        drop(ready.send(Ok(log)));
        owner.work(&waiting);
    };
    let machine = thread::Builder::new().name("machine".into()).spawn(move || run(waiting))?;
    let log = started.recv().map_err(io::Error::other)??;
    let parts = Parts { hub, link, orders, left, builders, changes, log };
    let made = Arc::new(App::new(options, parts)?);
    drop(app.set(Arc::downgrade(&made)));
    Ok((made, machine))
}
