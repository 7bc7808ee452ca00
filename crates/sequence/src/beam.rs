//! Intensity and piercing of lasers (Profiler reference, "Intensity Output", "Laser Operation").

use crate::cut::Cut;
use crate::step::Step;
use kerf_machine::Configuration;
use kerf_machine::lines::Output;
use kerf_machine::settings::laser::LaserType;
use kerf_program::{Beam, IntensityLaw};
use std::sync::Arc;

/// Milliseconds in a second.
const MS: f64 = 1e3;

/// Returns the dependence of intensity on speed, as far as the machine outputs any.
pub(crate) fn intensity_law(machine: &Configuration) -> Option<IntensityLaw> {
    let (intensity, laser) = (&machine.intensity, &machine.laser);
    if !intensity.output {
        return None;
    }
    let pulsed = laser.use_laser && laser.kind == Some(LaserType::Pulsed);
    Some(IntensityLaw {
        table: intensity.table.into(),
        scale_percent: intensity.scale_percent,
        clip: pulsed.then(|| pulse_limits(machine)),
    })
}

/// Least and greatest value that gives a pulse the laser can make.
pub(crate) fn pulse_limits(machine: &Configuration) -> [u8; 2] {
    let laser = &machine.laser;
    let period_us = 1e6 / laser.cut_hz;
    let value = |pulse_us: f64| pulse_us / period_us * 127.0;
    let low = value(laser.min_pulse_us);
    let low = if machine.intensity.strict_clip { low.ceil() } else { low + 1e-9 };
    [low.clamp(0.0, 255.0) as u8, (value(laser.max_pulse_us) + 1e-9).clamp(0.0, 127.0) as u8]
}

/// Returns the reason for which the laser can make no pulse, if there is one.
pub(crate) fn no_pulse(machine: &Configuration) -> Option<&'static str> {
    let laser = &machine.laser;
    if !laser.use_laser {
        return None;
    }
    let Some(kind) = laser.kind else { return Some("the type of laser is not chosen") };
    let [low, high] = pulse_limits(machine);
    let none = laser.min_pulse_us > laser.max_pulse_us || low > high || low > 127;
    (kind == LaserType::Pulsed && none).then_some("no valid laser pulse width")
}

