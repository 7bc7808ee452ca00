//! Curves as chords, for programs that know no arcs.

use kerf_geom::Polyarc;

/// Places along a polyarc, chords nowhere farther from an arc than `tolerance`.
pub fn flattened(path: &Polyarc, tolerance: f64) -> Vec<[f64; 2]> {
    let mut places = Vec::new();
    for segment in path.segments() {
        let arc = segment.arc().map_or((0.0, 0.0), |a| (a.radius(), a.sweep_rad.abs()));
        // A chord over an angle u lies r(1 − cos(u/2)) off its arc.
        let step = 2.0 * (1.0 - (tolerance / arc.0.max(tolerance)).min(1.0)).acos();
        let chords = if arc.1 > 0.0 { (arc.1 / step).ceil().max(1.0) as usize } else { 1 };
        places
            .extend((0..chords).map(|k| segment.at(k as f64 / chords as f64)).map(|p| [p.x, p.y]));
    }
    places
}
