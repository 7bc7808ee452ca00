//! Motion on a fake board: made as planned, stopped when it has to be, counted always.

use crate::world::{Feed, GRAIN_S, Motion, World};
use kerf_driver_klipper::board::{Ended, Home, News, NotNow, Options};
use kerf_driver_klipper::fake::{Dice, Faults};

/// Number of tries; `TRIES` in the environment is how many times as many there are.
fn tries(usual: u64) -> u64 {
    let times = std::env::var("TRIES").ok().and_then(|times| times.parse().ok());
    usual * times.unwrap_or(1)
}

/// Faults that befall 1 % of the frames.
fn one_percent() -> Faults {
    Faults { drop: 0.0025, flip: 0.0025, repeat: 0.0025, swap: 0.0025, ..Faults::default() }
}

/// Holds the steps that the board made against those that were planned: the same, each within a time, ticks.
fn compare(world: &World, feed: &Feed, within: f64) -> usize {
    let mut compared = 0;
    for (oid, planned) in feed.planned.iter().enumerate() {
        let made = &world.fake.steppers[&(oid as u8)].made;
        // A step there and back at once is left out by both.
        let planned = without_quick_turns(planned.iter().map(|s| (s.clock, s.forward)));
        assert_eq!(made.len(), planned.len(), "motor {oid}");
        for (n, ((clock, dir), (due, forward))) in made.iter().zip(&planned).enumerate() {
            assert_eq!(dir, forward, "motor {oid} step {n}");
            let late = *clock as f64 - due;
            let turns = n > 0 && planned[n - 1].1 != *forward;
            let within = if turns { within + 240.0 } else { within };
            assert!(late.abs() <= within, "motor {oid} step {n}: {late} ticks");
        }
        compared += made.len();
    }
    compared
}

fn without_quick_turns(steps: impl Iterator<Item = (f64, bool)>) -> Vec<(f64, bool)> {
    let mut kept: Vec<(f64, bool)> = Vec::new();
    for step in steps {
        match kept.last() {
            Some(last) if last.1 != step.1 && step.0 - last.0 < 240.0 => _ = kept.pop(),
            _ => kept.push(step),
        }
    }
    kept
}

/// Makes a motion and compares it; returns the number of steps.
fn check_made(seed: u64, faults: Faults, motion: &Motion) -> usize {
    let mut world = World::ready(seed, faults);
    let mut feed = world.begin(motion, &[]);
    while world.feed(motion, &mut feed) {
        world.pass();
    }
    let (why, counts) = world.wait_end();
    assert_eq!(why, Ended::Rested, "seed {seed}");
    let ends: Vec<i64> =
        motion.places.iter().map(|place| place(motion.lasts_s).round() as i64).collect();
    assert_eq!(counts, ends, "seed {seed}");
    assert!(!world.fake.is_shutdown());
    compare(&world, &feed, 61.0)
}

#[test]
fn motion_is_made_as_it_was_planned() {
    for seed in 0..4 {
        let steps = check_made(seed, Faults::default(), &Motion::waves(4000.0, 3.0));
        assert!(steps > 10_000, "{steps}");
    }
}

#[test]
fn motion_is_made_as_planned_on_a_faulty_line() {
    let seeds = 10..10 + tries(6);
    let (runs, made) = (seeds.clone().count(), |seed| {
        check_made(seed, one_percent(), &Motion::waves(5000.0, 4.0))
    });
    let steps: usize = seeds.map(made).sum();
    eprintln!("{runs} runs, {steps} steps, none wrong");
}

#[test]
fn a_board_whose_clock_is_off_is_followed() {
    let mut world = World::ready(3, Faults::default());
    world.fake.drift = 0.0;
    let mut fast = World::new(4, Faults::default(), crate::world::setup(), Default::default());
    fast.fake.drift = 80e-6;
    fast.wait(|news| matches!(news, News::Ready { .. }));
    fast.pass_for(30.0);
    let (clock, off) = fast.host.clock(fast.now_s).expect("a clock");
    assert!(clock.abs_diff(fast.fake.now) < off, "{} ticks, {off}", clock.abs_diff(fast.fake.now));
    assert!(clock.abs_diff(fast.fake.now) < 12_000, "within a millisecond");
    let (why, _) = fast.make(&Motion::waves(3000.0, 2.0), &[]);
    assert_eq!(why, Ended::Rested);
}

