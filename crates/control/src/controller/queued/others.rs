//! The boards of a machine beside the first: their names and ports.

use super::pins::{FIRST, entries};
use kerf_transport::Address;
use std::path::Path;

/// The rate of a board on a serial line where none is named, baud; over USB it has no meaning.
const BAUD: u32 = 250_000;

/// The key of the machine's file.
const KEY: &str = "board.others";

/// Reads the port of a board: `PORT[@BAUD]`, and any address of the network.
///
/// # Errors
/// A rate or a port that is none, in words; an empty text where nothing is named.
pub fn address(port: &str) -> Result<Address, String> {
    let bare = !port.is_empty() && !port.contains('@') && !port.contains(':');
    if bare { Address::read(&format!("{port}@{BAUD}")) } else { Address::read(port) }
}

/// Reads the further boards of a machine: `tools /dev/ttyACM1, left /dev/ttyUSB0@500000`.
///
/// # Errors
/// An entry is no name with a port, or a name is given twice; in words.
pub fn read(text: &str) -> Result<Vec<(String, Address)>, String> {
    let mut boards: Vec<(String, Address)> = Vec::new();
    for entry in entries(text) {
        let wrong = || format!("{KEY}: \"{entry}\" is no name with its port: tools /dev/ttyACM1");
        let (name, port) = entry.split_once(char::is_whitespace).ok_or_else(wrong)?;
        let is_plain = name.chars().all(|c| c.is_ascii_alphanumeric() || "-_".contains(c));
        let port = port.trim();
        let port = port.strip_prefix("klipper:").unwrap_or(port);
        let address = address(port).ok().filter(|_| is_plain).ok_or_else(wrong)?;
        if name == FIRST || boards.iter().any(|(other, _)| other == name) {
            let named = "give each board a name of its own, and none of them main";
            return Err(format!("{KEY}: there is a board {name} already: {named}"));
        }
        boards.push((name.to_owned(), address));
    }
    Ok(boards)
}

/// Refuses two boards that are one, or that cannot be told apart, by the ports of all boards and the serial number behind
/// each.
///
/// # Errors
/// Two of them hang on one port, or have one serial number; in words.
pub fn refuse_twins(
    boards: &[(String, String)],
    serial_number: impl Fn(&str) -> Option<String>,
) -> Result<(), String> {
    for (n, (name, port)) in boards.iter().enumerate() {
        for (other, taken) in &boards[..n] {
            if device(port) == device(taken) {
                return Err(format!("boards {other} and {name} hang on one port, {port}"));
            }
            let serial = serial_number(port);
            if serial.is_some() && serial == serial_number(taken) {
                return Err(format!(
                    "boards {other} and {name} have one serial number, {}: they would be mixed up when they are plugged \
                     in anew; flash one with another number, or take a board of another kind",
                    serial.unwrap_or_default()
                ));
            }
        }
    }
    Ok(())
}

/// The device behind a port, whatever links lead there.
fn device(port: &str) -> String {
    let found = Path::new(port).canonicalize();
    found.map_or_else(|_| port.to_owned(), |path| path.display().to_string())
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn further_boards_are_names_with_ports() {
        let told = read("tools /dev/ttyACM1, left klipper:/dev/ttyUSB0@500000").unwrap();
        let told: Vec<_> = told.iter().map(|(name, port)| format!("{name} {port}")).collect();
        assert_eq!(told, ["tools /dev/ttyACM1@250000", "left /dev/ttyUSB0@500000"]);
        assert_eq!(read("").unwrap(), []);
    }

    #[test]
    fn mistakes_are_told() {
        let check = |text: &str, part: &str| {
            let why = read(text).unwrap_err();
            assert!(why.contains(part), "{text}: {why}");
        };
        check("tools", "no name with its port");
        check("to:ols /dev/ttyACM1", "no name with its port");
        check("tools /dev/ttyACM1@fast", "no name with its port");
        check("tools a, tools b", "there is a board tools already");
        check("main a", "there is a board main already");
    }

    #[test]
    fn two_names_of_one_port_are_one_board() {
        let folder = tempfile::tempdir().unwrap();
        let [port, link] = ["ttyACM0", "by-id"].map(|name| folder.path().join(name));
        std::fs::write(&port, "").unwrap();
        std::os::unix::fs::symlink(&port, &link).unwrap();
        let named = |name: &str, path: &Path| (name.to_owned(), path.display().to_string());
        let why =
            refuse_twins(&[named("main", &port), named("tools", &link)], |_| None).unwrap_err();
        assert!(why.contains("boards main and tools hang on one port"), "{why}");
        assert!(
            refuse_twins(
                &[named("main", &port), named("tools", &folder.path().join("no"))],
                |_| None
            )
            .is_ok()
        );
    }

    #[test]
    fn two_boards_with_one_serial_number_are_refused() {
        let boards = [("main", "a"), ("tools", "b")].map(|(name, port)| (name.into(), port.into()));
        let why = refuse_twins(&boards, |_| Some("1d50:614e 7".into())).unwrap_err();
        assert!(why.contains("boards main and tools have one serial number, 1d50:614e 7"), "{why}");
        assert!(refuse_twins(&boards, |port| Some(format!("1d50:614e {port}"))).is_ok());
        assert!(refuse_twins(&boards, |_| None).is_ok(), "ports that tell none");
    }
}
