//! Composes the picture of a scene: what is where on the sheet, from board to legend.

mod columns;
mod depth;
mod extent;
mod facts;
mod legend;
pub mod numbers;
mod rulers;
mod signs;
mod steps;
mod tracks;
mod view;

pub use extent::reach;
pub use facts::{Row, story};
pub use tracks::{arc, place};

use crate::font::Font;
use crate::options::Options;
use crate::palette::{AIR, INK, JOG, PAPER, Rgb, SOFT};
use crate::scene::{Scene, TableView};
use crate::sheet::{Anchor, Frame, Layer, Mark, Paint, Rect, Sheet, Text};
use depth::{DepthScale, SHADES};
use extent::Extent;
use facts::{Drawn, Sample};
use kerf_geom::Point2;
use legend::Legend;
use tracks::{Detail, Tracks};
use view::View;

/// Share of the paper's colour in the band that shows the cutter's width.
const BAND: f64 = 0.66;
/// Widest and thinnest line of a cut, em.
const LINE_EM: [f64; 2] = [0.035, 0.16];
/// Reach of the rulers below the drawing, em.
const BELOW_EM: f64 = 3.6;
/// Margin of the page, em.
const MARGIN_EM: f64 = 2.0;
/// Room for heading and the name of the Y axis above the drawing, em.
const HEAD_EM: f64 = 5.4;

/// Draws the whole sheet.
pub fn compose(scene: &Scene, options: &Options) -> Sheet {
    let extent = Extent::of(scene);
    let cutter_mm = cutter(scene, options);
    let view = View::of(scene, &extent, cutter_mm);
    let scale = scale_of(scene, &extent);
    let tolerance_mm = (scene.segments.len() > options.detail_limit)
        .then(|| options.detail.max(1e-6) * view.panel.longer());
    let detail =
        Detail { point_mm: 1e-5 * view.panel.longer(), shade_mm: 0.3 * view.em, tolerance_mm };
    let tracks = Tracks::of(scene, &scale, &detail);
    let ink = Ink { em: view.em, line: line_width(&extent, &view), cutter_mm };
    let samples = samples(scene, &tracks, &ink);
    let depth = (!extent.cut.is_empty() && scene.colours.is_empty()).then_some(scale);
    let drawn = Drawn { depth, samples, left_out: extent.left_out, tolerance_mm };
    let legend = Legend::arrange(facts::blocks(scene, &view, &drawn), &view, BELOW_EM * view.em);
    let mut layers = rulers::board(&view, scene.unit);
    layers.extend(motion(scene, &view, &tracks, &ink));
    layers.push(rulers::rulers(&view, scene.unit));
    layers.push(legend.draw(&view, scene.unit));
    let page = page(&view, &legend, rulers::left_room(&view, scene.unit));
    layers.push(heading(scene, &view, &page));
    Sheet {
        title: scene.title.clone(),
        description: description(scene, &drawn, &view),
        page,
        panel: view.panel,
        origin: view.origin,
        decimals: view.decimals,
        layers,
    }
}

/// The depth scale of a scene.
pub fn depth_scale(scene: &Scene) -> DepthScale {
    scale_of(scene, &Extent::of(scene))
}

fn scale_of(scene: &Scene, extent: &Extent) -> DepthScale {
    DepthScale::new(scene.surface_z_mm, extent.cut.min[2], extent.cut.max[2])
}

/// The scene's table, if it is one that can be drawn.
pub fn drawable_table(scene: &Scene) -> Option<TableView> {
    scene.table.filter(view::drawable)
}

fn cutter(scene: &Scene, options: &Options) -> f64 {
    if options.show_cutter && !scene.colours.is_empty() {
        return scene.widest_mm().min(crate::FARTHEST_MM);
    }
    let known = scene.cutter_known && has_cutter(scene);
    if options.show_cutter && known { scene.cutter_mm.min(crate::FARTHEST_MM) } else { 0.0 }
}

fn has_cutter(scene: &Scene) -> bool {
    scene.cutter_mm.is_finite() && scene.cutter_mm > 0.0
}

/// Sizes of what the pen draws, mm.
struct Ink {
    em: f64,
    line: f64,
    cutter_mm: f64,
}

impl Ink {
    /// Returns `true` if the cutter is wider than the line that shows its middle.
    fn has_band(&self) -> bool {
        self.cutter_mm > 1.5 * self.line
    }

