//! Two boards as one machine: together in time, stopped together.

use crate::world::{World, setup};
use kerf_driver_klipper::board::{Ended, Home, News, Options};
use kerf_driver_klipper::convoy::Convoy;
use kerf_driver_klipper::fake::Faults;
use kerf_driver_klipper::queue::{Piece, Step};

/// Two boards whose crystals are 120 ppm apart.
struct Pair {
    worlds: [World; 2],
    convoy: Convoy,
    handed_s: f64,
    made: i64,
    /// Moment at which the second board grows warm.
    warm_s: f64,
}

impl Pair {
    fn new(seed: u64, warm_s: f64) -> Self {
        let world = |n: u64, drift: f64| {
            let options = Options { deadline_s: 0.1, ..Options::default() };
            let mut world = World::new(seed + n, Faults::default(), setup(), options);
            world.fake.drift = drift;
            world
        };
        let mut pair = Self {
            worlds: [world(0, 70e-6), world(1, -50e-6)],
            convoy: Convoy::default(),
            handed_s: 0.0,
            made: 0,
            warm_s: f64::INFINITY,
        };
        pair.pass_for(warm_s);
        assert!(pair.worlds.iter().all(|w| w.news.iter().any(|n| matches!(n, News::Ready { .. }))));
        pair
    }

    fn pass_for(&mut self, time_s: f64) {
        let until_s = self.worlds[0].now_s + time_s;
        while self.worlds[0].now_s < until_s {
            self.pass();
        }
    }

    fn pass(&mut self) {
        self.worlds.iter_mut().for_each(World::pass);
        let now_s = self.worlds[0].now_s;
        if now_s > self.warm_s {
            self.warm_s = f64::INFINITY;
            self.worlds[1].fake.warm(now_s, -48.5e-6);
        }
        let [a, b] = &mut self.worlds;
        self.convoy.relay(&mut [&mut a.host, &mut b.host], now_s).expect("boards");
    }

    fn start(&mut self, homes: &[Vec<Home>]) {
        let now_s = self.worlds[0].now_s;
        let [a, b] = &mut self.worlds;
        a.news.clear();
        b.news.clear();
        self.convoy.start(&mut [&mut a.host, &mut b.host], homes, now_s).expect("boards at rest");
        (self.handed_s, self.made) = (0.0, 0);
    }

    /// Hands out the next piece of 50 ms: the first motor of both makes 2000 steps/s, and they are made at the same
    /// moments.
    fn hand_out(&mut self, many: u32) {
        let [from_s, to_s] = [self.handed_s, self.handed_s + 0.05];
        let [a, b] = &mut self.worlds;
        self.convoy.bend(&[&mut a.host, &mut b.host], from_s);
        for (n, world) in self.worlds.iter_mut().enumerate() {
            let clock = |t_s: f64| self.convoy.clock(n, t_s).expect("a line");
            let steps = (0..many).map(|k| from_s + (f64::from(k) + 0.5) * 0.05 / f64::from(many));
            let steps = steps.map(|t_s| Step { clock: clock(t_s), forward: true }).collect();
            let piece = Piece {
                steps: vec![steps, vec![], vec![]],
                ends: clock(to_s) as u64,
                ..Piece::default()
            };
            _ = world.host.offer(&piece);
        }
        self.handed_s = to_s;
        self.made += i64::from(many);
    }

    fn ended(&self, world: usize) -> Option<Ended> {
        self.worlds[world].news.iter().find_map(|news| match news {
            News::Ended { why, .. } => Some(*why),
            _ => None,
        })
    }

    /// Moments at which the first motor of a board made its steps, seconds.
    fn moments(&self, world: usize) -> Vec<f64> {
        let fake = &self.worlds[world].fake;
        fake.steppers[&0].made.iter().map(|(clock, _)| fake.time_at(*clock)).collect()
    }

    /// Feeds for a while.
    fn run(&mut self, time_s: f64) {
        let since_s = self.worlds[0].now_s;
        while self.worlds[0].now_s < since_s + time_s && self.ended(0).or(self.ended(1)).is_none() {
            while self.handed_s < self.worlds[0].now_s - since_s + 0.3 {
                self.hand_out(20);
            }
            self.pass();
        }
    }
}

#[test]
fn boards_with_crystals_of_their_own_step_together() {
    let mut pair = Pair::new(300, 15.0);
    pair.start(&[]);
    let times = std::env::var("TRIES").ok().and_then(|times| times.parse().ok());
    let lasts_s = 60.0 * times.unwrap_or(1.0);
    pair.warm_s = pair.worlds[0].now_s + 15.0;
    pair.run(lasts_s);
    pair.pass_for(1.0);
    assert_eq!([pair.ended(0), pair.ended(1)], [Some(Ended::Rested); 2]);
    let [a, b] = [pair.moments(0), pair.moments(1)];
    assert_eq!((a.len(), b.len()), (pair.made as usize, pair.made as usize));
    let apart = a.iter().zip(&b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    eprintln!("boards 120 ppm apart: steps at most {:.1} µs apart in {lasts_s} s", apart * 1e6);
    assert!(apart < 30e-6, "{} µs", apart * 1e6);
}

#[test]
fn a_switch_on_one_board_stops_the_other() {
    let mut pair = Pair::new(310, 4.0);
    pair.worlds[0].fake.stops_at = vec![(10, 0, 900)];
    let home = Home { switch: 0, motors: vec![0, 1, 2], opens: false, look_s: 0.0005 };
    pair.start(&[vec![home]]);
    pair.run(4.0);
    pair.pass_for(0.5);
    assert_eq!([pair.ended(0), pair.ended(1)], [Some(Ended::Touched), Some(Ended::Asked)]);
    let [a, b] = [pair.moments(0), pair.moments(1)];
    let late_s = b.last().unwrap() - a.last().unwrap();
    assert!((0.0..0.006).contains(&late_s), "{late_s} s");
}

#[test]
fn a_board_that_is_lost_stops_the_others() {
    let mut pair = Pair::new(320, 4.0);
    pair.start(&[]);
    pair.run(2.0);
    pair.worlds[0].back.faults.drop = 1.0;
    pair.worlds[0].there.faults.drop = 1.0;
    let lost_s = pair.worlds[0].now_s;
    pair.run(2.0);
    let last_s = [pair.moments(0), pair.moments(1)].map(|moments| moments.last().unwrap() - lost_s);
    assert!(last_s[0] < 0.101 && last_s[1] < 0.19, "{last_s:?}");
    assert_eq!(pair.ended(1), Some(Ended::Deadline));
}
