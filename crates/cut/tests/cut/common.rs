//! Command lines in inches, as the manual and the ledger write them, and ways to look at the result.

use kerf_cut::*;
use kerf_program::MoveKind;

pub const IN: f64 = 25.4;

/// At `start` (inches): cutter .25, overlap 10 %, Safe-Z 1, resolution .05, small circle .25.
pub fn at(x: f64, y: f64, z: f64) -> Context {
    Context {
        start: [x * IN, y * IN, z * IN],
        zero_z: 0.0,
        safe_z: Some(IN),
        cutter_mm: 0.25 * IN,
        overlap_percent: 10.0,
        circle_mm: 0.05 * IN,
        small_circle_mm: 0.25 * IN,
        scale: [1.0; 3],
    }
}

pub fn origin() -> Context {
    at(0.0, 0.0, 0.0)
}

/// The fields of a parameter list.
struct Fields<'a>(Vec<&'a str>);

impl<'a> Fields<'a> {
    fn new(line: &'a str) -> Self {
        Self(line.split(',').map(str::trim).collect())
    }
    fn text(&self, i: usize) -> &'a str {
        self.0.get(i).copied().unwrap_or("")
    }
    fn opt(&self, i: usize) -> Option<f64> {
        let t = self.text(i);
        (!t.is_empty()).then(|| t.parse().unwrap())
    }
    fn num(&self, i: usize, default: f64) -> f64 {
        self.opt(i).unwrap_or(default)
    }
    fn inches(&self, i: usize) -> f64 {
        self.num(i, 0.0) * IN
    }
    fn side(&self, i: usize) -> Side {
        match self.text(i) {
            "O" => Side::Out,
            "I" => Side::In,
            _ => Side::True,
        }
    }
    fn turn(&self, i: usize) -> Direction {
        if self.num(i, 1.0) < 0.0 { Direction::Counter } else { Direction::Clockwise }
    }
    fn feature(&self, i: usize) -> Feature {
        Feature::from_number(self.num(i, 0.0) as u8).unwrap()
    }
    fn circle(&self, side: usize) -> Circle {
        Circle {
            diameter_mm: self.inches(0),
            side: self.side(side),
            turn: self.turn(side + 1),
            begin_deg: self.opt(side + 2),
            end_deg: self.opt(side + 3),
            proportion: [self.num(side + 6, 1.0), self.num(side + 7, 1.0)],
            passes: Passes {
                plunge_mm: self.inches(side + 4),
                repetitions: self.num(side + 5, 1.0) as u32,
                feature: self.feature(side + 8),
                no_pull_up: self.num(side + 9, 0.0) == 1.0,
                from_zero: self.num(side + 10, 0.0) == 1.0,
            },
        }
    }
}

pub fn cc(line: &str, context: &Context) -> Result<Cut, CutError> {
    circle(&Fields::new(line).circle(1), context)
}

pub fn cp(line: &str, context: &Context) -> Result<Cut, CutError> {
    let f = Fields::new(line);
    point_circle([f.inches(1), f.inches(2)], &f.circle(3), context)
}

pub fn cg_after(
    line: &str,
    previous: Option<[f64; 2]>,
    context: &Context,
) -> Result<(Cut, Option<[f64; 2]>), CutError> {
    let f = Fields::new(line);
    let inches = |i| f.opt(i).map(|v| v * IN);
    let arc = ArcTo {
        diameter_mm: inches(0),
        end: [inches(1), inches(2)],
        centre_offset: [inches(3), inches(4)],
        side: f.side(5),
        turn: f.turn(6),
        proportion: [f.num(9, 1.0), f.num(10, 1.0)],
        passes: Passes {
            plunge_mm: f.inches(7),
            repetitions: f.num(8, 1.0) as u32,
            feature: f.feature(11),
            no_pull_up: f.num(12, 0.0) == 1.0,
            from_zero: f.num(13, 0.0) == 1.0,
        },
    };
    arc_to(&arc, previous, context)
}

pub fn cg(line: &str, context: &Context) -> Result<Cut, CutError> {
    cg_after(line, None, context).map(|(cut, _)| cut)
}

pub fn ca(line: &str, context: &Context) -> Result<Cut, CutError> {
    let f = Fields::new(line);
    arch(
        &Arch {
            length_mm: f.inches(0),
            height_mm: f.inches(1),
            side: f.side(2),
            turn: f.turn(3),
            alignment_deg: f.num(4, 0.0),
            proportion: [f.num(7, 1.0), f.num(8, 1.0)],
            passes: Passes {
                plunge_mm: f.inches(5),
                repetitions: f.num(6, 1.0) as u32,
                feature: f.feature(9),
                no_pull_up: f.num(10, 0.0) == 1.0,
                from_zero: f.num(11, 0.0) == 1.0,
            },
        },
        context,
    )
}

