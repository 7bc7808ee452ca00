//! From entities to shapes.

use super::file::{Block, Entity, File, entities};
use super::map::{Map3, Vec3};
use super::tag::{Tag, tags};
use super::unseen::Unseen;
use super::write::Notes;
use super::{curves, insert, polyline, skipped, units};
use crate::Imported;
use crate::effort::{Effort, MOST_PLACED};
use crate::finding::Findings;
use crate::layers::Layers;
use crate::rsg::MARK;
use kerf_drawing::{Drawing, Shape};
use kerf_geom::{Point2, Polyarc, fit, tol};

/// Options with which a file is read.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// Draw what blocks hold where INSERT places them; else each INSERT is only counted.
    pub explode: bool,
    /// Take the drawing's own unit (`$INSUNITS`) into account; else a unit is a millimetre.
    pub scale: bool,
    /// Draw also what drawing programs do not show: layers that are off or frozen, what is invisible.
    pub unseen: bool,
    /// Leave entities that bear a comment of Kerf as they are written: paths of a job whose end is their start are open,
    /// with leads before and behind.
    pub as_written: bool,
    /// Greatest distance of arcs from the ellipses and splines they replace, millimetres.
    pub tolerance_mm: f64,
    /// Entities that INSERT draws, at the most, beyond those that the file writes: blocks in blocks can multiply without
    /// bound.
    pub most_placed: u64,
}

impl Default for Options {
    fn default() -> Self {
        let (tolerance_mm, most_placed) = (tol::FIT_MM, MOST_PLACED);
        let (unseen, as_written) = (false, false);
        Self { explode: true, scale: true, unseen, as_written, tolerance_mm, most_placed }
    }
}

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
    let mut import = Import {
        file: &file,
        options: *options,
        findings,
        shapes: Vec::new(),
        layers: Layers::default(),
        notes: Vec::new(),
        open_blocks: Vec::new(),
        unseen: Unseen::default(),
        effort: effort(&tags, options, given_up),
    };
    let world = Place { map: Map3::scaled(unit, unit, unit), layer: None };
    for section in &file.entities {
        import.entities(section, &world);
    }
    import.unseen.tell(&file.unseen, &mut import.findings);
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

/// Destination of entities: the world, or the world by way of a block.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place<'a> {
    /// From the frame of the entities to the world.
    pub map: Map3,
    /// The layer of the INSERT, which entities on layer 0 of a block take over.
    pub layer: Option<&'a [u8]>,
}

impl<'a> Place<'a> {
    /// The layer of an entity: what stands on layer 0 of a block stands on that of its INSERT.
    pub fn layer_of(&self, entity: &Entity<'_, 'a>) -> &'a [u8] {
        let own = entity.tag(8).map_or(b"0".as_slice(), |tag| tag.name());
        self.layer.filter(|_| own == b"0").unwrap_or(own)
    }
}

/// A block that is being drawn.
pub(super) struct OpenBlock<'f, 'a> {
    /// Its name in the table of blocks.
    pub key: &'f [u8],
    /// Its name as the INSERT has it.
    pub name: &'a [u8],
    /// The line of the INSERT.
    pub line: u32,
}

/// State of an import.
pub(super) struct Import<'f, 'a, 'g> {
    pub file: &'f File<'f, 'a>,
    pub options: Options,
    pub findings: Findings,
    shapes: Vec<Shape>,
    layers: Layers,
    /// The comment in the entity of each shape, empty where there is none.
    notes: Vec<String>,
    /// The blocks being drawn, outermost first.
    pub open_blocks: Vec<OpenBlock<'f, 'a>>,
    unseen: Unseen<'a>,
    effort: Effort<'g>,
}

