//! The board under the drawing: fine grid, table with its own grid, rulers and the zero mark.

use super::numbers;
use super::steps::{Step, multiples, round_step};
use super::view::{View, table_rect};
use crate::font::Font;
use crate::palette::{AXIS_X, AXIS_Y, BOARD, EDGE, FINE, GRID, INK, PAPER, Rgb, SOFT};
use crate::scene::{TableView, Unit};
use crate::sheet::{Anchor, Frame, Layer, Mark, Outline, Paint, Rect, Text};
use kerf_geom::{Point2, Vec2};

/// Distance of ruler numbers, em.
const NUMBER_EM: f64 = 7.0;
/// The table's grid is thinned above so many lines, which is where it turns into a grey area.
const MOST_LINES: f64 = 120.0;

/// With fewer lines of the table's grid in sight the rulers' own grid helps to read places.
const FEW_LINES: f64 = 4.0;

/// The step of the rulers.
pub fn ruler_step(view: &View, unit: Unit) -> Step {
    round_step(NUMBER_EM * view.em, unit)
}

/// The spacing at which the table's grid is drawn: VP's, or a multiple of it where that would be
/// too dense; nothing without a grid.
pub fn grid_spacing(view: &View) -> Option<f64> {
    let table = view.table.filter(|t| t.grid_mm.is_finite() && t.grid_mm > 0.0)?;
    let seen = shown_table(view, &table)?;
    let lines = seen.longer() / table.grid_mm;
    Some(table.grid_mm * (lines / MOST_LINES).ceil().max(1.0))
}

fn shown_table(view: &View, table: &TableView) -> Option<Rect> {
    let (table, panel) = (table_rect(table), view.panel);
    let (x, y) = (table.x.max(panel.x), table.y.max(panel.y));
    let (right, bottom) = (table.right().min(panel.right()), table.bottom().min(panel.bottom()));
    (right > x && bottom > y).then_some(Rect { x, y, w: right - x, h: bottom - y })
}

/// Board, fine grid and table.
pub fn board(view: &View, unit: Unit) -> Vec<Layer> {
    let mut board = Layer::new("board", Frame::Page, true);
    let colour = if view.table.is_some() { BOARD } else { PAPER };
    board.path(Outline::of_rect(view.panel), Paint::fill(colour));
    let mut table = Layer::new("table", Frame::Page, true);
    if let Some(t) = &view.table {
        table.path(Outline::of_rect(table_rect(t)), Paint::fill(PAPER));
    }
    let mut grid = Layer::new("grid", Frame::Page, true);
    let spacing = grid_spacing(view);
    if spacing.is_none_or(|mm| view.panel.longer() < FEW_LINES * mm) {
        let fine = fine_grid(view, ruler_step(view, unit).mm);
        grid.path(fine, Paint::line(FINE, 0.05 * view.em));
    }
    if let (Some(t), Some(spacing)) = (&view.table, spacing) {
        grid.path(table_grid(view, t, spacing), Paint::line(GRID, 0.06 * view.em));
    }
    let mut edge = Layer::new("table-edge", Frame::Page, true);
    if let Some(t) = &view.table {
        edge.path(Outline::of_rect(table_rect(t)), Paint::line(EDGE, 0.14 * view.em));
    }
    vec![board, table, grid, edge]
}

fn fine_grid(view: &View, step: f64) -> Outline {
    let p = view.panel;
    let mut lines = Outline::default();
    for k in multiples(p.x, p.right(), step, 1000) {
        vertical(&mut lines, k as f64 * step, p);
    }
    for k in multiples(p.y, p.bottom(), step, 1000) {
        horizontal(&mut lines, k as f64 * step, p);
    }
    lines
}

fn table_grid(view: &View, table: &TableView, spacing: f64) -> Outline {
    let mut lines = Outline::default();
    let Some(seen) = shown_table(view, table) else { return lines };
    let corner = Point2::new(table.origin[0], -table.origin[1]);
    for k in multiples(seen.x - corner.x, seen.right() - corner.x, spacing, 1000) {
        vertical(&mut lines, corner.x + k as f64 * spacing, seen);
    }
    for k in multiples(seen.y - corner.y, seen.bottom() - corner.y, spacing, 1000) {
        horizontal(&mut lines, corner.y + k as f64 * spacing, seen);
    }
    lines
}

fn vertical(lines: &mut Outline, x: f64, within: Rect) {
    lines.segment(Point2::new(x, within.y), Point2::new(x, within.bottom()));
}

