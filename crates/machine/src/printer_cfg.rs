//! Pins of a printer's configuration (`printer.cfg`, as Klipper's host reads it) as settings of a board.
//!
//! A section a line in brackets, then `key: value` or `key = value`; what follows `#` or `;` is a comment. Only what a board
//! with step queues needs is read: motors, their switches, what gives them current. The rest stays the printer's.

use std::collections::BTreeMap;
use std::fmt::Write;

/// Steps of a motor's turn where the file does not say.
const FULL_STEPS: f64 = 200.0;

/// A motor by its section.
#[derive(Clone, Copy)]
struct Motor {
    section: &'static str,
    /// The setting of its pins, which is also its name.
    key: &'static str,
    /// The setting that makes it the second motor of an axis.
    second: Option<&'static str>,
    /// The setting of its home switch; empty where it has none of its own.
    home: &'static str,
}

const MOTORS: [Motor; 6] = [
    Motor { section: "stepper_x", key: "x", second: None, home: "home_x" },
    Motor { section: "stepper_y", key: "y", second: None, home: "home_y" },
    Motor { section: "stepper_z", key: "z", second: None, home: "home_z" },
    Motor { section: "stepper_y1", key: "w", second: Some("y2"), home: "home_y2" },
    Motor { section: "stepper_x1", key: "q", second: Some("x2"), home: "home_x2" },
    Motor { section: "stepper_z1", key: "r", second: Some("z2"), home: "" },
];

/// The settings that were found, and what was left out.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Imported {
    /// Lines of a machine's file.
    pub file: String,
    /// Sentences about what a person has to look at.
    pub notes: Vec<String>,
}

/// Sections with their values.
type Sections = BTreeMap<String, BTreeMap<String, String>>;

/// Reads the pins of a printer's configuration.
///
/// # Errors
/// It names no motor; in words.
pub fn read(text: &str) -> Result<Imported, String> {
    let mut import = Import { sections: sections(text), ..Import::default() };
    MOTORS.into_iter().for_each(|motor| import.motor(motor));
    if import.board.is_empty() {
        return Err(
            "this file names no motors: it has no section [stepper_x] with step_pin and dir_pin"
                .into(),
        );
    }
    import.enable();
    import.currents();
    import.leaves_out();
    Ok(import.told())
}

fn sections(text: &str) -> Sections {
    let (mut all, mut name) = (Sections::new(), String::new());
    for line in text.lines() {
        let line = line.split(['#', ';']).next().unwrap_or_default();
        if let Some(section) = line.trim().strip_prefix('[').and_then(|it| it.split(']').next()) {
            name = section.trim().to_owned();
            all.entry(name.clone()).or_default();
        } else if let Some((key, value)) = line.split_once([':', '=']) {
            let values = all.entry(name.clone()).or_default();
            values.insert(key.trim().to_lowercase(), value.trim().to_owned());
        }
    }
    all
}

/// An import under way.
#[derive(Default)]
struct Import {
    sections: Sections,
    /// Lines of the areas `board`, `motors`, `homing`, in order.
    board: Vec<String>,
    motors: Vec<String>,
    homing: Vec<String>,
    drivers: Vec<String>,
    /// Current, sense resistors and microsteps of motors with such drivers, in the order of [`Motor`]s of a machine.
    ///
    /// [`Motor`]: crate::settings::motors::Motor
    currents: [[f64; 6]; 3],
    /// Pins that give motors their current, each once.
    enables: Vec<String>,
    /// Steps a millimetre of X, Y, Z.
    per_unit: [Option<f64>; 3],
    notes: Vec<String>,
}

impl Import {
    fn motor(&mut self, Motor { section, key, second, home }: Motor) {
        let Some(values) = self.sections.get(section).cloned() else { return };
        let pin = |import: &mut Self, name: &str| {
            let told = values.get(name).cloned()?;
            import.pin(section, name, &told)
        };
        let (Some(step), Some(dir)) = (pin(self, "step_pin"), pin(self, "dir_pin")) else { return };
        self.board.push(format!("{key} = \"{step} {dir}\""));
        self.driver(section, key, &values);
        if let Some(second) = second {
            self.motors.push(format!("{second} = \"{key}\""));
        }
        if let Some(enable) = pin(self, "enable_pin").filter(|pin| !self.enables.contains(pin)) {
            self.enables.push(enable);
        }
        if !home.is_empty()
            && let Some(switch) = pin(self, "endstop_pin")
        {
            self.board.push(format!("{home} = \"{switch}\""));
            self.homes(section, &values);
        }
        self.steps(section, &values);
    }

