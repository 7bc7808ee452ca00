//! The way down to the path of a group.

use kerf_drawing::GroupSettings;
use kerf_program::job::Plunge;
pub use kerf_program::job::{Depths, Heights, LowError};

/// The way down of a path of a group. Its helices lie on the side of the leads: right, unless the offset is
/// negative. They are no larger than the path has room for; without any it is a ramp as steep.
pub(crate) fn plunge(settings: &GroupSettings, room_mm: Option<f64>) -> Plunge {
    match settings.plunge {
        Plunge::Helix { radius_mm, angle_deg } => {
            let sign = if settings.offset_mm < 0.0 { -1.0 } else { 1.0 };
            let asked_mm = radius_mm.abs();
            let fits_mm = room_mm.map_or(asked_mm, |room_mm| room_mm.min(asked_mm));
            if fits_mm > 0.0 {
                let radius_mm = sign * fits_mm.copysign(radius_mm);
                Plunge::Helix { radius_mm, angle_deg }
            } else {
                Plunge::Ramp { angle_deg }
            }
        }
        plunge => plunge,
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use kerf_drawing::CutDepth;

    fn depths(height: CutDepth, pass_mm: Option<f64>, bottom_mm: f64) -> Result<Depths, LowError> {
        Depths::of(height, pass_mm, &[], &Heights { bottom_mm, ..Default::default() })
    }

    fn check(height: CutDepth, pass_mm: Option<f64>, expected: &[f64]) {
        assert_eq!(depths(height, pass_mm, -35.0), Ok(Depths::Level(expected.to_vec())));
    }

    #[test]
    fn pro_group_multi() {
        check(CutDepth::Mm(-13.0), Some(4.0), &[-24.0, -28.0, -32.0, -33.0]);
    }

    #[test]
    fn a_depth_of_nothing_is_one_pass_and_too_many_passes_are_made_deeper() {
        check(CutDepth::Mm(0.0), None, &[-20.0]);
        check(CutDepth::Mm(0.0), Some(1.0), &[-20.0]);
        let Ok(Depths::Level(levels)) = depths(CutDepth::Mm(-12.0), Some(1e-4), -35.0) else {
            panic!("levels are wanted")
        };
        let steps: Vec<f64> = levels.windows(2).map(|pair| pair[0] - pair[1]).collect();
        assert_eq!(levels.len(), 10_000);
        assert!(steps.iter().all(|step| (step - 0.0012).abs() < 1e-9));
    }

    #[test]
    fn pro_group_multi_dist() {
        check(CutDepth::Mm(-12.0), Some(4.0), &[-24.0, -28.0, -32.0]);
        check(CutDepth::Mm(-3.0), Some(4.0), &[-23.0]);
        let zero =
            GroupSettings { height: CutDepth::Mm(-3.0), pass_mm: Some(0.0), ..Default::default() };
        assert!(zero.check().is_err());
    }

    #[test]
    fn pro_group_h_thru() {
        check(CutDepth::Thru, None, &[-35.0]);
        assert!(kerf_drawing::Drawing::default().groups.iter().all(|g| g.height == CutDepth::Thru));
    }

    #[test]
    fn pro_group_h_mm_neg() {
        check(CutDepth::Mm(-2.5), None, &[-22.5]);
    }

    #[test]
    fn pro_group_h_mm_pos() {
        check(CutDepth::Mm(3.0), None, &[-17.0]);
        check(CutDepth::Mm(3.0), Some(1.0), &[-17.0]);
    }

    #[test]
    fn heights_of_points_below_z_bottom_are_refused() {
        let along = |z_mm: &[f64]| Depths::of(CutDepth::ThreeD, None, z_mm, &Heights::default());
        assert_eq!(along(&[0.0, 5.0, -10.0]), Ok(Depths::Along(-20.0)));
        assert_eq!(along(&[]), Ok(Depths::Along(-20.0)));
        let told = along(&[0.0, -10.5]).unwrap_err().to_string();
        assert_eq!(told, "it would be cut at -30.5 mm, below ZBottom at -30 mm");
    }

    #[test]
    fn pro_group_multi_limit() {
        let error = depths(CutDepth::Mm(-13.0), None, -30.0).unwrap_err();
        assert!(error.to_string().ends_with("at -33 mm, below ZBottom at -30 mm"), "{error}");
    }
}
