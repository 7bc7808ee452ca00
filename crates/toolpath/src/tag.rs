//! Tags: what is left uncut at the beginning of a path, so that the part stays in its sheet.

use kerf_geom::{Polyarc, PolyarcPlace};

/// The path without its first `tag_mm`; the end stays where it is. Nothing when the path is no longer
/// than the tag (readings, P-43).
pub(crate) fn without_tag(path: &Polyarc, tag_mm: f64) -> Option<Polyarc> {
    if tag_mm == 0.0 {
        return Some(path.clone());
    }
    let last = path.segment_count().checked_sub(1)?;
    let from = path.place_after(tag_mm).filter(|_| tag_mm < path.length())?;
    let end = path.end()?;
    Some(path.between(&from, &PolyarcPlace { segment: last, share: 1.0, at: end }))
}
