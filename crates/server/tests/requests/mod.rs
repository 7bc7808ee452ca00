//! Bytes as requests to a server whose machine is simulated. The test of this crate and the fuzz target share it.

use kerf_control::Session;
use kerf_files::{Folders, RealDisk};
use kerf_server::{Builders, Options, Role, Server, Workshop};
use kerf_workspace::{Workspace, stored::Stored};
use std::cell::RefCell;
use std::net::SocketAddr;
use std::path::PathBuf;
use std::sync::Arc;
use tempfile::TempDir;

/// A server hears so many texts; then it is another one, whatever they have made of it.
const TEXTS: u32 = 100;

/// Machine time passes so much faster than the world's.
const RATE: f64 = 10_000.0;

struct Asked {
    server: Server,
    _folder: TempDir,
    left: u32,
}

thread_local! {
    static ASKED: RefCell<Option<Asked>> = const { RefCell::new(None) };
}

fn begin() -> Asked {
    let folder = tempfile::tempdir().expect("a folder");
    let parts = folder.path().join("parts");
    std::fs::create_dir(&parts).expect("a part folder");
    std::fs::write(parts.join("a.sbp"), "MX,1\nPAUSE 1\nMY,1\n").expect("a part file");
    let options = Options {
        listen: SocketAddr::from(([127, 0, 0, 1], 0)),
        lan: false,
        names: Vec::new(),
        parts: parts.clone(),
        data: folder.path().join("data"),
        drawing_only: false,
        open: None,
        start: None,
        begin_with: Vec::new(),
        closes_with_program: false,
        webhook: None,
        rate: RATE,
    };
    let server = Server::start(options, builders(parts)).expect("a server");
    // What asks for the lease below has its number.
    drop(server.ask(Role::Owner, r#"{"id":1,"act":{"do":"takeLease","force":true}}"#));
    drop(server.ask(Role::Owner, r#"{"id":2,"act":{"do":"arm","lease":1}}"#));
    Asked { server, _folder: folder, left: TEXTS }
}

fn builders(parts: PathBuf) -> Builders {
    let folders = |parts: &PathBuf| Folders::new(parts.clone(), Vec::new(), Vec::new());
    let own = parts.clone();
    let workshop = move || {
        let stored = Stored::in_memory(Default::default());
        let workspace =
            Workspace::new(Box::new(RealDisk), folders(&own), stored, own.join("../data"));
        Ok(Workshop {
            session: Session::default(),
            workspace,
            controller: None,
            told: Default::default(),
            kept: false,
            started: || None,
        })
    };
    let preview = move || {
        let stored = Stored::in_memory(Default::default());
        Ok(Workspace::preview(RealDisk, folders(&parts), &stored, parts.join("../data")))
    };
    Builders { workshop: Arc::new(workshop), preview: Arc::new(preview) }
}

/// A request a line, from whoever its first byte says: each is done or refused with words, and a stop is heard after all
/// of them.
pub fn check(bytes: &[u8]) {
    let Some((who, bytes)) = bytes.split_first() else { return };
    let roles = [Role::Owner, Role::Observer, Role::Operator, Role::Setter];
    let role = roles[usize::from(*who) % roles.len()];
    let text = String::from_utf8_lossy(bytes);
    ASKED.with_borrow_mut(|asked| {
        let here = asked.get_or_insert_with(begin);
        for line in text.lines().take(40) {
            if let Err(problem) = here.server.ask(role, line) {
                assert!(!problem.text.is_empty(), "refused without words: {line}");
            }
        }
        let stopped = here.server.ask(Role::Observer, r#"{"id":3,"act":{"do":"stop"}}"#);
        assert!(stopped.is_ok(), "{stopped:?}");
        here.left -= 1;
        if here.left == 0 {
            *asked = None;
        }
    });
}
