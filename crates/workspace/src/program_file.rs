//! Program files by their names: from the folders of the machine, else those that come with Kerf.

use kerf_files::{Disk, Folders, Purpose, Shipped, custom_name};
use kerf_program::{FileRequest, Folder, HostError};
use std::path::Path;

/// Files larger than this are no part files, bytes.
pub const MOST_BYTES: usize = 1 << 29;

/// A file that a program runs: from the folders, else one that comes with Kerf.
pub(crate) fn program_file(
    disk: &dyn Disk,
    folders: &Folders,
    request: &FileRequest,
) -> Result<(String, Vec<u8>), HostError> {
    let path = match folders.find(disk, request.folder, &request.name, Purpose::Read) {
        Ok(path) => path,
        Err(error @ HostError::NotFound(_)) => return shipped(request).ok_or(error),
        Err(error) => return Err(error),
    };
    let bytes = disk.read(&path).map_err(|e| cannot("read", &path, &e))?;
    if bytes.len() > MOST_BYTES {
        return Err(HostError::Refused(format!("{} is too large", path.display())));
    }
    Ok((path.display().to_string(), bytes))
}

/// A custom cut that comes with the program.
fn shipped(request: &FileRequest) -> Option<(String, Vec<u8>)> {
    let name = match request.folder {
        Folder::Custom => Some(request.name.as_str()),
        Folder::Parts | Folder::Settings | Folder::Media => None,
    };
    let name = name.map(str::to_owned).or_else(|| custom_name(&request.name))?;
    let file = Shipped::find(&name)?;
    Some((file.name.into(), file.text.into()))
}

/// Tells that something cannot be done with a file.
pub(crate) fn cannot(what: &str, path: &Path, error: &std::io::Error) -> HostError {
    HostError::Refused(format!("cannot {what} {}: {error}", path.display()))
}
