//! The bridge that a tag really leaves: the material between where the cut of a closed shape begins and where it ends.
//!
//! ```text
//!        end of the cut        tag        beginning          the tool is as wide as the cut: it takes half its
//!   ═══════════════════( ·─────────────· )════════════       width from the tag at each end, and leads take more
//!                       ╰─── bridge ────╯
//! ```

use crate::shape_paths::{Pass, ShapePath};
use crate::warning::Warning;
use kerf_drawing::{CutDepth, GroupSettings};
use kerf_geom::{Polyarc, PolyarcPlace};

/// Of a path, at the most this share belongs to one end of it.
const MOST_OF_A_PATH: f64 = 0.3;

/// Bridges narrower than this hold nothing, millimetres: rounding, far below what any saw blade leaves.
const NOTHING_MM: f64 = 1e-6;

/// Bridges that the tags of one group leave.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Bridges {
    /// The narrowest bridge of the group, its shape and its width, millimetres.
    narrowest: Option<(usize, f64)>,
    /// The first shape that nothing holds, with how much it lacks, millimetres.
    loose: Option<(usize, f64)>,
    /// Number of shapes that nothing holds.
    loose_count: usize,
    /// A shape with a tag, cut by a tool whose width nobody knows.
    unknown: Option<usize>,
}

impl Bridges {
    /// Looks at the paths of a closed shape whose group has a tag.
    pub fn look(&mut self, number: usize, paths: &[ShapePath], settings: &GroupSettings) {
        if settings.tag_mm == 0.0 {
            return;
        }
        let Some(width_mm) = settings.width_mm() else {
            self.unknown = self.unknown.or(Some(number));
            return;
        };
        let cuts = paths.iter().filter(|path| path.pass != Pass::Traversal);
        let gaps = cuts.filter_map(|path| gap_mm(path, settings.tag_mm));
        let Some(least) = gaps.min_by(f64::total_cmp) else { return };
        let left_mm = least - width_mm;
        if left_mm < NOTHING_MM {
            self.loose = self.loose.or(Some((number, -left_mm)));
            self.loose_count += 1;
        } else if self.narrowest.is_none_or(|(_, before)| left_mm < before) {
            self.narrowest = Some((number, left_mm));
        }
    }

    /// Returns the warnings of a group.
    pub fn told(&self, settings: &GroupSettings) -> Vec<Warning> {
        let tag = settings.tag_mm;
        let narrowest = self.narrowest.map(|(shape, left_mm)| {
            let text =
                format!("its tag of {tag} mm leaves a bridge of {left_mm:.1} mm between the walls");
            Warning::new(shape, text)
        });
        let unknown = self.unknown.map(|shape| {
            let text = format!(
                "its tag of {tag} mm leaves less by the width of the tool, which is not known: set the cutter of the group"
            );
            Warning::new(shape, text)
        });
        let loose = self.loose.map(|(shape, lacks_mm)| self.told_loose(shape, lacks_mm, settings));
        loose.into_iter().chain(narrowest).chain(unknown).collect()
    }

    fn told_loose(&self, shape: usize, lacks_mm: f64, settings: &GroupSettings) -> Warning {
        let tag = settings.tag_mm;
        let through = settings.height == CutDepth::Thru;
        let what =
            if through { "the part is loose" } else { "the part is loose where it is cut through" };
        let others = match self.loose_count - 1 {
            0 => String::new(),
            others => format!("; so are {others} more of the group"),
        };
        let leads = settings.lead_in.is_some() || settings.lead_out.is_some();
        let smaller = if leads { " or smaller leads" } else { "" };
        let text = format!(
            "its tag of {tag} mm leaves nothing between the walls, the tool and its leads are wider by {lacks_mm:.1} \
             mm: {what}{others}; take a longer tag{smaller}"
        );
        Warning::new(shape, text)
    }
}

/// The least distance between the middle of the tool where the cut begins and where it ends, leads included.
fn gap_mm(path: &ShapePath, tag_mm: f64) -> Option<f64> {
    let lead_mm = |name: &str| {
        let lead = path.leads.iter().find(|(lead, _)| *lead == name);
        lead.map_or(0.0, |(_, lead)| lead.length())
    };
    let (before, after) = (lead_mm("lead-in"), lead_mm("lead-out"));
    let long = path.path.length();
    let near = tag_mm.min(MOST_OF_A_PATH * (long - before - after));
    let beginning = piece(&path.path, 0.0, before + near)?;
    let end = piece(&path.path, long - after - near, long)?;
    let distances = beginning
        .segments()
        .flat_map(|a| end.segments().map(move |b| a.distance_to(&b)).collect::<Vec<_>>());
    distances.min_by(f64::total_cmp)
}

fn piece(path: &Polyarc, from_mm: f64, to_mm: f64) -> Option<Polyarc> {
    let place = |far: f64| -> Option<PolyarcPlace> { path.place_after(far) };
    let last = || {
        let segment = path.segment_count().checked_sub(1)?;
        Some(PolyarcPlace { segment, share: 1.0, at: path.end()? })
    };
    let to = if to_mm < path.length() { place(to_mm) } else { last() };
    Some(path.between(&place(from_mm)?, &to?))
}
