//! The WebSocket of a page: a snapshot, then changes; requests and their replies.
//!
//! Reading, writing and slow requests are three tasks: a page that does not read what it is told can
//! still stop the machine, and so can one whose drawing operation takes a while.

use super::guard::Caller;
use crate::app::App;
use crate::asker::Asker;
use crate::hub::text;
use axum::Extension;
use axum::extract::State;
use axum::extract::ws::{Message, WebSocket, WebSocketUpgrade};
use axum::response::Response;
use futures_util::stream::{SplitSink, SplitStream};
use futures_util::{SinkExt, StreamExt};
use kerf_wire::{Act, Problem, Reply, Request, ToPage, Who, Why};
use std::sync::Arc;
use std::time::Duration;
use tokio::sync::broadcast::{Receiver, error::RecvError};
use tokio::sync::mpsc::{UnboundedReceiver, UnboundedSender, unbounded_channel};
use tokio::time::{Instant, interval, timeout};

/// A page that takes nothing for so long has gone.
const PATIENCE: Duration = Duration::from_secs(10);
/// How often a page is asked whether it is there.
const BEAT: Duration = Duration::from_secs(2);
/// Longest message of a page, bytes.
const LONGEST: usize = 4 << 20;

/// Makes a request a socket.
pub async fn socket(
    State(app): State<Arc<App>>,
    Extension(caller): Extension<Caller>,
    upgrade: WebSocketUpgrade,
) -> Response {
    let upgrade = upgrade.max_message_size(LONGEST).max_frame_size(LONGEST);
    upgrade.on_upgrade(move |socket| serve(app, caller, socket))
}

async fn serve(app: Arc<App>, caller: Caller, socket: WebSocket) {
    let name = caller.device.as_ref().map_or(String::new(), |(_, name)| name.clone());
    let who = app.pages.add(caller.role.unwrap_or_default(), name);
    app.tell_clients();
    let (write, read) = socket.split();
    let (replies, outgoing) = unbounded_channel();
    let (slow, waiting) = unbounded_channel();
    let mut writing =
        tokio::spawn(writer(app.clone(), who.clone(), caller.clone(), write, outgoing));
    let working = tokio::spawn(worker(app.clone(), waiting, replies.clone()));
    let page = Page { app: app.clone(), who: who.clone(), replies, slow };
    tokio::select! {
        () = page.listen(read) => {}
        _ = &mut writing => {}
    }
    // The connection ends with its page: who is not heard any more is told nothing, and sees so.
    writing.abort();
    working.abort();
    app.pages.remove(who.client);
    app.unlocked.remove(who.client);
    app.gone(who.client);
    app.tell_clients();
}

/// Who reads what a page sends.
struct Page {
    app: Arc<App>,
    who: Who,
    replies: UnboundedSender<Reply>,
    slow: UnboundedSender<(Asker, Request)>,
}

impl Page {
    async fn listen(self, mut read: SplitStream<WebSocket>) {
        // Browsers answer the beat; who does not has gone, whatever the network says.
        while let Ok(Some(Ok(message))) = timeout(PATIENCE, read.next()).await {
            match message {
                Message::Text(text) => self.request(&text),
                Message::Close(_) => break,
                _ => {}
            }
        }
    }

    fn request(&self, text: &str) {
        let asker = self.app.hears(&self.who);
        match serde_json::from_str::<Request>(text) {
            Err(error) => {
                let problem = Problem { why: Why::Malformed, text: error.to_string() };
                self.reply(Reply { id: 0, problem: Some(problem), notes: Vec::new() });
            }
            Ok(request) if is_slow(&request.act) => drop(self.slow.send((asker, request))),
            Ok(request) => self.reply(answer(&self.app, &asker, request)),
        }
    }

    fn reply(&self, reply: Reply) {
        // A writer that has gone ends the page.
        drop(self.replies.send(reply));
    }
}

/// What reads files, programs or drawings; the rest is done at once.
const fn is_slow(act: &Act) -> bool {
    matches!(
        act,
        Act::Open { .. }
            | Act::Parameters { .. }
            | Act::Folder { .. }
            | Act::KeepOrigin
            | Act::SaveJob
            | Act::TakeShapeBack
            | Act::Set { .. }
            | Act::Run { .. }
            | Act::TakeUp { .. }
            | Act::Command { .. }
            | Act::Draw { .. }
    )
}

fn answer(app: &Arc<App>, asker: &Asker, request: Request) -> Reply {
    match app.act(asker, request.act) {
        Ok(notes) => Reply { id: request.id, problem: None, notes },
        Err(problem) => Reply { id: request.id, problem: Some(problem), notes: Vec::new() },
    }
}

/// Does slow requests one after the other.
async fn worker(
    app: Arc<App>,
    mut requests: UnboundedReceiver<(Asker, Request)>,
    replies: UnboundedSender<Reply>,
) {
    while let Some((asker, request)) = requests.recv().await {
        let app = app.clone();
        let done = tokio::task::spawn_blocking(move || answer(&app, &asker, request)).await;
        if let Ok(reply) = done {
            drop(replies.send(reply));
        }
    }
}

/// Sends a page what it is told, until it has gone or its device is revoked.
async fn writer(
    app: Arc<App>,
    who: Who,
    caller: Caller,
    mut write: SplitSink<WebSocket, Message>,
    mut replies: UnboundedReceiver<Reply>,
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
                Ok(change) => Message::Text(change.to_string().into()),
                Err(RecvError::Lagged(_)) => match begin(&app, &who, &mut write).await {
                    Some(anew) => {
                        changes = anew;
                        continue;
                    }
                    None => return,
                },
                Err(RecvError::Closed) => return,
            },
            Some(reply) = replies.recv() => {
                Message::Text(text(&ToPage::Reply(reply)).to_string().into())
            }
            _ = beat.tick() => Message::Ping(Vec::new().into()),
        };
        if !send(&mut write, message).await {
            return;
        }
    }
}

/// Sends the snapshot; gives what changes after it.
async fn begin(
    app: &App,
    who: &Who,
    write: &mut SplitSink<WebSocket, Message>,
) -> Option<Receiver<Arc<str>>> {
    let (snapshot, changes) = app.hub.listen();
    let first = ToPage::Snapshot { who: who.clone(), snapshot: Box::new(snapshot) };
    send(write, Message::Text(text(&first).to_string().into())).await.then_some(changes)
}

async fn send(write: &mut SplitSink<WebSocket, Message>, message: Message) -> bool {
    let until = Instant::now() + PATIENCE;
    matches!(tokio::time::timeout_at(until, write.send(message)).await, Ok(Ok(())))
}
