//! The WebSocket of a page: a snapshot, then changes; requests and their replies.
//!
//! ```text
//!  page ─► reader: only stops? ─► done at once
//!            │ no: its allowance, room for one more reply
//!            ├─ fast ─► done at once ────┐
//!            └─ else ─► pool, in turn ───┴─► replies, bounded ─► writer ─► page
//! ```
//!
//! Reading, writing and what takes longer are apart: a page that does not read what it is told can still stop the machine,
//! and so can one whose drawing operation takes a while. Who asks for more than it may, or does not read its replies, is not
//! read any further until that has changed.

use super::allowance::Allowance;
use super::door::DoorSlot;
use super::guard::Caller;
use super::rest::malformed;
use crate::app::App;
use crate::asker::Asker;
use crate::hub::{Broadcast, text};
use crate::lanes::Lanes;
use crate::stop::{Presses, StopPress, heard};
use axum::Extension;
use axum::extract::State;
use axum::extract::ws::{CloseFrame, Message, WebSocket, WebSocketUpgrade, close_code};
use axum::http::StatusCode;
use axum::response::{IntoResponse, Response};
use futures_util::stream::{SplitSink, SplitStream};
use futures_util::{SinkExt, StreamExt};
use kerf_wire::{Act, Problem, Reply, Request, ToPage, Who};
use std::sync::Arc;
use std::time::Duration;
use tokio::sync::broadcast::{Receiver, error::RecvError};
use tokio::sync::mpsc::{self, OwnedPermit};
use tokio::time::{Instant, interval, timeout};

/// A page that takes nothing for so long has gone.
const PATIENCE: Duration = Duration::from_secs(10);
/// Heartbeat (keepalive): the time between two questions to a page whether it is there.
const BEAT: Duration = Duration::from_secs(2);
/// Longest message of a page, bytes.
const LONGEST: usize = 1 << 20;
/// Bytes that are read or written in one go.
const IN_ONE_GO: usize = 8 << 10;
/// Replies that a page is owed, and what it asked for that is not done yet: then it is read no further.
const OWED: usize = 64;
/// Messages of a page in a second, and at once.
const A_SECOND: u32 = 100;
const AT_ONCE: u32 = 200;

/// Makes a request a socket.
pub async fn socket(
    State(app): State<Arc<App>>,
    Extension(caller): Extension<Caller>,
    Extension(place): Extension<DoorSlot>,
    upgrade: WebSocketUpgrade,
) -> Response {
    let name = caller.device.as_ref().map_or(String::new(), |(_, name)| name.clone());
    let entered = app.pages.enter(caller.role.unwrap_or_default(), name, caller.number());
    let Some((who, presses)) = entered else {
        let text = "this device has too many pages open: close one of them";
        return (StatusCode::SERVICE_UNAVAILABLE, text).into_response();
    };
    // Whoever breaks off before the socket is there has gone too.
    let here = Here { app: app.clone(), client: who.client };
    let upgrade = upgrade.max_message_size(LONGEST).max_frame_size(LONGEST);
    let upgrade = upgrade.read_buffer_size(IN_ONE_GO).write_buffer_size(IN_ONE_GO);
    upgrade.on_upgrade(move |socket| async move {
        serve(app, who, presses, caller, socket).await;
        drop((here, place));
    })
}

/// A page that is connected; it has gone when this is dropped.
struct Here {
    app: Arc<App>,
    client: u32,
}

impl Drop for Here {
    fn drop(&mut self) {
        self.app.pages.remove(self.client);
        self.app.settings.unlocked.remove(self.client);
        self.app.works.give_up(self.client);
        self.app.driving.gone(self.client);
        self.app.driving.tell_clients();
    }
}

async fn serve(app: Arc<App>, who: Who, presses: Presses, caller: Caller, socket: WebSocket) {
    app.driving.tell_clients();
    let (write, read) = socket.split();
    let (replies, outgoing) = mpsc::channel(OWED);
    let mut writing =
        tokio::spawn(writer(app.clone(), who.clone(), caller.clone(), write, outgoing));
    let page = Page { app, who, customer: caller.number(), presses, replies };
    tokio::select! {
        () = page.listen(read) => {}
        _ = &mut writing => {}
    }
    // The connection ends with its page: who is not heard any more is told nothing, and sees so.
    writing.abort();
}

/// Reads what a page sends.
struct Page {
    app: Arc<App>,
    who: Who,
    customer: u32,
    presses: Presses,
    replies: mpsc::Sender<Owed>,
}

/// A reply that a page is owed, or the reason why it is told nothing more.
enum Owed {
    Reply(Reply),
    Leaves(&'static str),
}

impl Page {
    async fn listen(self, mut read: SplitStream<WebSocket>) {
        let mut allowance = Allowance::of(A_SECOND, AT_ONCE);
        // Browsers answer the beat; who does not has gone, whatever the network says.
        while let Ok(Some(Ok(message))) = timeout(PATIENCE, read.next()).await {
            match &message {
                Message::Text(text) if !self.halts(text.as_bytes()) => {
                    allowance.take().await;
                    let Ok(Ok(owed)) =
                        timeout(PATIENCE, self.replies.clone().reserve_owned()).await
                    else {
                        return;
                    };
                    self.request(text, owed);
                }
                Message::Binary(bytes) if !self.halts(bytes) => {
                    self.tell(Owed::Leaves("messages are texts"));
                }
                Message::Close(_) => break,
                _ => allowance.take().await,
            }
        }
    }

