//! Devices that may connect over the network: paired by a code that is shown at the machine.
//!
//! A device keeps a token of 256 random bits; here only its hash is kept. Tokens and codes are compared
//! in constant time.

use crate::app::{hash, hex, lock};
use kerf_control::files::{Disk, RealDisk};
use kerf_wire::Role;
use serde::{Deserialize, Serialize};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::time::{Duration, Instant};
use subtle::ConstantTimeEq;

/// A code can be used that long.
const VALID: Duration = Duration::from_secs(300);
/// Wrong codes until a new one has to be shown.
const TRIES: u32 = 5;
/// The list, in the data folder.
const FILE: &str = "devices.json";

/// A paired device.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Device {
    /// Its number, by which it is revoked.
    pub number: u32,
    /// Its name.
    pub name: String,
    /// What it may do.
    pub role: Role,
    /// Hash of its token.
    hash: String,
}

/// Why a device was not paired.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum PairError {
    /// Nobody shows a code.
    #[error("no code is shown at the machine, or it is too old: show a new one")]
    NoCode,
    /// Another code is shown.
    #[error("this is not the code that the machine shows")]
    Wrong,
    /// The list cannot be written, or there is no randomness.
    #[error("the device cannot be entered")]
    Failed,
}

/// Paired devices, and the code that is shown.
#[derive(Debug)]
pub struct Devices {
    file: PathBuf,
    inner: Mutex<Inner>,
}

#[derive(Debug, Default)]
struct Inner {
    devices: Vec<Device>,
    shown: Option<Shown>,
}

#[derive(Debug)]
struct Shown {
    code: String,
    role: Role,
    since: Instant,
    tries: u32,
}

impl Devices {
    /// Reads the list; a missing one is empty.
    ///
    /// # Errors
    /// Whatever the disk says, or that the list is none.
    pub fn read(data: &Path) -> io::Result<Self> {
        let file = data.join(FILE);
        let devices = if file.is_file() {
            serde_json::from_slice(&RealDisk.read(&file)?)?
        } else {
            Vec::new()
        };
        Ok(Self { file, inner: Mutex::new(Inner { devices, shown: None }) })
    }

    /// A new code for a device of a role.
    ///
    /// # Errors
    /// There is no randomness.
    pub fn show_code(&self, role: Role) -> Result<String, PairError> {
        let mut bytes = [0; 8];
        getrandom::fill(&mut bytes).map_err(|_| PairError::Failed)?;
        let code = format!("{:08}", u64::from_le_bytes(bytes) % 100_000_000);
        let shown = Shown { code: code.clone(), role, since: Instant::now(), tries: 0 };
        lock(&self.inner).shown = Some(shown);
        Ok(code)
    }

    /// Pairs a device that names the code; gives its token.
    ///
    /// # Errors
    /// The code is another, or none is shown.
    pub fn pair(&self, code: &str, name: &str) -> Result<(String, Device), PairError> {
        let mut inner = lock(&self.inner);
        let shown = inner.shown.as_mut().filter(|shown| shown.since.elapsed() < VALID);
        let shown = shown.ok_or(PairError::NoCode)?;
        if !same(shown.code.as_bytes(), code.trim().as_bytes()) {
            shown.tries += 1;
            if shown.tries >= TRIES {
                inner.shown = None;
            }
            return Err(PairError::Wrong);
        }
        let role = shown.role;
        inner.shown = None;
        let token = token()?;
        let number = inner.devices.iter().map(|d| d.number).max().unwrap_or(0) + 1;
        let name: String = name.chars().filter(|c| !c.is_control()).take(40).collect();
        let device = Device { number, name, role, hash: hash(token.as_bytes()) };
        inner.devices.push(device.clone());
        self.write(&inner.devices).map_err(|_| PairError::Failed)?;
        Ok((token, device))
    }

    /// The device with a token. Every device is looked at, so that time tells nothing.
    pub fn find(&self, token: &str) -> Option<Device> {
        let given = hash(token.as_bytes());
        let inner = lock(&self.inner);
        let mut found = None;
        for device in &inner.devices {
            if same(device.hash.as_bytes(), given.as_bytes()) {
                found = Some(device.clone());
            }
        }
        found
    }

    /// Whether a device is still paired.
    pub fn has(&self, number: u32) -> bool {
        lock(&self.inner).devices.iter().any(|device| device.number == number)
    }

    /// All devices: number, name, role.
    pub fn list(&self) -> Vec<(u32, String, Role)> {
        let inner = lock(&self.inner);
        inner.devices.iter().map(|d| (d.number, d.name.clone(), d.role)).collect()
    }

