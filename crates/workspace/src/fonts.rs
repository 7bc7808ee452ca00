//! The fonts of this computer, by name: what the Typesetter carves.

use crate::Workspace;
use std::path::{Path, PathBuf};

/// The folder of fonts in the data folder.
const FOLDER: &str = "fonts";

/// Folders of a folder of fonts are looked through so deep.
const DEEPEST: u32 = 4;

/// So many fonts are named when the wanted one is not among them.
const NAMED: usize = 12;

/// A font file by the words of its name: `DejaVu Sans Bold` is DejaVuSans-Bold.ttf.
fn plain(name: &str) -> String {
    let letters = name.chars().filter(|c| c.is_alphanumeric()).flat_map(char::to_lowercase);
    let plain: String = letters.collect();
    plain.strip_suffix("regular").map_or(plain.clone(), str::to_owned)
}

/// The name of a font file; nothing for other files.
fn font_name(file: &str) -> Option<&str> {
    let (stem, ending) = file.rsplit_once('.')?;
    ["ttf", "otf", "ttc"].iter().any(|known| ending.eq_ignore_ascii_case(known)).then_some(stem)
}

/// Lists the folders where systems keep their fonts.
fn system_folders() -> Vec<PathBuf> {
    let home = std::env::var_os("HOME").map(PathBuf::from);
    let of_home = [".local/share/fonts", ".fonts", "Library/Fonts"];
    let own = home.into_iter().flat_map(|home| of_home.map(|folder| home.join(folder)));
    let windows = std::env::var_os("WINDIR").map(|folder| PathBuf::from(folder).join("Fonts"));
    let shared =
        ["/usr/share/fonts", "/usr/local/share/fonts", "/Library/Fonts", "/System/Library/Fonts"];
    own.chain(windows).chain(shared.map(PathBuf::from)).collect()
}

/// The file of a font: of the data folder, of this computer, or the one that comes with Kerf.
///
/// # Errors
/// There is none of that name; some that there are.
pub fn font(workspace: &Workspace, name: &str) -> Result<Vec<u8>, String> {
    let wanted = plain(name);
    let mut known = Vec::new();
    let own = workspace.data_folder(FOLDER);
    for folder in std::iter::once(own).chain(system_folders()) {
        if let Some(bytes) = font_below(workspace, &folder, &wanted, DEEPEST, &mut known) {
            return Ok(bytes);
        }
    }
    for (stem, bold) in [("Roboto", false), ("Roboto Bold", true)] {
        if plain(stem) == wanted {
            return Ok(kerf_preview::font_file(bold).to_vec());
        }
        known.push(stem.to_owned());
    }
    known.sort();
    known.dedup();
    let more = known.len().saturating_sub(NAMED);
    known.truncate(NAMED);
    let more = if more > 0 { format!(" and {more} more") } else { String::new() };
    Err(format!("there is no font {name} on this computer; there are {}{more}", known.join(", ")))
}

fn font_below(
    workspace: &Workspace,
    folder: &Path,
    wanted: &str,
    depth: u32,
    known: &mut Vec<String>,
) -> Option<Vec<u8>> {
    if depth == 0 {
        return None;
    }
    for name in workspace.names_in(folder) {
        let path = folder.join(&name);
        match font_name(&name) {
            Some(stem) if plain(stem) == wanted => {
                if let Some(bytes) = workspace.bytes_of(&path) {
                    return Some(bytes);
                }
            }
            Some(stem) => known.push(stem.to_owned()),
            None => {
                let found = font_below(workspace, &path, wanted, depth - 1, known);
                if found.is_some() {
                    return found;
                }
            }
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_font_is_known_by_the_words_of_its_name() {
        for (name, file) in [
            ("DejaVu Sans Bold", "DejaVuSans-Bold"),
            ("roboto", "Roboto-Regular"),
            ("Times_New_Roman", "times new roman"),
        ] {
            assert_eq!(plain(name), plain(file));
        }
        assert_eq!(font_name("Serif.TTF"), Some("Serif"));
        assert_eq!((font_name("fonts.dir"), font_name("truetype")), (None, None));
    }
}
