//! Stops that have to be visited, and the ways to cut each.

use super::{Rapids, Search};
use crate::{Drawing, GroupSettings, Kind, Nesting, Shape};
use kerf_geom::{Bounds2, Point2};
use std::sync::Arc;

/// Places where a cut begins and ends.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct CutEnds {
    pub enter: Point2,
    pub leave: Point2,
}

impl CutEnds {
    const fn at(place: Point2) -> Self {
        Self { enter: place, leave: place }
    }
}

/// A shape that is cut.
#[derive(Clone, Debug)]
pub(super) struct Stop {
    /// Its place in the drawing.
    pub shape: usize,
    /// Ways in which it may be cut: places of a closed one, both directions of an open one.
    pub ways: Vec<CutEnds>,
    /// The stop that must come later, because this one lies in it.
    pub parent: Option<usize>,
    /// The stops that lie directly in this one.
    pub children: Vec<usize>,
    pub tool: Option<u8>,
    pub bounds: Bounds2,
    /// Its cut takes the same ways in a tour that is run backwards.
    pub turnable: bool,
    /// The best of all places of its contour may be taken.
    pub free: bool,
}

/// Everything that has to be visited. The last stop is home, where the trip begins and ends.
#[derive(Clone, Debug)]
pub(super) struct Site {
    stops: Vec<Stop>,
    rapids: Rapids,
}

/// Places of a closed shape that are tried.
const PLACES: usize = 24;

impl Site {
    pub fn of(drawing: &Drawing, search: &Search) -> Self {
        let on = |n: &usize| drawing.settings(drawing.shapes[*n].group).on;
        let cut: Vec<usize> = (0..drawing.shapes.len()).filter(on).collect();
        let shapes: Vec<Arc<Shape>> = cut.iter().map(|n| drawing.shapes[*n].clone()).collect();
        let nesting = Nesting::of(&shapes);
        let mut stops: Vec<Stop> = (0..cut.len())
            .map(|n| stop(&shapes[n], cut[n], nesting.parent(n), drawing, search.starts))
            .collect();
        for n in 0..stops.len() {
            if let Some(parent) = stops[n].parent {
                stops[parent].children.push(n);
            }
        }
        stops.push(home(search.from));
        Self { stops, rapids: search.rapids }
    }

    /// Returns the number of stops, home not counted.
    pub fn stops(&self) -> usize {
        self.stops.len() - 1
    }

    pub fn home(&self) -> usize {
        self.stops.len() - 1
    }

    pub fn stop(&self, stop: usize) -> &Stop {
        &self.stops[stop]
    }

    pub fn ways(&self, stop: usize) -> &[CutEnds] {
        &self.stops[stop].ways
    }

    pub fn shape(&self, stop: usize) -> usize {
        self.stops[stop].shape
    }

    /// Tells whether the start of a stop may be another one after the search.
    pub fn is_free(&self, stop: usize) -> bool {
        self.stops[stop].ways.len() > 1 || self.stops[stop].free
    }

    /// Seconds from a place where one tool has cut to a place where another will.
    pub fn seconds(&self, from: Point2, to: Point2, tools: [Option<u8>; 2]) -> f64 {
        // Without `hypot`, which guards against overflow that checked coordinates cannot cause: most of
        // the search is spent here.
        let (x, y) = (from.x - to.x, from.y - to.y);
        self.seconds_of((x * x + y * y).sqrt(), tools)
    }

    /// Seconds of a distance between the cuts of two tools.
    pub fn seconds_of(&self, distance_mm: f64, tools: [Option<u8>; 2]) -> f64 {
        let change = matches!(tools, [Some(a), Some(b)] if a != b);
        let change_s = if change { self.rapids.tool_change_s } else { 0.0 };
        self.rapids.seconds(distance_mm) + change_s
    }
}

fn home(from: Point2) -> Stop {
    Stop {
        shape: usize::MAX,
        ways: vec![CutEnds::at(from)],
        parent: None,
        children: Vec::new(),
        tool: None,
        bounds: Bounds2::of(from, from),
        turnable: false,
        free: false,
    }
}

fn stop(shape: &Shape, n: usize, parent: Option<usize>, drawing: &Drawing, starts: bool) -> Stop {
    let settings = drawing.settings(shape.group);
    let closed = shape.is_closed();
    let point = shape.kind() == Kind::Point;
    let turnable = starts && !closed && !point && may_turn(settings);
    let leads = settings.lead_in.is_some() || settings.lead_out.is_some();
    Stop {
        shape: n,
        ways: match () {
            () if closed && !point && starts => places(shape, leads),
            () if turnable => both_ways(shape),
            () => vec![present(shape)],
        },
        parent,
        children: Vec::new(),
        tool: Some(settings.tool),
        bounds: shape.path.bounds(),
        turnable: turnable || closed || point,
        free: closed && !point && starts && !leads,
    }
}

fn present(shape: &Shape) -> CutEnds {
    let enter = shape.start();
    CutEnds {
        enter,
        leave: if shape.is_closed() { enter } else { shape.path.end().unwrap_or(enter) },
    }
}

fn both_ways(shape: &Shape) -> Vec<CutEnds> {
    let there = present(shape);
    vec![there, CutEnds { enter: there.leave, leave: there.enter }]
}

/// Returns `true` if an open shape may be cut the other way round: nothing of its path lies on one side of it or at
/// one end.
fn may_turn(settings: &GroupSettings) -> bool {
    let GroupSettings { offset_mm, rough_mm, tag_mm, lead_in, lead_out, .. } = settings;
    let plain = *offset_mm == 0.0 && *rough_mm == 0.0 && *tag_mm == 0.0;
    plain && !lead_in.is_some() && !lead_out.is_some()
}

/// Places where the cut of a closed shape may begin. With leads they are the middles of its segments, and
/// a start that someone chose within one: a lead at a corner cuts into the part, or into what lies beside
/// it.
fn places(shape: &Shape, leads: bool) -> Vec<CutEnds> {
    let path = &shape.path;
    if leads {
        let every = path.segment_count().div_ceil(PLACES).max(1);
        let middles = path.segments().step_by(every).map(|segment| CutEnds::at(segment.at(0.5)));
        return shape.start_inserted.then(|| present(shape)).into_iter().chain(middles).collect();
    }
    let step = path.length() / PLACES as f64;
    let others = (1..PLACES).filter_map(|n| path.place_after(step * n as f64));
    [present(shape)].into_iter().chain(others.map(|place| CutEnds::at(place.at))).collect()
}
