//! Priorities of threads. The machine's thread and that of STOP are above all others: whatever else this server
//! does gives way to them.

/// Degree to which a thread gives way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Yields {
    /// Connections: what pages ask and are told.
    Front,
    /// Work of a moment for pages, drafts.
    Aside,
    /// Work that takes a while: tool paths, previews, checks.
    Last,
}

impl Yields {
    #[cfg(target_os = "linux")]
    const fn nice(self) -> i32 {
        match self {
            Self::Front => 5,
            Self::Aside => 10,
            Self::Last => 15,
        }
    }

    /// The thread that calls this gives way from now on, and so do those that it begins.
    pub fn hold(self) {
        // Elsewhere a priority is that of the whole process. Where the system refuses, threads are equal.
        #[cfg(target_os = "linux")]
        {
            _ = rustix::process::setpriority_process(None, self.nice());
        }
    }
}
