//! The groups of a clearing: one for its paths, and one that is off for the outlines they came from.

use super::OpError;
use super::clear::Clearing;
use crate::{CutDepth, Drawing, Group, GroupSettings, Lead};
use std::sync::Arc;

/// A group in which paths are cut as they are, by the cutter that clears, as deep as was asked; and what is to be
/// told of it.
pub(super) fn prepared_group(
    drawing: &mut Drawing,
    clearing: &Clearing,
) -> Result<(Group, Vec<String>), OpError> {
    let free = || Group::ALL.into_iter().find(|group| !used(drawing, *group));
    let group = clearing.group.or_else(free).ok_or(OpError::NoFreeGroup)?;
    let (used, before) = (used(drawing, group), *drawing.settings(group));
    let plain = as_drawn(&before);
    if used && plain != before {
        return Err(OpError::NotAsDrawn { group });
    }
    let deep = if used { kept_depth(group, &plain, clearing)? } else { depth(&plain, clearing) };
    let tool = clearing.tool_mm;
    let other = plain.cutter_mm.filter(|cutter| used && *cutter != tool);
    let other = other.map(|cutter| {
        format!("group {group} was cut by a cutter of {cutter} mm, now of {tool} mm")
    });
    let silent = (before.height == CutDepth::Thru && clearing.depth.is_none()).then(|| {
        format!(
            "how deep is not said: the paths of group {group} only touch ZSurface; say depth=2 or set the group's \
             height"
        )
    });
    *drawing.settings_mut(group) = GroupSettings { cutter_mm: Some(tool), ..deep };
    Ok((group, other.into_iter().chain(silent).collect()))
}

fn used(drawing: &Drawing, group: Group) -> bool {
    drawing.shapes.iter().any(|shape| shape.group == group)
}

/// The depth of a group without shapes: through the sheet only where that is asked for.
fn depth(settings: &GroupSettings, clearing: &Clearing) -> GroupSettings {
    let silent = match settings.height {
        CutDepth::Thru => CutDepth::Mm(0.0),
        set => set,
    };
    let height = clearing.depth.unwrap_or(silent);
    let pass_mm = settings.pass_mm.filter(|_| matches!(height, CutDepth::Mm(_)));
    GroupSettings { height, pass_mm, ..*settings }
}

/// The depth of a group that has shapes stays theirs.
fn kept_depth(
    group: Group,
    settings: &GroupSettings,
    clearing: &Clearing,
) -> Result<GroupSettings, OpError> {
    match (settings.height, clearing.depth) {
        (CutDepth::Thru, None) => Err(OpError::DepthNotSaid { group }),
        (set, Some(asked)) if set != asked => Err(OpError::OtherDepth { group }),
        _ => Ok(*settings),
    }
}

/// The same settings, but the path is the shape.
fn as_drawn(settings: &GroupSettings) -> GroupSettings {
    GroupSettings {
        offset_mm: 0.0,
        rough_mm: 0.0,
        double_line: false,
        tag_mm: 0.0,
        lead_in: Lead::default(),
        lead_out: Lead::default(),
        ..*settings
    }
}

/// Puts outlines that would be cut into a group that is off, and tells where they are.
pub(super) fn outlines_put_away(
    drawing: &mut Drawing,
    mut outlines: Vec<usize>,
    paths: Group,
) -> Result<Option<String>, OpError> {
    outlines.sort_unstable();
    outlines.retain(|place| {
        let settings = drawing.settings(drawing.shapes[*place].group);
        settings.on && !settings.traversal
    });
    if outlines.is_empty() {
        return Ok(None);
    }
    let group = resting_group(drawing, paths).ok_or(OpError::NoGroupOff)?;
    drawing.settings_mut(group).on = false;
    for place in &outlines {
        let shape = drawing.shapes[*place].as_ref().clone();
        drawing.shapes[*place] = Arc::new(shape.in_group(group));
    }
    Ok(Some(format!(
        "{} in group {group} now, which is off: only the area is cut; cut-outlines cuts them too",
        named(&outlines)
    )))
}

/// One that is off already, else the last one without shapes.
fn resting_group(drawing: &Drawing, paths: Group) -> Option<Group> {
    let others = || Group::ALL.into_iter().filter(|group| *group != paths);
    let off = others().find(|group| !drawing.settings(*group).on);
    off.or_else(|| others().rev().find(|group| !used(drawing, *group)))
}

fn named(outlines: &[usize]) -> String {
    match outlines {
        [one] => format!("outline {} is", one + 1),
        [first, others @ ..] => format!("outlines {} and {} more are", first + 1, others.len()),
        [] => String::new(),
    }
}
