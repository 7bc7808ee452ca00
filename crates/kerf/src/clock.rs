//! The clock on the wall, for logs.

use jiff::Zoned;
use kerf_control::Started;

/// Now, where the machine stands.
pub fn started() -> Started {
    let now = Zoned::now();
    Started {
        time: now.strftime("%H:%M:%S").to_string(),
        date: now.strftime("%Y-%m-%d").to_string(),
    }
}
