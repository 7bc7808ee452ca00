//! Orders that a controller carries out in a row, and signals that act at once.

use kerf_program::{AXES, Axes};

/// The number of an order; they count up from 1.
pub type Ticket = u32;

/// An order that a controller can be given.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Order {
    /// A straight move, mm and mm/s (degrees and degrees/s of rotary axes).
    Move {
        /// Target, machine frame.
        to: Axes,
        /// Highest speed.
        speed_mm_s: f64,
    },
    /// A straight move beside the work, which the feed override does not change. Where its speed is the greatest that the
    /// controller goes, it is a rapid move of the controller.
    Jog {
        /// Target, machine frame.
        to: Axes,
        /// Highest speed.
        speed_mm_s: f64,
    },
    /// An arc in X and Y, on which Z moves in proportion to the angle; of a controller that [makes arcs](super::Facts::arcs).
    Arc {
        /// Target, machine frame.
        to: Axes,
        /// Centre in X and Y, machine frame.
        centre: [f64; 2],
        /// Swept angle, positive counter-clockwise, a turn at most.
        sweep_rad: f64,
        /// Highest speed along the arc.
        speed_mm_s: f64,
    },
    /// A straight move that ends where the probe gets contact, or loses it: the machine stands at the very place, or at the
    /// end where nothing changed. No order is under way beside it.
    Probe {
        /// Target, machine frame.
        to: Axes,
        /// Highest speed.
        speed_mm_s: f64,
        /// The state of the probe that ends it.
        active: bool,
    },
    /// Switches an output.
    Output {
        /// Its line.
        line: u8,
        /// Its state from then on.
        on: bool,
    },
    /// Sets the speed of the spindle; it need not turn.
    Spindle {
        /// Revolutions a minute.
        rpm: f64,
    },
    /// Goes home with all axes that can.
    Home,
    /// Takes orders again after an alarm, without being homed.
    Unlock,
}

impl Order {
    /// Returns where it leads, machine frame; nothing where it is no move to a place.
    pub const fn to(&self) -> Option<Axes> {
        match self {
            Self::Move { to, .. }
            | Self::Jog { to, .. }
            | Self::Arc { to, .. }
            | Self::Probe { to, .. } => Some(*to),
            Self::Output { .. } | Self::Spindle { .. } | Self::Home | Self::Unlock => None,
        }
    }
}

/// A share that the operator turns at a controller, percent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Override {
    /// Of the speed of rapid moves, up to 100. A controller of few steps takes the next one below.
    Rapid(u8),
    /// Of the speed of the spindle.
    Spindle(u8),
}

/// Shares at which a controller makes what it is told, percent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shares {
    /// Of the speed of cuts.
    pub feed: u8,
    /// Of the speed of rapid moves.
    pub rapid: u8,
    /// Of the speed of the spindle.
    pub spindle: u8,
}

impl Default for Shares {
    fn default() -> Self {
        Self { feed: 100, rapid: 100, spindle: 100 }
    }
}

/// A request outside the row of orders, carried out at once.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Signal {
    /// Tell where you are.
    Ask,
    /// Slow down on the path and wait.
    Hold,
    /// Go on.
    Resume,
    /// Nothing runs: whoever moves you now does it by hand, also while you [wait for a tool](super::Wired::waits_for_tool).
    ByHand,
    /// The tool is in for which you [wait](super::Wired::waits_for_tool).
    ToolIn,
    /// Touch it off by yourself, as far as you [do such](super::Wired::touch_off).
    TouchOff,
    /// Nobody puts it in: give the change of tools up.
    ToolOff,
    /// Slow down, forget every order that is not done, switch outputs off.
    Stop,
    /// Make moves at so many percent of the speed that was ordered, from now on.
    Feed(u8),
    /// The operator turns something else.
    Override(Override),
}

/// An order with its ticket.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sent {
    /// Its ticket.
    pub ticket: Ticket,
    /// The order.
    pub order: Order,
}

/// Returns `true` if an order can be carried out by some machine.
pub fn is_sound(order: &Order) -> bool {
    match order {
        Order::Move { to, speed_mm_s }
        | Order::Jog { to, speed_mm_s }
        | Order::Probe { to, speed_mm_s, .. } => {
            to.0.iter().all(|v| v.is_finite()) && speed_mm_s.is_finite() && *speed_mm_s > 0.0
        }
        Order::Arc { to, centre, sweep_rad, speed_mm_s } => {
            let numbers = to.0.iter().chain(centre).chain([sweep_rad, speed_mm_s]);
            numbers.into_iter().all(|v| v.is_finite()) && *speed_mm_s > 0.0 && *sweep_rad != 0.0
        }
        Order::Output { line, .. } => (1..=u32::BITS as u8).contains(line),
        Order::Spindle { rpm } => rpm.is_finite() && *rpm >= 0.0,
        Order::Home | Order::Unlock => true,
    }
}

/// The way of a move, its longest axis counted.
pub fn way_mm(from: Axes, to: Axes) -> f64 {
    let ways: [f64; AXES] = to.minus(from).0;
    ways.iter().map(|way| way * way).sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_order_that_no_machine_can_carry_out_is_not_sound() {
        let to = Axes::default();
        let nowhere = Axes::xyz(0.0, f64::NAN, 0.0);
        for (order, sound) in [
            (Order::Move { to, speed_mm_s: 5.0 }, true),
            (Order::Move { to, speed_mm_s: 0.0 }, false),
            (Order::Move { to, speed_mm_s: f64::INFINITY }, false),
            (Order::Move { to: nowhere, speed_mm_s: 5.0 }, false),
            (Order::Arc { to, centre: [1.0; 2], sweep_rad: 1.0, speed_mm_s: 5.0 }, true),
            (Order::Arc { to, centre: [1.0; 2], sweep_rad: 0.0, speed_mm_s: 5.0 }, false),
            (Order::Output { line: 1, on: true }, true),
            (Order::Output { line: 0, on: true }, false),
            (Order::Output { line: 33, on: true }, false),
            (Order::Spindle { rpm: 0.0 }, true),
            (Order::Spindle { rpm: -1.0 }, false),
            (Order::Home, true),
        ] {
            assert_eq!(is_sound(&order), sound, "{order:?}");
        }
    }
}
