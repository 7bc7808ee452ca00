//! The legend: blocks of rows flowing into columns right of the drawing, or under a wide one.

use super::columns::{flow, height, row_height, tallest, wrapped};
use super::depth::{DepthScale, SHADES};
use super::facts::{Block, Row, Sample};
use super::numbers;
use super::signs::{begin_sign, bounds_paint, end_sign, start_sign};
use super::steps::{multiples, round_step};
use super::view::{View, table_rect};
use crate::font::Font;
use crate::palette::{AIR, AXIS_X, EDGE, GRID, INK, PAPER, Rgb, SOFT};
use crate::scene::Unit;
use crate::sheet::{Anchor, Frame, Layer, Mark, Outline, Paint, Rect, Text};
use kerf_geom::{Point2, Vec2};

/// Width of a column beside the drawing, em.
const COLUMN: f64 = 21.0;
/// The least width of a column under the drawing, em.
const NARROWEST: f64 = 18.0;
/// Gap between columns, em.
const GAP: f64 = 2.5;
/// Space between blocks, em.
pub const BETWEEN: f64 = 1.1;
/// Height of the small map, em.
pub const MAP: f64 = 9.0;
/// Drawings wider than this share of their height have the legend below.
const WIDE: f64 = 1.7;
/// Letters in a viewer's own font may be so much wider than ours.
pub const WIDER: f64 = 1.08;

/// Layout of the legend's columns.
#[derive(Clone, Debug, PartialEq)]
pub struct Legend {
    columns: Vec<Vec<Block>>,
    /// Width of a column, em.
    width: f64,
    /// The whole legend, page coordinates.
    pub area: Rect,
}

impl Legend {
    /// Arranges blocks beside or below the drawing; `below` is how far the rulers reach, mm.
    pub fn arrange(blocks: Vec<Block>, view: &View, below: f64) -> Self {
        if view.panel.w > WIDE * view.panel.h {
            Self::under(blocks, view, below)
        } else {
            Self::beside(blocks, view)
        }
    }

    /// As many columns as fit under the drawing, filling its width.
    fn under(blocks: Vec<Block>, view: &View, below: f64) -> Self {
        let (p, em) = (view.panel, view.em);
        let count = ((p.w / em + GAP) / (NARROWEST + GAP)).floor().max(1.0);
        let width = (p.w / em + GAP) / count - GAP;
        let columns = flow(wrapped(blocks, width), count as usize);
        let area = Rect { x: p.x, y: p.bottom() + below + em, w: p.w, h: tallest(&columns) * em };
        Self { columns, width, area }
    }

    /// As many columns as keep the legend about as high as the drawing.
    fn beside(blocks: Vec<Block>, view: &View) -> Self {
        let (p, em) = (view.panel, view.em);
        let blocks = wrapped(blocks, COLUMN);
        let tall: f64 = blocks.iter().map(|b| height(b) + BETWEEN).sum();
        let room = (1.15 * p.h / em + 3.0).max(34.0);
        let columns = flow(blocks, (tall / room).ceil().clamp(1.0, 3.0) as usize);
        let width = columns.len() as f64 * (COLUMN + GAP) - GAP;
        let x = p.right() + GAP * em;
        let area = Rect { x, y: p.y, w: width * em, h: tallest(&columns) * em };
        Self { columns, width: COLUMN, area }
    }

    /// Draws it.
    pub fn draw(&self, view: &View, unit: Unit) -> Layer {
        let mut layer = Layer::new("legend", Frame::Page, false);
        for (i, column) in self.columns.iter().enumerate() {
            let x = self.area.x + i as f64 * (self.width + GAP) * view.em;
            let mut writer = Writer {
                layer: &mut layer,
                view,
                unit,
                x,
                y: self.area.y,
                width: self.width,
                fonts: [Font::new(false), Font::new(true)],
            };
            for block in column {
                block.iter().for_each(|row| writer.row(row));
                writer.y += BETWEEN * view.em;
            }
        }
        layer
    }
}

