//! A tour: an order of the stops, and a way to cut each.

use super::site::{CutEnds, Site};

/// An order of all stops, home first, and how each is cut.
#[derive(Clone, Debug)]
pub(super) struct Tour<'a> {
    pub site: &'a Site,
    order: Vec<usize>,
    /// Position of each stop in the order.
    place: Vec<usize>,
    /// Which of its ways each stop takes.
    way: Vec<usize>,
    /// Places where each stop is entered and left.
    ends: Vec<CutEnds>,
    tools: Vec<Option<u8>>,
}

impl<'a> Tour<'a> {
    /// A tour of the stops in an order, without home.
    pub fn new(site: &'a Site, stops: impl IntoIterator<Item = usize>) -> Self {
        let mut order = vec![site.home()];
        order.extend(stops);
        let mut place = vec![0; order.len()];
        order.iter().enumerate().for_each(|(at, stop)| place[*stop] = at);
        let ends = (0..order.len()).map(|stop| site.ways(stop)[0]).collect();
        let tools = (0..order.len()).map(|stop| site.stop(stop).tool).collect();
        let way = vec![0; order.len()];
        Self { site, order, place, way, ends, tools }
    }

    /// Stops in order, without home.
    pub fn shapes(&self) -> impl Iterator<Item = usize> + '_ {
        self.order.iter().skip(1).copied()
    }

    /// Returns the number of stops with home.
    pub fn len(&self) -> usize {
        self.order.len()
    }

    /// The stop at a place of the order; after the last comes home.
    pub fn at(&self, place: usize) -> usize {
        self.order.get(place).copied().unwrap_or(self.order[0])
    }

    pub fn place(&self, stop: usize) -> usize {
        self.place[stop]
    }

    pub fn next(&self, stop: usize) -> usize {
        self.at(self.place[stop] + 1)
    }

    pub fn previous(&self, stop: usize) -> usize {
        let place = self.place[stop];
        self.order[if place == 0 { self.order.len() - 1 } else { place - 1 }]
    }

    pub fn ends(&self, stop: usize) -> CutEnds {
        self.ends[stop]
    }

    pub fn way(&self, stop: usize) -> usize {
        self.way[stop]
    }

    pub fn set_way(&mut self, stop: usize, way: usize) {
        self.way[stop] = way;
        self.ends[stop] = self.site.ways(stop)[way];
    }

    /// Lets a closed shape begin at a place that is none of its ways.
    pub fn set_ends(&mut self, stop: usize, ends: CutEnds) {
        self.ends[stop] = ends;
    }

    /// Seconds from one stop to another.
    pub fn leg(&self, from: usize, to: usize) -> f64 {
        let tools = [self.tools[from], self.tools[to]];
        self.site.seconds(self.ends[from].leave, self.ends[to].enter, tools)
    }

    /// Seconds from the stop before to a stop and on to the one after, were it cut so.
    pub fn through(&self, before: usize, stop: usize, way: &CutEnds, after: usize) -> f64 {
        let [a, b, c] = [before, stop, after].map(|stop| self.tools[stop]);
        let (from, to) = (self.ends[before].leave, self.ends[after].enter);
        self.site.seconds(from, way.enter, [a, b]) + self.site.seconds(way.leave, to, [b, c])
    }

    /// No way through a stop takes less: to its bounds and from there.
    pub fn least_through(&self, before: usize, stop: usize, after: usize) -> f64 {
        let bounds = &self.site.stop(stop).bounds;
        let tools = [before, stop, after].map(|stop| self.tools[stop]);
        let rapid = |place, from, to| {
            self.site.seconds_of(bounds.distance_squared(place).sqrt(), [from, to])
        };
        rapid(self.ends[before].leave, tools[0], tools[1])
            + rapid(self.ends[after].enter, tools[1], tools[2])
    }

    /// Seconds of the whole tour, without lifts.
    #[cfg(test)]
    pub fn seconds(&self) -> f64 {
        self.order.iter().map(|stop| self.leg(*stop, self.next(*stop))).sum()
    }

    /// The stops at these places of the order.
    pub fn part(&self, from: usize, to: usize) -> &[usize] {
        &self.order[from..=to]
    }

    /// Writes another order into a part of the tour.
    pub fn refill(&mut self, from: usize, stops: &[usize]) {
        for (n, stop) in stops.iter().enumerate() {
            self.order[from + n] = *stop;
            self.place[*stop] = from + n;
        }
    }

    /// Puts the stops after `middle` up to `last` before those from `first` to `middle`.
    pub fn swap(&mut self, first: usize, middle: usize, last: usize) {
        self.order[first..=last].rotate_left(middle + 1 - first);
        self.number(first, last);
    }

    /// Runs through a part backwards.
    pub fn turn(&mut self, first: usize, last: usize) {
        self.order[first..=last].reverse();
        self.number(first, last);
    }

    fn number(&mut self, first: usize, last: usize) {
        for place in first..=last {
            self.place[self.order[place]] = place;
        }
    }
}
