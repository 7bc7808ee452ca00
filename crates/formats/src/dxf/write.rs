//! DXF Release 12, as text: what every drawing program reads.

use kerf_drawing::{Drawing, Group, Kind, Shape};
use std::fmt::{Display, Write};

/// Beginning of a comment of Kerf.
pub(crate) const MARK: &str = "KERF ";

/// Contents of a file besides lines and arcs.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Notes {
    /// Comment lines at the head of the file.
    pub head: Vec<String>,
    /// A comment for each shape.
    pub shapes: Vec<String>,
    /// Each group has a layer of its name and colour; else all shapes are on layer 0.
    pub layers: bool,
}

/// A drawing as DXF Release 12. Groups, arrays, heights of arcs and pause marks are lost; order,
/// starts and directions stay.
pub fn write(drawing: &Drawing) -> String {
    write_with(drawing, &Notes::default())
}

pub(crate) fn write_with(drawing: &Drawing, notes: &Notes) -> String {
    let mut out = Pairs(String::with_capacity(256 * drawing.shapes.len() + 2048));
    notes.head.iter().for_each(|line| out.pair(999, line));
    header(&mut out, drawing);
    tables(&mut out, notes.layers);
    out.section("BLOCKS", |_| {});
    out.section("ENTITIES", |out| {
        for (n, shape) in drawing.shapes.iter().enumerate() {
            entity(out, shape, notes.shapes.get(n), notes.layers);
        }
    });
    out.pair(0, "EOF");
    out.0
}

/// Pairs of group code and value.
struct Pairs(String);

impl Pairs {
    fn pair(&mut self, code: u16, value: impl Display) {
        // Writing to a string cannot fail.
        let _ = writeln!(self.0, "{code:3}\n{value}");
    }

    fn place(&mut self, x: f64, y: f64, z: f64) {
        self.pair(10, x);
        self.pair(20, y);
        self.pair(30, z);
    }

    fn section(&mut self, name: &str, body: impl FnOnce(&mut Self)) {
        self.pair(0, "SECTION");
        self.pair(2, name);
        body(self);
        self.pair(0, "ENDSEC");
    }

    fn table(&mut self, name: &str, count: usize, body: impl FnOnce(&mut Self)) {
        self.pair(0, "TABLE");
        self.pair(2, name);
        self.pair(70, count);
        body(self);
        self.pair(0, "ENDTAB");
    }
}

fn header(out: &mut Pairs, drawing: &Drawing) {
    out.section("HEADER", |out| {
        out.pair(9, "$ACADVER");
        out.pair(1, "AC1009");
        if let Some(bounds) = drawing.bounds() {
            for (name, corner) in [("$EXTMIN", bounds.min), ("$EXTMAX", bounds.max)] {
                out.pair(9, name);
                out.place(corner.x, corner.y, 0.0);
            }
        }
    });
}

fn tables(out: &mut Pairs, layers: bool) {
    out.section("TABLES", |out| {
        out.table("LTYPE", 1, |out| {
            out.pair(0, "LTYPE");
            out.pair(2, "CONTINUOUS");
            out.pair(70, 0);
            out.pair(3, "Solid line");
            out.pair(72, 65);
            out.pair(73, 0);
            out.pair(40, 0.0);
        });
        let groups = if layers { &Group::ALL[..] } else { &[] };
        out.table("LAYER", 1 + groups.len(), |out| {
            layer(out, "0", 7);
            groups.iter().for_each(|group| layer(out, group.name(), group.dxf_colour()));
        });
    });
}

fn layer(out: &mut Pairs, name: &str, colour: u8) {
    out.pair(0, "LAYER");
    out.pair(2, name);
    out.pair(70, 0);
    out.pair(62, colour);
    out.pair(6, "CONTINUOUS");
}

fn entity(out: &mut Pairs, shape: &Shape, note: Option<&String>, layers: bool) {
    let layer = if layers { shape.group.name() } else { "0" };
    let start = |out: &mut Pairs, name: &str| {
        out.pair(0, name);
        note.iter().for_each(|note| out.pair(999, note));
        out.pair(8, layer);
    };
    if shape.kind() == Kind::Point {
        start(out, "POINT");
        let at = shape.start();
        return out.place(at.x, at.y, 0.0);
    }
    start(out, "POLYLINE");
    out.pair(66, 1);
    out.place(0.0, 0.0, 0.0);
    let solid = shape.z_mm.is_some();
    out.pair(70, u8::from(shape.is_closed()) + if solid { 8 } else { 0 });
    for (n, vertex) in shape.path.vertices.iter().enumerate() {
        out.pair(0, "VERTEX");
        out.pair(8, layer);
        out.place(vertex.at.x, vertex.at.y, shape.height_mm(n));
        if solid {
            out.pair(70, 32);
        } else if vertex.bulge != 0.0 {
            out.pair(42, vertex.bulge);
        }
    }
    out.pair(0, "SEQEND");
    out.pair(8, layer);
}
