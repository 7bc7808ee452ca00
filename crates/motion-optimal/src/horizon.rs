//! Speeds under a limit of jerk, found while the path is read.
//!
//! The path is planned in windows, each as if the machine stood where the window ends. What is farther
//! from that end than braking takes hardly depends on it: that is final, and the next window begins
//! there in motion, at the same speed and acceleration.
//!
//! ```text
//!  ṡ ▲     ______          this window          what is final, and the next window
//!    │    ╱      ╲____
//!    │   ╱        ┊   ╲
//!    │  ╱  final  ┊    ╲
//!    └─┴──────────┴─────┴──────────────► s
//! ```
//!
//! Should no way be found from there, the rest of the window before is run as it is, to its stand.

use crate::begin::Begin;
use crate::bounds::Bounds;
use crate::cells::{Cell, Cells, Known};
use crate::found::Found;
use crate::kernel::Kernel;
use crate::launch::{End, Launch};
use crate::leg::Leg;
use crate::node::Node;
use crate::problem::Problem;
use crate::scurve::phases;
use crate::speed_piece::SpeedPiece;
use crate::track::Track;
use crate::widths::Smoothing;
use crate::window::{Window, guide};
use kerf_program::Dynamics;

/// Braking counts as so many times what a straight line needs.
const BRAKES: f64 = 1.5;

/// A window is so many times as long as braking takes; the first one after another feed less, to be
/// ready soon, and each that follows by a factor more.
const LONG: f64 = 3.0;
const SHORT: f64 = 1.6;
const LONGER: f64 = 1.3;

/// Cost that the barriers may have at the end, as a share of the time; and in short windows, of which
/// little is final.
const GAP: f64 = 2e-3;
const GAP_SHORT: f64 = 2e-2;

/// Windows have at least so many cells.
const LEAST: usize = 96;
const LEAST_SHORT: usize = 24;

/// The pieces of the last window are kept over this share of braking: there its motion is still near
/// the one that is sought.
const KEPT: f64 = 0.4;

/// Cells among which the end of a window is looked for.
const ENDS: usize = 8;

/// Speeds along the path of a stack.
#[derive(Clone, Debug)]
pub(crate) struct Horizon<const N: usize> {
    bounds: Bounds<N>,
    jerk: [f64; N],
    smoothing: Smoothing<N>,
    /// Above zero half-widths, zero where the machine stands, below zero where there is no turn and
    /// so no bump.
    pub widths: Vec<f64>,
    walk: Option<Cells<N>>,
    /// The vertex at which the run begins, and up to which its end was looked for.
    first: usize,
    searched: usize,
    /// Cells that are not planned for good.
    cells: Vec<Cell<N>>,
    /// Nothing before counts.
    from_mm: f64,
    begin: Begin,
    /// A window is looked for when so many cells are known.
    enough: usize,
    long: f64,
    pub found: Found,
    /// No way was found from the motion with which it began.
    pub lost: bool,
}

impl<const N: usize> Horizon<N> {
    /// From rest at the beginning of a track.
    pub fn new(dynamics: &Dynamics) -> Self {
        let jerk = dynamics.jerk_mm_s3.unwrap_or_default();
        Self {
            bounds: Bounds::of(dynamics),
            jerk: std::array::from_fn(|k| jerk.0[k].max(1e-3)),
            smoothing: Smoothing::new(Kernel::Triangle),
            widths: Vec::new(),
            walk: None,
            first: 0,
            searched: 0,
            cells: Vec::new(),
            from_mm: 0.0,
            begin: Begin::Rest,
            enough: LEAST,
            long: LONG,
            found: Found::at_rest(),
            lost: false,
        }
    }

    /// In motion from a place on, where ways within the limits begin.
    pub fn begin_at(&mut self, at_mm: f64, ways: Vec<SpeedPiece>) {
        let Some(way) = ways.first() else { return };
        self.found = Found::in_motion(at_mm, way);
        self.from_mm = at_mm;
        self.begin = Begin::Motion(ways, None);
        (self.long, self.enough) = (SHORT, LEAST_SHORT);
    }

    /// The same with more axes, which stood still.
    pub fn widen<const M: usize>(&mut self, dynamics: &Dynamics) -> Horizon<M> {
        let Horizon { bounds, jerk, .. } = Horizon::<M>::new(dynamics);
        Horizon {
            bounds,
            jerk,
            smoothing: self.smoothing.widen(),
            widths: std::mem::take(&mut self.widths),
            walk: self.walk.as_ref().map(Cells::widen),
            first: self.first,
            searched: self.searched,
            cells: self.cells.iter().map(Cell::widen).collect(),
            from_mm: self.from_mm,
            begin: self.begin.clone(),
            enough: self.enough,
            long: self.long,
            found: std::mem::take(&mut self.found),
            lost: self.lost,
        }
    }

