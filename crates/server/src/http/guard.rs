//! Lets requests in: the right name of this machine, no foreign page, a paired device.
//!
//! A page of a foreign site in the user's own browser must not reach the machine: its requests carry
//! a foreign `Origin`, and where it points its own name at this address, a foreign `Host`.

use super::door::DoorSlot;
use crate::app::App;
use crate::people::Here;
use crate::pool::{HERE, RequestScope};
use axum::extract::connect_info::ConnectInfo;
use axum::extract::{Extension, Request, State};
use axum::http::header::{AUTHORIZATION, COOKIE, HOST, ORIGIN};
use axum::http::{HeaderMap, HeaderValue, Method, StatusCode, header};
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};
use kerf_wire::Role;
use std::net::{IpAddr, SocketAddr};
use std::sync::Arc;
use std::time::Duration;

/// Returns the name of the cookie that holds a device's token. Cookies know no ports, and each machine of a host has a port
/// and devices of its own: its name does, and it is that of the console.
pub fn device_cookie(console: u16) -> String {
    format!("kerf-device-{console}")
}

/// Name before the token of whoever sits at the machine, in the address that is printed.
pub const IN_ADDRESS: &str = "token";

/// Answer to a device that is not let in.
const UNPAIRED: &str = "this device is not paired with the machine; at the machine itself open the address that kerf \
    serve printed";

/// Headers of proxies. They are not believed; whoever sends them is not at the machine itself.
const FORWARDED: [&str; 4] = ["forwarded", "x-forwarded-for", "x-forwarded-host", "x-real-ip"];

/// Both ends of a connection.
#[derive(Clone, Copy, Debug)]
pub struct Peer {
    /// The other end.
    pub remote: SocketAddr,
    /// Ours.
    pub local: SocketAddr,
}

/// The caller of a request.
#[derive(Clone, Debug)]
pub struct Caller {
    /// Its role; nothing for a device that is not paired.
    pub role: Option<Role>,
    /// Number and name of the paired device; nothing at the machine itself.
    pub device: Option<(u32, String)>,
}

impl Caller {
    /// The device by its number; [`HERE`] at the machine itself.
    pub fn number(&self) -> u32 {
        self.device.as_ref().map_or(HERE, |(number, _)| *number)
    }
}

/// A request of somebody who is not paired has come and is answered within this time.
const STRANGERS_TIME: Duration = Duration::from_secs(5);

/// Looks at every request of the console before anything else does.
pub async fn guard(
    State(app): State<Arc<App>>,
    ConnectInfo(peer): ConnectInfo<Peer>,
    Extension(place): Extension<DoorSlot>,
    request: Request,
    next: Next,
) -> Response {
    if let Some(entered) = enter(&app, &peer, &request) {
        return with_headers(entered);
    }
    let port = peer.local.port();
    let caller = admit(&app, &peer, port, &request);
    pass(&app, caller, &place, request, next).await
}

/// The same on STOP's own way, which pages of the console ask from another port.
pub async fn guard_of_stop(
    State((app, port)): State<(Arc<App>, u16)>,
    ConnectInfo(peer): ConnectInfo<Peer>,
    Extension(place): Extension<DoorSlot>,
    request: Request,
    next: Next,
) -> Response {
    let caller = admit(&app, &peer, port, &request);
    pass(&app, caller, &place, request, next).await
}

