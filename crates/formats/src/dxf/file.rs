//! A DXF file as header, blocks and entities.

use super::tag::Tag;
use super::unseen::{self, Layers};
use crate::finding::Findings;
use std::collections::BTreeMap;

/// An entity: its name and the pairs that follow.
#[derive(Clone, Copy, Debug)]
pub struct Entity<'f, 'a> {
    /// `LINE`, `INSERT`, …
    pub name: &'a [u8],
    /// Line of the file where it begins.
    pub line: u32,
    /// Its pairs.
    pub tags: &'f [Tag<'a>],
}

impl<'a> Entity<'_, 'a> {
    /// The first pair with a code.
    pub fn tag(&self, code: u16) -> Option<&Tag<'a>> {
        self.tags.iter().find(|tag| tag.code == code)
    }

    /// The number of the first pair with a code, or a default where there is none. What is no number
    /// is told, and then the default holds too.
    pub fn real_or(&self, code: u16, default: f64, findings: &mut Findings) -> f64 {
        let Some(tag) = self.tag(code) else { return default };
        tag.real().unwrap_or_else(|| {
            findings.warn("number", tag.line, self.no_number(tag));
            default
        })
    }

    /// The number of the first pair with a code; nothing, and a finding, where there is none.
    pub fn real(&self, code: u16, findings: &mut Findings) -> Option<f64> {
        let Some(tag) = self.tag(code) else {
            let text = format!("{} without the value of group code {code}: left out", self.shown());
            findings.warn("missing", self.line, text);
            return None;
        };
        let value = tag.real();
        if value.is_none() {
            findings.warn("number", tag.line, self.no_number(tag) + ": left out");
        }
        value
    }

    /// A whole number, 0 where there is none. What is no number is told.
    pub fn whole(&self, code: u16, findings: &mut Findings) -> i64 {
        let Some(tag) = self.tag(code) else { return 0 };
        tag.whole().unwrap_or_else(|| {
            findings.warn("number", tag.line, self.no_number(tag) + ": taken for 0");
            0
        })
    }

    /// Its name for people.
    pub fn shown(&self) -> String {
        super::tag::decoded(self.name)
    }

    fn no_number(&self, tag: &Tag) -> String {
        let shown: String = tag.text().chars().take(30).collect();
        format!("{}: `{shown}` is no number (group code {})", self.shown(), tag.code)
    }
}

/// A block: entities that INSERT places again.
#[derive(Clone, Copy, Debug)]
pub struct Block<'f, 'a> {
    /// The BLOCK entity, with its base point.
    pub head: Entity<'f, 'a>,
    /// Its entities.
    pub tags: &'f [Tag<'a>],
}

/// The parts of a file that Kerf reads.
#[derive(Clone, Debug, Default)]
pub struct File<'f, 'a> {
    /// Variables of the header: the first pair after each name.
    pub header: BTreeMap<&'a [u8], Tag<'a>>,
    /// Blocks by name, in capitals.
    pub blocks: BTreeMap<Vec<u8>, Block<'f, 'a>>,
    /// Layers that are not seen.
    pub unseen: Layers,
    /// Pairs of the entities.
    pub entities: Vec<&'f [Tag<'a>]>,
}

impl<'f, 'a> File<'f, 'a> {
    /// Finds the sections. A file without any is taken for bare entities; one that breaks off is told.
    pub fn of(tags: &'f [Tag<'a>], findings: &mut Findings) -> Self {
        let mut file = Self::default();
        let mut rest = tags;
        tell_early_end(tags, findings);
        while let Some(start) = rest.iter().position(|tag| is(tag, 0, b"SECTION")) {
            rest = &rest[start + 1..];
            let ends = |tag: &Tag| is(tag, 0, b"ENDSEC") || is(tag, 0, b"SECTION");
            let end = rest.iter().position(ends).unwrap_or(rest.len());
            if let Some(next) = rest.get(end).filter(|next| is(next, 0, b"SECTION")) {
                findings.warn("end", next.line, "the section before this one has no ENDSEC");
            }
            file.add_section(&rest[..end]);
            rest = &rest[end..];
        }
        if file.entities.is_empty() && file.blocks.is_empty() && file.header.is_empty() {
            file.entities.push(tags);
        }
        file
    }

    fn add_section(&mut self, tags: &'f [Tag<'a>]) {
        let Some((first, body)) = tags.split_first() else { return };
        match (first.code, first.name()) {
            (2, b"HEADER") => self.read_header(body),
            (2, b"TABLES") => self.unseen.extend(unseen::layers(body)),
            (2, b"BLOCKS") => self.read_blocks(body),
            (2, b"ENTITIES") => self.entities.push(body),
            _ => {}
        }
    }

    fn read_header(&mut self, tags: &'f [Tag<'a>]) {
        for pair in tags.windows(2) {
            if pair[0].code == 9 {
                self.header.entry(pair[0].name()).or_insert(pair[1]);
            }
        }
    }

    fn read_blocks(&mut self, tags: &'f [Tag<'a>]) {
        let mut rest = tags;
        while let Some(start) = rest.iter().position(|tag| is(tag, 0, b"BLOCK")) {
            rest = &rest[start..];
            let ends = |tag: &Tag| is(tag, 0, b"ENDBLK") || is(tag, 0, b"BLOCK");
            let end = rest.iter().skip(1).position(ends).map_or(rest.len(), |n| n + 1);
            let head = entities(&rest[..end]).next();
            if let Some(head) = head {
                let name = head.tag(2).map(|tag| tag.name().to_ascii_uppercase());
                let tags = &rest[1 + head.tags.len()..end];
                self.blocks.entry(name.unwrap_or_default()).or_insert(Block { head, tags });
            }
            rest = &rest[end..];
        }
    }
}

/// A file with sections ends with EOF: one without may have lost something, and nobody would see it.
fn tell_early_end(tags: &[Tag], findings: &mut Findings) {
    let Some(last) = tags.last() else { return };
    if is(last, 0, b"EOF") {
        return;
    }
    let edge = |tag: &&Tag| is(tag, 0, b"SECTION") || is(tag, 0, b"ENDSEC");
    match tags.iter().rfind(edge) {
        Some(open) if is(open, 0, b"SECTION") => {
            let text = "the file breaks off within a section: what came after this line is lost";
            findings.warn("end", last.line, text);
        }
        Some(_) => {
            let text = "the file ends without EOF: something may be missing";
            findings.warn("end", last.line, text);
        }
        None => {}
    }
}

fn is(tag: &Tag, code: u16, name: &[u8]) -> bool {
    tag.code == code && tag.name() == name
}

/// The entities of a row of pairs. Pairs before the first are passed over.
pub fn entities<'f, 'a>(tags: &'f [Tag<'a>]) -> impl Iterator<Item = Entity<'f, 'a>> {
    let start = tags.iter().position(|tag| tag.code == 0).unwrap_or(tags.len());
    let mut rest = &tags[start..];
    std::iter::from_fn(move || {
        let (first, tail) = rest.split_first()?;
        let end = tail.iter().position(|tag| tag.code == 0).unwrap_or(tail.len());
        let (tags, after) = tail.split_at(end);
        rest = after;
        Some(Entity { name: first.name(), line: first.line, tags })
    })
}
