//! The numbers of docs/how-boards-with-step-queues-are-driven.md: `cargo test -p kerf-driver-klipper measured --
//! --nocapture`.

use crate::world::{Motion, World};
use kerf_driver_klipper::board::Ended;
use kerf_driver_klipper::fake::Faults;

const TICKS_PER_US: f64 = 12.0;

/// Three motors, the fastest at nearly 10,000 steps/s: 100 mm/s at 100 steps/mm.
fn waves() -> Motion {
    Motion::waves(4000.0, 5.0)
}

#[test]
fn measured_bytes_on_the_line_and_the_worst_step() {
    let (motion, mut world) = (waves(), World::ready(1, Faults::default()));
    let since = [world.there.bytes, world.back.bytes];
    let mut feed = world.begin(&motion, &[]);
    while world.feed(&motion, &mut feed) {
        world.pass();
    }
    assert_eq!(world.wait_end().0, Ended::Rested);
    let rate = |bytes: u64, since: u64| (bytes - since) as f64 / motion.lasts_s / 1000.0;
    let [there, back] = [rate(world.there.bytes, since[0]), rate(world.back.bytes, since[1])];
    let (mut worst, mut steps) = (0.0_f64, 0);
    for (oid, planned) in feed.planned.iter().enumerate() {
        let made = &world.fake.steppers[&(oid as u8)].made;
        let late =
            made.iter().zip(planned).map(|((clock, _), step)| (*clock as f64 - step.clock).abs());
        worst = late.fold(worst, f64::max);
        steps += made.len();
    }
    let (worst_us, commands) = (worst / TICKS_PER_US, world.fake.ran["queue_step"]);
    eprintln!("{steps} steps in {commands} commands; {there:.1} kB/s there, {back:.1} kB/s back");
    eprintln!(
        "worst step {worst_us:.2} µs from the plan; {} places of the board used",
        world.fake.most_places
    );
    assert!(there < 6.0 && back < 6.0 && worst_us < 5.1);
}

/// Seconds from a moment at 1 s of a motion to the last step behind it.
fn last_step_s(seed: u64, act: impl Fn(&mut World)) -> f64 {
    let (motion, mut world) = (waves(), World::ready(seed, Faults::default()));
    let mut feed = world.begin(&motion, &[]);
    let acts_s = world.now_s + 1.2 + seed as f64 * 0.017;
    while world.now_s < acts_s {
        world.feed(&motion, &mut feed);
        world.pass();
    }
    let asked = world.fake.now;
    act(&mut world);
    world.pass_for(1.0);
    let last =
        world.fake.steppers.values().filter_map(|s| s.made.last()).map(|(clock, _)| *clock).max();
    last.unwrap().saturating_sub(asked) as f64 / TICKS_PER_US / 1e6
}

#[test]
fn measured_times_to_the_last_step() {
    let longest =
        |act: fn(&mut World)| (0..20).map(|seed| last_step_s(seed, act)).fold(0.0, f64::max);
    let stop_s = longest(|world| world.host.stop().expect("a board"));
    let dead_s = longest(|world| world.stalls_until_s = f64::INFINITY);
    let silent_s = longest(|world| (world.there.faults.drop, world.back.faults.drop) = (1.0, 1.0));
    eprintln!(
        "to the last step: STOP {:.1} ms, host killed {:.0} ms, cable pulled {:.0} ms",
        stop_s * 1e3,
        dead_s * 1e3,
        silent_s * 1e3
    );
    assert!(stop_s < 0.004 && dead_s < 0.101 && silent_s < 0.101);
    assert!(dead_s > 0.05, "it went on for a while: {dead_s}");
}
