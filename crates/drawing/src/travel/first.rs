//! The first tour: always to the nearest stop that may come next.

use super::map::Map;
use super::site::Site;
use super::tour::Tour;
use kerf_geom::{Bounds2, Point2};

/// From home to the stop that is reached soonest, and on from there. What something lies in waits until
/// that is cut.
pub(super) fn tour(site: &Site) -> Tour<'_> {
    let mut waits: Vec<usize> = (0..site.stops()).map(|n| site.stop(n).children.len()).collect();
    let mut open: Vec<bool> = waits.iter().map(|waits| *waits == 0).collect();
    let (mut order, mut chosen) = (Vec::with_capacity(site.stops()), Vec::new());
    let (mut at, mut tool) = (site.ways(site.home())[0].leave, None);
    let mut map = Map::of(site, 0..site.stops());
    let mut done = vec![false; site.stops()];
    while let Some((stop, way)) = nearest(site, &map, &open, at, tool) {
        order.push(stop);
        chosen.push((stop, way));
        (open[stop], done[stop]) = (false, true);
        (at, tool) = (site.ways(stop)[way].leave, site.stop(stop).tool);
        if let Some(parent) = site.stop(stop).parent {
            waits[parent] -= 1;
            open[parent] = waits[parent] == 0;
        }
        // Places that are done with would be looked at again and again.
        if 2 * (site.stops() - order.len()) < map.len() {
            map = Map::of(site, (0..site.stops()).filter(|n| !done[*n]));
        }
    }
    let mut tour = Tour::new(site, order);
    chosen.into_iter().for_each(|(stop, way)| tour.set_way(stop, way));
    tour
}

/// Which of the open stops is reached soonest, and by which of its ways. Of equals the first shape. Sought is
/// in wider and wider squares: what lies outside of one is farther.
fn nearest(
    site: &Site,
    map: &Map,
    open: &[bool],
    at: Point2,
    tool: Option<u8>,
) -> Option<(usize, usize)> {
    let mut reach = map.spacing_mm();
    loop {
        let area = Bounds2::of(at, at).grown(reach);
        let (mut found, mut least) = (None, (f64::INFINITY, usize::MAX));
        map.meeting(&area, |stop| {
            let tools = [tool, site.stop(stop).tool];
            for (way, ends) in site.ways(stop).iter().enumerate().filter(|_| open[stop]) {
                let seconds = site.seconds(at, ends.enter, tools);
                if (seconds, stop) < least {
                    (least, found) = ((seconds, stop), Some((stop, way)));
                }
            }
        });
        if least.0 < site.seconds_of(reach, [tool, tool]) || map.lies_in(&area) {
            return found;
        }
        reach *= 2.0;
    }
}
