//! Several machines in one server: each with an owner, a journal, devices and a page of its own.
//!
//! ```text
//!  kerf serve --machine shop --also laser
//!    shop   ── port 8710, STOP 8711 ── data folder
//!    laser  ── port 8712, STOP 8713 ── data folder/together/laser
//! ```
//!
//! They share the part folder, the custom cuts and the saved machines.

use super::ServeArgs;
use crate::data_args::{DataArgs, data_folder};
use crate::exit::Usage;
use crate::machine_choice::MachineChoice;
use crate::machine_name::MachineName;
use crate::named_machine::{self, Named};
use anyhow::{Result, bail};
use kerf_server::{ServedMachine, Server};
use std::collections::BTreeSet;
use std::net::SocketAddr;
use std::path::Path;

/// The folder of the other machines' data folders, in the data folder.
const FOLDER: &str = "together";

/// Ports of a machine: its page's, and that of STOP above it.
const PORTS: u16 = 2;

/// The machines that are served, the first one first, each with its name and the options of its server.
///
/// # Errors
/// A machine is named twice, there is none of a name, or there are too few ports.
pub fn machines(args: &ServeArgs) -> Result<Vec<(String, ServeArgs)>> {
    let mut all = vec![(args.place.machine.words(), args.clone())];
    for (n, name) in (1_u16..).zip(&args.also) {
        let listen = beside(args.listen, n)?;
        all.push((name.to_string(), other(args, name, listen)?));
    }
    let (mut names, mut folders, mut lines) = <(BTreeSet<_>, BTreeSet<_>, BTreeSet<_>)>::default();
    for (name, one) in &all {
        let line = one.place.machine.controller().map(|line| line.address.key());
        let is_new = names.insert(name) && folders.insert(&one.place.data.folder);
        if !is_new || line.is_some_and(|line| !lines.insert(line)) {
            bail!(Usage(format!("{name} is named twice: each machine is served once")));
        }
    }
    Ok(all)
}

/// Tells the pages of every machine about the others.
pub fn tell(all: &[(String, ServeArgs)], servers: &[&Server]) {
    if servers.len() < 2 {
        return;
    }
    for (n, server) in servers.iter().enumerate() {
        let one = |(at, ((name, _), other)): (usize, (&(String, ServeArgs), &&Server))| {
            ServedMachine { name: name.clone(), port: other.address.port(), here: at == n }
        };
        server.tell_together(all.iter().zip(servers).enumerate().map(one).collect());
    }
}

fn beside(address: SocketAddr, n: u16) -> Result<SocketAddr> {
    // Any port stays any port.
    let port = if address.port() == 0 {
        Some(0)
    } else {
        PORTS.checked_mul(n).and_then(|by| address.port().checked_add(by))
    };
    let Some(port) = port else {
        bail!(Usage(format!("there is no port for another machine behind {}", address.port())));
    };
    Ok(SocketAddr::new(address.ip(), port))
}

/// The options of another machine's server.
fn other(args: &ServeArgs, name: &MachineName, listen: SocketAddr) -> Result<ServeArgs> {
    let data = &args.place.data;
    let folder = data_folder(data)?;
    let mut place = args.place.clone();
    place.machine = MachineChoice::named(at_its_file(name, data)?, data)?;
    place.custom.get_or_insert_with(|| folder.join("custom"));
    place.data =
        DataArgs { folder: Some(folder.join(FOLDER).join(folder_name(&name.to_string()))) };
    let also = Vec::new();
    Ok(ServeArgs { file: None, listen, also, receive: false, line: None, place, ..args.clone() })
}

/// Saved machines lie in the first machine's data folder: here they are named by their files.
fn at_its_file(name: &MachineName, data: &DataArgs) -> Result<MachineName> {
    let MachineName::Configured(path) = name else { return Ok(name.clone()) };
    Ok(match named_machine::named(path, data)? {
        Named::File(file) => MachineName::Configured(std::path::absolute(file)?),
        Named::Ready(_) => name.clone(),
    })
}

/// A machine's name as that of a folder.
fn folder_name(name: &str) -> String {
    let word =
        Path::new(name).file_stem().and_then(|stem| stem.to_str()).filter(|_| !name.contains(':'));
    let sign = |sign: char| if sign.is_alphanumeric() || sign == '_' { sign } else { '-' };
    word.unwrap_or(name).chars().map(sign).collect()
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn a_machine_has_a_folder_of_its_name() {
        let check = |name, folder| assert_eq!(folder_name(name), folder);
        check("laser", "laser");
        check("shop/laser 2.toml", "laser-2");
        check("grbl:/dev/ttyUSB0", "grbl--dev-ttyUSB0");
        check("grbl:tcp:10.0.0.2:23", "grbl-tcp-10-0-0-2-23");
    }

    #[test]
    fn the_next_machine_is_two_ports_on() {
        let check = |port, n, next: Option<u16>| {
            let at = beside(SocketAddr::from(([127, 0, 0, 1], port)), n).ok();
            assert_eq!(at.map(|at| at.port()), next);
        };
        check(8710, 1, Some(8712));
        check(8710, 2, Some(8714));
        check(0, 1, Some(0));
        check(65_535, 1, None);
    }
}
