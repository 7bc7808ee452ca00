//! The host of a board with step queues at 300,000 steps a second of three axes together: `steps-3x300k`.
//!
//! The board is a fake, in simulated time; only what the host does is measured: finding the steps of a plan, making
//! commands of them, and the frames both ways.

use anyhow::{Context, Result, ensure};
use kerf_driver_klipper::board::{Board, Ended, News, Options, Start};
use kerf_driver_klipper::fake::{Faults, Wired};
use kerf_driver_klipper::queue::{Piece, Step};
use kerf_driver_klipper::setup::{Motor, Pin, Setup};
use kerf_motion::{Leg, Mark, Model, Mover, Optimal, Stepper};
use kerf_program::{At, Axes, Dynamics, Feed, Line, MoveKind, Settings};
use std::fmt::Write as _;
use std::time::{Duration, Instant};

/// Steps a second of each of three axes.
const STEPS_S: f64 = 300_000.0;
/// Steps a millimetre.
const PER_MM: f64 = 1_000.0;
/// Length of the way of each axis, mm.
const WAY_MM: f64 = 900.0;
/// Length of a piece of motion, and the time by which it is handed over before it begins, seconds.
const PIECE_S: f64 = 0.02;
const AHEAD_S: f64 = 0.2;
/// Time between two looks of the host, seconds.
const GRAIN_S: f64 = 0.001;
/// Commands a second that the RP2040 takes over USB, as published.
const PUBLISHED: f64 = 885_000.0;
/// Share of one core that the host may take.
const GOAL: f64 = 0.1;

/// Time that the host took for a motion.
#[derive(Default)]
struct Took {
    steps: Duration,
    board: Duration,
}

/// Measures the processor time of the host; returns it as a table.
pub fn table() -> Result<String> {
    eprintln!("steps-3x300k …");
    let runs: Vec<(Took, f64, u64, u64)> = (0..3).map(|_| run()).collect::<Result<_>>()?;
    let best = |of: fn(&Took) -> Duration| {
        runs.iter().map(|(took, ..)| of(took)).min().unwrap_or_default().as_secs_f64()
    };
    let (_, lasts_s, commands, bytes) = runs.first().context("a run")?;
    let share = |time_s: f64| 100.0 * time_s / lasts_s;
    let [steps, board] = [share(best(|it| it.steps)), share(best(|it| it.board))];
    let a_second = *commands as f64 / lasts_s;
    ensure!(a_second < PUBLISHED, "{a_second} commands a second");
    let mut table = format!(
        "\nBoards with step queues, `steps-3x300k`: three axes at {STEPS_S} steps/s together, {lasts_s:.1} s of motion on the fake \
         board; the least of three runs, as a share of one core.\n\n\
         | what | share of a core |\n| --- | --- |\n"
    );
    let whole = steps + board;
    let met = if whole <= 100.0 * GOAL { "met" } else { "missed" };
    _ = writeln!(table, "| finding the steps of the plan | {steps:.1} % |");
    _ = writeln!(table, "| commands and frames | {board:.1} % |");
    _ = writeln!(table, "| together, goal ≤ {:.0} %: {met} | {whole:.1} % |", 100.0 * GOAL);
    _ = writeln!(
        table,
        "\n{a_second:.0} commands/s (an RP2040 takes {PUBLISHED} over USB, as published), {:.1} kB/s.",
        *bytes as f64 / lasts_s / 1e3
    );
    Ok(table)
}

fn leg() -> Result<Leg> {
    let dynamics = Dynamics {
        speed_mm_s: Axes::splat(STEPS_S / PER_MM),
        accel_mm_s2: Axes::splat(3_000.0),
        jerk_mm_s3: Some(Axes::splat(60_000.0)),
        tolerance_mm: 0.01,
    };
    let to = Axes::xyz(WAY_MM, WAY_MM, WAY_MM);
    let feed = Feed::Path(3.0_f64.sqrt() * STEPS_S / PER_MM);
    let mut mover = Mover::new(Axes::default(), &Settings::default());
    let line = Line { kind: MoveKind::Cut, to, feed };
    let made = mover.line(At::default(), &line).context("a move")?;
    Ok(Leg::new(Optimal { dynamics: &dynamics }.plan(vec![made])))
}

fn motor(n: usize) -> Motor {
    Motor {
        step: Pin::new(&format!("gpio{}", 2 * n)),
        dir: Pin::new(&format!("gpio{}", 2 * n + 1)),
        pulse_s: 1e-7,
        turn_s: 1e-6,
        both_edges: true,
        least_s: 1.2e-6,
    }
}

