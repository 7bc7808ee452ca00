//! `kerf explain`: what a diagnostic code means.

use crate::exit::Exit;
use crate::out;
use anyhow::Result;
use clap::Args;
use kerf_diag::{codes, explain};

/// Explains a diagnostic code, or lists all of them
#[derive(Args)]
#[command(after_help = "Example: kerf explain S002")]
pub struct ExplainArgs {
    /// The code, as S002; without one all codes are listed
    code: Option<String>,
}

pub fn run(args: &ExplainArgs) -> Result<Exit> {
    let Some(code) = &args.code else {
        let lines = codes::ALL.iter().map(|e| format!("{}  {}\n", e.code, e.title));
        out::print(&lines.collect::<String>());
        return Ok(Exit::Good);
    };
    let Some(found) = explain(code) else {
        eprintln!("kerf: there is no code {code}; `kerf explain` lists all");
        return Ok(Exit::Failed);
    };
    out::print(&format!("{}: {}\n\n{}\n", found.code, found.title, found.text));
    Ok(Exit::Good)
}
