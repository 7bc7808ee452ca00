//! Descriptors: as many as the system gives, so that connections take none from files.

/// Number assumed where the system does not tell or sets no bound.
const USUAL: usize = 1024;

/// Raises the limit of this process as far as it may.
pub fn raise() {
    #[cfg(target_os = "linux")]
    {
        use rustix::process::{Resource, Rlimit, getrlimit, setrlimit};
        let Rlimit { maximum, .. } = getrlimit(Resource::Nofile);
        // Where the system refuses, the usual limit is enough for the connections that are let in.
        _ = setrlimit(Resource::Nofile, Rlimit { current: maximum, maximum });
    }
}

/// The limit of this process.
pub fn limit() -> usize {
    #[cfg(target_os = "linux")]
    {
        use rustix::process::{Resource, getrlimit};
        let told = getrlimit(Resource::Nofile).current;
        told.and_then(|most| usize::try_from(most).ok()).unwrap_or(USUAL)
    }
    #[cfg(not(target_os = "linux"))]
    USUAL
}