fn horizontal(lines: &mut Outline, y: f64, within: Rect) {
    lines.segment(Point2::new(within.x, y), Point2::new(within.right(), y));
}

/// Room that the numbers of the Y ruler need left of the drawing, mm.
pub fn left_room(view: &View, unit: Unit) -> f64 {
    let step = ruler_step(view, unit);
    let font = Font::new(false);
    let numbers = multiples(-view.panel.bottom(), -view.panel.y, step.mm, 1000);
    let widest = numbers.map(|k| font.width(&number(k, step, unit))).fold(0.0, f64::max);
    (1.1 * widest + 1.6) * view.em
}

fn number(k: i64, step: Step, unit: Unit) -> String {
    numbers::decimal(k as f64 * step.mm, unit, step.decimals)
}

/// Ticks with numbers along the lower and the left edge, and the frame.
pub fn rulers(view: &View, unit: Unit) -> Layer {
    let (p, em) = (view.panel, view.em);
    let step = ruler_step(view, unit);
    let minor = step.mm / f64::from(step.minor);
    let mut layer = Layer::new("rulers", Frame::Page, false);
    let mut ticks = Outline::default();
    for k in multiples(p.x, p.right(), minor, 2000) {
        let x = k as f64 * minor;
        ticks.segment(Point2::new(x, p.bottom()), Point2::new(x, p.bottom() + tick(k, step) * em));
    }
    for k in multiples(-p.bottom(), -p.y, minor, 2000) {
        let y = -(k as f64) * minor;
        ticks.segment(Point2::new(p.x, y), Point2::new(p.x - tick(k, step) * em, y));
    }
    layer.path(ticks, Paint::line(SOFT, 0.06 * em));
    layer.path(Outline::of_rect(p), Paint::line(EDGE, 0.08 * em));
    for k in multiples(p.x, p.right(), step.mm, 1000) {
        let at = Point2::new(k as f64 * step.mm, p.bottom() + 1.9 * em);
        layer.marks.push(label(at, em, Anchor::Middle, number(k, step, unit)));
    }
    for k in multiples(-p.bottom(), -p.y, step.mm, 1000) {
        let at = Point2::new(p.x - 0.9 * em, -(k as f64) * step.mm + 0.35 * em);
        layer.marks.push(label(at, em, Anchor::End, number(k, step, unit)));
    }
    let x_name = Point2::new(p.right(), p.bottom() + 3.3 * em);
    layer.marks.push(label(x_name, em, Anchor::End, format!("X, {}", unit.symbol)));
    let y_name = Point2::new(p.x, p.y - 0.8 * em);
    layer.marks.push(label(y_name, em, Anchor::Start, format!("Y, {}", unit.symbol)));
    layer
}

fn tick(k: i64, step: Step) -> f64 {
    if k.rem_euclid(i64::from(step.minor)) == 0 { 0.7 } else { 0.35 }
}

fn label(at: Point2, em: f64, anchor: Anchor, text: String) -> Mark {
    Mark::Text(Text { at, size: em, anchor, bold: false, colour: SOFT, halo: false, text })
}

/// The working zero with its axes, when it is inside the drawing.
pub fn zero(view: &View) -> Layer {
    let (p, em) = (view.panel, view.em);
    let mut layer = Layer::new("zero", Frame::Page, true);
    let inside = p.x <= 0.0 && p.right() >= 0.0 && p.y <= 0.0 && p.bottom() >= 0.0;
    if inside {
        axis(&mut layer, Vec2::new(1.0, 0.0), AXIS_X, em);
        axis(&mut layer, Vec2::new(0.0, -1.0), AXIS_Y, em);
        let mut ring = Outline::default();
        ring.circle(Point2::default(), 0.45 * em);
        layer.path(ring, Paint::edged(PAPER, INK, 0.12 * em));
    }
    layer
}

fn axis(layer: &mut Layer, along: Vec2, colour: Rgb, em: f64) {
    let tip = Point2::default() + along * (4.2 * em);
    let neck = tip - Point2::default() - along * (1.1 * em);
    let side = along.left() * (0.38 * em);
    let mut shaft = Outline::default();
    shaft.segment(Point2::default(), Point2::default() + neck);
    layer.path(shaft, Paint::line(colour, 0.16 * em));
    let mut head = Outline::default();
    let base = Point2::default() + neck;
    head.polygon(&[tip, base + side, base + -side]);
    layer.path(head, Paint::fill(colour));
}
