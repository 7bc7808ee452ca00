//! STOP's own way: a listener and a thread that do nothing else, and wait for nobody.

use super::halt::{Pressed, StopPress, heard};
use super::presses::Presses;
use crate::app::App;
use crate::http::{Allowance, Caller, DoorSlot, guard_of_stop, serve};
use crate::hub::text;
use crate::refusal::problem;
use axum::extract::ws::{Message, WebSocket, WebSocketUpgrade};
use axum::extract::{Path, Query, State};
use axum::http::StatusCode;
use axum::middleware::from_fn_with_state;
use axum::response::{IntoResponse, Response};
use axum::routing::{any, post};
use axum::{Extension, Json, Router};
use futures_util::FutureExt;
use kerf_wire::{Reply, ToPage, Why};
use serde::Deserialize;
use std::io;
use std::net::SocketAddr;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::Duration;
use tokio::net::TcpListener;
use tokio::runtime::{Builder, Handle};
use tokio::sync::{mpsc, oneshot};
use tokio::time::{Instant, interval, timeout};

/// Heartbeat (keepalive): the time between two questions to a page whether it is there.
const BEAT: Duration = Duration::from_secs(2);
/// Longest time that a page may not answer.
const PATIENCE: Duration = Duration::from_secs(10);
/// Longest message, bytes.
const LONGEST: usize = 4096;
/// Crowds of messages in a second, and at once. What has come meanwhile is read as one crowd, so that no press waits
/// longer than for the next: a late one would stop what was begun behind it.
const A_SECOND: u32 = 20;
const AT_ONCE: u32 = 20;
/// Messages of a crowd at most.
const CROWD: usize = 1000;
/// Replies that a page is owed.
const OWED: usize = 32;

/// Answer to whoever asks for anything else.
const NOTHING_ELSE: &str =
    "only stop, hold, disarm and jogStop are heard here: ask the console for the rest";

/// The way, until it is dropped.
#[derive(Debug)]
pub struct StopWay {
    _ends: oneshot::Sender<()>,
}

/// Port at which the way listens.
#[derive(Debug)]
pub struct Door {
    /// The port of the console.
    console: u16,
    /// Its own.
    pub port: u16,
    listener: std::net::TcpListener,
}

impl Door {
    /// Beside a console: at the port above its own where that is free.
    ///
    /// # Errors
    /// No port is free.
    pub fn beside(console: SocketAddr) -> io::Result<Self> {
        let at = |port| std::net::TcpListener::bind(SocketAddr::new(console.ip(), port));
        let next = console.port().checked_add(1).map_or_else(|| at(0), at);
        let listener = next.or_else(|_| at(0))?;
        listener.set_nonblocking(true)?;
        let port = listener.local_addr()?.port();
        Ok(Self { console: console.port(), port, listener })
    }
}

/// State of its thread.
#[derive(Clone)]
struct StopRoutes {
    app: Arc<App>,
    /// Does what may wait for others.
    front: Handle,
}

impl StopWay {
    /// Begins its thread.
    ///
    /// # Errors
    /// The system gives none.
    pub fn begin(app: &Arc<App>, door: Door, front: Handle) -> io::Result<Self> {
        let Door { console, listener, .. } = door;
        let runtime = Builder::new_current_thread().enable_all().build()?;
        let router = StopRoutes { app: app.clone(), front }.router(console);
        let (ends, ended) = oneshot::channel();
        let work = async move {
            let Ok(listener) = TcpListener::from_std(listener) else { return };
            tokio::select! {
                () = serve(listener, router) => {}
                // The server has ended.
                _ = ended => {}
            }
        };
        let thread = thread::Builder::new().name("stop".into());
        thread.spawn(move || runtime.block_on(work))?;
        Ok(Self { _ends: ends })
    }
}

/// Whose page opens a socket.
#[derive(Debug, Default, Deserialize)]
struct Opens {
    /// Its number on the console's socket.
    #[serde(default)]
    client: u32,
}

impl StopRoutes {
    fn router(self, console: u16) -> Router {
        let guard = from_fn_with_state((self.app.clone(), console), guard_of_stop);
        Router::new()
            .route("/stop", any(socket))
            .route("/api/do/{act}", post(act))
            .fallback(|| async { (StatusCode::NOT_FOUND, NOTHING_ELSE) })
            .layer(guard)
            .with_state(self)
    }