#[test]
fn a_planner_that_falls_silent_leaves_the_machine_at_rest() {
    for pieces in [1, 7, 23] {
        let motion = Motion::waves(6000.0, 3.0);
        let mut world = World::ready(5, Faults::default());
        let mut feed = world.begin(&motion, &[]);
        while feed.next < pieces {
            world.feed(&Motion { lasts_s: 3.0, ..Motion::waves(6000.0, 3.0) }, &mut feed);
            world.pass();
        }
        let planned: usize = feed.planned.iter().map(Vec::len).sum();
        let (why, counts) = world.wait_end();
        assert_eq!(why, Ended::Rested);
        for (oid, count) in counts.iter().enumerate() {
            let stepper = &world.fake.steppers[&(oid as u8)];
            assert_eq!(stepper.position, *count);
            // The last steps of what moved fast are farther and farther apart.
            let gaps: Vec<u64> =
                stepper.made.windows(2).map(|pair| pair[1].0 - pair[0].0).collect();
            if gaps.len() > 200 {
                let last = gaps[gaps.len() - 3..].iter().sum::<u64>() / 3;
                let before = gaps[gaps.len() - 63..gaps.len() - 60].iter().sum::<u64>() / 3;
                assert!(last > before * 2, "motor {oid} slows down: {before}, {last} ticks");
            }
        }
        let made: usize = world.fake.steppers.values().map(|stepper| stepper.made.len()).sum();
        assert!(made > planned || pieces == 1, "the tail was made: {made}, {planned}");
        assert!(!world.fake.is_shutdown());
    }
}

#[test]
fn a_host_that_dies_leaves_motors_and_spindle_off() {
    let (mut dice, mut longest_s) = (Dice(9), [0.0_f64; 2]);
    for seed in 0..tries(30) {
        let mut motion = Motion::waves(2000.0, 3.0);
        motion.switches_s = vec![(0.01, 1)];
        let mut world = World::ready(20 + seed, one_percent());
        let mut feed = world.begin(&motion, &[]);
        let dies_s = world.now_s + 0.2 + dice.share() * 2.5;
        while world.now_s < dies_s {
            world.feed(&motion, &mut feed);
            world.pass();
        }
        world.stalls_until_s = f64::INFINITY;
        let died = world.fake.now;
        world.pass_for(1.5);
        let ticks = |clock: u64| clock.saturating_sub(died) as f64 / 12e6;
        let last = world
            .fake
            .steppers
            .values()
            .filter_map(|s| s.made.last())
            .map(|(clock, _)| *clock)
            .max();
        // The first deadline, before any motion, is later than the others.
        assert!(ticks(last.unwrap_or(0)) <= 0.11, "seed {seed}: {} s", ticks(last.unwrap_or(0)));
        let output = world.fake.outputs.values().next().unwrap();
        assert_eq!(output.value, 0, "seed {seed}: the output is off");
        let off = output.made.last().map_or(0, |(clock, _)| *clock);
        assert!(ticks(off) <= 0.7, "seed {seed}: {} s", ticks(off));
        let own = [ticks(last.unwrap_or(0)), ticks(off)];
        longest_s = [longest_s[0].max(own[0]), longest_s[1].max(own[1])];
    }
    eprintln!("{} kills: motors and output off after {longest_s:?} s at most", tries(30));
}

#[test]
fn a_stop_is_at_once_and_the_counts_are_those_of_the_board() {
    let mut dice = Dice(4);
    for seed in 0..tries(15) {
        let motion = Motion::waves(2000.0, 3.0);
        let mut world = World::ready(200 + seed, one_percent());
        let mut feed = world.begin(&motion, &[]);
        let stops_s = world.now_s + 0.5 + dice.share() * 2.0;
        while world.now_s < stops_s {
            world.feed(&motion, &mut feed);
            world.pass();
        }
        world.host.stop().expect("a board");
        let asked = world.fake.now;
        let (why, counts) = world.wait_end();
        assert_eq!(why, Ended::Asked);
        let positions: Vec<i64> = world.fake.steppers.values().map(|s| s.position).collect();
        assert_eq!(counts, positions);
        let last = world
            .fake
            .steppers
            .values()
            .filter_map(|s| s.made.last())
            .map(|(clock, _)| *clock)
            .max();
        let late_s = last.unwrap().saturating_sub(asked) as f64 / 12e6;
        assert!(late_s < 0.09, "seed {seed}: {late_s} s");
        // It goes on from there.
        let (why, _) = world.make(
            &Motion {
                places: Motion::straight(50.0, 0.5)
                    .places
                    .into_iter()
                    .zip(&counts)
                    .map(|(p, c)| {
                        let c = *c as f64;
                        Box::new(move |t| c + p(t)) as _
                    })
                    .collect(),
                lasts_s: 0.5,
                switches_s: vec![],
            },
            &[],
        );
        assert_eq!(why, Ended::Rested);
    }
}

