//! Checks that paths clear a region, by nothing but distances.
//!
//! The region is covered with a grid of places. A place can be reached if a place of the grid where the
//! tool's centre may be lies no farther away than the radius; it is cut if the path does. Both are
//! exact for each place, so that a place found uncut is uncut; pieces smaller than the grid can hide.
#![allow(dead_code)]

use kerf_geom::{Bounds2, Indexed, Point2, Polyarc};

/// Result of a look at a grid.
#[derive(Debug, Default)]
pub struct Seen {
    /// Area that can be reached and is not cut, square millimetres.
    pub uncut_mm2: f64,
    /// The largest piece of it.
    pub largest_mm2: f64,
    /// A place of that piece.
    pub largest_at: Point2,
    /// Area that can be reached.
    pub reached_mm2: f64,
    /// Most distance that the tool's edge comes out of the region, millimetres.
    pub out_mm: f64,
}

/// Looks at the places of a grid with so many of them along the longer side.
pub fn look(region: &[Polyarc], paths: &[Polyarc], radius: f64, count: usize) -> Seen {
    let mut bounds = Bounds2::default();
    region.iter().for_each(|contour| bounds.merge(&contour.bounds()));
    let size = bounds.size();
    look_within(region, paths, radius, (bounds, size.x.max(size.y) / count as f64))
}

/// Looks at the places of a grid within bounds that are so far apart. What can be reached only from
/// outside the bounds is not seen.
pub fn look_within(
    region: &[Polyarc],
    paths: &[Polyarc],
    radius: f64,
    (bounds, cell): (Bounds2, f64),
) -> Seen {
    let contours = Indexed::new(region);
    let cuts = Indexed::new(paths);
    let size = bounds.size();
    let (nx, ny) = ((size.x / cell) as usize + 1, (size.y / cell) as usize + 1);
    let place = |x: usize, y: usize| {
        Point2::new(
            bounds.min.x + (x as f64 + 0.37) * cell,
            bounds.min.y + (y as f64 + 0.61) * cell,
        )
    };
    let depth = |at: Point2| {
        let distance = contours.nearest(at).map_or(0.0, |found| found.1.distance);
        if contours.winding(at) > 0 { distance } else { -distance }
    };
    let centre: Vec<bool> = (0..nx * ny).map(|k| depth(place(k % nx, k / nx)) >= radius).collect();
    let reached = dilated(&centre, nx, ny, radius / cell);
    let uncut: Vec<bool> = (0..nx * ny)
        .map(|k| reached[k] && !cuts.is_nearer(place(k % nx, k / nx), radius + 1e-6))
        .collect();
    let area = |cells: usize| cells as f64 * cell * cell;
    let count = |list: &[bool]| area(list.iter().filter(|yes| **yes).count());
    let (most, first) = largest(&uncut, nx, ny);
    Seen {
        uncut_mm2: count(&uncut),
        largest_mm2: area(most),
        largest_at: place(first % nx, first / nx),
        reached_mm2: count(&reached),
        out_mm: out(&cuts, &contours, radius),
    }
}

/// The places of a grid no farther than `reach` cells from one that is set.
fn dilated(set: &[bool], nx: usize, ny: usize, reach: f64) -> Vec<bool> {
    // First along rows, how far it is to the next one that is set; then down the columns.
    let far = 1e9;
    let mut along = vec![far; nx * ny];
    for y in 0..ny {
        for (from, step) in [(0, 1_isize), (nx - 1, -1)] {
            let mut last = far;
            for n in 0..nx {
                let x = (from as isize + step * n as isize) as usize;
                last = if set[y * nx + x] { 0.0 } else { last + 1.0 };
                along[y * nx + x] = f64::min(along[y * nx + x], last);
            }
        }
    }
    let rows = reach as usize;
    let near = |k: usize| {
        let (x, y) = (k % nx, k / nx);
        (y.saturating_sub(rows)..(y + rows + 1).min(ny)).any(|other| {
            let dy = other as f64 - y as f64;
            along[other * nx + x].hypot(dy) <= reach
        })
    };
    (0..nx * ny).map(near).collect()
}

/// Size of the largest piece in cells, and one of them.
fn largest(set: &[bool], nx: usize, ny: usize) -> (usize, usize) {
    let mut seen = vec![false; set.len()];
    let mut most = (0, 0);
    for start in 0..set.len() {
        let (mut open, mut size) = (vec![start], 0);
        while let Some(k) = open.pop() {
            if !set[k] || std::mem::replace(&mut seen[k], true) {
                continue;
            }
            size += 1;
            let (x, y) = (k % nx, k / nx);
            let row = x.saturating_sub(1)..(x + 2).min(nx);
            open.extend(
                row.flat_map(|x| (y.saturating_sub(1)..(y + 2).min(ny)).map(move |y| y * nx + x)),
            );
        }
        if size > most.0 {
            most = (size, start);
        }
    }
    most
}

/// Distance that the edge of a tool whose centre follows paths comes out of the region.
fn out(cuts: &Indexed, contours: &Indexed, radius: f64) -> f64 {
    let mut out: f64 = 0.0;
    for segment in cuts.segments() {
        let count = (segment.length() / (0.01 * radius)).ceil().clamp(1.0, 2000.0) as usize;
        for k in 0..=count {
            let at = segment.at(k as f64 / count as f64);
            let distance = contours.nearest(at).map_or(0.0, |found| found.1.distance);
            let depth = if contours.winding(at) > 0 { distance } else { -distance };
            out = out.max(radius - depth);
        }
    }
    out
}
