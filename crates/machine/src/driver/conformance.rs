//! List of checks that every driver has to pass.
//!
//! ```ignore
//! for case in kerf_machine::driver::conformance::CASES {
//!     (case.check)(&mut MyDriver::at_rest()).expect(case.name);
//! }
//! ```
//!
//! Each check begins with a machine at rest at zero of every axis, all outputs off, that can go
//! 50 mm in every direction at 20 mm/s.

use super::{ControllerState, Driver, Order, Reply, Sent, Signal, Ticket};
use kerf_program::{Axes, Axis};

/// One thing that has to hold.
pub struct Case {
    /// The requirement in words.
    pub name: &'static str,
    /// The check; the error tells what was seen instead.
    pub check: fn(&mut dyn Driver) -> Result<(), String>,
}

/// Everything that has to hold.
pub const CASES: &[Case] = &[
    Case { name: "moves end where they are told to", check: moves_end },
    Case { name: "orders are done one after the other", check: in_order },
    Case { name: "a ticket that comes twice is carried out once", check: once },
    Case { name: "a ticket that does not follow is left alone", check: gap },
    Case { name: "a hold slows down on the path, and the move goes on", check: hold },
    Case { name: "a stop forgets what is not done and switches outputs off", check: stop },
    Case { name: "an order that no machine can do is refused", check: unsound },
    Case { name: "nobody is told of an input twice", check: inputs },
];

/// Time between two looks at a driver, seconds.
const TICK_S: f64 = 0.01;

/// Time after which something is taken never to come, seconds.
const LONG_S: f64 = 20.0;

/// A driver with a clock.
struct Bench<'a> {
    driver: &'a mut dyn Driver,
    now_s: f64,
    heard: Vec<Reply>,
}

fn to(x: f64) -> Order {
    Order::Move { to: Axes::xyz(x, 0.0, 0.0), speed_mm_s: 20.0 }
}

impl<'a> Bench<'a> {
    fn new(driver: &'a mut dyn Driver) -> Self {
        Self { driver, now_s: 0.0, heard: Vec::new() }
    }

    fn send(&mut self, ticket: Ticket, order: Order) {
        self.driver.send(&Sent { ticket, order }, self.now_s);
    }

    fn run(&mut self, seconds: f64) {
        let until_s = self.now_s + seconds;
        while self.now_s < until_s {
            self.now_s += TICK_S;
            // A driver that is never asked may stop by itself.
            self.driver.signal(Signal::Ask, self.now_s);
            let replies = self.driver.replies(self.now_s);
            self.heard.extend(replies.into_iter().flatten());
        }
    }

    fn until_done(&mut self, ticket: Ticket) -> Result<(), String> {
        let until_s = self.now_s + LONG_S;
        while !self.heard.contains(&Reply::Done(ticket)) {
            if self.now_s > until_s {
                return Err(format!("order {ticket} is not done after {LONG_S} s"));
            }
            self.run(TICK_S);
        }
        Ok(())
    }

    fn standing(&mut self) -> Result<ControllerState, String> {
        self.heard.retain(|reply| !matches!(reply, Reply::State(_)));
        self.run(0.2);
        let last = self.heard.iter().rev().find_map(|reply| match reply {
            Reply::State(standing) => Some(*standing),
            _ => None,
        });
        last.ok_or_else(|| "it does not tell where it is".into())
    }

    fn x(&mut self) -> Result<f64, String> {
        Ok(self.standing()?.position[Axis::X])
    }
}

fn near(what: &str, got: f64, wanted: f64) -> Result<(), String> {
    hold_that((got - wanted).abs() < 0.01, || format!("{what} is {got}, not {wanted}"))
}

fn hold_that(holds: bool, otherwise: impl FnOnce() -> String) -> Result<(), String> {
    if holds { Ok(()) } else { Err(otherwise()) }
}

fn moves_end(driver: &mut dyn Driver) -> Result<(), String> {
    let mut bench = Bench::new(driver);
    bench.send(1, to(10.0));
    bench.run(0.2);
    let on_the_way = bench.x()?;
    hold_that((0.0..=10.0).contains(&on_the_way), || format!("it passed x {on_the_way}"))?;
    bench.until_done(1)?;
    near("x", bench.x()?, 10.0)
}