    /// Goes on with vertices that are new.
    pub fn advance(&mut self, track: &Track, legs: &[Leg], ended: bool) {
        let wide = self.smoothing.advance(track, legs, ended);
        for j in self.widths.len()..wide {
            let width = self.smoothing.wide[j];
            let straight = self.smoothing.is_straight(j);
            self.widths.push(if straight { -width.max(f64::MIN_POSITIVE) } else { width });
        }
        while self.run(track, legs) {}
    }

    /// Goes on in a run; whether another one begins.
    fn run(&mut self, track: &Track, legs: &[Leg]) -> bool {
        let from = self.searched.max(self.first + 1);
        let stop = (from..self.widths.len()).find(|j| self.widths[*j] == 0.0);
        let Some(last) = stop.or(self.widths.len().checked_sub(1)).filter(|j| *j > self.first)
        else {
            return false;
        };
        self.searched = last;
        let ended = stop.is_some();
        let path = Known { track, widths: &self.widths, legs, last, ended };
        let walk = self.walk.get_or_insert_with(|| Cells::new(track, self.first));
        walk.resume(&path);
        while let Some(cell) = walk.next(&path) {
            if cell.at_mm + cell.h > self.from_mm {
                let inside = cell.at_mm < self.from_mm;
                self.cells.push(if inside { cell.after(self.from_mm) } else { cell });
            }
        }
        self.plan(legs, ended);
        if ended {
            (self.first, self.walk) = (last, None);
        }
        ended
    }

    /// Plans windows as far as cells are known.
    fn plan(&mut self, legs: &[Leg], ended: bool) {
        while !self.cells.is_empty() && (ended || self.cells.len() >= self.enough) {
            if ended && self.straight(legs) {
                return;
            }
            let count = if ended { self.cells.len() } else { self.last_cell() + 1 };
            let rest = self.cells.split_off(count);
            let cells = std::mem::replace(&mut self.cells, rest);
            let planned = self.window(&cells, legs, ended);
            let rest = std::mem::replace(&mut self.cells, cells);
            self.cells.extend(rest);
            let Some(at_mm) = planned else {
                self.enough = self.cells.len() + self.cells.len() / 2;
                return;
            };
            self.forget_cells(at_mm);
            if matches!(self.begin, Begin::Motion(..)) {
                self.long = (self.long * LONGER).min(LONG);
                self.enough = if self.is_short() { LEAST_SHORT } else { LEAST };
            }
        }
    }

    /// The longest of the last cells: there the window ends.
    fn last_cell(&self) -> usize {
        let last = self.cells.len() - 1;
        let longer = |a: usize, b: usize| if self.cells[b].h > self.cells[a].h { b } else { a };
        (last.saturating_sub(ENDS)..=last).fold(last, longer)
    }

    fn forget_cells(&mut self, at_mm: f64) {
        let count = self.cells.partition_point(|cell| cell.at_mm + cell.h <= at_mm);
        self.cells.drain(..count);
        if let Some(first) = self.cells.first_mut().filter(|cell| cell.at_mm < at_mm) {
            *first = first.after(at_mm);
        }
    }

    /// Plans a window and gives up to where that is final; `None` when the window is too short.
    fn window(&mut self, cells: &[Cell<N>], legs: &[Leg], ended: bool) -> Option<f64> {
        let (first, last) = (cells.first()?, cells.last()?);
        let end_mm = last.at_mm + last.h;
        let (begin, x) = match &self.begin {
            Begin::Rest => (End::Rest(Launch::into(first, &self.bounds, &self.jerk, legs)), 0.0),
            Begin::Motion(ways, _) => {
                let SpeedPiece { h, x } = ways[0];
                (End::Motion([x[0], (x[1] - x[0]) / h]), x[0])
            }
        };
        let guide = guide(cells, &self.bounds, legs, x);
        let brakes_mm = self.brakes_mm(cells, &guide);
        if !ended && end_mm - first.at_mm < self.long * brakes_mm {
            return None;
        }
        let end = Launch::out_of(last, &self.bounds, &self.jerk, legs);
        let window = Window {
            cells,
            bounds: &self.bounds,
            jerk: &self.jerk,
            legs,
            guide: &guide,
            begin,
            end,
        };
        let kept = self.begin.kept(KEPT * brakes_mm);
        let lengths: Vec<f64> = kept.iter().map(|way| way.h).collect();
        let pieces = window.pieces(&lengths);
        let (accel, jerk, kept) = (self.bounds.accel, self.jerk, lengths.len());
        let before = self.begin.before(first.at_mm, &pieces);
        let gap = if self.is_short() { GAP_SHORT } else { GAP };
        let problem =
            Problem { pieces: &pieces, accel, jerk, begin, end, before: &before, kept, gap };
        let Some(ordinates) = problem.solve() else { return self.give_up(first.at_mm, ended) };
        if let End::Rest(launch) = begin {
            self.found.launch(launch, ordinates[0][0]);
        }
        let ways: Vec<SpeedPiece> =
            pieces.iter().zip(ordinates).map(|(p, x)| SpeedPiece { h: p.h, x }).collect();
        let final_mm = end_mm - brakes_mm;
        let count = pieces.partition_point(|p| p.at_mm + p.h <= final_mm);
        let count = count.clamp(1, ways.len().saturating_sub(2).max(1));
        if ended || count >= ways.len() {
            self.found.go(&ways);
            self.land(end, end_mm);
            return Some(end_mm);
        }
        self.found.go(&ways[..count]);
        self.begin = Begin::Motion(ways[count..].to_vec(), Some(end));
        Some(pieces[count].at_mm)
    }

