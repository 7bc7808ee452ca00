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
        if 4 * (site.stops() - order.len()) < 3 * map.len() {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::travel::Search;
    use crate::{Drawing, Shape};

    /// Circles and points of three tools, by a rule that scatters them; some lie in others.
    fn scattered(count: usize) -> Drawing {
        let place = |n: usize| Point2::new((n * 7919 % 1009) as f64, (n * 104_729 % 997) as f64);
        let shape = |n: usize| match n % 3 {
            0 => Shape::point(place(n)),
            _ => Shape::flat(kerf_geom::Polyarc::circle(place(n), (n % 17 + 1) as f64)),
        };
        let mut drawing = Drawing::of((0..count).map(shape));
        for (n, group) in crate::Group::ALL.into_iter().take(3).enumerate() {
            drawing.settings_mut(group).tool = n as u8 + 1;
        }
        let coloured = drawing.shapes.iter().enumerate().map(|(n, shape)| {
            let group = crate::Group::ALL[n / 40 % 3];
            std::sync::Arc::new(Shape { group, ..shape.as_ref().clone() })
        });
        drawing.shapes = coloured.collect();
        drawing
    }

    /// The same order with a look at all stops for each.
    fn looked_at_all(site: &Site) -> Vec<usize> {
        let (mut order, mut at, mut tool) = (Vec::new(), site.ways(site.home())[0].leave, None);
        let mut left: Vec<usize> = (0..site.stops()).collect();
        while !left.is_empty() {
            let ready =
                |stop: &&usize| site.stop(**stop).children.iter().all(|c| order.contains(c));
            let ways = left.iter().filter(ready).flat_map(|stop| {
                let tools = [tool, site.stop(*stop).tool];
                let seconds = move |enter| site.seconds(at, enter, tools);
                site.ways(*stop).iter().map(move |way| (seconds(way.enter), *stop, way.leave))
            });
            let best = ways.min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
            let Some((_, stop, leave)) = best else { break };
            (at, tool) = (leave, site.stop(stop).tool);
            order.push(stop);
            left.retain(|other| *other != stop);
        }
        order
    }

    #[test]
    fn the_nearest_is_found_without_a_look_at_all() {
        for (count, starts) in [(1, true), (2, false), (60, true), (300, false), (300, true)] {
            let drawing = scattered(count);
            let site = Site::of(&drawing, &Search { starts, ..Search::default() });
            let order: Vec<usize> = tour(&site).shapes().collect();
            assert_eq!(order, looked_at_all(&site), "{count}");
        }
    }

    #[test]
    fn places_in_one_line_and_in_one_place_are_found() {
        let line = |n: usize| Point2::new((n * 31 % 50) as f64, 3.0);
        for place in [line, |_| Point2::new(5.0, 5.0)] {
            let drawing = Drawing::of((0..50).map(|n| Shape::point(place(n))));
            let site = Site::of(&drawing, &Search::default());
            assert_eq!(tour(&site).shapes().count(), 50);
        }
    }
}
