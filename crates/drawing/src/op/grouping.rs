//! Groups: who belongs to which, and how each is cut (Profiler reference, "Groups").

use super::OpError;
use crate::{CutDepth, Editor, Group, GroupSettings, Lead, Shape};
use kerf_program::job::Plunge;
use serde::{Deserialize, Serialize};

/// A change of one setting of a group.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "setting", content = "value", rename_all = "kebab-case")]
pub enum Change {
    /// Its shapes are cut.
    On(bool),
    /// Its shapes only lead the head.
    Traversal(bool),
    /// The tool control output.
    Tool(u8),
    /// The tool cut output.
    Cut(u8),
    /// Highest cutting speed, mm/min; `None` is the machine's.
    Speed(Option<f64>),
    /// Depth of the cut. A depth that is not in millimetres ends multi-pass.
    Height(CutDepth),
    /// Depth of a pass, millimetres; `None` cuts in one.
    Pass(Option<f64>),
    /// Distance of the path, millimetres, positive right of travel.
    Offset(f64),
    /// Stock that a rough pass leaves, millimetres.
    Rough(f64),
    /// Both sides.
    DoubleLine(bool),
    /// Length that is left out at the start, millimetres.
    Tag(f64),
    /// The way onto the path.
    LeadIn(Lead),
    /// The way off the path.
    LeadOut(Lead),
    /// The way down into the material.
    Plunge(Plunge),
    /// Diameter of the cutter, millimetres; `None` is twice the offset.
    Cutter(Option<f64>),
}

impl Change {
    fn apply(self, to: &mut GroupSettings) {
        match self {
            Self::On(on) => to.on = on,
            Self::Traversal(on) => to.traversal = on,
            Self::Tool(tool) => to.tool = tool,
            Self::Cut(cut) => to.cut = cut,
            Self::Speed(speed) => to.speed_mm_min = speed,
            Self::Height(height) => {
                to.height = height;
                to.pass_mm = to.pass_mm.filter(|_| matches!(height, CutDepth::Mm(_)));
            }
            Self::Pass(pass) => to.pass_mm = pass,
            Self::Offset(offset) => to.offset_mm = offset,
            Self::Rough(rough) => to.rough_mm = rough,
            Self::DoubleLine(on) => to.double_line = on,
            Self::Tag(tag) => to.tag_mm = tag,
            Self::LeadIn(lead) => to.lead_in = lead,
            Self::LeadOut(lead) => to.lead_out = lead,
            Self::Plunge(plunge) => to.plunge = plunge,
            Self::Cutter(cutter) => to.cutter_mm = cutter,
        }
    }
}

pub(super) fn put(draft: &mut Editor, group: Group) -> Result<(), OpError> {
    draft.change_selected(|_, shape| Ok(Shape { group, ..shape.clone() }))
}

pub(super) fn copy(draft: &mut Editor, group: Group) -> Result<(), OpError> {
    draft.add_from_selected(|shape| Shape { group, ..shape.clone() })
}

pub(super) fn set(draft: &mut Editor, group: Group, changes: &[Change]) -> Result<(), OpError> {
    let settings = draft.drawing.settings_mut(group);
    changes.iter().for_each(|change| change.apply(settings));
    settings.check().map_err(|source| OpError::Setting { group, source })
}
