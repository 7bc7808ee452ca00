//! Descriptors: as many as the system gives, so that connections take none from files.

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
