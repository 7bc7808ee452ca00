//! Intensity and piercing of lasers (Profiler reference, "Intensity Output", "Laser Operation").

use crate::Sequence;
use crate::small::Small;
use kerf_machine::lines::Output;
use kerf_machine::settings::laser::LaserType;
use kerf_program::job::JobShape;
use kerf_program::{Beam, IntensityLaw};
use std::sync::Arc;

/// Milliseconds in a second.
const MS: f64 = 1e3;

impl Sequence {
    /// Returns the dependence of intensity on speed, as far as the machine outputs any.
    pub(crate) fn intensity_law(&self) -> Option<IntensityLaw> {
        let (intensity, laser) = (&self.machine.intensity, &self.machine.laser);
        if !intensity.output {
            return None;
        }
        let pulsed = laser.use_laser && laser.kind == Some(LaserType::Pulsed);
        Some(IntensityLaw {
            table: intensity.table.into(),
            scale_percent: intensity.scale_percent,
            clip: pulsed.then(|| self.pulse_limits()),
        })
    }

    /// Least and greatest value that gives a pulse the laser can make.
    pub(crate) fn pulse_limits(&self) -> [u8; 2] {
        let laser = &self.machine.laser;
        let period_us = 1e6 / laser.cut_hz;
        let value = |pulse_us: f64| pulse_us / period_us * 127.0;
        let low = value(laser.min_pulse_us);
        let low = if self.machine.intensity.strict_clip { low.ceil() } else { low + 1e-9 };
        [low.clamp(0.0, 255.0) as u8, (value(laser.max_pulse_us) + 1e-9).clamp(0.0, 127.0) as u8]
    }

