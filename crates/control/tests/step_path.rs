//! A part file with its path in steps, and a judge: he looks at the steps and outputs of a board, however many hosts drove
//! it one after the other, for the whole path in order and nothing beside it.
//!
//! The path is computed here, not by Kerf: a zigzag with slopes and switched outputs, a spiral of short moves, a half circle.
#![allow(clippy::unwrap_used)]

use kerf_driver_klipper::fake::Board;
use std::collections::BTreeMap;
use std::f64::consts::PI;

/// Lines of the machine's file for the part: steps a millimetre and pins.
pub const MACHINE: &str = "units = \"mm\"\n[steps]\nper_unit = [100, 100, 200, 100, 100, 100]\n[board]\nx = \"gpio0 gpio1\"\n\
    y = \"gpio2 gpio3\"\nz = \"gpio4 gpio5\"\noutputs = \"1 gpio20, 2 gpio21\"\nspindle = \"gpio22\"\n\
    both_edges = true\npulse_us = 0.1";

/// Steps a millimetre.
const PER_MM: [f64; 3] = [100.0, 100.0, 200.0];
/// Distance from the path that a motor is in its cut at most, steps: half a step for rounding, and what it moves in the time
/// by which a step may be early or late.
const TOLERANCE: f64 = 0.6;
/// Distance between two samples of the path, mm.
const GRAIN_MM: f64 = 0.002;
/// Samples between which one place may not be told from the next: both legs of a sharp corner of the zigzag.
const SLACK: usize = 80;
/// Time without a step after which the machine stood, seconds.
const STAND_S: f64 = 0.02;
/// Place at which the machine stands at the end, mm.
pub const END_MM: [f64; 3] = [5.0, 8.0, 5.0];

/// A stretch that is cut.
enum Leg {
    To([f64; 3]),
    /// Half a circle counterclockwise in the plane, about a centre.
    Half([f64; 2]),
}

/// A part: figures that are cut one after the other, each from its start, and the legs of the first before which output 2 goes on
/// and off.
pub struct Part {
    figures: Vec<([f64; 3], Vec<Leg>)>,
    on: usize,
    off: usize,
}

/// A part with so many legs of a zigzag and of a spiral.
pub fn part(teeth: usize, round: u32) -> Part {
    let (on, off) = (teeth / 4, teeth / 2);
    let teeth = (1..).take(teeth).map(|n: i32| {
        let y_mm = if n % 2 == 0 { 10.0 } else { 18.0 };
        Leg::To([10.0 + 2.0 * f64::from(n), y_mm, -2.0 + 0.25 * f64::from(n % 5)])
    });
    let spiral = |n: u32| {
        let (turn, radius) = (0.1 * f64::from(n), 6.0 + 0.03 * f64::from(n));
        let thousandths = |mm: f64| (1000.0 * mm).round() / 1000.0;
        [thousandths(30.0 + radius * turn.cos()), thousandths(40.0 + radius * turn.sin()), -1.5]
    };
    let [x, y, _] = spiral(round);
    let mut around: Vec<Leg> = (1..=round).map(|n| Leg::To(spiral(n))).collect();
    around.push(Leg::Half([x - 12.0, y]));
    Part { figures: vec![([10.0, 10.0, -2.0], teeth.collect()), (spiral(0), around)], on, off }
}

impl Part {
    /// The part file.
    pub fn text(&self) -> String {
        let mut text = "SA\nVS,50,10\nTR,12000\nSO,1,1\nJZ,5\n".to_owned();
        for (n, ([x, y, z], legs)) in self.figures.iter().enumerate() {
            text += &format!("J2,{x},{y}\nMZ,{z}\n");
            let mut at = [*x, *y];
            for (k, leg) in legs.iter().enumerate() {
                match k {
                    _ if n > 0 => {}
                    _ if k == self.on => text += "SO,2,1\n",
                    _ if k == self.off => text += "SO,2,0\n",
                    _ => {}
                }
                match leg {
                    Leg::To([x, y, z]) => {
                        text += &format!("M3,{x},{y},{z}\n");
                        at = [*x, *y];
                    }
                    Leg::Half(centre) => {
                        let [i, j] = [0, 1].map(|n| centre[n] - at[n]);
                        at = [0, 1].map(|n| 2.0 * centre[n] - at[n]);
                        text += &format!("CG,,{:.3},{:.3},{i:.3},{j:.3},T,-1\n", at[0], at[1]);
                    }
                }
            }
            text += "JZ,5\n";
        }
        text + &format!("SO,1,0\nJ2,{},{}\n", END_MM[0], END_MM[1])
    }
}

