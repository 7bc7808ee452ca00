//! The name of a machine, as `--machine` takes it: the simulated one, a controller at its port, or what says how a
//! machine is set up.

use kerf_control::controller::queued;
use kerf_driver_linuxcnc as linuxcnc;
use kerf_transport::Address;
use std::fmt;
use std::path::{Path, PathBuf};

/// The driver of boards with step queues.
const KLIPPER: &str = "klipper";

/// The driver of LinuxCNC.
const LINUXCNC: &str = "linuxcnc";

/// The word for this computer, where a bridge is started.
const LOCAL: &str = "local";

/// Interpreters that run the bridge, the first one that is there: that of the system knows the module of LinuxCNC.
const PYTHONS: [&str; 2] = ["/usr/bin/python3", "python3"];

/// The ending of files that say how a machine is set up.
const ENDING: &str = "toml";

/// Ways to name a controller.
const CONTROLLERS: &str = "grbl:/dev/ttyUSB0, or grbl:/dev/ttyUSB0@250000 with another rate, grbl:tcp:HOST or \
     grbl:ws:HOST in the network";

/// The way to name a board with step queues.
const BOARDS: &str = "klipper:/dev/ttyACM0, or klipper:/dev/ttyUSB0@250000 on a serial line";

/// Ways to name LinuxCNC.
const BRIDGES: &str = "linuxcnc:local on this computer, or linuxcnc:HOST, where its bridge listens";

/// One name of a machine.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum MachineName {
    /// The simulated machine.
    Sim,
    /// A real controller.
    Controller(DriverName),
    /// A configuration: a file, a saved machine of the data folder, or a ready-made one.
    Configured(PathBuf),
}

impl MachineName {
    /// Reads `sim`, `grbl:PORT[@BAUD]`, `grbl:tcp:HOST[:PORT]`, `grbl:ws:HOST[:PORT]`, `linuxcnc:HOST[:PORT]`, or the name of a configuration.
    ///
    /// # Errors
    /// A driver that does not exist, or one without its port; the text tells how it is named.
    pub fn read(words: &str) -> Result<Self, String> {
        let configured = || Ok(Self::Configured(words.into()));
        if Path::new(words).extension().is_some_and(|it| it.eq_ignore_ascii_case(ENDING)) {
            return configured();
        }
        match words.split_once(':') {
            Some((driver, port)) if driver.len() > 1 => {
                DriverName::read(words, driver, port).map(Self::Controller)
            }
            None if words == "sim" => Ok(Self::Sim),
            None if words == "grbl" => Err(format!("grbl needs its port: {CONTROLLERS}")),
            None if words == KLIPPER => Err(format!("klipper needs its port: {BOARDS}")),
            None if words == LINUXCNC => Err(format!("linuxcnc needs its host: {BRIDGES}")),
            None if words.is_empty() => Err(format!("name a machine: sim, or {CONTROLLERS}")),
            _ => configured(),
        }
    }
}

impl fmt::Display for MachineName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Sim => f.write_str("sim"),
            Self::Controller(name) => name.fmt(f),
            Self::Configured(path) => path.display().fmt(f),
        }
    }
}

/// A driver and the line on which its controller hangs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DriverName {
    /// The whole name, as it was given.
    pub words: String,
    /// The line.
    pub address: Address,
}

impl DriverName {
    /// Returns `true` for a board with step queues, which is told each step.
    pub fn is_board(&self) -> bool {
        self.words.starts_with(KLIPPER)
    }

    /// A board with step queues at an address.
    pub fn of_board(address: &Address) -> Self {
        Self { words: format!("{KLIPPER}:{}", address.key()), address: address.clone() }
    }

    /// Returns `true` for LinuxCNC behind its bridge.
    pub fn is_linuxcnc(&self) -> bool {
        self.words.starts_with(LINUXCNC)
    }

