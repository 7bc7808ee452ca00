//! Log of what happened, and when.

use kerf_program::{AXES, Axis, Independent, OutputReason};

/// One thing that happened.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Happening {
    /// Time, seconds of machine time.
    pub t_s: f64,
    /// Event with its details.
    pub what: What,
}

/// The kinds of things that happen beside motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum What {
    /// An input changed.
    Input {
        /// Its number.
        number: u8,
        /// Its state from now on.
        on: bool,
    },
    /// The controller answers from now on, or does not any more.
    Link(bool),
    /// A motor has stalled, or is free again.
    Stall(bool),
    /// An output changed.
    Output {
        /// Its number.
        number: u8,
        /// Its state from now on.
        on: bool,
        /// Cause of the change.
        why: OutputReason,
    },
    /// The duty of a PWM channel changed; between two changes of one move it changes evenly.
    Pwm {
        /// Its number, from 1.
        channel: u8,
        /// Duty, 0 … 100.
        percent: f64,
        /// Pulse frequency, kHz.
        frequency_khz: f64,
    },
    /// The intensity output changed.
    Intensity {
        /// Its value, 0 … 127.
        value: u8,
        /// The burn bit is set.
        burn: bool,
    },
    /// Height control took a reading.
    Height {
        /// Height of the tool, Z of the machine frame, mm.
        z_mm: f64,
        /// Difference of the gap from the one that is wanted, mm.
        error_mm: f64,
        /// Reading of the sensor, 0 … 255.
        reading: u8,
    },
    /// Height control carried Z as far as here: it turns round, comes to rest, or the move is over.
    Carried {
        /// Height of the tool, Z of the machine frame, mm.
        z_mm: f64,
    },
    /// The pulse frequency of a laser was set, Hz.
    LaserFrequency(f64),
    /// A spindle got a speed.
    Spindle {
        /// Its number, from 1.
        number: u8,
        /// Revolutions a minute.
        rpm: f64,
        /// Its output is on.
        on: bool,
    },
    /// The warning light before and during motion.
    Light(bool),
    /// Power of the motors.
    Motors(bool),
    /// An axis was pushed by hand.
    Pushed {
        /// The axis.
        axis: Axis,
        /// Distance that it gave way, mm or degrees: none while its motor holds it.
        by: f64,
    },
    /// Coarser steps began or ended, each axis by its factor (command reference, VU).
    Resolution([u8; AXES]),
    /// An axis began or stopped to move beside the others (MI).
    Independent {
        /// The axis.
        axis: Axis,
        /// Its motion from now on.
        motion: Independent,
    },
}

/// Happenings in order of time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Log(Vec<Happening>);

impl Log {
    /// Adds one; it must not lie before the last.
    pub(crate) fn add(&mut self, t_s: f64, what: What) {
        self.0.push(Happening { t_s, what });
    }

    /// Takes everything out, in order of time. What happened at the same time stays in the order in
    /// which it was written.
    pub fn take(&mut self) -> impl Iterator<Item = Happening> + '_ {
        self.0.sort_by(|a, b| a.t_s.total_cmp(&b.t_s));
        self.0.drain(..)
    }

    /// True when nothing happened.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}
