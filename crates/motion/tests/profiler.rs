//! The `profiler` model against the rows of the ledger, in mm (areas smoothing, speeds and axes).

use kerf_motion::{Model, Move, Mover, Path, Plan, Profiler, planner};
use kerf_program::{
    Arc, At, Axes, Axis, Dynamics, Feed, Line, MoveKind, RampModel, Settings, Smoothing,
};
use std::f64::consts::{PI, TAU};

/// A machine under test and the moves it is to make.
struct Bench {
    dynamics: Dynamics,
    smoothing: Smoothing,
    mover: Mover,
    moves: Vec<Move>,
}

const AXIS_MM_S: f64 = 200.0;
const ACCEL: f64 = 1000.0;

/// Starts at a place, cutting at a speed.
fn bench(start: [f64; 3], cut_mm_s: f64) -> Bench {
    let mut settings = Settings::default();
    (settings.speeds.cut.xy, settings.speeds.cut.z) = (cut_mm_s, cut_mm_s);
    (settings.speeds.jog.xy, settings.speeds.jog.z) = (1000.0, 1000.0);
    (settings.speeds.cut.c, settings.speeds.jog.c) = (1e6, 1e6);
    let [x, y, z] = start;
    let dynamics = Dynamics {
        speed_mm_s: Axes([AXIS_MM_S, AXIS_MM_S, AXIS_MM_S, 180.0, 180.0, 180.0]),
        accel_mm_s2: Axes::splat(ACCEL),
        jerk_mm_s3: None,
        tolerance_mm: 0.0,
    };
    let mover = Mover::new(Axes::xyz(x, y, z), &settings);
    Bench { dynamics, smoothing: Smoothing::default(), mover, moves: Vec::new() }
}

impl Bench {
    fn factor(mut self, factor: f64) -> Self {
        self.smoothing.factor = factor;
        self
    }

    fn to(mut self, kind: MoveKind, to: Axes) -> Self {
        let line = Line { kind, to, feed: Feed::Axis };
        self.moves.extend(self.mover.line(At::default(), &line));
        self
    }

    fn cut(self, x: f64, y: f64, z: f64) -> Self {
        self.to(MoveKind::Cut, Axes::xyz(x, y, z))
    }

    /// An arc about the origin, radians, in which C turns as well.
    fn round(mut self, centre: [f64; 2], sweep_rad: f64, turn_deg: f64) -> Self {
        let mut to = self.mover.position();
        let (sin, cos) = sweep_rad.sin_cos();
        let [x, y] = [to.0[0] - centre[0], to.0[1] - centre[1]];
        to.0[0] = centre[0] + x * cos - y * sin;
        to.0[1] = centre[1] + x * sin + y * cos;
        to.0[5] += turn_deg;
        let (kind, feed, chords, small) = (MoveKind::Cut, Feed::Axis, 64, false);
        let arc = Arc { kind, centre, sweep_rad, to, feed, chords, small };
        self.moves.extend(self.mover.arc(At::default(), &arc));
        self
    }

    fn plan(self) -> Plan {
        Profiler { dynamics: &self.dynamics, smoothing: &self.smoothing }.plan(self.moves)
    }
}

/// A regular polygon about the origin, once round; Z falls evenly by `down`.
fn polygon(sides: u32, radius: f64, down: f64, factor: f64) -> Plan {
    let mut made = bench([radius, 0.0, 0.0], 50.0).factor(factor);
    for k in 1..=sides {
        let share = f64::from(k) / f64::from(sides);
        let (sin, cos) = (TAU * share).sin_cos();
        made = made.cut(radius * cos, radius * sin, -down * share);
    }
    made.plan()
}

/// Tells of each move if it became a curve.
fn curves(plan: &Plan) -> Vec<bool> {
    plan.moves().iter().map(|m| matches!(m.path, Path::Curve { .. })).collect()
}

fn all_smooth(plan: &Plan) -> bool {
    curves(plan).into_iter().all(|curve| curve)
}

