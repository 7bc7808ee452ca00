//! Two boards as one machine: together in time, stopped together.

use crate::world::motor;
use kerf_driver_klipper::board::{Ended, Fault, Home, News, Options, Watched};
use kerf_driver_klipper::crew::Crew;
use kerf_driver_klipper::fake::{Faults, Wired};
use kerf_driver_klipper::queue::{Piece, Refused, Step};
use kerf_driver_klipper::setup::{Pin, Setup, Switched};

/// Grain of virtual time, seconds, and length of a piece.
const GRAIN_S: f64 = 0.001;
const PIECE_S: f64 = 0.05;

/// A pin of one of the boards.
fn pin(board: usize, name: &str) -> Pin {
    Pin { board, ..Pin::new(name) }
}

/// Motors 0 and 2 on the first board, motor 1 on the second; a switch and an output on each.
fn setup() -> Setup {
    let on = |board: usize, n: usize| {
        let mut motor = motor(n);
        (motor.step.board, motor.dir.board) = (board, board);
        motor
    };
    let output = |board| Switched { pin: pin(board, "gpio20"), watch_s: Some(0.4) };
    Setup {
        motors: vec![on(0, 0), on(1, 0), on(0, 1)],
        switches: vec![pin(0, "gpio10"), pin(1, "gpio10")],
        outputs: vec![output(0), output(1)],
        ..Setup::default()
    }
}

/// Two boards whose crystals are some ppm apart.
struct Pair {
    wired: [Wired; 2],
    crew: Crew,
    now_s: f64,
    news: Vec<News>,
    /// Clock at the beginning of motion, ticks a second, and the time up to which motion was handed out, seconds.
    begins: f64,
    rate: f64,
    handed_s: f64,
    /// Share by which the second board's crystal changes in a second, and the moment of the next change.
    warms: f64,
    warm_s: f64,
    /// Moments at which the first motor of each board made its steps, seconds.
    moments: [Vec<f64>; 2],
}

impl Pair {
    fn new(seed: u64, faults: Faults) -> Self {
        let mut wired = [0, 1].map(|n| Wired::new(seed + n, Faults::default()));
        (wired[0].fake.drift, wired[1].fake.drift) = (50e-6, -50e-6);
        let names = ["main".to_owned(), "second".to_owned()];
        // What is apart is so by the clocks, not by what a command may be off.
        let options = Options { error_s: 0.2e-6, ..Options::default() };
        let crew = Crew::new(&setup(), &names, options, 0.0).expect("a setup");
        let (news, moments) = (Vec::new(), Default::default());
        let [now_s, begins, rate, handed_s, warms, warm_s] = [0.0; 6];
        let mut pair =
            Self { wired, crew, now_s, news, begins, rate, handed_s, warms, warm_s, moments };
        pair.pass_for(2.0);
        assert!(matches!(pair.news[..], [News::Ready { .. }]), "{:?}", pair.news);
        pair.news.clear();
        pair.wired.iter_mut().for_each(|wired| wired.spoil(faults));
        pair
    }

    fn pass(&mut self) {
        self.now_s += GRAIN_S;
        let (now_s, crew) = (self.now_s, &mut self.crew);
        for (n, wired) in self.wired.iter_mut().enumerate() {
            wired.pass(now_s, false, |heard| {
                crew.receive(n, heard, now_s);
                crew.transmit(n, now_s).bytes
            });
        }
        while let Some(news) = self.crew.news() {
            self.news.push(news);
        }
        for (wired, moments) in self.wired.iter_mut().zip(&mut self.moments) {
            let Some(stepper) = wired.fake.steppers.get_mut(&0) else { continue };
            let made = std::mem::take(&mut stepper.made);
            moments.extend(made.into_iter().map(|(clock, _)| wired.fake.time_at(clock)));
        }
        if self.now_s >= self.warm_s {
            let drift = self.wired[1].fake.drift + self.warms;
            self.wired[1].fake.warm(now_s, drift);
            self.warm_s = now_s + 1.0;
        }
    }

    fn pass_for(&mut self, time_s: f64) {
        let until_s = self.now_s + time_s;
        while self.now_s < until_s {
            self.pass();
        }
    }

    fn start(&mut self, homes: &[Home]) {
        let start = self.crew.start(homes, self.now_s).expect("boards at rest");
        (self.begins, self.rate, self.handed_s) = (start.clock as f64, start.ticks_per_s, 0.0);
    }