    /// Takes a device off the list: its token is worth nothing from now on.
    ///
    /// # Errors
    /// Whatever the disk says.
    pub fn revoke(&self, number: u32) -> io::Result<()> {
        let mut inner = lock(&self.inner);
        inner.devices.retain(|device| device.number != number);
        self.write(&inner.devices)
    }

    fn write(&self, devices: &[Device]) -> io::Result<()> {
        RealDisk.make_folder(self.file.parent().unwrap_or(Path::new("")))?;
        RealDisk.write(&self.file, &serde_json::to_vec_pretty(devices)?)
    }
}

fn token() -> Result<String, PairError> {
    let mut bytes = [0; 32];
    getrandom::fill(&mut bytes).map_err(|_| PairError::Failed)?;
    Ok(hex(&bytes))
}

/// Whether two texts are the same, in a time that does not tell where they differ.
fn same<T: ConstantTimeEq>(a: &[T], b: &[T]) -> bool {
    a.ct_eq(b).into()
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use std::cell::Cell;
    use subtle::Choice;

    fn devices() -> (tempfile::TempDir, Devices) {
        let dir = tempfile::tempdir().unwrap();
        let devices = Devices::read(dir.path()).unwrap();
        (dir, devices)
    }

    #[test]
    fn a_code_pairs_one_device_which_survives_and_can_be_revoked() {
        let (dir, devices) = devices();
        assert_eq!(devices.pair("1", "x").unwrap_err(), PairError::NoCode);
        let code = devices.show_code(Role::Operator).unwrap();
        let (token, device) = devices.pair(&format!(" {code} "), "tablet").unwrap();
        assert_eq!(devices.pair(&code, "again").unwrap_err(), PairError::NoCode);
        assert_eq!(devices.find(&token).unwrap().role, Role::Operator);
        let again = Devices::read(dir.path()).unwrap();
        assert_eq!(again.find(&token), Some(device.clone()));
        assert_eq!(again.find("guess"), None);
        again.revoke(device.number).unwrap();
        assert_eq!((again.find(&token), again.has(device.number)), (None, false));
        assert_eq!(Devices::read(dir.path()).unwrap().find(&token), None);
    }

    /// A byte that counts how often it is compared, and that can be compared in no other way.
    struct Counted<'a>(u8, &'a Cell<usize>);

    impl ConstantTimeEq for Counted<'_> {
        fn ct_eq(&self, other: &Self) -> Choice {
            self.1.set(self.1.get() + 1);
            self.0.ct_eq(&other.0)
        }
    }

    #[test]
    fn every_byte_is_compared_wherever_the_first_difference_is() {
        let counter = Cell::new(0);
        let bytes = |text: &[u8]| text.iter().map(|&b| Counted(b, &counter)).collect::<Vec<_>>();
        let shown = bytes(b"48210957");
        for (given, is) in
            [("48210957", true), ("08210957", false), ("48219957", false), ("48210950", false)]
        {
            counter.set(0);
            assert_eq!(same(&shown, &bytes(given.as_bytes())), is, "{given}");
            assert_eq!(counter.get(), shown.len(), "{given}: as many as there are");
        }
        assert!(!same(&shown, &bytes(b"4821095")), "a shorter one is another");
    }

    #[test]
    fn every_device_is_looked_at_and_the_right_one_is_found() {
        let (_dir, devices) = devices();
        let tokens: Vec<String> = (0..4)
            .map(|n| {
                let code = devices.show_code(Role::Observer).unwrap();
                devices.pair(&code, &format!("device {n}")).unwrap().0
            })
            .collect();
        for (n, token) in tokens.iter().enumerate() {
            assert_eq!(devices.find(token).unwrap().name, format!("device {n}"));
            let mut near = token.clone();
            near.replace_range(63.., if token.ends_with('0') { "1" } else { "0" });
            assert_eq!(devices.find(&near), None, "one digit off");
        }
    }

    #[test]
    fn the_token_itself_is_not_kept() {
        let (dir, devices) = devices();
        let code = devices.show_code(Role::Setter).unwrap();
        let (token, _) = devices.pair(&code, "desk").unwrap();
        let kept = std::fs::read_to_string(dir.path().join(FILE)).unwrap();
        assert!(!kept.contains(&token) && kept.contains("desk"));
    }

    #[test]
    fn a_code_is_not_guessed() {
        let (_dir, devices) = devices();
        let code = devices.show_code(Role::Owner).unwrap();
        for _ in 0..TRIES {
            assert_eq!(devices.pair("wrong", "x").unwrap_err(), PairError::Wrong);
        }
        assert_eq!(devices.pair(&code, "x").unwrap_err(), PairError::NoCode);
    }
}