/// Lets a request in that is admitted, in its turn.
async fn pass(
    app: &App,
    caller: Result<Caller, Refusal>,
    place: &DoorSlot,
    mut request: Request,
    next: Next,
) -> Response {
    let known = |caller: Caller| {
        let room = caller.role.is_none() || place.is_of(caller.number());
        let many = "this device has too many connections: close some of its pages";
        if room { Ok(caller) } else { Err((StatusCode::SERVICE_UNAVAILABLE, many)) }
    };
    let caller = match caller.and_then(known) {
        Ok(caller) => caller,
        Err((status, why)) => return with_headers((status, why).into_response()),
    };
    let (stranger, turn) =
        (caller.role.is_none(), RequestScope::of(app.pool.clone(), caller.number()));
    request.extensions_mut().insert(caller);
    let (request, _room) = match app.bodies.admit(request).await {
        Ok(admitted) => admitted,
        Err((status, why)) => return with_headers((status, why).into_response()),
    };
    let answer = turn.serve(next.run(request));
    if !stranger {
        return with_headers(answer.await);
    }
    let answer = tokio::time::timeout(STRANGERS_TIME, answer).await;
    let late = |_| (StatusCode::REQUEST_TIMEOUT, "this took too long").into_response();
    with_headers(answer.unwrap_or_else(late))
}