/// The path in steps, sampled, and the samples between which output 2 is on.
struct Path {
    samples: Vec<[f64; 3]>,
    second_on: [usize; 2],
    /// Samples by the whole steps of X and Y next to them.
    cells: BTreeMap<[i64; 2], Vec<usize>>,
}

fn sampled(part: &Part) -> Path {
    let (mut samples, mut second_on) = (Vec::new(), [0; 2]);
    for (n, (start, legs)) in part.figures.iter().enumerate() {
        let mut at = *start;
        for (k, leg) in legs.iter().enumerate() {
            if n == 0 && k == part.on {
                second_on[0] = samples.len();
            }
            if n == 0 && k == part.off {
                second_on[1] = samples.len();
            }
            let from = at;
            let (length_mm, place): (f64, Box<dyn Fn(f64) -> [f64; 3]>) = match *leg {
                Leg::To(to) => {
                    let along =
                        move |share: f64| [0, 1, 2].map(|n| from[n] + share * (to[n] - from[n]));
                    ((to[0] - from[0]).hypot(to[1] - from[1]), Box::new(along))
                }
                Leg::Half([i, j]) => {
                    let (radius, angle) =
                        ((from[0] - i).hypot(from[1] - j), (from[1] - j).atan2(from[0] - i));
                    let along = move |share: f64| {
                        let turn = angle + PI * share;
                        [i + radius * turn.cos(), j + radius * turn.sin(), from[2]]
                    };
                    (PI * radius, Box::new(along))
                }
            };
            let count = (length_mm / GRAIN_MM).ceil();
            for sample in 0..=count as usize {
                let place = place(sample as f64 / count);
                samples.push([0, 1, 2].map(|n| place[n] * PER_MM[n]));
            }
            at = place(1.0);
        }
    }
    let mut cells: BTreeMap<[i64; 2], Vec<usize>> = BTreeMap::new();
    for (n, [x, y, _]) in samples.iter().enumerate() {
        cells.entry([x.round() as i64, y.round() as i64]).or_default().push(n);
    }
    Path { samples, second_on, cells }
}

impl Path {
    /// Samples from which X and Y are within the tolerance.
    fn near(&self, [x, y, _]: [i64; 3]) -> Vec<usize> {
        let cells = (-1..=1).flat_map(|dx| (-1..=1).map(move |dy| [x + dx, y + dy]));
        let all = cells.filter_map(|cell| self.cells.get(&cell)).flatten().copied();
        let off = |n: usize| {
            let [sx, sy, _] = self.samples[n];
            (sx - x as f64).abs().max((sy - y as f64).abs())
        };
        all.filter(|n| off(*n) <= TOLERANCE).collect()
    }
}

/// A step of the board: its clock, and the counts of X, Y and Z behind it.
type Step = (u64, [i64; 3]);

fn steps(fake: &Board) -> Vec<Step> {
    let own =
        |motor: u8| fake.steppers[&motor].made.iter().map(move |(clock, up)| (*clock, motor, *up));
    let mut all: Vec<_> = (0..3).flat_map(own).collect();
    all.sort_unstable();
    let mut counts = [0; 3];
    let mut step = |(clock, motor, up): (u64, u8, bool)| {
        counts[usize::from(motor)] += if up { 1 } else { -1 };
        (clock, counts)
    };
    all.into_iter().map(&mut step).collect()
}

/// Values of an output by its pin.
struct Output<'a>(&'a [(u64, u32)]);

