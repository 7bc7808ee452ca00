//! RSM: a job in a file that drawing programs read.
//!
//! Like an RSG it is plain DXF Release 12 with comments. The paths stand in it as they are cut, arrays
//! laid out; the comments hold where the job lies on the table and what each path comes from.

use crate::job::{CutPath, DrawnJob, Origin};
use kerf_drawing::{Arrays, Drawing};
use kerf_formats::Imported;
use kerf_formats::rsg::{self, Own};
use kerf_geom::Point2;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Data of an RSM besides those of an RSG.
#[derive(Default, Serialize, Deserialize)]
struct Head {
    origin: Point2,
    /// A place of 0,0 that is meant: in files of before it meant none.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    origin_set: bool,
    finish: Point2,
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    finish_set: bool,
    start: usize,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    smoothing: Option<f64>,
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    edited: bool,
    paths: Vec<Origin>,
    /// The check number of what is cut; files of before have none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    sum: Option<u32>,
}

impl Head {
    fn origin(&self) -> Option<Point2> {
        meant(self.origin, self.origin_set)
    }

    fn finish(&self) -> Option<Point2> {
        meant(self.finish, self.finish_set)
    }
}

fn meant(place: Point2, set: bool) -> Option<Point2> {
    (set || place != Point2::default()).then_some(place)
}

/// A job as RSM.
pub fn write(job: &DrawnJob) -> String {
    let shapes = job.paths.iter().map(|path| path.shape.clone()).collect();
    let mut drawing = job.drawing.with_shapes(shapes);
    drawing.arrays = Arrays::default();
    let origin =
        |path: &CutPath| Origin { from: path.from, pass: path.pass, room_mm: path.room_mm };
    let paths = job.paths.iter().map(origin).collect();
    let DrawnJob { origin, finish, start, smoothing, edited, .. } = *job;
    let sum = Some(sum(&drawing));
    let head = Head {
        origin: origin.unwrap_or_default(),
        origin_set: origin.is_some(),
        finish: finish.unwrap_or_default(),
        finish_set: finish.is_some(),
        start,
        smoothing,
        edited,
        paths,
        sum,
    };
    rsg::write_with(&drawing, Some(serde_json::to_value(head).unwrap_or_default()))
}

/// Reason why a job is not cut: what its file says of it cannot all be read.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the job is damaged and is not cut ({0}): make it anew from its drawing")]
pub struct Damaged(String);

/// Reads an RSM. A drawing that is none is a job of its shapes as they are, so is a job of the old program; what
/// was noticed comes with it.
///
/// # Errors
/// Kerf wrote it, and it is not what it was.
pub fn read_whole(bytes: &[u8]) -> Result<(DrawnJob, Imported), Damaged> {
    match read_with_damage(bytes, &|| false) {
        (job, read, None) => Ok((job, read)),
        (.., Some(why)) => Err(Damaged(why)),
    }
}

/// The same, and of a damaged one what is left of it.
pub fn read(bytes: &[u8]) -> (DrawnJob, Imported) {
    read_until(bytes, &|| false)
}

/// The same, until it is given up: then nothing is read, and what was read says so.
pub fn read_until(bytes: &[u8], given_up: &dyn Fn() -> bool) -> (DrawnJob, Imported) {
    let (job, read, _) = read_with_damage(bytes, given_up);
    (job, read)
}

fn read_with_damage(
    bytes: &[u8],
    given_up: &dyn Fn() -> bool,
) -> (DrawnJob, Imported, Option<String>) {
    let (mut read, own) = rsg::read_with_until(bytes, given_up);
    let (head, damage) = head(own, &read.drawing);
    let shapes = std::mem::take(&mut read.drawing.shapes);
    let origins = head.paths.iter().copied();
    let numbered = (1..).map(|from| Origin { from, ..Origin::default() });
    let path = |(shape, origin): (Arc<_>, Origin)| {
        let Origin { from, pass, room_mm } = origin;
        CutPath { shape, from, pass, room_mm }
    };
    let missing = numbered.skip(head.paths.len());
    let paths = shapes.into_iter().zip(origins.chain(missing)).map(path).collect();
    let (origin, finish) = (head.origin(), head.finish());
    let Head { start, smoothing, edited, .. } = head;
    let drawing = read.drawing.clone();
    let start = start.max(1);
    (DrawnJob { paths, drawing, origin, finish, start, smoothing, edited }, read, damage)
}