    /// The next piece: motors 0 and 1 make so many steps at the same moments.
    fn piece(&self, many: u32) -> Piece {
        let clock = |t_s: f64| self.begins + t_s * self.rate;
        let each = |k| self.handed_s + (f64::from(k) + 0.5) * PIECE_S / f64::from(many);
        let steps: Vec<Step> =
            (0..many).map(|k| Step { clock: clock(each(k)), forward: true, count: 1 }).collect();
        let ends = clock(self.handed_s + PIECE_S) as u64;
        Piece { steps: vec![steps.clone(), steps, vec![]], ends, rests: ends, ..Piece::default() }
    }

    /// Feeds for a while, so many steps a piece, or until motion ends.
    fn run(&mut self, time_s: f64, many: u32) {
        let since_s = self.now_s;
        while self.now_s < since_s + time_s && self.ended().is_none() {
            while self.begins + (self.handed_s - 0.3) * self.rate
                < self.crew.clock(self.now_s).map_or(0.0, |(clock, _)| clock as f64)
            {
                if self.crew.offer(&self.piece(many)).is_err() {
                    break;
                }
                self.handed_s += PIECE_S;
            }
            self.pass();
        }
    }

    fn ended(&self) -> Option<(Ended, Vec<i64>)> {
        self.news.iter().find_map(|news| match news {
            News::Ended { why, counts } => Some((*why, counts.clone())),
            _ => None,
        })
    }

    /// Farthest that the steps of both boards that are planned for one moment are apart, and their number; they are
    /// forgotten.
    fn apart(&mut self) -> (f64, usize) {
        let [a, b] = &mut self.moments;
        let many = a.len().min(b.len());
        let pairs = a.drain(..many).zip(b.drain(..many));
        (pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max), many)
    }
}

#[test]
fn boards_with_crystals_of_their_own_step_together() {
    let times = std::env::var("TRIES").ok().and_then(|times| times.parse().ok()).unwrap_or(1);
    for (what, warms) in [("steady", 0.0), ("1 ppm a minute", 1e-6 / 60.0)] {
        let mut pair = Pair::new(300, Faults::default());
        pair.pass_for(15.0);
        pair.start(&[]);
        pair.warms = warms;
        let (mut farthest, mut all) = (0.0_f64, 0);
        for _ in 0..times {
            pair.run(60.0, 20);
            let (apart, many) = pair.apart();
            (farthest, all) = (farthest.max(apart), all + many);
        }
        assert_eq!(pair.ended(), None);
        pair.pass_for(1.5);
        assert_eq!(pair.ended().expect("an end").0, Ended::Rested);
        eprintln!("{what}: {all} steps at most {:.1} µs apart, {times} min", farthest * 1e6);
        assert!(farthest < 10e-6, "{what}: {} µs", farthest * 1e6);
    }
}

#[test]
fn a_switch_on_one_board_stops_motors_of_the_other() {
    for share in [0.0, 0.01] {
        let mut pair = Pair::new(310, Faults::all(share / 6.0));
        pair.wired[0].fake.stops_at = vec![(10, 0, 900)];
        let home = Home { switch: 0, motors: vec![0, 1], opens: false, look_s: 0.0005 };
        pair.start(&[home]);
        pair.run(4.0, 20);
        let (why, counts) = pair.ended().expect("an end");
        assert_eq!(why, Ended::Touched);
        let touched = |news: &News| matches!(news, News::Touched { switch: 0, counts, .. } if counts[..2] == [900, 900]);
        assert!(pair.news.iter().any(touched), "{:?}", pair.news);
        let behind = if share > 0.0 { 40 } else { 5 };
        assert!((900..902).contains(&counts[0]) && counts[1] < 900 + behind, "{counts:?}");
    }
}

#[test]
fn each_motor_of_an_axis_stops_at_its_own_switch_on_whatever_boards() {
    let mut pair = Pair::new(340, Faults::default());
    // Either switch is on the other motor's board.
    pair.wired[0].fake.stops_at = vec![(10, 0, i64::MAX)];
    pair.wired[1].fake.stops_at = vec![(10, 0, 500)];
    let home = |switch, motor| Home { switch, motors: vec![motor], opens: false, look_s: 0.0005 };
    pair.start(&[home(0, 1), home(1, 0)]);
    pair.run(2.0, 20);
    assert_eq!(pair.ended(), None, "one switch is not found yet");
    let stood = pair.wired[0].fake.steppers[&0].position;
    assert!((500..510).contains(&stood), "{stood}");
    let now = pair.wired[0].fake.now;
    pair.wired[0].fake.stops_at.clear();
    pair.wired[0].fake.driven.insert(10, vec![(now, true)]);
    pair.run(2.0, 20);
    assert_eq!(pair.ended().expect("an end").0, Ended::Touched);
}

