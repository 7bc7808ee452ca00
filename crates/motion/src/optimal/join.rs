//! Putting pieces of plan together.

use super::timed::Timed;
use super::track::Track;

impl Timed {
    /// Adds the next piece of the same stack, which begins when this one ends; so many moves come
    /// before it.
    pub fn join(&mut self, mut next: Self, moves: usize) {
        let (Some(end), Some(begin)) = (self.nodes.last(), next.nodes.first()) else {
            return *self = next;
        };
        let shift_mm = end.at_mm - begin.at_mm;
        // What lies beyond the ends was there only for the corners at them.
        let own = self.track.at_mm.partition_point(|at| *at <= end.at_mm);
        let past = next.track.at_mm.partition_point(|at| *at <= begin.at_mm);
        // The place where both meet belongs to both, unless the chain is broken there.
        let meets = past > 0 && !next.track.breaks[past - 1];
        let from = if meets { past } else { past.saturating_sub(1) };
        if let (true, Some(owner)) = (meets, next.track.owner.get(past - 1)) {
            self.track.owner[own - 1] = owner + moves as u32;
        }
        self.track.join(own, &mut next.track, from, shift_mm, moves as u32);
        self.widths.truncate(own);
        self.widths.extend_from_slice(&next.widths[from..]);
        next.nodes.iter_mut().for_each(|node| node.at_mm += shift_mm);
        self.nodes.extend_from_slice(&next.nodes[1..]);
        self.pushes.pop();
        self.pushes.append(&mut next.pushes);
    }
}

impl Track {
    /// Cuts this part off after so many vertices and adds another from a vertex on.
    fn join(&mut self, own: usize, next: &mut Self, from: usize, shift_mm: f64, moves: u32) {
        if self.dims < next.dims {
            self.widen();
        } else if next.dims < self.dims {
            next.widen();
        }
        let dims = self.dims;
        self.coords.truncate(own * dims);
        self.coords.extend_from_slice(&next.coords[from * dims..]);
        self.at_mm.truncate(own);
        self.at_mm.extend(next.at_mm[from..].iter().map(|at| at + shift_mm));
        self.owner.truncate(own);
        self.owner.extend(next.owner[from..].iter().map(|owner| owner + moves));
        self.breaks.truncate(own);
        self.breaks.extend_from_slice(&next.breaks[from..]);
    }
}
