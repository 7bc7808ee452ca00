//! Boards with step queues on the bench: who they are, and a proof that they make what is planned, with numbers.

use crate::args::Format;
use crate::commands::prove::{Figure, OnBench, Report};
use crate::controller;
use crate::exit::Exit;
use crate::machine_name::DriverName;
use crate::{given, out};
use anyhow::{Result, anyhow, bail};
use kerf_control::controller::Place;
use kerf_control::controller::queued::{AxisMove, Queued, Socket, introduced, others};
use kerf_driver_klipper::board::{Held, Introduced};
use kerf_driver_klipper::dictionary::Dictionary;
use kerf_driver_klipper::mailbox::Progress;
use kerf_machine::printer_cfg;
use kerf_machine::{Configuration, Machine};
use kerf_program::{Axes, Axis};
use std::fmt::Write;
use std::path::Path;

/// X goes there and back so far and so often, mm, at a speed in mm/s.
const WAY_MM: f64 = 20.0;
const TIMES: usize = 5;
const SPEED_MM_S: f64 = 30.0;
/// Stops on the way of X that are measured.
const STOPS: usize = 5;

pub fn socket(name: &DriverName) -> Result<Socket> {
    match controller::socket(name) {
        Place::Queued(socket) => Ok(socket),
        Place::Followed(_) => bail!("{name}: this is no board with step queues"),
    }
}

/// Prints who boards are: their firmware, chip, configuration, pins. Nothing of them changes. The other boards of the
/// machine follow, where somebody has named a machine that has some.
pub fn connect(names: &[DriverName], machine: &Configuration) -> Result<Exit> {
    let others = others(&machine.board.others).map_err(|why| anyhow!(why))?;
    let others = others.iter().map(|(_, address)| DriverName::of_board(address));
    let others: Vec<_> = others.filter(|other| !names.contains(other)).collect();
    for name in names.iter().chain(&others) {
        let introduced = introduced(&socket(name)?).map_err(|why| anyhow!("{name}: {why}"))?;
        out::print(&described(name, &introduced));
    }
    Ok(Exit::Good)
}

/// Prints the pins of a printer's configuration as lines of a machine's file.
pub fn import(file: &Path) -> Result<Exit> {
    let imported = printer_cfg::read(&given::text(file)?)
        .map_err(|why| anyhow!("{}: {why}", file.display()))?;
    imported.notes.iter().for_each(|note| eprintln!("kerf: {note}"));
    out::print(&imported.file);
    Ok(Exit::Good)
}

fn described(name: &DriverName, Introduced { dictionary, held }: &Introduced) -> String {
    let held = match held {
        Held::None => "none since it was powered".to_owned(),
        Held::Some(crc) => format!("{crc:08x}; another one needs a reset"),
        Held::ShutDown => "shut down: look why, then --unlock, or reset it".to_owned(),
    };
    let number = |key| dictionary.constant(key).unwrap_or_default();
    let edges = if number("STEPPER_STEP_BOTH_EDGE") == 1.0 { "yes" } else { "no" };
    let mut text = format!("{name}\n");
    let mut row = |what: &str, told: &str| {
        let _ = writeln!(text, "  {what:<16}{told}");
    };
    row("firmware", dictionary.version());
    let chip = dictionary.text("MCU").unwrap_or("unknown");
    row("chip", &format!("{chip}, {:.0} MHz", number("CLOCK_FREQ") / 1e6));
    row("configuration", &held);
    row("both edges", edges);
    row("pins", &ranges(&dictionary.words("pin")));
    for (use_of, pins) in reserved(dictionary) {
        row("taken by itself", &format!("{pins} ({use_of})"));
    }
    text
}

/// Pins that the board needs itself, with what for.
fn reserved(dictionary: &Dictionary) -> impl Iterator<Item = (&str, &str)> {
    let texts = dictionary.texts();
    texts.filter_map(|(key, pins)| Some((key.strip_prefix("RESERVE_PINS_")?, pins)))
}

/// Names that count up, as `gpio0…gpio29`.
fn ranges(names: &[&str]) -> String {
    let split = |name: &str| {
        let digits = name.chars().rev().take_while(char::is_ascii_digit).count();
        let (stem, number) = name.split_at(name.len() - digits);
        number.parse::<u32>().ok().map(|number| (stem.to_owned(), number))
    };
    let follows = |a: &str, b: &str| {
        split(a).zip(split(b)).is_some_and(|(a, b)| a.0 == b.0 && a.1 + 1 == b.1)
    };
    let rows = names.chunk_by(|a, b| follows(a, b)).map(|row| match row {
        [one] => (*one).to_owned(),
        [first, .., last] => format!("{first}…{last}"),
        [] => String::new(),
    });
    rows.collect::<Vec<_>>().join(" ")
}

