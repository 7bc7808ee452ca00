//! Paints a sheet as PNG, with the letters of the built-in font.

use crate::font::Font;
use crate::palette::{PAPER, Rgb};
use crate::sheet::{
    Anchor, Frame, Layer, Mark, Op, Outline, Paint, Sheet, Stroke, Text, arc_pieces,
};
use kerf_geom::{Point2, Vec2};
use tiny_skia::{
    Color, FillRule, LineCap, LineJoin, Mask, Path, PathBuilder, Pixmap, StrokeDash, Transform,
};

/// Thinner lines are painted this wide, pixels; below it they fade into the paper.
const THINNEST_PX: f64 = 0.7;
/// Curves are made of pieces of at most an eighth of a turn, where a cubic is off by less than
/// 10⁻⁵ of the radius.
const PIECE_RAD: f64 = std::f64::consts::FRAC_PI_4;

/// Reason why there is no picture.
#[derive(Debug, thiserror::Error)]
pub enum PngError {
    /// The size is zero or does not fit into memory.
    #[error("a picture of {width} × {height} pixels cannot be made; choose another size")]
    Size {
        /// Pixels across.
        width: u32,
        /// Pixels down.
        height: u32,
    },
    /// The encoder refused.
    #[error("the picture cannot be written as PNG: {0}")]
    Encoding(String),
}

/// Paints the sheet, its longer side `pixels` long.
pub fn paint(sheet: &Sheet, pixels: u32) -> Result<Vec<u8>, PngError> {
    let scale = f64::from(pixels) / sheet.page.longer();
    let [width, height] =
        [sheet.page.w, sheet.page.h].map(|mm| (mm * scale).round().max(1.0) as u32);
    let no_room = || PngError::Size { width, height };
    if pixels == 0 {
        return Err(no_room());
    }
    let mut pixmap = Pixmap::new(width, height).ok_or_else(no_room)?;
    pixmap.fill(colour(PAPER));
    let corner = Point2::new(sheet.page.x, sheet.page.y);
    let clip = clip(sheet, &pixmap, corner, scale).ok_or_else(no_room)?;
    let fonts = [Font::new(false), Font::new(true)];
    let mut brush = Brush { pixmap, corner, scale, flip: false, clip: None, fonts: &fonts };
    for layer in &sheet.layers {
        brush.clip = layer.clip.then_some(&clip);
        brush.layer(layer);
    }
    brush.pixmap.encode_png().map_err(|e| PngError::Encoding(e.to_string()))
}

fn clip(sheet: &Sheet, pixmap: &Pixmap, corner: Point2, scale: f64) -> Option<Mask> {
    let mut mask = Mask::new(pixmap.width(), pixmap.height())?;
    let p = sheet.panel;
    let [x, y, w, h] = [p.x - corner.x, p.y - corner.y, p.w, p.h].map(|v| (v * scale) as f32);
    let rect = tiny_skia::Rect::from_xywh(x, y, w, h)?;
    mask.fill_path(&PathBuilder::from_rect(rect), FillRule::Winding, true, Transform::identity());
    Some(mask)
}

fn colour(Rgb([r, g, b]): Rgb) -> Color {
    Color::from_rgba8(r, g, b, 255)
}

struct Brush<'a> {
    pixmap: Pixmap,
    /// Page position of the upper left corner.
    corner: Point2,
    /// Pixels a millimetre.
    scale: f64,
    /// Coordinates have Y up.
    flip: bool,
    clip: Option<&'a Mask>,
    fonts: &'a [Font; 2],
}

