//! Settings of a motor driver as values of its registers.

use super::{CHOPCONF, Chip, GCONF, GSTAT};

const IHOLD_IRUN: u8 = 0x10;
const TPOWERDOWN: u8 = 0x11;
const TPWMTHRS: u8 = 0x13;
const TCOOLTHRS: u8 = 0x14;
const SGTHRS: u8 = 0x40;
const COOLCONF: u8 = 0x6d;
const GLOBALSCALER: u8 = 0x0b;

/// Full scales of the voltage at a sense resistor, volts: usual, and where `vsense` is set.
const FULL_V: [f64; 2] = [0.325, 0.18];
/// Resistance beside a sense resistor inside the chips that have their own transistors, ohms.
const INSIDE_OHMS: f64 = 0.02;
/// Least scale of a TMC5160 beside 0, which is 256 (its data sheet, GLOBALSCALER).
const LEAST_SCALE: f64 = 32.0;
/// The chopper as the data sheets advise to begin with: TOFF 3, HSTRT 4, HEND 1, TBL 2.
const CHOPPER: u32 = 3 | 4 << 4 | 1 << 7 | 2 << 15;
/// Time from run to hold current, by 2^18 clocks a step.
const HOLD_DELAY: u32 = 6 << 16;
/// Stand until the current goes down, by 2^18 clocks.
const POWER_DOWN: u32 = 20;

/// Settings of a motor driver.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tuning {
    /// Its kind.
    pub chip: Chip,
    /// Current of a coil while the motor turns, amperes, root mean square.
    pub current_a: f64,
    /// Share of it while the motor stands.
    pub hold: f64,
    /// Its sense resistors, ohms.
    pub ohms: f64,
    /// Microsteps of a full step: a power of two up to 256.
    pub microsteps: u32,
    /// It makes 256 microsteps out of each full step by itself.
    pub interpolates: bool,
    /// StealthChop: no noise, less torque at speed; SpreadCycle where not.
    pub quiet: bool,
    /// Threshold at which it tells a stall; 0 where it tells none.
    pub stall: i32,
    /// Each edge is a step.
    pub both_edges: bool,
}

/// The reason for which a driver cannot be set so.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum TuningError {
    /// No current was named.
    #[error("no current is set for it: name it in amperes, less than its motor bears")]
    NoCurrent,
    /// The current is more or less than the resistors allow.
    #[error("{current_a} A is beyond its resistors: from {least_a:.2} to {most_a:.2} A")]
    Current {
        /// The one that is wanted.
        current_a: f64,
        /// Lowest one.
        least_a: f64,
        /// Highest one.
        most_a: f64,
    },
    /// A driver cannot make so many microsteps.
    #[error("{0} microsteps are none: 1, 2, 4 and so on up to 256")]
    Microsteps(u32),
    /// The threshold is out of bounds.
    #[error(
        "a stall threshold of {0} is none: 0 to 255 of a TMC2209, -64 to 63 of one with a chip select"
    )]
    Stall(i32),
}

/// A register with its value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Write {
    /// Its number.
    pub register: u8,
    /// Its value.
    pub value: u32,
}

impl Write {
    /// The register can be read back.
    pub const fn is_readable(self) -> bool {
        matches!(self.register, GCONF | CHOPCONF)
    }
}

/// A current as a chip takes it: its scale for all, the lower full scale, steps of 32.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Scale {
    global: u32,
    low: bool,
    run: u32,
}

impl Tuning {
    /// Returns its registers in the order in which they are written.
    ///
    /// # Errors
    ///
    /// The driver cannot be set so.
    pub fn writes(&self) -> Result<Vec<Write>, TuningError> {
        let Scale { global, low, run } = self.scale()?;
        let hold = (f64::from(run + 1) * self.hold.clamp(0.0, 1.0)).round().max(1.0) as u32 - 1;
        let mut writes = vec![
            (GSTAT, 0b111),
            (GCONF, self.choices()),
            (CHOPCONF, self.chopper(low)?),
            (TPOWERDOWN, POWER_DOWN),
            // StealthChop at all speeds.
            (TPWMTHRS, 0),
        ];
        if self.chip == Chip::Tmc5160 {
            writes.push((GLOBALSCALER, global));
        }
        writes.extend(self.stalls()?);
        // The current is the last: until then a chip that was reset has little.
        writes.push((IHOLD_IRUN, hold | run << 8 | HOLD_DELAY));
        Ok(writes.into_iter().map(|(register, value)| Write { register, value }).collect())
    }

