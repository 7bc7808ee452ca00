//! `kerf machine pace`: what runs have shown of the time that a controller takes.

use super::machine::controller;
use super::shop::not_beside_a_server;
use super::which::Which;
use crate::exit::Exit;
use crate::{out, setup};
use anyhow::Result;
use kerf_control::Learned;
use std::path::Path;

/// Tells it, or forgets it. The controller is not opened.
pub fn run(which: &Which, forget: bool) -> Result<Exit> {
    let port = controller(which)?.address.key();
    if forget {
        not_beside_a_server(which, "forget it on the page (Tool path)")?;
    }
    let mut workspace = setup::workspace(Path::new(""), &which.place(), !forget)?;
    if forget {
        Learned::forget(&port, &mut workspace.stored);
        return Ok(Exit::Good);
    }
    out::print(&(sentence(Learned::of(&port, &workspace.stored)) + "\n"));
    Ok(Exit::Good)
}

/// Tells it in a sentence.
pub fn sentence(learned: Learned) -> String {
    let runs = match learned.runs() {
        0 => return "no run here has shown anything yet".into(),
        1 => "1 run".to_owned(),
        runs => format!("{runs} runs"),
    };
    format!("{runs} here: motion takes {:.2} times as long as estimated", learned.factor())
}