    fn plunge(&self) -> f64 {
        (1.6 * self.line).max(0.16 * self.em)
    }
}

/// Lines of a dense path are thin, so that paper shows between them.
fn line_width(extent: &Extent, view: &View) -> f64 {
    let [w, h, _] = extent.cut.size();
    let spacing = w * h / extent.cut_mm.max(1e-12);
    let [thin, thick] = LINE_EM;
    if spacing > 0.0 {
        (0.5 * spacing).clamp(thin * view.em, thick * view.em)
    } else {
        thick * view.em
    }
}

fn jog_paint(em: f64) -> Paint {
    Paint::dashed(JOG, 0.1 * em, [0.75 * em, 0.5 * em])
}

fn motion(scene: &Scene, view: &View, tracks: &Tracks, ink: &Ink) -> Vec<Layer> {
    let mut layers = Vec::new();
    if ink.has_band() {
        let mut bands = Layer::new("cutter", Frame::Working, true);
        for (shade, cut) in tracks.cuts.iter().enumerate() {
            let colour = shade_colour(scene, shade).mixed(PAPER, BAND);
            let width = band_width(scene, shade, ink);
            bands.path(cut.clone(), Paint::line(colour, width));
            bands.path(signs::bores(tracks, shade, width), Paint::fill(colour));
        }
        layers.push(bands);
    }
    let mut jogs = Layer::new("jogs", Frame::Working, true);
    jogs.path(tracks.jogs.clone(), jog_paint(ink.em));
    let mut cuts = Layer::new("cuts", Frame::Working, true);
    cuts.path(tracks.air.clone(), Paint::line(AIR, 0.7 * ink.line));
    for (shade, cut) in tracks.cuts.iter().enumerate() {
        cuts.path(cut.clone(), Paint::line(shade_colour(scene, shade), ink.line));
    }
    layers.extend([cuts, jogs]);
    layers.push(rulers::zero(view));
    let colour = |shade| shade_colour(scene, shade);
    layers.push(signs::plunges(tracks, ink.plunge(), ink.em, colour));
    if !scene.colours.is_empty() {
        layers.push(signs::bounds(scene, ink.em));
        layers.push(signs::starts(scene, ink.em));
    }
    layers.push(signs::arrows(scene, view));
    layers.push(signs::ends(tracks, view));
    layers
}

/// The colour of a depth, or one that the scene gives.
fn shade_colour(scene: &Scene, shade: usize) -> Rgb {
    let given = scene.colours.get(shade).map(|colour| Rgb(colour.colour));
    given.unwrap_or_else(|| DepthScale::colour(shade.min(SHADES - 1)))
}

/// Returns the width of the cutter of the cuts of a shade, mm.
fn band_width(scene: &Scene, shade: usize, ink: &Ink) -> f64 {
    scene.colours.get(shade).map_or(ink.cutter_mm, |colour| colour.width_mm.min(ink.cutter_mm))
}

/// The colours that a scene gives, with the width of the cutter where it is known.
fn colour_samples(scene: &Scene, tracks: &Tracks) -> Vec<(Sample, String)> {
    let cut = |n: usize| tracks.cuts.get(n).is_some_and(|cut| !cut.ops.is_empty());
    let drilled = |n: usize| tracks.plunges.iter().any(|(_, shade)| *shade == Some(n));
    let sample = |n: usize| {
        let colour = &scene.colours[n];
        let wide = colour.width_mm > 0.0;
        let width = numbers::short(colour.width_mm, scene.unit, 3);
        let told = format!("{}, {width} {} wide", colour.name, scene.unit.symbol);
        let text = if wide { told } else { colour.name.clone() };
        let rgb = Rgb(colour.colour);
        (if cut(n) { Sample::Coloured(rgb, wide) } else { Sample::Drilled(rgb) }, text)
    };
    (0..scene.colours.len()).filter(|n| cut(*n) || drilled(*n)).map(sample).collect()
}

