//! Cases of controllers that plan for themselves, beside those that every machine has to hold.

use super::bench::{OnBench, Way, socket};
use super::outcome::Outcome;
use crate::commands::board::Board;
use crate::machine_name::DriverName;
use anyhow::{Result, anyhow, bail};
use kerf_control::controller::{change_zero, zeros_of};
use kerf_machine::Machine;
use kerf_machine::conformance::{self, CASES};
use kerf_machine::driver::{Override, Zero, ZeroChange};
use kerf_program::{Axes, MoveKind};
use std::time::Duration;

/// A place is where it should be within this, mm.
const NEAR_MM: f64 = 0.02;

/// Turned down by half, and rapid moves to a quarter, a way takes at least so much longer: ramps are no shorter.
const LONGER: f64 = 1.4;

/// A way is not made in less than this share of the time that its speed alone takes.
const NEARLY: f64 = 0.9;

/// A way is made so often at most before a computer is too busy to be trusted.
const TRIES: usize = 5;

/// The system of zero points that is changed for a moment, and the way by which.
const KEPT: (&str, f64) = ("G59.3", 5.0);

/// A controller answers within this.
const ANSWERS: Duration = Duration::from_secs(8);

/// One thing that has to hold.
pub struct Case {
    pub name: &'static str,
    pub check: fn(&DriverName) -> Result<Outcome>,
}

pub const OWN: &[Case] = &[
    Case { name: "a hold stands on the path, and the move goes on", check: hold },
    Case { name: "cuts follow the feed override", check: feed },
    Case { name: "rapid moves follow their override", check: rapid },
    Case { name: "a cable that is pulled and plugged in ends nothing silently", check: plugged },
    Case { name: "zero points are read and written, and move nothing", check: zeros },
];

/// Cases of settings of grbl.
pub const SETTINGS: &[Case] = &[
    Case { name: "$10=0: it is driven all the same", check: |name| set_to(name, 10, "0") },
    Case { name: "$10=2: it is driven all the same", check: |name| set_to(name, 10, "2") },
    Case { name: "$13=1: it is driven all the same", check: |name| set_to(name, 13, "1") },
];

const CUT: Way = Way { from_mm: 0.0, to_mm: 20.0, kind: MoveKind::Cut, speed_mm_s: 10.0 };

fn arrives(bench: &mut OnBench, x_mm: f64) -> Result<Outcome> {
    bench.looks(0.5);
    let stands_mm = bench.x_mm();
    if (stands_mm - x_mm).abs() < NEAR_MM {
        Ok(Outcome::Held(String::new()))
    } else {
        Ok(Outcome::Wrong(format!("it stands at x {stands_mm} and not at {x_mm}")))
    }
}

fn hold(name: &DriverName) -> Result<Outcome> {
    let mut bench = OnBench::open(name)?;
    let mut places = None;
    bench.goes(CUT, |connection, going| {
        let held = connection.hold(going);
        let x_mm = |connection: &mut kerf_control::controller::Connection| {
            Machine::place(connection).map(|place| place.0[0])
        };
        let before = x_mm(connection);
        for _ in 0..50 {
            connection.look();
            std::thread::sleep(Duration::from_millis(10));
        }
        places = Some((held.is_some(), before, x_mm(connection)));
        connection.go_on();
    })?;
    match places {
        Some((true, Some(a), Some(b))) if (a - b).abs() < NEAR_MM && b < 20.0 - NEAR_MM => {
            arrives(&mut bench, 20.0)
        }
        told => Ok(Outcome::Wrong(format!("held, and places before and after: {told:?}"))),
    }
}

/// Turned down to a share, a way takes longer; the share is as before afterwards. A busy computer sees late that a way is made,
/// which makes the quick way as long as the slow one: it is tried again then.
fn turned(
    name: &DriverName,
    (there, least_s): (Way, f64),
    turns: fn(&mut kerf_control::controller::Connection, bool),
) -> Result<Outcome> {
    let mut bench = OnBench::open(name)?;
    let back = Way { from_mm: there.to_mm, to_mm: 0.0, ..there };
    for _ in 0..TRIES {
        let plain_s = bench.goes(there, |_, _| {})?;
        turns(&mut bench.board, true);
        let slow_s = bench.goes(back, |_, _| {});
        turns(&mut bench.board, false);
        let slow_s = slow_s?;
        if slow_s < NEARLY * least_s {
            return Ok(Outcome::Wrong(format!("{plain_s:.2} s have become {slow_s:.2} s")));
        }
        let stands = arrives(&mut bench, 0.0)?;
        if slow_s >= LONGER * plain_s || !matches!(stands, Outcome::Held(_)) {
            return Ok(stands);
        }
    }
    Ok(Outcome::NotTried("this computer is too busy to tell a quick way from a slow one".into()))
}

