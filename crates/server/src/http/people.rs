//! Pairing of devices.

use super::Refused;
use super::guard::{Caller, Peer, device_cookie};
use super::rest::demand;
use crate::app::App;
use crate::people::PairError;
use crate::refusal::problem;
use axum::extract::{ConnectInfo, Path, State};
use axum::http::header;
use axum::response::IntoResponse;
use axum::{Extension, Json};
use kerf_wire::{Problem, Role, Tone, Why};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Request of a device to be paired.
#[derive(Debug, Deserialize, schemars::JsonSchema)]
pub struct Pair {
    /// The code that the machine shows.
    code: String,
    /// Name for the device.
    name: String,
}

/// Answer to a device that was paired.
#[derive(Debug, Serialize, schemars::JsonSchema)]
pub struct Paired {
    /// Its token, for scripts; browsers keep it as a cookie.
    token: String,
    /// Role of the device.
    role: Role,
}

/// For which role a code is shown.
#[derive(Debug, Deserialize, schemars::JsonSchema)]
pub struct Wanted {
    role: Role,
}

/// A code.
#[derive(Debug, Serialize, schemars::JsonSchema)]
pub struct Code {
    code: String,
}

/// A paired device.
#[derive(Debug, Serialize, schemars::JsonSchema)]
pub struct Listed {
    number: u32,
    name: String,
    role: Role,
}

impl From<PairError> for Problem {
    fn from(error: PairError) -> Self {
        let why = if error == PairError::Failed { Why::Server } else { Why::Role };
        problem(why, error.to_string())
    }
}

/// Pairs the device that asks.
pub async fn pair(
    State(app): State<Arc<App>>,
    ConnectInfo(peer): ConnectInfo<Peer>,
    Json(pair): Json<Pair>,
) -> Result<impl IntoResponse, Refused> {
    let from = peer.remote.ip();
    let paired = app.devices.pair(&pair.code, &pair.name, from);
    if let Err(PairError::Wrong { tell: Some(wrong) }) = paired {
        let text = format!(
            "Pairing: {} tried a wrong code, {wrong} wrong so far; the code that is shown stays good",
            from.to_canonical()
        );
        app.hub.say(Tone::Warning, text);
    }
    let (token, device) = paired.map_err(Problem::from)?;
    let name = device_cookie(peer.local.port());
    let cookie = format!("{name}={token}; Path=/; HttpOnly; SameSite=Strict; Max-Age=31536000");
    Ok(([(header::SET_COOKIE, cookie)], Json(Paired { token, role: device.role })))
}

/// Shows a code.
pub async fn code(
    State(app): State<Arc<App>>,
    Extension(caller): Extension<Caller>,
    Json(wanted): Json<Wanted>,
) -> Result<Json<Code>, Refused> {
    demand(&caller, Role::Owner)?;
    let code = app.devices.show_code(wanted.role).map_err(Problem::from)?;
    Ok(Json(Code { code }))
}

/// All devices.
pub async fn list(
    State(app): State<Arc<App>>,
    Extension(caller): Extension<Caller>,
) -> Result<Json<Vec<Listed>>, Refused> {
    demand(&caller, Role::Owner)?;
    let listed = |(number, name, role)| Listed { number, name, role };
    Ok(Json(app.devices.list().into_iter().map(listed).collect()))
}

/// Revokes a device.
pub async fn revoke(
    State(app): State<Arc<App>>,
    Extension(caller): Extension<Caller>,
    Path(number): Path<u32>,
) -> Result<Json<()>, Refused> {
    demand(&caller, Role::Owner)?;
    app.revoke(number).map_err(|e| problem(Why::Server, e.to_string()))?;
    Ok(Json(()))
}
