//! Another clock for a plan: how far it has run when so much time has passed.
//!
//! ```text
//!  time of ▲            ╱   runs as planned
//!  the plan│        __╱
//!          │     ╱‾‾        slows, stands, starts again
//!          │   ╱
//!          └─────────────► time
//! ```
//!
//! With τ(t) the time of the plan and r = τ′ its rate, velocity is q′·r and acceleration q″·r² + q′·r′,
//! where q′ and q″ are those of the plan: path and order of the moves stay what they are.

/// A moment from which on the plan runs at a rate that changes evenly, or whose change does.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Tick {
    pub t_s: f64,
    /// Time of the plan.
    pub plan_s: f64,
    pub rate: f64,
    /// Change of the rate, 1/s.
    pub gain: f64,
    /// Change of that, 1/s²; constant up to the next tick.
    pub push: f64,
}

/// Ticks in order; after the last one the rate stays.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Clock(Vec<Tick>);

/// Halvings in search of a moment.
const HALVINGS: u32 = 60;

impl Tick {
    /// The plan runs as planned from a moment on.
    pub fn plain(t_s: f64, plan_s: f64) -> Self {
        Self { t_s, plan_s, rate: 1.0, ..Self::default() }
    }

    /// Returns what the tick has come to after a time.
    pub fn after(&self, s: f64) -> Self {
        Self {
            t_s: self.t_s + s,
            plan_s: self.plan_s + s * (self.rate + s * (0.5 * self.gain + s * self.push / 6.0)),
            rate: (self.rate + s * (self.gain + 0.5 * s * self.push)).max(0.0),
            gain: self.gain + s * self.push,
            push: self.push,
        }
    }

    /// The same moment with another course from there on.
    pub fn turned(self, gain: f64, push: f64) -> Self {
        Self { gain, push, ..self }
    }
}

impl Clock {
    /// A clock of ticks in order, at least one.
    pub const fn of(ticks: Vec<Tick>) -> Self {
        Self(ticks)
    }

    /// A clock by which a plan runs as planned from a moment on.
    pub fn plain(t_s: f64, plan_s: f64) -> Self {
        Self(vec![Tick::plain(t_s, plan_s)])
    }

    /// Returns `true` if it is for a stack of which nothing is planned yet.
    pub fn restarts(&self) -> bool {
        self.0.len() == 1 && self.last().plan_s == 0.0 && self.last().t_s > 0.0
    }

    /// The last tick.
    pub fn last(&self) -> Tick {
        self.0.last().copied().unwrap_or_default()
    }

    /// Returns the tick shown at a time; before the first tick, that. At the very moment at which it stops at
    /// once it still runs: where a plan is cut it has the speed with which another goes on.
    pub fn at(&self, t_s: f64) -> Tick {
        let mut later = self.0.partition_point(|tick| tick.t_s <= t_s);
        let stops = |tick: &Tick| tick.t_s == t_s && tick.stands();
        if later > 1 && later == self.0.len() && self.0.last().is_some_and(stops) {
            later -= 1;
        }
        let tick = self.0.get(later.saturating_sub(1)).copied().unwrap_or_default();
        tick.after((t_s - tick.t_s).max(0.0))
    }

    /// The first tick at a time or after it.
    pub fn turns_after(&self, t_s: f64) -> Option<f64> {
        self.0.iter().map(|tick| tick.t_s).find(|at_s| *at_s >= t_s)
    }

    /// The same up to a moment, then other ticks, the first at that moment.
    pub fn then(&self, ticks: Vec<Tick>) -> Self {
        let from_s = ticks.first().map_or(f64::INFINITY, |tick| tick.t_s);
        let before = self.0.iter().take_while(|tick| tick.t_s < from_s);
        Self(before.copied().chain(ticks).collect())
    }

    /// Returns the time at which the plan reaches a time of its own. A clock that stops before stands at its last tick.
    pub fn when(&self, plan_s: f64) -> f64 {
        let later = self.0.partition_point(|tick| tick.plan_s < plan_s);
        let Some(tick) = self.0.get(later.saturating_sub(1)) else { return plan_s };
        let way = (plan_s - tick.plan_s).max(0.0);
        let most = self.0.get(later).map_or(f64::INFINITY, |next| next.t_s - tick.t_s);
        let s = if tick.push == 0.0 {
            let root = (tick.rate * tick.rate + 2.0 * tick.gain * way).max(0.0).sqrt();
            if way > 0.0 { 2.0 * way / (tick.rate + root) } else { 0.0 }
        } else {
            tick.reaches(plan_s, most)
        };
        tick.t_s + if tick.stands() { 0.0 } else { s.min(most) }
    }
}

impl Tick {
    const fn stands(&self) -> bool {
        self.rate <= 0.0 && self.gain <= 0.0 && self.push <= 0.0
    }

    fn reaches(&self, plan_s: f64, most: f64) -> f64 {
        let (mut low, mut high) = (0.0, most);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if self.after(middle).plan_s < plan_s { low = middle } else { high = middle }
        }
        high
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A clock that slows for a second, stands, and starts again.
    fn clock() -> Clock {
        let slows = Tick { gain: -1.0, ..Tick::plain(2.0, 2.0) };
        let stands = Tick { t_s: 3.0, plan_s: 2.5, ..Tick::default() };
        let starts = Tick { push: 2.0, ..stands };
        let runs = Tick::plain(4.0, 2.5 + 1.0 / 3.0);
        Clock::plain(0.0, 0.0).then(vec![slows, stands.turned(0.0, 0.0), starts, runs])
    }

    #[test]
    fn times_there_and_back_agree() {
        let clock = clock();
        for k in 0..=60 {
            let t = f64::from(k) * 0.1;
            let back = clock.when(clock.at(t).plan_s);
            assert!((back - t).abs() < 1e-6, "{t} {back}");
        }
    }

    #[test]
    fn a_clock_that_stops_at_once_runs_up_to_that_moment() {
        let cut = Clock::plain(0.0, 0.0).then(vec![Tick { rate: 0.0, ..Tick::plain(2.0, 2.0) }]);
        assert_eq!(cut.at(2.0).rate, 1.0);
        assert_eq!((cut.at(2.0_f64.next_up()).rate, cut.at(3.0).plan_s), (0.0, 2.0));
    }

    #[test]
    fn the_rate_changes_evenly() {
        let clock = clock();
        assert_eq!(clock.at(2.5).rate, 0.5);
        assert_eq!((clock.at(3.0).rate, clock.at(3.0).plan_s), (0.0, 2.5));
        assert!((clock.at(3.5).gain - 1.0).abs() < 1e-12);
        assert_eq!(clock.at(9.0).rate, 1.0);
    }
}
