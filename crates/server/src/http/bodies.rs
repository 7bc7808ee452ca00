//! Bodies of requests: how much of them the server holds at once, and how long one may take to come.

use axum::body::{Body, HttpBody};
use axum::extract::Request;
use axum::http::StatusCode;
use axum::http::header::CONTENT_LENGTH;
use futures_util::{StreamExt, stream};
use std::io;
use std::sync::Arc;
use std::time::Duration;
use tokio::sync::{OwnedSemaphorePermit, Semaphore};
use tokio::time::{Instant, timeout, timeout_at};

/// Longest file that is taken over the network, bytes.
pub const FILE: usize = 128 << 20;
/// Longest text of an editor, bytes.
pub const TEXT: usize = 4 << 20;
/// Longest act, bytes.
pub const ACT: usize = 1 << 20;
/// Longest of anything else, bytes.
pub const SHORT: usize = 64 << 10;

/// A body is counted in pieces of so many bytes.
const PIECE: u64 = 64 << 10;
/// Longest wait for room.
const PATIENCE: Duration = Duration::from_secs(10);
/// A body comes within this time, and longer by its length at so many bytes a second.
const TIME: Duration = Duration::from_secs(15);
const A_SECOND: u64 = 20_000;

/// Room for bodies: all that are held at once are no longer than the longest file.
#[derive(Clone, Debug)]
pub struct Bodies(Arc<Semaphore>);

impl Default for Bodies {
    fn default() -> Self {
        Self(Arc::new(Semaphore::new(pieces(FILE as u64) as usize)))
    }
}

/// Room that is held as long as its request is answered.
pub type Room = Option<OwnedSemaphorePermit>;

impl Bodies {
    /// Waits for room for the body of a request, which has to come in time from now on.
    ///
    /// # Errors
    /// There is none for a while.
    pub async fn admit(
        &self,
        request: Request,
    ) -> Result<(Request, Room), (StatusCode, &'static str)> {
        if request.body().is_end_stream() {
            return Ok((request, None));
        }
        let told = request.headers().get(CONTENT_LENGTH);
        let told = told.and_then(|length| length.to_str().ok()?.parse::<u64>().ok());
        // Who does not say how long it is may send as much as the longest.
        let length = told.unwrap_or(FILE as u64).min(FILE as u64);
        let room = match pieces(length) {
            1 => None,
            many => Some(self.room(many).await?),
        };
        let until = Instant::now() + TIME + Duration::from_secs(length / A_SECOND);
        Ok((request.map(|body| in_time(body, until)), room))
    }

    async fn room(&self, pieces: u32) -> Result<OwnedSemaphorePermit, (StatusCode, &'static str)> {
        let room = timeout(PATIENCE, self.0.clone().acquire_many_owned(pieces)).await;
        let text =
            "other files are being received, and there is no room for this one: send it again";
        room.ok().and_then(Result::ok).ok_or((StatusCode::SERVICE_UNAVAILABLE, text))
    }
}

fn pieces(length: u64) -> u32 {
    length.div_ceil(PIECE).max(1) as u32
}

/// The same body, which breaks off where it takes longer.
fn in_time(body: Body, until: Instant) -> Body {
    let late =
        || io::Error::new(io::ErrorKind::TimedOut, "the body of this request came too slowly");
    let next = move |mut rest: axum::body::BodyDataStream| async move {
        match timeout_at(until, rest.next()).await {
            Ok(piece) => piece.map(|piece| (piece.map_err(io::Error::other), rest)),
            Err(_) => Some((Err(late()), rest)),
        }
    };
    Body::from_stream(stream::unfold(body.into_data_stream(), next))
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use futures_util::FutureExt;

    fn request(length: Option<u64>) -> Request {
        let mut request = Request::new(Body::from("a body"));
        if let Some(length) = length {
            request.headers_mut().insert(CONTENT_LENGTH, length.into());
        }
        request
    }

    fn admit(bodies: &Bodies, length: Option<u64>) -> Option<Room> {
        Some(bodies.admit(request(length)).now_or_never()?.unwrap().1)
    }

    #[tokio::test]
    async fn so_much_is_held_at_once_and_given_back() {
        let bodies = Bodies::default();
        let most = FILE as u64;
        let first = admit(&bodies, Some(most / 2)).unwrap();
        let second = admit(&bodies, Some(most / 2)).unwrap();
        assert!(admit(&bodies, Some(2 * PIECE)).is_none(), "it waits");
        assert!(admit(&bodies, Some(6)).is_some(), "short ones do not");
        drop(first);
        assert!(admit(&bodies, Some(2 * PIECE)).is_some());
        drop(second);
        let unknown = admit(&bodies, None).unwrap();
        assert!(admit(&bodies, Some(2 * PIECE)).is_none(), "one of unknown length takes all");
        drop(unknown);
        assert!(admit(&bodies, Some(10 * most)).is_some(), "its route refuses it");
    }

    #[tokio::test]
    async fn a_body_that_comes_too_slowly_breaks_off() {
        let until = Instant::now() + Duration::from_millis(20);
        let never = Body::from_stream(stream::pending::<io::Result<Vec<u8>>>());
        let read = axum::body::to_bytes(in_time(never, until), 100).await;
        assert!(read.is_err());
    }
}
