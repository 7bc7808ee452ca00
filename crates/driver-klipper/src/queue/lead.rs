//! The time by which motion is sent before it is made, from the stalls that the host was seen to make.

/// Shortest time before the end of what was sent at which the tail is decided, seconds: the line and its resends.
const SHORTEST_S: f64 = 0.05;
/// Longest one, where the deadline asks for no longer one, seconds.
const LONGEST_S: f64 = 0.35;
/// Times the longest stall that is provided for.
const SAFETY: f64 = 2.0;
/// Share of the deadline by which the tail is decided at the least: whoever lets a host be silent for longer, as it may
/// stall, has motion sent earlier.
const OF_DEADLINE: f64 = 0.5;
/// Share of the shortest lead that a command may be on its way.
const OF_SHORTEST: f64 = 0.25;
/// Time for which a command that is lost once may be on its way, seconds.
const TRANSIT_S: f64 = 0.025;
/// Longest time that follows from the deadline, seconds.
const DEADLINE_LONGEST_S: f64 = 1.0;
/// Share of a stall that is forgotten in a second.
const FORGOTTEN: f64 = 0.02;
/// The whole lead, in times of the shortest one.
const FULL: f64 = 2.0;
/// The shortest lead is longer by at most so much at a look, seconds: whoever plans needs time to come so far ahead.
const RISE_S: f64 = 0.005;

/// How far ahead of its time motion is sent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lead {
    /// Ticks a second.
    frequency: f64,
    /// Shortest time before the end of what was sent at which the tail goes out, seconds.
    shortest_s: f64,
    /// Longest time between two looks at the queue, slowly forgotten, seconds.
    stall_s: f64,
    /// Time before the end of what was sent at which the tail goes out, seconds.
    least_s: f64,
    looked_s: Option<f64>,
}

impl Lead {
    /// Longest time by which a piece is sent before it begins, seconds.
    pub const MOST_S: f64 = FULL * DEADLINE_LONGEST_S;

    /// For a board with so many ticks a second.
    pub const fn new(frequency: f64) -> Self {
        let shortest_s = SHORTEST_S;
        Self { frequency, shortest_s, stall_s: 0.0, least_s: shortest_s, looked_s: None }
    }

    /// The same for a board that lets its host be silent for so long, seconds.
    pub const fn of_deadline(self, deadline_s: f64) -> Self {
        let shortest_s = (OF_DEADLINE * deadline_s).clamp(SHORTEST_S, DEADLINE_LONGEST_S);
        Self { shortest_s, least_s: shortest_s, ..self }
    }

    /// The host looks at the queue at a moment. It has stalled since the last look, as far as this can tell.
    pub fn looked(&mut self, now_s: f64) {
        let gap_s = self.looked_s.map_or(0.0, |looked_s| now_s - looked_s);
        self.stall_s = (self.stall_s * (1.0 - FORGOTTEN * gap_s)).max(gap_s);
        self.least_s = self.wanted_s().min(self.least_s + RISE_S.min(gap_s));
        self.looked_s = Some(now_s);
    }

    /// Moment of the last look.
    pub fn looked_s(&self) -> f64 {
        self.looked_s.unwrap_or(f64::NEG_INFINITY)
    }

    /// Longest stall that was seen, seconds.
    pub const fn stall_s(&self) -> f64 {
        self.stall_s
    }

    /// Ticks before the end of what was sent at which the tail goes out.
    pub fn least(&self) -> u64 {
        (self.least_s * self.frequency) as u64
    }

    /// Ticks by which a piece is sent before it begins.
    pub fn full(&self) -> u64 {
        (self.full_s() * self.frequency) as u64
    }

    /// The same, seconds.
    pub fn full_s(&self) -> f64 {
        FULL * self.wanted_s()
    }

    /// Ticks for which a command that is lost once, or whose host is kept waiting, may be on its way.
    pub fn transit(&self) -> u64 {
        (TRANSIT_S.max(OF_SHORTEST * self.shortest_s) * self.frequency) as u64
    }

    /// The shortest lead that the stalls ask for, seconds.
    fn wanted_s(&self) -> f64 {
        (self.shortest_s + SAFETY * self.stall_s).min(LONGEST_S.max(self.shortest_s))
    }
}
