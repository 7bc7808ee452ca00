//! External programs that a run starts.

use kerf_journal::Shell;
use kerf_program::{HostError, ShellCall};
use std::path::Path;
use std::process::{Command, Stdio};

/// Fails unless external programs are started.
fn start_allowed(shell: Shell) -> Result<(), HostError> {
    let what = "external programs are disabled; --allow-shell lets a run start them";
    if shell == Shell::Started { Ok(()) } else { Err(HostError::Disabled(what.into())) }
}

/// Starts an external program.
pub(crate) fn start(
    shell: Shell,
    folder: &Path,
    call: &ShellCall,
    told: [(&str, Option<String>); 2],
) -> Result<(), HostError> {
    if shell == Shell::Skipped {
        return Ok(());
    }
    start_allowed(shell)?;
    let mut command = shell_command(&call.line);
    command.current_dir(folder).stdin(Stdio::null());
    command.envs(told.into_iter().filter_map(|(name, value)| Some((name, value?))));
    let started = if call.wait { command.status().map(drop) } else { command.spawn().map(drop) };
    started.map_err(|e| HostError::Refused(format!("cannot start '{}': {e}", call.line)))
}

/// Starts an external program and waits until it has done what it should.
pub(crate) fn run_to_its_end(shell: Shell, folder: &Path, line: &str) -> Result<(), HostError> {
    start_allowed(shell)?;
    let ended = shell_command(line).current_dir(folder).stdin(Stdio::null()).status();
    let failed = |why: String| Err(HostError::Refused(format!("'{line}' {why}")));
    match ended {
        Ok(status) if status.success() => Ok(()),
        Ok(status) => failed(format!("failed: {status}")),
        Err(error) => failed(format!("cannot be started: {error}")),
    }
}

#[cfg(windows)]
fn shell_command(line: &str) -> Command {
    let mut command = Command::new("cmd");
    command.arg("/C").arg(line);
    command
}

#[cfg(not(windows))]
fn shell_command(line: &str) -> Command {
    let mut command = Command::new("sh");
    command.arg("-c").arg(line);
    command
}
