//! Switches of a board that is being wired, as they are now.

use crate::controller::queued::machine::Queued;
use crate::controller::queued::wiring::Wiring;
use kerf_driver_klipper::setup::{Pin, Pull};
use kerf_program::AxisSet;

/// A switch of the board, as it is now.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Seen {
    /// The axis whose home switch it is, or the number of an input.
    pub about: String,
    /// Its pin, as the machine's file has it.
    pub pin: String,
    /// It is pressed, as the machine understands its level.
    pub on: bool,
}

/// Looks at all home switches and inputs of a board; nothing where it does not tell them.
pub(super) fn seen(board: &mut Queued) -> Option<Vec<Seen>> {
    let rows = rows(&board.wiring);
    let switches: Vec<usize> = rows.iter().map(|(_, switch, _)| *switch).collect();
    let told = board.are_on(&switches)?;
    let seen = |((about, switch, turned), on): ((String, usize, bool), bool)| {
        let pin = &board.wiring.setup.switches[switch];
        let pin = Pin { inverted: pin.inverted != turned, ..pin.clone() };
        Seen { about, pin: written(&pin, &board.wiring.pins.boards), on: on != turned }
    };
    Some(rows.into_iter().zip(told).map(seen).collect())
}

/// Home switches by their axes, then inputs by their numbers: the switch of the board, and whether its level is turned round
/// once more.
fn rows(wiring: &Wiring) -> Vec<(String, usize, bool)> {
    let (mut rows, mut axes) = (Vec::new(), AxisSet::EMPTY);
    for motor in &wiring.motors {
        let Some(switch) = motor.home else { continue };
        let second = if axes.contains(motor.axis) { "2" } else { "" };
        axes.insert(motor.axis);
        if rows.iter().all(|(_, other, _)| *other != switch) {
            rows.push((format!("{}{second}", motor.axis.letter()), switch, false));
        }
    }
    rows.extend(wiring.inputs.iter().map(|it| (it.number.to_string(), it.switch, it.turned)));
    rows
}

/// A pin as a machine's file has it.
fn written(pin: &Pin, boards: &[String]) -> String {
    let pull = match pin.pull {
        Pull::Up => "^",
        Pull::Down => "~",
        Pull::None => "",
    };
    let turned = if pin.inverted { "!" } else { "" };
    let board = boards.get(pin.board).filter(|_| pin.board > 0);
    let board = board.map(|name| format!("{name}:")).unwrap_or_default();
    format!("{pull}{turned}{board}{}", pin.name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pin_is_written_as_it_is_read() {
        let boards = ["main".to_owned(), "tools".to_owned()];
        let pin = Pin { inverted: true, pull: Pull::Up, ..Pin::new("PA3") };
        assert_eq!(written(&pin, &boards), "^!PA3");
        assert_eq!(written(&Pin { board: 1, ..Pin::new("PA3") }, &boards), "tools:PA3");
    }
}
