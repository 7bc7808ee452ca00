//! The page that turns in 3D: one file, no network.
//!
//! Facts go in as JSON, motion as base64 of packed numbers, the viewer as plain scripts of our own.
//! A content security policy in the page forbids it to fetch anything.

mod motion;
mod roll;

use crate::options::Options;
use crate::palette::{self, Rgb};
use crate::picture::{self, numbers};
use crate::scene::Scene;
use crate::svg::escape;
use motion::{Motion, base64};
use serde::Serialize;

const PAGE: &str = include_str!("../../assets/viewer/page.html");
const STYLE: &str = include_str!("../../assets/viewer/style.css");
/// In the order in which they build on each other.
const SCRIPTS: [&str; 9] = [
    include_str!("../../assets/viewer/motion.js"),
    include_str!("../../assets/viewer/camera.js"),
    include_str!("../../assets/viewer/overlay.js"),
    include_str!("../../assets/viewer/gl.js"),
    include_str!("../../assets/viewer/canvas.js"),
    include_str!("../../assets/viewer/pick.js"),
    include_str!("../../assets/viewer/viewer.js"),
    include_str!("../../assets/viewer/hands.js"),
    include_str!("../../assets/viewer/panel.js"),
];
/// Colours of the depth scale given to the page.
const STOPS: u32 = 16;

/// Facts of the page besides the motion.
#[derive(Serialize)]
struct Facts<'a> {
    title: &'a str,
    unit: &'static str,
    unit_mm: f64,
    decimals: usize,
    pieces: usize,
    times: bool,
    middle: [f64; 3],
    low: [f64; 3],
    high: [f64; 3],
    depth: [f64; 2],
    surface: f64,
    cutter: f64,
    show_jogs: bool,
    simulate: bool,
    draw_tool: bool,
    /// Lowest and highest place of the motion on a cylinder, when it can be drawn there.
    rolled: Option<[[f64; 3]; 2]>,
    /// Height of the cylinder's axis.
    axis: Option<f64>,
    table: Option<Table>,
    light: Vec<String>,
    dark: Vec<String>,
    toolpaths: Vec<ToolPath<'a>>,
}

#[derive(Serialize)]
struct Table {
    origin: [f64; 2],
    size: [f64; 2],
    grid: f64,
}

#[derive(Serialize)]
struct ToolPath<'a> {
    name: &'a str,
    tool: &'a str,
    time: String,
    piece: u32,
}

/// Writes the page.
pub fn write(scene: &Scene, options: &Options) -> String {
    let motion = Motion::of(scene, options.chord_mm);
    // Numbers that are not finite cannot be in here: the scene's are checked one by one.
    let facts = serde_json::to_string(&facts(scene, &motion)).unwrap_or_else(|_| "{}".into());
    let title = if scene.title.trim().is_empty() { "Tool path" } else { scene.title.trim() };
    let parts = [
        ("title", escape(title)),
        ("summary", escape(&picture::summary(scene))),
        ("style", STYLE.to_owned()),
        ("legend", legend(scene)),
        // Nothing in the JSON may end the script element.
        ("facts", facts.replace('<', "\\u003c")),
        ("motion", base64(&motion.bytes())),
        ("script", SCRIPTS.concat()),
    ];
    fill(PAGE, &parts)
}

/// Puts the parts where the page names them; text inside the parts is left alone.
fn fill(page: &str, parts: &[(&str, String)]) -> String {
    let room: usize = parts.iter().map(|p| p.1.len()).sum();
    let mut out = String::with_capacity(page.len() + room);
    let mut rest = page;
    while let Some((before, after)) = rest.split_once("{{") {
        let Some((name, behind)) = after.split_once("}}") else { break };
        out.push_str(before);
        out.extend(parts.iter().filter(|p| p.0 == name).map(|p| p.1.as_str()));
        rest = behind;
    }
    out.push_str(rest);
    out
}

fn facts<'a>(scene: &'a Scene, motion: &Motion) -> Facts<'a> {
    let finite = |v: f64| if v.is_finite() { v } else { 0.0 };
    let bounds = motion.bounds;
    let scale = picture::depth_scale(scene);
    let size = bounds.size();
    let (low, high) =
        if bounds.is_empty() { ([0.0; 3], [0.0; 3]) } else { (bounds.min, bounds.max) };
    Facts {
        title: &scene.title,
        unit: scene.unit.symbol,
        unit_mm: scene.unit.mm,
        decimals: numbers::coordinate_decimals(size[0].max(size[1]) / scene.unit.mm, scene.unit),
        pieces: motion.len(),
        times: motion.has_times(),
        middle: motion.middle,
        low,
        high,
        depth: [scale.top, scale.bottom],
        surface: finite(scene.surface_z_mm),
        cutter: finite(scene.cutter_mm).max(0.0),
        show_jogs: scene.show_jogs,
        simulate: scene.simulate,
        draw_tool: scene.draw_tool,
        rolled: motion.rolled_box(),
        axis: motion.axis_z(),
        table: table(scene),
        light: ramp(palette::depth_colour),
        dark: ramp(palette::depth_colour_on_dark),
        toolpaths: toolpaths(scene, motion),
    }
}

fn table(scene: &Scene) -> Option<Table> {
    let table = picture::drawable_table(scene)?;
    let grid = if table.grid_mm.is_finite() { table.grid_mm.max(0.0) } else { 0.0 };
    Some(Table { origin: table.origin, size: [table.size_mm[0], table.size_mm[1]], grid })
}

fn ramp(colour: impl Fn(f64) -> Rgb) -> Vec<String> {
    (0..STOPS).map(|i| colour(f64::from(i) / f64::from(STOPS - 1)).hex()).collect()
}

fn toolpaths<'a>(scene: &'a Scene, motion: &Motion) -> Vec<ToolPath<'a>> {
    let piece =
        |segment: usize| motion.first_piece.get(segment).copied().unwrap_or(motion.len() as u32);
    scene
        .toolpaths
        .iter()
        .map(|t| ToolPath {
            name: &t.name,
            tool: &t.tool,
            time: numbers::duration(t.seconds),
            piece: piece(t.first_segment),
        })
        .collect()
}

/// The legend's rows as HTML; the viewer adds depth scale and tool paths.
fn legend(scene: &Scene) -> String {
    picture::story(scene).iter().map(|block| html_block(block)).collect()
}

fn html_block(block: &[picture::Row]) -> String {
    use picture::Row;
    let mut out = String::from("<section>");
    for row in block {
        out += &match row {
            Row::Head(text) => format!("<h2>{}</h2>", escape(text)),
            Row::Pair(name, value) => {
                format!(
                    "<p class=\"pair\"><span>{}</span><b>{}</b></p>",
                    escape(name),
                    escape(value)
                )
            }
            Row::Cells(cells) => {
                let cells: String =
                    cells.iter().map(|c| format!("<span>{}</span>", escape(c))).collect();
                format!("<p class=\"cells\">{cells}</p>")
            }
            Row::Note(text, _) => format!("<p>{}</p>", escape(text)),
            Row::Key(..) | Row::Depth(_) | Row::Map => String::new(),
        };
    }
    out + "</section>\n"
}
