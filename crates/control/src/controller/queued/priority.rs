//! Real-time priority of the thread that feeds boards: it runs before all others as soon as it has something to do.

/// Raises the thread that calls this above all that have no real-time priority. It never waits for anything but its lines
/// and the clock, so it leaves the processor to others most of the time.
///
/// # Errors
/// The system does not give it; the reason in words.
#[cfg(target_os = "linux")]
pub fn raise() -> Result<(), String> {
    use thread_priority::{
        RealtimeThreadSchedulePolicy, ThreadPriority, ThreadSchedulePolicy,
        set_thread_priority_and_policy, thread_native_id,
    };
    let fifo = ThreadSchedulePolicy::Realtime(RealtimeThreadSchedulePolicy::Fifo);
    let lowest = ThreadPriority::Crossplatform(LOWEST.try_into()?);
    set_thread_priority_and_policy(thread_native_id(), lowest, fifo).map_err(|why| match why {
        thread_priority::Error::OS(code) => std::io::Error::from_raw_os_error(code).to_string(),
        other => format!("{other:?}"),
    })
}

/// Among real-time threads it is one of the lowest: those of sound and of the system's drivers come before it.
#[cfg(target_os = "linux")]
const LOWEST: u8 = 1;

/// The same where threads have no such priority.
#[cfg(not(target_os = "linux"))]
pub fn raise() -> Result<(), String> {
    Err("this system has none".to_owned())
}

/// A sentence for the operator where the system did not give it.
pub fn words(why: &str) -> String {
    format!(
        "motion is sent without real-time priority ({why}): on a busy computer it may be late; a limit of rtprio 1 for this \
         user gives it (/etc/security/limits.conf)"
    )
}