#[test]
fn a_stall_makes_the_lead_longer_and_one_too_long_stops_without_a_shutdown() {
    let motion = Motion::waves(6000.0, 5.0);
    for (stall_s, ends) in [(0.02, Ended::Rested), (0.045, Ended::Rested), (0.5, Ended::Deadline)] {
        let mut world = World::ready(7, Faults::default());
        let mut feed = world.begin(&motion, &[]);
        let since_s = world.now_s;
        let mut stalls = 0.0;
        while world.feed(&motion, &mut feed) && world.news.is_empty() {
            if world.now_s > since_s + 1.0 + stalls {
                stalls += 0.7;
                world.stalls_until_s = world.now_s + stall_s;
            }
            world.pass();
        }
        let (why, counts) = world.wait_end();
        assert_eq!(why, ends, "stalls of {stall_s} s");
        assert!(!world.fake.is_shutdown(), "{:?}", world.fake.reason());
        let positions: Vec<i64> = world.fake.steppers.values().map(|s| s.position).collect();
        assert_eq!(counts, positions);
        let [seen_s, lead_s] = world.host.lead_s().expect("a board");
        assert!(
            seen_s > stall_s * 0.8 && lead_s > 0.1 + 2.0 * stall_s.min(0.1),
            "{seen_s} {lead_s}"
        );
    }
}

/// A planner that stays 0.2 s ahead, on a board that lets its host be silent for 0.3 s: where the host stalls while a frame is
/// being filled, the frame is late before the board's deadline is over.
#[test]
fn a_frame_that_waited_over_a_stall_ends_motion() {
    let mut late = 0;
    for stalls in 0..100 {
        let options = Options { deadline_s: 0.3, ..Options::default() };
        let mut world = World::new(60, Faults::default(), crate::world::setup(), options);
        world.ahead_s = 0.2;
        world.wait(|news| matches!(news, News::Ready { .. }));
        let motion = Motion::waves(3000.0, 3.0);
        let mut feed = world.begin(&motion, &[]);
        world.stalls_at(1.2 + f64::from(stalls) * GRAIN_S, 0.235, &motion, &mut feed);
        let (why, counts) = world.wait_end();
        assert!(!world.fake.is_shutdown(), "after {stalls} ms: {:?}", world.fake.reason());
        let positions: Vec<i64> = world.fake.steppers.values().map(|s| s.position).collect();
        assert_eq!(counts, positions, "after {stalls} ms");
        late += usize::from(why == Ended::Late);
    }
    assert!(late > 50, "{late} of 100 stalls made a step late");
}

#[test]
fn few_places_in_the_board_are_never_too_few() {
    let mut world = World::new(8, Faults::default(), crate::world::setup(), Default::default());
    world.fake.move_count = 40;
    world.wait(|news| matches!(news, News::Ready { .. }));
    let (why, _) = world.make(&Motion::waves(3000.0, 3.0), &[]);
    assert_eq!(why, Ended::Rested, "{:?}", world.fake.reason());
    assert!(
        world.fake.most_places <= 39 && world.fake.most_places > 5,
        "{}",
        world.fake.most_places
    );
}

#[test]
fn two_motors_of_an_axis_find_each_its_switch() {
    for seed in 0..10 {
        let mut world = World::ready(40 + seed, one_percent());
        world.fake.stops_at = vec![(10, 0, 700), (11, 1, 730)];
        let place = |t: f64| 900.0 * (t * 0.5).min(1.0);
        let motion = Motion {
            places: vec![Box::new(place), Box::new(place), Box::new(|_| 0.0)],
            lasts_s: 2.2,
            switches_s: vec![],
        };
        let home = |n: usize| Home { switch: n, motors: vec![n], opens: false, look_s: 0.0005 };
        let (why, counts) = world.make(&motion, &[home(0), home(1)]);
        assert_eq!((why, &counts[..]), (Ended::Touched, &[700, 730, 0][..]), "seed {seed}");
    }
}

#[test]
fn the_clock_at_which_a_probe_touched_is_told() {
    let mut world = World::ready(50, Faults::default());
    let motion = Motion::straight(2000.0, 2.0);
    world.fake.stops_at = vec![(10, 0, 900)];
    let home = Home { switch: 0, motors: vec![0, 1, 2], opens: false, look_s: 0.0002 };
    let mut feed = world.begin(&motion, &[home]);
    while world.feed(&motion, &mut feed) {
        world.pass();
    }
    let News::Touched { switch, clock, counts: then } =
        world.wait(|news| matches!(news, News::Touched { .. }))
    else {
        panic!()
    };
    let (why, counts) = world.wait_end();
    assert_eq!((switch, why), (0, Ended::Touched));
    assert_eq!(then, [900, 0, 0]);
    assert!((900..=901).contains(&counts[0]), "{counts:?}");
    let (closed, _) = world.fake.steppers[&0].made[899];
    assert!(clock >= closed && clock - closed <= 2400, "{clock} {closed}");
}

#[test]
fn motion_before_a_board_is_known_is_refused() {
    let mut world = World::new(1, Faults::default(), crate::world::setup(), Default::default());
    assert_eq!(world.host.start(&[], 0.0), Err(NotNow::Absent));
    world.wait(|news| matches!(news, News::Ready { .. }));
    assert_eq!(world.host.withdraw(), Err(NotNow::Rest));
    assert!(world.host.start(&[], world.now_s).is_ok());
    assert_eq!(world.host.start(&[], world.now_s), Err(NotNow::Busy));
}
