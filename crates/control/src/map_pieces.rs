//! Moves cut into pieces that follow a height map.
//!
//! A cut is cut every [`PIECE_MM`] along X and Y, a straight one also where it goes from one cell of the grid into
//! another; each piece ends at the height of its place. Within a cell the height along a straight way is a
//! parabola: a piece is off by its twist times a quarter of the square of half its length, at most. An arc stays one, cut into
//! shorter ones. A jog goes straight to the height of its end.

use kerf_program::{Arc, Axes, Axis, Command, Feed, HeightMap, Line, MoveKind};

/// Length of a piece, mm: a cell of 10 mm that is twisted by 0.1 mm bends away from it by 0.0003 mm.
pub(crate) const PIECE_MM: f64 = 1.0;

/// Shares that differ by less are the same.
const SAME: f64 = 1e-9;

/// A height map where it lies: the machine position of its X 0, Y 0.
#[derive(Clone, Copy)]
pub(crate) struct Laid<'a> {
    pub map: &'a HeightMap,
    pub zero: Axes,
    /// The machine's top, Z of the machine frame, mm: what travels there is not lifted beyond it.
    pub top_mm: f64,
}

impl Laid<'_> {
    /// Z of the surface there, mm above Z zero.
    fn height(&self, at: Axes) -> f64 {
        self.map.at(at[Axis::X] - self.zero[Axis::X], at[Axis::Y] - self.zero[Axis::Y])
    }

    /// The machine position of a place of the program.
    pub fn lifted(&self, mut place: Axes) -> Axes {
        let flat_mm = place[Axis::Z];
        let lifted_mm = flat_mm + self.height(place);
        place[Axis::Z] = lifted_mm.min(flat_mm.max(self.top_mm));
        place
    }

    /// The place of the program of a machine position.
    pub fn lowered(&self, mut place: Axes) -> Axes {
        place[Axis::Z] -= self.height(place);
        place
    }

    /// Distance of a place from the grid, mm.
    pub fn outside_mm(&self, at: Axes) -> f64 {
        let [x, y] = [Axis::X, Axis::Y].map(|axis| at[axis] - self.zero[axis]);
        self.map.outside_mm(x, y)
    }

    /// The pieces of a line that begins at a place of the program.
    pub fn line(&self, from: Axes, line: &Line) -> Vec<Command> {
        let shares =
            if line.kind == MoveKind::Cut { self.shares(from, line.to) } else { vec![1.0] };
        let mut before = 0.0;
        let piece = |share: f64| {
            let to =
                if share < 1.0 { from.zip(line.to, |a, b| a + (b - a) * share) } else { line.to };
            let feed = part_of(line.feed, share - std::mem::replace(&mut before, share));
            Command::Line(Line { to: self.lifted(to), feed, ..*line })
        };
        shares.into_iter().map(piece).collect()
    }

    /// Shares at which the pieces of a straight cut end.
    fn shares(&self, from: Axes, to: Axes) -> Vec<f64> {
        let [a, b] = [from, to]
            .map(|at| [at[Axis::X] - self.zero[Axis::X], at[Axis::Y] - self.zero[Axis::Y]]);
        let mut shares = evenly((b[0] - a[0]).hypot(b[1] - a[1]));
        shares.extend(self.map.crossings(a, b));
        shares.sort_by(f64::total_cmp);
        shares.dedup_by(|b, a| *b - *a < SAME);
        if let Some(last) = shares.last_mut() {
            *last = 1.0;
        }
        shares
    }

    /// The pieces of an arc that begins at a place of the program.
    pub fn arc(&self, from: Axes, arc: &Arc) -> Vec<Command> {
        let [cx, cy] = arc.centre;
        let (x, y) = (from[Axis::X] - cx, from[Axis::Y] - cy);
        let turned = |share: f64| {
            let (sin, cos) = (arc.sweep_rad * share).sin_cos();
            [cx + x * cos - y * sin, cy + x * sin + y * cos]
        };
        let end = turned(1.0);
        let gap = [arc.to[Axis::X] - end[0], arc.to[Axis::Y] - end[1]];
        let shares = match arc.kind {
            MoveKind::Cut => evenly(x.hypot(y) * arc.sweep_rad.abs()),
            MoveKind::Jog => vec![1.0],
        };
        let part = 1.0 / shares.len() as f64;
        let piece = |share: f64| {
            let mut to = from.zip(arc.to, |a, b| a + (b - a) * share);
            let [px, py] = turned(share);
            (to[Axis::X], to[Axis::Y]) = (px + gap[0] * share, py + gap[1] * share);
            let to = self.lifted(if share < 1.0 { to } else { arc.to });
            let chords = (f64::from(arc.chords) * part).ceil() as u32;
            let (sweep_rad, feed) = (arc.sweep_rad * part, part_of(arc.feed, part));
            Command::Arc(Arc { to, sweep_rad, chords, feed, ..*arc })
        };
        shares.into_iter().map(piece).collect()
    }
}

/// Ends of pieces of a way of so many millimetres, as shares.
fn evenly(length_mm: f64) -> Vec<f64> {
    let count = (length_mm / PIECE_MM - SAME).ceil().clamp(1.0, 1e7) as u32;
    (1..=count).map(|n| f64::from(n) / f64::from(count)).collect()
}

