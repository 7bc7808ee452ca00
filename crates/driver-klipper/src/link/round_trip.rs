//! Times of a line: the round trip, and from it the moment at which a frame counts as lost.

/// Shortest time after which a frame counts as lost, seconds.
const SHORTEST_S: f64 = 0.025;
/// Longest one.
const LONGEST_S: f64 = 5.0;
/// Share of the newest round trip in the smoothed one.
const SHARE: f64 = 0.125;
/// Share of the newest deviation in the smoothed one.
const DEVIATION_SHARE: f64 = 0.25;
/// Deviations that are added to the smoothed round trip.
const DEVIATIONS: f64 = 4.0;

/// The smoothed round trip of a line and the timer for what is on its way.
#[derive(Clone, Debug)]
pub struct RoundTrip {
    /// Smoothed round trip and its deviation, seconds.
    smooth_s: Option<[f64; 2]>,
    /// Time after which frames count as lost, doubled at each loss.
    patience_s: f64,
    /// Moment from which the timer runs; nothing where it does not.
    since_s: Option<f64>,
    /// Moment up to which naks may be answers to copies.
    copies_until_s: f64,
}

impl Default for RoundTrip {
    fn default() -> Self {
        Self {
            smooth_s: None,
            patience_s: SHORTEST_S,
            since_s: None,
            copies_until_s: f64::NEG_INFINITY,
        }
    }
}

impl RoundTrip {
    /// A frame that went out once took so long.
    pub fn measured(&mut self, trip_s: f64) {
        let [mut smooth_s, mut deviation_s] = self.smooth_s.unwrap_or([trip_s, trip_s / 2.0]);
        deviation_s += DEVIATION_SHARE * ((trip_s - smooth_s).abs() - deviation_s);
        smooth_s += SHARE * (trip_s - smooth_s);
        self.smooth_s = Some([smooth_s, deviation_s]);
    }

    /// Smoothed round trip and its deviation, seconds.
    pub const fn smooth_s(&self) -> Option<[f64; 2]> {
        self.smooth_s
    }

    /// Something was acknowledged: the timer runs anew, as patient as the round trip asks for. While each frame went out twice
    /// no round trip is known, and a patience that losses have lengthened is kept.
    pub fn progressed(&mut self, since_s: f64) {
        if let Some(patience_s) = self.asked_for_s() {
            self.patience_s = patience_s;
        }
        self.start(since_s);
    }

    /// The patience that the round trip asks for, seconds.
    fn asked_for_s(&self) -> Option<f64> {
        let [smooth_s, deviation_s] = self.smooth_s?;
        Some((smooth_s + DEVIATIONS * deviation_s).clamp(SHORTEST_S, LONGEST_S))
    }

    /// The timer runs from a moment: the last byte has left.
    pub fn start(&mut self, since_s: f64) {
        self.since_s = Some(since_s);
    }

    /// Nothing is waited for.
    pub fn stop(&mut self) {
        self.since_s = None;
    }

    /// Nothing came in time.
    pub fn missed(&mut self, now_s: f64) {
        self.patience_s = (self.patience_s * 2.0).min(LONGEST_S);
        self.since_s = Some(now_s);
    }

    /// All that is on its way went out again, the last byte at a moment. The board answers copies of what it has with
    /// naks, which ask for nothing.
    pub fn resent(&mut self, free_s: f64) {
        let trip_s =
            self.smooth_s.map_or(self.patience_s, |[smooth_s, deviation_s]| smooth_s + deviation_s);
        self.copies_until_s = free_s + 2.0 * trip_s;
    }

    /// Naks ask for frames again.
    pub fn is_over_resend(&self, now_s: f64) -> bool {
        now_s > self.copies_until_s
    }

    /// Moment at which what is on its way counts as lost; infinite while nothing is.
    pub fn due_s(&self) -> f64 {
        self.since_s.map_or(f64::INFINITY, |since_s| since_s + self.patience_s)
    }
}