    /// The driver of a motor, where the file tells of one with registers.
    fn driver(&mut self, section: &str, key: &str, values: &BTreeMap<String, String>) {
        let named = |(name, values): (&String, &BTreeMap<_, _>)| {
            let (kind, of) = name.split_once(' ')?;
            (of == section && kind.starts_with("tmc")).then(|| (kind.to_owned(), values.clone()))
        };
        let Some((kind, own)) = self.sections.iter().find_map(named) else { return };
        let mut words = vec![kind.clone()];
        for pin in ["uart_pin", "tx_pin", "cs_pin"] {
            let told = own.get(pin).cloned();
            words.extend(told.and_then(|told| self.pin(&kind, pin, &told)));
        }
        words.extend(own.get("uart_address").cloned());
        self.drivers.push(format!("{key} = \"{}\"", words.join(" ")));
        let bus = ["miso", "mosi", "sclk"].map(|it| own.get(&format!("spi_software_{it}_pin")));
        if let [Some(miso), Some(mosi), Some(sck)] = bus {
            let spi = format!("spi = \"{miso} {mosi} {sck}\"");
            if !self.drivers.contains(&spi) {
                self.drivers.push(spi);
            }
        }
        let number = |values: &BTreeMap<String, String>, key: &str| {
            values.get(key).and_then(|told| told.parse::<f64>().ok()).unwrap_or_default()
        };
        let place = ["x", "y", "z", "w", "q", "r"].iter().position(|it| *it == key);
        if let Some(place) = place {
            let [current, ohms, microsteps] = &mut self.currents;
            current[place] = number(&own, "run_current");
            ohms[place] = number(&own, "sense_resistor");
            microsteps[place] = number(values, "microsteps");
        }
    }

    /// The lines about all drivers together.
    fn currents(&mut self) {
        if self.drivers.is_empty() {
            return;
        }
        let [current, ohms, microsteps] = self.currents;
        let microsteps = microsteps.map(|many| if many > 0.0 { many } else { 16.0 });
        for (key, numbers) in [("current_a", current), ("ohms", ohms), ("microsteps", microsteps)] {
            self.drivers
                .push(format!("{key} = {numbers:?}").replace(".0,", ",").replace(".0]", "]"));
        }
    }

    /// Steps a millimetre: those of a turn by the way that it makes.
    fn steps(&mut self, section: &str, values: &BTreeMap<String, String>) {
        let number = |key: &str| values.get(key).and_then(|told| told.parse::<f64>().ok());
        let Some(axis) =
            ["stepper_x", "stepper_y", "stepper_z"].iter().position(|it| *it == section)
        else {
            return;
        };
        let turn = number("full_steps_per_rotation").unwrap_or(FULL_STEPS);
        let geared = values.get("gear_ratio").map_or(Some(1.0), |told| gear(told));
        let found = number("microsteps")
            .zip(number("rotation_distance").filter(|way_mm| *way_mm > 0.0))
            .zip(geared)
            .map(|((micro, way_mm), gear)| turn * micro * gear / way_mm);
        match found {
            Some(per_unit) => self.per_unit[axis] = Some(per_unit),
            None => self
                .notes
                .push(format!("{section}: its steps a millimetre are not told: measure them")),
        }
    }

    /// The axis has a home switch, at the end that the file says.
    fn homes(&mut self, section: &str, values: &BTreeMap<String, String>) {
        let Some(axis) = section.strip_prefix("stepper_").filter(|axis| axis.len() == 1) else {
            return;
        };
        let number = |key: &str| values.get(key).and_then(|told| told.parse::<f64>().ok());
        let most = number("position_max");
        let high = match values.get("homing_positive_dir").map(String::as_str) {
            Some(told) => told.eq_ignore_ascii_case("true"),
            None => number("position_endstop").zip(most).is_some_and(|(at, most)| at > 0.5 * most),
        };
        let end = if high { "high" } else { "low" };
        self.homing.push(format!("{axis} = {{ fitted = true, end = \"{end}\" }}"));
    }

    /// A pin in the board's own words; nothing where it is another board's, or no pin.
    fn pin(&mut self, section: &str, key: &str, told: &str) -> Option<String> {
        let signs: String =
            told.chars().take_while(|it| "!^~ ".contains(*it)).filter(|it| *it != ' ').collect();
        let name = told.trim_start_matches(['!', '^', '~', ' ']);
        if let Some((owner, _)) = name.split_once(':') {
            self.notes.push(format!(
                "{section}: {key} `{told}` is left out: {owner} is no pin of this board"
            ));
            return None;
        }
        let alias = self.alias(name);
        Some(format!("{signs}{}", alias.as_deref().unwrap_or(name)))
    }

    /// The pin behind a name of [board_pins].
    fn alias(&self, name: &str) -> Option<String> {
        let rows = self.sections.iter().filter(|(section, _)| section.starts_with("board_pins"));
        let texts = rows.flat_map(|(_, values)| values.values());
        let mut pairs =
            texts.flat_map(|text| text.split(',')).filter_map(|pair| pair.split_once('='));
        let (_, pin) = pairs.find(|(alias, _)| alias.trim() == name)?;
        Some(pin.trim().to_owned())
    }

