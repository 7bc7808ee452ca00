//! The rows of the ledger's area `motion` that are about planning, with their numbers.

use crate::shop::{joints, near, peaks, vs};
use kerf_motion::Plan;
use kerf_program::Axis;
use kerf_program::settings::MM_PER_INCH as INCH;

fn speed_at(plan: &Plan, t_s: f64) -> f64 {
    plan.at(t_s).path_speed_mm_s / INCH
}

fn x_at(plan: &Plan, t_s: f64) -> f64 {
    plan.at(t_s).position[Axis::X] / INCH
}

#[test]
fn sbp_motion_trapezoid() {
    let plan = vs(2.0, 1.0).mx(4.0).plan();
    let end = plan.duration_s();
    near(&[end], &[2.0914], 5e-5);
    let ramp_s = 1.6 / 14.0;
    near(&[x_at(&plan, ramp_s), 4.0 - x_at(&plan, end - ramp_s)], &[0.13714; 2], 5e-6);
    for t in [0.0, 0.03, 0.07, 0.11, 0.2, 1.0] {
        near(&[speed_at(&plan, t)], &[speed_at(&plan, end - t - 1e-12)], 1e-9);
        near(&[speed_at(&plan, t)], &[(0.4 + 14.0 * t).min(2.0)], 1e-9);
    }
}

#[test]
fn sbp_motion_ramp_rate() {
    let plan = vs(3.0, 1.0).mx(4.0).plan();
    let t = 2.0 / 14.0;
    near(&[t, speed_at(&plan, t), x_at(&plan, t)], &[0.142857, 2.4, 0.2], 1e-6);
    near(&[plan.moves()[0].accel_mm_s2 / INCH], &[14.0], 1e-9);
    let slower = vs(3.0, 1.0).set(|s| s.ramps.cut_rate_mm = 0.4 * INCH).mx(4.0).plan();
    near(&[slower.moves()[0].accel_mm_s2 / INCH], &[7.0], 1e-9);
}

#[test]
fn sbp_motion_jog_rate() {
    let vr = |s: &mut kerf_program::Settings| {
        s.ramps.jog.xy = INCH;
        s.ramps.jog_rate_mm = 0.4 * INCH;
    };
    let plan = vs(2.0, 1.0).set(vr).j3(9.0, 0.0, 0.0).mx(18.0).plan();
    let accel: Vec<f64> = plan.moves().iter().map(|m| m.accel_mm_s2 / INCH).collect();
    near(&accel, &[10.0, 14.0], 1e-9);
    let starts: Vec<f64> = plan.iter().map(|s| s.v_entry / INCH).collect();
    near(&starts, &[1.0, 0.4], 1e-9);
}

#[test]
fn sbp_motion_slow_noramp() {
    let plan = vs(0.3, 1.0).mx(1.0).plan();
    near(&[plan.duration_s()], &[3.3333], 5e-5);
    for share in [0.0, 0.01, 0.5, 0.99] {
        near(&[speed_at(&plan, share * plan.duration_s())], &[0.3], 1e-12);
    }
}

#[test]
fn sbp_motion_short() {
    let plan = vs(2.0, 1.0).mx(0.1).plan();
    near(&[peaks(&plan)[0], plan.duration_s()], &[1.2490, 0.12129], 5e-5);
    near(&[x_at(&plan, plan.duration_s() / 2.0)], &[0.05], 1e-9);
}

#[test]
fn sbp_motion_jog_always() {
    let plan = vs(2.0, 1.0).j3(5.0, 0.0, 0.0).j3(10.0, 0.0, 0.0).plan();
    near(&joints(&plan), &[0.4; 3], 1e-9);
}

#[test]
fn sbp_motion_lookahead() {
    let plan = vs(3.0, 1.0).mx(5.0).mx(10.0).mx(15.0).plan();
    near(&joints(&plan), &[0.4, 3.0, 3.0, 0.4], 1e-9);
}

#[test]
fn sbp_motion_corner_full() {
    for speed in [3.0, 1.0] {
        let plan = vs(speed, 1.0).mx(5.0).m3(5.0, 5.0, 0.0).plan();
        near(&joints(&plan), &[0.4; 3], 1e-9);
    }
    let plan = vs(1.0, 1.0).mx(5.0).ray(42.9, 5.0).plan();
    near(&joints(&plan), &[0.4, 1.0, 0.4], 1e-9);
}

#[test]
fn sbp_motion_corner_threshold() {
    for (speed, degrees, passed) in
        [(5.5, 10.0, 5.5), (10.0, 10.0, 5.69737), (5.5, 23.9, 5.5), (5.5, 24.1, 3.5583)]
    {
        for sign in [1.0, -1.0] {
            let plan = vs(speed, 1.0).mx(9.0).ray(sign * degrees, 9.0).plan();
            near(&joints(&plan), &[0.4, passed, 0.4], 1e-4);
        }
    }
}

#[test]
fn sbp_motion_slowcorner() {
    for (percent, degrees, passed) in
        [(65.0, 24.0, 3.575), (65.0, 33.5, 1.9875), (65.0, 43.0, 0.4), (90.0, 24.0, 4.95)]
    {
        let stack = vs(5.5, 1.0).set(|s| s.ramps.slow_corner_percent = percent);
        let plan = stack.mx(9.0).ray(degrees, 9.0).plan();
        near(&joints(&plan), &[0.4, passed, 0.4], 1e-4);
    }
}

