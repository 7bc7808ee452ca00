//! How machine time relates to the time of the world.

/// Says how far machine time may run, and when the operator wants it to stop.
pub trait Pace {
    /// Machine time is about to reach `t_s`. Returns earlier with a time when the operator stopped
    /// the machine before.
    fn reach(&mut self, t_s: f64) -> Option<f64>;
}

/// As fast as can be computed, never stopped.
impl Pace for () {
    fn reach(&mut self, _: f64) -> Option<f64> {
        None
    }
}

/// As fast as can be computed; the operator stops at a machine time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StopAt(pub f64);

impl Pace for StopAt {
    fn reach(&mut self, t_s: f64) -> Option<f64> {
        (t_s >= self.0).then_some(self.0)
    }
}