    fn enable(&mut self) {
        if !self.enables.is_empty() {
            self.board.push(format!("enable = \"{}\"", self.enables.join(", ")));
        }
    }

    /// Tells what the printer has and this machine does not take over.
    fn leaves_out(&mut self) {
        for section in self.sections.keys() {
            let mut words = section.split_whitespace();
            let (kind, of) = (words.next().unwrap_or_default(), words.next().unwrap_or_default());
            if kind.starts_with("tmc") && !MOTORS.iter().any(|motor| motor.section == of) {
                self.notes.push(format!("{section}: {of} is no motor of this machine"));
            }
            if ["heater_bed", "extruder", "fan", "output_pin", "heater_fan"].contains(&kind) {
                self.notes
                    .push(format!("{section}: its pin may serve as an output: board.outputs"));
            }
        }
    }

    fn told(self) -> Imported {
        let mut file = String::from("units = \"mm\"\n");
        if self.per_unit.iter().any(Option::is_some) {
            let [x, y, z] = self.per_unit.map(|steps| steps.unwrap_or(100.0));
            let _ = writeln!(file, "[steps]\nper_unit = [{x}, {y}, {z}, 100, 100, 100]");
        }
        for (area, lines) in [
            ("motors", &self.motors),
            ("homing", &self.homing),
            ("board", &self.board),
            ("drivers", &self.drivers),
        ] {
            if !lines.is_empty() {
                let _ = writeln!(file, "[{area}]\n{}", lines.join("\n"));
            }
        }
        Imported { file, notes: self.notes }
    }
}

/// Turns of the motor for one of the axis: `80:20`, or several with commas.
fn gear(text: &str) -> Option<f64> {
    let pair = |pair: &str| {
        let (motor, axis) = pair.split_once(':')?;
        Some(motor.trim().parse::<f64>().ok()? / axis.trim().parse::<f64>().ok()?)
    };
    text.split(',').map(pair).product()
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    const CARTESIAN: &str = "[mcu]\nserial: /dev/serial/by-id/usb\n[stepper_x]\nstep_pin: PC2 # comment\n\
        dir_pin: !PB9\nenable_pin: !PC3\nmicrosteps: 16\nrotation_distance: 40\nendstop_pin: ^PA5\n\
        position_endstop: 0\nposition_max: 235\n[stepper_y]\nstep_pin = PB8\ndir_pin = PB7\nenable_pin = !PC3\n\
        microsteps = 16\nrotation_distance = 40\nendstop_pin = ^Y_STOP\nposition_endstop = 235\nposition_max = 235\n\
        [stepper_y1]\nstep_pin: PB3\ndir_pin: PB4\nenable_pin: !PC4\n[stepper_z]\nstep_pin: PB6\ndir_pin: !PB5\n\
        microsteps: 16\nrotation_distance: 8\ngear_ratio: 2:1\nendstop_pin: probe:z_virtual_endstop\n\
        [tmc2209 stepper_x]\nuart_pin: PA1\nrun_current: 0.58\n[tmc2209 extruder]\nuart_pin: PA1\n[board_pins]\naliases: X_STOP=PA5, Y_STOP=PA6\n[fan]\npin: PA0\n";

    fn check(text: &str, line: &str) {
        let file = read(text).unwrap().file;
        assert!(file.lines().any(|it| it == line), "{line}\n{file}");
    }

    #[test]
    fn motors_switches_and_steps_are_read() {
        check(CARTESIAN, "x = \"PC2 !PB9\"");
        check(CARTESIAN, "per_unit = [80, 80, 800, 100, 100, 100]");
        check(CARTESIAN, "home_x = \"^PA5\"");
        check(CARTESIAN, "home_y = \"^PA6\"");
        check(CARTESIAN, "y = { fitted = true, end = \"high\" }");
        check(CARTESIAN, "y2 = \"w\"");
        check(CARTESIAN, "w = \"PB3 PB4\"");
        check(CARTESIAN, "enable = \"!PC3, !PC4\"");
        check(CARTESIAN, "x = \"tmc2209 PA1\"");
        check(CARTESIAN, "current_a = [0.58, 0, 0, 0, 0, 0]");
        check(CARTESIAN, "microsteps = [16, 16, 16, 16, 16, 16]");
        let machine = crate::file::read(&"m.toml".into(), &read(CARTESIAN).unwrap().file).unwrap();
        assert_eq!(machine.board.motors[2], "PB6 !PB5");
        assert_eq!(machine.drivers.current_a[0], 0.58);
    }

    #[test]
    fn what_is_left_out_is_told() {
        let notes = read(CARTESIAN).unwrap().notes.join("\n");
        for part in
            ["probe is no pin", "extruder is no motor of this machine", "fan: its pin may serve"]
        {
            assert!(notes.contains(part), "{part}: {notes}");
        }
        assert!(read("[printer]\nkinematics: delta\n").unwrap_err().contains("names no motors"));
    }
}
