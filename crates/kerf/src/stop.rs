//! Requests to stop Kerf: Ctrl-C, and where there are signals SIGTERM, SIGHUP, SIGQUIT and SIGXCPU (`kill`, the end
//! of a login, a terminal that was closed, Ctrl-\, a limit on the time of a process). Whatever moves is stopped and
//! switched off before the process ends.

use anyhow::{Context, Result};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, OnceLock};

/// Requests to stop that have come.
#[derive(Clone, Debug, Default)]
pub struct Stop {
    /// Ctrl-C, which nobody has heard yet.
    pressed: Arc<AtomicBool>,
    /// Another program has the terminal: the process may be suspended with it.
    lends: Arc<AtomicBool>,
    /// The process is to end: nobody answers any more.
    leaves: Arc<AtomicBool>,
    /// A run has heard that.
    heard: Arc<AtomicBool>,
}

impl Stop {
    /// Listens from the first time this is called; a process listens once.
    pub fn listen() -> Result<Self> {
        static STOP: OnceLock<Stop> = OnceLock::new();
        if let Some(stop) = STOP.get() {
            return Ok(stop.clone());
        }
        let stop = STOP.get_or_init(Self::default).clone();
        let flag = stop.pressed.clone();
        ctrlc::set_handler(move || flag.store(true, Ordering::Relaxed))
            .context("cannot listen to Ctrl-C")?;
        #[cfg(unix)]
        signals::listen(&stop.leaves).context("cannot listen to signals")?;
        Ok(stop)
    }

    /// Has Ctrl-Z stop a process that moves a machine as Ctrl-C does, instead of suspending it: nobody would watch
    /// over the machine then.
    pub fn instead_of_suspending(&self) -> Result<()> {
        #[cfg(unix)]
        signals::instead_of_suspending(&self.pressed, &self.lends)
            .context("cannot listen to signals")?;
        Ok(())
    }

    /// Does something while another program has the terminal, and the keys with it: Ctrl-Z suspends both, and
    /// what was pressed there is no stop of what runs.
    pub fn lending_terminal<T>(&self, does: impl FnOnce() -> T) -> T {
        self.lends.store(true, Ordering::Relaxed);
        let done = does();
        self.lends.store(false, Ordering::Relaxed);
        self.pressed.store(false, Ordering::Relaxed);
        done
    }

    /// Returns `true` if the run is to stop.
    pub fn is_wanted(&self) -> bool {
        self.pressed.load(Ordering::Relaxed) || self.leaves() && !self.heard.load(Ordering::Relaxed)
    }

    /// Returns `true` if the process is to end.
    pub fn leaves(&self) -> bool {
        self.leaves.load(Ordering::Relaxed)
    }

    /// Takes note that the run stops. That the process is to end is told once: another signal does not disturb the
    /// stop.
    pub fn hear(&self) {
        self.pressed.store(false, Ordering::Relaxed);
        if self.leaves() {
            self.heard.store(true, Ordering::Relaxed);
        }
    }
}

/// A file that may not grow any more (`ulimit -f`) is a write that fails, and no end of the process.
pub fn outlive_full_files() -> Result<()> {
    #[cfg(unix)]
    signals::outlive_full_files().context("cannot listen to signals")?;
    Ok(())
}

#[cfg(unix)]
mod signals {
    use signal_hook::consts::{SIGHUP, SIGQUIT, SIGTERM, SIGTSTP, SIGXCPU, SIGXFSZ};
    use signal_hook::flag::{register, register_conditional_default};
    use std::fs;
    use std::io;
    use std::sync::Arc;
    use std::sync::atomic::AtomicBool;

    /// Sets the flag at the signals that end a process. What was started to outlive its terminal (`nohup`)
    /// goes on without one.
    pub fn listen(leaves: &Arc<AtomicBool>) -> io::Result<()> {
        for signal in [SIGTERM, SIGQUIT, SIGXCPU] {
            register(signal, leaves.clone())?;
        }
        if !is_ignored(SIGHUP) {
            register(SIGHUP, leaves.clone())?;
        }
        Ok(())
    }

    /// Sets the flag where a terminal asks a process to suspend itself, and suspends it only where the other
    /// flag is set.
    pub fn instead_of_suspending(
        pressed: &Arc<AtomicBool>,
        suspends: &Arc<AtomicBool>,
    ) -> io::Result<()> {
        register_conditional_default(SIGTSTP, suspends.clone())?;
        register(SIGTSTP, pressed.clone()).map(drop)
    }

    /// A handler that does nothing, in place of the end of the process.
    pub fn outlive_full_files() -> io::Result<()> {
        register(SIGXFSZ, Arc::default()).map(drop)
    }

    /// Returns `true` if the process was started with this signal ignored. Only Linux tells; elsewhere the machine
    /// stops rather than to run on.
    fn is_ignored(signal: i32) -> bool {
        let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
        status.lines().find_map(|line| line.strip_prefix("SigIgn:")).is_some_and(|mask| {
            let mask = u64::from_str_radix(mask.trim(), 16).unwrap_or_default();
            mask & (1 << (signal - 1)) != 0
        })
    }
}