/// Reads what a file with these shapes says of its job, and finds what is wrong with that.
fn head(own: Own, drawing: &Drawing) -> (Head, Option<String>) {
    let value = match own {
        Own::Nothing | Own::Read(None) => return (Head::default(), None),
        Own::Damaged(why) => return (Head::default(), Some(why)),
        Own::Read(Some(value)) => value,
    };
    match serde_json::from_value::<Head>(value) {
        Err(error) => (Head::default(), Some(format!("its own data cannot be read ({error})"))),
        Ok(head) if head.paths.len() != drawing.shapes.len() => {
            let (had, has) = (head.paths.len(), drawing.shapes.len());
            (head, Some(format!("it had {had} paths and has {has}")))
        }
        Ok(head) if head.sum.is_some_and(|written| written != sum(drawing)) => {
            (head, Some("its paths or groups are not what they were".into()))
        }
        Ok(head) => (head, None),
    }
}

/// A check number of everything that is cut, and how; the same for a file with other line ends.
fn sum(drawing: &Drawing) -> u32 {
    let mut sum = crc32fast::Hasher::new();
    let mut add = |value: f64| sum.update(&(value + 0.0).to_bits().to_le_bytes());
    for shape in &drawing.shapes {
        let path = &shape.path;
        path.vertices.iter().for_each(|v| [v.at.x, v.at.y, v.bulge].into_iter().for_each(&mut add));
        shape.z_mm.iter().flatten().copied().for_each(&mut add);
        let flags = [path.closed, shape.pause].map(|flag| f64::from(u8::from(flag)));
        [flags[0], flags[1], shape.group as usize as f64].into_iter().for_each(&mut add);
    }
    sum.update(serde_json::to_string(&drawing.groups).unwrap_or_default().as_bytes());
    sum.finalize()
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::smoothed_job;
    use kerf_drawing::{Editor, script};

    fn job() -> DrawnJob {
        let text = "rect 50,50 150,150; line 0,0 10,1; circle 5,5 2; select 2; group red; select 3; pause on; \
                    set black height=-2 tool=2 cut=2 speed=1000; set red offset=1; array block 2x1 gap 10,20";
        let mut editor = Editor::default();
        for (_, op) in script(text).unwrap() {
            editor.apply(&op).unwrap();
        }
        smoothed_job(&editor.drawing, 0.6).unwrap().0
    }

    #[test]
    fn a_job_that_lost_a_line_is_refused_or_the_same() {
        let (text, mut refused) = (write(&job()), 0);
        let (job, _) = read_whole(text.as_bytes()).unwrap();
        let lines: Vec<&str> = text.lines().collect();
        for n in 0..lines.len() {
            let (before, after) = (&lines[..n], &lines[n + 1..]);
            for middle in [&[][..], &["xyz"], &["0"], &["12.5"], &["\u{1}\u{2}"]] {
                let hurt = [before, middle, after].concat().join("\n");
                match read_whole(hurt.as_bytes()) {
                    Err(_) => refused += 1,
                    Ok((read, _)) => assert!(read == job, "line {}: {middle:?}", n + 1),
                }
            }
        }
        assert!(refused > lines.len(), "{refused} of {}", lines.len());
    }

    #[test]
    fn a_path_whose_leads_meet_comes_back_open() {
        let text = "rect 20,20 110,110; set black lead-in=5,90 lead-out=5,90";
        let mut editor = Editor::default();
        for (_, op) in script(text).unwrap() {
            editor.apply(&op).unwrap();
        }
        let job = smoothed_job(&editor.drawing, 0.6).unwrap().0;
        let (back, _) = read_whole(write(&job).as_bytes()).unwrap();
        assert!(!job.paths[0].shape.is_closed());
        assert_eq!(back.paths, job.paths);
    }

    #[test]
    fn an_origin_of_zero_is_another_thing_than_none() {
        let back = |origin, finish| {
            let text = write(&DrawnJob { origin, finish, ..job() });
            let (read, _) = read_whole(text.as_bytes()).unwrap();
            ((read.origin, read.finish), text)
        };
        let (zero, there) = (Some(Point2::default()), Some(Point2::new(3.0, 4.0)));
        for (origin, finish) in [(None, None), (zero, None), (None, zero), (there, zero)] {
            assert_eq!(back(origin, finish).0, (origin, finish));
        }
        // Files of before wrote 0,0 for a place that was not set.
        let old = back(there, zero).1.replace(",\"finish_set\":true", "");
        let (read, _) = read_whole(old.replace(",\"origin_set\":true", "").as_bytes()).unwrap();
        assert_eq!((read.origin, read.finish), (there, None));
    }

    #[test]
    fn a_job_of_the_old_program_is_one() {
        let text = write(&job());
        let lines: Vec<&str> = text.lines().collect();
        // Its files have no comments.
        let pairs = lines.chunks(2).filter(|pair| pair[0].trim() != "999");
        let plain = pairs.flatten().copied().collect::<Vec<_>>().join("\n");
        let (read, _) = read_whole(plain.as_bytes()).unwrap();
        assert_eq!(read.paths.len(), job().paths.len());
    }
}
