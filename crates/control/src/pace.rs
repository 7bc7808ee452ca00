//! How machine time relates to the time of the world.

/// Says how far machine time may run, and when the operator wants it to stop.
pub trait Pace {
    /// Machine time is about to go from one moment to another, seconds; both may be the same. When
    /// the operator stops the machine before, returns the moment at which that happens.
    fn pass(&mut self, from_s: f64, to_s: f64) -> Option<f64>;

    /// The machine stands because of the stop that `pass` told: it is asked what comes next, which
    /// takes no machine time, and does not stop for the same reason again.
    fn heard(&mut self) {}
}

/// As fast as can be computed, never stopped.
impl Pace for () {
    fn pass(&mut self, _: f64, _: f64) -> Option<f64> {
        None
    }
}

/// As fast as can be computed; the operator stops at a machine time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StopAt(pub f64);

impl Pace for StopAt {
    fn pass(&mut self, from_s: f64, to_s: f64) -> Option<f64> {
        (to_s > from_s && to_s >= self.0).then_some(self.0.max(from_s))
    }

    fn heard(&mut self) {
        self.0 = f64::INFINITY;
    }
}
