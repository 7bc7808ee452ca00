//! Steps as commands: every step in its window, few commands, nothing too fast for a driver.

use kerf_driver_klipper::compress::{Compressor, Limits, Steps, TooFast};
use kerf_driver_klipper::fake::Dice;

const LIMITS: Limits = Limits { error: 60.0, least: 60, turn: 240 };

fn compressed(limits: Limits, steps: &[(f64, bool)]) -> Result<Vec<Steps>, TooFast> {
    let mut out = Vec::new();
    let mut compressor = Compressor::new(limits, 1000);
    for (clock, forward) in steps {
        compressor.push(*clock, *forward, &mut out)?;
    }
    compressor.finish(&mut out)?;
    Ok(out)
}

fn unfolded(commands: &[Steps]) -> Vec<(u64, bool)> {
    let each = |steps: &Steps| (1..=steps.count).map(|k| (steps.at(k), steps.forward)).collect();
    commands.iter().flat_map(|steps| -> Vec<_> { each(steps) }).collect()
}

/// Steps of an axis at places in steps, over ticks.
fn steps_of(place: impl Fn(f64) -> f64, ticks: f64) -> Vec<(f64, bool)> {
    let (mut made, mut steps, grain) = (0.0, Vec::new(), ticks / 400_000.0);
    let mut t = 0.0;
    while t < ticks {
        let next = t + grain;
        loop {
            let at = place(next);
            let forward = at > made + 0.5;
            if !forward && at >= made - 0.5 {
                break;
            }
            let half = if forward { made + 0.5 } else { made - 0.5 };
            let (mut low, mut high) = (t, next);
            for _ in 0..40 {
                let middle = 0.5 * (low + high);
                if (place(middle) > half) == forward { high = middle } else { low = middle }
            }
            made += if forward { 1.0 } else { -1.0 };
            steps.push((100_000.0 + high, forward));
        }
        t = next;
    }
    steps
}

/// Checks that steps come out as they went in, each within its window, and returns the number of commands.
fn check(limits: Limits, steps: &[(f64, bool)]) -> usize {
    let commands = compressed(limits, steps).expect("steps that can be made");
    let made = unfolded(&commands);
    assert_eq!(made.len(), steps.len());
    let (mut before, mut way) = (0, None);
    for (n, ((made, forward), (planned, ahead))) in made.iter().zip(steps).enumerate() {
        assert_eq!(forward, ahead, "step {n}");
        let since = n.checked_sub(1).map_or(f64::INFINITY, |n| planned - steps[n].0);
        let until = steps.get(n + 1).map_or(f64::INFINITY, |next| next.0 - planned);
        let most = limits.error.min(0.5 * since.min(until)).max(0.5);
        let error = *made as f64 - planned;
        assert!(error.abs() <= most + 0.01, "step {n} is {error} ticks late, {most} are allowed");
        let least = if way == Some(*forward) { limits.least } else { limits.turn };
        assert!(n == 0 || made - before >= u64::from(least), "step {n}: {} ticks", made - before);
        (before, way) = (*made, Some(*forward));
    }
    for pair in commands.windows(2) {
        assert_eq!(pair[1].from, pair[0].to(), "no reset within");
    }
    commands.len()
}

#[test]
fn a_constant_speed_is_few_commands() {
    let even: Vec<_> = (1..20_000).map(|n| (1000.0 + f64::from(n) * 750.0, true)).collect();
    assert_eq!(check(LIMITS, &even), 5);
    let odd: Vec<_> = (1..20_000).map(|n| (1000.0 + f64::from(n) * 750.25, true)).collect();
    assert!((55..70).contains(&check(LIMITS, &odd)), "{}", check(LIMITS, &odd));
}

#[test]
fn a_constant_acceleration_is_few_commands() {
    let ramp = steps_of(|t| 4000.0 * (t / 12e6).powi(2) * 2.0, 12e6);
    assert_eq!(ramp.len(), 8000);
    let commands = check(LIMITS, &ramp);
    assert!(commands < 260, "{commands}");
}

#[test]
fn steps_stay_in_their_windows_whatever_the_axis_does() {
    let mut dice = Dice(11);
    for _ in 0..12 {
        let [a, b, c] = [0; 3].map(|_: i32| dice.share());
        let wave = |t: f64| {
            let s = t / 12e6;
            900.0 * a * (7.0 * s).sin().powi(3)
                + 500.0 * b * (3.0 * s * c).cos() * s * s
                + 300.0 * s.powi(3)
        };
        let steps = steps_of(wave, 36e6);
        let steps = without_quick_turns(&steps);
        assert!(steps.len() > 300);
        check(LIMITS, &steps);
        check(Limits { error: 24.0, ..LIMITS }, &steps);
    }
}

/// Steps without those there and back at once, which are left out.
fn without_quick_turns(steps: &[(f64, bool)]) -> Vec<(f64, bool)> {
    let mut kept: Vec<(f64, bool)> = Vec::new();
    for step in steps {
        match kept.last() {
            Some(last) if last.1 != step.1 && step.0 - last.0 < f64::from(LIMITS.turn) => {
                _ = kept.pop()
            }
            _ => kept.push(*step),
        }
    }
    kept
}