/// Lowest speed at the joints of a curve between two long straights.
fn lowest_in_curve(speed: f64, min_distance: f64, degrees: f64, radius: f64, n: u32) -> f64 {
    let stack = vs(speed, 1.0).set(|s| s.ramps.min_distance_mm = min_distance * INCH);
    let plan = stack.mx(9.0).chords(0.0, degrees, radius, n).ray(degrees, 9.0).plan();
    let joints = joints(&plan);
    joints[1..joints.len() - 1].iter().copied().fold(f64::INFINITY, f64::min)
}

#[test]
fn sbp_motion_mindist() {
    // 157 chords of .01: in .15 lie 15 chords, or 16 joints.
    near(&[lowest_in_curve(10.0, 0.15, 90.0, 1.0, 157)], &[5.9], 0.1);
    near(&[lowest_in_curve(10.0, 0.05, 90.0, 1.0, 157)], &[10.0], 1e-9);
}

#[test]
fn sbp_motion_curve_radius() {
    near(&[lowest_in_curve(3.0, 0.15, 45.0, 0.2, 20)], &[0.4], 1e-9);
    near(&[lowest_in_curve(3.0, 0.05, 45.0, 0.24, 20)], &[0.4], 1e-9);
    near(&[lowest_in_curve(3.0, 0.05, 45.0, 0.3, 20)], &[3.0], 1e-9);
    near(&[lowest_in_curve(3.0, 0.15, 45.0, 1.0, 20)], &[3.0], 1e-9);
}

/// Highest speed between the first and the last joint of a curve of radius .2 at 3 in/s between two long straights.
fn highest_in_curve(min_distance: f64, degrees: f64, n: u32) -> f64 {
    let stack = vs(3.0, 1.0).set(|s| s.ramps.min_distance_mm = min_distance * INCH);
    let plan = stack.mx(9.0).chords(0.0, degrees, 0.2, n).ray(degrees, 9.0).plan();
    let peaks = peaks(&plan);
    peaks[1..peaks.len() - 1].iter().copied().fold(0.0, f64::max)
}

#[test]
#[allow(non_snake_case)]
fn sbp_motion_curve_radius__speed_all_through() {
    for degrees in [45.0, 60.0, 90.0, 135.0, 180.0] {
        for n in [5, 8, 13, 20, 64, 300] {
            for min_distance in [0.05, 0.15, 0.5] {
                let highest = highest_in_curve(min_distance, degrees, n);
                assert!(highest < 0.4 + 1e-6, "{degrees} in {n}, {min_distance}: {highest}");
            }
        }
    }
}

#[test]
fn sbp_motion_short_zigzag() {
    let mut stack = vs(3.0, 1.0);
    for k in 0..50 {
        stack = stack.mx(if k % 2 == 0 { 0.02 } else { 0.0 });
    }
    let plan = stack.plan();
    near(&peaks(&plan), &[0.4; 50], 1e-9);
    near(&[plan.duration_s()], &[50.0 * 0.02 / 0.4], 1e-9);
}

#[test]
fn sbp_motion_3d_zlimit() {
    let plan = vs(4.0, 1.0).m3(10.0, 0.0, -5.0).plan();
    near(&peaks(&plan), &[2.0], 1e-9);
    let state = plan.at(plan.duration_s() / 2.0);
    near(&state.velocity.first3().map(|v| v / INCH), &[2.0, 0.0, -1.0], 1e-9);
    near(&[plan.duration_s()], &[5.0], 0.1);
}

/// XY speed at the join of two segments on which Z would run at these speeds while XY runs at 4.
fn z_join(threshold: f64, z1: f64, z2: f64) -> f64 {
    let stack = vs(4.0, 9.0).set(|s| s.ramps.threshold_3d_percent = threshold);
    let plan = stack.m3(8.0, 0.0, 2.0 * z1).m3(16.0, 0.0, 2.0 * z1 + 2.0 * z2).plan();
    joints(&plan)[1]
}

#[test]
fn sbp_motion_3d_zchange() {
    // Down to where Z changes by just its ramp speed: 4·.4/.7.
    near(&[z_join(100.0, 2.0, 1.3), z_join(100.0, 2.0, 1.7)], &[4.0 * 0.4 / 0.7, 4.0], 1e-9);
    near(&[z_join(100.0, 2.0, -2.0)], &[0.4], 1e-9);
}

#[test]
fn sbp_motion_3d_thresh() {
    near(&[z_join(200.0, 2.0, 1.3), z_join(50.0, 2.0, 1.7)], &[4.0, 4.0 * 0.2 / 0.3], 1e-9);
}

#[test]
fn sbp_motion_3d_xyangle() {
    let mut stack = vs(4.0, 1.0);
    for k in 1..=40 {
        stack = stack.m3(f64::from(k), 0.0, if k % 2 == 0 { 0.0 } else { 0.045 });
    }
    let joints = joints(&stack.plan());
    near(&joints[1..40], &[4.0; 39], 1e-9);
}
