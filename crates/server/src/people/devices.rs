//! Devices that may connect over the network: paired by a code that is shown at the machine.
//!
//! A device keeps a token of 256 random bits; here only its hash is kept. Tokens and codes are compared
//! in constant time. Whoever tries a wrong code waits before the next one counts; the code stays good for others.

use super::Tries;
use crate::clock::Clock;
use crate::counted::{Counted, Found};
use crate::digested::{hash, hex};
use crate::locks::lock;
use kerf_files::{Disk, RealDisk};
use kerf_wire::Role;
use serde::{Deserialize, Serialize};
use std::io;
use std::net::{IpAddr, Ipv6Addr};
use std::path::Path;
use std::sync::Mutex;
use std::time::Duration;
use subtle::ConstantTimeEq;

/// A code can be used that long.
const VALID: Duration = Duration::from_secs(300);
/// Wrong codes are told at most so often.
const TELL: Duration = Duration::from_secs(1);
/// The list, in the data folder.
const FILE: &str = "devices.json";

/// Advice where there is no list.
const ANEW: &str =
    "No device is paired now: pair each anew, or end Kerf and put a copy of the list in its place";

/// Advice where the list is an older one.
const LOOK: &str = "Devices that were revoked since may be in it again, and others may be missing: look at the list of devices, \
                    and revoke what is not to drive the machine";

/// A paired device.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Device {
    /// Its number, by which it is revoked.
    pub number: u32,
    /// Its name.
    pub name: String,
    /// Its role.
    pub role: Role,
    /// Hash of its token.
    hash: String,
}

/// Reason why a device was not paired.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum PairError {
    /// Nobody shows a code.
    #[error("no code is shown at the machine, or it is too old: show a new one")]
    NoCode,
    /// Another code is shown.
    #[error("this is not the code that the machine shows")]
    Wrong {
        /// Number of wrong codes tried while this one was shown, where that is to be told now.
        tell: Option<u32>,
    },
    /// A wrong code came from there a moment ago.
    #[error("wrong codes were tried from this device: wait {0} s, then try again")]
    Wait(u64),
    /// The list cannot be written, or there is no randomness.
    #[error("the device cannot be entered")]
    Failed,
}

/// Paired devices, and the code that is shown.
#[derive(Debug)]
pub struct Devices {
    file: Counted,
    clock: Clock,
    inner: Mutex<Inner>,
}

#[derive(Debug, Default)]
struct Inner {
    devices: Vec<Device>,
    shown: Option<Shown>,
    /// Wrong codes, by the address that they came from.
    wrong: Tries<IpAddr>,
}

#[derive(Debug)]
struct Shown {
    code: String,
    role: Role,
    since: Duration,
    /// Wrong codes that were tried while it was shown.
    wrong: u32,
    /// Moment when that was told last.
    told: Option<Duration>,
}

impl Shown {
    /// A wrong code was tried; how many were, where that is to be told now.
    fn tried(&mut self, now: Duration) -> Option<u32> {
        self.wrong += 1;
        let due = self.told.is_none_or(|told| now.saturating_sub(told) >= TELL);
        due.then(|| {
            self.told = Some(now);
            self.wrong
        })
    }
}

impl Devices {
    /// Reads the list. One that is damaged is put aside; what is told of that, or of one that is gone or older, comes
    /// with it. Nobody is paired where there is none.
    ///
    /// # Errors
    /// Whatever the disk says.
    pub fn read(data: &Path, clock: Clock) -> io::Result<(Self, Option<String>)> {
        let file = Counted::secret(data.join(FILE));
        let (devices, told) = listed(&file)?;
        let inner = Mutex::new(Inner { devices, ..Inner::default() });
        Ok((Self { file, clock, inner }, told))
    }

    /// A new code for a device of a role.
    ///
    /// # Errors
    /// There is no randomness.
    pub fn show_code(&self, role: Role) -> Result<String, PairError> {
        let mut bytes = [0; 8];
        getrandom::fill(&mut bytes).map_err(|_| PairError::Failed)?;
        let code = format!("{:08}", u64::from_le_bytes(bytes) % 100_000_000);
        let since = self.clock.now();
        let shown = Shown { code: code.clone(), role, since, wrong: 0, told: None };
        lock(&self.inner).shown = Some(shown);
        Ok(code)
    }

