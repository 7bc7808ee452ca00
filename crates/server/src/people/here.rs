//! Tells who sits at the machine, when others may connect as well.
//!
//! A connection from this computer may come from anybody beyond a relay. So the owner has a token: in the address
//! that is printed at the start, and in a file that only the user can read, for commands beside the server.

use super::devices::{same, token};
use kerf_files::{Disk, RealDisk, write_private};
use std::io;
use std::path::Path;

/// The file of the token, in the data folder; `kerf send` and others look for it there.
pub const FILE: &str = "server.token";

/// The token of whoever sits at the machine. It stays the same, so that browsers find their way in again.
pub struct Here {
    token: String,
}

impl Here {
    /// The token of the data folder; a new one where there is none, or others could have read it.
    ///
    /// # Errors
    /// Whatever the disk says, or there is no randomness.
    pub fn of(data: &Path) -> io::Result<Self> {
        let file = data.join(FILE);
        if let Some(token) = kept(&file) {
            return Ok(Self { token });
        }
        let token =
            token().map_err(|_| io::Error::other("this computer gives no random numbers"))?;
        RealDisk.make_folder(data)?;
        write_private(&file, token.as_bytes())?;
        Ok(Self { token })
    }

    /// The token.
    pub fn token(&self) -> &str {
        &self.token
    }

    /// Returns `true` if this is the token.
    pub fn is(&self, given: &str) -> bool {
        same(self.token.as_bytes(), given.as_bytes())
    }
}

/// The token that a file holds, if it is one and only this user can read it.
fn kept(file: &Path) -> Option<String> {
    if others_read(file) {
        return None;
    }
    let text = String::from_utf8(RealDisk.read(file).ok()?).ok()?;
    let text = text.trim();
    let whole = text.len() == 64 && text.bytes().all(|byte| byte.is_ascii_hexdigit());
    whole.then(|| text.to_owned())
}

#[cfg(unix)]
fn others_read(file: &Path) -> bool {
    use std::os::unix::fs::PermissionsExt;
    std::fs::metadata(file).is_ok_and(|is| is.permissions().mode() & 0o077 != 0)
}

#[cfg(not(unix))]
fn others_read(_: &Path) -> bool {
    false
}

#[cfg(all(test, unix))]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use std::fs::{self, Permissions};
    use std::os::unix::fs::PermissionsExt;

    #[test]
    fn the_token_stays_and_only_the_user_reads_it() {
        let dir = tempfile::tempdir().unwrap();
        let (data, file) = (dir.path().join("data"), dir.path().join("data").join(FILE));
        let first = Here::of(&data).unwrap();
        assert_eq!(fs::metadata(&file).unwrap().permissions().mode() & 0o777, 0o600);
        assert_eq!(fs::read_to_string(&file).unwrap(), first.token());
        let again = Here::of(&data).unwrap();
        assert!(again.is(first.token()) && !again.is("") && !again.is("guess"));
    }

    #[test]
    fn a_token_that_others_could_read_or_that_is_none_is_made_anew() {
        let dir = tempfile::tempdir().unwrap();
        let file = dir.path().join(FILE);
        let spoils: [fn(&Path); 3] = [
            |file| fs::set_permissions(file, Permissions::from_mode(0o644)).unwrap(),
            |file| fs::write(file, "").unwrap(),
            |file| fs::write(file, "half").unwrap(),
        ];
        for spoil in spoils {
            let before = Here::of(dir.path()).unwrap();
            spoil(&file);
            let after = Here::of(dir.path()).unwrap();
            assert!(!after.is(before.token()));
            assert_eq!(fs::metadata(&file).unwrap().permissions().mode() & 0o777, 0o600);
        }
    }
}
