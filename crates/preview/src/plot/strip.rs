//! The marks of stretches of the motion: cut, jog or stand as a strip of colour, lines of the program as
//! ticks on it, tool paths as lines through all charts.

use super::chart::{EM, words};
use super::record::{Doing, Plot};
use super::scale::Scale;
use crate::font::Font;
use crate::palette::{EDGE, GRID, INK, JOG, PAPER, Rgb, SOFT, depth_colour};
use crate::sheet::{Anchor, Layer, Mark, Outline, Paint, Rect, Text};
use kerf_geom::Point2;

/// Narrower stretches are not drawn by themselves, mm.
const NARROWEST_MM: f64 = 0.08;
/// Ticks of lines nearer to each other than this would be a grey area, mm.
const TICKS_MM: f64 = 0.6;

/// Colour of what the machine does.
pub fn colour(doing: Doing) -> Rgb {
    match doing {
        Doing::Cut => INK.mixed(PAPER, 0.35),
        Doing::Jog => JOG.mixed(PAPER, 0.35),
        Doing::Stand => GRID,
    }
}

/// The strip over one abscissa (0 time, 1 path), in an area.
pub fn strip(layer: &mut Layer, plot: &Plot, over: usize, scale: &Scale, area: Rect) {
    let within = |x: f64| scale.at(x).clamp(area.x, area.right());
    let mut reached = area.x;
    for stretch in &plot.stretches {
        let (from, to) = (within(stretch.from[over]).max(reached), within(stretch.to[over]));
        if to - from < NARROWEST_MM {
            continue;
        }
        let rect = Rect { x: from, w: to - from, ..area };
        layer.path(Outline::of_rect(rect), Paint::fill(colour(stretch.doing)));
        reached = to;
    }
    layer.path(Outline::of_rect(area), Paint::line(EDGE, 0.15));
    lines(layer, plot, over, scale, area);
}

/// Numbers of source lines above the strip, where there is room for them.
fn lines(layer: &mut Layer, plot: &Plot, over: usize, scale: &Scale, area: Rect) {
    let font = Font::new(false);
    let (mut ticks, mut ticked, mut free) = (Outline::default(), f64::NEG_INFINITY, area.x);
    let crowded = plot.lines.len() as f64 * TICKS_MM > area.w;
    for (place, line) in &plot.lines {
        let x = scale.at(place[over]);
        if !(area.x - 1e-6..=area.right() + 1e-6).contains(&x) {
            continue;
        }
        if !crowded && x - ticked >= TICKS_MM {
            ticks.segment(Point2::new(x, area.y), Point2::new(x, area.bottom()));
            ticked = x;
        }
        let text = line.to_string();
        let width = font.width(&text) * SMALL;
        if x >= free - 1e-3 && x + width <= area.right() {
            let mut mark = words(Point2::new(x, area.y - 0.8), Anchor::Start, SOFT, text);
            mark.size = SMALL;
            layer.marks.push(Mark::Text(mark));
            free = x + width + 1.2;
        }
    }
    layer.path(ticks, Paint::line(PAPER, 0.2));
}

/// Size of line numbers, mm.
const SMALL: f64 = 0.75 * EM;

/// Lines where tool paths begin, through the charts, with their names above them.
pub fn toolpaths(
    layer: &mut Layer,
    plot: &Plot,
    over: usize,
    scale: &Scale,
    [top, bottom]: [f64; 2],
) {
    let font = Font::new(true);
    let mut free = scale.start;
    for (k, (place, name)) in plot.toolpaths.iter().enumerate() {
        let x = scale.at(place[over]);
        if x > scale.end {
            continue;
        }
        let x = x.max(scale.start);
        let next =
            plot.toolpaths.get(k + 1).map_or(scale.end, |(p, _)| scale.at(p[over]).min(scale.end));
        if x > scale.start + 1.0 {
            let mut line = Outline::default();
            line.segment(Point2::new(x, top), Point2::new(x, bottom));
            layer.path(line, Paint::dashed(SOFT, 0.2, [1.2, 0.8]));
        }
        let room = next - x - 1.5;
        if x >= free - 1e-3 && room > 3.0 * EM {
            let text = font.fitted(name, room / EM);
            let mark =
                Text { bold: true, ..words(Point2::new(x + 0.6, top), Anchor::Start, INK, text) };
            layer.marks.push(Mark::Text(mark));
            free = next;
        }
    }
}

/// Colour of an axis' curves.
pub fn axis_colour(index: usize) -> Rgb {
    use crate::palette::{AXIS_X, AXIS_Y};
    match index {
        0 => AXIS_X,
        1 => AXIS_Y,
        2 => Rgb([0x1f, 0x5f, 0xa8]),
        3 => Rgb([0xc7, 0x7a, 0x12]),
        4 => Rgb([0x7a, 0x3f, 0xa0]),
        _ => Rgb([0x12, 0x85, 0x8c]),
    }
}

/// Colour of the path's own curves.
pub fn path_colour() -> Rgb {
    depth_colour(0.9)
}