    /// Pairs a device that names the code, from an address; gives its token.
    ///
    /// # Errors
    /// The code is another, or none is shown; or a wrong one came from there a moment ago.
    pub fn pair(
        &self,
        code: &str,
        name: &str,
        from: IpAddr,
    ) -> Result<(String, Device), PairError> {
        let (from, now) = (network(from), self.clock.now());
        let mut inner = lock(&self.inner);
        let Inner { shown, wrong, .. } = &mut *inner;
        let code_shown = shown.as_mut().filter(|shown| now.saturating_sub(shown.since) < VALID);
        let code_shown = code_shown.ok_or(PairError::NoCode)?;
        if let Some(seconds) = wrong.wait_s(&from, now) {
            return Err(PairError::Wait(seconds));
        }
        if !same(code_shown.code.as_bytes(), code.trim().as_bytes()) {
            wrong.wrong(&from, now);
            return Err(PairError::Wrong { tell: code_shown.tried(now) });
        }
        wrong.right(&from);
        let role = code_shown.role;
        *shown = None;
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

    /// Returns `true` if a device is still paired.
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
        RealDisk.make_folder(self.file.path().parent().unwrap_or(Path::new("")))?;
        self.file.write(&serde_json::to_vec_pretty(devices)?)
    }
}

/// A token of 256 random bits.
///
/// # Errors
/// There is no randomness.
pub(super) fn token() -> Result<String, PairError> {
    let mut bytes = [0; 32];
    getrandom::fill(&mut bytes).map_err(|_| PairError::Failed)?;
    Ok(hex(&bytes))
}

/// The network that an address belongs to, as far as one device has it to itself.
fn network(from: IpAddr) -> IpAddr {
    match from.to_canonical() {
        IpAddr::V6(v6) => Ipv6Addr::from_bits(v6.to_bits() >> 64 << 64).into(),
        v4 => v4,
    }
}

/// The devices of a list, and what is told of it.
fn listed(file: &Counted) -> io::Result<(Vec<Device>, Option<String>)> {
    let found = match file.read() {
        Err(why) if why.kind() == io::ErrorKind::InvalidData => return damaged(file, &why),
        found => found?,
    };
    let list = format!("{}, the list of paired devices,", file.path().display());
    let (bytes, told) = match found {
        Found::Nothing => return Ok((Vec::new(), None)),
        Found::Gone => return Ok((Vec::new(), Some(format!("{list} is gone. {ANEW}")))),
        Found::Newest(bytes) => (bytes, None),
        Found::Older(bytes) => (bytes, Some(format!("{list} is an older copy. {LOOK}"))),
    };
    match serde_json::from_slice(&bytes) {
        Ok(devices) => Ok((devices, told)),
        Err(why) => damaged(file, &why.into()),
    }
}

/// Puts a list aside that is none, and tells that.
fn damaged(file: &Counted, why: &io::Error) -> io::Result<(Vec<Device>, Option<String>)> {
    let aside = |n: u32| file.path().with_file_name(format!("{FILE}.broken-{n}"));
    let free = (1..).map(aside).find(|path| !path.exists());
    let free = free.ok_or(io::ErrorKind::AlreadyExists)?;
    file.put_aside(&free)?;
    let told = format!(
        "{}, the list of paired devices, cannot be read ({why}). It was put aside as {}. {ANEW}",
        file.path().display(),
        free.display()
    );
    Ok((Vec::new(), Some(told)))
}

