//! The part files of a folder, as the dialogs of FP, FG and FS show them.

use crate::Workspace;
use kerf_sbp::Header;
use std::io;

/// Contents of a folder, in order of names.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Listing {
    /// The folders in it.
    pub folders: Vec<String>,
    /// The files that the search mask lets through.
    pub files: Vec<PartFile>,
}

/// A file of the part folder.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PartFile {
    /// Its name.
    pub name: String,
    /// Header that tells about the job, if the file has one.
    pub header: Option<Header>,
}

/// Lists the part folder.
///
/// # Errors
/// Whatever the disk says.
pub fn listing(workspace: &Workspace) -> io::Result<Listing> {
    let mut listing = Listing::default();
    for name in workspace.names()?.into_iter().filter(|name| !name.starts_with('.')) {
        if workspace.is_folder(&name) {
            listing.folders.push(name);
        } else if fits(workspace.mask(), &name) {
            let header = workspace.text(&name).and_then(|text| Header::read(&text));
            listing.files.push(PartFile { name, header });
        }
    }
    Ok(listing)
}

/// Tells whether a search mask lets a name through, in any case: `*` stands for any characters, `?` for one.
pub fn fits(mask: &str, name: &str) -> bool {
    let fold = |text: &str| text.to_lowercase().chars().collect::<Vec<_>>();
    // To DOS a name without a point has an empty extension.
    mask == "*.*" || matches(&fold(mask), &fold(name))
}

/// Goes on behind the last `*` whenever the rest does not fit: linear but for the length of the mask.
fn matches(mask: &[char], name: &[char]) -> bool {
    let (mut m, mut n, mut star) = (0, 0, None);
    while n < name.len() {
        match mask.get(m) {
            Some('*') => {
                star = Some((m + 1, n));
                m += 1;
            }
            Some(c) if *c == '?' || *c == name[n] => (m, n) = (m + 1, n + 1),
            _ => {
                let Some((behind, from)) = star else { return false };
                star = Some((behind, from + 1));
                (m, n) = (behind, from + 1);
            }
        }
    }
    mask[m..].iter().all(|c| *c == '*')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sbp_file_fs_mask() {
        let check = |mask: &str, yes: &[&str], no: &[&str]| {
            yes.iter().for_each(|name| assert!(fits(mask, name), "{mask} {name}"));
            no.iter().for_each(|name| assert!(!fits(mask, name), "{mask} {name}"));
        };
        check("*.sb?", &["demo.sbp", "MINE.SBD", "a.b.sbc"], &["demo.txt", "demo.sb", "sbp"]);
        check("*.*", &["a.b", "readme"], &[]);
        check("proj??.sbp", &["proj12.sbp"], &["proj1.sbp", "project.sbp", "xproj12.sbp"]);
        check("*a*b", &["ab", "xaxaxb"], &["xaxbx", ""]);
        check("", &[""], &["a"]);
    }
}
