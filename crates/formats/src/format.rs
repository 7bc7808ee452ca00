//! File formats of drawings and pictures: one table of endings, readers and writers.
//!
//! A format more is a row of [`FORMATS`] and the module that its functions stand in. The command line, the server and
//! conversions ask the table; none of them has a list of its own.

use crate::bitmap::{Bitmap, BitmapError};
use crate::{Imported, bitmap, dxf, hpgl, rsg, svg};
use kerf_drawing::Drawing;
use std::path::Path;

/// The ending of jobs: the tool paths of a drawing.
pub const JOB_ENDING: &str = "rsm";

/// Sort of content that a file holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Content {
    /// Shapes.
    Drawing,
    /// The tool paths of a drawing, which `kerf_toolpath` reads and writes; read here as shapes.
    Job,
    /// Dots of grey.
    Picture,
}

/// Wishes of the person who opens a file.
#[derive(Clone, Copy)]
pub struct Opening<'a> {
    /// Options of DXF; other formats have none.
    pub dxf: dxf::Options,
    /// Asked now and then; once it is `true`, reading ends and nothing is read.
    pub given_up: &'a dyn Fn() -> bool,
}

impl Default for Opening<'_> {
    fn default() -> Self {
        Self { dxf: dxf::Options::default(), given_up: &|| false }
    }
}

/// A row of the table.
#[derive(Clone, Copy, Debug)]
pub struct Format {
    /// The endings of its files, in small letters.
    pub endings: &'static [&'static str],
    /// A file keeps all that belongs to a drawing.
    pub keeps_all: bool,
    reader: Reader,
    writer: Option<fn(&Drawing) -> String>,
}