/// Runs the list and the measurements, and writes the report.
pub fn prove(
    name: &DriverName,
    machine: &Configuration,
    report: &Path,
    format: Format,
) -> Result<Exit> {
    let socket = socket(name)?;
    let open = || -> Result<OnBench<Queued>> {
        let mut queued = socket.open(machine, false).map_err(|why| anyhow!(why))?;
        queued.is_at(Axes::default());
        Ok(OnBench::new(queued))
    };
    let mut bench = open()?;
    let mut told = Report::of(name, bench.board.facts(), format);
    let measured = measured(&mut bench.board, machine);
    drop(bench);
    told.takes_list(open, |bench| {
        bench.board.close(false, || false);
        bench.lacks
    });
    told.figures(measured);
    told.write(report)
}

/// Moves X and stops it; the figures of it.
fn measured(queued: &mut Queued, machine: &Configuration) -> Vec<Figure> {
    let ms = |time_s: f64| time_s * 1e3;
    let mut progress = queued.progress();
    let mut figures = vec![figure("steps of X", steps_made(queued, machine, &mut progress))];
    let [stall_s, lead_s] = progress.lead_s;
    let lead = format!("{:.0} ms, longest stall {:.1} ms", ms(lead_s), ms(stall_s));
    figures.push(figure("lead", Ok(lead)));
    let latest = progress
        .latest_s
        .ok_or("no step was sent")
        .map(|latest_s| format!("sent {:.0} ms before it was due", ms(latest_s)));
    figures.push(figure("latest step", latest.map_err(str::to_owned)));
    let trip = progress.trip_s.ok_or("the board told no time");
    let trip = trip.map(|[trip_s, off_s]| format!("{:.2} ms ± {:.2} ms", ms(trip_s), ms(off_s)));
    figures.push(figure("round trip", trip.map_err(str::to_owned)));
    figures.push(figure("stop without a ramp", stops(queued, machine)));
    figures
}

fn figure(name: &'static str, saw: Result<String, String>) -> Figure {
    let ok = saw.is_ok();
    Figure { name, ok, saw: saw.unwrap_or_else(|why| format!("WRONG: {why}")) }
}

/// Moves X there and back. After each way the counts of all motors have to be those that were planned: a step that is lost on
/// the way there and another on the way back would not show at the end. The progress is that behind the last good way.
fn steps_made(
    queued: &mut Queued,
    machine: &Configuration,
    progress: &mut Progress,
) -> Result<String, String> {
    let mut steps = 0;
    for n in 1..=TIMES {
        for to_mm in [WAY_MM, 0.0] {
            let [before, _] = queued.counts();
            let on_way = |why| format!("on way {n} of {TIMES} to {to_mm} mm: {why}");
            way(to_mm).moves(queued, machine, || false).map_err(on_way)?;
            let [made, planned] = queued.counts();
            if made != planned {
                let why = format!("the motors came to {made:?}, planned was {planned:?}");
                return Err(on_way(why));
            }
            *progress = queued.progress();
            let moved = made.iter().zip(&before).map(|(made, before)| made.abs_diff(*before));
            steps += moved.max().unwrap_or_default();
        }
    }
    Ok(format!("{steps} planned and made, looked at after each of {} ways", 2 * TIMES))
}

/// Stops X on its way several times; the longest time until the board told where.
fn stops(queued: &mut Queued, machine: &Configuration) -> Result<String, String> {
    let mut longest_s = 0.0_f64;
    for _ in 0..STOPS {
        longest_s = longest_s.max(stop_s(queued, machine)?);
        way(0.0).moves(queued, machine, || false)?;
    }
    let longest_ms = longest_s * 1e3;
    Ok(format!("{longest_ms:.1} ms until the board told its counts, longest of {STOPS}"))
}

/// The way of X to a place.
const fn way(to_mm: f64) -> AxisMove {
    AxisMove { axis: Axis::X, to_mm, mm_s: SPEED_MM_S }
}

/// Stops X on its way at once; returns the time until the board told where, seconds.
fn stop_s(queued: &mut Queued, machine: &Configuration) -> Result<f64, String> {
    way(WAY_MM).goes(queued, machine, |since_s| since_s > 0.6)?;
    let begin_s = queued.progress().at_s;
    queued.halt();
    let stood_s = queued.progress().at_s - begin_s;
    if let Some(fault) = queued.fault() {
        return Err(fault.message.clone());
    }
    let place = queued.counted();
    queued.is_at(place);
    Ok(stood_s)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_that_count_up_are_a_range() {
        assert_eq!(
            ranges(&["gpio0", "gpio1", "gpio2", "PA0", "PA2", "nc"]),
            "gpio0…gpio2 PA0 PA2 nc"
        );
    }
}