/// The signs that occur, so that the legend explains no others.
fn samples(scene: &Scene, tracks: &Tracks, ink: &Ink) -> Vec<(Sample, String)> {
    let cuts = tracks.cuts.iter().any(|c| !c.ops.is_empty());
    let jogs = !tracks.jogs.ops.is_empty();
    let air = !tracks.air.ops.is_empty();
    let width = numbers::short(ink.cutter_mm, scene.unit, 3);
    let depths = scene.colours.is_empty();
    let all = [
        (cuts && depths && !ink.has_band(), Sample::Cut, cut_words(scene)),
        (
            cuts && depths && ink.has_band(),
            Sample::Cutter,
            format!("cut, cutter {width} {} wide", scene.unit.symbol),
        ),
        (air, Sample::Air, "cut above the surface".into()),
        (jogs, Sample::Jog, "jog".into()),
        (depths && !tracks.plunges.is_empty(), Sample::Plunge, "straight plunge".into()),
        (cuts && !depths, Sample::Begin, "a cut begins".into()),
        (!scene.bounds.is_empty() && !depths, Sample::Bounds, "bounds of the cuts".into()),
        (cuts || jogs || air, Sample::Arrow, "direction".into()),
        (tracks.ends.is_some(), Sample::Start, "start".into()),
        (tracks.ends.is_some(), Sample::End, "end".into()),
    ];
    let signs = all.into_iter().filter(|s| s.0).map(|(_, sample, text)| (sample, text));
    colour_samples(scene, tracks).into_iter().chain(signs).collect()
}

/// A cut drawn as a line; the width of a cutter that nobody chose is told.
fn cut_words(scene: &Scene) -> String {
    if scene.cutter_known || !has_cutter(scene) {
        return "cut".into();
    }
    let width = numbers::short(scene.cutter_mm, scene.unit, 3);
    format!("cut, cutter {width} {} (default)", scene.unit.symbol)
}

fn page(view: &View, legend: &Legend, left_mm: f64) -> Rect {
    let em = view.em;
    let p = view.panel;
    let drawing = Rect {
        x: p.x - left_mm,
        y: p.y - HEAD_EM * em,
        w: p.w + left_mm,
        h: p.h + (HEAD_EM + BELOW_EM) * em,
    };
    drawing.around(&legend.area).grown(MARGIN_EM * em)
}

fn heading(scene: &Scene, view: &View, page: &Rect) -> Layer {
    let em = view.em;
    let mut layer = Layer::new("heading", Frame::Page, false);
    let x = page.x + MARGIN_EM * em;
    let room = (page.w / em - 2.0 * MARGIN_EM) / 1.08;
    let mut put = |y: f64, size: f64, bold: bool, colour, text: &str| {
        let text = Font::new(bold).fitted(text, room / size);
        let at = Point2::new(x, page.y + y * em);
        layer.marks.push(Mark::Text(Text {
            at,
            size: size * em,
            anchor: Anchor::Start,
            bold,
            colour,
            halo: false,
            text,
        }));
    };
    let title = if scene.title.trim().is_empty() { "Tool path" } else { scene.title.trim() };
    put(MARGIN_EM + 1.6, 1.9, true, INK, title);
    put(MARGIN_EM + 3.3, 1.0, false, SOFT, &summary(scene));
    layer
}

/// `120.00 × 80.00 mm, down to −6.00 mm · 0:04:12`.
pub fn summary(scene: &Scene) -> String {
    let (size, unit) = (scene.bounds.size(), scene.unit);
    let decimals = numbers::coordinate_decimals(size[0].max(size[1]) / unit.mm, unit);
    let number = |mm: f64| numbers::decimal(mm, unit, decimals);
    let what = if scene.bounds.is_empty() {
        "nothing is cut".into()
    } else {
        let [x, y] = [size[0], size[1]].map(number);
        let bottom = number(scene.bounds.min[2]);
        format!("{x} × {y} {symbol}, down to {bottom} {symbol}", symbol = unit.symbol)
    };
    format!("{what} · {}", numbers::duration(scene.duration_s))
}

fn description(scene: &Scene, drawn: &Drawn, view: &View) -> String {
    let mut text = format!(
        "Tool path seen from above, {}. One unit is a millimetre; numbers in the paths are working coordinates",
        summary(scene)
    );
    if view.origin != Point2::default() {
        text += &format!(" less {}, {}", view.origin.x, view.origin.y);
    }
    text += &format!(". Findings: {}.", facts::finding_counts(&scene.findings));
    if let Some(tolerance) = drawn.tolerance_mm {
        text += &format!(
            " Simplified: lines are within {tolerance:.4} mm, depths within one of {SHADES} shades."
        );
    }
    text
}
