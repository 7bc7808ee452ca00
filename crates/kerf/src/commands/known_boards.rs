//! `kerf machine boards`: boards with step queues whose pins are known.

use crate::exit::Usage;
use crate::out;
use anyhow::Result;
use kerf_machine::boards::{self, KnownBoard, Plug, Wire};
use std::fmt::Write;

/// Prints all boards, a line each, or the pins of one.
pub fn print(name: Option<&str>) -> Result<()> {
    match name {
        Some(name) => out::print(&pins(&named(name)?)),
        None => boards::all()?.iter().for_each(|board| out::print(&line(board))),
    }
    Ok(())
}

/// Returns the board of a name.
pub fn named(name: &str) -> Result<KnownBoard> {
    boards::named(name).map_err(|why| Usage(why.to_string()).into())
}

fn line(board: &KnownBoard) -> String {
    let (chips, motors) = (board.chips.join(", "), board.motors.len());
    format!("{:<16} {:<38} {motors:>2} motors, {chips}\n", board.name, board.title)
}

/// Returns the plugs of a board with their pins, as a table.
fn pins(board: &KnownBoard) -> String {
    let mut text = line(board);
    for motor in &board.motors {
        let wire = match &motor.wire {
            Wire::Own(pin) => format!("driver {pin}"),
            Wire::Shared(address) => format!("driver address {address}"),
            Wire::None => "driver set by jumpers".to_owned(),
        };
        let soldered = motor.driver.as_deref().map(|it| format!(", {it}")).unwrap_or_default();
        let _ = writeln!(
            text,
            "  motor {:<6}step {}, direction {}, enable !{}, {wire}{soldered}",
            motor.name, motor.step, motor.dir, motor.enable
        );
    }
    let mut row = |what: &str, told: String| {
        if !told.is_empty() {
            let _ = writeln!(text, "  {what:<12}{told}");
        }
    };
    row("drivers on", board.uart.iter().map(|uart| uart.join(" ")).collect());
    row("SPI", board.spi.iter().map(|spi| spi.join(" ")).collect());
    row("switches", plugs(&board.ends));
    row("outputs", plugs(&board.outputs));
    row("servo", board.servo.clone().unwrap_or_default());
    row("probe", board.probe.clone().unwrap_or_default());
    text
}

fn plugs(plugs: &[Plug]) -> String {
    let words: Vec<_> = plugs.iter().map(|plug| format!("{} {}", plug.name, plug.pin)).collect();
    words.join(", ")
}
