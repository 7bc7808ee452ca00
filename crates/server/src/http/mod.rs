//! The server's face to the network.
//!
//! ```text
//!  request ─► guard: Host, Origin, who is it? ─► route ─► App
//!                └─ refused                         └─ /ws: socket
//! ```

mod allowance;
mod assets;
mod bodies;
mod door;
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

pub use allowance::Allowance;
pub use bodies::Bodies;
pub use door::{DoorSlot, serve};
pub use guard::{Caller, IN_ADDRESS, guard_of_stop};
pub use routes::{describe, paths, router};

use crate::pool::{Lane, RequestScope};
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
            Why::Full => StatusCode::INSUFFICIENT_STORAGE,
        };
        (status, Json(self.0)).into_response()
    }
}

/// Does something that may take a while, in its turn, on a thread where that holds nobody up.
async fn aside<T: Send + 'static>(
    work: impl FnOnce() -> Result<T, Problem> + Send + 'static,
) -> Result<T, Refused> {
    Ok(RequestScope::present()?.done(Lane::Long, work).await??)
}

/// The same for what takes a moment.
async fn soon<T: Send + 'static>(
    work: impl FnOnce() -> Result<T, Problem> + Send + 'static,
) -> Result<T, Refused> {
    Ok(RequestScope::present()?.done(Lane::Short, work).await??)
}
