//! Nodes of a motion along a path, and the motion between two of them in closed form.

/// Halvings in search of a time.
const HALVINGS: u32 = 50;

/// A place on the way, with speed and time; between two of them s̈ is constant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Node {
    /// Along the track.
    pub at_mm: f64,
    /// Speed along the track.
    pub v: f64,
    /// Time of the plan.
    pub t_s: f64,
}

/// Motion after a node where jerk is limited.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Push {
    /// s̈ at the node.
    pub accel: f64,
    /// Constant over time up to the next node; `None` where s̈ is linear in s instead.
    pub jerk: Option<f64>,
}

/// A place on the path with the motion along it.
#[derive(Clone, Copy, Debug)]
pub struct Along {
    /// Along the track.
    pub at_mm: f64,
    /// Speed along the track.
    pub v: f64,
    /// s̈.
    pub accel: f64,
}

/// The motion at a time since a node, where jerk is limited.
pub(crate) fn pushed(a: &Node, push: &Push, next: &Node, s: f64) -> Along {
    let here = match push.jerk {
        Some(jerk) => Along {
            at_mm: a.at_mm + s * (a.v + s * (0.5 * push.accel + s * jerk / 6.0)),
            v: a.v + s * (push.accel + 0.5 * s * jerk),
            accel: push.accel + s * jerk,
        },
        None => {
            let way = next.at_mm - a.at_mm;
            let end = (next.v * next.v - a.v * a.v) / way - push.accel;
            swing(a, push.accel, (end - push.accel) / way, s)
        }
    };
    Along { at_mm: between(a, next, here.at_mm), v: here.v.max(0.0), ..here }
}

/// A node at a place between two, where jerk is limited, and how the motion goes on after it.
pub(crate) fn halve(a: &Node, push: &Push, b: &Node, at_mm: f64) -> (Node, Push) {
    let (mut low, mut high) = (0.0, b.t_s - a.t_s);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if pushed(a, push, b, middle).at_mm < at_mm { low = middle } else { high = middle }
    }
    let Along { v, accel, .. } = pushed(a, push, b, high);
    (Node { at_mm, v, t_s: a.t_s + high }, Push { accel, jerk: push.jerk })
}

/// A place between two nodes; before the second, when it is a stop, so that rounding does not put
/// the last moments of one direction into the next.
pub(crate) fn between(a: &Node, b: &Node, at_mm: f64) -> f64 {
    let last = if b.v > 0.0 { b.at_mm } else { b.at_mm.next_down() };
    at_mm.min(last).max(a.at_mm)
}

/// Motion with s̈ linear in s: s̈ = accel + rate·(s − s₀).
pub(crate) fn swing(from: &Node, accel: f64, rate: f64, s: f64) -> Along {
    let w = rate.abs().sqrt();
    // c = cos or cosh, and what else the solution is made of, by series where nothing swings.
    let (c, sine, rest) = if w * s < 1e-3 {
        let q = rate * s * s;
        (1.0 + q / 2.0, s * (1.0 + q / 6.0), s * s * (0.5 + q / 24.0))
    } else if rate > 0.0 {
        let (c, sine) = ((w * s).cosh(), (w * s).sinh());
        (c, sine / w, (c - 1.0) / rate)
    } else {
        let (sine, c) = (w * s).sin_cos();
        (c, sine / w, (c - 1.0) / rate)
    };
    Along {
        at_mm: from.at_mm + from.v * sine + accel * rest,
        v: from.v * c + accel * sine,
        accel: accel * c + rate * from.v * sine,
    }
}

/// Adds a node reached with constant s̈.
pub(crate) fn step(nodes: &mut Vec<Node>, at_mm: f64, v: f64) {
    if let Some(before) = nodes.last() {
        let way = at_mm - before.at_mm;
        if way > 0.0 {
            let t_s = before.t_s + 2.0 * way / (before.v + v);
            nodes.push(Node { at_mm, v, t_s });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_swing_is_what_its_equation_says() {
        let from = Node { at_mm: 3.0, v: 2.0, t_s: 0.0 };
        for (rate, s) in [(4.0, 0.7), (-4.0, 0.7), (0.0, 0.7), (1e-7, 2.0), (-1e-7, 2.0)] {
            let at = |s| swing(&from, 5.0, rate, s);
            let (d, here) = (1e-4, at(s));
            let (before, after) = (at(s - d), at(s + d));
            let slope = |a: f64, b: f64| (b - a) / (2.0 * d);
            assert!((slope(before.at_mm, after.at_mm) - here.v).abs() < 1e-5, "{rate}");
            assert!((slope(before.v, after.v) - here.accel).abs() < 1e-5, "{rate}");
            let due = 5.0 + rate * (here.at_mm - from.at_mm);
            assert!((here.accel - due).abs() < 1e-9, "{rate}: {} and not {due}", here.accel);
        }
    }

    #[test]
    fn a_swing_by_series_goes_on_as_one_by_functions() {
        let from = Node { at_mm: 0.0, v: 2.0, t_s: 0.0 };
        for rate in [1e-2, -1e-2] {
            // Where the one gives way to the other.
            let [series, whole] =
                [1.0 - 1e-9, 1.0 + 1e-9].map(|k| swing(&from, 5e8, rate, k * 1e-2));
            assert!((series.at_mm / whole.at_mm - 1.0).abs() < 1e-8, "{series:?} {whole:?}");
        }
    }
}