impl Brush<'_> {
    fn layer(&mut self, layer: &Layer) {
        self.flip = layer.frame == Frame::Working;
        for mark in &layer.marks {
            match mark {
                Mark::Path { outline, paint } => self.outline(outline, paint),
                Mark::Text(text) => self.text(text),
            }
        }
    }

    fn outline(&mut self, outline: &Outline, paint: &Paint) {
        if let Some(path) = self.path(outline) {
            self.fill(&path, paint.fill);
            self.stroke(&path, paint.stroke.as_ref());
        }
    }

    fn fill(&mut self, path: &Path, fill: Option<Rgb>) {
        let Some(fill) = fill else { return };
        let paint = solid(fill);
        self.pixmap.fill_path(path, &paint, FillRule::Winding, Transform::identity(), self.clip);
    }

    fn stroke(&mut self, path: &Path, stroke: Option<&Stroke>) {
        let Some(stroke) = stroke else { return };
        let px = |mm: f64| (mm * self.scale) as f32;
        let dash = stroke.dash.and_then(|[on, off]| StrokeDash::new(vec![px(on), px(off)], 0.0));
        let style = tiny_skia::Stroke {
            width: (stroke.width * self.scale).max(THINNEST_PX) as f32,
            line_cap: if dash.is_some() { LineCap::Butt } else { LineCap::Round },
            line_join: LineJoin::Round,
            dash,
            ..tiny_skia::Stroke::default()
        };
        let paint = solid(stroke.colour);
        self.pixmap.stroke_path(path, &paint, &style, Transform::identity(), self.clip);
    }

    fn path(&self, outline: &Outline) -> Option<Path> {
        let mut builder = PathBuilder::new();
        let mut pen = Point2::default();
        for op in &outline.ops {
            match *op {
                Op::Move(to) => {
                    let [x, y] = self.pixel(to);
                    builder.move_to(x, y);
                    pen = to;
                }
                Op::Line(to) => {
                    let [x, y] = self.pixel(to);
                    builder.line_to(x, y);
                    pen = to;
                }
                Op::Arc { centre, to, sweep_rad } => {
                    self.arc(&mut builder, pen, centre, to, sweep_rad);
                    pen = to;
                }
                Op::Close => builder.close(),
            }
        }
        builder.finish()
    }

    fn arc(
        &self,
        into: &mut PathBuilder,
        from: Point2,
        centre: Point2,
        to: Point2,
        sweep_rad: f64,
    ) {
        let mut start = from;
        for (end, sweep) in arc_pieces(from, centre, to, sweep_rad, PIECE_RAD) {
            // The cubic that touches the circle at both ends and in the middle.
            let handle = 4.0 / 3.0 * (0.25 * sweep).tan();
            let [ax, ay] = self.pixel(start + (start - centre).left() * handle);
            let [bx, by] = self.pixel(end + (end - centre).left() * -handle);
            let [x, y] = self.pixel(end);
            into.cubic_to(ax, ay, bx, by, x, y);
            start = end;
        }
    }

    fn pixel(&self, p: Point2) -> [f32; 2] {
        let y = if self.flip { -p.y } else { p.y };
        [((p.x - self.corner.x) * self.scale) as f32, ((y - self.corner.y) * self.scale) as f32]
    }

    fn text(&mut self, text: &Text) {
        let Some(path) = self.letters(text) else { return };
        if text.halo {
            let rim = Stroke { colour: PAPER, width: 0.3 * text.size, dash: None };
            self.stroke(&path, Some(&rim));
        }
        self.fill(&path, Some(text.colour));
    }

    fn letters(&self, text: &Text) -> Option<Path> {
        let font = &self.fonts[usize::from(text.bold)];
        let shift = match text.anchor {
            Anchor::Start => 0.0,
            Anchor::Middle => -0.5,
            Anchor::End => -1.0,
        };
        let mut pen = text.at + Vec2::new(shift * font.width(&text.text) * text.size, 0.0);
        let mut builder = PathBuilder::new();
        for c in text.text.chars() {
            let scale = (font.scale() * text.size * self.scale) as f32;
            font.outline(c, &mut Letter { into: &mut builder, at: self.pixel(pen), scale });
            pen += Vec2::new(font.advance(c) * text.size, 0.0);
        }
        builder.finish()
    }
}

fn solid(fill: Rgb) -> tiny_skia::Paint<'static> {
    let mut paint = tiny_skia::Paint::default();
    paint.set_color(colour(fill));
    paint
}

/// Puts a letter's outline, Y up in font units, where it belongs on the picture.
struct Letter<'a> {
    into: &'a mut PathBuilder,
    at: [f32; 2],
    scale: f32,
}

impl Letter<'_> {
    fn px(&self, x: f32, y: f32) -> [f32; 2] {
        [self.at[0] + x * self.scale, self.at[1] - y * self.scale]
    }
}

impl ttf_parser::OutlineBuilder for Letter<'_> {
    fn move_to(&mut self, x: f32, y: f32) {
        let [x, y] = self.px(x, y);
        self.into.move_to(x, y);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        let [x, y] = self.px(x, y);
        self.into.line_to(x, y);
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        let ([x1, y1], [x, y]) = (self.px(x1, y1), self.px(x, y));
        self.into.quad_to(x1, y1, x, y);
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        let ([x1, y1], [x2, y2], [x, y]) = (self.px(x1, y1), self.px(x2, y2), self.px(x, y));
        self.into.cubic_to(x1, y1, x2, y2, x, y);
    }

    fn close(&mut self) {
        self.into.close();
    }
}
