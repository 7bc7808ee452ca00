//! 3D shapes that come into a drawing: their group becomes 3D, so that they are cut at their own heights and not
//! flat at that of the group.

use crate::{CutDepth, Drawing, Group, GroupSettings};
use std::fmt;
use std::ops::Range;
use std::sync::Arc;

/// A group that 3D shapes came into, and what became of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Heightened {
    /// It holds only 3D shapes, and is 3D now.
    Became(Group),
    /// It holds flat shapes too: the 3D shapes went into another, which is 3D.
    Moved {
        /// The group they came into.
        from: Group,
        /// The group they are in.
        to: Group,
    },
    /// It holds flat shapes too, and no group was free: they are cut flat.
    Flat(Group),
}

impl fmt::Display for Heightened {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Became(group) => {
                write!(f, "group {group} is 3D now: its shapes have heights of their own")
            }
            Self::Moved { from, to } => {
                write!(
                    f,
                    "shapes with heights of their own are in group {to}, which is 3D; group {from} has flat shapes too"
                )
            }
            Self::Flat(group) => write!(
                f,
                "group {group} has flat shapes and shapes with heights of their own, which are cut flat: no group is free; \
                 empty one, put them into it and give it the height 3D"
            ),
        }
    }
}

/// Gives 3D shapes that came into a drawing, by their places, a group that is 3D.
pub fn heighten(drawing: &mut Drawing, new: Range<usize>) -> Vec<Heightened> {
    let is_new = |place: usize| new.contains(&place);
    let flat_in = |drawing: &Drawing, group: Group| {
        drawing.settings(group).height != CutDepth::ThreeD
            && drawing.shapes.iter().any(|shape| shape.group == group && shape.z_mm.is_none())
    };
    let mut found = Vec::new();
    for group in Group::ALL {
        let came = |(place, shape): (usize, &Arc<crate::Shape>)| {
            is_new(place) && shape.group == group && shape.z_mm.is_some()
        };
        let any = drawing.shapes.iter().enumerate().any(came);
        if !any || drawing.settings(group).height == CutDepth::ThreeD {
            continue;
        }
        if !flat_in(drawing, group) {
            make_3d(drawing.settings_mut(group));
            found.push(Heightened::Became(group));
            continue;
        }
        let Some(to) = home_for_3d(drawing, group) else {
            found.push(Heightened::Flat(group));
            continue;
        };
        let mut settings = *drawing.settings(group);
        make_3d(&mut settings);
        *drawing.settings_mut(to) = settings;
        for (place, shape) in drawing.shapes.iter_mut().enumerate() {
            if is_new(place) && shape.group == group && shape.z_mm.is_some() {
                Arc::make_mut(shape).group = to;
            }
        }
        found.push(Heightened::Moved { from: group, to });
    }
    found
}

const fn make_3d(settings: &mut GroupSettings) {
    settings.height = CutDepth::ThreeD;
    settings.pass_mm = None;
}

/// A group that is cut as this one but 3D, else one without shapes.
fn home_for_3d(drawing: &Drawing, group: Group) -> Option<Group> {
    let mut wanted = *drawing.settings(group);
    make_3d(&mut wanted);
    let used = |group: Group| drawing.shapes.iter().any(|shape| shape.group == group);
    let alike =
        Group::ALL.into_iter().find(|other| used(*other) && *drawing.settings(*other) == wanted);
    alike.or_else(|| Group::ALL.into_iter().find(|other| *other != group && !used(*other)))
}

#[cfg(test)]
#[allow(non_snake_case)]
mod tests {
    use super::*;
    use crate::Shape;
    use kerf_geom::{Point2, Polyarc};

    fn line() -> Polyarc {
        Polyarc::lines([Point2::new(0.0, 0.0), Point2::new(10.0, 0.0)], false)
    }

    fn solid() -> Shape {
        Shape::with_heights(line(), vec![-2.0, -4.0])
    }

    #[test]
    fn pro_import_nc_path2d3d__the_group_becomes_3d() {
        let mut drawing = Drawing::of([solid(), solid()]);
        assert_eq!(heighten(&mut drawing, 0..2), [Heightened::Became(Group::Black)]);
        assert_eq!(drawing.settings(Group::Black).height, CutDepth::ThreeD);
        assert_eq!(heighten(&mut drawing, 0..2), []);
    }

    #[test]
    fn flat_shapes_keep_their_group_and_3d_shapes_get_one() {
        let mut drawing = Drawing::of([Shape::flat(line()), solid()]);
        drawing.settings_mut(Group::Black).tool = 3;
        let moved = Heightened::Moved { from: Group::Black, to: Group::Blue };
        assert_eq!(heighten(&mut drawing, 1..2), [moved]);
        assert_eq!(drawing.shapes[1].group, Group::Blue);
        let blue = drawing.settings(Group::Blue);
        assert_eq!((blue.height, blue.tool), (CutDepth::ThreeD, 3));
        assert_eq!(drawing.settings(Group::Black).height, CutDepth::Thru);
        // The next one joins it; shapes that were there before stay where they are.
        drawing.add(solid());
        assert_eq!(heighten(&mut drawing, 2..3), [moved]);
        drawing.add(solid());
        assert_eq!(heighten(&mut drawing, 4..4), []);
        assert_eq!(drawing.shapes[3].group, Group::Black);
    }

    #[test]
    fn without_a_free_group_it_is_told() {
        let all = Group::ALL.into_iter().map(|group| Shape::flat(line()).in_group(group));
        let mut drawing = Drawing::of(all.chain([solid()]));
        assert_eq!(heighten(&mut drawing, 8..9), [Heightened::Flat(Group::Black)]);
    }
}
