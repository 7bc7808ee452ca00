//! The page: heading and key, and three charts over time beside three along the path.

use super::chart::{Chart, EM, words};
use super::record::{CurvesOverAbscissa, Doing, Plot};
use super::strip::{axis_colour, colour, path_colour, strip, toolpaths};
use super::{Sides, curve::Curve};
use crate::font::Font;
use crate::palette::{BOARD, EDGE, INK, JOG, PAPER, SOFT};
use crate::picture::numbers::{duration, path_length};
use crate::scene::Unit;
use crate::sheet::{Anchor, Frame, Layer, Mark, Outline, Paint, Rect, Sheet, Text};
use kerf_geom::Point2;

/// The page, an A4 sheet on its side, mm.
const PAGE: Rect = Rect { x: 0.0, y: 0.0, w: 297.0, h: 210.0 };
const MARGIN: f64 = 10.0;
/// Beginning and end of the charts' block.
const TOP: f64 = 39.0;
const BOTTOM: f64 = 192.0;
/// Room for the numbers left of a chart, and between charts.
const LEFT: f64 = 15.0;
const GAP: f64 = 9.0;
/// Height of the strip that tells cut, jog and stand.
const STRIP: f64 = 2.2;
/// Name of each of the three charts, the power of the second in its unit, and its share of the height.
const CHARTS: [(&str, &str, f64); 3] =
    [("Speed", "s", 0.44), ("Acceleration", "s²", 0.28), ("Jerk, over 1 ms", "s³", 0.28)];

/// Line widths, mm.
const STRONG: f64 = 0.35;
const FAINT: f64 = 0.2;

/// Draws the whole sheet.
pub fn compose(plot: &Plot, sides: Sides) -> Sheet {
    let mut ground = Layer::new("ground", Frame::Page, false);
    ground.path(Outline::of_rect(PAGE), Paint::fill(BOARD));
    let mut layers = vec![ground];
    for (over, column) in columns(sides) {
        layers.extend(draw_column(plot, over, column));
    }
    layers.push(heading(plot));
    Sheet {
        title: plot.title.clone(),
        description: format!("Speed, acceleration and jerk of a run: {}.", summary(plot)),
        page: PAGE,
        panel: PAGE,
        origin: Point2::default(),
        decimals: 2,
        layers,
    }
}

/// The columns: 0 over time, 1 along the path, each with its left and right edge.
fn columns(sides: Sides) -> Vec<(usize, [f64; 2])> {
    let (left, right) = (MARGIN + LEFT, PAGE.right() - MARGIN);
    match sides {
        Sides::Time => vec![(0, [left, right])],
        Sides::Path => vec![(1, [left, right])],
        Sides::Both => {
            let middle = 0.5 * (MARGIN + right);
            vec![(0, [left, middle - 2.0]), (1, [middle + LEFT, right])]
        }
    }
}

fn draw_column(plot: &Plot, over: usize, [left, right]: [f64; 2]) -> [Layer; 3] {
    let ids =
        [["grid-time", "curves-time", "frame-time"], ["grid-path", "curves-path", "frame-path"]];
    let mut layers = ids[over].map(|id| Layer::new(id, Frame::Page, false));
    let [grid, curves, frame] = &mut layers;
    let data = &plot.over[over];
    if plot.stretches.is_empty() {
        let at = Point2::new(0.5 * (left + right), TOP + 40.0);
        let none = words(at, Anchor::Middle, INK, "nothing moves".into());
        frame.marks.push(Mark::Text(Text { size: 4.0, ..none }));
        return layers;
    }
    let x_unit = if over == 0 { 1.0 } else { plot.unit.mm };
    let mut y = TOP + STRIP + GAP;
    let room = BOTTOM - y - 2.0 * GAP;
    let mut last = None;
    for (k, (name, per, share)) in CHARTS.into_iter().enumerate() {
        let area = Rect { x: left, y, w: right - left, h: share * room };
        let span = [plot.start[over], plot.end[over]];
        let chart = Chart::new(area, span, range(data, k), [x_unit, plot.unit.mm]);
        chart.ground(grid);
        draw_curves(curves, &chart, data, k);
        let below = (k == 2).then(|| abscissa(over, plot.unit));
        chart.frame(frame, &format!("{name}, {}/{per}", plot.unit.symbol), below.as_deref());
        y += area.h + GAP;
        last = Some(chart.x);
    }
    if let Some(x) = last {
        let area = Rect { x: left, y: TOP + 2.0, w: right - left, h: STRIP };
        strip(frame, plot, over, &x, area);
        toolpaths(frame, plot, over, &x, [TOP - 2.6, BOTTOM]);
    }
    layers
}

fn abscissa(over: usize, unit: Unit) -> String {
    if over == 0 { "time, s".into() } else { format!("way along the path, {}", unit.symbol) }
}