    /// Returns `true` while windows are short, to be ready soon.
    fn is_short(&self) -> bool {
        self.long < LONG
    }

    /// Returns the way of braking from the greatest speed of the motion without a limit of jerk, mm.
    fn brakes_mm(&self, cells: &[Cell<N>], guide: &[Node]) -> f64 {
        let v = guide.iter().map(|node| node.v).fold(0.0, f64::max);
        let along = |limits: &[f64; N]| {
            let least = |cell: &Cell<N>| {
                let slope = &cell.frame.slope;
                (0..N).map(|k| limits[k] / slope[k].abs()).fold(f64::INFINITY, f64::min)
            };
            cells.iter().map(least).fold(f64::INFINITY, f64::min)
        };
        let (a, j) = (along(&self.bounds.accel), along(&self.jerk));
        let takes_s = if v * j > a * a { v / a + a / j } else { 2.0 * (v / j).sqrt() };
        BRAKES * 0.5 * v * takes_s
    }

    /// Runs on as the last window said, to its stand.
    fn give_up(&mut self, at_mm: f64, ended: bool) -> Option<f64> {
        let Begin::Motion(ways, end) = std::mem::replace(&mut self.begin, Begin::Rest) else {
            return None;
        };
        if end.is_none() && !ended && self.is_short() {
            // With more of the path a way may be found.
            self.begin = Begin::Motion(ways, end);
            self.long *= LONGER;
            return None;
        }
        self.found.go(&ways);
        let at_mm = at_mm + ways.iter().map(|way| way.h).sum::<f64>();
        let Some(end) = end else {
            self.lost = true;
            return Some(at_mm);
        };
        self.land(end, at_mm + end.way_mm);
        Some(at_mm + end.way_mm)
    }

    /// Takes the way of the last window to its stand as final.
    pub fn settle_early(&mut self) {
        let Some(at_mm) = self.cells.first().map(|cell| cell.at_mm) else { return };
        if matches!(self.begin, Begin::Motion(_, Some(_)))
            && let Some(at_mm) = self.give_up(at_mm, true)
        {
            self.forget_cells(at_mm);
        }
    }

    /// A run that is one straight line.
    fn straight(&mut self, legs: &[Leg]) -> bool {
        let ([cell], Begin::Rest) = (&self.cells[..], &self.begin) else { return false };
        if !cell.straight {
            return false;
        }
        let cell = *cell;
        let most = |limits: &[f64; N]| {
            let slope = &cell.frame.slope;
            (0..N).map(|k| limits[k] / slope[k].abs()).fold(f64::INFINITY, f64::min)
        };
        let [v, a, j] = [&self.bounds.speed, &self.bounds.accel, &self.jerk].map(most);
        let feed = legs[cell.owner as usize].feed_cap(&cell.frame.slope).sqrt();
        for phase in phases(cell.h, v.min(feed), a, j) {
            self.found.push(phase.duration_s, phase.jerk);
        }
        self.found.stand(cell.at_mm + cell.h);
        self.cells.clear();
        true
    }

    /// To rest at a place.
    fn land(&mut self, end: Launch, at_mm: f64) {
        self.found.land(end, at_mm);
        (self.begin, self.long, self.enough) = (Begin::Rest, LONG, LEAST);
    }

    /// The first vertex that is still needed.
    pub fn needs(&self) -> usize {
        self.walk.as_ref().map_or(self.first, Cells::needs)
    }

    /// Forgets the first vertices.
    pub fn forget(&mut self, vertices: usize) {
        self.smoothing.forget(vertices);
        self.widths.drain(..vertices);
        self.first = self.first.saturating_sub(vertices);
        self.searched = self.searched.saturating_sub(vertices);
        if let Some(walk) = &mut self.walk {
            walk.forget(vertices);
        }
    }

    /// Counts moves from a later one on.
    pub fn count_from(&mut self, first: usize) {
        for cell in &mut self.cells {
            cell.owner = cell.owner.saturating_sub(first as u32);
        }
    }
}
