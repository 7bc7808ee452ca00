//! The best way through every stop, for an order that is given: exact over the ways there are.

use super::tour::Tour;

/// Chooses the ways with the least time. Stops are passed in order; for each way of a stop the best way of
/// the stop before it is remembered, and the chain is followed back from home.
pub(super) fn choose(tour: &mut Tour) {
    let site = tour.site;
    let stops: Vec<usize> = tour.shapes().chain([site.home()]).collect();
    let mut least = vec![0.0];
    let mut came_from: Vec<Vec<usize>> = Vec::with_capacity(stops.len());
    let mut before = site.home();
    for stop in &stops {
        let tools = [site.stop(before).tool, site.stop(*stop).tool];
        let step = |to: &super::site::CutEnds| {
            let from = site.ways(before).iter().zip(&least).enumerate();
            let reached = from
                .map(|(n, (way, so_far))| (n, so_far + site.seconds(way.leave, to.enter, tools)));
            reached.fold((0, f64::INFINITY), |best, next| if next.1 < best.1 { next } else { best })
        };
        let steps: Vec<(usize, f64)> = site.ways(*stop).iter().map(step).collect();
        least = steps.iter().map(|step| step.1).collect();
        came_from.push(steps.into_iter().map(|step| step.0).collect());
        before = *stop;
    }
    let mut way = 0;
    for (n, stop) in stops.iter().enumerate().rev() {
        tour.set_way(*stop, way);
        way = came_from[n][way];
    }
}
