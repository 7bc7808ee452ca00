//! From entities to shapes.

use super::file::{Entity, File, entities};
use super::importing::{Destination, Import, Options};
use super::map::{Map3, Vec3};
use super::tag::{Tag, tags};
use super::write::Notes;
use super::{curves, insert, polyline, skipped, units};
use crate::Imported;
use crate::effort::Effort;
use crate::finding::Findings;
use kerf_drawing::Shape;
use kerf_geom::Polyarc;

/// Reads a DXF file, as far as sense goes.
///
/// ```
/// let text = "0\nSECTION\n2\nENTITIES\n0\nLINE\n10\n0\n20\n0\n11\n30\n21\n40\n0\nENDSEC\n0\nEOF\n";
/// let read = kerf_formats::dxf::read(text.as_bytes(), &Default::default());
/// assert_eq!(read.drawing.shapes[0].path.length(), 50.0);
/// assert!(read.findings.is_empty());
/// ```
pub fn read(bytes: &[u8], options: &Options) -> Imported {
    read_until(bytes, options, &|| false)
}

/// The same, until it is given up: then nothing is read.
pub fn read_until(bytes: &[u8], options: &Options, given_up: &dyn Fn() -> bool) -> Imported {
    let mut read = read_with_notes(bytes, options, given_up).0;
    read.heighten();
    read
}

/// Reads a DXF file with the comments at its head and in its entities.
pub(crate) fn read_with_notes(
    bytes: &[u8],
    options: &Options,
    given_up: &dyn Fn() -> bool,
) -> (Imported, Notes) {
    let mut findings = Findings::default();
    let tags = tags(bytes, &mut findings);
    if tags.is_empty() {
        let empty = bytes.trim_ascii().is_empty();
        findings.warn("end", 1, if empty { "the file is empty" } else { "the file is no DXF" });
    }
    let file = File::of(&tags, &mut findings);
    let unit = unit(&file, options, &mut findings);
    let effort = effort(&tags, options, given_up);
    let mut import = Import::new(&file, *options, findings, effort);
    let world = Destination { map: Map3::scaled(unit, unit, unit), layer: None };
    for section in &file.entities {
        import.entities(section, &world);
    }
    import.tell_unseen();
    let head = tags.iter().take_while(|tag| tag.code == 999).map(Tag::text).collect();
    import.finish(head)
}

/// INSERT may draw as many entities as the file writes for nothing.
fn effort<'g>(tags: &[Tag], options: &Options, given_up: &'g dyn Fn() -> bool) -> Effort<'g> {
    let entities = tags.iter().filter(|tag| tag.code == 0).count();
    Effort::of(entities, tags.len(), given_up).at_most(options.most_placed)
}

fn unit(file: &File, options: &Options, findings: &mut Findings) -> f64 {
    let Some(tag) = file.header.get(b"$INSUNITS".as_slice()).filter(|_| options.scale) else {
        return 1.0;
    };
    match tag.whole().and_then(units::unit) {
        Some((factor, name)) if factor != 1.0 => {
            findings.note("unit", tag.line, format!("drawn in {name}: scaled by {factor}"));
            factor
        }
        _ => 1.0,
    }
}

impl<'f, 'a> Import<'f, 'a, '_> {
    /// Draws the entities of a section or a block.
    pub fn entities(&mut self, tags: &'f [Tag<'a>], place: &Destination<'a>) {
        let mut rest = entities(tags).peekable();
        while let Some(entity) = rest.next() {
            if !self.goes_on() {
                return;
            }
            // Paper space is the sheet around the drawing, not the drawing.
            if entity.whole(67, &mut self.findings) == 1 {
                self.findings.skip("(paper space)");
                continue;
            }
            if self.hides(&entity, place) {
                continue;
            }
            match entity.name {
                b"POLYLINE" => polyline::old(self, &entity, &mut rest, place),
                b"INSERT" => insert::insert(self, &entity, place),
                _ => self.single(&entity, place),
            }
        }
    }

    fn single(&mut self, entity: &Entity<'f, 'a>, place: &Destination<'a>) {
        match entity.name {
            b"LINE" => self.line(entity, place),
            b"POINT" => self.point(entity, place),
            b"CIRCLE" => self.circle(entity, place),
            b"ARC" => self.arc(entity, place),
            b"LWPOLYLINE" => polyline::light(self, entity, place),
            b"ELLIPSE" => curves::ellipse(self, entity, place),
            b"SPLINE" => curves::spline(self, entity, place),
            // Parts of entities that were told already.
            b"VERTEX" | b"SEQEND" | b"ATTRIB" | b"ENDSEC" | b"EOF" => {}
            name if skipped::is_known(name) => self.findings.skip(&entity.shown()),
            _ => self.unknown(entity),
        }
    }

    fn line(&mut self, entity: &Entity<'f, 'a>, place: &Destination<'a>) {
        let (from, to) = (self.corner(entity, 0), self.corner(entity, 1));
        let (Some(from), Some(to)) = (from, to) else { return };
        let ends = [place.map.apply(from), place.map.apply(to)];
        let path = Polyarc::lines(ends.map(Vec3::flat), false);
        if ends[0] == ends[1] {
            self.findings.warn("length", entity.line, "LINE without length: left out");
        } else if ends[0].z == ends[1].z {
            self.add(entity, place, Shape::flat(path));
        } else {
            let heights = ends.map(|end| end.z).to_vec();
            self.add(entity, place, Shape::with_heights(path, heights));
        }
    }

    fn point(&mut self, entity: &Entity<'f, 'a>, place: &Destination<'a>) {
        if let Some(at) = self.corner(entity, 0) {
            self.add(entity, place, Shape::point(place.map.apply(at).flat()));
        }
    }

    fn circle(&mut self, entity: &Entity<'f, 'a>, place: &Destination<'a>) {
        let Some((centre, radius)) = self.centre_and_radius(entity) else { return };
        let path = Polyarc::circle(centre.flat(), radius);
        self.flat(entity, place, &path, centre.z);
    }

    fn arc(&mut self, entity: &Entity<'f, 'a>, place: &Destination<'a>) {
        let Some((centre, radius)) = self.centre_and_radius(entity) else { return };
        let from = entity.real(50, &mut self.findings);
        let to = entity.real(51, &mut self.findings);
        let (Some(from), Some(to)) = (from, to) else { return };
        // Counter-clockwise; equal angles are the full circle.
        let sweep = (to - from).rem_euclid(360.0);
        let path = if sweep == 0.0 {
            Polyarc::circle(centre.flat(), radius)
        } else {
            Polyarc::arc(centre.flat(), radius, from.to_radians(), sweep.to_radians())
        };
        self.flat(entity, place, &path, centre.z);
    }

    fn centre_and_radius(&mut self, entity: &Entity<'f, 'a>) -> Option<(Vec3, f64)> {
        let centre = self.corner(entity, 0)?;
        let radius = entity.real(40, &mut self.findings)?;
        if radius <= 0.0 {
            let text = format!("{} of radius {radius}: left out", entity.shown());
            self.findings.warn("radius", entity.line, text);
            return None;
        }
        Some((centre, radius))
    }
}