type Refusal = (StatusCode, &'static str);

/// Finds out who asks, if they may ask at all; pages come from the console, which listens at a port of its own.
fn admit(app: &App, peer: &Peer, console: u16, request: &Request) -> Result<Caller, Refusal> {
    let (headers, path) = (request.headers(), request.uri().path());
    let host = host(headers).filter(|host| is_ours(app, peer, host));
    let host =
        host.ok_or((StatusCode::MISDIRECTED_REQUEST, "this is not the name of this machine"))?;
    let foreign = (StatusCode::FORBIDDEN, "a page of another site may not ask this machine");
    match headers.get(ORIGIN) {
        Some(origin) if origin.as_bytes() != origin_of(peer, console, host).as_bytes() => {
            return Err(foreign);
        }
        None if SOCKETS.contains(&path) => return Err(foreign),
        _ => {}
    }
    let caller = who(app, peer, console, headers);
    let open = !path.starts_with("/api") && !SOCKETS.contains(&path) || path == "/api/pair";
    if caller.role.is_none() && !open {
        return Err((StatusCode::UNAUTHORIZED, UNPAIRED));
    }
    // Nothing changes by looking.
    let known = [Method::GET, Method::HEAD, Method::POST, Method::PUT, Method::DELETE];
    if known.contains(request.method()) {
        Ok(caller)
    } else {
        Err((StatusCode::METHOD_NOT_ALLOWED, "this is not how things are asked here"))
    }
}

/// Paths at which sockets are opened: only by pages, and only by those of this machine.
const SOCKETS: [&str; 2] = ["/ws", "/stop"];

/// The origin of the console's pages, for whoever calls this machine so.
fn origin_of(peer: &Peer, console: u16, host: &str) -> String {
    match host.strip_suffix(&format!(":{}", peer.local.port())) {
        _ if peer.local.port() == console => format!("http://{host}"),
        Some(name) if console == 80 => format!("http://{name}"),
        Some(name) => format!("http://{name}:{console}"),
        None => format!("http://{host}:{console}"),
    }
}

fn host(headers: &HeaderMap) -> Option<&str> {
    let mut hosts = headers.get_all(HOST).iter();
    let host = hosts.next()?.to_str().ok()?;
    hosts.next().is_none().then_some(host)
}

/// Returns `true` if a name with a port is one of this machine's.
fn is_ours(app: &App, peer: &Peer, host: &str) -> bool {
    let (name, port) = match host.rsplit_once(':') {
        Some((name, port)) if !port.contains(']') => (name, port.parse().ok()),
        _ => (host, Some(80)),
    };
    let local = peer.local.ip().to_canonical();
    let address = match local {
        IpAddr::V4(v4) => v4.to_string(),
        IpAddr::V6(v6) => format!("[{v6}]"),
    };
    let named = |ours: &str| name.eq_ignore_ascii_case(ours);
    let ours = named(&address)
        || local.is_loopback() && named("localhost")
        || app.options.lan && app.options.names.iter().any(|ours| named(ours));
    ours && port == Some(peer.local.port())
}

/// Returns `true` if a request comes from this computer, and nothing says that it was handed on.
fn is_here(peer: &Peer, headers: &HeaderMap) -> bool {
    let forwarded = FORWARDED.iter().any(|name| headers.contains_key(*name));
    let remote = peer.remote.ip().to_canonical();
    let own = remote.is_loopback() || remote == peer.local.ip().to_canonical();
    own && !forwarded
}

/// Returns the name of the cookie of whoever sits at the machine.
fn here_cookie(console: u16) -> String {
    format!("kerf-here-{console}")
}

/// Lets whoever opens the address that was printed in: the token goes from the address into a cookie.
fn enter(app: &App, peer: &Peer, request: &Request) -> Option<Response> {
    let (here, path) = (app.here.as_ref()?, request.uri().path());
    if request.method() != Method::GET || path.starts_with("/api") || path == "/ws" {
        return None;
    }
    let pairs = request.uri().query()?.split('&').filter_map(|pair| pair.split_once('='));
    let (_, given) = pairs.into_iter().find(|(name, _)| *name == IN_ADDRESS)?;
    let headers = request.headers();
    let ours = host(headers).is_some_and(|host| is_ours(app, peer, host));
    let mut answer = (StatusCode::SEE_OTHER, [(header::LOCATION, path)]).into_response();
    if ours && is_here(peer, headers) && here.is(given) {
        let cookie = format!(
            "{}={given}; Path=/; HttpOnly; SameSite=Strict; Max-Age=31536000",
            here_cookie(peer.local.port())
        );
        answer.headers_mut().insert(header::SET_COOKIE, HeaderValue::from_str(&cookie).ok()?);
    }
    Some(answer)
}

/// Finds out who asks: whoever sits at the machine owns it, and shows so where others may connect; everybody else is
/// a paired device, or nobody.
fn who(app: &App, peer: &Peer, console: u16, headers: &HeaderMap) -> Caller {
    let shows = |here: &Here| {
        let given = bearer(headers).or_else(|| cookie(headers, &here_cookie(console)));
        given.is_some_and(|given| here.is(given))
    };
    if is_here(peer, headers) && app.here.as_ref().is_none_or(shows) {
        return Caller { role: Some(Role::Owner), device: None };
    }
    let token = bearer(headers).or_else(|| cookie(headers, &device_cookie(console)));
    let device = token.and_then(|token| app.devices.find(token));
    let device = device.filter(|_| app.options.lan);
    Caller {
        role: device.as_ref().map(|device| device.role),
        device: device.map(|device| (device.number, device.name)),
    }
}

fn bearer(headers: &HeaderMap) -> Option<&str> {
    headers.get(AUTHORIZATION)?.to_str().ok()?.strip_prefix("Bearer ")
}

fn cookie<'a>(headers: &'a HeaderMap, wanted: &str) -> Option<&'a str> {
    let cookies = headers.get(COOKIE)?.to_str().ok()?;
    let pairs = cookies.split(';').filter_map(|pair| pair.trim().split_once('='));
    pairs.into_iter().find(|(name, _)| *name == wanted).map(|(_, value)| value)
}

/// Adds what every answer says to the browser. Pages get their own policy, with a nonce.
fn with_headers(mut response: Response) -> Response {
    let headers = response.headers_mut();
    let always = [
        (header::X_CONTENT_TYPE_OPTIONS, "nosniff"),
        (header::REFERRER_POLICY, "no-referrer"),
        (header::X_FRAME_OPTIONS, "DENY"),
    ];
    for (name, value) in always {
        headers.insert(name, HeaderValue::from_static(value));
    }
    let policies = [
        ("cross-origin-opener-policy", "same-origin"),
        ("cross-origin-resource-policy", "same-origin"),
        ("permissions-policy", "camera=(), microphone=(), geolocation=()"),
    ];
    for (name, value) in policies {
        headers.insert(name, HeaderValue::from_static(value));
    }
    let policy = "default-src 'none'; frame-ancestors 'none'";
    headers.entry(header::CONTENT_SECURITY_POLICY).or_insert(HeaderValue::from_static(policy));
    headers.entry(header::CACHE_CONTROL).or_insert(HeaderValue::from_static("no-store"));
    response
}