/// Speeds at the joints between moves.
fn joints(plan: &Plan) -> Vec<f64> {
    plan.iter().skip(1).map(|span| span.v_entry).collect()
}

fn stops(plan: &Plan) -> usize {
    joints(plan).into_iter().filter(|v| *v == 0.0).count()
}

#[track_caller]
fn near(got: f64, expected: f64) {
    assert!((got - expected).abs() < 1e-3, "{got} is not {expected}");
}

#[test]
fn pro_smoothing_factor() {
    for (sides, factor, smooth) in [(72, 0.6, true), (36, 0.6, false), (36, 2.0, true)] {
        let plan = polygon(sides, 50.0, 0.0, factor);
        assert_eq!(all_smooth(&plan), smooth, "{sides} sides at {factor}");
        assert_eq!(curves(&plan).contains(&true), smooth, "{sides} sides at {factor}");
    }
    // More polygons (readings, Smoothing).
    assert!(all_smooth(&polygon(36, 10.0, 0.0, 0.6)));
    assert!(!curves(&polygon(12, 10.0, 0.0, 2.0)).contains(&true));
}

/// A wandering polyline, some of it fine and some rough.
fn wander(mut seed: u64, factor: f64) -> Plan {
    let mut random = move || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (seed >> 40) as f64 / (1u64 << 24) as f64
    };
    let (mut made, mut heading) = (bench([0.0; 3], 50.0).factor(factor), 0.0);
    let [mut x, mut y] = [0.0, 0.0];
    for k in 0..200 {
        heading += (random() - 0.5) * if k / 20 % 2 == 0 { 0.3 } else { 1.2 };
        let step = 0.2 + 4.0 * random() * random();
        let (sin, cos) = f64::sin_cos(heading);
        (x, y) = (x + step * cos, y + step * sin);
        made = made.cut(x, y, 0.0);
    }
    made.plan()
}

#[test]
fn pro_smoothing_larger() {
    let mut more = 0;
    for seed in 0..20 {
        let (less, all) = (curves(&wander(seed, 0.6)), curves(&wander(seed, 2.0)));
        assert!(less.contains(&true));
        assert!(less.iter().zip(&all).all(|(less, all)| !less || *all), "seed {seed}");
        more += usize::from(less != all);
    }
    assert!(more > 10, "{more}");
}

#[test]
fn pro_smoothing_zero() {
    let plan = polygon(72, 50.0, 0.0, 0.0);
    assert!(!curves(&plan).contains(&true));
    assert_eq!((plan.moves().len(), stops(&plan)), (72, 71));
}

#[test]
fn pro_smoothing_default() {
    assert_eq!(Settings::default().smoothing.factor, 0.6);
}

#[test]
fn pro_smoothing_stop() {
    let bent = |degrees: f64, factor: f64| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let made = bench([0.0; 3], 50.0).factor(factor);
        joints(&made.cut(50.0, 0.0, 0.0).cut(50.0 + 50.0 * cos, 50.0 * sin, 0.0).plan())
    };
    near(bent(0.8, 0.6)[0], 50.0);
    assert_eq!(bent(2.0, 0.0), [0.0]);
    assert_eq!(bent(1.01, 0.6), [0.0]);
}

#[test]
fn pro_smoothing_stop_default() {
    assert_eq!(Settings::default().smoothing.stop_angle_deg, 1.0);
}

#[test]
fn pro_smoothing_stop_outside() {
    assert_eq!(stops(&polygon(72, 50.0, 0.0, 0.0)), 71);
    let plan = polygon(72, 50.0, 0.0, 0.6);
    assert_eq!(stops(&plan), 0);
    let cruise = plan.duration_s() * 0.5;
    for k in -20..20 {
        let state = plan.at(cruise + f64::from(k) * 0.05);
        let [vx, vy, _] = state.velocity.first3();
        assert!((vx.hypot(vy) - 50.0).abs() < 0.01, "{}", vx.hypot(vy));
    }
}

