//! The server's face to the network.
//!
//! ```text
//!  request ─► guard: Host, Origin, who is it? ─► route ─► App
//!                └─ refused                         └─ /ws: socket
//! ```

mod assets;
mod files;
mod guard;
mod language;
mod media;
mod people;
mod preview;
mod registry;
mod rest;
mod routes;
mod socket;
mod texts;

pub use guard::Peer;
pub use routes::{describe, paths, router};

use axum::Json;
use axum::http::StatusCode;
use axum::response::{IntoResponse, Response};
use kerf_wire::{Problem, Why};

/// A problem as an answer to a request.
#[derive(Debug)]
pub struct Refused(pub Problem);

impl From<Problem> for Refused {
    fn from(problem: Problem) -> Self {
        Self(problem)
    }
}

impl IntoResponse for Refused {
    fn into_response(self) -> Response {
        let status = match self.0.why {
            Why::Malformed => StatusCode::BAD_REQUEST,
            Why::Password => StatusCode::UNAUTHORIZED,
            Why::Role | Why::Lease | Why::Disarmed => StatusCode::FORBIDDEN,
            Why::File => StatusCode::NOT_FOUND,
            Why::State | Why::Changed | Why::Replaces | Why::Late => StatusCode::CONFLICT,
            Why::Mistake => StatusCode::UNPROCESSABLE_ENTITY,
            Why::Server => StatusCode::INTERNAL_SERVER_ERROR,
        };
        (status, Json(self.0)).into_response()
    }
}

/// Does something that takes a while on a thread where that holds nobody up.
async fn aside<T: Send + 'static>(
    work: impl FnOnce() -> Result<T, Problem> + Send + 'static,
) -> Result<T, Refused> {
    let done = tokio::task::spawn_blocking(work).await;
    let failed = |_| Problem { why: Why::Server, text: "this failed in the server".into() };
    Ok(done.map_err(failed)??)
}