#[test]
fn a_switch_that_is_watched_stops_both_and_leaves_outputs_as_they_are() {
    let mut pair = Pair::new(350, Faults::default());
    pair.crew.set_output(0, 1.0, pair.now_s).expect("an output");
    pair.crew.set_output(1, 1.0, pair.now_s).expect("an output");
    pair.wired[1].fake.stops_at = vec![(10, 0, 300)];
    pair.crew
        .watch(&[Watched { switch: 1, opens: false, look_s: 1e-4, guards: false }], pair.now_s)
        .expect("a switch");
    pair.start(&[]);
    pair.run(3.0, 20);
    assert_eq!(pair.ended().expect("an end").0, Ended::Touched);
    let on = |wired: &Wired| wired.fake.outputs.values().all(|output| output.value == 1);
    assert!(pair.wired.iter().all(on));
    let touched = |news: &News| matches!(news, News::Touched { switch: 1, .. });
    assert!(pair.news.iter().any(touched));
}

#[test]
fn a_board_that_is_lost_stops_the_other_and_is_named() {
    for lost in [0, 1] {
        let mut pair = Pair::new(320, Faults::default());
        pair.start(&[]);
        pair.run(2.0, 20);
        pair.wired[lost].spoil(Faults { drop: 1.0, ..Faults::default() });
        let lost_s = pair.now_s;
        pair.run(4.0, 20);
        let last_s = [0, 1].map(|n| pair.moments[n].last().unwrap() - lost_s);
        assert!(last_s[lost] < 0.101 && last_s[1 - lost] < 0.19, "{last_s:?}");
        let name = ["main", "second"][lost];
        let named = |news: &News| matches!(news, News::Fault(Fault::OnBoard { board, fault }) if board == name && **fault == Fault::Silent);
        assert!(pair.news.iter().any(named), "{:?}", pair.news);
    }
}

#[test]
fn a_board_that_shuts_down_stops_the_other_and_both_go_on_once_that_is_cleared() {
    let mut pair = Pair::new(330, Faults::default());
    pair.crew.set_output(0, 1.0, pair.now_s).expect("an output");
    pair.start(&[]);
    pair.run(1.0, 20);
    pair.wired[1].fake.shut("ADC out of range");
    let shut_s = pair.now_s;
    pair.pass_for(0.5);
    let told = |news: &News| matches!(news, News::Shutdown(why) if why == "board second: ADC out of range");
    assert!(pair.news.iter().any(told), "{:?}", pair.news);
    assert!(pair.moments[0].last().unwrap() - shut_s < 0.005);
    assert!(pair.wired[0].fake.outputs.values().all(|output| output.value == 0));
    assert!(pair.crew.start(&[], pair.now_s).is_err());
    pair.crew.recover().expect("a shutdown");
    pair.pass_for(0.5);
    assert_eq!(pair.ended().expect("an end").0, Ended::Shutdown);
    pair.news.clear();
    pair.start(&[]);
    pair.run(1.0, 20);
    assert_eq!(pair.ended(), None);
}

#[test]
fn a_piece_that_one_board_cannot_make_is_made_by_none() {
    let mut pair = Pair::new(360, Faults::default());
    pair.start(&[]);
    let mut bad = pair.piece(20);
    let clock = bad.steps[1][0].clock;
    bad.steps[1] =
        vec![Step { clock, forward: true, count: 1 }, Step { clock, forward: true, count: 1 }];
    assert!(matches!(pair.crew.offer(&bad), Err(Refused::TooFast(_))));
    pair.run(0.5, 20);
    pair.pass_for(1.5);
    let (_, counts) = pair.ended().expect("an end");
    assert_eq!(counts[0], counts[1]);
    assert!(counts[0] > 100);
}

#[test]
fn pins_of_one_motor_are_on_one_board() {
    let mut setup = setup();
    setup.motors[0].dir.board = 1;
    let names = ["main".to_owned(), "second".to_owned()];
    let why = Crew::new(&setup, &names, Options::default(), 0.0).err().expect("a mistake");
    assert!(why.to_string().contains("are on two boards"), "{why}");
}