    /// Does what a message that only stops asks for, before anything else; returns `true` if it was one.
    fn halts(&self, message: &[u8]) -> bool {
        let Some(pressed) = StopPress::read(message) else { return false };
        let reply =
            Owed::Reply(Reply { id: pressed.id, problem: None, notes: Vec::new(), clock_ms: None });
        if !self.presses.is_new(pressed.id) {
            self.tell(reply);
            return true;
        }
        let stop = pressed.halt.press(&self.app, self.who.client);
        pressed.halt.settle(&self.app);
        let (app, replies) = (self.app.clone(), self.replies.clone());
        tokio::spawn(async move {
            heard(&app, stop).await;
            // A page that reads nothing is told nothing; it has stopped the machine all the same.
            drop(replies.try_send(reply));
        });
        true
    }

    fn request(&self, text: &str, owed: OwnedPermit<Owed>) {
        let asker = self.app.hears(&self.who);
        let request = match serde_json::from_str::<Request>(text) {
            Err(error) => {
                let problem = Some(malformed(&error));
                owed.send(Owed::Reply(Reply { id: 0, problem, notes: Vec::new(), clock_ms: None }));
                return;
            }
            Ok(request) => request,
        };
        let Some(lane) = request.act.lane() else {
            owed.send(Owed::Reply(answer(&self.app, &asker, request)));
            return;
        };
        let (app, id) = (self.app.clone(), request.id);
        let awaited = app.works.begin(self.who.client, &request.act);
        let asker = asker.awaiting(awaited);
        let work = move || drop(owed.send(Owed::Reply(answer(&app, &asker, request))));
        if let Err(problem) = self.app.pool.give(lane, self.customer, work) {
            self.tell(Owed::Reply(refused(id, problem)));
        }
    }

    /// Tells a page something that it has room for.
    fn tell(&self, owed: Owed) {
        drop(self.replies.try_send(owed));
    }
}

const fn refused(id: u32, problem: Problem) -> Reply {
    Reply { id, problem: Some(problem), notes: Vec::new(), clock_ms: None }
}

fn answer(app: &Arc<App>, asker: &Asker, request: Request) -> Reply {
    let Request { id, act } = request;
    let clock_ms = matches!(act, Act::Ping).then(|| app.clock.ms());
    match app.act(asker, act) {
        Ok(notes) => Reply { id, problem: None, notes, clock_ms },
        Err(problem) => refused(id, problem),
    }
}

/// Sends a page what it is told, until it has gone or its device is revoked.
async fn writer(
    app: Arc<App>,
    who: Who,
    caller: Caller,
    mut write: SplitSink<WebSocket, Message>,
    mut replies: mpsc::Receiver<Owed>,
) {
    let mut beat = interval(BEAT);
    let mut changes = match begin(&app, &who, &mut write).await {
        Some(changes) => changes,
        None => return,
    };
    let paired = || caller.device.as_ref().is_none_or(|(number, _)| app.devices.has(*number));
    while paired() {
        let message = tokio::select! {
            // What an act changed is told before its reply.
            biased;
            change = changes.recv() => match change {
                Ok(change) => Message::Text(change.text()),
                Err(RecvError::Lagged(_)) => match begin(&app, &who, &mut write).await {
                    Some(anew) => {
                        changes = anew;
                        continue;
                    }
                    None => return,
                },
                Err(RecvError::Closed) => return,
            },
            Some(owed) = replies.recv() => match owed {
                Owed::Reply(reply) => Message::Text(text(&ToPage::Reply(reply))),
                Owed::Leaves(reason) => closing(reason),
            },
            _ = beat.tick() => Message::Ping(Vec::new().into()),
        };
        let leaves = matches!(message, Message::Close(_));
        if !send(&mut write, message).await || leaves {
            return;
        }
    }
}

/// Returns the last message to a page: the reason why it is told nothing more.
fn closing(reason: &'static str) -> Message {
    Message::Close(Some(CloseFrame { code: close_code::POLICY, reason: reason.into() }))
}

/// Sends the snapshot; gives what changes after it.
async fn begin(
    app: &App,
    who: &Who,
    write: &mut SplitSink<WebSocket, Message>,
) -> Option<Receiver<Arc<Broadcast>>> {
    let (snapshot, changes) = app.hub.listen();
    let snapshot = Box::new(Arc::unwrap_or_clone(snapshot));
    let first = ToPage::Snapshot { who: who.clone(), snapshot };
    send(write, Message::Text(text(&first))).await.then_some(changes)
}

async fn send(write: &mut SplitSink<WebSocket, Message>, message: Message) -> bool {
    let until = Instant::now() + PATIENCE;
    matches!(tokio::time::timeout_at(until, write.send(message)).await, Ok(Ok(())))
}
