//! RSG: a drawing with everything that belongs to it, in a file that drawing programs read.
//!
//! The geometry is plain DXF Release 12, each group on a layer of its name and colour. What DXF has
//! no place for stands in comments (group code 999), which other programs pass over: at the head of
//! the file the settings of the groups, arrays, comments; in each entity what its shape has beyond
//! its lines and arcs (readings, P-7). Files of the old program, which have no such comments,
//! are read as drawings.

use crate::dxf::{self, MARK, Notes, Options};
use crate::{Finding, Imported, Weight};
use kerf_drawing::{Arrays, Drawing, Group, GroupSettings, Kind, Shape};
use kerf_geom::Vec2;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// The version that is written. A file of a later one is read as a plain drawing, and that is told.
const VERSION: u32 = 1;

/// Longest line of a comment: programs of Release 12 read 255 characters.
const LONGEST: usize = 200;

#[derive(Serialize, Deserialize)]
struct Head {
    version: u32,
    groups: [GroupSettings; 8],
    arrays: Arrays,
    moved: Vec2,
    #[serde(default, skip_serializing_if = "is_false")]
    ordered_by_hand: bool,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    comments: Vec<String>,
    /// Data that a job has besides.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    job: Option<serde_json::Value>,
}

/// Data of a shape beyond its lines and arcs.
#[derive(Default, Serialize, Deserialize)]
struct Extra {
    group: Group,
    #[serde(default, skip_serializing_if = "is_false")]
    pause: bool,
    #[serde(default, skip_serializing_if = "is_false")]
    start_inserted: bool,
    /// Bulges of a 3D shape: the polyline in space that DXF has is straight.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    bulges: Vec<f64>,
    /// The height of a single point: the one that DXF has is that of a plan.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    height_mm: Option<f64>,
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde asks by reference")]
fn is_false(value: &bool) -> bool {
    !*value
}

/// A drawing as RSG.
pub fn write(drawing: &Drawing) -> String {
    write_with(drawing, None)
}

/// A drawing with the data of a job, as RSM has them.
pub fn write_with(drawing: &Drawing, job: Option<serde_json::Value>) -> String {
    let head = Head {
        version: VERSION,
        groups: drawing.groups,
        arrays: drawing.arrays,
        moved: drawing.moved,
        ordered_by_hand: drawing.ordered_by_hand,
        comments: drawing.comments().to_vec(),
        job,
    };
    let notes = Notes {
        head: chunks(&json(&head)),
        shapes: drawing.shapes.iter().map(|shape| MARK.to_owned() + &json(&extra(shape))).collect(),
        layers: true,
    };
    dxf::write_with(drawing, &notes)
}

/// The types of this file always have a JSON form.
fn json<T: Serialize>(value: &T) -> String {
    serde_json::to_string(value).unwrap_or_default()
}

/// The text in lines that do not end with a blank: readers cut blanks off.
fn chunks(text: &str) -> Vec<String> {
    let mut lines = Vec::new();
    let mut rest = text;
    while !rest.is_empty() {
        let far = rest.char_indices().nth(LONGEST).map_or(rest.len(), |(at, _)| at);
        let kept = rest[..far].trim_end_matches(' ').len();
        let (line, after) = rest.split_at(if kept == 0 { far } else { kept });
        lines.push(MARK.to_owned() + line);
        rest = after;
    }
    lines
}

fn extra(shape: &Shape) -> Extra {
    let curved = shape.z_mm.is_some() && shape.path.vertices.iter().any(|v| v.bulge != 0.0);
    let bulges = shape.path.vertices.iter().filter(|_| curved).map(|v| v.bulge).collect();
    let Shape { group, pause, start_inserted, .. } = *shape;
    let height_mm =
        shape.z_mm.as_ref().filter(|_| shape.kind() == Kind::Point).map(|_| shape.height_mm(0));
    Extra { group, pause, start_inserted, bulges, height_mm }
}

/// Reads an RSG file, or any DXF.
pub fn read(bytes: &[u8]) -> Imported {
    read_until(bytes, &|| false)
}

/// The same, until it is given up: then nothing is read.
pub fn read_until(bytes: &[u8], given_up: &dyn Fn() -> bool) -> Imported {
    read_as(bytes, false, given_up).0
}

/// Data in a file that only Kerf writes.
#[derive(Clone, Debug, PartialEq)]
pub enum Own {
    /// Nothing: another program wrote it, the old one among them.
    Nothing,
    /// The data of a drawing, and those of a job where it is one.
    Read(Option<serde_json::Value>),
    /// Not all of it can be read, and why.
    Damaged(String),
}

/// Reads an RSG or RSM file with the data of its job, its paths to the letter.
pub fn read_with(bytes: &[u8]) -> (Imported, Own) {
    read_with_until(bytes, &|| false)
}

/// The same, until it is given up: then nothing is read.
pub fn read_with_until(bytes: &[u8], given_up: &dyn Fn() -> bool) -> (Imported, Own) {
    read_as(bytes, true, given_up)
}

fn read_as(bytes: &[u8], as_written: bool, given_up: &dyn Fn() -> bool) -> (Imported, Own) {
    let options = Options { scale: false, as_written, ..Options::default() };
    let (mut read, notes) = dxf::read_with_notes(bytes, &options, given_up);
    let head: String = notes.head.iter().filter_map(|line| line.strip_prefix(MARK)).collect();
    if head.is_empty() && !notes.shapes.iter().any(|note| note.starts_with(MARK)) {
        read.heighten();
        return (read, Own::Nothing);
    }
    let mut job = None;
    match serde_json::from_str::<Head>(&head) {
        Ok(mut head) if head.version <= VERSION => {
            job = head.job.take();
            restore(&mut read, head, &notes.shapes);
        }
        Ok(head) => tell(&mut read, format!("written by a later Kerf (version {})", head.version)),
        Err(error) => tell(&mut read, format!("its own data cannot be read ({error})")),
    }
    // Kerf writes nothing that it warns of.
    let damage = read.findings.iter().find(|found| found.weight == Weight::Warning);
    let own = damage.map_or(Own::Read(job), |found| Own::Damaged(found.text.clone()));
    (read, own)
}

fn tell(read: &mut Imported, why: String) {
    warn(read, format!("{why}: read as a plain drawing, groups and arrays are lost"));
}

fn warn(read: &mut Imported, text: String) {
    read.findings.push(Finding { line: 1, ..Finding::of_file(Weight::Warning, text) });
}

fn restore(read: &mut Imported, head: Head, notes: &[String]) {
    let drawing = &mut read.drawing;
    drawing.groups = head.groups;
    drawing.arrays = head.arrays;
    drawing.moved = head.moved;
    drawing.ordered_by_hand = head.ordered_by_hand;
    let (mut without, mut notes) = (Vec::new(), notes.iter());
    for (number, shape) in (1..).zip(&mut drawing.shapes) {
        let own = notes.next().and_then(|note| note.strip_prefix(MARK));
        match own.and_then(|json| serde_json::from_str(json).ok()) {
            Some(extra) => *shape = Arc::new(restored(shape, extra)),
            None => without.push(number),
        }
    }
    let bad = Group::ALL.iter().find_map(|group| {
        drawing.settings(*group).check().err().map(|error| format!("group {group}: {error}"))
    });
    if let Some(why) = bad.or(drawing.set_comments(head.comments).err().map(|e| e.to_string())) {
        tell(read, why);
        read.drawing.groups = Drawing::default().groups;
    }
    without.into_iter().for_each(|shape: u32| {
        warn(read, format!("shape {shape}: its own data cannot be read, it is in group black"));
    });
}

fn restored(shape: &Shape, extra: Extra) -> Shape {
    let Extra { group, pause, start_inserted, bulges, height_mm } = extra;
    let mut path = shape.path.clone();
    for (vertex, bulge) in path.vertices.iter_mut().zip(bulges) {
        vertex.bulge = bulge;
    }
    let z_mm = height_mm.map(|z| vec![z]).or_else(|| shape.z_mm.clone());
    Shape { path, z_mm, group, pause, start_inserted }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use kerf_drawing::{Editor, script};
    use kerf_geom::{Point2, Polyarc, Vertex};

    fn rich() -> Drawing {
        let text = "circle 50,50 25; line 0,0,0.3 10,1 20,5 close; point 3,4; select 1; group red; \
            select 2; pause on; start 2 15,3; \
            set red on=off traversal=on tool=2 cut=3 speed=3000 height=-2.5 pass=1 offset=3 rough=0.5 \
            double=on tag=2 lead-in=5,90 lead-out=1,45; array block 2x3 gap 10,20 start tl order row-snake; \
            array job 4x1 gap 1,2 start br order column; origin 1,2; comment Anna | 18 mm birch | äöü";
        let mut editor = Editor::default();
        for (_, op) in script(text).unwrap() {
            editor.apply(&op).unwrap();
        }
        let curve = Polyarc::open(vec![Vertex::new(0.1, 0.2, 0.5), Vertex::new(9.0, 0.7, 0.0)]);
        editor.drawing.add(Shape::with_heights(curve, vec![-1.0, -2.0]));
        editor.drawing
    }

    #[test]
    fn pro_files_rsg() {
        let drawing = rich();
        let back = read(write(&drawing).as_bytes());
        assert_eq!(back.findings, []);
        assert_eq!(back.drawing, drawing);
    }

    #[test]
    fn pro_group_saved() {
        let drawing = rich();
        let back = read(write(&drawing).as_bytes()).drawing;
        assert_eq!(back.groups, drawing.groups);
        assert_ne!(back.groups, Drawing::default().groups);
    }

    #[test]
    fn pro_files_comments() {
        let back = read(write(&rich()).as_bytes()).drawing;
        assert_eq!(back.comments(), ["Anna", "18 mm birch", "äöü"]);
    }

    #[test]
    fn pro_files_dxf_out() {
        let drawing = rich();
        let back = dxf::read(dxf::write(&drawing).as_bytes(), &Options::default());
        // The shape with heights of its own leaves the group of the flat ones.
        let found: Vec<_> =
            back.findings.iter().map(|found| (found.weight, found.text.as_str())).collect();
        assert!(
            matches!(found[..], [(Weight::Note, text)] if text.contains("are in group blue")),
            "{found:?}"
        );
        let flat = 3;
        for (old, new) in drawing.shapes.iter().zip(&back.drawing.shapes).take(flat) {
            assert_eq!((&new.path, new.group), (&old.path, Group::Black));
        }
        assert_eq!(back.drawing.arrays, Arrays::default());
    }

    #[test]
    fn blanks_at_the_end_of_a_line_are_kept() {
        for length in 0..50 {
            let mut drawing = Drawing::default();
            drawing.set_comments(vec![" ".repeat(length) + "x"; 10]).unwrap();
            assert_eq!(read(write(&drawing).as_bytes()).drawing, drawing);
        }
    }

    #[test]
    fn a_file_of_the_old_program_is_a_drawing() {
        let plain = dxf::write(&rich());
        assert_eq!(read(plain.as_bytes()).drawing.shapes.len(), 4);
    }

    #[test]
    fn broken_data_of_its_own_leave_a_drawing() {
        let text = write(&rich()).replace("\"version\":1", "\"version\":9");
        let later = read(text.as_bytes());
        assert!(later.findings[0].text.starts_with("written by a later Kerf (version 9)"));
        assert_eq!((later.drawing.shapes.len(), later.drawing.arrays), (4, Arrays::default()));
        let broken = read(write(&rich()).replace("\"tool\":2", "\"tool\":7").as_bytes());
        assert!(broken.findings[0].text.contains("tool is 7"), "{:?}", broken.findings);
        assert_eq!(broken.drawing.groups, Drawing::default().groups);
    }

    #[test]
    fn the_corner_of_a_drawing_is_the_same_to_the_last_bit() {
        let at = Point2::new(0.1 + 0.2, 1.0 / 3.0);
        let drawing = Drawing::of([Shape::point(at)]);
        assert_eq!(read(write(&drawing).as_bytes()).drawing, drawing);
    }
}