/// Lowest and highest value of a chart, 0 among them.
fn range(data: &CurvesOverAbscissa, chart: usize) -> [f64; 2] {
    let per_axis = data.axes.iter().map(|(_, curves)| &curves[chart]);
    let own: &[&Curve] = match (chart, data.axes.is_empty()) {
        (0, _) => &[&data.path[0], &data.programmed],
        (1, true) => &[&data.path[1], &data.total_accel],
        (_, true) => &[&data.path[chart]],
        (_, false) => &[],
    };
    let all = own.iter().copied().chain(per_axis);
    all.filter_map(Curve::range).fold([0.0, 0.0], |[low, high], [a, b]| [low.min(a), high.max(b)])
}

fn draw_curves(layer: &mut Layer, chart: &Chart, data: &CurvesOverAbscissa, k: usize) {
    let ink = path_colour();
    if k == 0 {
        chart.area(layer, &data.path[0], ink.mixed(PAPER, 0.88));
        chart.curve(layer, &data.programmed, programmed());
    }
    if k == 1 && data.axes.is_empty() {
        chart.curve(layer, &data.total_accel, total());
    }
    let faint = !data.axes.is_empty();
    if k == 0 || !faint {
        let width = if faint { FAINT } else { STRONG };
        chart.curve(layer, &data.path[k], Paint::line(ink, width));
    }
    for (axis, curves) in &data.axes {
        chart.curve(layer, &curves[k], Paint::line(axis_colour(axis.index()), STRONG));
    }
}

fn programmed() -> Paint {
    Paint::dashed(JOG.mixed(INK, 0.25), FAINT, [1.4, 0.9])
}

fn total() -> Paint {
    Paint::line(EDGE, FAINT)
}

fn heading(plot: &Plot) -> Layer {
    let mut layer = Layer::new("heading", Frame::Page, false);
    let room = PAGE.w - 2.0 * MARGIN;
    let mut put = |y: f64, size: f64, bold, colour, text: &str| {
        let text = Font::new(bold).fitted(text, room / size);
        let at = Point2::new(MARGIN, y);
        layer.marks.push(Mark::Text(Text { size, bold, ..words(at, Anchor::Start, colour, text) }));
    };
    put(16.0, 6.0, true, INK, if plot.title.is_empty() { "Motion" } else { &plot.title });
    put(22.0, 3.2, false, SOFT, &summary(plot));
    key(&mut layer, plot);
    layer
}

/// `0:01:24 · 1 234.0 mm · at most 98 mm/s, 100 programmed · ramps shopbot`.
fn summary(plot: &Plot) -> String {
    let [time, way] = [plot.end[0] - plot.start[0], plot.end[1] - plot.start[1]];
    let top = |curve: &Curve| curve.range().map_or(0.0, |r| r[1]) / plot.unit.mm;
    let data = &plot.over[0];
    let decimals = if plot.unit.mm > 2.0 { 2 } else { 1 };
    let mut text = format!(
        "{} · {} · at most {:.decimals$} {symbol}/s, {:.decimals$} programmed",
        duration(time),
        path_length(way, plot.unit),
        top(&data.path[0]),
        top(&data.programmed),
        symbol = plot.unit.symbol,
    );
    if !plot.note.is_empty() {
        text += &format!(" · {}", plot.note);
    }
    text
}

/// Samples of the lines and their meaning, in one row.
fn key(layer: &mut Layer, plot: &Plot) {
    let axes = &plot.over[0].axes;
    let mut entries = vec![
        (programmed(), "programmed speed".to_owned()),
        (Paint::line(path_colour(), STRONG), "along the path".into()),
    ];
    if axes.is_empty() {
        entries.push((total(), "in all directions".into()));
    }
    for (axis, _) in axes {
        let paint = Paint::line(axis_colour(axis.index()), STRONG);
        entries.push((paint, axis.letter().to_string()));
    }
    for (doing, name) in [(Doing::Cut, "cut"), (Doing::Jog, "jog"), (Doing::Stand, "stands")] {
        if plot.stretches.iter().any(|s| s.doing == doing) {
            entries.push((Paint::fill(colour(doing)), name.into()));
        }
    }
    if !plot.lines.is_empty() {
        entries.push((Paint::default(), "small numbers: lines of the program".into()));
    }
    let mut x = MARGIN;
    for (paint, name) in entries {
        x = entry(layer, x, paint, name);
    }
}

fn entry(layer: &mut Layer, x: f64, paint: Paint, name: String) -> f64 {
    const Y: f64 = 29.0;
    let mut from = x;
    if paint != Paint::default() {
        let mut sample = Outline::default();
        sample.segment(Point2::new(x, Y - 0.8), Point2::new(x + 7.0, Y - 0.8));
        if paint.fill.is_some() {
            sample = Outline::of_rect(Rect { x, y: Y - 1.9, w: 7.0, h: STRIP });
        }
        layer.path(sample, paint);
        from += 8.8;
    }
    let width = 1.05 * Font::new(false).width(&name) * EM;
    layer.marks.push(Mark::Text(words(Point2::new(from, Y), Anchor::Start, INK, name)));
    from + width + 5.0
}