    /// The choices for the whole chip: its registers count, and not its pins.
    const fn choices(&self) -> u32 {
        match self.chip {
            Chip::Tmc2208 | Chip::Tmc2209 => {
                let spread = if self.quiet { 0 } else { 1 << 2 };
                // PDN_UART is no pin of the current, MRES no pins of microsteps; steps are filtered.
                spread | 1 << 6 | 1 << 7 | 1 << 8
            }
            Chip::Tmc2130 | Chip::Tmc5160 => {
                let quiet = if self.quiet { 1 << 2 } else { 0 };
                // DIAG1 tells a stall, and is driven.
                quiet | if self.stall == 0 { 0 } else { 1 << 8 | 1 << 13 }
            }
        }
    }

    fn chopper(&self, low: bool) -> Result<u32, TuningError> {
        let many = self.microsteps;
        if !many.is_power_of_two() || many > 256 {
            return Err(TuningError::Microsteps(many));
        }
        let resolution = (8 - many.trailing_zeros()) << 24;
        let bit = |on: bool, at: u32| u32::from(on) << at;
        let bits = bit(low, 17) | bit(self.interpolates, 28) | bit(self.both_edges, 29);
        Ok(CHOPPER | resolution | bits)
    }

    /// The registers of the stall threshold.
    fn stalls(&self) -> Result<Vec<(u8, u32)>, TuningError> {
        let wrong = || TuningError::Stall(self.stall);
        let at_all_speeds = (TCOOLTHRS, if self.stall == 0 { 0 } else { 0xf_ffff });
        match self.chip {
            Chip::Tmc2208 if self.stall == 0 => Ok(Vec::new()),
            Chip::Tmc2208 => Err(wrong()),
            Chip::Tmc2209 => {
                let threshold = u8::try_from(self.stall).map_err(|_| wrong())?;
                Ok(vec![at_all_speeds, (SGTHRS, threshold.into())])
            }
            Chip::Tmc2130 | Chip::Tmc5160 => {
                let threshold = Some(self.stall).filter(|it| (-64..64).contains(it));
                let threshold = threshold.ok_or_else(wrong)? as u32 & 0x7f;
                Ok(vec![at_all_speeds, (COOLCONF, threshold << 16)])
            }
        }
    }