    /// Does what was pressed, and has the rest of it done elsewhere. Gives the reply as soon as the machine has heard.
    async fn press(self, Pressed { halt, id }: Pressed, client: u32) -> Reply {
        let (stop, app) = (halt.press(&self.app, client), self.app.clone());
        self.front.spawn(async move { halt.settle(&app) });
        heard(&self.app, stop).await;
        Reply { id, problem: None, notes: Vec::new(), clock_ms: None }
    }
}

/// Carries out what scripts press.
async fn act(
    State(way): State<StopRoutes>,
    Path(name): Path<String>,
    Query(Opens { client }): Query<Opens>,
) -> Response {
    match StopPress::named(&name) {
        Some(halt) => Json(way.press(Pressed { halt, id: 0 }, client).await).into_response(),
        None => (StatusCode::NOT_FOUND, NOTHING_ELSE).into_response(),
    }
}

/// Makes a request a socket.
async fn socket(
    State(way): State<StopRoutes>,
    Extension(caller): Extension<Caller>,
    Extension(place): Extension<DoorSlot>,
    Query(Opens { client }): Query<Opens>,
    upgrade: WebSocketUpgrade,
) -> Response {
    let presses = way.app.pages.presses(client, caller.number()).unwrap_or_default();
    let upgrade = upgrade.max_message_size(LONGEST).max_frame_size(LONGEST);
    let upgrade = upgrade.read_buffer_size(LONGEST).write_buffer_size(LONGEST);
    upgrade.on_upgrade(move |socket| async move {
        Page { way, client, caller, presses }.listen(socket).await;
        drop(place);
    })
}

/// A page that may press.
struct Page {
    way: StopRoutes,
    client: u32,
    caller: Caller,
    presses: Presses,
}

impl Page {
    async fn listen(self, mut socket: WebSocket) {
        let (tell, mut told) = mpsc::channel(OWED);
        let mut beat = interval(BEAT);
        let mut allowance = Allowance::of(A_SECOND, AT_ONCE);
        let mut last = Instant::now();
        let revoked = Arc::<AtomicBool>::default();
        while last.elapsed() < PATIENCE && !revoked.load(Ordering::Relaxed) {
            let out = tokio::select! {
                message = socket.recv() => {
                    let mut next = Some(message);
                    let mut read = 0;
                    while let Some(message) = next {
                        let Some(Ok(message)) = message else { return };
                        self.hear(&message, &tell);
                        read += 1;
                        next = if read < CROWD { socket.recv().now_or_never() } else { None };
                    }
                    last = Instant::now();
                    allowance.take().await;
                    continue;
                }
                Some(reply) = told.recv() => Message::Text(text(&ToPage::Reply(reply))),
                _ = beat.tick() => {
                    self.look(&revoked);
                    Message::Ping(Vec::new().into())
                }
            };
            if !matches!(timeout(PATIENCE, socket.send(out)).await, Ok(Ok(()))) {
                return;
            }
        }
    }

    /// Does what a message presses, whatever its form.
    fn hear(&self, message: &Message, tell: &mpsc::Sender<Reply>) {
        let bytes = match message {
            Message::Text(text) => text.as_bytes(),
            Message::Binary(bytes) => bytes,
            _ => return,
        };
        let Some(pressed) = StopPress::read(bytes) else {
            let problem = Some(problem(Why::Malformed, NOTHING_ELSE));
            return drop(tell.try_send(Reply {
                id: 0,
                problem,
                notes: Vec::new(),
                clock_ms: None,
            }));
        };
        if !self.presses.is_new(pressed.id) {
            let reply = Reply { id: pressed.id, problem: None, notes: Vec::new(), clock_ms: None };
            return drop(tell.try_send(reply));
        }
        let pressing = self.way.clone().press(pressed, self.client);
        let tell = tell.clone();
        // It begins before anything else of this thread does.
        let mut pressing = Box::pin(pressing);
        let first = (&mut pressing).now_or_never();
        if let Some(reply) = first {
            return drop(tell.try_send(reply));
        }
        tokio::spawn(async move { drop(tell.try_send(pressing.await)) });
    }

    /// Has it looked whether the device is still paired: who looks may wait for others, so this thread does not.
    fn look(&self, revoked: &Arc<AtomicBool>) {
        let Some((number, _)) = self.caller.device else { return };
        let (app, revoked) = (self.way.app.clone(), revoked.clone());
        self.way.front.spawn(async move {
            revoked.store(!app.devices.has(number), Ordering::Relaxed);
        });
    }
}