fn in_order(driver: &mut dyn Driver) -> Result<(), String> {
    let mut bench = Bench::new(driver);
    bench.send(1, to(2.0));
    bench.send(2, Order::Output { line: 3, on: true });
    bench.send(3, to(0.0));
    bench.run(TICK_S);
    hold_that(bench.standing()?.outputs == 0 || bench.heard.contains(&Reply::Done(1)), || {
        "an output was switched before the move ahead of it was done".into()
    })?;
    bench.until_done(3)?;
    let done: Vec<Ticket> = bench
        .heard
        .iter()
        .filter_map(|reply| if let Reply::Done(ticket) = reply { Some(*ticket) } else { None })
        .collect();
    hold_that(done == [1, 2, 3], || format!("orders were done as {done:?}"))?;
    let outputs = bench.standing()?.outputs;
    hold_that(outputs == 0b100, || format!("outputs are {outputs:b}"))
}

fn once(driver: &mut dyn Driver) -> Result<(), String> {
    let mut bench = Bench::new(driver);
    bench.send(1, to(3.0));
    bench.send(1, to(3.0));
    bench.send(2, to(0.0));
    bench.until_done(2)?;
    bench.heard.clear();
    bench.send(1, to(3.0));
    bench.run(1.0);
    near("x", bench.x()?, 0.0)?;
    hold_that(bench.heard.contains(&Reply::Done(1)), || "it is not answered again".into())
}

fn gap(driver: &mut dyn Driver) -> Result<(), String> {
    let mut bench = Bench::new(driver);
    bench.send(2, to(5.0));
    bench.run(1.0);
    near("x", bench.x()?, 0.0)?;
    bench.send(1, to(1.0));
    bench.send(2, to(5.0));
    bench.until_done(2)?;
    near("x", bench.x()?, 5.0)
}

fn hold(driver: &mut dyn Driver) -> Result<(), String> {
    let mut bench = Bench::new(driver);
    bench.send(1, to(40.0));
    bench.run(0.5);
    bench.driver.signal(Signal::Hold, bench.now_s);
    bench.run(1.0);
    let held = bench.x()?;
    hold_that(held > 0.0 && held < 40.0, || format!("it was held at x {held}"))?;
    near("x while held", bench.x()?, held)?;
    bench.driver.signal(Signal::Resume, bench.now_s);
    bench.until_done(1)?;
    near("x", bench.x()?, 40.0)
}

fn stop(driver: &mut dyn Driver) -> Result<(), String> {
    let mut bench = Bench::new(driver);
    bench.send(1, Order::Output { line: 2, on: true });
    bench.send(2, to(40.0));
    bench.send(3, to(0.0));
    bench.run(0.5);
    bench.driver.signal(Signal::Stop, bench.now_s);
    bench.run(1.0);
    let standing = bench.standing()?;
    hold_that(!standing.moving && standing.outputs == 0, || format!("after a stop: {standing:?}"))?;
    near("x", bench.x()?, standing.position[Axis::X])?;
    hold_that(standing.position[Axis::X] < 40.0, || "the move was made to its end".into())
}

fn unsound(driver: &mut dyn Driver) -> Result<(), String> {
    let mut bench = Bench::new(driver);
    bench.send(1, to(f64::NAN));
    bench.run(0.5);
    let refused = bench.heard.iter().any(|reply| matches!(reply, Reply::Refused(1, _)));
    hold_that(refused, || "a move to nowhere was not refused".into())?;
    near("x", bench.x()?, 0.0)
}

fn inputs(driver: &mut dyn Driver) -> Result<(), String> {
    let mut bench = Bench::new(driver);
    bench.run(1.0);
    let mut last = [None; 256];
    for reply in &bench.heard {
        if let Reply::Input { line, on } = reply {
            let before = last[usize::from(*line)].replace(*on);
            hold_that(before != Some(*on), || format!("input {line} was told to be {on} twice"))?;
        }
    }
    Ok(())
}