    /// The current as the chip takes it: I = (run + 1)/32 · U/R/√2, times global/256 of a TMC5160 (data sheets,
    /// "Selecting sense resistors").
    fn scale(&self) -> Result<Scale, TuningError> {
        if self.current_a <= 0.0 {
            return Err(TuningError::NoCurrent);
        }
        let own = self.chip == Chip::Tmc5160;
        let ohms = self.ohms + if own { 0.0 } else { INSIDE_OHMS };
        let [most_a, low_a] = FULL_V.map(|volts| volts / ohms * std::f64::consts::FRAC_1_SQRT_2);
        let least_a = if own { most_a * LEAST_SCALE / 256.0 / 32.0 } else { low_a / 32.0 };
        let wanted = self.current_a;
        if !(least_a..=most_a).contains(&wanted) {
            return Err(TuningError::Current { current_a: wanted, least_a, most_a });
        }
        if own {
            // Fine steps of all, with half the steps of the run current and more, as the data sheet advises.
            let global = (wanted / most_a * 256.0).ceil().clamp(LEAST_SCALE, 256.0);
            let run = (wanted / (most_a * global / 256.0) * 32.0).round().clamp(1.0, 32.0);
            return Ok(Scale { global: global as u32 & 0xff, low: false, run: run as u32 - 1 });
        }
        let low = wanted <= low_a;
        let full_a = if low { low_a } else { most_a };
        let run = (wanted / full_a * 32.0).floor().clamp(1.0, 32.0);
        Ok(Scale { global: 0, low, run: run as u32 - 1 })
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn tuning(chip: Chip, current_a: f64) -> Tuning {
        let ohms = chip.usual_ohms();
        Tuning {
            chip,
            current_a,
            hold: 0.5,
            ohms,
            microsteps: 16,
            interpolates: true,
            quiet: false,
            stall: 0,
            both_edges: false,
        }
    }

    fn value(tuning: Tuning, register: u8) -> Option<u32> {
        let writes = tuning.writes().unwrap();
        writes.iter().find(|it| it.register == register).map(|it| it.value)
    }

    #[test]
    fn currents_are_steps_of_the_sense_resistors() {
        let check = |chip, current_a, expected: (u32, bool, u32)| {
            let Scale { global, low, run } = tuning(chip, current_a).scale().unwrap();
            assert_eq!((global, low, run), expected, "{chip:?} {current_a} A");
        };
        // Data sheet of the TMC2209, 0.11 Ω: 1.77 A at most, 0.98 A with vsense.
        check(Chip::Tmc2209, 1.76, (0, false, 30));
        check(Chip::Tmc2209, 0.97, (0, true, 30));
        check(Chip::Tmc2208, 0.5, (0, true, 15));
        check(Chip::Tmc5160, 3.06, (0, false, 31));
        check(Chip::Tmc5160, 1.0, (84, false, 31));
        check(Chip::Tmc5160, 0.2, (32, false, 16));
    }

    #[test]
    fn a_current_is_never_more_than_was_asked_for_by_over_a_step() {
        for chip in [Chip::Tmc2208, Chip::Tmc2209, Chip::Tmc2130, Chip::Tmc5160] {
            let ohms = chip.usual_ohms() + if chip == Chip::Tmc5160 { 0.0 } else { INSIDE_OHMS };
            for n in 1..17 {
                let wanted = 0.1 * f64::from(n);
                let Scale { global, low, run } = tuning(chip, wanted).scale().unwrap();
                let full = FULL_V[usize::from(low)] / ohms / 2_f64.sqrt();
                let global = if global == 0 { 256 } else { global };
                let made = full * f64::from(run + 1) / 32.0 * f64::from(global) / 256.0;
                assert!(made < 1.05 * wanted && made > 0.6 * wanted, "{chip:?} {wanted} {made}");
            }
        }
    }

    #[test]
    fn registers_are_those_of_the_data_sheets() {
        let driver = tuning(Chip::Tmc2209, 0.8);
        assert_eq!(value(driver, GCONF), Some(0x1c4));
        assert_eq!(value(Tuning { quiet: true, ..driver }, GCONF), Some(0x1c0));
        assert_eq!(value(driver, CHOPCONF), Some(0x1403_00c3));
        assert_eq!(value(Tuning { microsteps: 256, ..driver }, CHOPCONF), Some(0x1003_00c3));
        let edges = Tuning { both_edges: true, interpolates: false, ..driver };
        assert_eq!(value(edges, CHOPCONF), Some(0x2403_00c3));
        assert_eq!(value(driver, IHOLD_IRUN), Some(0x0006_190c));
        assert_eq!(value(Tuning { stall: 80, ..driver }, SGTHRS), Some(80));
        let select = Tuning { stall: -2, quiet: true, ..tuning(Chip::Tmc2130, 0.8) };
        assert_eq!(value(select, COOLCONF), Some(0x7e << 16));
        assert_eq!(value(select, GCONF), Some(0x2104));
        assert_eq!(
            tuning(Chip::Tmc5160, 1.0).writes().unwrap().last().unwrap().register,
            IHOLD_IRUN
        );
    }

    #[test]
    fn settings_that_no_driver_has_are_told() {
        let check = |tuning: Tuning, part: &str| {
            let why = tuning.writes().unwrap_err().to_string();
            assert!(why.contains(part), "{why}");
        };
        check(tuning(Chip::Tmc2209, 0.0), "no current is set");
        check(tuning(Chip::Tmc2209, 2.0), "from 0.03 to 1.77 A");
        check(Tuning { microsteps: 10, ..tuning(Chip::Tmc2209, 1.0) }, "10 microsteps");
        check(Tuning { stall: 5, ..tuning(Chip::Tmc2208, 1.0) }, "stall threshold of 5");
        check(Tuning { stall: 64, ..tuning(Chip::Tmc2130, 1.0) }, "stall threshold of 64");
    }
}
