//! The settings as a part file.

use super::find;
use super::setting::plain;
use kerf_program::Settings;
use kerf_program::settings::Distance;

/// The settings as the lines of a part file that sets them, units first.
///
/// Locations are not among them (VA), nor what ends with a file (VO).
pub fn settings_lines(settings: &Settings) -> Vec<String> {
    let mut lines: Vec<String> = ["VD", "VB", "VC", "VI", "VL", "VN", "VH", "VP", "VR", "VS", "VU"]
        .into_iter()
        .filter_map(|letters| find(letters)?.present(settings))
        .collect();
    let relative = settings.distance == Distance::Relative;
    lines.push(if relative { "SR" } else { "SA" }.into());
    lines.push(format!("SW,{}", plain(settings.warning_s)));
    lines.push(format!("SO,4,{}", settings.io.output4));
    lines
}
