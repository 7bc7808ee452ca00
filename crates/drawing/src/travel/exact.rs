//! Every order at once, for few stops: dynamic programming over subsets (Held and Karp 1962), with the ways
//! of each stop and with precedence.

use super::site::Site;
use super::tour::Tour;

/// The best tour there is, over the ways there are. Memory grows with 2ⁿ: for few stops only.
pub(super) fn tour(site: &Site) -> Tour<'_> {
    let states = States::of(site);
    let all = (1usize << site.stops()) - 1;
    let mut least = vec![f64::INFINITY; (all + 1) * states.count];
    let mut before = vec![usize::MAX; least.len()];
    for (state, seconds) in states.first.iter().enumerate() {
        let stop = states.stop[state];
        if states.inside[stop] == 0 {
            least[(1 << stop) * states.count + state] = *seconds;
        }
    }
    for done in 1..all {
        for from in 0..states.count {
            let so_far = least[done * states.count + from];
            if so_far.is_finite() {
                states.go_on(done, from, so_far, &mut least, &mut before);
            }
        }
    }
    states.follow_back(site, all, &least, &before)
}

/// Each way of each stop is a state: where the head may stand after a cut.
struct States {
    count: usize,
    stop: Vec<usize>,
    way: Vec<usize>,
    /// The stops, as a set, that lie in each stop.
    inside: Vec<usize>,
    /// Seconds from home, to home, and from each to each.
    first: Vec<f64>,
    last: Vec<f64>,
    leg: Vec<f64>,
}

impl States {
    fn of(site: &Site) -> Self {
        let ways = |stop: usize| (0..site.ways(stop).len()).map(move |way| (stop, way));
        let (stop, way): (Vec<usize>, Vec<usize>) = (0..site.stops()).flat_map(ways).unzip();
        let home = (site.home(), 0);
        let seconds = |(from, a): (usize, usize), (to, b): (usize, usize)| {
            let tools = [site.stop(from).tool, site.stop(to).tool];
            site.seconds(site.ways(from)[a].leave, site.ways(to)[b].enter, tools)
        };
        let all = || stop.iter().copied().zip(way.iter().copied());
        let set = |n: usize| site.stop(n).children.iter().map(|child| 1 << child).sum();
        Self {
            count: stop.len(),
            first: all().map(|to| seconds(home, to)).collect(),
            last: all().map(|from| seconds(from, home)).collect(),
            leg: all()
                .flat_map(|from| all().map(move |to| (from, to)))
                .map(|(a, b)| seconds(a, b))
                .collect(),
            inside: (0..site.stops()).map(set).collect(),
            stop,
            way,
        }
    }

    /// From a state on to every stop that is not done and may come next.
    fn go_on(
        &self,
        done: usize,
        from: usize,
        so_far: f64,
        least: &mut [f64],
        before: &mut [usize],
    ) {
        for to in 0..self.count {
            let stop = self.stop[to];
            let missing = self.inside[stop] & !done;
            if done & (1 << stop) != 0 || missing != 0 {
                continue;
            }
            let seconds = so_far + self.leg[from * self.count + to];
            let slot = (done | 1 << stop) * self.count + to;
            if seconds < least[slot] {
                (least[slot], before[slot]) = (seconds, from);
            }
        }
    }

    fn follow_back<'a>(
        &self,
        site: &'a Site,
        all: usize,
        least: &[f64],
        before: &[usize],
    ) -> Tour<'a> {
        let whole = |state: &usize| least[all * self.count + state] + self.last[*state];
        let end = (0..self.count).min_by(|a, b| whole(a).total_cmp(&whole(b)));
        let (mut done, mut state) = (all, end.unwrap_or_default());
        let mut chosen = Vec::with_capacity(site.stops());
        while done != 0 {
            chosen.push(state);
            let slot = done * self.count + state;
            done &= !(1 << self.stop[state]);
            state = before[slot];
        }
        let mut tour = Tour::new(site, chosen.iter().rev().map(|state| self.stop[*state]));
        chosen.iter().for_each(|state| tour.set_way(self.stop[*state], self.way[*state]));
        tour
    }
}
