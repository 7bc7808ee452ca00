//! Files that hold a secret, or what nobody else has to know: only their owner reads and writes them.

use std::path::Path;

/// Makes an empty file where there is none, and takes it away from everybody but its owner. Whoever opens it afterwards
/// tells what is wrong with it; on systems without such permissions it is as any other file.
#[cfg(unix)]
pub fn make(path: &Path) {
    use std::fs;
    use std::os::unix::fs::OpenOptionsExt;
    drop(fs::File::options().create(true).truncate(false).write(true).mode(OWNER).open(path));
    keep(path);
    for ending in ["-wal", "-shm"] {
        keep(Path::new(&format!("{}{ending}", path.display())));
    }
}

#[cfg(not(unix))]
pub fn make(_: &Path) {}

/// Permissions of a file that its owner reads and writes, and nobody else.
#[cfg(unix)]
pub const OWNER: u32 = 0o600;

/// Takes an earlier file away from others. Who is not its owner leaves it as it is.
#[cfg(unix)]
pub fn keep(path: &Path) {
    use std::fs;
    use std::os::unix::fs::PermissionsExt;
    let others = |file: &fs::Metadata| file.permissions().mode() & 0o077 != 0;
    if fs::metadata(path).is_ok_and(|file| others(&file)) {
        drop(fs::set_permissions(path, fs::Permissions::from_mode(OWNER)));
    }
}

#[cfg(not(unix))]
pub fn keep(_: &Path) {}