#[test]
fn pro_smoothing_tangent() {
    let plan = bench([0.0; 3], 50.0).cut(50.0, 0.0, 0.0).round([50.0, 10.0], PI, 0.0).plan();
    assert_eq!(joints(&plan), [50.0]);
    // A tighter one limits the joint by its curvature: 1000 mm/s² on 1 mm.
    let plan = bench([0.0; 3], 50.0).cut(50.0, 0.0, 0.0).round([50.0, 1.0], PI, 0.0).plan();
    near(joints(&plan)[0], 1000f64.sqrt());
}

#[test]
fn pro_smoothing_curve() {
    let limit = 0.06;
    for plan in [polygon(72, 50.0, 0.0, 0.6), wander(3, 0.6)] {
        let moves = plan.moves();
        for (k, m) in moves.iter().enumerate().filter(|(_, m)| *m != &moves[0]) {
            let Path::Curve { start, .. } = m.path else { continue };
            assert_eq!((m.position(0.0), m.position(1.0)), (m.from, m.to));
            near_place(m.position(1e-9), m.from);
            if let Path::Curve { end, .. } = moves[k - 1].path {
                assert_eq!(start, end);
            }
            let [ax, ay, _] = m.from.first3();
            let [dx, dy, _] = m.to.minus(m.from).first3();
            for u in 1..50 {
                let [x, y, _] = m.position(f64::from(u) / 50.0).first3();
                let off = ((x - ax) * dy - (y - ay) * dx).abs() / dx.hypot(dy);
                assert!(off <= limit * 1.01, "{off}");
            }
        }
    }
}

#[track_caller]
fn near_place(a: Axes, b: Axes) {
    assert!(a.0.iter().zip(b.0).all(|(a, b)| (a - b).abs() < 1e-6), "{a:?} is not {b:?}");
}

#[test]
fn pro_smoothing_corners() {
    let mut square = bench([0.0; 3], 50.0).factor(2.0);
    for (x, y) in [(0.2, 0.0), (0.2, 0.2), (0.0, 0.2), (0.0, 0.0)] {
        square = square.cut(x, y, 0.0);
    }
    let plan = square.plan();
    assert!(!curves(&plan).contains(&true));
    assert_eq!(stops(&plan), 3);
    // 45° is not sharp, 46° is.
    for (sides, smooth) in [(8, true), (7, false)] {
        assert_eq!(curves(&polygon(sides, 0.2, 0.0, 2.0)).contains(&true), smooth, "{sides}");
    }
}

#[test]
fn pro_smoothing_three_d() {
    let helix = polygon(72, 50.0, 5.0, 0.6);
    assert!(all_smooth(&helix));
    assert_eq!(stops(&helix), 0);
    let middle = helix.at(0.5 * helix.duration_s()).position.first3();
    near(middle[2], -2.5);
}

#[test]
fn a_straight_before_a_curve_of_segments_is_left_without_a_stop() {
    let mut made = bench([0.0; 3], 50.0).cut(60.0, 0.0, 0.0);
    for k in 1..=36 {
        let (sin, cos) = (f64::from(k) * 5f64.to_radians()).sin_cos();
        made = made.cut(60.0 + 20.0 * sin, 20.0 - 20.0 * cos, 0.0);
    }
    let plan = made.cut(0.0, 40.0, 0.0).plan();
    assert!(!curves(&plan)[0] && !curves(&plan)[37]);
    assert_eq!(stops(&plan), 0);
}

#[test]
fn pro_speeds_centripetal() {
    for (percent, radius, expected) in
        [(50.0, 20.0, 100.0), (50.0, 5.0, 50.0), (100.0, 20.0, 141.421), (25.0, 20.0, 70.711)]
    {
        let mut made = bench([radius, 0.0, 0.0], 500.0);
        made.smoothing.centripetal_percent = percent;
        let plan = made.round([0.0, 0.0], 10.0 * PI, 0.0).plan();
        near(plan.span(0).unwrap().v_peak, expected);
    }
    assert_eq!(Settings::default().smoothing.centripetal_percent, 100.0);
}