pub fn cr(line: &str, context: &Context) -> Result<Cut, CutError> {
    let f = Fields::new(line);
    rectangle(
        &Rectangle {
            length_x_mm: f.inches(0),
            length_y_mm: f.num(1, f.num(0, 0.0)) * IN,
            side: f.side(2),
            turn: f.turn(3),
            corner: Corner::from_number(f.num(4, 4.0) as u8).unwrap(),
            passes: Passes {
                plunge_mm: f.inches(5),
                repetitions: f.num(6, 1.0) as u32,
                feature: f.feature(7),
                no_pull_up: false,
                from_zero: f.num(8, 0.0) == 1.0,
            },
        },
        context,
    )
}

/// Steps and where each begins, inches.
pub fn legs(start_mm: [f64; 3], steps: &[Step]) -> Vec<([f64; 3], Step)> {
    let mut from = start_mm;
    steps
        .iter()
        .map(|step| {
            let leg = (from.map(|v| v / IN), inches(*step));
            from = step.to();
            leg
        })
        .collect()
}

fn inches(step: Step) -> Step {
    match step {
        Step::Line { kind, to } => Step::Line { kind, to: to.map(|v| v / IN) },
        Step::Arc { centre, sweep_rad, to, chords, small } => Step::Arc {
            centre: centre.map(|v| v / IN),
            sweep_rad,
            to: to.map(|v| v / IN),
            chords,
            small,
        },
    }
}

/// The steps as short text, inches with up to four decimals: `cut x y z`, `jog x y z`,
/// `cw|ccw degrees about cx cy to x y z`.
pub fn told(cut: &Cut) -> Vec<String> {
    cut.steps.iter().map(|s| tell(inches(*s))).collect()
}

pub fn tell(step: Step) -> String {
    match step {
        Step::Line { kind: MoveKind::Cut, to } => format!("cut {}", numbers(&to)),
        Step::Line { kind: MoveKind::Jog, to } => format!("jog {}", numbers(&to)),
        Step::Arc { centre, sweep_rad, to, .. } => format!(
            "{} {} about {} to {}",
            if sweep_rad < 0.0 { "cw" } else { "ccw" },
            number(sweep_rad.abs().to_degrees()),
            numbers(&centre),
            numbers(&to)
        ),
    }
}

fn numbers(values: &[f64]) -> String {
    values.iter().map(|v| number(*v)).collect::<Vec<_>>().join(" ")
}

pub fn number(v: f64) -> String {
    let rounded = (v * 1e4).round() / 1e4 + 0.0;
    format!("{rounded}")
}

/// Compares steps with what is expected, one a line.
#[track_caller]
pub fn check(result: Result<Cut, CutError>, expected: &str) {
    let got = told(&result.unwrap()).join("\n");
    let want: Vec<_> = expected.trim().lines().map(str::trim).collect();
    assert_eq!(got, want.join("\n"));
}

#[track_caller]
pub fn refused(result: Result<Cut, CutError>, part: &str) {
    let message = result.expect_err("should be refused").to_string();
    assert!(message.contains(part), "{message:?} lacks {part:?}");
}

/// Distance of a place from one step of the path, seen from above, and the share of the step at
/// which the step is that near. Inches.
pub fn nearest(from: [f64; 3], step: &Step, p: [f64; 2]) -> (f64, f64) {
    match *step {
        Step::Line { to, .. } => {
            let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
            let length2 = dx * dx + dy * dy;
            let t = ((p[0] - from[0]) * dx + (p[1] - from[1]) * dy) / length2;
            let t = if length2 > 0.0 { t.clamp(0.0, 1.0) } else { 0.0 };
            ((from[0] + dx * t - p[0]).hypot(from[1] + dy * t - p[1]), t)
        }
        Step::Arc { centre, sweep_rad, to, .. } => {
            let tau = std::f64::consts::TAU;
            let angle = |q: [f64; 2]| (q[1] - centre[1]).atan2(q[0] - centre[0]);
            let way = (angle(p) - angle([from[0], from[1]])) * sweep_rad.signum();
            let radius = (from[0] - centre[0]).hypot(from[1] - centre[1]);
            let share = way.rem_euclid(tau) / sweep_rad.abs();
            if share <= 1.0 {
                let off = radius - (p[0] - centre[0]).hypot(p[1] - centre[1]);
                return (off.abs(), share);
            }
            let end = |q: [f64; 3]| (q[0] - p[0]).hypot(q[1] - p[1]);
            if end(from) < end(to) { (end(from), 0.0) } else { (end(to), 1.0) }
        }
    }
}

/// The path goes through these places (inches) in this order.
#[track_caller]
pub fn passes(context: &Context, cut: &Cut, places: &[[f64; 2]]) {
    let legs = legs(context.start, &cut.steps);
    let mut after = 0.0;
    for place in places {
        let ends = |to: [f64; 3]| (to[0] - place[0]).hypot(to[1] - place[1]) < 2e-4;
        let found = legs.iter().enumerate().find_map(|(i, (from, step))| {
            let (off, share) = nearest(*from, step, *place);
            let at = [Some(share).filter(|_| off < 2e-4), Some(1.0).filter(|_| ends(step.to()))];
            at.into_iter().flatten().map(|share| i as f64 + share).find(|at| *at >= after - 1e-6)
        });
        after = found.unwrap_or_else(|| panic!("{place:?} is not on the path after {after}"));
    }
}
