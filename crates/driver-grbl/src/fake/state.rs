//! The state of the fake controller.

/// Its state, as reports name it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum State {
    Ready,
    Hold,
    Door,
    Resuming,
    Homing,
    Alarm,
    Sleep,
    Check,
    /// It waits for a tool (grblHAL).
    Tool,
}