/// Returns `true` if two texts are the same, in a time that does not tell where they differ.
pub(super) fn same<T: ConstantTimeEq>(a: &[T], b: &[T]) -> bool {
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
        let (devices, told) = Devices::read(dir.path(), Clock::default()).unwrap();
        assert_eq!(told, None);
        (dir, devices)
    }

    /// Address of the devices of a test.
    const DESK: IpAddr = IpAddr::V4(std::net::Ipv4Addr::new(192, 168, 1, 7));

    #[test]
    fn a_code_pairs_one_device_which_survives_and_can_be_revoked() {
        let (dir, devices) = devices();
        assert_eq!(devices.pair("1", "x", DESK).unwrap_err(), PairError::NoCode);
        let code = devices.show_code(Role::Operator).unwrap();
        let (token, device) = devices.pair(&format!(" {code} "), "tablet", DESK).unwrap();
        assert_eq!(devices.pair(&code, "again", DESK).unwrap_err(), PairError::NoCode);
        assert_eq!(devices.find(&token).unwrap().role, Role::Operator);
        let (again, _) = Devices::read(dir.path(), Clock::default()).unwrap();
        assert_eq!(again.find(&token), Some(device.clone()));
        assert_eq!(again.find("guess"), None);
        again.revoke(device.number).unwrap();
        assert_eq!((again.find(&token), again.has(device.number)), (None, false));
        assert_eq!(Devices::read(dir.path(), Clock::default()).unwrap().0.find(&token), None);
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
                devices.pair(&code, &format!("device {n}"), DESK).unwrap().0
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
        let (token, _) = devices.pair(&code, "desk", DESK).unwrap();
        let kept = std::fs::read_to_string(dir.path().join(FILE)).unwrap();
        assert!(!kept.contains(&token) && kept.contains("desk"));
    }

    #[test]
    fn a_code_is_not_guessed() {
        let (_dir, devices) = devices();
        let code = devices.show_code(Role::Owner).unwrap();
        let tries = |code: &str, from| devices.pair(code, "x", from).map(drop);
        assert_eq!(tries("wrong", DESK), Err(PairError::Wrong { tell: Some(1) }));
        for code in ["wrong", &code] {
            assert_eq!(tries(code, DESK), Err(PairError::Wait(1)), "not even the right one");
        }
    }

    #[test]
    fn a_code_ends_and_a_wait_is_over_also_while_the_computer_sleeps() {
        let (_dir, devices) = devices();
        let code = devices.show_code(Role::Owner).unwrap();
        devices.clock.forward(VALID * 9 / 10);
        assert!(matches!(devices.pair("wrong", "x", DESK), Err(PairError::Wrong { .. })));
        assert_eq!(devices.pair(&code, "x", DESK).unwrap_err(), PairError::Wait(1));
        devices.clock.forward(Duration::from_secs(2));
        assert!(devices.pair(&code, "x", DESK).is_ok());
        let code = devices.show_code(Role::Owner).unwrap();
        devices.clock.forward(VALID);
        assert_eq!(devices.pair(&code, "x", DESK).unwrap_err(), PairError::NoCode);
    }

    #[test]
    fn strangers_do_not_use_a_code_up() {
        let (_dir, devices) = devices();
        let code = devices.show_code(Role::Owner).unwrap();
        for n in 0..40 {
            let from = IpAddr::from([10, 0, 0, n]);
            let tried = devices.pair("00000000", "x", from);
            assert!(matches!(tried, Err(PairError::Wrong { .. })), "{n}: {tried:?}");
        }
        assert!(devices.pair(&code, "tablet", DESK).is_ok());
    }

    #[test]
    fn a_device_has_one_network_of_its_own() {
        let check = |from: &str, expected: &str| {
            assert_eq!(network(from.parse().unwrap()), expected.parse::<IpAddr>().unwrap());
        };
        check("192.168.1.7", "192.168.1.7");
        check("::ffff:192.168.1.7", "192.168.1.7");
        check("2001:db8:1:2:3:4:5:6", "2001:db8:1:2::");
    }

    #[test]
    fn a_list_that_is_none_is_put_aside_and_nobody_is_paired() {
        let (dir, devices) = devices();
        let file = dir.path().join(FILE);
        let code = devices.show_code(Role::Setter).unwrap();
        let (token, _) = devices.pair(&code, "desk", DESK).unwrap();
        let whole = std::fs::read(&file).unwrap();
        // A letter of the name became another: the list reads like one still.
        let mut flipped = whole.clone();
        let letter = whole.windows(4).position(|four| four == b"desk").unwrap();
        flipped[letter] ^= 1;
        for (n, broken) in [&b""[..], &whole[..whole.len() / 2], &flipped].iter().enumerate() {
            std::fs::write(&file, broken).unwrap();
            let (read, told) = Devices::read(dir.path(), Clock::default()).unwrap();
            assert_eq!((read.list().len(), read.find(&token)), (0, None));
            let aside = dir.path().join(format!("{FILE}.broken-{}", n + 1));
            assert_eq!(std::fs::read(&aside).unwrap(), *broken);
            assert!(told.unwrap().contains(&aside.display().to_string()));
        }
    }

    #[cfg(unix)]
    #[test]
    fn only_the_user_reads_the_list() {
        use std::os::unix::fs::PermissionsExt;
        let (dir, devices) = devices();
        let file = dir.path().join(FILE);
        std::fs::write(&file, "[]").unwrap();
        let code = devices.show_code(Role::Observer).unwrap();
        devices.pair(&code, "desk", DESK).unwrap();
        assert_eq!(std::fs::metadata(&file).unwrap().permissions().mode() & 0o777, 0o600);
    }
}
