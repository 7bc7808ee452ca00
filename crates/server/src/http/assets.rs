//! The console itself: built into the program, or a page that says how to build it.

use crate::app::App;
use crate::digested::hex;
use axum::extract::State;
use axum::http::{HeaderMap, HeaderValue, StatusCode, Uri, header};
use axum::response::{IntoResponse, Response};
use rust_embed::Embed;
use std::sync::Arc;

/// The console as `npm run build` leaves it. Not there before it was built.
#[derive(Embed)]
#[folder = "../../console/dist"]
#[allow_missing = true]
struct Console;

/// The page when the console was not built.
const MINIMAL: &str = include_str!("minimal.html");

/// Placeholder of the nonce in the page.
const NONCE: &str = "__KERF_NONCE__";

/// A file of the console; the page itself for every path that is none.
pub async fn asset(State(app): State<Arc<App>>, headers: HeaderMap, uri: Uri) -> Response {
    let path = uri.path().trim_start_matches('/');
    match Console::get(path).filter(|_| path != "index.html") {
        Some(file) => plain(path, file.data.into_owned()),
        None if path.rsplit('/').next().is_some_and(|last| last.contains('.')) => {
            StatusCode::NOT_FOUND.into_response()
        }
        None => page(&stop_way(&headers, app.hub.read(|now| now.stop_port))),
    }
}

/// Returns the address of STOP's own way: this machine as the browser calls it, at another port. An address of IPv6
/// is no name in a policy, so the port alone stands for it.
fn stop_way(headers: &HeaderMap, port: u16) -> String {
    let host = headers.get(header::HOST).and_then(|host| host.to_str().ok()).unwrap_or_default();
    let name = host.split_once(':').map_or(host, |(name, _)| name);
    let plain = |c: char| c.is_ascii_alphanumeric() || c == '.' || c == '-';
    let named = !name.is_empty() && name.chars().all(plain);
    format!("ws://{}:{port}", if named { name } else { "*" })
}

fn plain(path: &str, bytes: Vec<u8>) -> Response {
    let mut headers = HeaderMap::new();
    headers.insert(header::CONTENT_TYPE, HeaderValue::from_static(kind(path)));
    // Names below assets carry a hash of what is in them.
    let keep = if path.starts_with("assets/") {
        "public, max-age=31536000, immutable"
    } else {
        "no-cache"
    };
    headers.insert(header::CACHE_CONTROL, HeaderValue::from_static(keep));
    // Workers take the policy of the script they are made from.
    headers.insert(header::CONTENT_SECURITY_POLICY, HeaderValue::from_static(WORKER));
    (headers, bytes).into_response()
}

/// Policy for a script that runs beside the page.
const WORKER: &str = "default-src 'none'; script-src 'self'; connect-src 'self'";

fn page(stop_way: &str) -> Response {
    let mut bytes = [0; 16];
    if getrandom::fill(&mut bytes).is_err() {
        return StatusCode::INTERNAL_SERVER_ERROR.into_response();
    }
    let nonce = hex(&bytes);
    let built = Console::get("index.html");
    let text = built.map(|file| String::from_utf8_lossy(&file.data).into_owned());
    let text = text.unwrap_or_else(|| MINIMAL.to_owned()).replace(NONCE, &nonce);
    let policy = format!(
        "default-src 'none'; script-src 'self' 'nonce-{nonce}'; style-src 'self' 'nonce-{nonce}'; \
         img-src 'self' data: blob:; media-src 'self'; font-src 'self'; connect-src 'self' {stop_way}; worker-src 'self'; \
         manifest-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
    );
    let headers = [
        (header::CONTENT_TYPE, "text/html; charset=utf-8".to_owned()),
        (header::CONTENT_SECURITY_POLICY, policy),
    ];
    (headers, text).into_response()
}

fn kind(path: &str) -> &'static str {
    match path.rsplit_once('.').map_or("", |(_, extension)| extension) {
        "js" | "mjs" => "text/javascript; charset=utf-8",
        "css" => "text/css; charset=utf-8",
        "svg" => "image/svg+xml",
        "png" => "image/png",
        "ico" => "image/x-icon",
        "woff2" => "font/woff2",
        "json" | "map" => "application/json",
        "webmanifest" => "application/manifest+json",
        "wasm" => "application/wasm",
        "txt" => "text/plain; charset=utf-8",
        _ => "application/octet-stream",
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn files_of_the_console_are_told_with_their_kind_and_how_long_they_hold() {
        for (path, kind, keep) in [
            ("assets/page-1a2b.js", "text/javascript", "immutable"),
            ("kerf.svg", "image/svg+xml", "no-cache"),
            ("assets/unknown", "application/octet-stream", "immutable"),
        ] {
            let told = plain(path, b"text".to_vec());
            let header = |name| told.headers()[name].to_str().unwrap();
            assert!(header(header::CONTENT_TYPE).starts_with(kind), "{path}");
            assert!(header(header::CACHE_CONTROL).contains(keep), "{path}");
            assert_eq!(header(header::CONTENT_SECURITY_POLICY), WORKER, "{path}");
        }
    }
}