/// The feed of a share of a move.
fn part_of(feed: Feed, share: f64) -> Feed {
    match feed {
        Feed::Time(time_s) => Feed::Time(time_s * share),
        other => other,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use kerf_motion::Mover;
    use kerf_program::{At, Settings};

    /// A saddle of 4 by 3 cells of 10 mm that is up to 0.9 mm high.
    fn saddle() -> HeightMap {
        let places = (0..20).map(|n| (f64::from(n % 5) * 10.0, f64::from(n / 5) * 10.0));
        let line = |(x, y): (f64, f64)| {
            format!("{x},{y},{}\n", (x - 20.0) * (y - 15.0) / 400.0 + 0.004 * x)
        };
        HeightMap::read(
            &(kerf_program::HEIGHT_MAP_HEAD.to_owned()
                + "\n"
                + &places.map(line).collect::<String>()),
        )
        .expect("a grid")
    }

    /// The share of a straight move at which it is in X and Y where a place is.
    fn along(whole: &kerf_motion::Move, place: Axes) -> f64 {
        let ([dx, dy, ..], [x, y, ..]) = (whole.to.minus(whole.from).0, place.minus(whole.from).0);
        (x * dx + y * dy) / (dx * dx + dy * dy)
    }

    /// Follows the pieces of a move closely: every place lies the height of the surface above that of the
    /// program, to so many millimetres, and the pieces end where the move does.
    #[track_caller]
    fn check(command: Command, from: Axes, within_mm: f64) {
        let (map, zero) = (saddle(), Axes::xyz(100.0, 50.0, -7.0));
        let laid = Laid { map: &map, zero, top_mm: f64::INFINITY };
        let settings = Settings::default();
        let (mut flat, mut raised) =
            (Mover::new(from, &settings), Mover::new(laid.lifted(from), &settings));
        let made = |mover: &mut Mover, command: &Command| match command {
            Command::Line(line) => mover.line(At::default(), line),
            Command::Arc(arc) => mover.arc(At::default(), arc),
            _ => None,
        };
        let pieces = match &command {
            Command::Line(line) => laid.line(from, line),
            Command::Arc(arc) => laid.arc(from, arc),
            other => panic!("{other:?}"),
        };
        let whole = made(&mut flat, &command).expect("it moves");
        let parts: Vec<_> = pieces.iter().filter_map(|piece| made(&mut raised, piece)).collect();
        for (n, part) in parts.iter().enumerate() {
            for eighth in 0..=8 {
                let place = part.position(f64::from(eighth) / 8.0);
                let share = match whole.arc() {
                    Some(_) => (n as f64 + f64::from(eighth) / 8.0) / parts.len() as f64,
                    None => along(&whole, place),
                };
                let program = whole.position(share);
                let off = place.minus(laid.lifted(program));
                assert!(off.0.iter().all(|v| v.abs() < within_mm), "{off:?} at {program:?}");
            }
        }
        let end = parts.last().expect("pieces").to;
        assert_eq!(end, laid.lifted(whole.to));
    }

    const FROM: Axes = Axes([103.0, 52.0, -8.0, 0.0, 0.0, 0.0]);

    #[test]
    fn straight_cuts_follow_the_surface() {
        for (x, y, z) in
            [(137.0, 78.0, -8.0), (103.0, 79.0, -9.5), (139.5, 52.0, -8.0), (104.0, 53.3, -7.5)]
        {
            let line = Line { kind: MoveKind::Cut, to: Axes::xyz(x, y, z), feed: Feed::Path(20.0) };
            check(Command::Line(line), FROM, 0.001);
        }
    }

    #[test]
    fn arcs_follow_the_surface_and_stay_arcs() {
        for sweep_rad in [1.0, -2.0, 6.2] {
            let (x, y) = (-12.0_f64, -9.0_f64);
            let (sin, cos) = f64::sin_cos(sweep_rad);
            let to = Axes::xyz(115.0 + x * cos - y * sin, 61.0 + x * sin + y * cos, -8.4);
            let arc = Arc {
                kind: MoveKind::Cut,
                centre: [115.0, 61.0],
                sweep_rad,
                to,
                feed: Feed::Path(20.0),
                chords: 100,
                small: false,
            };
            // Where it goes from one cell into another the surface has an edge.
            check(Command::Arc(arc), FROM, 0.03);
        }
    }

    #[test]
    fn a_jog_goes_to_the_height_of_its_end_and_time_is_shared() {
        let map = saddle();
        let laid = Laid { map: &map, zero: Axes::default(), top_mm: f64::INFINITY };
        let jog = Line { kind: MoveKind::Jog, to: Axes::xyz(40.0, 30.0, 5.0), feed: Feed::Axis };
        assert_eq!(laid.line(Axes::default(), &jog).len(), 1);
        let cut = Line { kind: MoveKind::Cut, to: Axes::xyz(3.5, 0.0, 0.0), feed: Feed::Time(7.0) };
        let times: Vec<f64> = laid
            .line(Axes::default(), &cut)
            .iter()
            .map(|piece| match piece {
                Command::Line(Line { feed: Feed::Time(time_s), .. }) => *time_s,
                other => panic!("{other:?}"),
            })
            .collect();
        assert_eq!(times, [1.75; 4]);
    }

    #[test]
    fn what_travels_at_the_top_of_the_machine_is_not_lifted_beyond_it() {
        let map = saddle();
        let laid = Laid { map: &map, zero: Axes::default(), top_mm: 10.0 };
        let height = laid.lifted(Axes::xyz(40.0, 30.0, 0.0))[Axis::Z];
        assert!(height > 0.5, "{height}");
        for (flat_mm, mm) in
            [(10.0, 10.0), (9.9, 10.0), (5.0, 5.0 + height), (12.0, 12.0), (-1.0, height - 1.0)]
        {
            let at = laid.lifted(Axes::xyz(40.0, 30.0, flat_mm))[Axis::Z];
            assert!((at - mm).abs() < 1e-9, "{flat_mm}: {at}, not {mm}");
        }
    }
}