struct Writer<'a> {
    layer: &'a mut Layer,
    view: &'a View,
    unit: Unit,
    x: f64,
    y: f64,
    /// Width of the column, em.
    width: f64,
    fonts: [Font; 2],
}

impl Writer<'_> {
    fn row(&mut self, row: &Row) {
        match row {
            Row::Head(text) => self.head(text),
            Row::Pair(name, value) => self.pair(name, value),
            Row::Cells(cells) => self.cells(cells),
            Row::Key(sample, text) => self.key(*sample, text),
            Row::Depth(scale) => self.depth(scale),
            Row::Map => self.map(),
            Row::Note(text, colour) => {
                self.text(0.0, 1.0, Anchor::Start, self.width, *colour, text)
            }
        }
        self.y += row_height(row) * self.view.em;
    }

    /// A place so many em from the column's corner and the row's upper edge.
    fn at(&self, x: f64, y: f64) -> Point2 {
        Point2::new(self.x + x * self.view.em, self.y + y * self.view.em)
    }

    fn text(&mut self, x: f64, y: f64, anchor: Anchor, room: f64, colour: Rgb, text: &str) {
        let text = self.fonts[0].fitted(text, room / WIDER + 1e-9);
        self.put(x, y, anchor, false, colour, text);
    }

    fn put(&mut self, x: f64, y: f64, anchor: Anchor, bold: bool, colour: Rgb, text: String) {
        let at = self.at(x, y);
        let text = Text { at, size: self.view.em, anchor, bold, colour, halo: false, text };
        self.layer.marks.push(Mark::Text(text));
    }

    fn head(&mut self, text: &str) {
        let text = self.fonts[1].fitted(text, self.width / WIDER);
        self.put(0.0, 1.0, Anchor::Start, true, INK, text);
        let mut line = Outline::default();
        line.segment(self.at(0.0, 1.38), self.at(self.width, 1.38));
        self.layer.path(line, Paint::line(GRID, 0.07 * self.view.em));
    }

    fn pair(&mut self, name: &str, value: &str) {
        let value = self.fonts[0].fitted(value, 0.7 * self.width);
        let room = self.width - WIDER * self.fonts[0].width(&value) - 0.6;
        self.text(0.0, 1.0, Anchor::Start, room, SOFT, name);
        self.put(self.width, 1.0, Anchor::End, false, INK, value);
    }

    fn cells(&mut self, cells: &[String; 4]) {
        self.text(0.0, 1.0, Anchor::Start, 2.0, SOFT, &cells[0]);
        let heading = cells[0].is_empty();
        for (cell, right) in cells[1..].iter().zip([0.39, 0.695, 1.0].map(|s| s * self.width)) {
            self.text(right, 1.0, Anchor::End, 6.2, if heading { SOFT } else { INK }, cell);
        }
    }

    fn key(&mut self, sample: Sample, text: &str) {
        self.sample(sample);
        self.text(4.4, 1.05, Anchor::Start, self.width - 4.4, INK, text);
    }

    fn sample(&mut self, sample: Sample) {
        let em = self.view.em;
        let (left, middle, right) = (self.at(0.2, 0.7), self.at(1.8, 0.7), self.at(3.4, 0.7));
        let mut line = Outline::default();
        line.segment(left, right);
        let deep = DepthScale::colour(SHADES * 2 / 3);
        match sample {
            Sample::Cut => self.layer.path(line, Paint::line(deep, 0.16 * em)),
            Sample::Coloured(colour, wide) => {
                if wide {
                    self.layer
                        .path(line.clone(), Paint::line(colour.mixed(PAPER, super::BAND), em));
                }
                self.layer.path(line, Paint::line(colour, 0.16 * em));
            }
            Sample::Begin => begin_sign(self.layer, middle, Vec2::new(1.0, 0.0), em),
            Sample::Bounds => self.layer.path(line, bounds_paint(em)),
            Sample::Air => self.layer.path(line, Paint::line(AIR, 0.1 * em)),
            Sample::Cutter => {
                self.layer.path(line.clone(), Paint::line(deep.mixed(PAPER, super::BAND), em));
                self.layer.path(line, Paint::line(deep, 0.14 * em));
            }
            Sample::Jog => self.layer.path(line, super::jog_paint(em)),
            Sample::Plunge => self.dot(middle, deep),
            Sample::Drilled(colour) => self.dot(middle, colour),
            Sample::Arrow => {
                let mut head = Outline::default();
                super::signs::head(&mut head, middle, Vec2::new(1.0, 0.0), em);
                self.layer.path(head, Paint::fill(INK));
            }
            Sample::Start => start_sign(self.layer, middle, em),
            Sample::End => end_sign(self.layer, middle, em),
        }
    }

    fn dot(&mut self, middle: Point2, colour: Rgb) {
        let mut dot = Outline::default();
        dot.circle(middle, 0.34 * self.view.em);
        self.layer.path(dot, Paint::fill(colour));
    }

    fn depth(&mut self, scale: &DepthScale) {
        let em = self.view.em;
        let title = format!("Depth of cut (Z), {}", self.unit.symbol);
        self.text(0.0, 1.0, Anchor::Start, self.width, SOFT, &title);
        let (left, top) = (self.x, self.y + 1.5 * em);
        let cell = self.width * em / SHADES as f64;
        for shade in 0..SHADES {
            let colour = if scale.is_flat() { SHADES - 1 } else { shade };
            let bar = Rect { x: left + shade as f64 * cell, y: top, w: 1.02 * cell, h: 0.9 * em };
            self.layer.path(Outline::of_rect(bar), Paint::fill(DepthScale::colour(colour)));
        }
        if scale.is_flat() {
            let only = numbers::short(scale.bottom, self.unit, 4);
            return self.text(0.5 * self.width, 3.4, Anchor::Middle, self.width, INK, &only);
        }
        self.depth_numbers(scale);
    }

    /// Numbers at round heights, as many as there is room for.
    fn depth_numbers(&mut self, scale: &DepthScale) {
        let step = round_step(scale.range() / 5.0, self.unit);
        let mut ticks = Outline::default();
        // Up to here the line of numbers is taken, em.
        let mut taken = f64::NEG_INFINITY;
        for k in
            multiples(scale.bottom, scale.top, step.mm, 20).collect::<Vec<_>>().into_iter().rev()
        {
            let z = k as f64 * step.mm;
            let share = scale.share(z).clamp(0.0, 1.0);
            ticks.segment(self.at(share * self.width, 2.4), self.at(share * self.width, 2.65));
            let number = numbers::decimal(z, self.unit, step.decimals);
            // Numbers at the ends stay inside the column.
            let half = 0.5 * WIDER * self.fonts[0].width(&number);
            let x = (share * self.width).clamp(half, self.width - half);
            if x - half >= taken {
                self.text(x, 3.6, Anchor::Middle, 2.0 * half, INK, &number);
                taken = x + half + 0.5;
            }
        }
        self.layer.path(ticks, Paint::line(SOFT, 0.07 * self.view.em));
    }

    /// The table small, with the drawing's frame in it.
    fn map(&mut self) {
        let Some(table) = self.view.table.map(|t| table_rect(&t)) else { return };
        let (em, panel) = (self.view.em, self.view.panel);
        let all = table.around(&panel);
        let scale = (self.width * em / all.w).min(MAP * em / all.h);
        let corner = self.at(0.0, 0.5);
        let small = |r: Rect| Rect {
            x: corner.x + (r.x - all.x) * scale,
            y: corner.y + (r.y - all.y) * scale,
            w: r.w * scale,
            h: r.h * scale,
        };
        self.layer.path(Outline::of_rect(small(table)), Paint::edged(PAPER, EDGE, 0.1 * em));
        let here = small(panel);
        let seen = here.grown((0.25 * em - 0.5 * here.longer()).max(0.0));
        self.layer
            .path(Outline::of_rect(seen), Paint::edged(AXIS_X.mixed(PAPER, 0.8), AXIS_X, 0.1 * em));
    }
}
