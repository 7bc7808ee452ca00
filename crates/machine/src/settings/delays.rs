//! Waits in the cutting sequence (Profiler reference, "Special Delay Times During Cutting").

use super::words;

words! {
    /// End of the wait at the bottom.
    BottomDelayType {
        /// A fixed time.
        Time = "time",
        /// The input EndBottomDelay, then the fixed time.
        Input = "input",
    }
}

words! {
    /// Action when the input does not come.
    TimeoutAction {
        /// The cut output goes off and the job pauses.
        Pause = "pause",
        /// Cutting starts all the same.
        Continue = "continue",
    }
}

/// Delays, seconds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Delays {
    /// After the router or shutter goes on at the first shape, and again after a pause.
    pub router_start_s: f64,
    /// After a tool output goes on and after it goes off, at each shape.
    pub air_tool_s: f64,
    /// End of the wait at the bottom.
    pub bottom_type: BottomDelayType,
    /// The wait at the bottom; after the input where one is waited for.
    pub bottom_s: f64,
    /// Longest wait for the input.
    pub bottom_timeout_s: f64,
    /// Action when it does not come.
    pub bottom_timeout: TimeoutAction,
    /// After the cut output is off and before raising.
    pub end_s: f64,
    /// Intensity during the end delay, 0 … 127.
    pub end_intensity: u8,
}

impl Default for Delays {
    fn default() -> Self {
        Self {
            router_start_s: 0.0,
            air_tool_s: 0.0,
            bottom_type: BottomDelayType::Time,
            bottom_s: 0.0,
            bottom_timeout_s: 10.0,
            bottom_timeout: TimeoutAction::Pause,
            end_s: 0.0,
            end_intensity: 0,
        }
    }
}