/// A host and its board.
struct World {
    wired: Wired,
    host: Board,
    now_s: f64,
    took: Duration,
}

impl World {
    fn pass(&mut self) {
        self.now_s += GRAIN_S;
        let (now_s, host, took) = (self.now_s, &mut self.host, &mut self.took);
        self.wired.pass(now_s, false, |heard| {
            let since = Instant::now();
            host.receive(heard, now_s);
            let out = host.transmit(now_s).bytes;
            *took += since.elapsed();
            out
        });
    }

    fn wait(&mut self) -> Result<News> {
        for _ in 0..60_000 {
            if let Some(news) = self.host.news() {
                return Ok(news);
            }
            self.pass();
        }
        anyhow::bail!("the board tells nothing")
    }
}

/// Makes the motion once: the time that it took the host, its length in seconds, its commands and its bytes.
fn run() -> Result<(Took, f64, u64, u64)> {
    let leg = leg()?;
    let setup = Setup { motors: (0..3).map(motor).collect(), ..Setup::default() };
    let options = Options { error_s: 2e-6, ..Options::default() };
    let (wired, host) = (Wired::new(1, Faults::default()), Board::new(setup, options, 0.0));
    let mut world = World { wired, host, now_s: 0.0, took: Duration::ZERO };
    let ready = world.wait()?;
    ensure!(matches!(ready, News::Ready { .. }), "{ready:?}");
    let start = world.host.start(&[], world.now_s)?;
    (world.took, world.wired.there.bytes) = (Duration::ZERO, 0);
    let steps = feed(&mut world, &leg, &start)?;
    let ended = world.wait()?;
    ensure!(matches!(ended, News::Ended { why: Ended::Rested, .. }), "{ended:?}");
    let commands = world.wired.fake.ran.get("queue_step").copied().unwrap_or_default();
    let took = Took { steps, board: world.took };
    Ok((took, leg.span_s()[1], commands, world.wired.there.bytes))
}

fn of_motors(
    made: impl Iterator<Item = Mark> + Clone,
    clock: impl Fn(f64) -> f64 + Copy,
    [from, to]: [f64; 2],
) -> Vec<Vec<Step>> {
    let own = |axis: usize| {
        let own = made.clone().filter(move |step| step.axis == axis);
        own.map(|Mark { t_s, forward, count, .. }| Step {
            clock: clock(t_s).clamp(from, to),
            forward,
            count,
        })
        .collect()
    };
    (0..3).map(own).collect()
}

/// Hands the motion over piece by piece; returns the time that finding its steps took.
fn feed(world: &mut World, leg: &Leg, start: &Start) -> Result<Duration> {
    let mut stepper = Stepper::new(Axes::splat(PER_MM), Axes::default());
    let (mut from_s, [_, end_s], mut took) = (0.0, leg.span_s(), Duration::ZERO);
    let clock = |t_s: f64| start.clock as f64 + t_s * start.ticks_per_s;
    while from_s < end_s {
        let (now, _) = world.host.clock(world.now_s).context("a clock")?;
        if clock(from_s - AHEAD_S) > now as f64 {
            world.pass();
            continue;
        }
        let to_s = (from_s + PIECE_S).min(end_s);
        let since = Instant::now();
        let made = leg.steps(&mut stepper, [from_s, to_s]);
        // The way to rest is found for each piece as well.
        let rests = leg.rest(to_s).filter(|_| to_s < end_s);
        let tail = rests.map(|rest| stepper.clone().sketch(to_s, rest.end_s, |t_s| rest.at(t_s)));
        let ends = clock(to_s).ceil();
        let rests = tail.iter().flatten().map(|step| clock(step.t_s)).fold(ends, f64::max).ceil();
        let steps =
            of_motors(made.iter().copied().map(Mark::from), clock, [clock(from_s).ceil(), ends]);
        let tail =
            tail.map(|tail| of_motors(tail.into_iter(), clock, [ends, rests])).unwrap_or_default();
        took += since.elapsed();
        let since = Instant::now();
        let (ends, rests) = (ends as u64, rests as u64);
        world.host.offer(&Piece { steps, ends, tail, rests, ..Piece::default() })?;
        world.took += since.elapsed();
        from_s = to_s;
    }
    Ok(took)
}