/// The speed of a long cut in a direction, mm/min.
fn speed_in(degrees: f64, y_factor: f64) -> f64 {
    let (sin, cos) = f64::to_radians(degrees).sin_cos();
    let mut made = bench([0.0; 3], 500.0);
    made.smoothing.cut_speed_mm_s = Some(100.0);
    made.smoothing.y_factor = y_factor;
    60.0 * made.cut(-500.0 * cos, 500.0 * sin, 0.0).plan().span(0).unwrap().v_peak
}

#[test]
fn pro_speeds_yfactor() {
    near(speed_in(90.0, 0.8), 4800.0);
    near(speed_in(90.0, 1.0), 6000.0);
    assert_eq!(Settings::default().smoothing.y_factor, 1.0);
}

#[test]
fn pro_speeds_yfactor_angle() {
    for (degrees, expected) in
        [(0.0, 6000.0), (30.0, 5600.0), (45.0, 5400.0), (60.0, 5200.0), (90.0, 4800.0)]
    {
        near(speed_in(degrees, 0.8), expected);
    }
    near(speed_in(60.0, 1.5), 8000.0);
    // Then the limits of the axes: 12000 mm/min for Y alone.
    near(speed_in(90.0, 2.5), 12_000.0);
    // Round a circle the slowest direction counts.
    let mut made = bench([50.0, 0.0, 0.0], 500.0);
    (made.smoothing.cut_speed_mm_s, made.smoothing.y_factor) = (Some(100.0), 0.8);
    near(made.round([0.0, 0.0], 0.4 * PI, 0.0).plan().span(0).unwrap().v_peak, 80.0);
}

#[test]
fn pro_speeds_cut_group() {
    let mut made = bench([0.0; 3], 150.0);
    made.smoothing.cut_speed_mm_s = Some(100.0);
    near(made.cut(500.0, 0.0, 0.0).plan().span(0).unwrap().v_peak, 100.0);
}

#[test]
fn pro_axes_maxspeed() {
    let rapid =
        |x: f64, y: f64| bench([0.0; 3], 50.0).to(MoveKind::Jog, Axes::xyz(x, y, 0.0)).plan();
    near(rapid(1000.0, 0.0).span(0).unwrap().v_peak, 200.0);
    let state = rapid(1000.0, 1000.0).at(3.0);
    near(state.velocity[Axis::X], 200.0);
    near(state.velocity[Axis::Y], 200.0);
    let mut turned = Axes::default();
    turned[Axis::C] = 720.0;
    let plan = bench([0.0; 3], 50.0).to(MoveKind::Jog, turned).plan();
    near(plan.at(2.0).velocity[Axis::C], 180.0);
}

#[test]
fn pro_axes_maxacc() {
    let plan = bench([0.0; 3], 50.0).to(MoveKind::Jog, Axes::xyz(100.0, 0.0, 0.0)).plan();
    near(plan.duration_s(), 0.7);
    near(plan.at(0.1).acceleration[Axis::X], 1000.0);
}

#[test]
fn pro_axes_tangent_arc() {
    // C turns with the direction, as a knife does.
    let made = bench([10.0, 0.0, 0.0], 50.0).round([0.0, 0.0], TAU, 360.0);
    near(made.plan().span(0).unwrap().v_peak, 31.416);
}

#[test]
fn a_plunge_ramps_with_the_acceleration_of_z() {
    let mut made = bench([0.0, 0.0, -10.0], 20.0);
    made.dynamics.accel_mm_s2[Axis::Z] = 500.0;
    near(made.cut(0.0, 0.0, -30.0).plan().duration_s(), 1.04);
}

#[test]
fn axes_keep_their_accelerations_on_straight_ways_and_the_path_is_unbroken() {
    for seed in 30..40 {
        let plan = wander(seed, 0.6);
        let (mut before, step) = (plan.at(0.0), 0.001);
        for k in 1..(plan.duration_s() / step) as u32 {
            let state = plan.at(f64::from(k) * step);
            let jump = state.position.minus(before.position).first3();
            assert!(jump[0].hypot(jump[1]) <= 50.5 * step, "{jump:?}");
            let curve = matches!(plan.moves()[state.move_index].path, Path::Curve { .. });
            // Along and across a curve together: at most both in full, at 45°.
            let most = ACCEL * if curve { 1.75 } else { 1.0 + 1e-9 };
            assert!(state.acceleration.0.iter().all(|a| a.abs() <= most), "{state:?}");
            before = state;
        }
    }
}

