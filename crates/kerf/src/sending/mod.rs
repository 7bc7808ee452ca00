//! Job files sent to the computer at the machine, over a serial line or the network.

mod http;
mod line;
mod shown;

pub use http::{Sent, send_over_network};
pub use line::{Folder, receive_over_line, send_over_line};
pub use shown::Shown;

use crate::exit::{Exit, Usage};
use crate::transfer::State;
use anyhow::{Result, bail};
use kerf_machine::Configuration;

/// Target of a file that is sent, or source of one that comes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum To {
    /// One of the ports 1 to 4 of the settings; the one they name for file sending.
    Port(Option<usize>),
    /// A serial port by its path.
    Device(String),
    /// A server.
    Server(String),
}

impl To {
    /// Reads `com2`, `/dev/ttyUSB0` or `http://192.168.1.20:8710`; nothing when it is none of these.
    pub fn of(word: &str) -> Option<Self> {
        let port = word.get(..3).filter(|begin| begin.eq_ignore_ascii_case("com"));
        if port.is_some() && word.len() == 3 {
            return Some(Self::Port(None));
        }
        if let Some(number) = port.and_then(|_| word[3..].parse().ok()) {
            return Some(Self::Port(Some(number)));
        }
        if word.starts_with("http://") {
            return Some(Self::Server(word.to_owned()));
        }
        word.starts_with("/dev/").then(|| Self::Device(word.to_owned()))
    }

    /// The path of the port.
    pub fn device(&self, machine: &Configuration) -> Result<String> {
        match self {
            Self::Device(path) => Ok(path.clone()),
            Self::Port(number) => {
                let number = number.unwrap_or(usize::from(machine.options.send_port));
                let devices = &machine.options.devices;
                match devices.get(number.wrapping_sub(1)) {
                    Some(path) => Ok(path.clone()),
                    None => bail!(Usage(format!(
                        "there is no port {number}: file sending has the ports 1 to {}",
                        devices.len()
                    ))),
                }
            }
            Self::Server(url) => bail!(Usage(format!("{url} is no serial port"))),
        }
    }
}

/// Tells how a transfer ended, and returns that as an exit code.
pub fn ended(name: &str, state: &State) -> Exit {
    match state {
        State::Failed(why) => {
            eprintln!("kerf: {name}: {why}");
            Exit::Failed
        }
        State::Stopped => {
            eprintln!("kerf: {name}: stopped");
            Exit::Stopped
        }
        _ => Exit::Good,
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn ports_are_named_by_number_or_path() {
        let machine = Configuration::default();
        let device = |word| To::of(word).unwrap().device(&machine);
        assert_eq!(device("com2").unwrap(), "/dev/ttyS1");
        assert_eq!(device("com").unwrap(), "/dev/ttyS1");
        assert_eq!(device("COM4").unwrap(), "/dev/ttyS3");
        assert_eq!(device("/dev/ttyUSB0").unwrap(), "/dev/ttyUSB0");
        for none in ["com0", "com5"] {
            assert!(device(none).unwrap_err().to_string().contains("1 to 4"), "{none}");
        }
        assert_eq!((To::of("MX,2"), To::of("company.rsm")), (None, None));
    }
}