    fn read(words: &str, driver: &str, port: &str) -> Result<Self, String> {
        let (read, needs) = match driver {
            "grbl" => (Address::read(port), format!("port: {CONTROLLERS}")),
            KLIPPER => (queued::address(port), format!("port: {BOARDS}")),
            LINUXCNC => (bridge(port), format!("host: {BRIDGES}")),
            _ => {
                let drivers = "only grbl, klipper and linuxcnc";
                return Err(format!("there is no driver '{driver}', {drivers}: {CONTROLLERS}"));
            }
        };
        let needs = format!("{driver} needs its {needs}");
        let address = read.map_err(|why| if why.is_empty() { needs } else { why })?;
        Ok(Self { words: words.to_owned(), address })
    }
}

/// The address of a bridge to LinuxCNC: a program that is started here, or one that listens at a host.
fn bridge(host: &str) -> Result<Address, String> {
    if host.is_empty() {
        return Err(String::new());
    }
    if host != LOCAL {
        return Address::tcp(host, linuxcnc::PORT);
    }
    let [system, any] = PYTHONS;
    let python = if Path::new(system).exists() { system } else { any };
    let words = [python, "-u", "-c", linuxcnc::BRIDGE].map(str::to_owned).into();
    Ok(Address::Program { name: format!("{LINUXCNC}:{LOCAL}"), words })
}

impl fmt::Display for DriverName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.words)
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn controllers_are_named_with_port_and_rate() {
        let check = |words: &str, address: &str| {
            let read = MachineName::read(words).unwrap();
            let MachineName::Controller(name) = &read else { panic!("{words} is a controller") };
            assert_eq!(
                (name.address.to_string().as_str(), read.to_string().as_str()),
                (address, words)
            );
        };
        check("grbl:/dev/ttyUSB0", "/dev/ttyUSB0@115200");
        check("grbl:COM3@250000", "COM3@250000");
        check("grbl:tcp:10.0.0.2", "tcp:10.0.0.2:23");
        check("klipper:/dev/ttyACM0", "/dev/ttyACM0@250000");
        check("klipper:/dev/ttyUSB0@500000", "/dev/ttyUSB0@500000");
        check("grbl:ws:router.local:80", "ws:router.local:80/");
        check("linuxcnc:10.0.0.2", "tcp:10.0.0.2:5107");
        check("linuxcnc:mill:5200", "tcp:mill:5200");
        check("linuxcnc:local", "linuxcnc:local");
    }

    #[test]
    fn configurations_are_files_and_names() {
        for words in ["mine.toml", "C:\\shop\\mine.toml", "C:mine", "router-96x48", "a:b.TOML"] {
            assert_eq!(MachineName::read(words), Ok(MachineName::Configured(words.into())));
        }
    }

    #[test]
    fn every_name_is_shown_as_it_is_read() {
        for words in ["sim", "grbl:COM3@250000", "router-96x48"] {
            assert_eq!(MachineName::read(words).unwrap().to_string(), words);
        }
    }

    #[test]
    fn a_wrong_name_is_refused_with_the_mend() {
        let check = |words, mend: &str| {
            let why = MachineName::read(words).unwrap_err();
            assert!(why.contains(mend), "{words}: {why}");
        };
        check("grbl", "grbl:/dev/ttyUSB0");
        check("grbl:", "grbl:/dev/ttyUSB0");
        check("klipper:", "klipper:/dev/ttyACM0");
        check("grbl:@9600", "grbl needs its port");
        check("grbl:COM3@fast", "'fast' is no rate");
        check("grbl:COM3@0", "'0' is no rate");
        check("grbl:tcp:10.0.0.2:x", "'x' is no port of the network");
        check("grbl:ws:", "grbl:ws:HOST");
        check("linuxcnc:", "linuxcnc:local");
        check("linuxcnc", "linuxcnc:HOST");
        check("marlin:x", "there is no driver 'marlin', only grbl, klipper and linuxcnc");
        check("", "name a machine: sim");
    }
}