#[test]
fn a_stop_inside_a_curve_leaves_the_rest_of_it() {
    let plan = polygon(72, 50.0, 0.0, 0.6);
    let total: f64 = plan.moves().iter().map(|m| m.length_mm).sum();
    let stop = plan.stop(1.0, true).unwrap();
    let (made, rest) = plan.cut(&stop);
    assert_eq!(made.at(made.duration_s()).path_speed_mm_s, 0.0);
    let [x, y, _] = stop.position.first3();
    assert!((x.hypot(y) - 50.0).abs() < 1e-3);
    near_place(rest[0].from, stop.position);
    let lengths = |moves: &[Move]| moves.iter().map(|m| m.length_mm).sum::<f64>();
    near(lengths(made.moves()) + lengths(&rest), total);
    let dynamics = bench([0.0; 3], 1.0).dynamics;
    let again = Profiler { dynamics: &dynamics, smoothing: &Smoothing::default() }.plan(rest);
    assert_eq!(stops(&again), 0);
}

#[test]
fn the_model_in_force_is_the_one_named() {
    let mut settings = Settings::default();
    assert_eq!(settings.model(), RampModel::Shopbot);
    settings.dynamics = Some(settings.axis_dynamics());
    assert_eq!(settings.model(), RampModel::Optimal);
    settings.ramp_model = Some(RampModel::Profiler);
    assert_eq!(settings.model(), RampModel::Profiler);
}

/// An override on the way changes the speed by the ramps of the axes; the tool does not stop.
#[test]
fn an_override_keeps_moving() {
    let mut settings = Settings { ramp_model: Some(RampModel::Profiler), ..Settings::default() };
    settings.speeds.cut.xy = 100.0;
    let dynamics = settings.axis_dynamics();
    let mut mover = Mover::new(Axes::default(), &settings);
    let place = |k: u32| {
        let x = 2.0 * f64::from(k);
        Axes::xyz(x, 8.0 * (x / 40.0).sin(), 0.0)
    };
    let line = |to| Line { kind: MoveKind::Cut, to, feed: Feed::Axis };
    let moves: Vec<Move> =
        (1..400).filter_map(|k| mover.line(At::default(), &line(place(k)))).collect();
    for share in [0.3, 0.8, 1.5] {
        let mut planner = planner(&settings);
        moves.iter().for_each(|m| planner.push(*m));
        let piece = planner.take().or_else(|| planner.finish()).unwrap();
        let (made, stop) = planner.feed(piece, 2.0, share).unwrap();
        assert!((stop.end_s - 2.0).abs() < 1e-9);
        let mut speed = made.at(stop.end_s - 1e-9).path_speed_mm_s;
        let next = planner.take().or_else(|| planner.finish()).unwrap();
        let most = 1.5e-3 * dynamics.accel_mm_s2.0[0] + 1e-6;
        // The piece that slows may be short; what follows is checked by the next one.
        for k in 1..((next.duration_s() * 1e3) as u32).min(1000) {
            let now = next.at(f64::from(k) * 1e-3).path_speed_mm_s;
            assert!((now - speed).abs() < most, "{share}: {speed} to {now} mm/s");
            speed = now;
        }
        let goal = 100.0 * f64::from(share);
        assert!(speed > 0.4 * goal && speed < 1.1 * goal, "{share}: {speed} mm/s");
        let left = std::iter::from_fn(|| planner.take().or_else(|| planner.finish())).last();
        let end = left.as_ref().unwrap_or(&next).moves().last().unwrap().to;
        assert_eq!(end, moves.last().unwrap().to);
    }
}
