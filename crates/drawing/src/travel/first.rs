//! The first tour: always to the nearest stop that may come next.

use super::site::Site;
use super::tour::Tour;

/// From home to the stop that is reached soonest, and on from there. What something lies in waits until
/// that is cut.
pub(super) fn tour(site: &Site) -> Tour<'_> {
    let mut waits: Vec<usize> = (0..site.stops()).map(|n| site.stop(n).children.len()).collect();
    let mut open: Vec<usize> = (0..site.stops()).filter(|n| waits[*n] == 0).collect();
    let (mut order, mut chosen) = (Vec::with_capacity(site.stops()), Vec::new());
    let (mut at, mut tool) = (site.ways(site.home())[0].leave, None);
    while let Some((slot, way)) = nearest(site, &open, at, tool) {
        let stop = open.swap_remove(slot);
        order.push(stop);
        chosen.push((stop, way));
        (at, tool) = (site.ways(stop)[way].leave, site.stop(stop).tool);
        if let Some(parent) = site.stop(stop).parent {
            waits[parent] -= 1;
            if waits[parent] == 0 {
                open.push(parent);
            }
        }
    }
    let mut tour = Tour::new(site, order);
    chosen.into_iter().for_each(|(stop, way)| tour.set_way(stop, way));
    tour
}

/// Which of the open stops is reached soonest, and by which of its ways. Of equals the first shape.
fn nearest(
    site: &Site,
    open: &[usize],
    at: kerf_geom::Point2,
    tool: Option<u8>,
) -> Option<(usize, usize)> {
    let mut found = None;
    let (mut least, mut number) = (f64::INFINITY, usize::MAX);
    for (slot, stop) in open.iter().enumerate() {
        let tools = [tool, site.stop(*stop).tool];
        // No place of the shape is nearer than its bounds.
        let far = site.stop(*stop).bounds.distance_squared(at).sqrt();
        if site.seconds_of(far, tools) > least {
            continue;
        }
        for (way, ends) in site.ways(*stop).iter().enumerate() {
            let seconds = site.seconds(at, ends.enter, tools);
            if seconds < least || (seconds == least && *stop < number) {
                (least, number, found) = (seconds, *stop, Some((slot, way)));
            }
        }
    }
    found
}