#[test]
fn fast_steps_are_within_half_a_step_and_turns_within_their_time() {
    let mut dice = Dice(5);
    for _ in 0..300 {
        let (mut clock, mut steps) = (100_000.0, Vec::new());
        for n in 0..12 {
            // As close as a driver lets them be, and to and fro as close as it turns.
            for _ in 0..1 + dice.below(9) {
                clock += 100.0 + dice.share() * 60.0;
                steps.push((clock, n % 2 == 0));
            }
            clock += 145.0 + dice.share() * 30.0;
        }
        check(LIMITS, &steps);
    }
}

#[test]
fn a_step_there_and_back_at_once_is_not_made() {
    let steps = [(5000.0, true), (9000.0, true), (9100.0, false), (20_000.0, false)];
    let commands = compressed(LIMITS, &steps).expect("steps");
    let made: Vec<_> = unfolded(&commands).iter().map(|(_, forward)| *forward).collect();
    assert_eq!(made, [true, false]);
}

#[test]
fn a_long_rest_sets_the_clock_anew() {
    let steps = [(5000.0, true), (9000.0, true), (5e9, true), (5e9 + 4000.0, true)];
    let commands = compressed(LIMITS, &steps).expect("steps");
    let resets = commands.windows(2).filter(|pair| pair[1].from != pair[0].to()).count();
    assert_eq!((commands.len(), resets), (3, 1));
    assert!(unfolded(&commands)[2].0.abs_diff(5_000_000_000) <= 60);
}

#[test]
fn steps_that_no_driver_can_make_are_refused() {
    let fast: Vec<_> = (1..50).map(|n| (2000.0 + f64::from(n) * 50.0, true)).collect();
    let refused = compressed(LIMITS, &fast).expect_err("50 ticks are less than 60");
    assert_eq!(refused.least, 60);
}

/// Fewest commands by trying, for each beginning, every `add` and every interval that could be.
fn fewest(steps: &[(f64, bool)], error: f64) -> usize {
    let (mut from, mut done, mut commands) = (1000_i64, 0, 0);
    while done < steps.len() {
        let mut best = (0, 0);
        for add in -3000..=3000_i64 {
            let (mut low, mut high, mut k) = (f64::from(LIMITS.least), f64::MAX, 1_i64);
            for (n, (clock, _)) in steps[done..].iter().enumerate() {
                let at = done + n;
                let since = if at == 0 { f64::INFINITY } else { clock - steps[at - 1].0 };
                let until = steps.get(at + 1).map_or(f64::INFINITY, |next| next.0 - clock);
                let reach = error.min(0.5 * since.min(until)).max(0.5);
                let bend = (add * (k * (k - 1) / 2)) as f64;
                low = low.max((clock - reach - from as f64 - bend) / k as f64);
                high = high.min((clock + reach - from as f64 - bend) / k as f64);
                let interval = (0.5 * (low + high)).round();
                if interval < low || interval > high {
                    break;
                }
                if k > best.0 {
                    best = (k, from + k * interval as i64 + add * (k * (k - 1) / 2));
                }
                k += 1;
            }
        }
        commands += 1;
        done += best.0 as usize;
        from = best.1;
    }
    commands
}

#[test]
fn commands_are_nearly_as_few_as_can_be() {
    let s_curve = |t: f64| {
        2000.0 * {
            let s = t / 12e6;
            s * s * s * (10.0 - 15.0 * s + 6.0 * s * s)
        }
    };
    for error in [24.0, 60.0, 250.0] {
        let steps = steps_of(s_curve, 12e6);
        let few = fewest(&steps, error);
        let found = check(Limits { error, ..LIMITS }, &steps);
        assert!(found * 100 <= few * 105, "{found} commands, {few} would do");
    }
}

#[test]
fn steps_that_are_told_by_their_last_one_are_all_made_and_none_too_close() {
    // Braking from 300,000 steps/s on a clock of 12 MHz: 40 ticks apart, then longer and longer.
    let steps = steps_of(|t| t / 40.0 - 1.25e-8 * t * t / 2.0, 2e6);
    assert!(steps.len() > 24_000, "{}", steps.len());
    let limits = Limits { error: 24.0, least: 15, turn: 15 };
    for each in [1, 7, 75] {
        let (mut commands, mut compressor) = (Vec::new(), Compressor::new(limits, 100_000));
        let mut marks: Vec<(f64, u16)> = Vec::new();
        for some in steps.chunks(each) {
            let (clock, forward) = some[some.len() - 1];
            marks.push((clock, some.len() as u16));
            compressor.push_even(clock, forward, some.len() as u16, &mut commands).unwrap();
        }
        compressor.finish(&mut commands).unwrap();
        let made = unfolded(&commands);
        assert_eq!(made.len(), steps.len(), "{each} at once");
        assert!(made.windows(2).all(|pair| pair[1].0 >= pair[0].0 + 15));
        let mut n = 0;
        for (clock, count) in marks {
            n += usize::from(count);
            let off = (made[n - 1].0 as f64 - clock).abs();
            assert!(off <= 24.0_f64.max(0.5 * f64::from(count)) + 0.01, "{off} ticks at step {n}");
        }
        assert!(commands.len() < steps.len() / 20, "{} commands", commands.len());
    }
}