fn feed(name: &DriverName) -> Result<Outcome> {
    let least_s = CUT.to_mm / (CUT.speed_mm_s * 0.5);
    turned(name, (CUT, least_s), |connection, down| connection.feed(if down { 0.5 } else { 1.0 }))
}

fn rapid(name: &DriverName) -> Result<Outcome> {
    let quickest_mm_s = OnBench::open(name)?.board.facts().speed_mm_s[0].unwrap_or(1000.0);
    let (kind, speed_mm_s) = (MoveKind::Jog, 2.0 * quickest_mm_s);
    let there = Way { to_mm: 40.0, kind, speed_mm_s, ..CUT };
    turned(name, (there, there.to_mm / (quickest_mm_s * 0.25)), |connection, down| {
        connection.turn(Override::Rapid(if down { 25 } else { 100 }));
    })
}

fn plugged(name: &DriverName) -> Result<Outcome> {
    let mut bench = OnBench::open(name)?;
    bench.board.opens_again(socket(name)?.opens);
    match bench.goes(CUT, |connection, _| connection.is_unplugged()) {
        Ok(_) => arrives(&mut bench, 20.0),
        Err(told) => Ok(Outcome::Held(format!("it ends, and says so: {told}"))),
    }
}

fn zeros(name: &DriverName) -> Result<Outcome> {
    let mut bench = OnBench::open(name)?;
    let (system, by_mm) = KEPT;
    let of = |zeros: Vec<Zero>| zeros.into_iter().find(|zero| zero.name == system).map(|it| it.at);
    let Some(before) = of(zeros_of(&mut bench.board)) else {
        return Ok(Outcome::NotTried(format!("it tells no {system} ($#)")));
    };
    let moved = before.plus(Axes::xyz(by_mm, by_mm, 0.0));
    let x_mm = bench.x_mm();
    for at in [moved, before] {
        let lies = ZeroChange::Lies(at.0.map(Some));
        change_zero(&mut bench.board, system, lies, || false).map_err(|why| anyhow!(why))?;
        let told = of(zeros_of(&mut bench.board));
        let holds = told.is_some_and(|told| (told.0[0] - at.0[0]).abs() < NEAR_MM);
        if !holds {
            return Ok(Outcome::Wrong(format!("{system} is told to be {told:?}, not {at:?}")));
        }
    }
    arrives(&mut bench, x_mm)
}

/// The first case of every machine, with the board set in another way; it is set as before afterwards.
fn set_to(name: &DriverName, number: u16, value: &str) -> Result<Outcome> {
    let mut board = Board::open(&name.address, ANSWERS)?;
    let before = board.settings().get(&number).cloned();
    let Some(before) = before else {
        board.leave()?;
        return Ok(Outcome::NotTried(format!("it has no ${number}")));
    };
    board.set(number, value)?;
    board.leave()?;
    let outcome = first_case(name);
    let mut board = Board::open(&name.address, ANSWERS)?;
    board.set(number, &before)?;
    board.leave()?;
    outcome
}

fn first_case(name: &DriverName) -> Result<Outcome> {
    let [first, ..] = CASES else { bail!("there are no cases") };
    let mut bench = OnBench::open(name)?;
    Ok(match first.run(&mut bench) {
        Ok(conformance::Outcome::Held) => Outcome::Held(String::new()),
        Ok(conformance::Outcome::Failed(fault)) => Outcome::NotHeld(fault.message),
        Err(why) => Outcome::Wrong(why),
    })
}

/// Goes home, where it is asked for: its axes move to their switches.
pub fn homes(name: &DriverName, wanted: bool) -> Result<Outcome> {
    let mut bench = OnBench::as_it_stands(name)?;
    if !bench.board.facts().homes {
        return Ok(Outcome::NotTried("it has no homing ($22)".into()));
    }
    if !wanted {
        return Ok(Outcome::NotTried("it moves its axes to their switches: --home".into()));
    }
    bench.homes()?;
    Ok(Outcome::Held(String::new()))
}
