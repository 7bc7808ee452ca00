//! Steers Z beside the plan: by readings of a torch's voltage, by two switches of its head, or by the one input of VH.

use kerf_machine::height_follower::{acts_in, in_plane};
use kerf_machine::lines::Input;
use kerf_motion::Move;
use kerf_program::{Axis, Gauge, HeightLaw, Settings, TORCH_INPUT};

/// Distance by which Z is led on from where it was while a switch was on, mm: so far it runs on behind the place where the
/// switch lets go, because motion is handed over some tenths of a second before it is made. A guess: the sheet may rise by
/// as much in that time, some 3.5 mm/s.
const REACH_MM: f64 = 0.5;

/// Means by which it is known which way Z is to go.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Steering {
    /// Readings tell where the sheet is.
    Readings,
    /// The head is too high, and too low.
    Switches([bool; 2]),
    /// Down while the input is on, up while it is off (command reference, VH).
    Torch {
        /// State of the input.
        on: bool,
        /// Share of the speed of a move at which Z goes.
        rate: f64,
    },
}

impl Steering {
    /// Means of a law, with the states of inputs by number.
    pub fn of(law: &HeightLaw, reads: impl Fn(u8) -> bool) -> Self {
        match law.gauge {
            Gauge::Simple { high, low } => Self::Switches([reads(high), reads(low)]),
            Gauge::Proportional { .. } => Self::Readings,
        }
    }

    /// Learns the states of inputs by number; tells whether one of its own has changed.
    pub fn learn(&mut self, law: &HeightLaw, reads: impl Fn(u8) -> bool) -> bool {
        let now = match *self {
            Self::Torch { rate, .. } => Self::Torch { on: reads(TORCH_INPUT), rate },
            _ => Self::of(law, reads),
        };
        std::mem::replace(self, now) != now
    }

    /// Z follows during a move.
    pub fn acts_in(&self, law: &HeightLaw, made: &Move) -> bool {
        match self {
            Self::Torch { .. } => in_plane(made),
            _ => acts_in(law, made),
        }
    }

    /// The speed of Z in a move, mm/s upwards, where that does not follow from a place.
    pub fn speed_mm_s(&self, made: &Move) -> Option<f64> {
        match *self {
            Self::Torch { on, rate } => Some(rate * made.speed_mm_s * if on { -1.0 } else { 1.0 }),
            _ => None,
        }
    }

    /// Distance of the place to which switches lead Z from where it was when they were as they are, mm; nothing where
    /// something else leads it.
    pub const fn leads_mm(&self) -> Option<f64> {
        match self {
            Self::Switches([true, false]) => Some(-REACH_MM),
            Self::Switches([false, true]) => Some(REACH_MM),
            Self::Switches(_) => Some(0.0),
            _ => None,
        }
    }

    /// Too high and too low at once.
    pub const fn is_in_conflict(&self) -> bool {
        matches!(self, Self::Switches([true, true]))
    }
}

/// Inputs by which two switches tell the height.
pub const SWITCHES: [Input; 2] = [Input::ZHigh, Input::ZLow];

/// The law of VH, and how Z is steered by it; nothing where it is off.
pub fn of_torch(settings: &Settings, reads: impl Fn(u8) -> bool) -> Option<(HeightLaw, Steering)> {
    let height = &settings.height;
    let dynamics = settings.axis_dynamics();
    let limits = settings.limits.check.then_some(&settings.limits);
    let law = HeightLaw {
        gauge: Gauge::Simple { high: TORCH_INPUT, low: TORCH_INPUT },
        speed_mm_s: dynamics.speed_mm_s[Axis::Z],
        accel_mm_s2: dynamics.accel_mm_s2[Axis::Z],
        activation: 0.0,
        ceiling_mm: limits.map_or(f64::INFINITY, |limits| limits.high[Axis::Z]),
        floor_mm: limits.map_or(f64::NEG_INFINITY, |limits| limits.low[Axis::Z]),
        raised_mm: None,
    };
    let steering = Steering::Torch { on: reads(TORCH_INPUT), rate: height.rate };
    settings.torch_on().then_some((law, steering))
}
