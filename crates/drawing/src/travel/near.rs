//! The stops that are worth being visited next to a stop.

use super::map::Map;
use super::site::Site;
use kerf_geom::Bounds2;

/// Neighbours that are kept.
const NEIGHBOURS: usize = 14;
/// Stops whose bounds are nearest, of which the neighbours are found by their ways.
const CANDIDATES: usize = 48;

/// For each stop the nearest ones that may follow it, nearest first. What lies in a stop never follows it.
pub(super) fn neighbours(site: &Site) -> Vec<Vec<usize>> {
    let map = Map::of(site, 0..site.stops());
    (0..=site.stops()).map(|stop| of(site, &map, stop)).collect()
}

/// Stops by the gap between their bounds, among them all that are nearest: within a distance, which is doubled
/// until there are enough.
fn candidates(site: &Site, map: &Map, stop: usize) -> Vec<(f64, usize)> {
    let own = &site.stop(stop).bounds;
    let mut reach = 4.0 * map.spacing_mm();
    loop {
        let (area, mut near) = (own.grown(reach), Vec::new());
        map.meeting(&area, |other| {
            if other != stop && !lies_in(site, other, stop) {
                near.push((gap_squared(own, &site.stop(other).bounds), other));
            }
        });
        let sure = near.iter().filter(|(gap, _)| *gap <= reach * reach).count();
        if sure > CANDIDATES || map.lies_in(&area) {
            return near;
        }
        reach *= 2.0;
    }
}

fn of(site: &Site, map: &Map, stop: usize) -> Vec<usize> {
    let mut near = candidates(site, map, stop);
    let order = |a: &(f64, usize), b: &(f64, usize)| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1));
    if near.len() > CANDIDATES {
        near.select_nth_unstable_by(CANDIDATES, order);
        near.truncate(CANDIDATES);
    }
    near.iter_mut().for_each(|(gap, other)| *gap = way_gap_squared(site, stop, *other));
    near.sort_by(order);
    near.truncate(NEIGHBOURS);
    near.into_iter().map(|(_, other)| other).collect()
}

fn lies_in(site: &Site, inner: usize, outer: usize) -> bool {
    std::iter::successors(site.stop(inner).parent, |n| site.stop(*n).parent).any(|n| n == outer)
}

fn gap_squared(a: &Bounds2, b: &Bounds2) -> f64 {
    let apart = |low: f64, high: f64| (low - high).max(0.0);
    let x = apart(a.min.x, b.max.x).max(apart(b.min.x, a.max.x));
    let y = apart(a.min.y, b.max.y).max(apart(b.min.y, a.max.y));
    x * x + y * y
}

/// The least distance from where one is left to where the other is entered, squared.
fn way_gap_squared(site: &Site, from: usize, to: usize) -> f64 {
    let gaps = site.ways(from).iter().flat_map(|a| {
        site.ways(to).iter().map(|b| {
            let (x, y) = (a.leave.x - b.enter.x, a.leave.y - b.enter.y);
            x * x + y * y
        })
    });
    gaps.fold(f64::INFINITY, f64::min)
}
