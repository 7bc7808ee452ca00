//! Moments at which something that depends on time becomes true or false.

/// Stretch of time in which something changes once at the most, and speed only rises or only falls, seconds.
pub const SLICE_S: f64 = 0.001;

/// Precision with which the moment of a change is sought, seconds.
pub const EXACT_S: f64 = 1e-7;

/// Finds when something becomes true or false in a stretch of time, the state at its beginning first.
pub fn flips(from_s: f64, to_s: f64, is: &dyn Fn(f64) -> bool) -> Vec<(f64, bool)> {
    let mut states = vec![(from_s, is(from_s))];
    let slices = ((to_s - from_s) / SLICE_S).ceil().max(1.0) as u64;
    for slice in 1..=slices {
        let end_s = from_s + (to_s - from_s) * slice as f64 / slices as f64;
        let (begin_s, before) = states.last().copied().unwrap_or_default();
        if is(end_s) == before {
            continue;
        }
        let start_s = begin_s.max(end_s - (to_s - from_s) / slices as f64);
        states.push((flip(start_s, end_s, before, is), !before));
    }
    states
}

/// Finds the moment, between two others, at which a state ends.
fn flip(mut from_s: f64, mut to_s: f64, before: bool, is: &dyn Fn(f64) -> bool) -> f64 {
    while to_s - from_s > EXACT_S {
        let middle_s = 0.5 * (from_s + to_s);
        if is(middle_s) == before { from_s = middle_s } else { to_s = middle_s }
    }
    to_s
}
