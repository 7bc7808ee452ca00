//! The clock on the wall, for logs.

use jiff::Zoned;
use kerf_journal::Started;
use std::time::SystemTime;

/// Now, where the machine stands.
pub fn started() -> Started {
    let now = Zoned::now();
    Started {
        time: now.strftime("%H:%M:%S").to_string(),
        date: now.strftime("%Y-%m-%d").to_string(),
    }
}

/// A time as people here write it: `2026-11-24 14:03`.
pub fn told(time: SystemTime) -> String {
    let zoned = Zoned::try_from(time).map(|at| at.strftime("%Y-%m-%d %H:%M").to_string());
    zoned.unwrap_or_else(|_| "at an unknown time".into())
}
