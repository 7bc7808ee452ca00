//! An import on its way: options, shapes so far, and how one is added.

use super::chords::chords;
use super::file::{Block, Entity, File};
use super::map::{Map3, Vec3};
use super::tag::Tag;
use super::unseen::Unseen;
use super::write::{MARK, Notes};
use crate::Imported;
use crate::effort::{Effort, MOST_PLACED};
use crate::finding::Findings;
use crate::layers::Layers;
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

/// Destination of entities: the world, or the world by way of a block.
#[derive(Clone, Copy, Debug)]
pub(super) struct Destination<'a> {
    /// From the frame of the entities to the world.
    pub map: Map3,
    /// The layer of the INSERT, which entities on layer 0 of a block take over.
    pub layer: Option<&'a [u8]>,
}

impl<'a> Destination<'a> {
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

impl<'f, 'a, 'g> Import<'f, 'a, 'g> {
    /// With nothing drawn.
    pub fn new(
        file: &'f File<'f, 'a>,
        options: Options,
        findings: Findings,
        effort: Effort<'g>,
    ) -> Self {
        Self {
            file,
            options,
            findings,
            shapes: Vec::new(),
            layers: Layers::default(),
            notes: Vec::new(),
            open_blocks: Vec::new(),
            unseen: Unseen::default(),
            effort,
        }
    }

    /// What was drawn, with the comments at the head of the file.
    pub fn finish(mut self, head: Vec<String>) -> (Imported, Notes) {
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

    /// Returns `true` if drawing programs do not show an entity, and it shall not be drawn.
    pub fn hides(&mut self, entity: &Entity<'f, 'a>, place: &Destination<'a>) -> bool {
        !self.options.unseen && self.unseen.hides(entity, place.layer_of(entity), &self.file.unseen)
    }

    /// Tells what was not drawn because it is not shown.
    pub fn tell_unseen(&mut self) {
        self.unseen.tell(&self.file.unseen, &mut self.findings);
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

    /// Tells of an entity that nobody knows.
    pub fn unknown(&mut self, entity: &Entity<'f, 'a>) {
        let shown: String = entity.shown().chars().take(30).collect();
        let text = format!("`{shown}` is no entity that DXF has: left out");
        self.findings.warn("unknown", entity.line, text);
    }

    /// The place in the codes 10, 20, 30 or the next three; without a height it is at 0.
    pub fn corner(&mut self, entity: &Entity<'f, 'a>, number: u16) -> Option<Vec3> {
        let x = entity.real(10 + number, &mut self.findings)?;
        let y = entity.real(20 + number, &mut self.findings)?;
        Some(Vec3::new(x, y, entity.real_or(30 + number, 0.0, &mut self.findings)))
    }

    /// The map from the frame in which an entity is drawn to the world.
    pub fn frame(&mut self, entity: &Entity<'f, 'a>, place: &Destination<'a>) -> Map3 {
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
        place: &Destination<'a>,
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
        place: &Destination<'a>,
        path: &Polyarc,
        height: f64,
        map: &Map3,
    ) {
        let chords = chords(path, self.options.tolerance_mm);
        let space = |at: Point2| map.apply(Vec3::new(at.x, at.y, height));
        let places = chords.into_iter().map(space).collect();
        self.in_space(entity, place, places, path.closed);
    }

    /// Adds straight lines through places of the world.
    pub fn in_space(
        &mut self,
        entity: &Entity<'f, 'a>,
        place: &Destination<'a>,
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
    pub fn add(&mut self, entity: &Entity<'f, 'a>, place: &Destination<'a>, shape: Shape) {
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