#[derive(Clone, Copy, Debug)]
enum Reader {
    Drawing(fn(&[u8], &Opening<'_>) -> Imported),
    Job(fn(&[u8], &Opening<'_>) -> Imported),
    Picture(fn(&[u8]) -> Result<Bitmap, BitmapError>),
}

/// All formats, in the order in which messages list them.
pub const FORMATS: [Format; 6] = [
    Format {
        endings: &["dxf"],
        keeps_all: false,
        reader: Reader::Drawing(|bytes, how| dxf::read_until(bytes, &how.dxf, how.given_up)),
        writer: Some(dxf::write),
    },
    Format {
        endings: &["svg"],
        keeps_all: false,
        reader: Reader::Drawing(|bytes, how| svg::read_until(bytes, how.given_up)),
        writer: Some(svg::write),
    },
    Format {
        endings: &["rsg"],
        keeps_all: true,
        reader: Reader::Drawing(|bytes, how| rsg::read_until(bytes, how.given_up)),
        writer: Some(rsg::write),
    },
    Format {
        endings: &[JOB_ENDING],
        keeps_all: true,
        reader: Reader::Job(|bytes, how| rsg::read_with_until(bytes, how.given_up).0),
        writer: None,
    },
    Format {
        endings: &["plt", "hpg", "hpgl"],
        keeps_all: false,
        reader: Reader::Drawing(|bytes, _| hpgl::read(bytes)),
        writer: None,
    },
    Format {
        endings: &["bmp", "jpg", "jpeg", "png"],
        keeps_all: false,
        reader: Reader::Picture(bitmap::read),
        writer: None,
    },
];

impl Format {
    /// Finds the format of a file by its name.
    pub fn of_file(name: impl AsRef<Path>) -> Option<&'static Self> {
        Self::of_ending(&ending(name))
    }

    /// Finds the format of an ending in small letters.
    pub fn of_ending(ending: &str) -> Option<&'static Self> {
        FORMATS.iter().find(|format| format.endings.contains(&ending))
    }

    /// Returns the sort of content that its files hold.
    pub const fn content(&self) -> Content {
        match self.reader {
            Reader::Drawing(_) => Content::Drawing,
            Reader::Job(_) => Content::Job,
            Reader::Picture(_) => Content::Picture,
        }
    }

    /// Tells whether Kerf writes files of it.
    pub fn is_written(&self) -> bool {
        self.writer.is_some() || self.content() == Content::Job
    }

    /// Reads the shapes of a file; `None` for a picture.
    pub fn open(&self, bytes: &[u8], how: &Opening<'_>) -> Option<Imported> {
        match self.reader {
            Reader::Drawing(read) | Reader::Job(read) => Some(read(bytes, how)),
            Reader::Picture(_) => None,
        }
    }

    /// Reads the dots of a picture; `None` for a drawing.
    pub fn picture(&self, bytes: &[u8]) -> Option<Result<Bitmap, BitmapError>> {
        match self.reader {
            Reader::Picture(read) => Some(read(bytes)),
            Reader::Drawing(_) | Reader::Job(_) => None,
        }
    }

    /// Writes a drawing; `None` where drawings are not written so.
    pub fn write(&self, drawing: &Drawing) -> Option<String> {
        self.writer.map(|write| write(drawing))
    }

    /// Returns a sentence about what its files have no place for, where the drawing has any of it.
    pub fn unkept(&self, drawing: &Drawing) -> Option<&'static str> {
        (!self.keeps_all).then(|| crate::unkept(drawing)).flatten()
    }
}

/// Opens a drawing or a job by the ending of its name; `None` where that is of neither.
pub fn open(name: impl AsRef<Path>, bytes: &[u8], how: &Opening<'_>) -> Option<Imported> {
    Format::of_file(name)?.open(bytes, how)
}

/// Returns `true` if the ending of a name is that of a drawing or of a job.
pub fn is_drawing(name: impl AsRef<Path>) -> bool {
    Format::of_file(name).is_some_and(|format| format.content() != Content::Picture)
}

/// Returns the ending of a file's name, in small letters and without the dot.
pub fn ending(name: impl AsRef<Path>) -> String {
    let ending = name.as_ref().extension().unwrap_or_default();
    ending.to_string_lossy().to_ascii_lowercase()
}

/// Lists the endings of drawings that are read: `.dxf, .svg or .plt`.
pub fn readable() -> String {
    listed(FORMATS.iter().filter(|format| format.content() != Content::Picture))
}

/// Lists the endings of drawings that are written, first the one that keeps everything.
pub fn writable() -> String {
    let written = || FORMATS.iter().filter(|format| format.writer.is_some());
    listed(written().filter(|it| it.keeps_all).chain(written().filter(|it| !it.keeps_all)))
}

fn listed<'a>(formats: impl Iterator<Item = &'a Format>) -> String {
    let dotted = formats.flat_map(|format| format.endings).map(|ending| format!(".{ending}"));
    let mut endings: Vec<String> = dotted.collect();
    let last = endings.pop().unwrap_or_default();
    format!("{} or {last}", endings.join(", "))
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use image::{DynamicImage, ImageFormat};
    use kerf_drawing::Shape;
    use kerf_geom::{Point2, Polyarc, Vertex};
    use std::io::Cursor;

    fn line() -> Drawing {
        let ends = [Point2::new(1.0, 2.0), Point2::new(30.0, 4.0)];
        let vertices = ends.map(|at| Vertex::new(at.x, at.y, 0.0)).to_vec();
        Drawing::of([Shape::flat(Polyarc::open(vertices))])
    }

    /// A file of each ending, written by another hand where Kerf writes none.
    fn sample(ending: &str) -> Vec<u8> {
        let picture = |format| {
            let mut bytes = Cursor::new(Vec::new());
            DynamicImage::new_luma8(3, 2).write_to(&mut bytes, format).unwrap();
            bytes.into_inner()
        };
        match ending {
            "rsm" => rsg::write_with(&line(), Some(serde_json::json!({}))).into_bytes(),
            "plt" | "hpg" | "hpgl" => b"IN;SP1;PU40,80;PD1200,160;PU;".to_vec(),
            "bmp" => picture(ImageFormat::Bmp),
            "jpg" | "jpeg" => picture(ImageFormat::Jpeg),
            "png" => picture(ImageFormat::Png),
            _ => Format::of_ending(ending).unwrap().write(&line()).unwrap().into_bytes(),
        }
    }

    #[test]
    fn each_row_opens_a_sample_of_its_ending() {
        for ending in FORMATS.iter().flat_map(|format| format.endings) {
            let name = format!("folder.of/sample.{}", ending.to_uppercase());
            let format = Format::of_file(&name).unwrap();
            let bytes = sample(ending);
            if format.content() == Content::Picture {
                let dots = format.picture(&bytes).unwrap().unwrap();
                assert_eq!((dots.columns, dots.rows), (3, 2), "{name}");
                assert_eq!(open(&name, &bytes, &Opening::default()), None, "{name}");
                continue;
            }
            let read = open(&name, &bytes, &Opening::default()).unwrap();
            assert_eq!(read.findings, [], "{name}");
            let found = &read.drawing.shapes[0].path;
            let off =
                |at: usize| found.vertices[at].at.distance(line().shapes[0].path.vertices[at].at);
            assert!(
                found.vertices.len() == 2 && off(0) < 1e-6 && off(1) < 1e-6,
                "{name}: {found:?}"
            );
        }
    }

    #[test]
    fn each_module_that_reads_a_file_stands_in_a_row() {
        let source = include_str!("lib.rs");
        let table = include_str!("format.rs").split_once("pub const FORMATS").unwrap().1;
        let table = table.split_once("impl Format").unwrap().0;
        // `motion` reads commands, no bytes.
        let modules = source.lines().filter_map(|line| line.strip_prefix("pub mod "));
        let readers: Vec<_> =
            modules.map(|name| name.trim_end_matches(';')).filter(|it| *it != "motion").collect();
        assert!(readers.len() >= 5, "{readers:?}");
        for reader in readers {
            assert!(table.contains(&format!("{reader}::read")), "{reader} stands in no row");
        }
    }

    #[test]
    fn an_ending_stands_in_one_row() {
        for ending in FORMATS.iter().flat_map(|format| format.endings) {
            let rows = FORMATS.iter().filter(|format| format.endings.contains(ending)).count();
            assert_eq!(rows, 1, "{ending}");
        }
        assert!(Format::of_file("part.sbp").is_none() && Format::of_file("dxf").is_none());
    }

    #[test]
    fn messages_list_what_is_read_and_what_is_written() {
        assert_eq!(readable(), ".dxf, .svg, .rsg, .rsm, .plt, .hpg or .hpgl");
        assert_eq!(writable(), ".rsg, .dxf or .svg");
    }
}
