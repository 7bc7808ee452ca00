//! A length that no round trip through places is below: the 1-tree with prices (Held and Karp 1970).

use kerf_geom::Point2;

/// Rounds of changing the prices.
const ROUNDS: usize = 150;

/// The greatest bound found, in the places' unit. The first place is the one outside the tree.
pub fn one_tree(places: &[Point2]) -> f64 {
    let mut prices = vec![0.0; places.len()];
    let (mut best, mut step) = (0.0f64, 0.0);
    for round in 0..ROUNDS {
        let (length, degrees) = tree(places, &prices);
        let bound = length - 2.0 * prices.iter().sum::<f64>();
        best = best.max(bound);
        if round == 0 {
            step = 0.5 * length / places.len() as f64;
        }
        for (price, degree) in prices.iter_mut().zip(&degrees) {
            *price += step * (*degree as f64 - 2.0);
        }
        step *= 0.97;
    }
    best
}

/// The least tree through all places but the first and the two shortest legs to that one, with prices
/// added, and how many legs each place has.
fn tree(places: &[Point2], prices: &[f64]) -> (f64, Vec<usize>) {
    let cost = |a: usize, b: usize| places[a].distance(places[b]) + prices[a] + prices[b];
    let mut degrees = vec![0; places.len()];
    let mut near: Vec<(f64, usize)> = (0..places.len()).map(|n| (cost(1, n), 1)).collect();
    let mut done = vec![false; places.len()];
    (done[0], done[1]) = (true, true);
    let mut length = 0.0;
    for _ in 2..places.len() {
        let open = (0..places.len()).filter(|n| !done[*n]);
        let Some(next) = open.min_by(|a, b| near[*a].0.total_cmp(&near[*b].0)) else { break };
        length += near[next].0;
        degrees[next] += 1;
        degrees[near[next].1] += 1;
        done[next] = true;
        for other in (0..places.len()).filter(|n| !done[*n]) {
            let reached = cost(next, other);
            if reached < near[other].0 {
                near[other] = (reached, next);
            }
        }
    }
    let mut first: Vec<usize> = (1..places.len()).collect();
    first.sort_by(|a, b| cost(0, *a).total_cmp(&cost(0, *b)));
    for other in first.iter().take(2) {
        length += cost(0, *other);
        degrees[0] += 1;
        degrees[*other] += 1;
    }
    (length, degrees)
}