impl Cut<'_> {
    /// Returns `true` if shapes of a cut output are engraved: never pierced.
    fn engraves(&self) -> bool {
        self.setup.machine.laser.engrave_cut == Some(self.shape.cut)
    }

    /// Returns `true` if a shape is pierced before it is cut.
    pub fn pierces(&self) -> bool {
        let laser = &self.setup.machine.laser;
        laser.use_laser && laser.pierce.use_sequence && !self.engraves()
    }

    /// The tool output of a shape: its group's, or the gas that is used instead.
    pub fn tool_of(&self) -> Option<Output> {
        let gas = self.setup.machine.laser.gas;
        if self.setup.machine.laser.use_laser && gas.overrides && !self.engraves() {
            return gas.tool.map(Output::tool);
        }
        Some(Output::tool(self.shape.tool))
    }

    /// Piercing, then down to the height of the cut with the cut gas (readings, P-76 to P-79).
    pub fn laser_start(&self, z: f64) -> Vec<Step> {
        let (pierce, gas) = (self.setup.machine.laser.pierce, self.setup.machine.laser.gas);
        let pierce_gas = pierce.gas_tool.map(Output::tool);
        let mut steps = self.to_pierce_height(z);
        if let Some(tool) = pierce_gas {
            steps.extend([Step::Switch(tool, true), Step::Wait(pierce.gas_wait_ms / MS)]);
        }
        steps.extend(self.pierced());
        let sensed = self.height_law().is_some();
        steps.push(if sensed { Step::AboveSensed(0.0) } else { Step::Plunge(z) });
        steps.extend(pierce_gas.map(|tool| Step::Switch(tool, false)));
        let tool = self.tool_of();
        steps.extend(tool.map(|tool| Step::Switch(tool, true)));
        steps.extend(pierce_gas.map(|_| Step::Wait(pierce.purge_ms / MS)));
        steps.extend(tool.map(|_| Step::Wait(gas.wait_ms / MS)));
        steps.extend(self.cutting_frequency());
        steps.push(Step::Switch(Output::cut(self.shape.cut), true));
        steps.extend(self.beam_follows());
        steps
    }

    /// Down to the height at which it is pierced: above the surface that height control senses, or above
    /// ZSurface.
    fn to_pierce_height(&self, z: f64) -> Vec<Step> {
        let above_mm = self.setup.machine.laser.pierce.height_mm;
        let Some(law) = self.height_law() else {
            return vec![Step::Plunge(self.values.heights.surface_mm + above_mm)];
        };
        let [controlled, lower] = Self::until_sensed(law, z);
        vec![controlled, lower, Step::AboveSensed(above_mm)]
    }

    /// The beam is on for the pierce time.
    fn pierced(&self) -> Vec<Step> {
        let pierce = self.setup.machine.laser.pierce;
        if pierce.time_ms <= 0.0 {
            return Vec::new();
        }
        let mut steps = Vec::new();
        if self.setup.machine.laser.kind == Some(LaserType::Pulsed) {
            steps.push(Step::Frequency(pierce.hz));
        }
        let value = intensity_law(&self.setup.machine).map(|law| law.value(pierce.intensity));
        steps.extend(value.map(|value| Step::Beam(Beam::Level { value, burn: false })));
        let cut = Output::cut(self.shape.cut);
        steps.extend([Step::Switch(cut, true), Step::Wait(pierce.time_ms / MS)]);
        steps.extend([Step::Switch(cut, false), Step::Beam(Beam::Off)]);
        steps
    }

    fn cutting_frequency(&self) -> Option<Step> {
        let laser = &self.setup.machine.laser;
        let pulsed = laser.use_laser && laser.kind == Some(LaserType::Pulsed);
        pulsed.then_some(Step::Frequency(laser.cut_hz))
    }

    /// Intensity during the bottom delay: what the table gives at rest, with the burn bit.
    pub fn beam_at_bottom(&self) -> Vec<Step> {
        let Some(law) = intensity_law(&self.setup.machine) else {
            return self.cutting_frequency().into_iter().collect();
        };
        let value = IntensityLaw { clip: None, ..law }.value(0);
        let burn = self.setup.machine.intensity.low_bit_at_bottom;
        let (value, burn) = if self.engraves() { (0, false) } else { (value, burn) };
        let beam = Step::Beam(Beam::Level { value, burn });
        self.cutting_frequency().into_iter().chain([beam]).collect()
    }

    /// Intensity follows the speed from here on.
    pub fn beam_follows(&self) -> Option<Step> {
        let law = intensity_law(&self.setup.machine)?;
        Some(Step::Beam(Beam::Follow(Arc::new(law))))
    }

    /// Intensity during the end delay.
    pub fn beam_at_end(&self) -> Option<Step> {
        let law = intensity_law(&self.setup.machine)?;
        let value = match self.setup.machine.delays.end_intensity {
            0 => return Some(Step::Beam(Beam::Off)),
            asked => law.value(asked),
        };
        Some(Step::Beam(Beam::Level { value, burn: false }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pro_intensity_pwmlimits() {
        let mut machine = Configuration::default();
        (machine.laser.use_laser, machine.laser.kind) = (true, Some(LaserType::Pulsed));
        machine.intensity.output = true;
        machine.laser.cut_hz = 5000.0;
        (machine.laser.min_pulse_us, machine.laser.max_pulse_us) = (20.0, 100.0);
        let clip = |machine: &Configuration| intensity_law(machine).and_then(|law| law.clip);
        // Of 200 us: a tenth and a half of 127.
        assert_eq!(clip(&machine), Some([12, 63]));
        machine.laser.cut_hz = 10_000.0;
        assert_eq!(clip(&machine), Some([25, 127]));
        machine.laser.kind = Some(LaserType::Continuous);
        assert_eq!(clip(&machine), None);
    }
}
