//! A run as a trace of signals: steps and directions, ports and switches, positions in steps, pulse
//! widths (`--vcd`).

mod pulses;
mod signals;
mod waveforms;

use crate::{Event, ExecutedMove, Sink};
use kerf_machine::Configuration;
use kerf_machine::lines::{Output, line_of_pin};
use kerf_machine::settings::laser::Laser;
use kerf_machine::wiring::INPUT_BITS;
use kerf_motion::{Step, Stepper};
use kerf_program::Axis;
use pulses::{Line, Pulses};
use signals::Signals;
use std::io::{self, Write};
use waveforms::Vcd;

/// Writes the trace of a run.
pub struct VcdSink<W> {
    out: W,
    vcd: Vcd,
    machine: Configuration,
    signals: Signals,
    pulses: Pulses,
    /// Places of the motors; nothing before the first move.
    stepper: Option<Stepper>,
    beam: Beam,
    failed: Option<io::Error>,
}

/// Signals that the board of a laser sees.
#[derive(Default)]
struct Beam {
    byte: u8,
    cuts: [bool; 2],
}

impl Beam {
    fn switch(&mut self, output: u8, on: bool) {
        let cuts = [Output::Cut1, Output::Cut2].into_iter().zip(&mut self.cuts);
        cuts.filter(|(cut, _)| cut.number() == output).for_each(|(_, state)| *state = on);
    }

    fn power_percent(&self, laser: &Laser) -> f64 {
        laser.power_percent(self.byte / 2, self.byte & 1 == 1, self.cuts)
    }
}

impl<W: Write> VcdSink<W> {
    /// A trace of this machine.
    pub fn new(out: W, machine: Configuration) -> Self {
        let mut vcd = Vcd::default();
        let signals = Signals::new(&mut vcd);
        let (pulses, beam) = (Pulses::new(&machine), Beam::default());
        let mut sink =
            Self { out, vcd, machine, signals, pulses, stepper: None, beam, failed: None };
        let header = sink.vcd.header();
        sink.put(&header);
        sink.inputs_at_rest();
        sink
    }

    /// Traces the readings of inputs that nobody has moved.
    fn inputs_at_rest(&mut self) {
        let reads = kerf_sim::untouched(&self.machine);
        let active = INPUT_BITS.iter().map(line_of_pin).filter(|line| reads(*line));
        active.for_each(|line| self.signals.inputs.change(&mut self.vcd, 0.0, line, true));
    }

    /// The trace is over.
    ///
    /// # Errors
    /// The first thing that could not be written.
    pub fn finish(mut self) -> io::Result<()> {
        self.flush(f64::INFINITY);
        match self.failed {
            Some(error) => Err(error),
            None => self.out.flush(),
        }
    }

    fn flush(&mut self, before_s: f64) {
        let lines = self.vcd.flush(before_s);
        self.put(&lines);
    }

    fn put(&mut self, text: &str) {
        if self.failed.is_none() {
            self.failed = self.out.write_all(text.as_bytes()).err();
        }
    }

    fn step(&mut self, step: &Step, made: i64) {
        self.vcd.at(step.t_s, self.signals.positions[step.axis], made as f64);
        for edge in self.pulses.edges(step) {
            let ids = match edge.line {
                Line::Direction => &self.signals.directions,
                Line::Step => &self.signals.steps,
            };
            self.vcd.at_ns(edge.t_ns, ids[edge.motor.index()], f64::from(edge.high));
        }
    }
}

impl<W: Write> Sink for VcdSink<W> {
    fn event(&mut self, event: &Event) {
        let (vcd, signals) = (&mut self.vcd, &self.signals);
        match event {
            Event::Output { n, on, t, .. } => {
                signals.outputs.change(vcd, *t, *n, *on);
                self.beam.switch(*n, *on);
                vcd.at(*t, signals.power, self.beam.power_percent(&self.machine.laser));
            }
            Event::Input { n, on, t, .. } => signals.inputs.change(vcd, *t, *n, *on),
            Event::Pwm { channel, percent, t, .. } => {
                let id = signals.pwm.get(usize::from(*channel).wrapping_sub(1));
                id.into_iter().for_each(|id| vcd.at(*t, *id, *percent));
            }
            Event::Intensity { byte, port, t, .. } => {
                vcd.at(*t, signals.intensity[usize::from(*port == 2)], f64::from(*byte));
                self.beam.byte = *byte;
                vcd.at(*t, signals.power, self.beam.power_percent(&self.machine.laser));
            }
            Event::LaserHz { hz, t } => {
                let port = usize::from(self.machine.intensity.port == 2);
                vcd.at(*t, signals.laser_hz[port], *hz);
            }
            _ => {}
        }
    }

    fn looks_at_motion(&self) -> bool {
        false
    }

    fn made(&mut self, made: &ExecutedMove<'_>) {
        let (span, t0_s) = (made.span, made.t0_s);
        let [from_s, to_s] = [span.t0_s, span.t1_s].map(|s| t0_s + s);
        // What happens during a move is told after it.
        self.flush(from_s);
        let per_unit = self.machine.program.resolution.steps_per_unit;
        let place = |t_s: f64| made.place(t_s - t0_s);
        let new = || Stepper::new(per_unit, place(from_s));
        let of_axis = |axis: Axis| self.machine.motors.of_axis(axis);
        let alone = made.alone.and_then(|(axis, n)| of_axis(axis).get(n).copied());
        self.pulses.move_alone(alone);
        let stepper = self.stepper.get_or_insert_with(new);
        let anew = stepper.stands(place(from_s));
        let mut counts = stepper.made();
        for axis in anew {
            self.vcd.at(from_s, self.signals.positions[axis], counts[axis] as f64);
        }
        let steps = stepper.follow(from_s, to_s, place);
        for step in steps {
            counts[step.axis] += if step.forward { 1 } else { -1 };
            self.step(&step, counts[step.axis]);
        }
    }
}