impl<'a> Output<'a> {
    fn of(fake: &'a Board, pin: u32) -> Self {
        Self(&fake.outputs.values().find(|it| it.pin == pin).unwrap().made)
    }

    fn at(&self, clock: u64) -> u32 {
        let before = self.0.partition_point(|(at, _)| *at <= clock);
        before.checked_sub(1).map_or(0, |n| self.0[n].1)
    }
}

/// Holds boards against the path.
pub struct Judge {
    path: Path,
}

impl Judge {
    pub fn new(part: &Part) -> Self {
        Self { path: sampled(part) }
    }

    /// The board has cut the whole path in its order and nothing else, with its outputs, and stands at the end. Tells how much
    /// of the path one host at most made once more, mm.
    #[track_caller]
    pub fn holds(&self, fake: &Board, of: &str) -> f64 {
        assert_eq!(fake.reason(), None, "{of}");
        let end: Vec<i64> = fake.steppers.values().map(|it| it.position).collect();
        let wanted = [0, 1, 2].map(|n| (END_MM[n] * PER_MM[n]).round() as i64);
        assert_eq!(end, wanted, "{of}: it stands elsewhere");
        assert!(fake.outputs.values().all(|output| output.value == 0), "{of}: an output is on");
        let (mut farthest, mut again) = (0, 0);
        let stand = (STAND_S * fake.frequency) as u64;
        let goes_on = |a: &Step, b: &Step| a.1[2] < 0 && b.1[2] < 0 && b.0 - a.0 < stand;
        for pass in steps(fake).chunk_by(goes_on).filter(|it| it[0].1[2] < 0) {
            let Some([from, to]) = self.cut(fake, pass, of) else { continue };
            assert!(
                from <= farthest + 3,
                "{of}: nothing was cut between samples {farthest} and {from}"
            );
            again = again.max(farthest.saturating_sub(from));
            farthest = farthest.max(to);
        }
        let last = self.path.samples.len() - 1;
        assert!(farthest + SLACK >= last, "{of}: cut up to {farthest} of {last}");
        again as f64 * GRAIN_MM
    }

    /// Follows steps that lie below the surface, one behind the other and without a stand; the first and the last sample of the
    /// path that they cut. Nothing where they are above it.
    fn cut(&self, fake: &Board, pass: &[Step], of: &str) -> Option<[usize; 2]> {
        let [first, second, spindle] = [20, 21, 22].map(|pin| Output::of(fake, pin));
        let (mut from, mut to) = (None, 0);
        let mut seen = Vec::new();
        for (clock, place) in pass {
            let near = self.path.near(*place);
            let above = |n: &usize| place[2] as f64 - self.path.samples[*n][2];
            assert!(
                near.iter().any(|n| above(n) >= -TOLERANCE),
                "{of}: cut beside the path at {place:?}, {near:?}"
            );
            let on: Vec<usize> = near.into_iter().filter(|n| above(n).abs() <= TOLERANCE).collect();
            let (Some(least), Some(most)) = (on.first(), on.last()) else { continue };
            if from.is_none() {
                (from, to) = (Some(*least), *least);
            }
            let onward =
                on.iter().filter(|n| (to.saturating_sub(SLACK)..=to + SLACK).contains(n)).max();
            let onward = *onward.unwrap_or_else(|| {
                panic!("{of}: from sample {to} to {least} … {most} at {place:?}")
            });
            to = to.max(onward);
            seen.push((*clock, onward));
        }
        let from = from?;
        // A lift leaves the path at once, whatever is on.
        let cuts = to - from > SLACK;
        for (clock, at) in seen.into_iter().filter(|_| cuts) {
            let is_on = [&first, &spindle].map(|output| output.at(clock) > 0);
            assert_eq!(is_on, [true; 2], "{of}: the spindle is off at sample {at}");
            let [on, off] = self.path.second_on;
            let clear = |edge: usize| at.abs_diff(edge) > SLACK;
            if clear(on) && clear(off) {
                assert_eq!(
                    second.at(clock) > 0,
                    (on..off).contains(&at),
                    "{of}: output 2 at sample {at}"
                );
            }
        }
        Some([from, to])
    }
}
