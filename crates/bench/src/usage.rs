//! Processor time and memory, as the system counts them.

use anyhow::Result;

/// Processor time and memory that a process, or all children that are over, used.
pub struct Usage {
    /// Processor time, user and system, seconds.
    pub cpu_s: f64,
    /// Peak memory, bytes; of the greatest of several.
    pub peak: f64,
}

/// Of this process.
pub fn own() -> Result<Usage> {
    unix::usage(false)
}

/// Of its children that are over.
pub fn children() -> Result<Usage> {
    unix::usage(true)
}

#[cfg(unix)]
mod unix {
    use super::Usage;
    use anyhow::Result;
    use nix::sys::resource::{UsageWho, getrusage};
    use nix::sys::time::TimeValLike;

    /// Unit in which the system counts memory, bytes.
    const UNIT: f64 = if cfg!(target_os = "macos") { 1.0 } else { 1024.0 };

    pub fn usage(children: bool) -> Result<Usage> {
        let who = if children { UsageWho::RUSAGE_CHILDREN } else { UsageWho::RUSAGE_SELF };
        let usage = getrusage(who)?;
        let cpu = usage.user_time() + usage.system_time();
        let (cpu_s, peak) = (cpu.num_microseconds() as f64 * 1e-6, usage.max_rss() as f64 * UNIT);
        Ok(Usage { cpu_s, peak })
    }
}

#[cfg(not(unix))]
mod unix {
    pub fn usage(_: bool) -> anyhow::Result<super::Usage> {
        anyhow::bail!("measuring works on Unix only")
    }
}