impl<'f, 'a> Import<'f, 'a, '_> {
    fn finish(mut self, head: Vec<String>) -> (Imported, Notes) {
        let ended = self.effort.ended();
        if ended.is_some() {
            (self.shapes, self.layers, self.notes) = Default::default();
        }
        let layers = self.layers.list;
        let skipped = self.findings.skipped();
        let drawing = Drawing::of(self.shapes);
        let findings = self.findings.finish();
        let read = Imported { drawing, findings, layers, skipped, ended };
        (read, Notes { head, shapes: self.notes, layers: false })
    }

    /// Draws the entities of a section or a block.
    pub fn entities(&mut self, tags: &'f [Tag<'a>], place: &Place<'a>) {
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
            if !self.options.unseen
                && self.unseen.hides(&entity, place.layer_of(&entity), &self.file.unseen)
            {
                continue;
            }
            match entity.name {
                b"POLYLINE" => polyline::old(self, &entity, &mut rest, place),
                b"INSERT" => insert::insert(self, &entity, place),
                _ => self.single(&entity, place),
            }
        }
    }

    /// Counts an entity, or a copy of an empty block; nothing more is drawn when this is false.
    pub fn goes_on(&mut self) -> bool {
        let goes_on = self.effort.goes_on(!self.open_blocks.is_empty());
        self.tell_too_much();
        goes_on
    }

    /// True when nothing more is drawn.
    pub const fn is_over(&self) -> bool {
        self.effort.ended().is_some()
    }

    /// Tells of the block that draws too much, if that is so.
    fn tell_too_much(&mut self) {
        let Some(outermost) = self.open_blocks.first().filter(|_| self.is_over()) else { return };
        let what = format!("INSERT of block `{}`", super::tag::decoded(outermost.name));
        let mend = "give it and the blocks within it fewer rows and columns, or draw the shapes without blocks";
        self.effort.tell(&what, (outermost.line, 0), mend, &mut self.findings);
    }

    fn single(&mut self, entity: &Entity<'f, 'a>, place: &Place<'a>) {
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

    /// Tells of an entity that nobody knows.
    pub fn unknown(&mut self, entity: &Entity<'f, 'a>) {
        let shown: String = entity.shown().chars().take(30).collect();
        let text = format!("`{shown}` is no entity that DXF has: left out");
        self.findings.warn("unknown", entity.line, text);
    }

    fn line(&mut self, entity: &Entity<'f, 'a>, place: &Place<'a>) {
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

    fn point(&mut self, entity: &Entity<'f, 'a>, place: &Place<'a>) {
        if let Some(at) = self.corner(entity, 0) {
            self.add(entity, place, Shape::point(place.map.apply(at).flat()));
        }
    }

    fn circle(&mut self, entity: &Entity<'f, 'a>, place: &Place<'a>) {
        let Some((centre, radius)) = self.centre_and_radius(entity) else { return };
        let path = Polyarc::circle(centre.flat(), radius);
        self.flat(entity, place, &path, centre.z);
    }

    fn arc(&mut self, entity: &Entity<'f, 'a>, place: &Place<'a>) {
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

    /// The place in the codes 10, 20, 30 or the next three; without a height it is at 0.
    pub fn corner(&mut self, entity: &Entity<'f, 'a>, number: u16) -> Option<Vec3> {
        let x = entity.real(10 + number, &mut self.findings)?;
        let y = entity.real(20 + number, &mut self.findings)?;
        Some(Vec3::new(x, y, entity.real_or(30 + number, 0.0, &mut self.findings)))
    }

    /// The map from the frame in which an entity is drawn to the world.
    pub fn frame(&mut self, entity: &Entity<'f, 'a>, place: &Place<'a>) -> Map3 {
        Map3::of_extrusion(self.extrusion(entity)).then(&place.map)
    }

    fn extrusion(&mut self, entity: &Entity<'f, 'a>) -> Vec3 {
        let x = entity.real_or(210, 0.0, &mut self.findings);
        let y = entity.real_or(220, 0.0, &mut self.findings);
        let z = entity.real_or(230, 1.0, &mut self.findings);
        Vec3::new(x, y, z)
    }

    /// Adds a path drawn in the plane of an entity at a height.
    pub fn flat(
        &mut self,
        entity: &Entity<'f, 'a>,
        place: &Place<'a>,
        path: &Polyarc,
        height: f64,
    ) {
        let map = self.frame(entity, place);
        if !map.keeps_level() {
            return self.slanted(entity, place, path, height, &map);
        }
        let unit = map.plane(height);
        match fit::affine(path, &unit, self.options.tolerance_mm) {
            Ok(path) => self.add(entity, place, Shape::flat(path)),
            Err(error) => {
                let text = format!("{}: {error}: left out", entity.shown());
                self.findings.warn("map", entity.line, text);
            }
        }
    }

    /// A path in a plane that is not level has heights: arcs become short lines in space.
    fn slanted(
        &mut self,
        entity: &Entity<'f, 'a>,
        place: &Place<'a>,
        path: &Polyarc,
        height: f64,
        map: &Map3,
    ) {
        let chords = curves::chords(path, self.options.tolerance_mm);
        let space = |at: Point2| map.apply(Vec3::new(at.x, at.y, height));
        let places = chords.into_iter().map(space).collect();
        self.in_space(entity, place, places, path.closed);
    }

    /// Adds straight lines through places of the world.
    pub fn in_space(
        &mut self,
        entity: &Entity<'f, 'a>,
        place: &Place<'a>,
        mut places: Vec<Vec3>,
        closed: bool,
    ) {
        places.dedup();
        let returns = places.len() > 2 && places.first() == places.last();
        if returns {
            places.pop();
        }
        if places.len() < 2 {
            let text = format!("{} without length: left out", entity.shown());
            return self.findings.warn("length", entity.line, text);
        }
        let closed = closed || returns;
        let heights = places.iter().map(|p| p.z).collect();
        let path = Polyarc::lines(places.into_iter().map(Vec3::flat), closed);
        self.add(entity, place, Shape::with_heights(path, heights));
    }

    /// Adds a shape to the drawing and to its layer.
    pub fn add(&mut self, entity: &Entity<'f, 'a>, place: &Place<'a>, shape: Shape) {
        let note = entity.tag(999).map(Tag::text).unwrap_or_default();
        let stays = entity.name == b"POINT" || self.options.as_written && note.starts_with(MARK);
        let tidied = if stays { Some(shape) } else { crate::tidy::tidied(shape) };
        let Some(shape) = tidied else {
            let text = format!("{} without length: left out", entity.shown());
            return self.findings.warn("length", entity.line, text);
        };
        if let Err(error) = shape.path.check() {
            let text = format!("{}: {error}: left out", entity.shown());
            self.findings.warn("place", entity.line, text);
            return;
        }
        let layer = place.layer_of(entity);
        self.layers.add(layer, self.shapes.len(), || super::tag::decoded(layer));
        self.notes.push(note);
        if !self.open_blocks.is_empty() {
            self.effort.drew(shape.path.vertices.len());
            self.tell_too_much();
        }
        self.shapes.push(shape);
    }

    /// The block of a name.
    pub fn block(&self, name: &[u8]) -> Option<(&'f [u8], Block<'f, 'a>)> {
        let (name, block) = self.file.blocks.get_key_value(&name.to_ascii_uppercase())?;
        Some((name, *block))
    }
}