    /// Returns the reason for which the laser can make no pulse, if there is one.
    pub(crate) fn no_pulse(&self) -> Option<&'static str> {
        let laser = &self.machine.laser;
        if !laser.use_laser {
            return None;
        }
        let Some(kind) = laser.kind else { return Some("the type of laser is not chosen") };
        let [low, high] = self.pulse_limits();
        let none = laser.min_pulse_us > laser.max_pulse_us || low > high || low > 127;
        (kind == LaserType::Pulsed && none).then_some("no valid laser pulse width")
    }

    /// Returns `true` if shapes of a cut output are engraved: never pierced.
    fn engraves(&self, shape: &JobShape) -> bool {
        self.machine.laser.engrave_cut == Some(shape.cut)
    }

    /// Returns `true` if a shape is pierced before it is cut.
    pub(crate) fn pierces(&self, shape: &JobShape) -> bool {
        let laser = &self.machine.laser;
        laser.use_laser && laser.pierce.use_sequence && !self.engraves(shape)
    }

    /// The tool output of a shape: its group's, or the gas that is used instead.
    pub(crate) fn tool_of(&self, shape: &JobShape) -> Option<Output> {
        let gas = self.machine.laser.gas;
        if self.machine.laser.use_laser && gas.overrides && !self.engraves(shape) {
            return gas.tool.map(Output::tool);
        }
        Some(Output::tool(shape.tool))
    }

    /// Piercing, then down to the height of the cut with the cut gas (readings, P-76 to P-79).
    pub(crate) fn laser_start(&self, shape: &JobShape, z: f64) -> Vec<Small> {
        let (pierce, gas) = (self.machine.laser.pierce, self.machine.laser.gas);
        let pierce_gas = pierce.gas_tool.map(Output::tool);
        let mut steps = self.to_pierce_height(shape, z);
        if let Some(tool) = pierce_gas {
            steps.extend([Small::Switch(tool, true), Small::Wait(pierce.gas_wait_ms / MS)]);
        }
        steps.extend(self.pierced(shape));
        let sensed = self.height_law(shape).is_some();
        steps.push(if sensed { Small::AboveSensed(0.0) } else { Small::Plunge(z) });
        steps.extend(pierce_gas.map(|tool| Small::Switch(tool, false)));
        let tool = self.tool_of(shape);
        steps.extend(tool.map(|tool| Small::Switch(tool, true)));
        steps.extend(pierce_gas.map(|_| Small::Wait(pierce.purge_ms / MS)));
        steps.extend(tool.map(|_| Small::Wait(gas.wait_ms / MS)));
        steps.extend(self.cutting_frequency());
        steps.push(Small::Switch(Output::cut(shape.cut), true));
        steps.extend(self.beam_follows(shape));
        steps
    }

    /// Down to the height at which it is pierced: above the surface that height control senses, or above
    /// ZSurface.
    fn to_pierce_height(&self, shape: &JobShape, z: f64) -> Vec<Small> {
        let above_mm = self.machine.laser.pierce.height_mm;
        let Some(law) = self.height_law(shape) else {
            return vec![Small::Plunge(self.heights.surface_mm + above_mm)];
        };
        let [controlled, lower] = Self::until_sensed(law, z);
        vec![controlled, lower, Small::AboveSensed(above_mm)]
    }

    /// The beam is on for the pierce time.
    fn pierced(&self, shape: &JobShape) -> Vec<Small> {
        let pierce = self.machine.laser.pierce;
        if pierce.time_ms <= 0.0 {
            return Vec::new();
        }
        let mut steps = Vec::new();
        if self.machine.laser.kind == Some(LaserType::Pulsed) {
            steps.push(Small::Frequency(pierce.hz));
        }
        let value = self.intensity_law().map(|law| law.value(pierce.intensity));
        steps.extend(value.map(|value| Small::Beam(Beam::Level { value, burn: false })));
        let cut = Output::cut(shape.cut);
        steps.extend([Small::Switch(cut, true), Small::Wait(pierce.time_ms / MS)]);
        steps.extend([Small::Switch(cut, false), Small::Beam(Beam::Off)]);
        steps
    }

    fn cutting_frequency(&self) -> Option<Small> {
        let laser = &self.machine.laser;
        let pulsed = laser.use_laser && laser.kind == Some(LaserType::Pulsed);
        pulsed.then_some(Small::Frequency(laser.cut_hz))
    }

    /// Intensity during the bottom delay: what the table gives at rest, with the burn bit.
    pub(crate) fn beam_at_bottom(&self, shape: &JobShape) -> Vec<Small> {
        let Some(law) = self.intensity_law() else {
            return self.cutting_frequency().into_iter().collect();
        };
        let value = IntensityLaw { clip: None, ..law }.value(0);
        let burn = self.machine.intensity.low_bit_at_bottom;
        let (value, burn) = if self.engraves(shape) { (0, false) } else { (value, burn) };
        let beam = Small::Beam(Beam::Level { value, burn });
        self.cutting_frequency().into_iter().chain([beam]).collect()
    }

    /// Intensity follows the speed from here on.
    pub(crate) fn beam_follows(&self, _shape: &JobShape) -> Option<Small> {
        let law = self.intensity_law()?;
        Some(Small::Beam(Beam::Follow(Arc::new(law))))
    }

    /// Intensity during the end delay.
    pub(crate) fn beam_at_end(&self) -> Option<Small> {
        let law = self.intensity_law()?;
        let value = match self.machine.delays.end_intensity {
            0 => return Some(Small::Beam(Beam::Off)),
            asked => law.value(asked),
        };
        Some(Small::Beam(Beam::Level { value, burn: false }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use kerf_machine::Configuration;
    use kerf_program::Axes;

    #[test]
    fn pro_intensity_pwmlimits() {
        let mut machine = Configuration::default();
        (machine.laser.use_laser, machine.laser.kind) = (true, Some(LaserType::Pulsed));
        machine.intensity.output = true;
        machine.laser.cut_hz = 5000.0;
        (machine.laser.min_pulse_us, machine.laser.max_pulse_us) = (20.0, 100.0);
        let clip = |machine: &Configuration| {
            let (job, machine) = (Arc::default(), Arc::new(machine.clone()));
            Sequence::new(job, machine, Axes::default()).intensity_law().and_then(|law| law.clip)
        };
        // Of 200 us: a tenth and a half of 127.
        assert_eq!(clip(&machine), Some([12, 63]));
        machine.laser.cut_hz = 10_000.0;
        assert_eq!(clip(&machine), Some([25, 127]));
        machine.laser.kind = Some(LaserType::Continuous);
        assert_eq!(clip(&machine), None);
    }
}
