//! A whole job lifted: paths with heights of their own lie higher or lower (Profiler reference, "Hand Console",
//! function 300).

use kerf_program::job::{CutDepth, Job, JobShape};

/// The lowest place of the paths that are cut at heights of their own, millimetres above ZSurface; nothing
/// without such a path.
pub fn lowest_mm(job: &Job) -> Option<f64> {
    let own = job.shapes.iter().filter(|shape| shape.height == CutDepth::ThreeD);
    own.flat_map(|shape| (1..=shape.path.vertices.len()).map(|n| shape.height_mm(n)))
        .reduce(f64::min)
}

/// A job whose paths with heights of their own lie a distance higher, negative lower. Zero changes nothing.
pub fn lifted(job: Job, by_mm: f64) -> Job {
    if by_mm == 0.0 {
        return job;
    }
    let shapes = job.shapes.iter().map(|shape| match shape.height {
        CutDepth::ThreeD => shape_lifted(shape, by_mm),
        _ => shape.clone(),
    });
    Job { shapes: shapes.collect(), ..job }
}

fn shape_lifted(shape: &JobShape, by_mm: f64) -> JobShape {
    let heights = (0..shape.path.vertices.len()).map(|n| shape.height_mm(n) + by_mm);
    JobShape { z_mm: heights.collect(), ..shape.clone() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use kerf_geom::{Point2, Polyarc};

    fn shape(height: CutDepth, z_mm: &[f64]) -> JobShape {
        let places = (0..3).map(|x| Point2::new(f64::from(x), 0.0));
        let path = Polyarc::lines(places, false);
        JobShape { height, z_mm: z_mm.into(), ..JobShape::through(1, path) }
    }

    #[test]
    fn only_paths_with_heights_of_their_own_are_lifted() {
        let shapes =
            [shape(CutDepth::ThreeD, &[0.0, -4.0, -2.5]), shape(CutDepth::Thru, &[-9.0; 3])];
        let job = Job { shapes: shapes.into(), ..Job::default() };
        assert_eq!(lowest_mm(&job), Some(-4.0));
        let up = lifted(job.clone(), 1.5);
        assert_eq!(*up.shapes[0].z_mm, [1.5, -2.5, -1.0]);
        assert_eq!((&up.shapes[1], lowest_mm(&up)), (&job.shapes[1], Some(-2.5)));
        assert_eq!(lifted(job.clone(), 0.0), job);
    }

    #[test]
    fn heights_that_are_not_told_are_those_of_the_surface() {
        let job = Job { shapes: [shape(CutDepth::ThreeD, &[3.0])].into(), ..Job::default() };
        assert_eq!(lowest_mm(&job), Some(0.0));
        assert_eq!(*lifted(job, -1.0).shapes[0].z_mm, [2.0, -1.0, -1.0]);
        assert_eq!(lowest_mm(&Job::default()), None);
    }
}
